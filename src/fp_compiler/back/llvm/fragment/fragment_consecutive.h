#pragma once
#include <map>

#include "fp_compiler/back/llvm/fragment/fragment_affine.h"
#include "fp_compiler/back/llvm/pixel/pixel_memory.h"

/// The decision, once a span, whether all samples with affine coordinates read consecutive texels.
namespace arbiter::fp::llvm_back {

/// How far from a texel's centre, in texels, a linear filter of bytes gives that texel alone: half
/// a step of its weights.
inline constexpr double kLinearReach = 1.0 / 512;

/// How a loop reads the samples whose texels are consecutive: like any other, as loads that need no
/// wrapping, or as loads on both sides of the texture's edge. Given: the one sample is at hand.
enum class SamplePath : std::uint8_t { General, Consecutive, Edge, Given };

/// The samples of a program that may read consecutive texels, and whether they do in a span.
class ConsecutiveSamples {
public:
  /// Writes the decision to the group's block, and to the item's.
  /// \param number the item's place in the group, i32
  ConsecutiveSamples(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                     const Places &places, const AffineFlow &flow, const SpanGroup &spans,
                     Value *data, Value *number);

  /// Whether any sample of the program can be read so at all.
  [[nodiscard]] bool any() const { return !m_samples.empty(); }
  /// i1: whether all of them are consecutive over the whole span, but for wrapping.
  [[nodiscard]] Value *good() const { return m_good; }
  /// Pixels [begin, end) of the span, counted from its first, in which none wraps: a whole number
  /// of vectors after its start, and whole ones unless it ends with the span. Both are the span's
  /// count where there are none.
  [[nodiscard]] Value *begin() const { return m_begin; }
  [[nodiscard]] Value *end() const { return m_end; }
  /// Whether the texture instruction \p index is one of them.
  [[nodiscard]] bool has(std::size_t index) const { return m_samples.contains(index); }
  /// For the texture instruction \p index: the texel of pixel \p column of the span, where none
  /// wraps.
  [[nodiscard]] Value *texels(std::size_t index, Value *column) const;
  /// Asks for the texels that a row two rows further on will read there: as far as neighbours reach
  /// in most programs. What processors foresee ends with each page of 4096 bytes.
  void prefetch(Value *column) const;
  /// The texels from that pixel on, wrapped; what decode() takes.
  [[nodiscard]] Value *wrappedTexels(std::size_t index, const PixelPlace &place) const;

private:
  /// What the loops want of a sample, in the item's block.
  struct Sample {
    const abi::SamplerKey *key;
    Value *texel; ///< pointer to the texel of the span's first pixel, unless it is wrapped
    Value *first; ///< i32: that texel's place in its row
    // Of the entry's block.
    Value *width;     ///< i32
    Value *rowStride; ///< i64
  };
  /// The same of all spans of the group, while it is found out.
  struct Found {
    Value *base, *rowStride, *width; ///< of the entry's block
    Value *offset, *first;           ///< vectors
  };
  struct Axis {
    Value *first = nullptr; ///< the index that the first pixel reads, before wrapping, doubles
    Value *good = nullptr;  ///< i1
  };
  [[nodiscard]] static bool isCandidate(const jit::FragmentProgram &program,
                                        const abi::FragmentKey &key, std::size_t index,
                                        const AffineFlow &flow);
  [[nodiscard]] Found find(std::size_t index, const AffineFlow::Axes &axes);
  [[nodiscard]] Axis axis(const Affine &coordinate, Value *size, bool normalised, bool linear,
                          bool advances);
  /// Vectors of the group.
  [[nodiscard]] Value *number(double value) const;
  [[nodiscard]] Value *integer(int value) const;
  [[nodiscard]] Value *toInt(Value *value) const;
  [[nodiscard]] Value *toDouble(Value *value) const;
  [[nodiscard]] Value *larger(Value *a, Value *b) const;
  [[nodiscard]] Value *smaller(Value *a, Value *b) const;
  [[nodiscard]] Value *both(Value *a, Value *b);
  /// `lanes` texels from a pointer on, of the lanes of \p mask; the others' are those of \p others.
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
