#pragma once
#include <GL/gl.h>

#include "state/objects/symbol_table.h"

/// Parameters of GL's that shaders of EXT_vertex_shader read: the tables of section 2.14.
namespace arbiter::state {

class Context;

/// BindLightParameterEXT to BindParameterEXT: the symbol's name; 0 after an error.
/// \error INVALID_ENUM what is in none of the tables, or is of a light, unit or plane that there is
/// not
[[nodiscard]] GLuint bindLightParameter(Context &context, GLenum light, GLenum value);
[[nodiscard]] GLuint bindMaterialParameter(Context &context, GLenum face, GLenum value);
[[nodiscard]] GLuint bindTexGenParameter(Context &context, GLenum unit, GLenum coord, GLenum value);
[[nodiscard]] GLuint bindTextureUnitParameter(Context &context, GLenum unit, GLenum value);
[[nodiscard]] GLuint bindParameter(Context &context, GLenum value);

/// A row of the value that GL has of a bound symbol now, of a matrix that is a variant a column.
/// CURRENT_VERTEX_EXT has none: (0, 0, 0, 1). Outside of Begin and End.
[[nodiscard]] Vec4 boundValue(Context &context, const VertexSymbol &symbol, std::size_t row);

} // namespace arbiter::state
