#pragma once
#include <optional>

#include <GL/gl.h>

#include "state/imaging/arithmetic.h"
#include "state/imaging/pixels.h"

/// Transfers between the application's memory or pixel buffers, the framebuffer, and RGBA floats.
/// The host converts what is in memory, through a float texture of the layer's and with the
/// application's pixel store. So all of its formats and types work.
namespace arbiter::state {

struct RasterContext;

/// An image in the application's memory.
struct ImageInMemory {
  int dimensions = 2; ///< the command's
  GLsizei width = 0, height = 1, depth = 1;
  GLenum format = GL_RGBA, type = GL_FLOAT;
};

/// True for formats of colours or of indices that become colours. False for depth, stencil and
/// integers.
[[nodiscard]] bool isColorFormat(GLenum format);

/// Reads an image and expands it to RGBA (3.6.4). Raises an error and returns nothing if that
/// fails.
[[nodiscard]] std::optional<imaging::Pixels>
unpackPixels(RasterContext &context, const ImageInMemory &image, const void *pixels);
/// True if the format and the type fit together, as unpackPixels() would find. For images without
/// pixels, or with too many.
[[nodiscard]] bool arePixels(RasterContext &context, GLenum format, GLenum type);
/// Writes components, converted only to the type. Raises an error and returns false if that fails.
/// Luminance is red alone; green and blue must be 0 for it.
[[nodiscard]] bool packPixels(RasterContext &context, const imaging::Pixels &pixels, GLenum format,
                              GLenum type, void *to);
/// Reads the read buffer's colours. Raises an error and returns nothing if that fails.
[[nodiscard]] std::optional<imaging::Pixels>
readFramebuffer(RasterContext &context, GLint x, GLint y, GLsizei width, GLsizei height);
/// Returns the context's scale, bias and maps.
[[nodiscard]] imaging::FirstArithmetic firstArithmetic(const RasterContext &context);

} // namespace arbiter::state
