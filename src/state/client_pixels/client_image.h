#pragma once
#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

/// Images in the application's memory or in a pixel buffer: the layout of their pixels.
namespace arbiter::state {

struct CoreContext;

/// Returns the bytes of one component; 0 for packed types and for values that are no type.
[[nodiscard]] std::size_t componentBytes(GLenum type);

enum class PixelStore : std::uint8_t { Pack, Unpack };

/// The size of an image in pixels. Only three-dimensional images obey IMAGE_HEIGHT and SKIP_IMAGES.
struct ImageSize {
  int dimensions = 2;
  std::size_t width = 0, height = 0, depth = 1;
};

/// The layout of an image, in bytes from its address: its begin and end, and the strides of its
/// rows and images. An image without pixels ends where it begins.
struct ImageLayout {
  std::size_t first = 0, row = 0, image = 0, end = 0;
};

/// Returns the layout that the host's pixel store gives (OpenGL 2.1, 3.6.4, Unpacking, and 4.3.2).
/// \param element bytes of a component, or of a pixel of a packed type
[[nodiscard]] ImageLayout layoutOf(const CoreContext &context, PixelStore store,
                                   const ImageSize &size, std::size_t element, std::size_t pixel);

/// True if a pixel buffer is bound for this direction.
[[nodiscard]] bool hasPixelBuffer(const CoreContext &context, PixelStore store);
/// True if the bound buffer holds `bytes` from `offset` on and is not mapped. Raises an error if
/// not.
[[nodiscard]] bool pixelBufferHolds(CoreContext &context, PixelStore store, std::size_t offset,
                                    std::size_t bytes);

} // namespace arbiter::state
