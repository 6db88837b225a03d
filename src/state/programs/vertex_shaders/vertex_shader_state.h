#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include <GL/gl.h>

#include "state/objects/symbol_table.h"
#include "state/programs/vertex_shaders/recorder.h"

namespace arbiter::state {

class Context;
struct CompiledProgram;
struct ProgramTarget;

/// What a compiled shader of EXT_vertex_shader has beside its program.
struct VertexShaderInputs {
  /// What an env parameter of the program holds.
  struct Row {
    std::shared_ptr<const VertexSymbol> symbol;
    std::uint8_t row;
  };
  std::vector<Row> env; ///< by number
  bool follows = false; ///< a value of `env` is one of GL's, which draws ask for
  /// Within the limits. A shader that is not is undefined: vertices are fixed function's (2.14).
  bool fits = true;
  bool optimized = true; ///< within those of the card itself
  GLuint instructions = 0, variants = 0, invariants = 0, localConstants = 0, locals = 0;
};

/// EXT_vertex_shader in a context, where the layer has it. Shaders are objects of
/// Target::VertexShader, whose env parameters are the invariants of the one that is drawn with.
struct VertexShaderState {
  std::unique_ptr<VertexShaderRecorder> recorder; ///< between Begin- and EndVertexShaderEXT
  /// Of the shader that draws are drawn with; null: of none.
  std::shared_ptr<const VertexShaderInputs> effective;
  std::uint64_t seenValues = 0; ///< VertexSymbolTable::version() that the env parameters are of
};

/// BindVertexShaderEXT, also of a list.
void bindVertexShader(Context &context, GLuint name);
/// SetInvariantEXT, also of a list: the rows of its value. It is one that can be set.
void setInvariant(Context &context, GLuint name, const std::vector<Vec4> &rows);

/// The row of vertex shaders, if one is enabled and defined: what draws are drawn with unless a
/// vertex program is enabled. Gives its invariants their values.
[[nodiscard]] const ProgramTarget *vertexShaderEffective(Context &context);
/// Before a draw: values that have changed since, by other contexts too. Outside of Begin and End.
void refreshVertexShader(Context &context);
/// Each draw must look.
[[nodiscard]] bool vertexShaderFollows(const Context &context);

/// A row of what GL has of a symbol that follows it. Outside of Begin and End.
[[nodiscard]] Vec4 followedValue(Context &context, const VertexSymbol &symbol, std::size_t row);

/// A value of GetIntegerv and its kin; false: it is the host's to answer.
[[nodiscard]] bool vertexShaderValue(const Context &context, GLenum pname, GLint &value);

} // namespace arbiter::state
