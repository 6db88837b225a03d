#pragma once
#include <vector>

#include <GL/gl.h>

namespace arbiter::state {

struct ProgramContext;

/// Pixels of HILO components and texture offset groups, as passed to TexImage. They are converted
/// between the application's memory, or its pixel buffer, and floats. A signed integer's largest
/// value is 1, and the second smallest is -1. This is the rule of OpenGL 4.2 and not that of table
/// 2.6, so that zero can be represented.
struct ComponentPixels {
  GLsizei width = 1, height = 1, depth = 1;
  int components = 2;
  GLenum type = GL_FLOAT;
  /// dimensions of the command; SKIP_IMAGES and IMAGE_HEIGHT only apply to three
  int dimensions = 2;
};

/// Returns GL_NO_ERROR, or the error for a format and type that do not match (table 3.8).
[[nodiscard]] GLenum componentTypeError(GLenum format, GLenum type);

/// Reads pixels by the context's unpack state. Returns false after an error: the buffer is too
/// small, or mapped. Requires that componentTypeError() accepts the type.
[[nodiscard]] bool unpackComponents(ProgramContext &context, const ComponentPixels &pixels,
                                    const void *from, std::vector<GLfloat> &to);
/// Writes pixels of an integer type by the context's pack state, and by the rule above: a host may
/// have table 4.9's, by which -128 comes back for -127. Returns false after an error, as above.
[[nodiscard]] bool packComponents(ProgramContext &context, const ComponentPixels &pixels,
                                  const std::vector<GLfloat> &from, void *to);
/// Returns whether packComponents() writes such a type: all but floats, which need no conversion.
[[nodiscard]] bool isPackedHere(GLenum type);

} // namespace arbiter::state
