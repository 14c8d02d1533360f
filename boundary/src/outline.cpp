#include "shoreline/boundary/outline.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "closed_spans.hpp"
#include "message.hpp"
#include "self_crossing.hpp"
#include "shoreline/boundary/region.hpp"

namespace shoreline {
namespace {

/// Diagonal of the smallest box around all tracking points.
double outline_size(std::span<const Piece> pieces) {
  Eigen::AlignedBox2d box;
  for (const Piece& piece : pieces)
    for (const Vec2& x : piece.points) box.extend(x);
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

std::size_t at(int piece) { return static_cast<std::size_t>(piece); }

[[noreturn]] void refuse_open_end(std::span<const Piece> pieces, int piece) {
  const Vec2& end = pieces[at(piece)].points.back();
  const Piece* nearest = nullptr;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Piece& other : pieces) {
    if (other.closed || (other.points.front() - end).norm() >= smallest) continue;
    smallest = (other.points.front() - end).norm();
    nearest = &other;
  }
  throw OutlineError(piece, quoted(pieces[at(piece)].name) + ": ends at " + text(end) +
                                ", where no piece starts; the nearest start is that of " + quoted(nearest->name) +
                                " at " + text(nearest->points.front()));
}

/// For each open piece the one that starts where it ends; −1 for closed pieces.
std::vector<int> successors(std::span<const Piece> pieces) {
  const double tolerance = 1e-9 * outline_size(pieces);
  const int count = static_cast<int>(pieces.size());
  std::vector<int> next(pieces.size(), -1);
  std::vector<int> previous(pieces.size(), -1);
  for (int i = 0; i < count; ++i) {
    if (pieces[at(i)].closed) continue;
    const Vec2& end = pieces[at(i)].points.back();
    for (int j = 0; j < count; ++j) {
      if (pieces[at(j)].closed || (pieces[at(j)].points.front() - end).norm() > tolerance) continue;
      if (next[at(i)] >= 0)
        throw OutlineError(i, quoted(pieces[at(i)].name) + ": ends at " + text(end) + ", where both " +
                                  quoted(pieces[at(next[at(i)])].name) + " and " + quoted(pieces[at(j)].name) +
                                  " start");
      next[at(i)] = j;
    }
    if (next[at(i)] < 0) refuse_open_end(pieces, i);
    int& before = previous[at(next[at(i)])];
    if (before >= 0)
      throw OutlineError(i, quoted(pieces[at(i)].name) + ": ends at " + text(end) + ", where " +
                                quoted(pieces[at(before)].name) + " ends too");
    before = i;
  }
  return next;
}

void check_lengths(std::span<const Piece> pieces, std::span<const SplineCurve> curves, double size) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    double length = 0.0;  // of the polygon: its curve is no point unless it is one
    for (const CubicSpan& span : curves[i].spans) length += (span.control[3] - span.control[0]).norm();
    if (length <= 1e-12 * size)
      throw OutlineError(static_cast<int>(i), quoted(pieces[i].name) + ": the curve at " +
                                                  text(pieces[i].points.front()) + " has no length");
  }
}

void check_crossings(std::span<const Piece> pieces, std::span<const SplineCurve> curves,
                     std::span<const std::vector<int>> loops, double size) {
  std::vector<std::vector<LoopSpan>> spans(loops.size());
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (const int piece : loops[l])
      for (const CubicSpan& span : curves[at(piece)].spans) spans[l].push_back({span, piece});
  const std::optional<Crossing> found = find_crossing(spans, size);
  if (!found) return;
  const std::string who = quoted(pieces[at(found->piece)].name);
  const std::string whom = found->other == found->piece ? std::string("itself") : quoted(pieces[at(found->other)].name);
  throw OutlineError(found->piece, who + ": crosses or touches " + whom + " at " + text(found->x));
}

void check_orientations(std::span<const Piece> pieces, std::span<const SplineCurve> curves,
                        std::span<const std::vector<int>> loops) {
  std::vector<std::vector<SplineCurve>> loop_curves(loops.size());
  std::vector<Region> inside;
  for (std::size_t l = 0; l < loops.size(); ++l) {
    for (const int piece : loops[l]) loop_curves[l].push_back(curves[at(piece)]);
    inside.emplace_back(loop_curves[l]);
  }
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const Vec2 x = loop_curves[l].front().spans.front().position(0.5);
    int around = 0;
    for (std::size_t other = 0; other < loops.size(); ++other)
      if (other != l && inside[other].contains(x)) ++around;
    const bool is_hole = around % 2 == 1;
    const bool clockwise = inside[l].area() < 0.0;
    if (clockwise == is_hole) continue;
    const int piece = loops[l].front();
    throw OutlineError(piece, quoted(pieces[at(piece)].name) + ": its loop through " + text(x) + " runs " +
                                  (clockwise ? "clockwise, but bounds the body from outside"
                                             : "counter-clockwise, but bounds a hole") +
                                  "; the body must lie to its left: reverse the points");
  }
}

}  // namespace

std::vector<std::vector<int>> close_loops(std::span<const Piece> pieces) {
  const std::vector<int> next = successors(pieces);
  std::vector<char> used(pieces.size(), 0);
  std::vector<std::vector<int>> loops;
  for (int first = 0; first < static_cast<int>(pieces.size()); ++first) {
    if (used[at(first)]) continue;
    std::vector<int>& loop = loops.emplace_back();
    for (int piece = first; piece >= 0 && !used[at(piece)]; piece = next[at(piece)]) {
      used[at(piece)] = 1;
      loop.push_back(piece);
    }
  }
  return loops;
}

void check_outline(std::span<const Piece> pieces, std::span<const SplineCurve> curves,
                   std::span<const std::vector<int>> loops) {
  const double size = outline_size(pieces);
  check_lengths(pieces, curves, size);
  check_crossings(pieces, curves, loops, size);
  check_orientations(pieces, curves, loops);
}

}  // namespace shoreline
