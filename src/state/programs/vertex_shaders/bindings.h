#pragma once
#include <GL/gl.h>

#include "state/objects/symbol_table.h"

/// Binds GL parameters that shaders of EXT_vertex_shader read: the tables of section 2.14.
namespace arbiter::state {

struct ProgramContext;

/// Execute BindLightParameterEXT to BindParameterEXT. They return the symbol's name, or 0 after an
/// error.
/// \error INVALID_ENUM for a name in none of the tables, or for a light, unit or plane that does
/// not exist
[[nodiscard]] GLuint bindLightParameter(ProgramContext &context, GLenum light, GLenum value);
[[nodiscard]] GLuint bindMaterialParameter(ProgramContext &context, GLenum face, GLenum value);
[[nodiscard]] GLuint bindTexGenParameter(ProgramContext &context, GLenum unit, GLenum coord,
                                         GLenum value);
[[nodiscard]] GLuint bindTextureUnitParameter(ProgramContext &context, GLenum unit, GLenum value);
[[nodiscard]] GLuint bindParameter(ProgramContext &context, GLenum value);

/// Returns a row of a bound symbol's current value, or a column if it is a matrix that is a
/// variant. CURRENT_VERTEX_EXT has no value: (0, 0, 0, 1). Requires that no primitive is open.
[[nodiscard]] Vec4 boundValue(ProgramContext &context, const VertexSymbol &symbol, std::size_t row);

} // namespace arbiter::state
