#pragma once
#include <array>

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>

#include "fp_compiler/abi.h"

/// A function of machine code while it is written: one value holds `lanes` pixels or vertices. The
/// parts of the back end (arithmetic, sampling, pixel operations) are functions over this.
namespace arbiter::fp::llvm_back {

/// What the processor offers; the lane count follows from it.
struct Cpu {
  enum class Family : std::uint8_t { Avx512, Avx2, Sse41, Neon } family = Family::Sse41;
  std::string name;     ///< for LLVM: "skylake-avx512"
  std::string features; ///< for LLVM: "+avx512f,..."
  [[nodiscard]] int lanes() const {
    return family == Family::Avx512 ? 16 : family == Family::Avx2 ? 8 : 4;
  }
  [[nodiscard]] int blockWidth() const { return lanes() == 4 ? 2 : 4; }
  [[nodiscard]] int blockHeight() const { return lanes() / blockWidth(); }
};

using Value = llvm::Value;
/// One value a component. A component that nothing reads may be null.
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
  /// Ordered comparisons give false for NaN.
  [[nodiscard]] Value *min(Value *a, Value *b); ///< floats; b where a is NaN
  [[nodiscard]] Value *max(Value *a, Value *b); ///< floats; b where a is NaN
  [[nodiscard]] Value *floor(Value *a);
  [[nodiscard]] Value *toInt(Value *a); ///< toward zero; what does not fit gives anything, no trap
  [[nodiscard]] Value *toFloat(Value *a); ///< of i32
  /// [0,1]; NaN gives 0.
  [[nodiscard]] Value *saturate(Value *a);
  /// Asks for \p bytes from a pointer on, which need not be there, to be read or written soon.
  void prefetch(Value *pointer, unsigned bytes, bool isWritten);
  /// i32s of a table of `lanes` such, which lies aligned to its size: element \p index modulo
  /// lanes.
  [[nodiscard]] Value *lookUp(Value *table, Value *index);
  /// A scalar of a struct that `pointer` leads to: a load of `type` at `offset` bytes.
  [[nodiscard]] Value *field(llvm::Type *type, Value *pointer, std::size_t offset);
};

// --- sample.cpp
// ---------------------------------------------------------------------------------------

/// Where a sample is taken and what is known of it.
struct SampleAt {
  Vec coordinate = {};   ///< s, t, r; TXP has divided
  Value *bias = nullptr; ///< TXB's, or null
  Value *lod = nullptr;  ///< TXL's level of detail, before biases and clamps; no derivatives then
  /// Of Lanes::Quad: derivatives are differences in the quad. Of Lanes::Row: those of affine
  /// coordinates, as splat values a pixel in x and in y; all null where no level of detail is
  /// wanted.
  std::array<Value *, 3> dx = {}, dy = {};
  Value *mask = nullptr; ///< lanes that count, or null for all: loads of others are safe anyway
  /// Set by the fragment loop where the whole span is known to read consecutive texels 1:1 (plain
  /// loads from `texels`): see fragment.cpp. Null otherwise.
  Value *texels = nullptr; ///< pointer to the texel of lane 0
};

/// The texel's four components as the program sees them, components outside `needed` null.
/// \param unit the TextureView
struct Texel {
  Vec rgba = {};
  /// The 32 bits of a U8x4 texel as it lies in memory, where it is one or a filter made its bytes:
  /// storing it unchanged needs no arithmetic. Else null.
  Value *packed = nullptr;
};
/// True if hosts filter bytes in bytes with the wrap mode: it needs neither a border nor a mirror.
[[nodiscard]] constexpr bool isSimple(abi::Wrap wrap) {
  return wrap == abi::Wrap::Repeat || wrap == abi::Wrap::ClampToEdge;
}
[[nodiscard]] Texel sample(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
                           const SampleAt &at, unsigned needed);

// --- pixel.cpp: what happens to a fragment after the program
// ------------------------------------------

/// A stored pixel's components as floats, shared by textures and targets.
/// \param raw pixels as they lie in memory, an integer each: <lanes x i8>, i16, i32, i64 or i128
[[nodiscard]] Vec decode(Code &code, const abi::Format &format, Value *raw, unsigned needed);

} // namespace arbiter::fp::llvm_back
