#pragma once
#include <array>
#include <memory>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/vertex_shader/shader.h"
#include "state/objects/symbol_table.h"

namespace arbiter::state {

/// Builds a shader from the commands between BeginVertexShaderEXT and EndVertexShaderEXT
/// (EXT_vertex_shader, section 2.14), and detects errors. A command with an error leaves the shader
/// unchanged.
class VertexShaderRecorder {
public:
  /// No context has a limit above this.
  static constexpr std::uint32_t kMaxInstructions = 1u << 16;

  /// The result of a command. NO_ERROR: the command is in the shader. `why` tells what is wrong,
  /// for the log.
  struct Verdict {
    GLenum error = GL_NO_ERROR;
    const char *why = "";
  };

  VertexShaderRecorder(VertexSymbolTable &table, GLuint coordinateSets)
      : m_table(table), m_coordinateSets(coordinateSets) {}

  /// Adds an operation of ShaderOp1EXT to ShaderOp3EXT. \param count number of arguments
  [[nodiscard]] Verdict operation(GLenum op, GLuint result, int count,
                                  const std::array<GLuint, 3> &arguments);
  [[nodiscard]] Verdict swizzle(GLuint result, GLuint in, const std::array<GLenum, 4> &takes);
  [[nodiscard]] Verdict writeMask(GLuint result, GLuint in, const std::array<GLenum, 4> &writes);
  [[nodiscard]] Verdict insert(GLuint result, GLuint source, GLuint number);
  [[nodiscard]] Verdict extract(GLuint result, GLuint source, GLuint number);
  /// Executes SetLocalConstantEXT, which may be called once for each constant in a definition.
  [[nodiscard]] Verdict setConstant(GLuint name);

  /// The shader as recorded until EndVertexShaderEXT.
  struct Recorded {
    fp::vertex_shader::Shader shader;
    std::vector<std::shared_ptr<VertexSymbol>> symbols; ///< one for each of the shader's symbols
    std::vector<bool> used; ///< true if an operation uses the symbol, not just its block
    bool tooLong = false;   ///< true if operations are missing
  };
  [[nodiscard]] Recorded end();

private:
  /// Limit of the work, counted in operations. OP_INDEX counts more, because it selects among a
  /// whole block.
  static constexpr std::size_t kMaxWork = 2 * kMaxInstructions, kWorkOfIndexed = 8;

  [[nodiscard]] std::optional<fp::vertex_shader::Result> outputOf(GLuint name) const;
  [[nodiscard]] Verdict result(GLuint name, fp::vertex_shader::Result &result);
  [[nodiscard]] Verdict argument(GLuint name, std::uint32_t &symbol);
  /// Returns the symbol's number in the shader. Its whole block is added if necessary.
  [[nodiscard]] std::optional<std::uint32_t> numberOf(GLuint name);
  [[nodiscard]] fp::vertex_shader::DataType typeOf(const fp::vertex_shader::Result &result) const {
    return fp::vertex_shader::typeOf(result, m_recorded.shader.symbols);
  }
  [[nodiscard]] fp::vertex_shader::DataType typeOf(std::uint32_t symbol) const {
    return m_recorded.shader.symbols[symbol].type;
  }
  /// Checks that both are vectors, for SwizzleEXT and WriteMaskEXT.
  [[nodiscard]] Verdict vectors(GLuint resultName, GLuint in,
                                fp::vertex_shader::Operation &operation);
  [[nodiscard]] Verdict move(fp::vertex_shader::Op op, GLuint resultName, GLuint source,
                             GLuint number);
  void add(const fp::vertex_shader::Operation &operation);

  VertexSymbolTable &m_table;
  GLuint m_coordinateSets;
  Recorded m_recorded;
  std::unordered_map<GLuint, std::uint32_t> m_numbers;
  std::size_t m_work = 0;
  std::unordered_set<GLuint> m_constants; ///< constants that were set
};

} // namespace arbiter::state
