#pragma once
#include <functional>
#include <string>
#include <vector>

namespace bench {

/// A thing to measure. A sample repeats it \p count times and returns nanoseconds: their average,
/// or one time for each of \p count programs, numbered from \p seed.
struct Row {
  std::string name;
  std::function<std::vector<double>(int count, unsigned seed)> sample;
};

[[nodiscard]] const std::vector<Row> &callRows();
[[nodiscard]] const std::vector<Row> &drawRows();
[[nodiscard]] const std::vector<Row> &loadRows();
/// Returns rows of large quads, for the modes of arithmetic.
[[nodiscard]] const std::vector<Row> &fillRows();

/// Returns a valid program within a Radeon 9700's limits: samples first, then arithmetic on all of
/// them.
[[nodiscard]] std::string generateText(unsigned seed);

} // namespace bench
