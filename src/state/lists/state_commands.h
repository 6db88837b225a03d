#pragma once
#include <string>

#include <GL/gl.h>

/// Commands that set state between a list's primitives. Programs that give each triangle of a model
/// its own material and texture have thousands. The layer keeps them, so that the host need not
/// compile a list for each run. It leaves out those that change nothing, so that the primitives
/// around them merge.
namespace arbiter::state {

struct RasterContext;

/// Record a command in a list. They return false if the host must compile it: it may be an error,
/// or the layer does not keep state here.
[[nodiscard]] bool recordMaterial(RasterContext &context, GLenum face, GLenum pname,
                                  const GLfloat *values);
[[nodiscard]] bool recordBindTexture(RasterContext &context, GLenum target, GLuint texture);

/// Executes StateCommands in a row.
void executeStateCommands(RasterContext &context, const std::string &bytes);

} // namespace arbiter::state
