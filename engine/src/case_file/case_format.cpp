// docs/case_format.md: what the table of keys cannot say, then the table.

#include "keys.hpp"
#include "shoreline/engine/case_reader.hpp"

namespace shoreline {
namespace {

constexpr auto introduction = R"(# The case file

One JSON file is one scene, in SI units (metre, second, kilogram, newton, pascal; in the plane, per metre of
thickness). Any key that is not listed here is an error, and so is a key that is there twice. This page is what
`shoreline schema --markdown` prints; `shoreline schema` prints the same table as JSON Schema (draft 2020-12), which
editors can use to complete and check a case.

**Boundaries.** A piece is a cubic spline through its tracking points, with the material to its left. Pieces that meet
end to end close into loops, and where two meet is a corner. Outer loops run counter-clockwise, holes clockwise.
A displacement or traction may be `"exact"`: that of the case's `exact` solution, at the original position of the
material there.

**Expressions.** A number, or a formula in a string. A formula knows `x`, `y` (current position; in `exact` the
original one), `X`, `Y` (original position), `t` (k/N at the end of step k of N, in dynamics seconds), `pi` and the names under
`constants`; the operators `+ - * / ^`, `== != < > <= >=`, `&& ||` and `a ? b : c`; and the functions `abs sign rint
sqrt exp ln log log2 log10 sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh min max sum avg` (`log`
is the natural logarithm). Plain numbers in loads and prescribed displacements ramp with the load factor, which is t or
the formula under `analysis.load`; formulas are taken as they are. In `exact`, closed forms follow the load factor too,
and expressions are taken as they are, numbers among them. In dynamics nothing ramps.

**On the command line** `--set path=value` overrides or adds any key by its dotted path, list entries by number or by
their `name`: `--set grid.cell_size=0.0625 --set boundaries.outer.condition.band=1e-6`. The value is JSON, or a bare
word.
)";

}  // namespace

std::string case_format() { return introduction + keys::reference_page(keys::case_keys(), "The case"); }

}  // namespace shoreline
