#pragma once
#include <string>
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
/// Of the modes of arithmetic: large quads.
[[nodiscard]] const std::vector<Row> &fillRows();

/// A valid program within a Radeon 9700's limits: samples first, then arithmetic on all of them.
[[nodiscard]] std::string generateText(unsigned seed);

} // namespace bench
