#include "shoreline/boundary/outline.hpp"

#include <catch2/catch.hpp>

#include "random_pieces.hpp"
#include "shoreline/boundary/short_forms.hpp"

using namespace shoreline;
using Catch::Matchers::Contains;

namespace {

Piece named(const std::string& name, Piece piece) {
  piece.name = name;
  return piece;
}

/// "" if the pieces bound a body, else the message; the piece at fault must be the one that it names.
std::string problem(const std::vector<Piece>& pieces) {
  try {
    const std::vector<std::vector<int>> loops = close_loops(pieces);
    std::vector<SplineCurve> curves;
    for (const Piece& piece : pieces) curves.push_back(fit_spline(piece));
    check_outline(pieces, curves, loops);
  } catch (const OutlineError& error) {
    const std::string& name = pieces.at(static_cast<std::size_t>(error.piece())).name;
    CHECK_THAT(error.what(), Catch::Matchers::StartsWith("piece '" + name + "'"));
    return error.what();
  }
  return "";
}

std::vector<Piece> rectangle(const Vec2& low, const Vec2& high) {
  const Vec2 right(high.x(), low.y());
  const Vec2 left(low.x(), high.y());
  return {named("bottom", line(low, right)), named("right", line(right, high)), named("top", line(high, left)),
          named("left", line(left, low))};
}

std::vector<Piece> operator+(std::vector<Piece> a, const Piece& b) {
  a.push_back(b);
  return a;
}

}  // namespace

TEST_CASE("pieces close into loops in the order in which they run", "[boundary][outline]") {
  std::vector<Piece> pieces = rectangle({0, 0}, {3, 2});
  std::swap(pieces[1], pieces[3]);  // bottom, left, top, right
  pieces.insert(pieces.begin() + 1, named("hole", circle({1, 1}, 0.5, 12, true)));
  CHECK(close_loops(pieces) == std::vector<std::vector<int>>{{0, 4, 3, 2}, {1}});
  CHECK(problem(pieces).empty());
}

TEST_CASE("ends meet up to 1e-9 of the outline", "[boundary][outline]") {
  std::vector<Piece> pieces = rectangle({0, 0}, {1, 1});
  pieces[2].points.front() += Vec2(5e-10, -5e-10);
  CHECK(problem(pieces).empty());
  pieces[2].points.front() += Vec2(1e-8, 0);
  CHECK_THAT(problem(pieces), Contains("'right'") && Contains("(1, 1)") && Contains("'top'"));
}

TEST_CASE("valid outlines pass: sharp corners, a lens of two arcs, islands in holes", "[boundary][outline]") {
  CHECK(problem({named("a", line({0, 0}, {10, 0})), named("b", line({10, 0}, {0, 0.01})),
                 named("c", line({0, 0.01}, {0, 0}))})
            .empty());
  CHECK(problem({named("low", arc({0, 1}, std::sqrt(2.0), 225, 315, 5)),
                 named("high", arc({0, -1}, std::sqrt(2.0), 45, 135, 2))})
            .empty());
  CHECK(problem({named("low", arc({0, 1}, 1, -90, 0, 2)), named("high", arc({1, 0}, 1, 90, 180, 2))}).empty());
  CHECK(problem({named("outer", circle({0, 0}, 3, 16, false)), named("hole", circle({0, 0}, 2, 16, true)),
                 named("island", circle({0, 0}, 1, 16, false)), named("beside", circle({7, 0}, 1, 16, false))})
            .empty());
  test::RandomPieces random(8);
  for (int draw = 0; draw < 200; ++draw) {  // through points of a circle, near or far: no crossing
    Piece piece = circle({0, 0}, 1.0, random.whole(3, 40), false);
    CHECK(problem({named("circle", piece)}).empty());
  }
}

TEST_CASE("an open loop is reported with its end", "[boundary][outline]") {
  std::vector<Piece> pieces = rectangle({0, 0}, {3, 2});
  pieces.erase(pieces.begin() + 2);
  CHECK_THAT(problem(pieces), Contains("'right'") && Contains("(3, 2)") && Contains("no piece starts"));
  CHECK_THAT(problem({named("alone", line({0, 0}, {1, 0}, 4))}), Contains("'alone'") && Contains("(1, 0)"));
}

TEST_CASE("two pieces at one end are reported", "[boundary][outline]") {
  const std::vector<Piece> pieces = rectangle({0, 0}, {3, 2});
  CHECK_THAT(problem(pieces + named("second", line({3, 2}, {0, 0}))),
             Contains("(3, 2)") && Contains("'top'") && Contains("'second'"));
  CHECK_THAT(problem(pieces + named("second", line({5, 5}, {3, 2}))), Contains("(3, 2)") && Contains("ends too"));
}

TEST_CASE("a piece that crosses itself is reported with the place", "[boundary][outline]") {
  const Piece eight{
      .name = "eight", .points = {{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}, .corners = {0, 1, 2, 3}, .closed = true};
  CHECK_THAT(problem({eight}), Contains("'eight'") && Contains("itself"));

  std::vector<Piece> pieces = rectangle({0, 0}, {4, 3});
  pieces[2] = {.name = "top", .points = {{4, 3}, {2, 2}, {1, 3}, {2, 4}, {3, 3}, {1.5, 1.5}, {0, 3}}};
  CHECK_THAT(problem(pieces), Contains("'top'") && Contains("itself") && Contains("("));
}

TEST_CASE("a single span that loops is reported", "[boundary][outline]") {
  const bool in_first_half = GENERATE(false, true);  // of u; y = 9u − 9u², x = 9u − 24u² + 16u³ to u = 1 or u = 2
  const CubicSpan knot = in_first_half ? CubicSpan{{Vec2(0, 0), Vec2(6, 6), Vec2(-20, 0), Vec2(50, -18)}}
                                       : CubicSpan{{Vec2(0, 0), Vec2(3, 3), Vec2(-2, 3), Vec2(1, 0)}};
  const Vec2 end = knot.control[3];
  const Vec2 below = end - Vec2(0, 22);
  const std::vector<Piece> pieces{named("knot", line({0, 0}, end)), named("down", line(end, below)),
                                  named("home", line(below, {0, 0}))};
  const std::vector<SplineCurve> curves{
      {.spans = {knot}, .knots = {0, 1}}, fit_spline(pieces[1]), fit_spline(pieces[2])};
  CHECK_THROWS_WITH(check_outline(pieces, curves, close_loops(pieces)),
                    Contains("'knot'") && Contains("itself at (0.5, "));
}

TEST_CASE("pieces that cross or touch one another are reported with the place", "[boundary][outline]") {
  const std::vector<Piece> box = rectangle({0, 0}, {4, 4});
  CHECK_THAT(problem(box + named("hole", circle({4, 2}, 1, 16, true))),
             Contains("'right'") && Contains("'hole'") && Contains("(4, "));
  CHECK_THAT(problem(box + named("hole", circle({3, 2}, 1, 16, true))), Contains("'hole'") && Contains("(4, 2)"));
  CHECK_THAT(problem(box + named("copy", {.points = {{1, 4}, {3, 4}, {2, 3}}, .corners = {0, 1, 2}, .closed = true})),
             Contains("'top'") && Contains("'copy'"));
  CHECK(problem(box + named("hole", circle({3 - 1e-9, 2}, 1, 16, true))).empty());

  const std::vector<Piece> bow{named("a", line({0, 0}, {2, 2})), named("b", line({2, 2}, {2, 0})),
                               named("c", line({2, 0}, {0, 2})), named("d", line({0, 2}, {0, 0}))};
  CHECK_THAT(problem(bow), Contains("'a'") && Contains("'c'") && Contains("(1, 1)"));

  const std::vector<Piece> fold{named("out", line({0, 0}, {2, 0})), named("back", line({2, 0}, {1, 0})),
                                named("up", line({1, 0}, {0, 1})), named("down", line({0, 1}, {0, 0}))};
  CHECK_THAT(problem(fold), Contains("'out'") && Contains("'back'"));
}

TEST_CASE("neighbours that cross near the end they share are reported", "[boundary][outline]") {
  const std::vector<Piece> pieces{named("out", line({0, 0}, {4, 0})), named("bent", line({4, 0}, {3.5, -4})),
                                  named("home", line({3.5, -4}, {0, 0}))};
  std::vector<SplineCurve> curves;
  for (const Piece& piece : pieces) curves.push_back(fit_spline(piece));
  curves[1].spans[0] = {{Vec2(4, 0), Vec2(3.9, 1), Vec2(3.8, -3), Vec2(3.5, -4)}};  // y = 0 again at u = 0.228
  CHECK_THROWS_WITH(check_outline(pieces, curves, close_loops(pieces)),
                    Contains("'out'") && Contains("'bent'") && Contains("at (3.9"));
}

TEST_CASE("a loop without an inside is reported", "[boundary][outline]") {
  const Vec2 tip(10, 0.001);
  CHECK_THAT(problem({named("there", line({0, 0}, tip)), named("back", line(tip, {0, 0}))}),
             Contains("crosses or touches"));
}

TEST_CASE("a loop that runs the wrong way is reported", "[boundary][outline]") {
  CHECK_THAT(problem({named("disc", circle({0, 0}, 1, 8, true))}),
             Contains("'disc'") && Contains("runs clockwise") && Contains("reverse") && Contains("("));
  CHECK_THAT(problem(rectangle({0, 0}, {4, 4}) + named("hole", circle({2, 2}, 1, 16, false))),
             Contains("'hole'") && Contains("counter-clockwise, but bounds a hole") && Contains("("));
}

TEST_CASE("a curve of no length is reported", "[boundary][outline]") {
  std::vector<Piece> pieces = rectangle({0, 0}, {1, 1});
  std::vector<SplineCurve> curves;
  for (const Piece& piece : pieces) curves.push_back(fit_spline(piece));
  for (Vec2& p : curves[1].spans[0].control) p = Vec2(1, 0);
  CHECK_THROWS_WITH(check_outline(pieces, curves, close_loops(pieces)),
                    Contains("'right'") && Contains("(1, 0)") && Contains("no length"));
}
