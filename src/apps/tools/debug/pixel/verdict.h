#pragma once
#include <optional>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/pixel/drawer.h"
#include "apps/tools/debug/trace/compare.h"

namespace arbiter::tools::debug {

/// Compares a drawn pixel with the interpreter's result.
struct Verdict {
  std::string drawer;
  std::array<std::uint8_t, 4> picture = {};     ///< the pixel in the document's picture
  std::array<std::uint8_t, 4> interpreter = {}; ///< the fragment's color in 8 bits
  std::optional<Vec4> drawn; ///< the fragment's color in a float target; empty: discarded
  /// True if the depth test hides the fragment where the program puts it; `drawn` is then its color
  /// at the rasterized depth.
  bool isHidden = false;
  bool isDiscarded = false; ///< true if the interpreter discards the fragment
  int steps = 0;            ///< greatest difference of 8-bit values
  bool bitsEqual = false;   ///< true if the float colors are equal, with NaNs equal
  /// The first instruction whose value differs by more than rounding; value.first is the
  /// interpreter's.
  std::optional<Difference> first;
  bool bisected = false; ///< true if `first` was found by bisection, so that an earlier row may
                         ///< differ without an effect

  [[nodiscard]] bool isEqual() const { return steps == 0 && isDiscarded == !drawn.has_value(); }
};

/// The greatest difference between host and interpreter that rounding of functions can explain.
inline constexpr Tolerance kRounding = {0x1p-16f, 0x1p-16f};

/// Compares the trace's first arithmetic with the drawn pixel. If they differ, draws the program
/// cut after its instructions to find the first difference. Fails if the drawer fails.
[[nodiscard]] Result<Verdict, DebugError> judge(Drawer &drawer, const fp::ir::Program &program,
                                                const Trace &trace, int x, int y,
                                                const Tolerance &tolerance = kRounding);

/// Returns a line such as "swrast drew 8c5a3fff: equal" or "host differs by 2/255, first at line
/// 10: MAD a, ..".
[[nodiscard]] std::string verdictLine(const Verdict &verdict, const Trace &trace);

/// Returns the values of \p rows (ascending) in one pixel, drawn by cut programs.
[[nodiscard]] Result<std::vector<Vec4>, DebugError>
drawRows(Drawer &drawer, const fp::ir::Program &program, const std::vector<std::size_t> &rows,
         int x, int y, Fragments fragments = Fragments::Covered);

} // namespace arbiter::tools::debug
