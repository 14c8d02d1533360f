#include "results_reader.hpp"

#include "hdf5_file.hpp"

namespace shoreline {

std::map<std::string, Eigen::Matrix2Xd> curve_displacements(const std::filesystem::path& file) {
  const Hdf5File results(file, Hdf5File::Mode::read);
  std::map<std::string, Eigen::Matrix2Xd> displacements;
  if (!results.contains("/steps")) return displacements;
  const std::vector<std::string> steps = results.names("/steps");
  if (steps.empty() || !results.contains("/steps/" + steps.front() + "/curves")) return displacements;
  for (const std::string& curve : results.names("/steps/" + steps.front() + "/curves")) {
    const auto at = [&](const std::string& step) {
      return results.rows("/steps/" + step + "/curves/" + curve + "/polyline");
    };
    const Eigen::MatrixXd start = at(steps.front());
    const Eigen::MatrixXd end = at(steps.back());
    if (start.cols() == end.cols()) displacements[curve] = (end - start).topRows<2>();
  }
  return displacements;
}

}  // namespace shoreline
