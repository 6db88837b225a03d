#include "fp_compiler/back/llvm/fragment/fragment_options.h"

#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/program/arithmetic.h"

namespace arbiter::fp::llvm_back {

namespace {
class Options {
public:
  Options(Code &code, const Places &places, Value *data, Numerics numerics)
      : m_code(code), m_places(places), m_data(data), m_numerics(numerics) {}

  /// Adds the secondary colour to the clamped colour, as the interpreter does. Alpha is not changed
  /// or clamped.
  void sum(Vec &color, const Vec &secondary) {
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = m_code.ir.CreateFAdd(m_code.saturate(valueOr0(color[c])), valueOr0(secondary[c]));
  }

  Value *factor(ir::FogMode mode, Value *coordinate) {
    constexpr float kOneOverLn2 = 1.442695041f, kOneOverRootLn2 = 1.201122409f;
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *exponent = nullptr;
    switch (mode) {
    case ir::FogMode::None:
      return nullptr;
    case ir::FogMode::Exp:
      exponent = multiplied(coordinate, scaledDensity(kOneOverLn2));
      break;
    case ir::FogMode::Exp2: {
      Value *const root = multiplied(coordinate, scaledDensity(kOneOverRootLn2));
      exponent = multiplied(root, root);
      break;
    }
    case ir::FogMode::Linear: {
      Value *const end = uniform(offsetof(abi::FragmentData, fogEnd));
      Value *const start = uniform(offsetof(abi::FragmentData, fogStart));
      return m_code.saturate(
          ir.CreateFDiv(ir.CreateFSub(end, coordinate), ir.CreateFSub(end, start)));
    }
    }
    return m_code.saturate(exp2(m_code, ir.CreateFNeg(exponent)));
  }

  void fog(Vec &color, Value *factor) {
    for (std::size_t c = 0; c < 4; ++c)
      color[c] = m_code.saturate(valueOr0(color[c]));
    OperandValues operands;
    for (std::size_t c = 0; c < 3; ++c) {
      operands[0][c] = factor;
      operands[1][c] = color[c];
      operands[2][c] = uniform(offsetof(abi::FragmentData, fogColor) + sizeof(float) * c);
    }
    const Vec blend = apply(m_code, ir::Opcode::Lrp, operands, 0x7, {}, m_numerics);
    for (std::size_t c = 0; c < 3; ++c)
      color[c] = blend[c];
  }

private:
  Value *valueOr0(Value *value) { return value ? value : m_code.splat(0.0f); }

  Value *uniform(std::size_t offset) {
    return writeIn(m_code, m_places.entry, [&] {
      return m_code.splat(m_code.field(m_code.ir.getFloatTy(), m_data, offset));
    });
  }

  Value *scaledDensity(float scale) {
    return m_code.ir.CreateFMul(uniform(offsetof(abi::FragmentData, fogDensity)),
                                m_code.splat(scale));
  }

  Value *multiplied(Value *a, Value *b) {
    OperandValues operands;
    operands[0][0] = a;
    operands[1][0] = b;
    return apply(m_code, ir::Opcode::Mul, operands, 1, {}, m_numerics)[0];
  }

  Code &m_code;
  const Places &m_places;
  Value *m_data;
  Numerics m_numerics;
};
} // namespace

void applyOptions(Code &code, const Places &places, Value *data, const ir::Options &options,
                  Numerics numerics, FragmentHooks &hooks, FragmentColors &fragment) {
  Options writer(code, places, data, numerics);
  if (options.colorSum) {
    const Vec secondary = hooks.input({ir::AttributeKind::ColorSecondary, 0}, 0x7);
    for (Vec &color : fragment.colors)
      writer.sum(color, secondary);
  }
  if (options.fog != ir::FogMode::None) {
    Value *coordinate = hooks.input({ir::AttributeKind::FogCoord, 0}, 1)[0];
    Value *const factor = writer.factor(options.fog, coordinate ? coordinate : code.splat(0.0f));
    for (Vec &color : fragment.colors)
      writer.fog(color, factor);
  }
}

namespace {
void multiplyAlpha(Code &code, Value *part, FragmentColors &fragment) {
  for (Vec &color : fragment.colors)
    if (color[3])
      color[3] = code.ir.CreateFMul(color[3], part);
}
} // namespace

void applyCoverage(Code &code, abi::Coverage coverage, const Vec &input, FragmentColors &fragment) {
  llvm::IRBuilder<> &ir = code.ir;
  if (coverage == abi::Coverage::Disc) {
    Value *const squares =
        ir.CreateFAdd(ir.CreateFMul(input[0], input[0]), ir.CreateFMul(input[1], input[1]));
    Value *const inside = ir.CreateFCmpOLE(squares, code.splat(1.0f));
    fragment.alive = fragment.alive ? ir.CreateAnd(fragment.alive, inside) : inside;
    Value *const one = code.splat(1.0f);
    Value *const part = ir.CreateFMul(ir.CreateFSub(one, squares), input[2]);
    multiplyAlpha(code, code.select(ir.CreateFCmpOGT(part, one), part, one), fragment);
    return;
  }
  const auto along = [&](Value *from, Value *reach) {
    return code.saturate(
        ir.CreateFSub(reach, ir.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, from)));
  };
  multiplyAlpha(code, ir.CreateFMul(along(input[0], input[2]), along(input[1], input[3])),
                fragment);
}

} // namespace arbiter::fp::llvm_back
