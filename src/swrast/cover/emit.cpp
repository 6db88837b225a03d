#include "swrast/cover/emit.h"

#include <cmath>

namespace arbiter::swrast {
namespace {

/// Shapes at least this many vectors wide are shaded by rows if there is a choice. In narrower
/// ones, the ends of rows leave most lanes empty.
constexpr int kRowVectors = 2;
/// A shape is packed by the pixel if its blocks in a tile have on average no more covered pixels
/// than this, of 16. A block costs less than a packed vector, but packed vectors are full.
constexpr std::uint32_t kMaxPacked = 8;

/// Counts the bits set in the low 16, without the instruction that some supported processors lack.
unsigned coveredPixels(unsigned mask) {
  mask -= (mask >> 1) & 0x5555u;
  mask = (mask & 0x3333u) + ((mask >> 2) & 0x3333u);
  mask = (mask + (mask >> 4)) & 0x0F0Fu;
  return (mask + (mask >> 8)) & 0x1Fu;
}

/// Estimates, from area and perimeter, whether the triangle covers most pixels of the 4x4 blocks
/// that it touches. These blocks have about as many pixels as its area, plus two for each column or
/// row that the perimeter crosses.
bool fillsBlocks(const Shape &shape) {
  if (shape.edgeCount != 3)
    return false;
  const Edge *const edges = shape.edges;
  const double twiceArea =
      std::abs(double(edges[0].a) * edges[1].b - double(edges[1].a) * edges[0].b);
  double around = 0;
  for (int i = 0; i < 3; ++i)
    around += std::abs(double(edges[i].a)) + std::abs(double(edges[i].b));
  return twiceArea > 4.0 * kSubpixels * around;
}

std::int64_t floorDivide(std::int64_t value, std::int64_t divisor) {
  const std::int64_t quotient = value / divisor;
  return quotient - (value % divisor < 0 ? 1 : 0);
}

} // namespace

RowWalker::RowWalker(const Shape &shape, int left, int bottom, int right, int top)
    : m_left(left), m_right(right) {
  for (int i = 0; i < shape.edgeCount; ++i) {
    const Edge &edge = shape.edges[i];
    const std::int64_t value = std::int64_t(edge.b) * bottom + edge.c;
    if (EdgeOver(edge, {left, bottom, right - left, top - bottom}).all)
      continue;
    if (edge.a == 0) {
      m_level[m_levels++] = {value, edge.b};
      continue;
    }
    // For a left edge, the first x with a * x >= -value. For a right edge, the first x beyond the
    // shape.
    const std::int64_t divisor = edge.a > 0 ? edge.a : -std::int64_t(edge.a);
    const std::int64_t numerator = edge.a > 0 ? divisor - 1 - value : divisor + value;
    const std::int64_t step = edge.a > 0 ? -std::int64_t(edge.b) : edge.b;
    Walk &walk = edge.a > 0 ? m_walk[m_lefts++] : m_walk[3 - m_rights++];
    walk.divisor = divisor;
    walk.quotient = floorDivide(numerator, divisor);
    walk.remainder = numerator - walk.quotient * divisor;
    walk.quotientStep = floorDivide(step, divisor);
    walk.remainderStep = step - walk.quotientStep * divisor;
  }
}

/// Steps one edge at a time, so that its state stays in registers.
template <typename Put> void RowWalker::follow(Walk &walk, int count, Put put) const {
  const Walk by = walk;
  const std::int64_t low = m_left, high = m_right;
  std::int64_t quotient = by.quotient, remainder = by.remainder;
  for (int row = 0; row < count; ++row) {
    put(row, int(std::clamp(quotient, low, high)));
    remainder += by.remainderStep;
    const bool carry = remainder >= by.divisor;
    quotient += by.quotientStep + (carry ? 1 : 0);
    remainder -= carry ? by.divisor : 0;
  }
  walk.quotient = quotient;
  walk.remainder = remainder;
}

void RowWalker::next(int *begin, int *end, int count) {
  std::fill_n(begin, count, m_left);
  std::fill_n(end, count, m_right);
  for (int i = 0; i < m_lefts; ++i)
    follow(m_walk[i], count,
           [&](int row, int column) { begin[row] = std::max(begin[row], column); });
  for (int i = 0; i < m_rights; ++i)
    follow(m_walk[3 - i], count,
           [&](int row, int column) { end[row] = std::min(end[row], column); });
  for (int i = 0; i < m_levels; ++i)
    for (int row = 0; row < count; ++row) {
      if (m_level[i].value < 0)
        end[row] = begin[row];
      m_level[i].value += m_level[i].step;
    }
}

void Emitter::flush() {
  if (m_count != 0)
    (m_isRow ? m_shading.row : m_shading.quad)(m_shading.data, m_primitive, m_spans, m_count);
  m_count = 0;
}

bool Emitter::wantsRows(int width) const {
  if (!m_shading.row || !m_shading.quad)
    return m_shading.row != nullptr;
  return width >= kRowVectors * m_shading.lanes;
}

bool Emitter::wantsRowsOfSmall(int width) const {
  constexpr int kLeastLanes = 8; // blocks of 2x2 would be too many
  return m_shading.lanes < kLeastLanes ? wantsRows(width) : m_shading.quad == nullptr;
}

void Emitter::shade(const Shape &shape, int left, int bottom, int right, int top) {
  left = std::max(left, shape.left);
  right = std::min(right, shape.right);
  bottom = std::max(bottom, shape.bottom);
  top = std::min(top, shape.top);
  if (left >= right || bottom >= top)
    return;
  flush();
  m_packed.finish();
  m_primitive = &shape.primitive;
  m_stippled = shape.stippled;
  m_isRow = wantsRows(shape.right - shape.left);
  if (m_isRow)
    rows(shape, left, bottom, right, top);
  else
    blocks(shape, left, bottom, right, top);
  flush();
}

template <typename MaskOf> void Emitter::filterBlocks(MaskOf maskOf, BlockSize size) {
  const std::uint32_t count = m_count;
  m_count = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block item = m_blocks[i];
    m_pixels -= coveredPixels(item.mask);
    block(item.x, item.y, maskOf(item), size);
  }
}

void Emitter::shadeInTile(const Shape &shape, const Rect &rect) {
  if (m_packs && shape.edgeCount != 0 && fitsRegions(shape)) {
    const Rect own = {shape.left, shape.bottom, shape.right - shape.left, shape.top - shape.bottom};
    const Rect part = intersect(own, rect);
    if (part.empty() || pack(shape, part))
      return;
  }
  shade(shape, rect.x, rect.y, rect.x + rect.width, rect.y + rect.height);
}

bool Emitter::pack(const Shape &shape, const Rect &part) {
  Region region;
  if (!regionOf(shape, part, region))
    return true;
  if (region.count == 0 && std::min(part.width, part.height) >= 2 * kPackedBlock.width)
    return false; // a rectangle fills most of its blocks
  const bool isWide = wantsRows(shape.right - shape.left);
  if (isWide && fillsBlocks(shape))
    return false;
  const Cover cover = m_cover.region(region, kPackedBlock.lanes(), m_blocks);
  const bool isThin = cover.pixels <= kMaxPacked * cover.blocks;
  const bool alike = m_blockSize.lanes() == kPackedBlock.lanes();
  if (!isThin && (!alike || isWide))
    return false;
  takeBlocks(shape, cover, kPackedBlock);
  if (isThin) {
    m_packed.add(shape, m_blocks, m_count);
    m_count = 0;
    return true;
  }
  m_packed.finish();
  m_primitive = &shape.primitive;
  m_isRow = false;
  flush();
  return true;
}

void Emitter::takeBlocks(const Shape &shape, const Cover &cover, BlockSize size) {
  m_count = cover.blocks;
  m_pixels += cover.pixels;
  m_stippled = shape.stippled;
  if (m_stippled)
    filterBlocks([](const abi::Block &block) { return unsigned(block.mask); }, size);
}

void Emitter::shadeSmall(const PlanePlan &plan, const WindowVertex *window,
                         const SmallTriangle &small, const Rect &rect) {
  const Rect part = intersect(
      {small.left, small.bottom, small.right - small.left, small.top - small.bottom}, rect);
  if (part.empty())
    return;
  m_primitive = &m_small;
  m_stippled = m_state.polygonStipple != nullptr;
  m_isRow = !m_packs && wantsRowsOfSmall(part.width);
  const auto planes = [&] {
    m_small.z = small.depthPlane();
    makePlanes(m_state, plan, small, window, m_small);
  };
  if (m_isRow) {
    const Triangle triangle = triangleOf(small, window);
    planes();
    Shape shape;
    (void)shapeOf(rect, triangle.corner, areaOf(triangle.corner), shape);
    rows(shape, shape.left, shape.bottom, shape.right, shape.top);
    flush();
    return;
  }
  const BlockSize size = m_packs ? kPackedBlock : m_blockSize;
  const Cover cover = m_cover.small(small, part, size.lanes(), m_blocks);
  m_count = cover.blocks;
  m_pixels += cover.pixels;
  keepInside(rect, part, size);
  if (m_count == 0)
    return;
  if (m_packs) {
    m_packed.add(plan, window, small, m_blocks, m_count);
    m_count = 0;
    return;
  }
  planes();
  flush();
}

void Emitter::keepInside(const Rect &rect, const Rect &part, BlockSize size) {
  // If all sides lie on block boundaries, no block is cut.
  constexpr int kWithin = 3;
  if (((rect.x | rect.y | rect.width | rect.height) & kWithin) == 0 && !m_stippled)
    return;
  const int right = rect.x + rect.width, top = rect.y + rect.height;
  const bool crosses = (part.x & -size.width) < rect.x || (part.y & -size.height) < rect.y ||
                       ((part.x + part.width + size.width - 1) & -size.width) > right ||
                       ((part.y + part.height + size.height - 1) & -size.height) > top;
  if (crosses || m_stippled)
    filterBlocks(
        [&](const abi::Block &item) {
          return crosses ? item.mask & insideMask(rect, item.x, item.y, size) : item.mask;
        },
        size);
}

unsigned Emitter::insideMask(const Rect &rect, int x, int y, BlockSize size) {
  unsigned mask = 0;
  for (int i = 0; i < size.lanes(); ++i) {
    const int px = x + i % size.width, py = y + i / size.width;
    if (px >= rect.x && px < rect.x + rect.width && py >= rect.y && py < rect.y + rect.height)
      mask |= 1u << i;
  }
  return mask;
}

void Emitter::span(int x, int y, int end) {
  if (m_count == kBatch)
    flush();
  m_spans[m_count++] = {std::int16_t(x), std::int16_t(y), std::uint16_t(end - x), 0};
  m_pixels += unsigned(end - x);
}

void Emitter::stippledSpan(int x, int y, int end) {
  // The pattern's rows start at the bottom, and a byte's highest bit is its leftmost pixel.
  const std::uint8_t *const row = m_state.polygonStipple + std::ptrdiff_t(4) * (y & 31);
  const auto isSet = [row](int at) { return ((row[(at & 31) >> 3] >> (7 - (at & 7))) & 1) != 0; };
  while (x < end) {
    while (x < end && !isSet(x))
      ++x;
    const int start = x;
    while (x < end && isSet(x))
      ++x;
    if (start < x)
      span(start, y, x);
  }
}

void Emitter::rows(const Shape &shape, int left, int bottom, int right, int top) {
  RowWalker walker(shape, left, bottom, right, top);
  int begin[RowWalker::kRows], end[RowWalker::kRows];
  for (int y = bottom; y < top; y += RowWalker::kRows) {
    const int count = std::min(RowWalker::kRows, top - y);
    walker.next(begin, end, count);
    for (int row = 0; row < count; ++row) {
      if (begin[row] >= end[row])
        continue;
      if (m_stippled)
        stippledSpan(begin[row], y + row, end[row]);
      else
        span(begin[row], y + row, end[row]);
    }
  }
}

void Emitter::block(int x, int y, unsigned mask, BlockSize size) {
  if (m_stippled) {
    for (int i = 0; i < size.lanes(); ++i) {
      const int px = x + i % size.width, py = y + i / size.width;
      const std::uint8_t byte = m_state.polygonStipple[4 * (py & 31) + ((px & 31) >> 3)];
      if (((byte >> (7 - (px & 7))) & 1) == 0)
        mask &= ~(1u << i);
    }
  }
  if (mask == 0)
    return;
  if (m_count == kBatch)
    flush();
  m_blocks[m_count++] = {std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0};
  m_pixels += coveredPixels(mask);
}

void Emitter::blocks(const Shape &shape, int left, int bottom, int right, int top) {
  const bool fits = fitsRegions(shape);
  constexpr int kSide = Region::kSide;
  for (int y = bottom & -kSide; y < top; y += kSide)
    for (int x = left & -kSide; x < right; x += kSide) {
      const Rect part = intersect({left, bottom, right - left, top - bottom}, {x, y, kSide, kSide});
      if (fits)
        tileBlocks(shape, part);
      else
        wideBlocks(shape, part);
    }
}

void Emitter::tileBlocks(const Shape &shape, const Rect &part) {
  Region region;
  if (!regionOf(shape, part, region))
    return;
  flush();
  takeBlocks(shape, m_cover.region(region, m_blockSize.lanes(), m_blocks), m_blockSize);
}

void Emitter::wideBlocks(const Shape &shape, const Rect &part) {
  const auto isInside = [&](int x, int y) {
    return std::all_of(shape.edges, shape.edges + shape.edgeCount, [&](const Edge &edge) {
      return edge.a * std::int64_t(x) + edge.b * std::int64_t(y) + edge.c >= 0;
    });
  };
  const int width = m_blockSize.width, height = m_blockSize.height;
  for (int y = part.y & -height; y < part.y + part.height; y += height)
    for (int x = part.x & -width; x < part.x + part.width; x += width) {
      unsigned mask = insideMask(part, x, y, m_blockSize);
      for (int i = 0; i < m_blockSize.lanes(); ++i)
        if (!isInside(x + i % width, y + i / width))
          mask &= ~(1u << i);
      block(x, y, mask, m_blockSize);
    }
}

} // namespace arbiter::swrast
