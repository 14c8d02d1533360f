#include "text_file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "place.hpp"

namespace shoreline {

std::string text_of(const std::filesystem::path& file, const std::string& expected) {
  const Place place{file.string(), {}};
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) place.fail("found a folder, expected " + expected);
  std::ifstream stream(file, std::ios::binary);
  if (!stream) place.fail(fmt::format("cannot be read ({}), expected {}", std::strerror(errno), expected));
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace shoreline
