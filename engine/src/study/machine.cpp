#include "machine.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "shoreline/engine/version.hpp"

namespace shoreline {

std::string machine_name() {
  std::string processor = "unknown processor";
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (const std::size_t colon = line.find(": "); line.starts_with("model name") && colon != std::string::npos) {
      processor = line.substr(colon + 2);
      break;
    }
  const double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  const int cores = omp_get_num_procs();
  return fmt::format("{}, {} {}, {:.0f} GiB", processor, cores, cores == 1 ? "core" : "cores",
                     std::ceil(bytes / std::exp2(30.0)));
}

std::string program_name() {
  const std::string report = version_report();
  return report.substr(0, report.find('\n'));
}

}  // namespace shoreline
