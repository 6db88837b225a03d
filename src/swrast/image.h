#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "fp_compiler/abi.h"

/// Pixels in memory, shared until somebody writes: what makes a feedback copy free.
namespace arbiter::swrast {

/// A block of memory that images share. 64 bytes before and behind may be read. Freed blocks go to
/// a small pool, so that ping-pong between two buffers allocates nothing.
class Storage {
public:
  /// Null if there is no memory. The bytes are undefined.
  [[nodiscard]] static std::shared_ptr<Storage> make(std::size_t bytes);
  /// Whose memory images use that is none of ours.
  struct Owner {
    void (*release)(void *user); ///< the last image lets go
    /// Whether somebody beside the images has still to read what was written: until then it may not
    /// be written again. \param wait until he has
    bool (*isRead)(void *user, bool wait);
  };
  /// On failure the owner is told at once. 64 bytes before and behind may be read of it too.
  [[nodiscard]] static std::shared_ptr<Storage> wrap(std::uint8_t *data, std::size_t bytes,
                                                     const Owner &owner, void *user);
  ~Storage();
  Storage(const Storage &) = delete;
  Storage &operator=(const Storage &) = delete;
  [[nodiscard]] std::uint8_t *data() const { return m_data; } ///< aligned to 64 bytes
  [[nodiscard]] std::size_t bytes() const { return m_bytes; }
  /// Whether somebody beside the images has still to read it. Ours is read by images alone.
  [[nodiscard]] bool isRead() const { return m_owner && m_owner->isRead(m_user, false); }
  /// Until it may be written again.
  void awaitReader() const {
    if (m_owner)
      (void)m_owner->isRead(m_user, true);
  }
  /// Memory that all storages hold now, pool included.
  [[nodiscard]] static std::size_t totalBytes();

protected:
  Storage(std::uint8_t *data, std::size_t bytes) : m_data(data), m_bytes(bytes) {}

private:
  std::uint8_t *m_data;
  std::size_t m_bytes;
  const Owner *m_owner = nullptr; ///< null: the pool's memory
  void *m_user = nullptr;
};

/// A rectangle of a colour buffer or a level of a texture. A value: copying it shares the pixels.
/// Rows may run up or down in memory.
struct Image {
  abi::Format format;
  std::int32_t width = 0, height = 0, depth = 1; ///< depth: slices of a 3D texture
  std::int64_t rowStride = 0, sliceStride = 0;   ///< bytes; rowStride is negative if top row first
  std::shared_ptr<Storage> storage;
  std::ptrdiff_t offset = 0; ///< of pixel (0, 0, 0), the lower left, in the storage

  [[nodiscard]] bool empty() const { return !storage; }
  [[nodiscard]] std::uint8_t *pixel(int x, int y, int z = 0) const {
    return storage->data() + offset + z * sliceStride + y * rowStride +
           std::ptrdiff_t(x) * abi::bytesOf(format.layout);
  }
  [[nodiscard]] bool shared() const { return storage.use_count() > 1; }
};

/// Rows of 64-byte multiples. Empty if there is no memory, or a size is not in [1, 16384].
[[nodiscard]] Image makeImage(const abi::Format &format, int width, int height, int depth = 1,
                              bool topRowFirst = false);
/// Before a write: a storage of its own that nobody else reads, with the old contents unless they
/// are not needed.
/// False if there is no memory; the image is as it was.
[[nodiscard]] bool makeWritable(Image &image, bool keepContents);

struct Rect {
  std::int32_t x = 0, y = 0, width = 0, height = 0;
  [[nodiscard]] bool empty() const { return width <= 0 || height <= 0; }
  bool operator==(const Rect &) const = default;
};
[[nodiscard]] Rect intersect(const Rect &a, const Rect &b);

/// Copies pixels, converting where formats differ (colour to colour; each component by value).
/// Rectangles are clipped by neither side: the caller has. Source and destination may share storage
/// only if they are the same pixels or do not overlap.
void copyPixels(Image &to, int toX, int toY, int toZ, const Image &from, const Rect &rect,
                int fromZ = 0);
/// Every pixel of `rect` becomes `rgba`, components outside `writeMask` kept. Float targets are not
/// clamped.
void fill(Image &image, const Rect &rect, const float rgba[4], unsigned writeMask = 0xF);
/// The same of a depth or depth-stencil image; false flags leave a part as it is.
void fillDepthStencil(Image &image, const Rect &rect, bool depth, float depthValue,
                      std::uint8_t stencilMask, std::uint8_t stencilValue);

} // namespace arbiter::swrast
