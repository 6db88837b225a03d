#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "fp_compiler/abi.h"
#include "swrast/image/storage.h"

/// Images: pixels in memory that are shared until one image is written. This makes feedback copies
/// free.
namespace arbiter::swrast {

/// A colour or depth buffer, or a level of a texture. Copying this value shares the pixels. Rows
/// may run up or down in memory.
struct Image {
  abi::Format format;
  std::int32_t width = 0, height = 0, depth = 1; ///< depth: number of slices of a 3D texture
  std::int64_t rowStride = 0, sliceStride = 0;   ///< bytes; rowStride is negative if top row first
  std::shared_ptr<Storage> storage;
  /// bytes from the storage's start to pixel (0, 0, 0), the lower left
  std::ptrdiff_t offset = 0;

  [[nodiscard]] bool empty() const { return !storage; }
  /// Returns a pixel's address, from which all pixels can be read or written.
  [[nodiscard]] std::uint8_t *pixel(int x, int y, int z = 0) const {
    complete();
    return placeOf(x, y, z);
  }
  /// Returns a pixel's address without finishing pending draws and clears. It is for draws, which
  /// are done in order and call DeferredClear::reach().
  [[nodiscard]] std::uint8_t *placeOf(int x, int y, int z = 0) const {
    return storage->data() + offset + z * sliceStride + y * rowStride +
           std::ptrdiff_t(x) * abi::bytesOf(format.layout);
  }
  /// Finishes pending draws and writes what is left of a clear. Call it before several threads use
  /// pixel().
  void complete() const {
    storage->settle();
    if (DeferredClear *const clear = storage->pendingClear())
      clear->complete();
  }
  [[nodiscard]] bool shared() const { return storage.use_count() > 1; }
};

/// Returns an image whose rows are multiples of 64 bytes. It is empty if there is no memory, or if
/// a size is not in [1, 16384].
[[nodiscard]] Image makeImage(const abi::Format &format, int width, int height, int depth = 1,
                              bool topRowFirst = false);
/// Gives the image storage that no other image shares and no reader uses. Call it before pixels are
/// written. The pixels are preserved if `keepContents` is true. Returns false if there is no
/// memory; the image is then unchanged.
[[nodiscard]] bool makeWritable(Image &image, bool keepContents);

} // namespace arbiter::swrast
