#pragma once
#include <map>
#include <optional>
#include <vector>

#include "fp_compiler/back/llvm/fragment/fragment_spans.h"
#include "fp_compiler/jit.h"

/// Texture coordinates that are affine functions of a span's pixels: found by a walk over the
/// program, tested once a span. Where every pixel of a span reads the texel next to its
/// neighbour's, the loop loads texels as they lie.
namespace arbiter::fp::llvm_back {

/// A component of a register over a span, as doubles: the value of pixel i is `base + slope * i`,
/// and what the lanes compute differs from it by at most `magnitude * rounds * 2^-24`. What is the
/// same for all spans is a scalar of the entry's block, the rest a vector of the group's.
struct Affine {
  Value *base = nullptr;
  Value *slope = nullptr;     ///< null: the same for all pixels; a scalar
  Value *slopeY = nullptr;    ///< from a row to the next; null: none; a scalar
  Value *magnitude = nullptr; ///< of the value and of all it was made from, over the span
  int rounds = 0;
};

/// The samples of a program whose coordinates are affine.
class AffineFlow {
public:
  using Axes = std::array<std::optional<Affine>, 4>;

  AffineFlow(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
             const Places &places, Interpolator &interpolator, Value *data, const SpanGroup &spans);

  /// s, t, r, q of the texture instruction \p index of the code, where they are affine.
  [[nodiscard]] const Axes *coordinate(std::size_t index) const;
  [[nodiscard]] Value *number(double value) const;

private:
  void step(const ir::Instruction &instruction);
  [[nodiscard]] std::optional<Affine> read(const ir::Operand &operand, int component);
  [[nodiscard]] std::optional<Affine> attribute(int index, int component);
  [[nodiscard]] std::optional<Affine> position(int component);
  [[nodiscard]] std::optional<Affine> result(const ir::Instruction &instruction, int component);
  [[nodiscard]] std::optional<Affine> dot(const ir::Instruction &instruction, int terms,
                                          bool homogeneous);
  [[nodiscard]] std::optional<Affine> add(const std::optional<Affine> &a,
                                          const std::optional<Affine> &b);
  [[nodiscard]] std::optional<Affine> multiply(const std::optional<Affine> &a,
                                               const std::optional<Affine> &b);
  [[nodiscard]] Affine uniform(Value *scalar);
  [[nodiscard]] Value *magnitudeOf(Value *value);
  [[nodiscard]] Value *sum(Value *a, Value *b);
  [[nodiscard]] Value *product(Value *a, Value *b);
  [[nodiscard]] Value *greater(Value *a, Value *b);
  [[nodiscard]] std::optional<Affine> negated(std::optional<Affine> value, bool negate);
  [[nodiscard]] Value *wide(Value *number); ///< as double; of whole numbers too
  /// What \p make makes of the operands: once a call if all are scalars, else once a group.
  template <typename Make, typename... Values> Value *made(Make make, Values... operands) {
    if (!(operands->getType()->isVectorTy() || ...))
      return writeIn(m_code, m_places.entry, [&] { return make(operands...); });
    return make(m_spans.inLanes(operands)...);
  }

  Code &m_code;
  const jit::FragmentProgram &m_program;
  const abi::FragmentKey &m_key;
  const Places &m_places;
  Interpolator &m_interpolator;
  Value *m_data;
  const SpanGroup &m_spans;
  std::vector<Axes> m_temporaries;
  std::map<std::size_t, Axes> m_samples;
};

} // namespace arbiter::fp::llvm_back
