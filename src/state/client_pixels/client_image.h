#pragma once
#include <cstddef>
#include <cstdint>

#include <GL/gl.h>

/// Images in the application's memory or in its pixel buffers: where their pixels lie.
namespace arbiter::state {

class Context;

/// Bytes of one component; 0 for packed types and for what is no type.
[[nodiscard]] std::size_t componentBytes(GLenum type);

enum class PixelStore : std::uint8_t { Pack, Unpack };

/// In pixels. Only those of three dimensions know rows of an image and images that are skipped.
struct ImageSize {
  int dimensions = 2;
  std::size_t width = 0, height = 0, depth = 1;
};

/// In bytes from the image's address: where it begins and ends, and how far its rows and its images
/// are apart. One without pixels ends where it begins.
struct ImageLayout {
  std::size_t first = 0, row = 0, image = 0, end = 0;
};

/// By the host's pixel store (OpenGL 2.1, 3.6.4, Unpacking, and 4.3.2).
/// \param element bytes of a component, or of a pixel of a packed type
[[nodiscard]] ImageLayout layoutOf(const Context &context, PixelStore store, const ImageSize &size,
                                   std::size_t element, std::size_t pixel);

/// A buffer is bound that pixels go to, or come from.
[[nodiscard]] bool hasPixelBuffer(const Context &context, PixelStore store);
/// The bound buffer holds so many bytes from an offset on, and is not mapped; an error else.
[[nodiscard]] bool pixelBufferHolds(Context &context, PixelStore store, std::size_t offset,
                                    std::size_t bytes);

} // namespace arbiter::state
