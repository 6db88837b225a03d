#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "fp_compiler/vertex_shader/shader.h"

/// An independent implementation of EXT_vertex_shader for tests. It runs a shader as the table of
/// operations in section 2.14 is printed, in double precision, without the IR.
namespace arbiter::fp::testing {

/// The value of a symbol: [0] for a scalar, [0] to [3] for a vector, all for a matrix, column by
/// column.
using SymbolValue = std::array<double, 16>;

struct VertexShaderResults {
  std::array<double, 4> position = {};
  std::array<std::array<double, 4>, 2> colors = {};
  std::array<std::array<double, 4>, 32> texCoords = {};
  double fog = 0.0;
  bool defined = true; ///< false if an operation gave a number that is not finite
};

/// Runs a shader.
/// \param values one for each symbol; for locals the initial values
/// \param disturbance each result is changed by this part of itself, up and down in turn; if that
/// changes the output, single precision may differ too
[[nodiscard]] VertexShaderResults evaluateVertexShader(const vertex_shader::Shader &shader,
                                                       std::vector<SymbolValue> values,
                                                       double disturbance = 0.0);

} // namespace arbiter::fp::testing
