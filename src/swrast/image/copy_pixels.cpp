#include "swrast/image/copy_pixels.h"

#include <algorithm>
#include <cstring>

#include "swrast/image/pixel_values.h"
#include "swrast/threads.h"

namespace arbiter::swrast {
namespace {

using abi::Layout;

/// Below this, waking a thread costs more than the work.
constexpr std::int64_t kParallelBytes = 512 << 10;
constexpr int kBandRows = 32;

/// Calls `row(y)` for rows 0 to height - 1, on all threads where that pays.
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

/// Four bytes from four: shift[i] is where byte i comes from; what no byte gives is in `ones`.
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
    return; // depth converts to nothing but its own format
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

void fill(Image &image, const Rect &rect, const float rgba[4], unsigned writeMask) {
  const int components = abi::componentsOf(image.format.layout);
  if (rect.empty() || image.empty() || components == 0)
    return;
  const auto pixelBytes = std::size_t(abi::bytesOf(image.format.layout));
  float value[1][4] = {{rgba[0], rgba[1], rgba[2], rgba[3]}};
  constexpr std::size_t kPattern = 256; // a multiple of every pixel's size
  std::uint8_t pattern[kPattern] = {}, mask[kPattern];
  // What the mask keeps shows as bits that differ between two backgrounds.
  std::memset(mask, 0xFF, sizeof mask);
  packPixels(image.format, value, 1, pattern, writeMask);
  packPixels(image.format, value, 1, mask, writeMask);
  bool whole = true;
  for (std::size_t i = 0; i < pixelBytes; ++i) {
    mask[i] = std::uint8_t(~(pattern[i] ^ mask[i]));
    whole = whole && mask[i] == 0xFF;
  }
  for (std::size_t i = pixelBytes; i < kPattern; ++i) {
    pattern[i] = pattern[i - pixelBytes];
    mask[i] = mask[i - pixelBytes];
  }
  const std::size_t bytes = std::size_t(rect.width) * pixelBytes;
  forRows(rect.height, std::int64_t(bytes) * rect.height, [&](int y) {
    std::uint8_t *const row = image.pixel(rect.x, rect.y + y);
    for (std::size_t done = 0; done < bytes; done += kPattern) {
      const std::size_t n = std::min(kPattern, bytes - done);
      if (whole) {
        std::memcpy(row + done, pattern, n);
        continue;
      }
      for (std::size_t i = 0; i < n; ++i)
        row[done + i] = std::uint8_t((row[done + i] & ~mask[i]) | (pattern[i] & mask[i]));
    }
  });
}

void fillDepthStencil(Image &image, const Rect &rect, bool depth, float depthValue,
                      std::uint8_t stencilMask, std::uint8_t stencilValue) {
  if (rect.empty() || image.empty())
    return;
  const double z = depthValue > 0 ? (depthValue < 1 ? double(depthValue) : 1.0) : 0.0;
  const std::int64_t bytes =
      std::int64_t(rect.width) * rect.height * abi::bytesOf(image.format.layout);
  const auto fillRows = [&](auto value, auto mask) {
    using Value = decltype(value);
    forRows(rect.height, bytes, [&](int y) {
      auto *const row = reinterpret_cast<Value *>(image.pixel(rect.x, rect.y + y));
      if (Value(~mask) == 0) {
        std::fill(row, row + rect.width, value);
        return;
      }
      // What is changed is read first: far enough ahead, as these images leave the nearer caches.
      constexpr int kPart = 64 / int(sizeof(Value)), kAhead = 24 * kPart;
      int x = 0;
      for (; x + kPart <= rect.width; x += kPart) {
        __builtin_prefetch(row + x + kAhead, 1, 3);
        for (int i = 0; i < kPart; ++i)
          row[x + i] = Value((row[x + i] & ~mask) | (value & mask));
      }
      for (; x < rect.width; ++x)
        row[x] = Value((row[x] & ~mask) | (value & mask));
    });
  };
  switch (image.format.layout) {
  case Layout::Depth16:
    if (depth)
      fillRows(std::uint16_t(z * 65535.0 + 0.5), std::uint16_t(0xFFFF));
    return;
  case Layout::Depth24Stencil8: {
    const std::uint32_t value = (std::uint32_t(z * 16777215.0 + 0.5) << 8) | stencilValue;
    const std::uint32_t mask = (depth ? 0xFFFFFF00u : 0u) | stencilMask;
    if (mask)
      fillRows(value, mask);
    return;
  }
  case Layout::Depth32:
    if (depth)
      fillRows(std::uint32_t(z * 4294967295.0 + 0.5), 0xFFFFFFFFu);
    return;
  case Layout::Depth32F:
    if (depth) {
      std::uint32_t value = 0;
      const auto f = float(z);
      std::memcpy(&value, &f, 4);
      fillRows(value, 0xFFFFFFFFu);
    }
    return;
  default:
    return;
  }
}

} // namespace arbiter::swrast
