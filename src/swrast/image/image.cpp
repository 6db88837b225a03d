#include "swrast/image/image.h"

#include <algorithm>
#include <cstring>

#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

constexpr int kMaxSize = 16384;
constexpr std::int64_t kCopyBytes = 128 << 10;

void copyBytes(std::uint8_t *to, const std::uint8_t *from, std::size_t bytes) {
  if (std::int64_t(bytes) < kParallelBytes) {
    std::memcpy(to, from, bytes);
    return;
  }
  auto part = [=](std::uint32_t i) {
    const std::size_t at = std::size_t(i) * kCopyBytes;
    std::memcpy(to + at, from + at, std::min(std::size_t(kCopyBytes), bytes - at));
  };
  parallel(std::uint32_t((bytes + kCopyBytes - 1) / kCopyBytes), part);
}

/// Returns the row stride. Long rows span an odd number of cache lines: with a power of two, all
/// pixels of a column would share a few cache sets and evict each other.
std::int64_t strideOf(std::int64_t bytes) {
  constexpr std::int64_t kCacheLine = 64, kLong = 1024;
  const std::int64_t lines = (bytes + kCacheLine - 1) / kCacheLine;
  return kCacheLine * (bytes < kLong ? lines : lines | 1);
}

} // namespace

Image makeImage(const abi::Format &format, int width, int height, int depth, bool topRowFirst) {
  Image image;
  const auto valid = [](int size) { return size >= 1 && size <= kMaxSize; };
  if (format.layout == abi::Layout::None || !valid(width) || !valid(height) || !valid(depth))
    return image;
  const std::int64_t row = strideOf(std::int64_t(width) * abi::bytesOf(format.layout));
  const std::int64_t slice = row * height;
  // The product cannot overflow: at most 2^28 rows of 2^18 bytes. No machine has as much memory.
  std::shared_ptr<Storage> storage = Storage::make(std::uint64_t(slice) * std::uint64_t(depth));
  if (!storage)
    return image;
  image.format = format;
  image.width = width;
  image.height = height;
  image.depth = depth;
  image.rowStride = topRowFirst ? -row : row;
  image.sliceStride = slice;
  image.offset = topRowFirst ? row * (height - 1) : 0;
  image.storage = std::move(storage);
  return image;
}

bool makeWritable(Image &image, bool keepContents) {
  if (image.empty())
    return false;
  if (!image.shared()) {
    image.storage->awaitReader();
    if (!keepContents)
      image.storage->forgetClear();
    return true;
  }
  std::shared_ptr<Storage> storage = Storage::make(image.storage->bytes());
  if (!storage)
    return false;
  if (keepContents) {
    image.complete();
    copyBytes(storage->data(), image.storage->data(), image.storage->bytes());
  }
  image.storage = std::move(storage);
  return true;
}

} // namespace arbiter::swrast
