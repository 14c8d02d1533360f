#include "multiply_adds.hpp"

#include <array>
#include <numeric>

namespace shoreline::bench {

double multiply_adds(long count, double b, double c) {
  std::array<double, chains> a;
  std::iota(a.begin(), a.end(), 0.0);  // alike, they would be worked out once
  for (long k = 0; k < count; ++k)
    for (double& chain : a) chain = chain * b + c;
  double sum = 0.0;
  for (const double chain : a) sum += chain;
  return sum;
}

bool has_fma() {
#ifdef __FMA__
  return true;
#else
  return false;
#endif
}

}  // namespace shoreline::bench
