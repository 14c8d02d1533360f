#include "shoreline/engine/expression.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <locale>
#include <numbers>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/failures.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

double value(const std::string& formula) { return Expression(formula)({}); }

std::string problem_of(const std::string& formula, const std::map<std::string, double>& constants = {}) {
  try {
    const Expression accepted(formula, constants);
    return "accepted";
  } catch (const InvalidArgument& error) {
    return error.what();
  }
}

struct CommaForPoint : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

}  // namespace

TEST_CASE("an expression is the function that it spells", "[engine][expression]") {
  const double x = GENERATE(take(3, random(-2.0, 2.0)));
  const double y = GENERATE(take(3, random(0.5, 2.0)));
  const PlaceTime at{.x = {x, y}, .origin = {x + 1.0, y - 1.0}, .t = 0.25};
  CAPTURE(x, y);
  CHECK_THAT(Expression("a*sin(pi*x)^2 + exp(-y)*(X - Y)/t", {{"a", 3.0}})(at),
             WithinAbs(3.0 * std::pow(std::sin(std::numbers::pi * x), 2) + std::exp(-y) * (x - y + 2.0) / 0.25, 1e-12));
  CHECK_THAT(Expression("x < 0 && y > 1 ? atan2(y, x) : sqrt(y)")(at),
             WithinAbs(x < 0 && y > 1 ? std::atan2(y, x) : std::sqrt(y), 1e-15));
}

TEST_CASE("powers bind tighter than signs and group to the right", "[engine][expression]") {
  CHECK(value("-2^2") == -4.0);
  CHECK(value("2^3^2") == 512.0);
  CHECK(value("2^-1") == 0.5);
  CHECK(value("6/2*3") == 9.0);
}

TEST_CASE("x and X, y and Y are different places", "[engine][expression]") {
  const PlaceTime at{.x = {1.0, 2.0}, .origin = {3.0, 4.0}, .t = 5.0};
  CHECK(Expression("x")(at) == 1.0);
  CHECK(Expression("y")(at) == 2.0);
  CHECK(Expression("X")(at) == 3.0);
  CHECK(Expression("Y")(at) == 4.0);
  CHECK(Expression("t")(at) == 5.0);
}

TEST_CASE("a number ramps with the load factor, a formula does not", "[engine][expression]") {
  const double factor = GENERATE(0.0, 0.3, 1.0);
  CHECK(Quantity(8.0)({.t = 0.125, .factor = factor}) == 8.0 * factor);
  CHECK(Quantity(Expression("8"))({.t = 0.125, .factor = factor}) == 8.0);
}

TEST_CASE("a formula knows whether it depends on place", "[engine][expression]") {
  for (const char* formula : {"x", "2*y", "t+X", "sin(Y)"}) CHECK(Expression(formula).uses_place());
  for (const char* formula : {"t", "pi", "p*exp(t)", "max(t, 2)"})
    CHECK_FALSE(Expression(formula, {{"p", 1.0}}).uses_place());
  CHECK(Expression("x*t").uses_time());
  CHECK_FALSE(Expression("x*tan(y)").uses_time());
}

TEST_CASE("the decimal sign is a point in every locale", "[engine][expression]") {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaForPoint));
  const double result = value("1.5 + 2.5e-1");
  std::locale::global(before);
  CHECK(result == 1.75);
}

TEST_CASE("a wrong formula is refused with its text, the character and the reason", "[engine][expression]") {
  struct Wrong {
    const char* formula;
    const char* at;
    const char* reason;
  };
  const Wrong wrong = GENERATE(values<Wrong>({{"x + q", "character 5", "found \"q\", expected"},
                                              {"x +", "character 4", "ends too soon"},
                                              {"", "character 1", "empty"},
                                              {"(x", "character 3", "parenthesis"},
                                              {"x)", "character 2", "parenthesis"},
                                              {"sin(x, y)", "character 9", "Too many parameters"},
                                              {"2x", "character 2", "Unexpected variable \"x\""},
                                              {"1e999", "character 1", "found \"1e999\""},
                                              {"x = 1", "character 3", "assigns"},
                                              {"x += 1", "character 4", "assigns"},
                                              {"1, 2", "character 2", "found 2 values"},
                                              {"\"text\"", "character 1", "no formula has"},
                                              {"x; y", "character 2", "no formula has"}}));
  CAPTURE(wrong.formula);
  CHECK_THAT(problem_of(wrong.formula),
             Contains(std::string("\"") + wrong.formula + "\"") && Contains(wrong.at) && Contains(wrong.reason));
}

TEST_CASE("comparisons are no assignments", "[engine][expression]") {
  CHECK(value("2 == 2") == 1.0);
  CHECK(value("2 != 2") == 0.0);
  CHECK(value("2 <= 1") == 0.0);
  CHECK(value("2 >= 1") == 1.0);
}

TEST_CASE("constants have names of their own", "[engine][expression]") {
  const std::string name = GENERATE("x", "Y", "t", "sin", "pi", "2a", "a b", "", "ä");
  CAPTURE(name);
  CHECK_THAT(problem_of("1", {{name, 1.0}}), Contains("constant \"" + name + "\""));
  CHECK(problem_of("1", {{"a_2", 1.0}}) == "accepted");
}

TEST_CASE("a value that is not finite stops the computation with formula, place and time", "[engine][expression]") {
  const Expression pole("1/x");
  CHECK(pole({.x = {2.0, 0.0}}) == 0.5);
  CHECK_THROWS_AS(pole({}), ComputationError);
  CHECK_THROWS_WITH(Expression("sqrt(y)")({.x = {3.0, -4.0}, .t = 0.5}),
                    Contains("\"sqrt(y)\"") && Contains("not a number") && Contains("(3, -4)") && Contains("t = 0.5"));
}
