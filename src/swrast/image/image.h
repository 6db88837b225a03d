#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include "fp_compiler/abi.h"
#include "swrast/image/storage.h"

/// Pixels in memory, shared until one of the images is written: what makes a feedback copy free.
namespace arbiter::swrast {

/// A rectangle of a colour buffer or a level of a texture. A value: copying it shares the pixels.
/// Rows may run up or down in memory.
struct Image {
  abi::Format format;
  std::int32_t width = 0, height = 0, depth = 1; ///< depth: slices of a 3D texture
  std::int64_t rowStride = 0, sliceStride = 0;   ///< bytes; rowStride is negative if top row first
  std::shared_ptr<Storage> storage;
  std::ptrdiff_t offset = 0; ///< of pixel (0, 0, 0), the lower left, in the storage

  [[nodiscard]] bool empty() const { return !storage; }
  /// A pixel's place, to read or write any of them.
  [[nodiscard]] std::uint8_t *pixel(int x, int y, int z = 0) const {
    complete();
    return placeOf(x, y, z);
  }
  /// The same while draws and a clear may be pending: for draws, which come after those that wait
  /// and call DeferredClear::reach().
  [[nodiscard]] std::uint8_t *placeOf(int x, int y, int z = 0) const {
    return storage->data() + offset + z * sliceStride + y * rowStride +
           std::ptrdiff_t(x) * abi::bytesOf(format.layout);
  }
  /// Draws that wait are done, and what is left of a clear is written. To be called before threads
  /// use pixel().
  void complete() const {
    storage->settle();
    if (DeferredClear *const clear = storage->pendingClear())
      clear->complete();
  }
  [[nodiscard]] bool shared() const { return storage.use_count() > 1; }
};

/// Rows of 64-byte multiples. Empty if there is no memory, or a size is not in [1, 16384].
[[nodiscard]] Image makeImage(const abi::Format &format, int width, int height, int depth = 1,
                              bool topRowFirst = false);
/// To be called before pixels are written: the image then has storage that no other image shares
/// and no reader uses, with the old pixels if `keepContents`. False if there is no memory; the
/// image is as it was.
[[nodiscard]] bool makeWritable(Image &image, bool keepContents);

} // namespace arbiter::swrast
