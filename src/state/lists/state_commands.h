#pragma once
#include <string>

#include <GL/gl.h>

/// Commands that set state between the primitives of a list, and that come by the thousand where
/// programs write each triangle of a model with its own material and texture: kept by the layer,
/// not compiled by the host into a list for each run of them, and left out where they set what the
/// list has set already, so that the primitives around them are one.
namespace arbiter::state {

class Context;

/// While a list is compiled. False: the command is the host's to compile, as it may be an error, or
/// is within something that is the host's.
[[nodiscard]] bool recordMaterial(Context &context, GLenum face, GLenum pname,
                                  const GLfloat *values);
[[nodiscard]] bool recordBindTexture(Context &context, GLenum target, GLuint texture);

/// StateCommands in a row.
void executeStateCommands(Context &context, const std::string &bytes);

} // namespace arbiter::state
