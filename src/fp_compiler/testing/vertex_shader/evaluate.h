#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/vertex_shader/shader.h"

/// A second reading of EXT_vertex_shader for tests: runs a shader as the table of operations of
/// section 2.14 is printed, in double precision, without the IR.
namespace arbiter::fp::testing {

/// A symbol's value: [0] of a scalar, [0] to [3] of a vector, all of a matrix, column after column.
using SymbolValue = std::array<double, 16>;

struct VertexShaderResults {
  std::array<double, 4> position = {};
  std::array<std::array<double, 4>, 2> colors = {};
  std::array<std::array<double, 4>, 32> texCoords = {};
  double fog = 0.0;
  bool defined = true; ///< no operation gave what is no finite number
};

/// \param values one for each symbol; those of locals are what they have at first
/// \param disturbance each result is changed by so much of itself, up and down in turn: where that
///                    changes what comes out, single precision need not give the same
[[nodiscard]] VertexShaderResults evaluateVertexShader(const vertex_shader::Shader &shader,
                                                       std::vector<SymbolValue> values,
                                                       double disturbance = 0.0);

} // namespace arbiter::fp::testing
