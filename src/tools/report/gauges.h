#pragma once
#include <string>

#include "tools/check/checked_file.h"

/// used / limit as bars. The figures stand beside each as text, so that nothing is said by colour
/// or length alone.
namespace arbiter::tools {

/// A bar as HTML. As long as its frame for a full count; over the limit the frame is the count, and
/// a mark stands where the limit is.
[[nodiscard]] std::string gaugeBar(std::uint32_t used, std::uint32_t limit);

/// A table with a gauge for each native resource of the program's target, and the counts of the
/// API. Requires a file that has counts.
[[nodiscard]] std::string gaugeTable(const CheckedFile &file);

/// The native resource of which the program takes the largest part.
struct Fullest {
  const char *title = ""; ///< empty if no resource has a limit
  std::uint32_t used = 0, limit = 0;

  [[nodiscard]] double part() const { return limit == 0 ? 0 : double(used) / limit; }
};
[[nodiscard]] Fullest fullestOf(const CheckedFile &file);

} // namespace arbiter::tools
