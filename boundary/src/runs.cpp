#include "runs.hpp"

#include <set>

namespace shoreline {

std::vector<Run> smooth_runs(const Piece& piece) {
  const std::size_t count = piece.points.size();
  std::set<std::size_t> breaks(piece.corners.begin(), piece.corners.end());
  if (piece.closed && breaks.empty()) return {{0, count}};
  if (piece.closed) {
    breaks.insert(*breaks.begin() + count);
  } else {
    breaks.insert(0);
    breaks.insert(count - 1);
  }
  std::vector<Run> runs;
  for (auto next = std::next(breaks.begin()); next != breaks.end(); ++next)
    runs.push_back({*std::prev(next), *next - *std::prev(next)});
  return runs;
}

}  // namespace shoreline
