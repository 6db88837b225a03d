#include "swrast/image/copy_pixels.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "swrast/image/pixel_values.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

using abi::Layout;

constexpr int kBandRows = 32;
/// Clears of fewer bytes are written at once.
constexpr std::int64_t kDeferredBytes = 8 << 10;

/// Calls `row(y)` for rows 0 to height - 1, on all threads if there is enough work.
template <typename Row> void forRows(int height, std::int64_t bytes, const Row &row) {
  auto band = [&](std::uint32_t i) {
    const int end = std::min(height, int(i + 1) * kBandRows);
    for (int y = int(i) * kBandRows; y < end; ++y)
      row(y);
  };
  const auto bands = std::uint32_t((height + kBandRows - 1) / kBandRows);
  if (bytes >= kParallelBytes)
    parallel(bands, band);
  else
    for (std::uint32_t i = 0; i < bands; ++i)
      band(i);
}

/// A permutation of a pixel's four bytes. shift[i] selects the source of byte i; bytes without a
/// source are set from `ones`.
struct BytePermutation {
  unsigned shift[4] = {};
  std::uint32_t keep[4] = {};
  std::uint32_t ones = 0;
};

BytePermutation permutationOf(const abi::Format &to, const abi::Format &from) {
  BytePermutation result;
  for (int stored = 0; stored < 4; ++stored) {
    const int component = sourceOf(to.swizzle, stored);
    const abi::From source = component < 4 ? from.swizzle[std::size_t(component)] : abi::From::One;
    if (int(source) < 4) {
      result.shift[stored] = 8u * unsigned(source);
      result.keep[stored] = 0xFFu << (8 * stored);
    } else if (source == abi::From::One) {
      result.ones |= 0xFFu << (8 * stored);
    }
  }
  return result;
}

void permute(const BytePermutation &p, std::uint8_t *to, const std::uint8_t *from, int count) {
  for (int i = 0; i < count; ++i) {
    std::uint32_t in = 0;
    std::memcpy(&in, from + 4 * std::ptrdiff_t(i), 4);
    const std::uint32_t out = (((in >> p.shift[0]) << 0) & p.keep[0]) |
                              (((in >> p.shift[1]) << 8) & p.keep[1]) |
                              (((in >> p.shift[2]) << 16) & p.keep[2]) |
                              (((in >> p.shift[3]) << 24) & p.keep[3]) | p.ones;
    std::memcpy(to + 4 * std::ptrdiff_t(i), &out, 4);
  }
}

void convert(const abi::Format &toFormat, std::uint8_t *to, const abi::Format &fromFormat,
             const std::uint8_t *from, int count) {
  constexpr int kChunk = 64;
  float rgba[kChunk][4];
  for (int done = 0; done < count; done += kChunk) {
    const int n = std::min(kChunk, count - done);
    unpackPixels(fromFormat, from, n, rgba);
    packPixels(toFormat, rgba, n, to);
    from += std::ptrdiff_t(n) * abi::bytesOf(fromFormat.layout);
    to += std::ptrdiff_t(n) * abi::bytesOf(toFormat.layout);
  }
}

} // namespace

void copyPixels(Image &to, int toX, int toY, int toZ, const Image &from, const Rect &rect,
                int fromZ) {
  if (rect.empty() || to.empty() || from.empty())
    return;
  to.complete();
  from.complete();
  const std::int64_t bytes = std::int64_t(rect.width) * abi::bytesOf(to.format.layout);
  const auto each = [&](auto copyRow) {
    forRows(rect.height, bytes * rect.height, [&](int y) {
      copyRow(to.pixel(toX, toY + y, toZ), from.pixel(rect.x, rect.y + y, fromZ));
    });
  };
  if (to.format == from.format) {
    each([&](std::uint8_t *out, const std::uint8_t *in) {
      if (out != in)
        std::memcpy(out, in, std::size_t(bytes));
    });
    return;
  }
  if (abi::componentsOf(to.format.layout) == 0 || abi::componentsOf(from.format.layout) == 0)
    return; // depth converts only to its own format
  if (to.format.layout == Layout::U8x4 && from.format.layout == Layout::U8x4) {
    const BytePermutation permutation = permutationOf(to.format, from.format);
    each([&](std::uint8_t *out, const std::uint8_t *in) {
      permute(permutation, out, in, rect.width);
    });
    return;
  }
  each([&](std::uint8_t *out, const std::uint8_t *in) {
    convert(to.format, out, from.format, in, rect.width);
  });
}

namespace {

/// Clears with the pattern: a large image when its pixels are needed, anything else now.
void clearPixels(Image &image, const Rect &rect, const ClearPattern &pattern) {
  image.storage->settle();
  const ClearedPixels pixels = {image.placeOf(0, 0), image.rowStride, image.width, image.height,
                                abi::bytesOf(image.format.layout)};
  const Rect area = intersect(rect, {0, 0, image.width, image.height});
  const std::int64_t bytes = std::int64_t(area.width) * area.height * pixels.pixelBytes;
  const bool isWhole = area.width == image.width && area.height == image.height;
  if (isWhole && image.depth == 1 && bytes >= kDeferredBytes &&
      image.storage->deferClear(pixels, pattern))
    return;
  if (DeferredClear *const before = image.storage->pendingClear())
    before->reach(area);
  forRows(area.height, bytes, [&](int y) {
    writePattern(pixels, pattern, {area.x, area.y + y, area.width, 1});
  });
}

} // namespace

void fill(Image &image, const Rect &rect, const float rgba[4], unsigned writeMask) {
  const int components = abi::componentsOf(image.format.layout);
  if (rect.empty() || image.empty() || components == 0)
    return;
  const auto pixelBytes = std::size_t(abi::bytesOf(image.format.layout));
  float value[1][4] = {{rgba[0], rgba[1], rgba[2], rgba[3]}};
  // Packing over two different backgrounds shows which bits the mask keeps: they differ.
  ClearPattern pattern;
  std::memset(pattern.mask, 0xFF, sizeof pattern.mask);
  packPixels(image.format, value, 1, pattern.value, writeMask);
  packPixels(image.format, value, 1, pattern.mask, writeMask);
  for (std::size_t i = 0; i < pixelBytes; ++i)
    pattern.mask[i] = std::uint8_t(~(pattern.value[i] ^ pattern.mask[i]));
  for (std::size_t i = pixelBytes; i < sizeof pattern.value; ++i) {
    pattern.value[i] = pattern.value[i - pixelBytes];
    pattern.mask[i] = pattern.mask[i - pixelBytes];
  }
  clearPixels(image, rect, pattern);
}

void fillDepthStencil(Image &image, const Rect &rect, bool depth, double depthValue,
                      std::uint8_t stencilMask, std::uint8_t stencilValue) {
  if (rect.empty() || image.empty())
    return;
  const double z = depthValue > 0 ? std::min(depthValue, 1.0) : 0.0;
  const bool isWhole = rect.x <= 0 && rect.y <= 0 &&
                       std::int64_t(rect.x) + rect.width >= image.width &&
                       std::int64_t(rect.y) + rect.height >= image.height;
  const auto stepsOf = [&](float most) {
    return std::uint32_t(isWhole ? std::lrint(z * double(most)) : std::lrint(float(z) * most));
  };
  const auto clear = [&](auto value, auto mask) {
    if (mask == 0)
      return;
    ClearPattern pattern;
    for (std::size_t at = 0; at < sizeof pattern.value; at += sizeof value) {
      std::memcpy(pattern.value + at, &value, sizeof value);
      std::memcpy(pattern.mask + at, &mask, sizeof mask);
    }
    clearPixels(image, rect, pattern);
  };
  const std::uint32_t all = depth ? 0xFFFFFFFFu : 0;
  switch (image.format.layout) {
  case Layout::Depth16:
    return clear(std::uint16_t(stepsOf(65535.0f)), std::uint16_t(all));
  case Layout::Depth24Stencil8:
    return clear((stepsOf(16777215.0f) << 8) | stencilValue, (all & 0xFFFFFF00u) | stencilMask);
  case Layout::Depth32:
    return clear(isWhole ? std::uint32_t(std::llrint(z * 4294967295.0)) : abi::depth32Of(float(z)),
                 all);
  case Layout::Depth32F:
    return clear(float(z), all);
  default:
    return;
  }
}

} // namespace arbiter::swrast
