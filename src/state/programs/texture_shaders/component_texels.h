#pragma once
#include <vector>

#include <GL/gl.h>

namespace arbiter::state {

class Context;

/// Texels of HILO components and texture offset groups as TexImage's pixels: between the
/// application's memory, or its pixel buffer, and floats. A signed integer's greatest value is 1
/// and its least but one -1, as OpenGL 4.2 has it and not table 2.6: zero is a number of it then.
struct ComponentPixels {
  GLsizei width = 1, height = 1, depth = 1;
  int components = 2;
  GLenum type = GL_FLOAT;
  int dimensions = 2; ///< of the command: SKIP_IMAGES and IMAGE_HEIGHT are three's
};

/// GL_NO_ERROR, or the error of a format and a type that do not go together (table 3.8).
[[nodiscard]] GLenum componentTypeError(GLenum format, GLenum type);

/// Reads them by the context's unpack state. False after an error: the buffer is too small, or
/// mapped. Requires that the type is one that componentTypeError() takes.
[[nodiscard]] bool unpackComponents(Context &context, const ComponentPixels &pixels,
                                    const void *from, std::vector<GLfloat> &to);
/// Writes texels of one of the two packed types, by the context's pack state.
[[nodiscard]] bool packSignedBytes(Context &context, const ComponentPixels &pixels,
                                   const std::vector<GLfloat> &from, void *to);

} // namespace arbiter::state
