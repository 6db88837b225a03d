#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/vertex_shader/shader.h"

namespace arbiter::fp::vertex_shader {

/// What an env parameter of the program holds.
struct EnvRow {
  std::uint32_t symbol; ///< an invariant, in Shader::symbols
  std::uint8_t row;     ///< of its value
};

struct Lowered {
  ir::Program program;
  std::vector<EnvRow> env; ///< by the number of the env parameter
};

/// The shader as IR of a vertex program. Outputs that it does not write stay unwritten. What the
/// specification leaves undefined: a local is zero before it is written; OP_INDEX outside of its
/// block gives zero; constants that are not finite are the nearest number that is.
///
/// Requires: symbols and arguments of each operation are in Shader::symbols and in the table; a
/// local of matrix type is written by OP_INDEX and InsertComponent alone.
[[nodiscard]] Lowered lower(const Shader &shader);

} // namespace arbiter::fp::vertex_shader
