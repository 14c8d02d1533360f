#include <dlfcn.h>

#include <filesystem>

#include "shoreline/engine/linear_solver.hpp"

extern "C" {
void openblas_set_num_threads(int threads);
void dpotrf_(const char* triangle, const int* n, double* matrix, const int* rows, int* fault);
}

namespace shoreline {
namespace {

/// A function of the library that the program calls, or null.
template <class Function>
Function* loaded(void* library, const char* name) {
  return reinterpret_cast<Function*>(dlsym(library, name));
}

}  // namespace

void set_blas_threads(int threads) {
  openblas_set_num_threads(threads);
  // OpenBLAS waits for ever for work space that the system refuses; so it takes it here, where there still is some
  const int one = 1;
  double matrix = 1.0;
  int fault = 0;
  dpotrf_("L", &one, &matrix, &one, &fault);
}

Blas blas_at_work() {
  Dl_info found{};
  void* dgemm = dlsym(RTLD_DEFAULT, "dgemm_");
  if (dgemm == nullptr || dladdr(dgemm, &found) == 0) return {"unknown", false};
  const std::string file = std::filesystem::weakly_canonical(found.dli_fname).string();
  void* library = dlopen(found.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
  const auto has = [&](const char* name) { return library != nullptr && loaded<void()>(library, name) != nullptr; };
  if (has("openblas_get_config")) return {loaded<char*()>(library, "openblas_get_config")(), false};
  if (has("bli_info_get_version_str")) return {"BLIS (" + file + ")", false};
  if (has("MKL_Get_Version_String") || has("mkl_get_version_string")) return {"MKL (" + file + ")", false};
  if (has("ATL_dgemm") || file.find("atlas") != std::string::npos) return {"ATLAS (" + file + ")", false};
  if (file.find("/libblas") != std::string::npos) return {"reference BLAS (" + file + ")", true};
  return {file, false};
}

std::string blas_name() { return blas_at_work().name; }

}  // namespace shoreline
