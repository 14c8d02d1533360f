#include "shoreline/engine/version.hpp"

#include <H5public.h>
#include <dlfcn.h>
#include <fmt/format.h>
#include <muParserDef.h>

#include <Eigen/Core>
#include <array>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "shoreline/engine/linear_solver.hpp"

namespace shoreline {
namespace {

/// A function of a shared library that has been loaded, or null. So a library is asked without its headers.
template <class Function>
Function* loaded(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

std::string suitesparse() {
  std::array<int, 3> number{};
  auto* ask = loaded<int(int*)>("SuiteSparse_version");
  if (ask == nullptr) return "unknown";
  ask(number.data());
  return fmt::format("{}", fmt::join(number, "."));
}

std::string hdf5() {
  std::array<unsigned, 3> number{};
  H5get_libversion(&number[0], &number[1], &number[2]);
  return fmt::format("{}", fmt::join(number, "."));
}

}  // namespace

std::string version() { return SHORELINE_VERSION; }

std::string version_report() {
  return fmt::format(
      "shoreline {}, {} build, GCC {}\n"
      "Eigen {}.{}.{}, SuiteSparse {}, BLAS: {}\n"
      "Boost {}.{}.{}, nlohmann_json {}.{}.{}, HDF5 {}, muParser {}, fmt {}.{}.{}\n",
      version(), SHORELINE_BUILD_TYPE, __VERSION__, EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION,
      suitesparse(), blas_name(), BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100,
      NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH, hdf5(), mu::ParserVersion,
      FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100);
}

}  // namespace shoreline
