#include <cmath>

#include "edge_history.hpp"
#include "shoreline/engine/effects.hpp"

namespace shoreline {
namespace {

/// Adds nothing to the equations: follows the displacement of a piece and compares it with the exact one.
class BoundaryError final : public Contribution {
 public:
  BoundaryError(int piece, std::string piece_name, bool normal_only, DisplacementOnPiece exact)
      : piece_(piece), piece_name_(std::move(piece_name)), normal_only_(normal_only), exact_(std::move(exact)) {}

  [[nodiscard]] std::string name() const override { return "boundary_error:" + piece_name_; }
  [[nodiscard]] std::string needs() const override { return "values on the edge, and the exact solution there"; }

  void add(const StepState& /*step*/, ElementBlocks& /*blocks*/) const override {}

  void accept(const StepState& step, const Eigen::Matrix2Xd& increment) override {
    const Edge& edge = step.edges[static_cast<std::size_t>(piece_)];
    Eigen::Matrix2Xd displacement(2, static_cast<Eigen::Index>(edge.points.size()));
    double squares = 0.0;
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const BoundaryPoint& p = edge.points[k];
      Vec2 u = step.basis.support(edge.support_cell[edge.segment_of(k)], p.x).interpolate(increment);
      if (!history_.empty()) u += history_.at(p.span, p.u).head<2>();
      displacement.col(static_cast<Eigen::Index>(k)) = u;
      const Vec2 error = u - exact_(p, step.t);
      const double size = normal_only_ ? p.normal.dot(error) : error.norm();
      squares += p.weight * size * size;
    }
    history_ = {edge.segments, gauss(edge.points_per_segment).point, std::move(displacement)};
    l2_ = std::sqrt(squares);
  }

  void respace(int piece, const PlaceMap& places) override {
    if (piece == piece_) history_.places = places;
  }

  void report(Resultants& resultants) const override { resultants.displacement_errors[piece_name_] = l2_; }

 private:
  int piece_;
  std::string piece_name_;
  bool normal_only_;
  DisplacementOnPiece exact_;
  EdgeHistory history_;  ///< displacement
  double l2_ = 0.0;
};

}  // namespace

std::unique_ptr<Contribution> boundary_error(int piece, std::string piece_name, bool normal_only,
                                             DisplacementOnPiece exact) {
  return std::make_unique<BoundaryError>(piece, std::move(piece_name), normal_only, std::move(exact));
}

}  // namespace shoreline
