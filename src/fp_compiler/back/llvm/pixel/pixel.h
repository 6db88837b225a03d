#pragma once
#include <vector>

#include "fp_compiler/back/llvm/pixel/pixel_memory.h"
#include "fp_compiler/back/llvm/pixel/pixel_pack.h"
#include "fp_compiler/jit.h"

/// Operations on a fragment after its program.
namespace arbiter::fp::llvm_back {

/// A texel as the program saw it, and as it was in memory.
struct PackedTexel {
  Vec rgba;
  Value *packed = nullptr; ///< one i32 in each lane, U8x4
  abi::Swizzle swizzle = abi::kRgba;
};

/// The program's results for the fragments.
struct FragmentColors {
  std::array<Vec, abi::kMaxColorTargets> colors = {}; ///< by target; null components are zero
  Value *depth = nullptr; ///< the program's depth; null: interpolated depth
  Value *alive = nullptr; ///< lanes that no KIL discarded; null: all
  std::vector<PackedTexel> texels;
};

/// Returns a <comparison> b for floats or signed integers. It is false for NaN, except for
/// NotEqual.
[[nodiscard]] Value *compared(Code &code, abi::Compare compare, Value *a, Value *b);

/// Writes colours to the targets.
class PixelWriter {
public:
  PixelWriter(Code &code, const abi::FragmentKey &key, const Places &places, Value *data)
      : m_code(code), m_key(key), m_places(places), m_data(data) {}

  /// \return false, with a reason, for states that are not supported
  [[nodiscard]] static bool supports(const abi::FragmentKey &key, std::string &reason);
  /// Sets the item's first pixel, in the item's block.
  void setPixel(Value *x, Value *y);
  /// Row: prefetches the pixels of the row above, which are written next.
  void prefetch(const PixelPlace &place);
  /// Returns \p mask, which may be null, without the lanes that the alpha test discards.
  [[nodiscard]] Value *alphaTested(const PixelPlace &place, const FragmentColors &fragment,
                                   Value *mask);
  /// \param mask lanes to write; null: all covered ones
  void write(const PixelPlace &place, const FragmentColors &fragment, Value *mask);
  /// Returns the pixels of a target for colours without blending. The write mask is not applied.
  [[nodiscard]] Value *pixelsOf(const FragmentColors &fragment, std::size_t target);
  /// Stores pixels under the write mask. \p mask and \p old, the previous pixels, may be null.
  void storePixels(const PixelPlace &place, Value *pixels, std::size_t target, Value *mask,
                   Value *old = nullptr);

private:
  /// Returns the stored bits if the colour is a sampled texel that the program did not change; else
  /// null.
  [[nodiscard]] Value *passedThrough(const FragmentColors &fragment, const Vec &color,
                                     const abi::ColorTargetKey &target);
  /// Blends four-byte buffers as hosts do: in bytes, and each product is rounded to a byte.
  /// \param old the previous pixels
  [[nodiscard]] Value *blendedBytes(const FragmentColors &fragment, std::size_t target, Value *old);
  [[nodiscard]] Vec blended(const Vec &source, const Vec &dest, const abi::BlendKey &key,
                            bool fixedPoint);
  [[nodiscard]] Value *uniform(std::size_t offset, bool clamped = false);

  Code &m_code;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_data;
  std::vector<PixelMemory> m_targets; ///< by target; only those with a layout
};

} // namespace arbiter::fp::llvm_back
