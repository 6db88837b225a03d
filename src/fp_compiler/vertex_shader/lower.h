#pragma once
#include <cstdint>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/vertex_shader/shader.h"

namespace arbiter::fp::vertex_shader {

/// The contents of one env parameter of the program.
struct EnvRow {
  std::uint32_t symbol; ///< an invariant, index into Shader::symbols
  std::uint8_t row;     ///< row of its value
};

struct Lowered {
  ir::Program program;
  std::vector<EnvRow> env; ///< by env parameter
};

/// Returns the shader as IR of a vertex program. Outputs that it does not write stay unwritten.
/// This defines cases that the specification leaves undefined. A local is zero before it is
/// written. OP_INDEX out of range gives zero. Constants that are not finite become the nearest
/// finite number.
///
/// Requires: the symbols and arguments of each operation are in Shader::symbols and in the table.
/// Only OP_INDEX and InsertComponent write a local of matrix type.
[[nodiscard]] Lowered lower(const Shader &shader);

} // namespace arbiter::fp::vertex_shader
