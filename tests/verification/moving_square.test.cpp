// The square in manufactured, axis-aligned motion on jittered meshes: de Koster et al. 2020, §4.2.

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "../bases/meshes.hpp"
#include "../motion.hpp"
#include "../random.hpp"

using namespace shoreline;
using std::numbers::pi;

namespace {

constexpr double amplitude = 0.05, modulus = 1e7, density = 1e3;
constexpr double lambda = modulus * 0.3 / (1.3 * 0.4);
constexpr double mu = modulus / 2.6;

double swing(double t) { return std::sin(std::sqrt(modulus / density) * pi * t); }

/// The paper's body force per mass, eqs 42 to 46.
Vec2 force(const PlaceTime& at) {
  const double s = swing(at.t);
  const Vec2 d(1.0 + 2.0 * amplitude * pi * std::cos(2.0 * pi * at.origin.x()) * s,
               1.0 - 2.0 * amplitude * pi * std::cos(2.0 * pi * at.origin.y()) * s);
  const Vec2 u = amplitude * s * Vec2(std::sin(2.0 * pi * at.origin.x()), -std::sin(2.0 * pi * at.origin.y()));
  const double volumetric = lambda * (std::log(d.x() * d.y()) - 1.0) - mu;
  return pi * pi / density *
         u.cwiseProduct(Vec2(4.0 * mu - modulus - 4.0 * volumetric / (d.x() * d.x()),
                             4.0 * mu - modulus - 4.0 * volumetric / (d.y() * d.y())));
}

/// The example's motion with the force in C++, which is the same and faster.
/// @param cells  of the mesh in a side
/// @param count  material points a triangle, twice a square
/// @param more   keys of the case
test::Motion square(const std::string& basis, Index cells, int count, double time_step, unsigned seed,
                    const std::vector<std::string>& more = {}) {
  const auto points = static_cast<int>(std::lround(std::sqrt(2.0 * count) * cells));
  std::vector<std::string> keys{
      "grid.basis=" + basis, "analysis.time_step=" + std::to_string(time_step),
      "material_points.across=[" + std::to_string(points) + "," + std::to_string(points) + "]"};
  keys.insert(keys.end(), more.begin(), more.end());
  Case problem = read_case(std::string(SHORELINE_EXAMPLES) + "/moving_square/powell_sabin.json", keys);
  test::Random random(seed);
  std::vector<Vec2> vertices = test::jittered_points(cells, cells, random, 0.2);
  for (Vec2& v : vertices) v /= cells;
  problem.grid.mesh = std::make_shared<TriangleMesh>(delaunay(vertices));
  problem.gravity_field.reset();
  test::Motion motion(build_dynamic_scene(problem));
  motion.scene.gravity_field = force;
  return motion;
}

double rms(const std::string& basis, Index cells, int count, double time_step = 1e-4, unsigned seed = 1) {
  return square(basis, cells, count, time_step, seed).compute().over_time("displacement").rms;
}

double total_variation(const std::vector<double>& values) {
  double sum = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) sum += std::abs(values[k] - values[k - 1]);
  return sum;
}

/// Total variation of the probe's σ_xx over that of the exact one.
double jaggedness(const std::string& basis, Index cells) {
  const test::Motion motion = square(basis, cells, 32, 1e-4, 1).compute();
  std::vector<double> computed, exact;
  for (const ProbeState& state : motion.scene.body.probes.front().history) {
    computed.push_back((*state.stress)[0]);
    exact.push_back(motion.scene.body.exact->stress(state.position - state.displacement, state.t)[0]);
  }
  return total_variation(computed) / total_variation(exact);
}

}  // namespace

TEST_CASE("the example's formulas are the paper's body force", "[verification][dynamics]") {
  const test::Motion example("moving_square/powell_sabin.json", {});
  for (const auto& [x, y, t] : {std::array{0.13, 0.71, 0.003}, std::array{0.6, 0.25, 0.013}}) {
    const PlaceTime at{.x = {x, y}, .origin = {x, y}, .t = t};
    CHECK((example.scene.gravity_field(at) - force(at)).norm() <= 1e-9 * force(at).norm());
  }
}

TEST_CASE("the square moves within 3e-4 m on nine vertices a side, 2.5 times nearer than on as many linear functions",
          "[verification][dynamics]") {
  for (const unsigned seed : {1, 2, 3}) {
    CAPTURE(seed);
    const double splines = rms("powell_sabin", 8, 32, 1e-4, seed);  // 243 functions
    const double linear = rms("linear", 16, 32, 1e-4, seed);        // 289
    CHECK(splines < 3e-4);
    CHECK(linear >= 2.5 * splines);
  }
}

TEST_CASE("with 128 points a triangle the square converges with more than order 2.2, then 1.6",
          "[verification][dynamics]") {
  const double error[] = {rms("powell_sabin", 4, 128), rms("powell_sabin", 8, 128), rms("powell_sabin", 16, 128, 8e-5)};
  CAPTURE(error[0], error[1], error[2]);
  CHECK(std::log2(error[0] / error[1]) > 2.2);
  CHECK(std::log2(error[1] / error[2]) > 1.6);
  CHECK(error[2] < 4e-5);
}

TEST_CASE("the stress of one point is smooth on Powell-Sabin splines and jagged on linear triangles",
          "[verification][dynamics]") {
  const double splines = jaggedness("powell_sabin", 8);
  CHECK(splines < 1.1);
  CHECK(jaggedness("linear", 16) - 1.0 > 5.0 * (splines - 1.0));
}

TEST_CASE("with fitted weights, a ghost mass and pic 32 points a triangle are enough for order 2",
          "[verification][dynamics][fitted]") {
  const std::vector<std::string> remedy{"material_points.volumes=fitted", "ghost=1e-4", "analysis.transfer=pic"};
  const auto error = [&](Index cells, int count) {
    return square("powell_sabin", cells, count, 8e-5, 1, remedy).compute().over_time("displacement").rms;
  };
  const double coarse = error(8, 32), fine = error(16, 32);
  CHECK(coarse < 1.5e-4);
  CHECK(fine < 4.5e-5);
  CHECK(std::log2(coarse / fine) > 1.7);
}

TEST_CASE("with eight points a triangle fitted weights take a third off the error of a ghost mass alone",
          "[verification][dynamics][fitted]") {
  const auto error = [](const std::string& volumes) {
    return square("powell_sabin", 8, 8, 1e-4, 1,
                  {"material_points.volumes=" + volumes, "ghost=1e-4", "analysis.transfer=pic"})
        .compute()
        .over_time("displacement")
        .rms;
  };
  CHECK(error("fitted") < 0.67 * error("clipped"));
}
