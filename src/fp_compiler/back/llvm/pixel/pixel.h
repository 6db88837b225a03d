#pragma once
#include <vector>

#include "fp_compiler/back/llvm/pixel/pixel_memory.h"
#include "fp_compiler/back/llvm/pixel/pixel_pack.h"
#include "fp_compiler/jit.h"

/// What happens to a fragment after its program.
namespace arbiter::fp::llvm_back {

/// A texel as the program saw it, and as it lay in memory.
struct PackedTexel {
  Vec rgba;
  Value *packed = nullptr; ///< one i32 a lane, U8x4
  abi::Swizzle swizzle = abi::kRgba;
};

/// What the program made of the fragments.
struct FragmentColors {
  std::array<Vec, abi::kMaxColorTargets> colors = {}; ///< by target; null components are zero
  Value *depth = nullptr;                             ///< the program's; null: the fragment's own
  Value *alive = nullptr;                             ///< lanes that no KIL discarded; null: all
  std::vector<PackedTexel> texels;
};

/// a <comparison> b, of numbers or of signed integers. Ordered: false for NaN, but for NotEqual.
[[nodiscard]] Value *compared(Code &code, abi::Compare compare, Value *a, Value *b);

/// Writes colours to the targets.
class PixelWriter {
public:
  PixelWriter(Code &code, const abi::FragmentKey &key, const Places &places, Value *data)
      : m_code(code), m_key(key), m_places(places), m_data(data) {}

  /// \return false, with a reason, for states that have no code
  [[nodiscard]] static bool supports(const abi::FragmentKey &key, std::string &reason);
  /// In the item's block: its first pixel.
  void setPixel(Value *x, Value *y);
  /// Row: asks for the pixels that the row above will write.
  void prefetch(const PixelPlace &place);
  /// Lanes that the alpha test discards taken away from \p mask, which may be null.
  [[nodiscard]] Value *alphaTested(const PixelPlace &place, const FragmentColors &fragment,
                                   Value *mask);
  /// \param mask lanes that are written; null: all that are covered
  void write(const PixelPlace &place, const FragmentColors &fragment, Value *mask);
  /// A target's pixels of colours without blending, its write mask not applied.
  [[nodiscard]] Value *pixelsOf(const FragmentColors &fragment, std::size_t target);
  /// Stores them under the write mask; \p mask and \p old, what was there, may be null.
  void storePixels(const PixelPlace &place, Value *pixels, std::size_t target, Value *mask,
                   Value *old = nullptr);

private:
  /// The stored bits of texels that were sampled and not touched; null where it was another colour.
  [[nodiscard]] Value *passedThrough(const FragmentColors &fragment, const Vec &color,
                                     const abi::ColorTargetKey &target);
  /// Blends buffers of four bytes as hosts do: in bytes, each product rounded to one.
  /// \param old what was there
  [[nodiscard]] Value *blendedBytes(const FragmentColors &fragment, std::size_t target, Value *old);
  [[nodiscard]] Vec blended(const Vec &source, const Vec &dest, const abi::BlendKey &key,
                            bool fixedPoint);
  [[nodiscard]] Value *uniform(std::size_t offset, bool clamped = false);

  Code &m_code;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_data;
  std::vector<PixelMemory> m_targets; ///< by target; those with a layout
};

} // namespace arbiter::fp::llvm_back
