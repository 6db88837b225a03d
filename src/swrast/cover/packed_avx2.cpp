#include <array>
#include <immintrin.h>

#include "swrast/cover/columns.h"
#include "swrast/cover/packed_choice.h"

/// Kernels for processors with vectors of 8 lanes, which handle two rows of a block at a time.
namespace arbiter::swrast {
namespace {

constexpr int kHalf = 8; // lanes

/// Computes the clamped depths of two rows of pixels. The steps and their order are those of the
/// machine code.
class DepthSteps {
public:
  DepthSteps(const PackedTile &tile, const abi::DepthPlane &z)
      : m_tile(tile), m_c(_mm256_set1_ps(z.c)), m_dx(_mm256_set1_ps(z.dx)),
        m_dy(_mm256_set1_ps(z.dy)), m_offset(_mm256_set1_ps(z.offset)),
        m_minimum(_mm256_set1_ps(tile.minimum)), m_maximum(_mm256_set1_ps(tile.maximum)) {}

  /// \param at number of the block
  [[nodiscard]] __m256 at(unsigned at, int half) const {
    const float *const y = m_tile.yOf[at >> 4] + kHalf * half;
    const __m256 along = _mm256_fmadd_ps(m_dx, _mm256_load_ps(m_tile.xOf[at & 15]), m_c);
    const __m256 plane = _mm256_fmadd_ps(m_dy, _mm256_load_ps(y), along);
    const __m256 depth = _mm256_add_ps(plane, m_offset);
    // For NaN, these instructions return the second operand.
    return _mm256_min_ps(_mm256_max_ps(depth, m_minimum), m_maximum);
  }

private:
  const PackedTile &m_tile;
  __m256 m_c, m_dx, m_dy, m_offset, m_minimum, m_maximum;
};

/// The processor's float comparisons in GL's order. Never and Always do not use them.
constexpr int kFloatCompare[] = {0,          _CMP_LT_OQ,  _CMP_EQ_OQ, _CMP_LE_OQ,
                                 _CMP_GT_OQ, _CMP_NEQ_UQ, _CMP_GE_OQ, 0};

/// Returns all bits set in each lane where the comparison holds.
template <abi::Compare kCompare> __m256i compared(__m256i incoming, __m256i stored) {
  using abi::Compare;
  const __m256i all = _mm256_set1_epi32(-1);
  switch (kCompare) {
  case Compare::Less:
    return _mm256_cmpgt_epi32(stored, incoming);
  case Compare::GreaterEqual:
    return _mm256_xor_si256(all, _mm256_cmpgt_epi32(stored, incoming));
  case Compare::Greater:
    return _mm256_cmpgt_epi32(incoming, stored);
  case Compare::LessEqual:
    return _mm256_xor_si256(all, _mm256_cmpgt_epi32(incoming, stored));
  case Compare::Equal:
    return _mm256_cmpeq_epi32(incoming, stored);
  default:
    return _mm256_xor_si256(all, _mm256_cmpeq_epi32(incoming, stored));
  }
}

/// Returns the lanes of \p mask that pass. \p made receives the new pixels for the buffer.
template <abi::Layout kLayout, abi::Compare kCompare>
__m256i passing(__m256i mask, __m256 depth, __m256i old, __m256i &made) {
  constexpr bool kDecided = kCompare == abi::Compare::Never || kCompare == abi::Compare::Always;
  if constexpr (kCompare == abi::Compare::Never)
    mask = _mm256_setzero_si256();
  __m256i passes = mask;
  if constexpr (kLayout == abi::Layout::Depth32F) {
    made = _mm256_castps_si256(depth);
    if constexpr (!kDecided)
      passes = _mm256_castps_si256(
          _mm256_cmp_ps(depth, _mm256_castsi256_ps(old), kFloatCompare[int(kCompare)]));
  } else if constexpr (kLayout == abi::Layout::Depth32) { // same as abi::depth32Of()
    const __m256i bits =
        _mm256_slli_epi32(_mm256_cvttps_epi32(_mm256_mul_ps(depth, _mm256_set1_ps(0x1p31f))), 1);
    const __m256 isOne = _mm256_cmp_ps(depth, _mm256_set1_ps(1.0f), _CMP_NLT_UQ);
    made = _mm256_or_si256(bits, _mm256_castps_si256(isOne));
    // AVX2 compares signed integers only, so the sign bits are flipped.
    const __m256i top = _mm256_set1_epi32(int(0x80000000));
    if constexpr (!kDecided)
      passes = compared<kCompare>(_mm256_xor_si256(made, top), _mm256_xor_si256(old, top));
  } else {
    constexpr bool kShort = kLayout == abi::Layout::Depth16;
    const __m256i mine =
        _mm256_cvtps_epi32(_mm256_mul_ps(depth, _mm256_set1_ps(kShort ? 65535.0f : 16777215.0f)));
    made = kShort ? mine
                  : _mm256_or_si256(_mm256_slli_epi32(mine, 8),
                                    _mm256_and_si256(old, _mm256_set1_epi32(255)));
    if constexpr (!kDecided)
      passes = compared<kCompare>(mine, kShort ? old : _mm256_srli_epi32(old, 8));
  }
  return _mm256_and_si256(mask, passes);
}

unsigned bitsOf(__m256i lanes) { return unsigned(_mm256_movemask_ps(_mm256_castsi256_ps(lanes))); }

__m256i lanesOf(unsigned bits) {
  const __m256i each = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  return _mm256_cmpeq_epi32(_mm256_and_si256(_mm256_set1_epi32(int(bits)), each), each);
}

__m256i *vectorAt(void *lanes) { return static_cast<__m256i *>(lanes); }
const __m256i *vectorAt(const void *lanes) { return static_cast<const __m256i *>(lanes); }

template <abi::Layout kLayout, abi::Compare kCompare>
std::uint32_t testBlocksBy(PackedTile &tile, const abi::DepthPlane &z, std::uint32_t owner,
                           const abi::Block *blocks, std::uint32_t count, abi::Block *out) {
  const DepthSteps steps(tile, z);
  const __m256i owners = _mm256_set1_epi32(int(owner));
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block block = blocks[i];
    const unsigned at = PackedTile::blockAt(block.x, block.y);
    if (__builtin_expect((tile.loaded[at >> 4] >> (at & 15) & 1) == 0, 0))
      tile.load(block.x, block.y);
    unsigned mask = 0;
    for (int half = 0; half < 2; ++half) {
      // Always stores whole vectors: loading one that was stored in parts is slow.
      __m256i lanes = lanesOf(block.mask >> kHalf * half);
      if constexpr (kLayout != abi::Layout::None) {
        __m256i *const depths = vectorAt(tile.depth[at] + kHalf * half);
        const __m256i old = _mm256_load_si256(depths);
        __m256i made;
        lanes = passing<kLayout, kCompare>(lanes, steps.at(at, half), old, made);
        if (tile.test.write)
          _mm256_store_si256(depths, _mm256_blendv_epi8(old, made, lanes));
      }
      __m256i *const before = vectorAt(tile.owner[at] + kHalf * half);
      _mm256_store_si256(before, _mm256_blendv_epi8(_mm256_load_si256(before), owners, lanes));
      mask |= bitsOf(lanes) << kHalf * half;
    }
    out[left] = {block.x, block.y, std::uint16_t(mask), 0};
    left += mask != 0 ? 1 : 0;
  }
  return left;
}

struct Kernels {
  template <abi::Layout kLayout, abi::Compare kCompare>
  static constexpr TestBlocks test = testBlocksBy<kLayout, kCompare>;
};

/// For each set of 8 lanes, the numbers of its lanes without gaps.
constexpr auto kClosed = [] {
  std::array<std::array<std::uint8_t, kHalf>, 256> table{};
  for (unsigned mask = 0; mask < 256; ++mask) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < kHalf; ++lane)
      if (mask >> lane & 1)
        table[mask][count++] = lane;
  }
  return table;
}();

/// Moves the lanes of the set together, without the gaps between them.
__m256i closed(__m256i lanes, unsigned set) {
  const __m128i order = _mm_loadl_epi64(reinterpret_cast<const __m128i *>(kClosed[set].data()));
  return _mm256_permutevar8x32_epi32(lanes, _mm256_cvtepu8_epi32(order));
}

std::uint32_t listPixels(const PackedTile &tile, std::uint32_t owner, unsigned column, bool quads,
                         const abi::Block *blocks, std::uint32_t count, abi::Pixel *out) {
  // x and y of the lanes of two rows as in abi::Pixel, by rows or by quads.
  const __m256i rows = _mm256_setr_epi32(0, 1, 2, 3, 0x100, 0x101, 0x102, 0x103);
  const __m256i byQuad = _mm256_setr_epi32(0, 1, 0x100, 0x101, 2, 3, 0x102, 0x103);
  const __m256i lanes =
      _mm256_add_epi32(quads ? byQuad : rows, _mm256_set1_epi32(int(column << 16)));
  const __m256i owners = _mm256_set1_epi32(int(owner));
  const __m256i helper = _mm256_set1_epi32(int(unsigned(abi::Pixel::kHelper) << 24));
  std::uint32_t total = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block block = blocks[i];
    const std::uint32_t *const seen = tile.owner[PackedTile::blockAt(block.x, block.y)];
    for (int half = 0; half < 2; ++half) {
      unsigned mask = unsigned(block.mask) >> kHalf * half & 0xFF;
      if (owner != 0)
        mask = bitsOf(_mm256_cmpeq_epi32(owners, _mm256_load_si256(vectorAt(seen + kHalf * half))));
      __m256i pixels =
          _mm256_add_epi32(lanes, _mm256_set1_epi32(PackedTile::placeOf(block) + (2 * half << 8)));
      if (quads) {
        // To order by quads, the second pair of a row is swapped with the first pair of the next
        // row.
        mask = (mask & 0xC3) | (mask & 0x0C) << 2 | (mask >> 2 & 0x0C);
        unsigned any = mask | mask >> 1;
        any = (any | any >> 2) & 0x11;
        const unsigned whole = any * 15;
        pixels = _mm256_or_si256(pixels, _mm256_and_si256(helper, lanesOf(whole & ~mask)));
        mask = whole;
      }
      _mm256_storeu_si256(vectorAt(out + total), closed(pixels, mask));
      total += unsigned(__builtin_popcount(mask));
    }
  }
  return total;
}

} // namespace

const PackedKernels kPackedAvx2 = {chooseTest<Kernels>, listPixels, setColumns};

} // namespace arbiter::swrast
