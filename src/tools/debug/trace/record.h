#pragma once
#include <functional>
#include <string_view>
#include <vector>

#include "tools/debug/trace/trace.h"

namespace arbiter::tools::debug {

/// What the program reads for the pixel, before any arithmetic's rounding.
struct TraceInputs {
  std::vector<Vec4> attributes; ///< by Program::attributes
  std::vector<Vec4> parameters; ///< by Program::parameters; constants need no value
  /// The texel of instruction \p index of the program. Empty: zeros.
  std::function<Vec4(std::size_t index, const fp::ir::Sample &, fp::Numerics)> texture;
  /// The level of detail of a texture instruction, where it is known.
  std::function<std::optional<float>(std::size_t index)> lod;
  float fogCoordinate = 0;            ///< for the fog options
  Vec4 fogColor = {}, fogParams = {}; ///< likewise: the rows state.fog.color and state.fog.params
  Vec4 secondary = {};                ///< for Options::colorSum
};

/// The interpreter's inputs for one arithmetic. \p given and \p program must outlive them.
[[nodiscard]] fp::ir::Inputs interpreterInputs(const fp::ir::Program &program,
                                               const TraceInputs &given, fp::Numerics numerics);

/// Runs \p program with both arithmetics. Instructions after a KIL that discards are run too, and
/// marked.
/// \param text what the program's spans lie in
/// Requires: validate(program) finds nothing.
[[nodiscard]] Trace record(const fp::ir::Program &program, std::string_view text,
                           const TraceInputs &given, Both<fp::Numerics> numerics);

} // namespace arbiter::tools::debug
