#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace arbiter::fp::proof {

/// The result of testing one function or opcode.
struct Row {
  std::string name;
  std::uint64_t cases = 0;
  std::uint64_t different = 0;
  /// The number of differences in which the reference's long double cannot tell which result is
  /// right. They are within one unit in the last place, and do not count as different.
  std::uint64_t open = 0;
  std::string first; ///< a description of the first difference
};

struct Settings {
  std::uint64_t stride = 1;  ///< tests every n-th pattern or single
  std::uint64_t samples = 0; ///< for each opcode
  std::uint64_t seed = 1;
  std::function<void(const std::string &name, double done)> progress;
};

using Rows = std::vector<Row>;

/// Tests fp24::rounded, truncated and colour: all 2^24 patterns, all 2^32 singles, and, for any
/// stride, the singles around the turning points of each exponent.
[[nodiscard]] Rows formats(const Settings &settings);
/// Tests opcodes of one number, and _SAT, on all 2^24 patterns.
[[nodiscard]] Rows unary(const Settings &settings);
/// Tests all arithmetic opcodes on samples, including special values.
[[nodiscard]] Rows sampled(const Settings &settings);
/// Tests programs of one instruction by ir::evaluate(), on singles as an application sets them: the
/// conversion by each kind of register, swizzles, signs and _SAT.
[[nodiscard]] Rows programs(const Settings &settings);

} // namespace arbiter::fp::proof
