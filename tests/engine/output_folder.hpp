#pragma once
// A folder of its own for each test that writes files.

#include <stdlib.h>

#include <filesystem>
#include <string>

namespace shoreline::test {

struct OutputFolder {
  OutputFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "shoreline-test-XXXXXX").string();
    path = mkdtemp(name.data());
  }
  ~OutputFolder() { std::filesystem::remove_all(path); }
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  std::filesystem::path path;
};

}  // namespace shoreline::test
