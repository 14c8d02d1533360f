#include "atomic_file.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

#include "shoreline/engine/failures.hpp"

namespace shoreline {

void write_atomically(const std::filesystem::path& file, std::string_view text) {
  std::filesystem::path part = file;
  part += ".part";
  errno = 0;
  std::ofstream stream(part, std::ios::binary);
  stream << text << std::flush;
  if (!stream) throw OutputError(part.string() + ": cannot write: " + std::generic_category().message(errno));
  stream.close();

  std::error_code problem;
  std::filesystem::rename(part, file, problem);
  if (problem) throw OutputError(file.string() + ": cannot write: " + problem.message());
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) throw OutputError(folder.string() + ": cannot make this folder: " + problem.message());
}

}  // namespace shoreline
