#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>

#include "state/objects/symbol_table.h"
#include "state/programs/vertex_shaders/recorder.h"

namespace arbiter::state {

struct ProgramContext;
struct CompiledProgram;
struct ProgramTarget;

/// The properties of a compiled shader of EXT_vertex_shader beside its program.
struct VertexShaderInputs {
  /// The source of one env parameter.
  struct Row {
    std::shared_ptr<const VertexSymbol> symbol;
    std::uint8_t row;
  };
  std::vector<Row> env; ///< indexed by the parameter's number
  bool follows = false; ///< true if some value in `env` is a GL parameter that draws must query
  /// True if it is within the limits. Otherwise it is undefined, and fixed function processes
  /// vertices (2.14).
  bool fits = true;
  bool optimized = true; ///< true if it is within the limits of the card itself
  GLuint instructions = 0, variants = 0, invariants = 0, localConstants = 0, locals = 0;
};

/// A context's state of EXT_vertex_shader, if the layer offers it. Shaders are objects of
/// Target::VertexShader; the target's env parameters are the invariants of the effective one.
struct VertexShaderState {
  /// set between BeginVertexShaderEXT and EndVertexShaderEXT
  std::unique_ptr<VertexShaderRecorder> recorder;
  /// The inputs of the effective shader, or null.
  std::shared_ptr<const VertexShaderInputs> effective;
  std::uint64_t seenValues = 0; ///< VertexSymbolTable::version() of the env parameters
};

/// Executes BindVertexShaderEXT, called or from a list.
void bindVertexShader(ProgramContext &context, GLuint name);
/// Executes SetInvariantEXT, called or from a list. Requires an invariant that may be set.
/// \param rows of its value
void setInvariant(ProgramContext &context, GLuint name, const std::vector<Vec4> &rows);

/// Returns the target of vertex shaders if one is enabled and defined, and sets its invariants'
/// values. Draws use it unless a vertex program is enabled.
[[nodiscard]] const ProgramTarget *vertexShaderEffective(ProgramContext &context);
/// Updates values that have changed, in other contexts too, before a draw. Requires that no
/// primitive is open.
void refreshVertexShader(ProgramContext &context);
/// True if each draw must call refreshVertexShader().
[[nodiscard]] bool vertexShaderFollows(const ProgramContext &context);

/// Returns a row of the GL value that a symbol follows. Requires that no primitive is open.
[[nodiscard]] Vec4 followedValue(ProgramContext &context, const VertexSymbol &symbol,
                                 std::size_t row);

/// Answers GetIntegerv and similar queries. Returns false if the host must answer.
[[nodiscard]] bool vertexShaderValue(const ProgramContext &context, GLenum pname, GLint &value);

} // namespace arbiter::state
