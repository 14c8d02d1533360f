#include "shoreline/boundary/respacing.hpp"

#include <algorithm>
#include <limits>

#include "runs.hpp"

namespace shoreline {
namespace {

bool beyond(const Piece& piece, const Run& run, double limit) {
  double shortest = std::numeric_limits<double>::infinity();
  double longest = 0.0;
  for (std::size_t k = run.first; k < run.first + run.chords; ++k) {
    const std::size_t count = piece.points.size();
    const double chord = (piece.points[(k + 1) % count] - piece.points[k % count]).norm();
    shortest = std::min(shortest, chord);
    longest = std::max(longest, chord);
  }
  return longest > limit * shortest;
}

Vec2 position(const SplineCurve& curve, const CurvePlace& place) {
  return curve.spans[static_cast<std::size_t>(place.span)].position(place.u);
}

/// Arc length at which a point of a run lies; beyond the last point of a closed curve it counts on.
double arc_of(const ArcLength& curve, std::size_t point) {
  const std::size_t spans = curve.curve().spans.size();
  return point <= spans ? curve.start_of(static_cast<int>(point))
                        : curve.length() + curve.start_of(static_cast<int>(point - spans));
}

/// Moves the inner points of a run to equal arc lengths.
void spread(const ArcLength& before, const Run& run, Piece& piece, std::vector<double>& start) {
  const double begin = arc_of(before, run.first);
  const double end = arc_of(before, run.first + run.chords);
  for (std::size_t j = 1; j < run.chords; ++j) {
    double arc = begin + (end - begin) * static_cast<double>(j) / static_cast<double>(run.chords);
    if (arc >= before.length()) arc -= before.length();
    const std::size_t point = (run.first + j) % piece.points.size();
    piece.points[point] = position(before.curve(), before.at(arc));
    start[point] = arc;
  }
}

}  // namespace

CurvePlace PlaceMap::operator()(const CurvePlace& place) const {
  const auto span = static_cast<std::size_t>(place.span);
  const double begin = start[span];
  double end = span + 1 < start.size() ? start[span + 1] : now.curve().closed ? start[0] : before.length();
  if (end <= begin) end += before.length();  // past the start of a closed curve
  const double fraction =
      (now.to(place) - now.start_of(place.span)) / (now.start_of(place.span + 1) - now.start_of(place.span));
  const double arc = begin + fraction * (end - begin);
  return before.at(now.curve().closed && arc >= before.length() ? arc - before.length() : arc);
}

std::optional<Respaced> respace(const Piece& piece, double limit) {
  std::vector<Run> runs = smooth_runs(piece);
  std::erase_if(runs, [&](const Run& run) { return !beyond(piece, run, limit); });
  if (runs.empty()) return std::nullopt;
  ArcLength before(fit_spline(piece));
  Piece respaced = piece;
  std::vector<double> start(before.curve().spans.size());
  for (std::size_t k = 0; k < start.size(); ++k) start[k] = before.start_of(static_cast<int>(k));
  for (const Run& run : runs) spread(before, run, respaced, start);
  ArcLength now(fit_spline(respaced));
  return Respaced{std::move(respaced), {std::move(now), std::move(before), std::move(start)}};
}

SplineCurve respaced_original(const SplineCurve& original, const Respaced& respaced) {
  Piece piece = respaced.piece;
  for (std::size_t k = 0; k < respaced.places.start.size(); ++k)
    piece.points[k] = position(original, respaced.places.before.at(respaced.places.start[k]));
  if (!piece.closed) {
    piece.points.back() = original.spans.back().position(1.0);
    piece.start_tangent = original.spans.front().derivative(0.0);
    piece.end_tangent = original.spans.back().derivative(1.0);
  }
  return fit_spline(piece);
}

}  // namespace shoreline
