#include "fp_compiler/back/llvm/program/arithmetic.h"

#include <limits>

#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/program/packing.h"

namespace arbiter::fp::llvm_back {

using analysis::Guard;
using ir::Opcode;

namespace {
bool guards(Guard guard, Guard side) { return (int(guard) & int(side)) != 0; }

/// Emits the arithmetic of one instruction.
class Unit {
public:
  Unit(Code &code, const OperandValues &operands, unsigned needed,
       const analysis::OperandFacts &facts, Numerics numerics, ir::Language language)
      : m_code(code), m_ir(code.ir), m_a(operands[0]), m_b(operands[1]), m_c(operands[2]),
        m_needed(needed), m_facts(facts), m_legacy(numerics == Numerics::Legacy),
        m_forwards(language == ir::Language::ArbVertex) {}

  Vec compute(Opcode op);

private:
  [[nodiscard]] bool wants(std::size_t component) const { return m_needed >> component & 1; }

  template <typename F> Vec each(F function) {
    Vec result = {};
    for (std::size_t i = 0; i < 4; ++i)
      if (wants(i))
        result[i] = function(i);
    return result;
  }
  Vec all(Value *value) {
    return each([&](std::size_t) { return value; });
  }
  Value *zero() { return m_code.splat(0.0f); }
  Value *one() { return m_code.splat(1.0f); }
  Value *sum(Value *a, Value *b) { return m_ir.CreateFAdd(a, b); }

  /// Returns the product. In Legacy, zero times infinity or NaN is zero.
  Value *product(Value *a, Value *b, Guard guard) {
    Value *const plain = m_ir.CreateFMul(a, b);
    if (!m_legacy || guard == Guard::None)
      return plain;
    Value *isZero = m_ir.getFalse();
    if (guards(guard, Guard::Left))
      isZero = m_ir.CreateFCmpOEQ(a, zero());
    if (guards(guard, Guard::Right)) {
      Value *const right = m_ir.CreateFCmpOEQ(b, zero());
      isZero = guards(guard, Guard::Left) ? m_ir.CreateOr(isZero, right) : right;
    }
    Value *const undefined = m_ir.CreateFCmpUNO(plain, plain);
    return m_code.select(m_ir.CreateAnd(undefined, isZero), zero(), plain);
  }
  Value *product(std::size_t i) { return product(m_a[i], m_b[i], m_facts.first); }

  /// Returns a dot product, summed in the order of ir/semantics.h.
  Value *dot(std::size_t terms) {
    const auto term = [&](std::size_t i) { return product(m_forwards ? i : terms - 1 - i); };
    Value *all = term(0);
    for (std::size_t i = 1; i < terms; ++i)
      all = sum(all, term(i));
    return all;
  }
  Value *homogeneous() {
    return m_forwards ? sum(dot(3), m_b[3])
                      : sum(sum(product(0), sum(product(2), m_b[3])), product(1));
  }

  Value *truth(llvm::CmpInst::Predicate predicate, std::size_t i) {
    return m_code.select(m_ir.CreateFCmp(predicate, m_a[i], m_b[i]), one(), zero());
  }

  Value *blend(std::size_t i) {
    Value *const rest = m_ir.CreateFSub(one(), m_a[i]);
    return sum(product(i), product(rest, m_c[i], m_facts.second));
  }

  Value *fraction(Value *a) { return m_ir.CreateFSub(a, m_code.floor(a)); }

  Value *minor(std::size_t i, std::size_t j) {
    return m_ir.CreateFSub(product(m_a[i], m_b[j], m_facts.first),
                           product(m_a[j], m_b[i], m_facts.second));
  }

  /// Computes components with functions that are called only if the component is needed.
  template <typename X, typename Y, typename Z, typename W> Vec of(X x, Y y, Z z, W w) {
    return {wants(0) ? x() : nullptr, wants(1) ? y() : nullptr, wants(2) ? z() : nullptr,
            wants(3) ? w() : nullptr};
  }

  Vec light();
  Vec exponential();
  Vec logarithm();

  Code &m_code;
  llvm::IRBuilder<> &m_ir;
  const Vec &m_a, &m_b, &m_c;
  unsigned m_needed;
  const analysis::OperandFacts &m_facts;
  bool m_legacy;
  bool m_forwards; ///< order in which dot products are summed
};

Vec Unit::light() {
  return of([&] { return one(); }, [&] { return maximum(m_code, m_a[0], zero()); },
            [&] {
              constexpr float kLimit = 127.99999f; // 128 - 2^-17
              Value *const exponent = minimum(
                  m_code, maximum(m_code, m_a[3], m_code.splat(-kLimit)), m_code.splat(kLimit));
              return m_code.select(m_ir.CreateFCmpOGT(m_a[0], zero()),
                                   power(m_code, m_a[1], exponent, m_legacy), zero());
            },
            [&] { return one(); });
}

Vec Unit::exponential() {
  return of([&] { return exp2(m_code, m_code.floor(m_a[0])); }, [&] { return fraction(m_a[0]); },
            [&] { return exp2(m_code, m_a[0]); }, [&] { return one(); });
}

Vec Unit::logarithm() {
  Value *const magnitude = absolute(m_code, m_a[0]);
  Value *const bits = m_ir.CreateBitCast(magnitude, m_code.i32);
  constexpr int kExponentBits = 0x7F800000;
  Value *const exponentBits = m_ir.CreateAnd(bits, m_code.splat(kExponentBits));
  // Zeros (also denormals), infinities and NaN have no regular exponent.
  Value *const ordinary =
      m_ir.CreateAnd(m_ir.CreateICmpNE(exponentBits, m_code.splat(0)),
                     m_ir.CreateICmpNE(exponentBits, m_code.splat(kExponentBits)));
  return of(
      [&] {
        Value *const exponent =
            m_ir.CreateSub(m_ir.CreateLShr(bits, m_code.splat(23)), m_code.splat(127));
        return m_code.select(ordinary, m_code.toFloat(exponent), log2(m_code, magnitude));
      },
      [&] {
        constexpr int kMantissaBits = 0x007FFFFF, kOne = 0x3F800000;
        Value *const mantissa = m_ir.CreateBitCast(
            m_ir.CreateOr(m_ir.CreateAnd(bits, m_code.splat(kMantissaBits)), m_code.splat(kOne)),
            m_code.f32);
        return m_code.select(ordinary, mantissa, one());
      },
      [&] { return log2(m_code, magnitude); }, [&] { return one(); });
}

Vec Unit::compute(Opcode op) {
  switch (op) {
  case Opcode::Abs:
    return each([&](std::size_t i) { return absolute(m_code, m_a[i]); });
  case Opcode::Add:
    return each([&](std::size_t i) { return sum(m_a[i], m_b[i]); });
  case Opcode::Cmp:
    return each([&](std::size_t i) {
      return m_code.select(m_ir.CreateFCmpOLT(m_a[i], zero()), m_b[i], m_c[i]);
    });
  case Opcode::Cos:
    return all(sineCosine(m_code, m_a[0]).cosine);
  case Opcode::Dp3:
    return all(dot(3));
  case Opcode::Dp4:
    return all(dot(4));
  case Opcode::Dph:
    return all(homogeneous());
  case Opcode::Dst:
    return of([&] { return one(); }, [&] { return product(1); }, [&] { return m_a[2]; },
              [&] { return m_b[3]; });
  case Opcode::Ex2:
    return all(exp2(m_code, m_a[0]));
  case Opcode::Flr:
    return each([&](std::size_t i) { return m_code.floor(m_a[i]); });
  case Opcode::Frc:
    return each([&](std::size_t i) { return fraction(m_a[i]); });
  case Opcode::Lg2:
    return all(log2(m_code, m_a[0]));
  case Opcode::Lit:
    return light();
  case Opcode::Lrp:
    return each([&](std::size_t i) { return blend(i); });
  case Opcode::Mad:
    return each([&](std::size_t i) { return sum(product(i), m_c[i]); });
  case Opcode::Max:
    return each([&](std::size_t i) { return maximum(m_code, m_a[i], m_b[i]); });
  case Opcode::Min:
    return each([&](std::size_t i) { return minimum(m_code, m_a[i], m_b[i]); });
  case Opcode::Mov:
  case Opcode::Swz:
    return each([&](std::size_t i) { return m_a[i]; });
  case Opcode::Mul:
    return each([&](std::size_t i) { return product(i); });
  case Opcode::Pow:
    return all(power(m_code, m_a[0], m_b[0], m_legacy));
  case Opcode::Rcp:
    return all(reciprocal(m_code, m_a[0]));
  case Opcode::Rsq:
    return all(reciprocalRoot(m_code, m_a[0]));
  case Opcode::Scs: {
    // If neither x nor y is needed, nothing is read.
    const SineCosine both = m_a[0] ? sineCosine(m_code, m_a[0]) : SineCosine{};
    return of([&] { return both.cosine; }, [&] { return both.sine; }, [&] { return zero(); },
              [&] { return zero(); });
  }
  case Opcode::Sge:
    return each([&](std::size_t i) { return truth(llvm::CmpInst::FCMP_OGE, i); });
  case Opcode::Sin:
    return all(sineCosine(m_code, m_a[0]).sine);
  case Opcode::Slt:
    return each([&](std::size_t i) { return truth(llvm::CmpInst::FCMP_OLT, i); });
  case Opcode::Sub:
    return each([&](std::size_t i) { return m_ir.CreateFSub(m_a[i], m_b[i]); });
  case Opcode::Xpd:
    return of([&] { return minor(1, 2); }, [&] { return minor(2, 0); }, [&] { return minor(0, 1); },
              [&] { return zero(); });
  case Opcode::Exp:
    return exponential();
  case Opcode::Log:
    return logarithm();
  case Opcode::Seq:
    return each([&](std::size_t i) { return truth(llvm::CmpInst::FCMP_OEQ, i); });
  case Opcode::Sne:
    return each([&](std::size_t i) { return truth(llvm::CmpInst::FCMP_UNE, i); });
  case Opcode::Pk2h:
    return all(packed(m_code, ir::Packing::Half2, m_a));
  case Opcode::Pk2us:
    return all(packed(m_code, ir::Packing::Unsigned2, m_a));
  case Opcode::Pk4b:
    return all(packed(m_code, ir::Packing::Signed4, m_a));
  case Opcode::Pk4ub:
    return all(packed(m_code, ir::Packing::Unsigned4, m_a));
  case Opcode::Up2h:
    return unpacked(m_code, ir::Packing::Half2, m_a[0], m_needed);
  case Opcode::Up2us:
    return unpacked(m_code, ir::Packing::Unsigned2, m_a[0], m_needed);
  case Opcode::Up4b:
    return unpacked(m_code, ir::Packing::Signed4, m_a[0], m_needed);
  case Opcode::Up4ub:
    return unpacked(m_code, ir::Packing::Unsigned4, m_a[0], m_needed);
  case Opcode::Ddx: // of a single fragment; the walk handles quads
  case Opcode::Ddy:
    return each([&](std::size_t i) { return m_ir.CreateFSub(m_a[i], m_a[i]); });
  case Opcode::Arl:
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
  case Opcode::Txd:
  case Opcode::Txl:
  case Opcode::Kil:
  case Opcode::Rep:
  case Opcode::Endrep:
  case Opcode::Brk:
#define FP_NV_WORD(Enumerator, ...) case Opcode::Enumerator:
#include "fp_compiler/ir/ops.def"
    break; // the walk handles these, and the words of NVIDIA's languages are in no program's code
  }
  llvm_unreachable("not an arithmetic opcode");
}
} // namespace

Vec apply(Code &code, Opcode op, const OperandValues &operands, unsigned needed,
          const analysis::OperandFacts &facts, Numerics numerics, ir::Language language) {
  return Unit(code, operands, needed, facts, numerics, language).compute(op);
}

Value *kills(Code &code, const Vec &operand) {
  Value *any = nullptr;
  for (Value *const component : operand) {
    if (!component)
      continue;
    Value *const below = code.ir.CreateFCmpOLT(component, code.splat(0.0f));
    any = any ? code.ir.CreateOr(any, below) : below;
  }
  return any ? any : llvm::Constant::getNullValue(code.i1);
}

} // namespace arbiter::fp::llvm_back
