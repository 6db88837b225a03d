#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/ir/ir.h"
#include "tools/debug/pixel/cut.h"
#include "tools/debug/trace/condition.h"

namespace arbiter::tools::debug {

/// What `--watch` asks for.
struct Watch {
  std::string reg;        ///< anything that an instruction may read there, or a result
  std::uint32_t line = 0; ///< after the instructions up to this line
};
/// "REG@LINE".
[[nodiscard]] Result<Watch, DebugError> parseWatch(std::string_view text);

/// A program that shows a register after a line, as a colour.
/// \param text the fragment program's, which \p program was made of
/// Errors: no instruction up to that line, no such register there.
[[nodiscard]] Result<fp::ir::Program, DebugError>
watchProgram(const fp::ir::Program &program, std::string_view text, const Watch &watch,
             Fragments fragments = Fragments::Covered);

/// Values as 8-bit RGBA, opaque: low becomes 0 and high 255. NaN is magenta; what nothing covers is
/// transparent black.
[[nodiscard]] std::vector<std::uint8_t> picturedValues(const std::vector<fp::ir::Vec4> &values,
                                                       float low, float high);

} // namespace arbiter::tools::debug
