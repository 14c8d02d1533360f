#include "shoreline/engine/strain_energy.hpp"

namespace shoreline {

double strain_energy(const MaterialPoints& points) {
  double energy = 0.0;
  for (Index p = 0; p < points.size(); ++p)
    energy += 0.5 * points.volume[p] * points.stress.col(p).head<3>().dot(points.strain.col(p));
  return energy;
}

}  // namespace shoreline
