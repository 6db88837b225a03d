#pragma once
#include <string>
#include <string_view>

#include "apps/tools/debug/pixel/cut.h"
#include "apps/tools/debug/trace/condition.h"
#include "fp_compiler/ir/ir.h"

namespace arbiter::tools::debug {

/// The register and line that `--watch` names.
struct Watch {
  std::string reg;        ///< a register that an instruction there may read, or a result
  std::uint32_t line = 0; ///< the value is taken after the instructions up to this line
};
/// Parses "REG@LINE".
[[nodiscard]] Result<Watch, DebugError> parseWatch(std::string_view text);

/// Returns a program that shows a register after a line, as a color.
/// \param text the fragment program's text, from which \p program was compiled
/// Fails if there is no instruction up to that line, or no such register there.
[[nodiscard]] Result<fp::ir::Program, DebugError>
watchProgram(const fp::ir::Program &program, std::string_view text, const Watch &watch,
             Fragments fragments = Fragments::Covered);

/// The watched value over the picture.
struct Extent {
  std::size_t covered = 0; ///< number of pixels that the mesh covers
  fp::ir::Vec4 least = {}; ///< of each component, of those that are numbers; NaN if there is none
  fp::ir::Vec4 greatest = {};
};
[[nodiscard]] Extent extentOf(const std::vector<fp::ir::Vec4> &values);

/// Returns values as opaque 8-bit RGBA: low becomes 0 and high 255. NaN becomes magenta, an
/// uncovered pixel transparent black.
[[nodiscard]] std::vector<std::uint8_t> picturedValues(const std::vector<fp::ir::Vec4> &values,
                                                       float low, float high);

} // namespace arbiter::tools::debug
