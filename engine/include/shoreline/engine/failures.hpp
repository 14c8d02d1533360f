#pragma once
// The three ways in which a run ends other than well, and the exit status of each.

#include <string>

#include "shoreline/bases/error.hpp"

namespace shoreline {

/// A case file is wrong (status 2): which file, which key, what was found, what was expected.
class CaseError : public Error {
 public:
  /// Message: "FILE: /pointer: problem".
  CaseError(const std::string& file, const std::string& pointer, const std::string& problem)
      : Error(file + ": " + (pointer.empty() ? "" : pointer + ": ") + problem), pointer_(pointer) {}
  [[nodiscard]] const std::string& pointer() const noexcept { return pointer_; }  ///< e.g. "/boundaries/2/points"

 private:
  std::string pointer_;
};

/// The computation failed (status 1): at which step, what was measured, what to try.
class ComputationError : public Error {
 public:
  using Error::Error;
};

/// Results cannot be written (status 3): which file, why.
class OutputError : public Error {
 public:
  using Error::Error;
};

}  // namespace shoreline
