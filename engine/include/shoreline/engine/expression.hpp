#pragma once
// Numbers and formulas that a case gives as functions of place and time.

#include <map>
#include <memory>
#include <string>
#include <variant>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// Where and when a formula is evaluated.
struct PlaceTime {
  Vec2 x = Vec2::Zero();       ///< current position [m]
  Vec2 origin = Vec2::Zero();  ///< original position X, Y [m]
  double t = 0.0;              ///< k/N at the end of step k of N, or [s]
  double factor = 0.0;         ///< load factor at t, by which plain numbers ramp
};

/// A formula in x, y, X, Y, t, pi and named constants. Copies share one parser: not to be evaluated by two threads at
/// once.
class Expression {
 public:
  /// @param constants  names are letters, digits and _, not those of variables, functions and built-in constants
  /// @throws InvalidArgument with the formula, the position in it and what is wrong there; or with the constant
  explicit Expression(const std::string& formula, const std::map<std::string, double>& constants = {});

  /// @throws ComputationError with the formula, place and time where its value is not finite
  [[nodiscard]] double operator()(const PlaceTime& at) const;
  [[nodiscard]] const std::string& formula() const;
  [[nodiscard]] bool uses_place() const;  ///< whether x, y, X or Y occurs in the formula
  [[nodiscard]] bool uses_time() const;   ///< whether t does

 private:
  struct Parser;
  std::shared_ptr<Parser> parser_;
};

/// A plain number, which ramps with the load factor in a quasi-static run, or an expression, which is taken as it is.
class Quantity {
 public:
  Quantity(double number) : value_(number) {}  // NOLINT(google-explicit-constructor): a number is a quantity
  Quantity(Expression expression) : value_(std::move(expression)) {}  // NOLINT(google-explicit-constructor)

  [[nodiscard]] double operator()(const PlaceTime& at) const;

 private:
  std::variant<double, Expression> value_;
};

}  // namespace shoreline
