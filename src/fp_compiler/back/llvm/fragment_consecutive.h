#pragma once
#include <map>

#include "fp_compiler/back/llvm/fragment_affine.h"

/// The decision, once a span, whether all samples with affine coordinates read consecutive texels.
namespace arbiter::fp::llvm_back {

/// A linear filter's fraction of a texel is rounded to a multiple of 1/256 by the general code
/// (sample.cpp), so that one below 1/512 is none: a coordinate that near to a texel's centre gives
/// the texel itself on either path.
inline constexpr double kLinearReach = 1.0 / 512;

class ConsecutiveSamples {
public:
  /// Written to the item's block.
  ConsecutiveSamples(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                     const Places &places, const AffineFlow &flow, Value *data, Value *count);

  /// Whether any sample of the program can be read so at all.
  [[nodiscard]] bool any() const { return !m_texels.empty(); }
  /// Pixels [begin, end) of the span, counted from its first, of which the texels below hold; a
  /// whole number of vectors after its start, and whole ones unless it ends with the span. Both are
  /// the span's count where there are none.
  [[nodiscard]] Value *begin() const { return m_begin; }
  [[nodiscard]] Value *end() const { return m_end; }
  /// The texel of the span's first pixel (which may lie outside of the texture, unread), for the
  /// texture instruction \p index; null if it is none of those.
  [[nodiscard]] Value *texels(std::size_t index) const;

private:
  struct Axis {
    Value *first = nullptr; ///< the index that the first pixel reads, before wrapping, a double
    Value *good = nullptr;  ///< i1
  };
  [[nodiscard]] static bool isCandidate(const jit::FragmentProgram &program,
                                        const abi::FragmentKey &key, std::size_t index,
                                        const AffineFlow &flow);
  void add(std::size_t index, const AffineFlow::Axes &axes);
  [[nodiscard]] Axis axis(const Affine &coordinate, Value *size, bool normalised, bool linear,
                          bool advances);
  [[nodiscard]] Value *both(Value *a, Value *b);

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Value *m_data, *m_count;
  Value *m_last = nullptr; ///< count - 1, a double
  Value *m_good = nullptr, *m_begin = nullptr, *m_end = nullptr;
  std::map<std::size_t, Value *> m_texels;
};

} // namespace arbiter::fp::llvm_back
