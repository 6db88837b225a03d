#pragma once
#include <string>

#include "apps/tools/check/checked_file.h"

/// Shows used / limit as bars. The figures are next to each bar as text, so that nothing depends on
/// color or length alone.
namespace arbiter::tools {

/// Returns a bar as HTML. Its frame is the limit. Over the limit the frame is the count, and a mark
/// shows the limit.
[[nodiscard]] std::string gaugeBar(std::uint32_t used, std::uint32_t limit);

/// Returns a table with a gauge for each native resource of the program's target, and the API's
/// counts. Requires: a file that has counts.
[[nodiscard]] std::string gaugeTable(const CheckedFile &file);

/// The native resource of which the program uses the largest part.
struct Fullest {
  const char *title = ""; ///< empty if no resource has a limit
  std::uint32_t used = 0, limit = 0;

  [[nodiscard]] double part() const { return limit == 0 ? 0 : double(used) / limit; }
};
[[nodiscard]] Fullest fullestOf(const CheckedFile &file);

} // namespace arbiter::tools
