#pragma once
#include <map>

#include "fp_compiler/back/llvm/fragment/fragment_affine.h"
#include "fp_compiler/back/llvm/pixel/pixel_memory.h"

/// Decides once for each span whether all samples with affine coordinates read consecutive texels.
namespace arbiter::fp::llvm_back {

/// Maximum distance from a texel's centre, in texels, at which the linear byte filter returns that
/// texel unchanged. It is half a step of the filter weights.
inline constexpr double kLinearReach = 1.0 / 512;

/// How a loop reads samples with consecutive texels. General: like any other sample. Consecutive:
/// loads without wrapping. Edge: loads on both sides of the texture's edge. Given: the one sample
/// is already loaded.
enum class SamplePath : std::uint8_t { General, Consecutive, Edge, Given };

/// The samples of a program that may read consecutive texels, and whether they do in a span.
class ConsecutiveSamples {
public:
  /// Writes the decision to the group's and the item's block.
  /// \param number the item's index in the group, i32
  ConsecutiveSamples(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                     const Places &places, const AffineFlow &flow, const SpanGroup &spans,
                     Value *data, Value *number);

  /// True if any sample of the program qualifies.
  [[nodiscard]] bool any() const { return !m_samples.empty(); }
  /// Returns an i1: true if all of them are consecutive over the whole span, except for wrapping.
  [[nodiscard]] Value *good() const { return m_good; }
  /// Return the range [begin, end) of pixels of the span in which no sample wraps. It starts a
  /// whole number of vectors after the span's start, and has whole vectors unless it ends with the
  /// span. If there is no such range, both are the span's count.
  [[nodiscard]] Value *begin() const { return m_begin; }
  [[nodiscard]] Value *end() const { return m_end; }
  /// True if the texture instruction at \p index qualifies.
  [[nodiscard]] bool has(std::size_t index) const { return m_samples.contains(index); }
  /// Returns the texels of the texture instruction at \p index from pixel \p column of the span on,
  /// without wrapping.
  [[nodiscard]] Value *texels(std::size_t index, Value *column) const;
  /// Prefetches texels two rows below, as far as most programs read neighbours. The hardware
  /// prefetcher stops at each page of 4096 bytes.
  void prefetch(Value *column) const;
  /// Returns the wrapped texels from that pixel on, as decode() takes them.
  [[nodiscard]] Value *wrappedTexels(std::size_t index, const PixelPlace &place) const;

private:
  /// Values of a sample that the loops need, in the item's block.
  struct Sample {
    const abi::SamplerKey *key;
    Value *texel; ///< pointer to the texel of the span's first pixel, before wrapping
    Value *first; ///< i32: index of that texel in its row
    // The following are in the entry block.
    Value *width;     ///< i32
    Value *rowStride; ///< i64
  };
  /// Values of a sample for all spans of the group.
  struct Found {
    Value *base, *rowStride, *width; ///< in the entry block
    Value *offset, *first;           ///< vectors
  };
  struct Axis {
    Value *first = nullptr; ///< index of the first pixel's texel before wrapping, doubles
    Value *good = nullptr;  ///< i1
  };
  [[nodiscard]] static bool isCandidate(const jit::FragmentProgram &program,
                                        const abi::FragmentKey &key, std::size_t index,
                                        const AffineFlow &flow);
  [[nodiscard]] Found find(std::size_t index, const AffineFlow::Axes &axes);
  [[nodiscard]] Axis axis(const Affine &coordinate, Value *size, bool normalised, bool linear,
                          bool advances);
  /// The following work on vectors of the group.
  [[nodiscard]] Value *number(double value) const;
  [[nodiscard]] Value *integer(int value) const;
  [[nodiscard]] Value *toInt(Value *value) const;
  [[nodiscard]] Value *toDouble(Value *value) const;
  [[nodiscard]] Value *larger(Value *a, Value *b) const;
  [[nodiscard]] Value *smaller(Value *a, Value *b) const;
  [[nodiscard]] Value *both(Value *a, Value *b);
  /// Loads `lanes` texels from a pointer in the lanes of \p mask; other lanes come from \p others.
  [[nodiscard]] Value *texelsFrom(const Sample &sample, Value *pointer, Value *mask,
                                  Value *others) const;

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  const SpanGroup &m_spans;
  Value *m_data;
  Value *m_last = nullptr; ///< count - 1, doubles
  Value *m_good = nullptr, *m_begin = nullptr, *m_end = nullptr;
  std::map<std::size_t, Sample> m_samples;
};

} // namespace arbiter::fp::llvm_back
