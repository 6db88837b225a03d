#include "apps/tools/debug/trace/trace.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace arbiter::tools::debug {

float greatestError(const Row &row) {
  float greatest = 0;
  for (const float error : row.error)
    greatest = std::isnan(error) ? std::numeric_limits<float>::infinity()
                                 : std::max(greatest, std::fabs(error));
  return greatest;
}

std::size_t rowAtLine(const Trace &trace, std::uint32_t line) {
  std::size_t found = 0;
  for (std::size_t i = 0; i < trace.rows.size(); ++i)
    if (trace.rows[i].at.line <= line)
      found = i;
  return found;
}

} // namespace arbiter::tools::debug
