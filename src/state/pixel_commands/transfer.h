#pragma once
#include <optional>

#include <GL/gl.h>

#include "state/imaging/arithmetic.h"
#include "state/imaging/pixels.h"

/// Pixels between the application's memory, or its pixel buffers, the framebuffer and RGBA floats.
/// What lies in memory is converted by the host, through a texture of floats of the layer's own,
/// with the application's pixel store: every format and type that the host has.
namespace arbiter::state {

class Context;

/// An image in the application's memory.
struct ImageInMemory {
  int dimensions = 2; ///< of the command
  GLsizei width = 0, height = 1, depth = 1;
  GLenum format = GL_RGBA, type = GL_FLOAT;
};

/// Colours, or indices that become colours, and nothing of depth, stencil or whole numbers.
[[nodiscard]] bool isColorFormat(GLenum format);

/// Up to the final expansion to RGBA (3.6.4). Empty after an error, which is raised.
[[nodiscard]] std::optional<imaging::Pixels>
unpackPixels(Context &context, const ImageInMemory &image, const void *pixels);
/// That a format and a type go together, as unpackPixels() would find: of images that have no
/// pixels, or too many.
[[nodiscard]] bool arePixels(Context &context, GLenum format, GLenum type);
/// Components as they are, without another conversion than to the type. False after an error, which
/// is raised. Luminance is red: green and blue are 0 where it is asked for.
[[nodiscard]] bool packPixels(Context &context, const imaging::Pixels &pixels, GLenum format,
                              GLenum type, void *to);
/// The read buffer's colours; empty after an error, which is raised.
[[nodiscard]] std::optional<imaging::Pixels> readFramebuffer(Context &context, GLint x, GLint y,
                                                             GLsizei width, GLsizei height);
/// The context's scale, bias and maps.
[[nodiscard]] imaging::FirstArithmetic firstArithmetic(const Context &context);

} // namespace arbiter::state
