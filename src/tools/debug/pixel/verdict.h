#pragma once
#include <optional>

#include "tools/debug/pixel/cut.h"
#include "tools/debug/pixel/drawer.h"
#include "tools/debug/trace/compare.h"

namespace arbiter::tools::debug {

/// What an implementation drew beside what the interpreter says.
struct Verdict {
  std::string drawer;
  std::array<std::uint8_t, 4> picture = {};     ///< the pixel of the document's picture
  std::array<std::uint8_t, 4> interpreter = {}; ///< the fragment's colour in 8 bits
  std::optional<Vec4> drawn; ///< the fragment's colour as a float target has it; none: discarded
  bool isDiscarded = false;  ///< by the interpreter
  int steps = 0;             ///< the greatest difference in 8 bits
  bool bitsEqual = false;    ///< of the float colours; NaNs are equal
  /// The first instruction whose value differs beyond rounding; value.first is the interpreter's.
  std::optional<Difference> first;
  bool bisected = false; ///< `first` was found by halving: an earlier one may differ and not matter

  [[nodiscard]] bool isEqual() const { return steps == 0 && isDiscarded == !drawn.has_value(); }
};

/// Where host and interpreter may differ by the rounding of their functions, and no more.
inline constexpr Tolerance kRounding = {0x1p-16f, 0x1p-16f};

/// Compares the trace's first arithmetic with what the drawer makes of the pixel. Where they
/// differ, the program is drawn cut behind its instructions. Errors: the drawer's.
[[nodiscard]] Result<Verdict, DebugError> judge(Drawer &drawer, const fp::ir::Program &program,
                                                const Trace &trace, int x, int y,
                                                const Tolerance &tolerance = kRounding);

/// "swrast drew 8c5a3fff: equal", "host differs by 2/255, first at line 10: MAD a, ..".
[[nodiscard]] std::string verdictLine(const Verdict &verdict, const Trace &trace);

/// The value of each of \p rows (ascending) in one pixel, drawn by cut programs.
[[nodiscard]] Result<std::vector<Vec4>, DebugError>
drawRows(Drawer &drawer, const fp::ir::Program &program, const std::vector<std::size_t> &rows,
         int x, int y, Fragments fragments = Fragments::Covered);

} // namespace arbiter::tools::debug
