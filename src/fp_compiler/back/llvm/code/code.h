#pragma once
#include <array>

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include "fp_compiler/abi.h"

/// The state of code generation for one function. A vector value holds `lanes` pixels or vertices.
/// The parts of the back end (arithmetic, sampling, pixel operations) are functions on it.
namespace arbiter::fp::llvm_back {

/// The target processor. The lane count depends on its family.
struct Cpu {
  enum class Family : std::uint8_t { Avx512, Avx2, Sse41, Neon } family = Family::Sse41;
  std::string name;     ///< LLVM's name: "skylake-avx512"
  std::string features; ///< LLVM's features: "+avx512f,..."
  [[nodiscard]] int lanes() const {
    return family == Family::Avx512 ? 16 : family == Family::Avx2 ? 8 : 4;
  }
  [[nodiscard]] int blockWidth() const { return lanes() == 4 ? 2 : 4; }
  [[nodiscard]] int blockHeight() const { return lanes() / blockWidth(); }
};

using Value = llvm::Value;
/// One value for each component. A component that nothing reads may be null.
using Vec = std::array<Value *, 4>;

struct Code {
  Code(llvm::IRBuilder<> &builder, const Cpu &target);

  llvm::IRBuilder<> &ir;
  const Cpu &cpu;
  int lanes;
  llvm::VectorType *f32; ///< <lanes x float>
  llvm::VectorType *i32; ///< <lanes x i32>
  llvm::VectorType *i1;  ///< <lanes x i1>: masks

  [[nodiscard]] llvm::LLVMContext &context() const { return ir.getContext(); }
  [[nodiscard]] Value *splat(float value);
  [[nodiscard]] Value *splat(int value);
  [[nodiscard]] Value *splat(Value *scalar); ///< a float or i32
  [[nodiscard]] Value *iota();               ///< 0, 1, 2 .. as i32
  [[nodiscard]] Value *select(Value *mask, Value *yes, Value *no) {
    return ir.CreateSelect(mask, yes, no);
  }
  /// The comparisons are ordered: they are false for NaN.
  [[nodiscard]] Value *min(Value *a, Value *b); ///< floats; b if a is NaN
  [[nodiscard]] Value *max(Value *a, Value *b); ///< floats; b if a is NaN
  [[nodiscard]] Value *floor(Value *a);
  [[nodiscard]] Value *toInt(Value *a);   ///< toward zero; any value if out of range, no trap
  [[nodiscard]] Value *toFloat(Value *a); ///< from i32
  /// Clamps to [0,1]; NaN gives 0.
  [[nodiscard]] Value *saturate(Value *a);
  /// Prefetches \p bytes from a pointer on, for reading or writing. The memory need not exist.
  void prefetch(Value *pointer, unsigned bytes, bool isWritten);
  /// Looks up element \p index modulo lanes in a table of `lanes` i32s, which is aligned to its
  /// size.
  [[nodiscard]] Value *lookUp(Value *table, Value *index);
  /// Loads a scalar of `type` at `offset` bytes of the struct at `pointer`.
  [[nodiscard]] Value *field(llvm::Type *type, Value *pointer, std::size_t offset);
};

// --- sample.cpp: texture samples ---

/// The operands of a texture sample.
struct SampleAt {
  Vec coordinate = {};   ///< s, t, r; already divided for TXP
  Value *bias = nullptr; ///< TXB's bias, or null
  /// TXL's level of detail before biases and clamps, or null. There are no derivatives then.
  Value *lod = nullptr;
  /// Derivatives of the coordinate. Lanes::Quad: differences within the quad. Lanes::Row: slopes of
  /// affine coordinates for a pixel step in x and in y, equal in all lanes. All are null if no
  /// level of detail is needed.
  std::array<Value *, 3> dx = {}, dy = {};
  /// Lanes that are needed, or null for all. Loads in other lanes are safe anyway.
  Value *mask = nullptr;
  /// Set by the fragment loop if the whole span reads consecutive texels 1:1, so that plain loads
  /// from `texels` work (fragment.cpp). Null otherwise.
  Value *texels = nullptr; ///< pointer to the texel of lane 0
};

/// The result of sample(): the texel's components as the program sees them. Components outside
/// `needed` are null.
struct Texel {
  Vec rgba = {};
  /// The 32 bits of a U8x4 texel as in memory, if it is a single texel or the filter computed
  /// bytes. It can be stored unchanged without arithmetic. Null otherwise.
  Value *packed = nullptr;
};
/// True if hosts use byte arithmetic for filtering with the wrap mode, which needs neither border
/// nor mirror.
[[nodiscard]] constexpr bool isSimple(abi::Wrap wrap) {
  return wrap == abi::Wrap::Repeat || wrap == abi::Wrap::ClampToEdge;
}
[[nodiscard]] Texel sample(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
                           const SampleAt &at, unsigned needed);

// --- sample_decode.cpp: stored pixels as floats ---

/// Converts a stored pixel's components to floats, for textures and targets.
/// \param raw pixels as in memory, one integer each: <lanes x i8>, i16, i32, i64 or i128
[[nodiscard]] Vec decode(Code &code, const abi::Format &format, Value *raw, unsigned needed);

} // namespace arbiter::fp::llvm_back
