#pragma once
// What Shoreline throws. A wrong input throws; a broken invariant asserts.

#include <stdexcept>

namespace shoreline {

/// Base of everything that Shoreline throws on purpose.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value passed in by the caller breaks a stated precondition. The message has the value and the rule.
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

}  // namespace shoreline
