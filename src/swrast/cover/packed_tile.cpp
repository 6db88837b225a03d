#include <algorithm>
#include <cmath>
#include <cstring>

#include "swrast/cover/columns.h"
#include "swrast/cover/packed.h"
#include "util/processor.h"

/// The tile's copy of the depth buffer, and the kernels for any processor.
namespace arbiter::swrast {

void PackedTile::begin(const Rect &tile, const Shading &shading, int planesFrom) {
  std::fill(std::begin(loaded), std::end(loaded), std::uint16_t(0));
  rect = tile;
  originY = planesFrom;
  target = shading.data->depthStencil;
  test = shading.depth;
  minimum = shading.data->depthMinimum;
  maximum = shading.data->depthMaximum;
  if (test.layout == abi::Layout::None)
    return;
  const int left = tile.x & -kSide, bottom = (tile.y & -kSide) - originY;
  for (int block = 0; block < kSide / 4; ++block)
    for (int lane = 0; lane < kLanes; ++lane) {
      const int row = lane / 4;
      xOf[block][lane] = float(left + 4 * block + lane % 4);
      yOf[block][lane] = float(bottom + 4 * block + row);
    }
  // A window's rows are often whole pages apart, and hardware prefetchers do not cross pages.
  constexpr int kLine = 64;
  const int bytes = rect.width * abi::bytesOf(test.layout);
  const std::uint8_t *row =
      target.base + rect.y * target.rowStride + rect.x * abi::bytesOf(test.layout);
  for (int y = 0; y < rect.height; ++y, row += target.rowStride)
    for (int at = 0; at < bytes; at += kLine)
      __builtin_prefetch(row + at, 1, 2);
}

/// Calls `visit(lane, address)` for each pixel of the block that lies in the tile.
template <typename Visit> void PackedTile::eachPixel(int x, int y, Visit visit) const {
  const int bytes = abi::bytesOf(test.layout);
  for (int lane = 0; lane < kLanes; ++lane) {
    const int px = x + lane % 4, py = y + lane / 4;
    if (px >= rect.x && px < rect.x + rect.width && py >= rect.y && py < rect.y + rect.height)
      visit(lane, target.base + py * target.rowStride + px * bytes);
  }
}

namespace {
bool contains(const Rect &rect, int x, int y) {
  return x >= rect.x && y >= rect.y && x + 4 <= rect.x + rect.width &&
         y + 4 <= rect.y + rect.height;
}
} // namespace

void PackedTile::load(int x, int y) {
  const unsigned at = blockAt(x, y);
  loaded[at >> 4] |= std::uint16_t(1u << (at & 15));
  std::memset(owner[at], 0, sizeof owner[at]);
  if (test.layout == abi::Layout::None)
    return;
  if (abi::bytesOf(test.layout) == 4 && contains(rect, x, y)) {
    const std::uint8_t *row = target.base + y * target.rowStride + x * 4;
    for (int i = 0; i < 4; ++i, row += target.rowStride)
      std::memcpy(&depth[at][4 * i], row, 16);
    return;
  }
  std::memset(depth[at], 0, sizeof depth[at]);
  const auto bytes = std::size_t(abi::bytesOf(test.layout));
  eachPixel(x, y, [&](int lane, const std::uint8_t *from) {
    std::memcpy(&depth[at][lane], from, bytes); // little endian: a short depth fills the lower half
  });
}

void PackedTile::end() {
  for (int row = 0; row < 16; ++row) {
    const unsigned columns = loaded[row];
    loaded[row] = 0;
    if (test.layout == abi::Layout::None || !test.write)
      continue;
    const int y = (rect.y & -kSide) + 4 * row;
    for (unsigned rest = columns; rest != 0; rest &= rest - 1) {
      const int x = (rect.x & -kSide) + 4 * __builtin_ctz(rest);
      const std::int32_t *const from = depth[blockAt(x, y)];
      if (abi::bytesOf(test.layout) == 4 && contains(rect, x, y)) {
        std::uint8_t *to = target.base + y * target.rowStride + x * 4;
        for (int i = 0; i < 4; ++i, to += target.rowStride)
          std::memcpy(to, from + 4 * i, 16);
        continue;
      }
      const auto bytes = std::size_t(abi::bytesOf(test.layout));
      eachPixel(x, y, [&](int lane, std::uint8_t *to) { std::memcpy(to, from + lane, bytes); });
    }
  }
}

namespace {

template <typename Number> bool passes(abi::Compare compare, Number incoming, Number stored) {
  switch (compare) {
  case abi::Compare::Never:
    return false;
  case abi::Compare::Less:
    return incoming < stored;
  case abi::Compare::Equal:
    return incoming == stored;
  case abi::Compare::LessEqual:
    return incoming <= stored;
  case abi::Compare::Greater:
    return incoming > stored;
  case abi::Compare::NotEqual:
    return incoming != stored;
  case abi::Compare::GreaterEqual:
    return incoming >= stored;
  case abi::Compare::Always:
    return true;
  }
  return false;
}

/// Tests one pixel's depth against the buffer's, and replaces `pixel` if it passes.
bool testPixel(const PackedTile &tile, float depth, std::int32_t &pixel) {
  // Written so that NaN becomes the minimum.
  depth = depth > tile.minimum ? depth : tile.minimum;
  depth = depth < tile.maximum ? depth : tile.maximum;
  const abi::Compare compare = tile.test.compare;
  std::int32_t made = 0;
  bool pass = true;
  if (tile.test.layout == abi::Layout::Depth32F) {
    float stored = 0;
    std::memcpy(&stored, &pixel, sizeof stored);
    std::memcpy(&made, &depth, sizeof made);
    pass = passes(compare, depth, stored);
  } else if (tile.test.layout == abi::Layout::Depth16) {
    made = std::int32_t(std::lrintf(depth * 65535.0f));
    pass = passes(compare, made, pixel);
  } else if (tile.test.layout == abi::Layout::Depth32) {
    const std::uint32_t mine = abi::depth32Of(depth);
    made = std::int32_t(mine);
    pass = passes(compare, mine, std::uint32_t(pixel));
  } else {
    const auto incoming = std::int32_t(std::lrintf(depth * 16777215.0f));
    made = std::int32_t(std::uint32_t(incoming) << 8 | (std::uint32_t(pixel) & 255));
    pass = passes(compare, incoming, std::int32_t(std::uint32_t(pixel) >> 8));
  }
  if (pass && tile.test.write)
    pixel = made;
  return pass;
}

std::uint32_t testBlocks(PackedTile &tile, const abi::DepthPlane &z, std::uint32_t owner,
                         const abi::Block *blocks, std::uint32_t count, abi::Block *out) {
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block block = blocks[i];
    const unsigned at = PackedTile::blockAt(block.x, block.y);
    if ((tile.loaded[at >> 4] >> (at & 15) & 1) == 0)
      tile.load(block.x, block.y);
    unsigned mask = 0;
    for (unsigned rest = block.mask; rest != 0; rest &= rest - 1) {
      const int lane = __builtin_ctz(rest);
      const float depth = abi::depthAt(z, block.x + lane % 4, block.y + lane / 4 - tile.originY);
      if (tile.test.layout != abi::Layout::None && !testPixel(tile, depth, tile.depth[at][lane]))
        continue;
      tile.owner[at][lane] = owner;
      mask |= 1u << lane;
    }
    out[left] = {block.x, block.y, std::uint16_t(mask), 0};
    left += mask != 0 ? 1 : 0;
  }
  return left;
}

std::uint32_t listPixels(const PackedTile &tile, std::uint32_t owner, unsigned column, bool quads,
                         const abi::Block *blocks, std::uint32_t count, abi::Pixel *out) {
  std::uint32_t total = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block &block = blocks[i];
    const std::uint32_t *const owners = tile.owner[PackedTile::blockAt(block.x, block.y)];
    const auto isSeen = [&](int lane) {
      return owner != 0 ? owners[lane] == owner : (block.mask >> lane & 1) != 0;
    };
    for (int k = 0; k < PackedTile::kLanes; ++k) {
      const int inQuad = (k / 8 * 2 + k % 4 / 2) * 4 + k / 4 % 2 * 2 + k % 2;
      const int lane = quads ? inQuad : k;
      const int first = lane / 8 * 8 + lane % 4 / 2 * 2; // first lane of this lane's quad
      const bool seen = isSeen(lane);
      if (!seen && !(quads && (isSeen(first) || isSeen(first + 1) || isSeen(first + 4) ||
                               isSeen(first + 5))))
        continue;
      constexpr int kIn = PackedTile::kSide - 1;
      out[total++] = {std::uint8_t((block.x & kIn) + lane % 4),
                      std::uint8_t((block.y & kIn) + lane / 4), std::uint8_t(column),
                      std::uint8_t(seen ? 0 : abi::Pixel::kHelper)};
    }
  }
  return total;
}

} // namespace

const PackedKernels kPackedBaseline = {[](const DepthTest &) { return &testBlocks; }, listPixels,
                                       setColumns};

const PackedKernels &choosePackedKernels() {
#if defined(__x86_64__) || defined(__i386__)
  if (vectors() == Vectors::Avx512)
    return kPackedAvx512;
  if (vectors() == Vectors::Avx2)
    return kPackedAvx2;
#endif
  return kPackedBaseline;
}

} // namespace arbiter::swrast
