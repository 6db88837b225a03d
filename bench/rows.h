#pragma once
#include <string_view>
#include <vector>

namespace bench {

/// One thing to measure. A sample repeats it \p count times and gives nanoseconds: their average,
/// or one time for each of \p count programs, the first of them number \p seed.
struct Row {
  std::string_view name;
  std::vector<double> (*sample)(int count, unsigned seed);
};

[[nodiscard]] const std::vector<Row> &callRows();
[[nodiscard]] const std::vector<Row> &drawRows();
[[nodiscard]] const std::vector<Row> &loadRows();

} // namespace bench
