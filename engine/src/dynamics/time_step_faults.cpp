// What is said of a motion that cannot go on.

#include <fmt/format.h>

#include "../point_cells.hpp"
#include "shoreline/engine/failures.hpp"
#include "time_step.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

std::string in_words(Fault fault) {
  switch (fault) {
    case Fault::not_finite:
      return "has a velocity or deformation that is not finite";
    case Fault::inverted:
      return "is turned inside out (det D <= 0)";
    case Fault::too_fast:
      return "would move by more than half a cell in one step";
    case Fault::none:
      break;
  }
  return "moves";
}

}  // namespace

void TimeStep::require_sound(const MotionReport& motion) const {
  const MaterialPoints& points = scene_.body.points;
  if (motion.fault != Fault::none)
    throw ComputationError(fmt::format("material point {} at ({:.6g}, {:.6g}) {}", motion.point,
                                       points.position(0, motion.point), points.position(1, motion.point),
                                       in_words(motion.fault)));
  if (motion.outside > 0 && !scene_.settings.drop_outside) require_inside(cell_, points);
}

std::string TimeStep::fastest_motion() const {
  const Index function = critical_.most_moved();
  Index elements = 0, occupied = 0, points = 0;
  for (Index s = table_.first[at(function)]; s < table_.first[at(function) + 1]; ++s, ++elements) {
    const Index element = table_.slot[at(s)] / table_.n;
    const Index number = cells_.occupied.number[at(element)];
    if (number < 0) continue;
    ++occupied;
    const Index begin = cells_.supports.first[at(cells_.occupied.first_cell[at(number)])];
    const Index end = cells_.supports.first[at(cells_.occupied.first_cell[at(number) + 1])];
    points += end - begin;
  }
  const Vec2 x = scene_.body.basis->control_point(function);
  return fmt::format(
      "the fastest motion is that of the function at ({:.4g}, {:.4g}), which sees {} "
      "material point{} in {} of its {} element{}",
      x.x(), x.y(), points, points == 1 ? "" : "s", occupied, elements, elements == 1 ? "" : "s");
}

}  // namespace shoreline
