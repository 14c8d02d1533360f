#include "shoreline/engine/expression.hpp"

#include <fmt/format.h>
#include <muParser.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <regex>

#include "shoreline/bases/error.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {

/// A muParser with the variables it reads. muParser brings its own number format, so no locale matters.
struct Expression::Parser {
  std::string formula;
  mu::Parser parser;
  double x = 0.0, y = 0.0, X = 0.0, Y = 0.0, t = 0.0;
};

namespace {

const std::array<std::string, 5> variables{"x", "y", "X", "Y", "t"};

std::string shortened(const std::string& formula) {
  constexpr std::size_t longest = 80;
  return formula.size() <= longest ? formula : formula.substr(0, longest) + "…";
}

[[noreturn]] void fail(const std::string& formula, std::size_t position, const std::string& problem) {
  throw InvalidArgument(fmt::format("formula \"{}\": at character {}: {}", shortened(formula),
                                    std::min(position, formula.size()) + 1, problem));
}

/// muParser would take x = 1 for an assignment and "…" for a text; neither belongs in a formula.
void refuse_foreign_characters(const std::string& formula) {
  const std::string comparisons = "=!<>";
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const char c = formula[i];
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (!letter && std::string("_.+-*/^(),<>=!&|?: \t").find(c) == std::string::npos)
      fail(formula, i, "found a character that no formula has");
    if (c != '=') continue;
    const bool pair = (i > 0 && comparisons.find(formula[i - 1]) != std::string::npos) ||
                      (i + 1 < formula.size() && formula[i + 1] == '=');
    if (!pair) fail(formula, i, "found =, which assigns; to compare write ==");
  }
}

void check_constant(const std::string& name, double value, const mu::Parser& parser) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidArgument("constant \"" + shortened(name) + "\": " + why);
  };
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  if (name.empty() || !letter(name[0]) ||
      !std::ranges::all_of(name, [&](char c) { return letter(c) || (c >= '0' && c <= '9'); }))
    refuse("expected a name of letters, digits and _ that does not begin with a digit");
  if (std::ranges::count(variables, name)) refuse("the name is taken by a variable (x, y, X, Y, t)");
  if (parser.GetFunDef().contains(name)) refuse("the name is taken by a function");
  if (parser.GetConst().contains(name)) refuse("the name is taken by a built-in constant");
  if (!std::isfinite(value)) refuse("expected a finite number");
}

std::string known_names(const mu::Parser& parser) {
  std::string names = fmt::format("{}", fmt::join(variables, ", "));
  for (const auto& [name, value] : parser.GetConst())
    if (name[0] != '_') names += ", " + name;
  return names;
}

std::string problem_of(const mu::Parser::exception_type& error, const mu::Parser& parser) {
  switch (error.GetCode()) {
    case mu::ecUNASSIGNABLE_TOKEN:
      return fmt::format("found \"{}\", expected a number, an operator, a function or one of {}", error.GetToken(),
                         known_names(parser));
    case mu::ecUNEXPECTED_EOF:
      return "the formula ends too soon";
    case mu::ecEMPTY_EXPRESSION:
      return "the formula is empty";
    default:  // the position is told already
      return std::regex_replace(error.GetMsg(), std::regex(R"( ?(found )?(at |\()(expression )?position:? \d+\)?\.?)"),
                                "");
  }
}

}  // namespace

Expression::Expression(const std::string& formula, const std::map<std::string, double>& constants)
    : parser_(std::make_shared<Parser>()) {
  parser_->formula = formula;
  mu::Parser& parser = parser_->parser;
  parser.DefineConst("pi", std::numbers::pi);
  for (const auto& [name, value] : constants) check_constant(name, value, parser);
  for (const auto& [name, value] : constants) parser.DefineConst(name, value);
  const std::array<double*, 5> values{&parser_->x, &parser_->y, &parser_->X, &parser_->Y, &parser_->t};
  for (std::size_t i = 0; i < variables.size(); ++i) parser.DefineVar(variables[i], values[i]);
  refuse_foreign_characters(formula);
  try {
    parser.SetExpr(formula);
    parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    fail(formula, static_cast<std::size_t>(std::max(error.GetPos(), 0)), problem_of(error, parser));
  }
  if (parser.GetNumResults() != 1)
    fail(formula, formula.find(','), fmt::format("found {} values, expected one", parser.GetNumResults()));
}

double Expression::operator()(const PlaceTime& at) const {
  parser_->x = at.x.x();
  parser_->y = at.x.y();
  parser_->X = at.origin.x();
  parser_->Y = at.origin.y();
  parser_->t = at.t;
  const double value = parser_->parser.Eval();
  if (!std::isfinite(value))
    throw ComputationError(fmt::format("formula \"{}\" is {} at (x, y) = ({:g}, {:g}), (X, Y) = ({:g}, {:g}), t = {:g}",
                                       shortened(formula()), std::isnan(value) ? "not a number" : "infinite", at.x.x(),
                                       at.x.y(), at.origin.x(), at.origin.y(), at.t));
  return value;
}

const std::string& Expression::formula() const { return parser_->formula; }

bool Expression::uses_place() const {
  const auto& used = parser_->parser.GetUsedVar();
  return std::ranges::any_of(used, [](const auto& variable) { return variable.first != "t"; });
}

bool Expression::uses_time() const { return parser_->parser.GetUsedVar().contains("t"); }

double Quantity::operator()(const PlaceTime& at) const {
  if (const double* number = std::get_if<double>(&value_)) return *number * at.factor;
  return std::get<Expression>(value_)(at);
}

}  // namespace shoreline
