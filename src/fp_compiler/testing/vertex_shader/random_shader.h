#pragma once
#include <vector>

#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/vertex_shader/evaluate.h"
#include "fp_compiler/vertex_shader/shader.h"

/// Random shaders of EXT_vertex_shader. A seed gives the same shader on every machine.
namespace arbiter::fp::testing {

struct RandomVertexShader {
  /// The shader. It writes the position first, as the vertex has it. Then it writes the first
  /// kRandomTexCoords sets of coordinates, both colours and the fog coordinate in full.
  vertex_shader::Shader shader;
  /// The value of each symbol, for evaluateVertexShader(). Values of state are made up, and the
  /// vertex is (0, 0, 0, 1).
  std::vector<SymbolValue> values;
};

inline constexpr int kRandomTexCoords = 4;

[[nodiscard]] RandomVertexShader randomVertexShader(Random &random);

} // namespace arbiter::fp::testing
