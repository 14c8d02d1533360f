#pragma once
// Where in a case file something stands.

#include <string>

#include "shoreline/engine/failures.hpp"

namespace shoreline {

/// A file (or what stands for one in messages) and a JSON pointer in it.
struct Place {
  std::string file;
  std::string pointer;  ///< "" is the whole file

  [[nodiscard]] Place operator/(const std::string& key) const;
  [[nodiscard]] Place operator/(std::size_t entry) const { return *this / std::to_string(entry); }

  [[noreturn]] void fail(const std::string& problem) const { throw CaseError(file, pointer, problem); }
};

}  // namespace shoreline
