#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "apps/tools/debug/trace/trace.h"

namespace arbiter::tools::debug {

/// A program's inputs for one pixel, before any arithmetic rounds them.
struct TraceInputs {
  std::vector<Vec4> attributes; ///< in the order of Program::attributes
  std::vector<Vec4> parameters; ///< in the order of Program::parameters; constants need no value
  /// Returns the texel for instruction \p index of the program. If unset, texels are zero.
  std::function<Vec4(std::size_t index, const fp::ir::Sample &, fp::Numerics)> texture;
  /// Returns the level of detail of a texture instruction if it is known.
  std::function<std::optional<float>(std::size_t index)> lod;
  float fogCoordinate = 0;            ///< for the fog options
  Vec4 fogColor = {}, fogParams = {}; ///< state.fog.color and state.fog.params, for the fog options
  Vec4 secondary = {};                ///< for Options::colorSum
};

/// Returns the interpreter's inputs for one arithmetic. \p given and \p program must outlive them.
[[nodiscard]] fp::ir::Inputs interpreterInputs(const fp::ir::Program &program,
                                               const TraceInputs &given, fp::Numerics numerics);

/// Runs \p program with both arithmetics. Instructions after a KIL that discards are also run, and
/// marked.
/// \param text the text that the program's spans refer to
/// Requires: validate(program) finds nothing.
[[nodiscard]] Trace record(const fp::ir::Program &program, std::string_view text,
                           const TraceInputs &given, Both<fp::Numerics> numerics);

} // namespace arbiter::tools::debug
