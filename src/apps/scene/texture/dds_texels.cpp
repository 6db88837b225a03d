// Decodes blocks and texels of DDS files.
#include <bit>

#include "apps/scene/texture/dds_format.h"

namespace arbiter::scene {

namespace {

std::uint32_t little(const std::uint8_t *bytes, unsigned count) {
  std::uint32_t value = 0;
  for (unsigned i = 0; i < count; ++i)
    value |= std::uint32_t(bytes[i]) << 8 * i;
  return value;
}

/// Expands 5, 6 and 5 bits to 8 bits each.
Rgba8 colorOf(std::uint32_t bits) {
  const std::uint32_t red = bits >> 11 & 31, green = bits >> 5 & 63, blue = bits & 31;
  return {std::uint8_t(red << 3 | red >> 2), std::uint8_t(green << 2 | green >> 4),
          std::uint8_t(blue << 3 | blue >> 2), 255};
}

/// Returns (a * parts of \p a + b * parts of \p b) / their sum, rounded to nearest.
std::uint8_t mixed(unsigned a, unsigned parts, unsigned b, unsigned others) {
  const unsigned whole = parts + others;
  return std::uint8_t((a * parts + b * others + whole / 2) / whole);
}

Rgba8 mixed(const Rgba8 &a, unsigned parts, const Rgba8 &b, unsigned others) {
  Rgba8 result;
  for (std::size_t i = 0; i < 4; ++i)
    result[i] = mixed(a[i], parts, b[i], others);
  return result;
}

/// Decodes two colors and two in between. If the first is not greater, BC1 has one color in between
/// and transparent black.
void decodeColors(const std::uint8_t *block, bool mayBeClear, std::array<Rgba8, 16> &texels) {
  const std::uint32_t first = little(block, 2), second = little(block + 2, 2);
  std::array<Rgba8, 4> palette = {colorOf(first), colorOf(second)};
  if (first > second || !mayBeClear) {
    palette[2] = mixed(palette[0], 2, palette[1], 1);
    palette[3] = mixed(palette[0], 1, palette[1], 2);
  } else {
    palette[2] = mixed(palette[0], 1, palette[1], 1);
    palette[3] = {0, 0, 0, 0};
  }
  const std::uint32_t indices = little(block + 4, 4);
  for (unsigned i = 0; i < 16; ++i)
    texels[i] = palette[indices >> 2 * i & 3];
}

/// Decodes four bits of alpha for each texel.
void decodePlainAlpha(const std::uint8_t *block, std::array<Rgba8, 16> &texels) {
  for (unsigned i = 0; i < 16; ++i)
    texels[i][3] = std::uint8_t((block[i / 2] >> i % 2 * 4 & 15) * 17);
}

/// Decodes two levels and six in between, or four in between, zero and one.
void decodeMixedAlpha(const std::uint8_t *block, std::array<Rgba8, 16> &texels) {
  const unsigned first = block[0], second = block[1];
  std::array<std::uint8_t, 8> palette = {block[0], block[1], 0, 0, 0, 0, 0, 255};
  const unsigned steps = first > second ? 7 : 5;
  for (unsigned i = 1; i < steps; ++i)
    palette[i + 1] = mixed(first, steps - i, second, i);
  for (unsigned half = 0; half < 2; ++half) {
    const std::uint32_t indices = little(block + 2 + 3 * half, 3);
    for (unsigned i = 0; i < 8; ++i)
      texels[8 * half + i][3] = palette[indices >> 3 * i & 7];
  }
}

/// Expands a component of at most 8 bits to 8 bits.
std::uint8_t componentOf(std::uint32_t bits, std::uint32_t mask) {
  const std::uint32_t most = mask >> std::countr_zero(mask);
  return std::uint8_t(((bits & mask) >> std::countr_zero(mask)) * 255 / most);
}

} // namespace

std::array<Rgba8, 16> decodeBlock(DdsKind kind, const std::uint8_t *block) {
  std::array<Rgba8, 16> texels = {};
  decodeColors(block + (kind == DdsKind::Bc1 ? 0 : 8), kind == DdsKind::Bc1, texels);
  if (kind == DdsKind::Bc2)
    decodePlainAlpha(block, texels);
  if (kind == DdsKind::Bc3)
    decodeMixedAlpha(block, texels);
  return texels;
}

Rgba8 decodeTexel(const DdsFormat &format, const std::uint8_t *texel) {
  const std::uint32_t bits = little(texel, format.bytes);
  Rgba8 result = {0, 0, 0, 255};
  for (std::size_t i = 0; i < 4; ++i)
    if (format.masks[i] != 0)
      result[i] = componentOf(bits, format.masks[i]);
  if (format.isGrey)
    result[1] = result[2] = result[0];
  return result;
}

} // namespace arbiter::scene
