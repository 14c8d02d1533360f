#pragma once
// Reads back what a run has written.

#include <hdf5.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace shoreline::test {

/// A text attribute of an object; empty where there is none.
inline std::string text_attribute(hid_t place, const char* path, const char* name) {
  if (H5Aexists_by_name(place, path, name, H5P_DEFAULT) <= 0) return "";
  const hid_t attribute = H5Aopen_by_name(place, path, name, H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  char* text = nullptr;
  H5Aread(attribute, type, &text);
  std::string copy = text;
  H5free_memory(text);
  H5Tclose(type);
  H5Aclose(attribute);
  return copy;
}

/// All numbers of a dataset, its shape and its unit.
struct Dataset {
  std::vector<hsize_t> shape;
  std::vector<double> values;
  std::string unit;
};

inline Dataset read(const std::filesystem::path& folder, const std::string& path) {
  Dataset read;
  const hid_t file = H5Fopen((folder / "results.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  REQUIRE(file >= 0);
  const hid_t set = H5Dopen2(file, path.c_str(), H5P_DEFAULT);
  REQUIRE(set >= 0);
  const hid_t space = H5Dget_space(set);
  read.shape.resize(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space)));
  H5Sget_simple_extent_dims(space, read.shape.data(), nullptr);
  read.values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, read.values.data());
  read.unit = text_attribute(file, path.c_str(), "unit");
  H5Sclose(space);
  H5Dclose(set);
  H5Fclose(file);
  return read;
}

inline std::string text_of(const std::filesystem::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

/// Checks that every array that results.xdmf names exists with the shape it says; returns how many there are.
inline int check_shapes(const std::filesystem::path& folder) {
  const auto unescaped = [](std::string text) {
    for (const auto& [xml, plain] : {std::pair("&lt;", "<"), {"&gt;", ">"}, {"&quot;", "\""}, {"&amp;", "&"}})
      for (std::size_t at; (at = text.find(xml)) != std::string::npos;)
        text.replace(at, std::string(xml).size(), plain);
    return text;
  };
  const std::string xdmf = text_of(folder / "results.xdmf");
  int arrays = 0;
  for (std::size_t at = xdmf.find("Dimensions=\""); at != std::string::npos; at = xdmf.find("Dimensions=\"", at + 1)) {
    std::stringstream shape(xdmf.substr(at + 12, xdmf.find('"', at + 12) - at - 12));
    const std::size_t path = xdmf.find("results.h5:", at) + 11;
    std::vector<hsize_t> expected;
    for (hsize_t n; shape >> n;) expected.push_back(n);
    CHECK(read(folder, unescaped(xdmf.substr(path, xdmf.find("</", path) - path))).shape == expected);
    ++arrays;
  }
  return arrays;
}

}  // namespace shoreline::test
