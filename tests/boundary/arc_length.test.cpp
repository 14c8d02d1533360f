#include "shoreline/boundary/arc_length.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "random_pieces.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

TEST_CASE("a place is at its own arc length, and arc length grows along the curve", "[boundary][arc_length]") {
  test::RandomPieces random(1);
  for (int draw = 0; draw < 40; ++draw) {
    const ArcLength arc(fit_spline(random.any()));
    const auto spans = static_cast<int>(arc.curve().spans.size());
    double before = 0.0;
    for (int span = 0; span < spans; ++span)
      for (const double u : {0.0, random.uniform(0.0, 0.5), random.uniform(0.5, 1.0)}) {
        const double here = arc.to({span, u});
        CHECK(here >= before);
        before = here;
        const CurvePlace place = arc.at(here);
        const double speed = arc.curve().spans[static_cast<std::size_t>(span)].derivative(u).norm();
        CHECK_THAT((place.span + place.u - span - u) * speed, WithinAbs(0.0, 1e-11 * arc.length()));
      }
    double sum = 0.0;
    for (const CubicSpan& span : arc.curve().spans) sum += span.length();
    CHECK_THAT(arc.length(), WithinRel(sum, 1e-14));
    CHECK_THAT(arc.to({spans - 1, 1.0}), WithinRel(sum, 1e-14));
  }
}

TEST_CASE("arc lengths of a straight line and of a circle are known", "[boundary][arc_length]") {
  const ArcLength line(fit_spline(shoreline::line({0.0, 0.0}, {3.0, 4.0}, 4)));
  CHECK_THAT(line.to({1, 0.25}), WithinRel(1.25 * 5.0 / 3.0, 1e-14));
  CHECK(line.at(2.5).span == 1);
  CHECK_THAT(line.at(2.5).u, WithinAbs(0.5, 1e-14));
  CHECK(line.at(-1.0).span == 0);
  CHECK(line.at(-1.0).u == 0.0);
  CHECK(line.at(6.0).span == 2);
  CHECK(line.at(6.0).u == 1.0);
  const ArcLength circle(fit_spline(shoreline::circle({1.0, -2.0}, 0.5, 64, true)));
  CHECK_THAT(circle.length(), WithinRel(std::numbers::pi, 1e-6));
}
