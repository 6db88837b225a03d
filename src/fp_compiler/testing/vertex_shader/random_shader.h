#pragma once
#include <vector>

#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/vertex_shader/evaluate.h"
#include "fp_compiler/vertex_shader/shader.h"

/// Random shaders of EXT_vertex_shader, from a seed and the same on every machine.
namespace arbiter::fp::testing {

struct RandomVertexShader {
  /// It writes the position first, as the vertex has it, then the first kRandomTexCoords sets of
  /// coordinates, both colours and the fog coordinate in full.
  vertex_shader::Shader shader;
  /// One for each symbol, as evaluateVertexShader() takes them. Those of state are made up, and the
  /// vertex is (0, 0, 0, 1).
  std::vector<SymbolValue> values;
};

inline constexpr int kRandomTexCoords = 4;

[[nodiscard]] RandomVertexShader randomVertexShader(Random &random);

} // namespace arbiter::fp::testing
