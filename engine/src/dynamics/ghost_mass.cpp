#include "ghost_mass.hpp"

namespace shoreline {

void GhostMass::find(const Basis& basis, const std::vector<char>& active) {
  if (active == active_) return;
  active_ = active;
  std::vector<Eigen::Triplet<double>> entries;
  for (const Face& face : faces_inside(basis.grid(), active)) {
    FaceJumps& jumps = jumps_[{face.cell, face.neighbour}];
    if (jumps.functions.empty()) jumps = face_jumps(basis, face, scale_, 2 * basis.degree() + 1);
    const auto n = static_cast<Eigen::Index>(jumps.functions.size());
    Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t q = 0; q < jumps.jump.size(); ++q)
      mass += jumps.weight[q] * jumps.jump[q].transpose() * jumps.jump[q];
    for (Eigen::Index a = 0; a < n; ++a)
      for (Eigen::Index b = 0; b < n; ++b)
        entries.emplace_back(jumps.functions[static_cast<std::size_t>(a)], jumps.functions[static_cast<std::size_t>(b)],
                             mass(a, b));
  }
  matrix_.resize(basis.functions(), basis.functions());
  matrix_.setFromTriplets(entries.begin(), entries.end());
}

}  // namespace shoreline
