#include "shoreline/engine/pictures.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <vector>

extern const char* const shoreline_picture_script;
extern const char* const shoreline_study_picture_script;

namespace shoreline {
namespace {

constexpr int no_library = 77;       // exit status of the script where a library is missing
constexpr int not_executable = 126;  // of the shell where the interpreter is no program
constexpr int no_program = 127;      // of the shell where there is no such file

struct Outcome {
  int status;
  std::string last_line;  ///< of what was printed
};

/// As one word of a shell command.
std::string quoted(const std::string& word) {
  std::string safe = "'";
  for (const char c : word) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return safe + "'";
}

/// A script that draws what lies in a folder.
struct Script {
  const char* text;
  std::string libraries;  ///< that it needs
  std::string packages;   ///< of Debian, which hold them
};

Outcome draw(const Script& script, const std::string& python, const std::filesystem::path& folder) {
  const std::string command = quoted(python) + " - " + quoted(folder.string()) + " 2>&1 <<'END_OF_SCRIPT'\n" +
                              script.text + "\nEND_OF_SCRIPT\n";
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) return {no_program, "no shell"};
  std::string last_line;
  for (std::array<char, 512> line{}; std::fgets(line.data(), line.size(), output) != nullptr;) last_line = line.data();
  const int status = pclose(output);
  while (!last_line.empty() && last_line.back() == '\n') last_line.pop_back();
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, last_line};
}

std::vector<std::string> interpreters() {
  std::vector<std::string> found;
  if (const char* chosen = std::getenv("SHORELINE_PYTHON")) found.emplace_back(chosen);
  found.insert(found.end(), {"python3", "/usr/bin/python3", "/usr/local/bin/python3"});
  return found;
}

/// Draws with the first interpreter that has the libraries.
std::optional<std::string> draw(const Script& script, const std::filesystem::path& folder) {
  std::string tried;
  for (const std::string& python : interpreters()) {
    const Outcome outcome = draw(script, python, folder);
    if (outcome.status == 0) return std::nullopt;
    if (outcome.status != no_library && outcome.status != not_executable && outcome.status != no_program)
      return "no picture: " + python + ": " + outcome.last_line;
    tried += (tried.empty() ? "" : ", ") + python;
  }
  return "no picture: no Python with " + script.libraries + " (tried " + tried + "); install " + script.packages +
         ", or name one in SHORELINE_PYTHON";
}

}  // namespace

std::optional<std::string> make_pictures(const std::filesystem::path& folder) {
  return draw({shoreline_picture_script, "matplotlib and h5py", "python3-matplotlib and python3-h5py"}, folder);
}

std::optional<std::string> make_study_pictures(const std::filesystem::path& folder) {
  return draw({shoreline_study_picture_script, "matplotlib", "python3-matplotlib"}, folder);
}

}  // namespace shoreline
