#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace arbiter::fp::proof {

/// What one function or opcode was held against, and how it did.
struct Row {
  std::string name;
  std::uint64_t cases = 0;
  std::uint64_t different = 0;
  /// Differences where the long double of the reference cannot tell which is right; not counted as
  /// different. They are within one unit of the last place.
  std::uint64_t open = 0;
  std::string first; ///< the first difference, in words
};

struct Settings {
  std::uint64_t stride = 1;  ///< every how manieth pattern or single
  std::uint64_t samples = 0; ///< of each opcode
  std::uint64_t seed = 1;
  std::function<void(const std::string &name, double done)> progress;
};

using Rows = std::vector<Row>;

/// fp24::rounded, truncated and colour: all 2^24 patterns, all 2^32 singles, and, whatever the
/// stride, the singles around the turning points of each exponent.
[[nodiscard]] Rows formats(const Settings &settings);
/// Opcodes of one number, and _SAT, on all 2^24 patterns.
[[nodiscard]] Rows unary(const Settings &settings);
/// All arithmetic opcodes on samples, special values among them.
[[nodiscard]] Rows sampled(const Settings &settings);
/// Programs of one instruction through ir::evaluate(), on singles as an application gives them:
/// what each kind of register makes of them, swizzles, signs and _SAT.
[[nodiscard]] Rows programs(const Settings &settings);

} // namespace arbiter::fp::proof
