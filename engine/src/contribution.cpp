#include "shoreline/engine/contribution.hpp"

namespace shoreline {

void Contribution::accept(const StepState& /*step*/, const Eigen::Matrix2Xd& /*increment*/) {}

void Contribution::respace(int /*piece*/, const PlaceMap& /*places*/) {}

void Contribution::report(Resultants& /*resultants*/) const {}

}  // namespace shoreline
