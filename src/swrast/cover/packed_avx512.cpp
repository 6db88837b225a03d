#include <immintrin.h>

#include "swrast/cover/columns.h"
#include "swrast/cover/packed_choice.h"

/// Kernels for processors with vectors of 16 lanes and compress instructions.
namespace arbiter::swrast {
namespace {

/// Computes the clamped depths of a block's pixels. The steps and their order are those of the
/// machine code.
class DepthSteps {
public:
  DepthSteps(const PackedTile &tile, const abi::DepthPlane &z)
      : m_tile(tile), m_c(_mm512_set1_ps(z.c)), m_dx(_mm512_set1_ps(z.dx)),
        m_dy(_mm512_set1_ps(z.dy)), m_offset(_mm512_set1_ps(z.offset)),
        m_minimum(_mm512_set1_ps(tile.minimum)), m_maximum(_mm512_set1_ps(tile.maximum)) {}

  /// \param at number of the block
  [[nodiscard]] __m512 at(unsigned at) const {
    const __m512 along = _mm512_fmadd_ps(m_dx, _mm512_load_ps(m_tile.xOf[at & 15]), m_c);
    const __m512 plane = _mm512_fmadd_ps(m_dy, _mm512_load_ps(m_tile.yOf[at >> 4]), along);
    const __m512 depth = _mm512_add_ps(plane, m_offset);
    // For NaN, these instructions return the second operand.
    return _mm512_min_ps(_mm512_max_ps(depth, m_minimum), m_maximum);
  }

private:
  const PackedTile &m_tile;
  __m512 m_c, m_dx, m_dy, m_offset, m_minimum, m_maximum;
};

/// The processor's comparisons in GL's order. Never and Always do not use them.
constexpr int kIntegerCompare[] = {
    0, _MM_CMPINT_LT, _MM_CMPINT_EQ, _MM_CMPINT_LE, _MM_CMPINT_NLE, _MM_CMPINT_NE, _MM_CMPINT_NLT,
    0};
constexpr int kFloatCompare[] = {0,          _CMP_LT_OQ,  _CMP_EQ_OQ, _CMP_LE_OQ,
                                 _CMP_GT_OQ, _CMP_NEQ_UQ, _CMP_GE_OQ, 0};

/// Returns the lanes of \p mask that pass. \p made receives the new pixels for the buffer.
template <abi::Layout kLayout, abi::Compare kCompare>
__mmask16 passing(__mmask16 mask, __m512 depth, __m512i old, __m512i &made) {
  constexpr bool kDecided = kCompare == abi::Compare::Never || kCompare == abi::Compare::Always;
  if constexpr (kCompare == abi::Compare::Never)
    mask = 0;
  if constexpr (kLayout == abi::Layout::Depth32F) {
    made = _mm512_castps_si512(depth);
    if constexpr (!kDecided)
      mask = _mm512_mask_cmp_ps_mask(mask, depth, _mm512_castsi512_ps(old),
                                     kFloatCompare[int(kCompare)]);
  } else if constexpr (kLayout == abi::Layout::Depth32) { // same as abi::depth32Of()
    const __m512i bits =
        _mm512_slli_epi32(_mm512_cvttps_epi32(_mm512_mul_ps(depth, _mm512_set1_ps(0x1p31f))), 1);
    const __mmask16 isOne = _mm512_cmp_ps_mask(depth, _mm512_set1_ps(1.0f), _CMP_NLT_UQ);
    made = _mm512_mask_mov_epi32(bits, isOne, _mm512_set1_epi32(-1));
    if constexpr (!kDecided)
      mask = _mm512_mask_cmp_epu32_mask(mask, made, old, kIntegerCompare[int(kCompare)]);
  } else {
    constexpr bool kHalf = kLayout == abi::Layout::Depth16;
    const __m512i mine =
        _mm512_cvtps_epi32(_mm512_mul_ps(depth, _mm512_set1_ps(kHalf ? 65535.0f : 16777215.0f)));
    made = kHalf ? mine
                 : _mm512_or_si512(_mm512_slli_epi32(mine, 8),
                                   _mm512_and_si512(old, _mm512_set1_epi32(255)));
    if constexpr (!kDecided)
      mask = _mm512_mask_cmp_epi32_mask(mask, mine, kHalf ? old : _mm512_srli_epi32(old, 8),
                                        kIntegerCompare[int(kCompare)]);
  }
  return mask;
}

template <abi::Layout kLayout, abi::Compare kCompare>
std::uint32_t testBlocksBy(PackedTile &tile, const abi::DepthPlane &z, std::uint32_t owner,
                           const abi::Block *blocks, std::uint32_t count, abi::Block *out) {
  const DepthSteps steps(tile, z);
  const __m512i owners = _mm512_set1_epi32(int(owner));
  const bool writes = tile.test.write;
  std::uint32_t left = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    // Loaded as one word, from which compilers extract the fields well.
    std::uint64_t block = 0;
    __builtin_memcpy(&block, &blocks[i], sizeof block);
    const auto x = unsigned(block), y = unsigned(block >> 16);
    const unsigned at = PackedTile::blockAt(int(x), int(y));
    if (__builtin_expect((tile.loaded[at >> 4] >> (at & 15) & 1) == 0, 0))
      tile.load(std::int16_t(x), std::int16_t(y));
    auto mask = __mmask16(block >> 32);
    // Always stores whole vectors: loading one that was stored in parts is slow.
    if constexpr (kLayout != abi::Layout::None) {
      const __m512i old = _mm512_load_si512(tile.depth[at]);
      __m512i made;
      mask = passing<kLayout, kCompare>(mask, steps.at(at), old, made);
      if (writes)
        _mm512_store_si512(tile.depth[at], _mm512_mask_mov_epi32(old, mask, made));
    }
    const __m512i before = _mm512_load_si512(tile.owner[at]);
    _mm512_store_si512(tile.owner[at], _mm512_mask_mov_epi32(before, mask, owners));
    block = (block & 0xFFFFFFFFu) | std::uint64_t(mask) << 32;
    __builtin_memcpy(static_cast<void *>(&out[left]), &block, sizeof block);
    left += mask != 0 ? 1 : 0;
  }
  return left;
}

struct Kernels {
  template <abi::Layout kLayout, abi::Compare kCompare>
  static constexpr TestBlocks test = testBlocksBy<kLayout, kCompare>;
};

/// Returns x and y of a block's lanes as in abi::Pixel, by rows or by quads.
__m512i lanesOf(bool quads) {
  const __m512i rows = _mm512_setr_epi32(0, 1, 2, 3, 0x100, 0x101, 0x102, 0x103, 0x200, 0x201,
                                         0x202, 0x203, 0x300, 0x301, 0x302, 0x303);
  const __m512i byQuad = _mm512_setr_epi32(0, 1, 0x100, 0x101, 2, 3, 0x102, 0x103, 0x200, 0x201,
                                           0x300, 0x301, 0x202, 0x203, 0x302, 0x303);
  return quads ? byQuad : rows;
}

std::uint32_t listPixels(const PackedTile &tile, std::uint32_t owner, unsigned column, bool quads,
                         const abi::Block *blocks, std::uint32_t count, abi::Pixel *out) {
  const __m512i lanes = _mm512_add_epi32(lanesOf(quads), _mm512_set1_epi32(int(column << 16)));
  const __m512i owners = _mm512_set1_epi32(int(owner));
  const __m512i helper = _mm512_set1_epi32(int(unsigned(abi::Pixel::kHelper) << 24));
  std::uint32_t total = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const abi::Block block = blocks[i];
    unsigned mask = block.mask;
    if (owner != 0)
      mask = _mm512_cmpeq_epi32_mask(
          owners, _mm512_load_si512(tile.owner[PackedTile::blockAt(block.x, block.y)]));
    __m512i pixels = _mm512_add_epi32(lanes, _mm512_set1_epi32(PackedTile::placeOf(block)));
    if (quads) {
      // To order by quads, the second pair of a row is swapped with the first pair of the next row.
      mask = (mask & 0xC3C3) | (mask & 0x0C0C) << 2 | (mask >> 2 & 0x0C0C);
      unsigned any = mask | mask >> 1;
      any = (any | any >> 2) & 0x1111;
      const unsigned whole = any * 15;
      pixels = _mm512_mask_or_epi32(pixels, __mmask16(whole & ~mask), pixels, helper);
      mask = whole;
    }
    _mm512_storeu_si512(out + total, _mm512_maskz_compress_epi32(__mmask16(mask), pixels));
    total += unsigned(__builtin_popcount(mask));
  }
  return total;
}

} // namespace

const PackedKernels kPackedAvx512 = {chooseTest<Kernels>, listPixels, setColumns};

} // namespace arbiter::swrast
