#include "fp_compiler/back/llvm/fragment_affine.h"

#include <algorithm>

#include <llvm/IR/Intrinsics.h>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::llvm_back {

namespace {
std::optional<Affine> negated(Code &code, std::optional<Affine> value, bool negate) {
  if (!value || !negate)
    return value;
  value->base = code.ir.CreateFNeg(value->base);
  if (value->slope)
    value->slope = code.ir.CreateFNeg(value->slope);
  if (value->slopeY)
    value->slopeY = code.ir.CreateFNeg(value->slopeY);
  return value;
}
} // namespace

AffineFlow::AffineFlow(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                       const Places &places, Interpolator &interpolator, Value *data, Value *count)
    : m_code(code), m_program(program), m_key(key), m_places(places), m_interpolator(interpolator),
      m_data(data), m_count(count), m_temporaries(program.program().temporaries.size()) {
  for (Axes &axes : m_temporaries)
    for (std::optional<Affine> &axis : axes)
      axis = uniform(number(0)); // registers are zero until written
  const std::vector<ir::Instruction> &instructions = program.program().code;
  writeIn(code, places.item, [&] {
    for (std::size_t i = 0; i < instructions.size(); ++i) {
      const ir::Instruction &instruction = instructions[i];
      if (ir::info(instruction.op).has(ir::Texture)) {
        Axes &axes = m_samples[i];
        for (int c = 0; c < 4; ++c)
          axes[std::size_t(c)] = read(instruction.src[0], c);
      }
      step(instruction);
    }
  });
}

const AffineFlow::Axes *AffineFlow::coordinate(std::size_t index) const {
  const auto found = m_samples.find(index);
  return found == m_samples.end() ? nullptr : &found->second;
}

Value *AffineFlow::number(double value) const {
  return llvm::ConstantFP::get(m_code.ir.getDoubleTy(), value);
}

Value *AffineFlow::magnitudeOf(Value *value) {
  return m_code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, value);
}

Affine AffineFlow::uniform(Value *scalar) {
  return {scalar, nullptr, nullptr, magnitudeOf(scalar), 0};
}

void AffineFlow::step(const ir::Instruction &instruction) {
  if (ir::info(instruction.op).has(ir::Kills) || instruction.dst.file != ir::File::Temporary)
    return;
  Axes results;
  for (int c = 0; c < 4; ++c)
    if ((instruction.dst.mask >> c & 1) && !instruction.dst.saturate)
      results[std::size_t(c)] = result(instruction, c);
  for (int c = 0; c < 4; ++c)
    if (instruction.dst.mask >> c & 1)
      m_temporaries[instruction.dst.index][std::size_t(c)] = results[std::size_t(c)];
}

std::optional<Affine> AffineFlow::result(const ir::Instruction &instruction, int component) {
  const auto operand = [&](int i) { return read(instruction.src[std::size_t(i)], component); };
  switch (instruction.op) {
  case ir::Opcode::Mov:
  case ir::Opcode::Swz:
    return operand(0);
  case ir::Opcode::Add:
    return add(operand(0), operand(1));
  case ir::Opcode::Sub:
    return add(operand(0), negated(m_code, operand(1), true));
  case ir::Opcode::Mul:
    return multiply(operand(0), operand(1));
  case ir::Opcode::Mad:
    return add(multiply(operand(0), operand(1)), operand(2));
  case ir::Opcode::Dp3:
    return dot(instruction, 3, false);
  case ir::Opcode::Dp4:
    return dot(instruction, 4, false);
  case ir::Opcode::Dph:
    return dot(instruction, 3, true);
  default:
    return std::nullopt;
  }
}

std::optional<Affine> AffineFlow::dot(const ir::Instruction &instruction, int terms,
                                      bool homogeneous) {
  std::optional<Affine> sum = multiply(read(instruction.src[0], 0), read(instruction.src[1], 0));
  for (int c = 1; c < terms; ++c)
    sum = add(sum, multiply(read(instruction.src[0], c), read(instruction.src[1], c)));
  return homogeneous ? add(sum, read(instruction.src[1], 3)) : sum;
}

std::optional<Affine> AffineFlow::add(const std::optional<Affine> &a,
                                      const std::optional<Affine> &b) {
  if (!a || !b)
    return std::nullopt;
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto sum = [&](Value *one, Value *other) {
    return !one ? other : !other ? one : ir.CreateFAdd(one, other);
  };
  return Affine{ir.CreateFAdd(a->base, b->base), sum(a->slope, b->slope), sum(a->slopeY, b->slopeY),
                ir.CreateFAdd(a->magnitude, b->magnitude), std::max(a->rounds, b->rounds) + 1};
}

std::optional<Affine> AffineFlow::multiply(const std::optional<Affine> &a,
                                           const std::optional<Affine> &b) {
  const auto varies = [](const Affine &value) { return value.slope || value.slopeY; };
  if (!a || !b || (varies(*a) && varies(*b)))
    return std::nullopt;
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto scaled = [&](Value *one, Value *other) -> Value * {
    return one ? ir.CreateFMul(one, b->base) : other ? ir.CreateFMul(other, a->base) : nullptr;
  };
  return Affine{ir.CreateFMul(a->base, b->base), scaled(a->slope, b->slope),
                scaled(a->slopeY, b->slopeY), ir.CreateFMul(a->magnitude, b->magnitude),
                a->rounds + b->rounds + 1};
}

std::optional<Affine> AffineFlow::read(const ir::Operand &operand, int component) {
  const ir::Select select = operand.swizzle[std::size_t(component)];
  const bool negate = operand.negate >> component & 1;
  if (select == ir::Select::Zero || select == ir::Select::One)
    return negated(m_code, uniform(number(select == ir::Select::One ? 1 : 0)), negate);
  const int from = int(select);
  std::optional<Affine> value;
  if (operand.relative)
    return std::nullopt;
  if (operand.file == ir::File::Temporary) {
    value = m_temporaries[operand.index][std::size_t(from)];
  } else if (operand.file == ir::File::Attribute) {
    value = attribute(operand.index, from);
  } else if (operand.file == ir::File::Parameter) {
    const ir::Parameter &parameter = m_program.program().parameters[operand.index];
    llvm::IRBuilder<> &ir = m_code.ir;
    if (parameter.kind == ir::ParameterKind::Constant) {
      value = uniform(number(double(parameter.constant[std::size_t(from)])));
    } else {
      value = uniform(writeIn(m_code, m_places.entry, [&] {
        Value *const rows =
            m_code.field(ir.getPtrTy(), m_data, offsetof(abi::FragmentData, parameters));
        Value *const scalar = m_code.field(ir.getFloatTy(), rows,
                                           sizeof(float) * (4u * operand.index + unsigned(from)));
        return ir.CreateFPExt(scalar, ir.getDoubleTy());
      }));
    }
  }
  return negated(m_code, value, negate);
}

std::optional<Affine> AffineFlow::attribute(int index, int component) {
  const ir::Attribute attribute = m_program.program().attributes[std::size_t(index)];
  if (attribute.kind == ir::AttributeKind::Position)
    return position(component);
  const std::vector<jit::FragmentInput> &inputs = m_program.shape().inputs;
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const jit::FragmentInput &in) {
    return in.attribute == attribute;
  });
  if (found == inputs.end())
    return std::nullopt;
  const int input = int(found - inputs.begin());
  const abi::Interpolation how = m_key.inputs[std::size_t(input)];
  if (how == abi::Interpolation::Perspective)
    return std::nullopt;
  llvm::IRBuilder<> &ir = m_code.ir;
  llvm::Type *const number = ir.getDoubleTy();
  const std::size_t plane = Interpolator::planeOf(input, component);
  if (how == abi::Interpolation::Flat)
    return uniform(ir.CreateFPExt(m_interpolator.constant(plane), number));
  Value *const row = ir.CreateFPExt(m_interpolator.rowConstant(plane), number);
  Value *const slope = ir.CreateFPExt(m_interpolator.slope(plane, false), number);
  Value *const slopeY = ir.CreateFPExt(m_interpolator.slope(plane, true), number);
  Value *const from = ir.CreateSIToFP(m_interpolator.fromOrigin(), number);
  Value *const reach = ir.CreateFAdd(magnitudeOf(from), ir.CreateSIToFP(m_count, number));
  // Two roundings: dx * x, and its sum with the row's constant, which is taken as it is.
  return Affine{ir.CreateFAdd(row, ir.CreateFMul(slope, from)), slope, slopeY,
                ir.CreateFAdd(magnitudeOf(row), ir.CreateFMul(magnitudeOf(slope), reach)), 2};
}

std::optional<Affine> AffineFlow::position(int component) {
  const ir::Options &options = m_program.program().options;
  // Window coordinates are below 2^15: with their halves, exact.
  llvm::IRBuilder<> &ir = m_code.ir;
  Value *const centre = number(options.pixelCenterInteger ? 0 : 0.5);
  if (component == 0) {
    Value *const x = ir.CreateSIToFP(m_interpolator.pixelX(), ir.getDoubleTy());
    Value *const last = ir.CreateFAdd(x, ir.CreateSIToFP(m_count, ir.getDoubleTy()));
    return Affine{ir.CreateFAdd(x, centre), number(1), nullptr, ir.CreateFAdd(last, number(1)), 0};
  }
  if (component == 1) {
    Value *y = ir.CreateFAdd(ir.CreateSIToFP(m_interpolator.pixelY(), ir.getDoubleTy()), centre);
    Value *magnitude = ir.CreateFAdd(y, number(1));
    if (!options.originUpperLeft)
      return Affine{y, nullptr, number(1), magnitude, 0};
    Value *const height = writeIn(m_code, m_places.entry, [&] {
      return ir.CreateFPExt(
          m_code.field(ir.getFloatTy(), m_data, offsetof(abi::FragmentData, windowHeight)),
          ir.getDoubleTy());
    });
    Value *const top = ir.CreateFSub(height, number(options.pixelCenterInteger ? 1 : 0));
    magnitude = ir.CreateFAdd(magnitude, magnitudeOf(height));
    return Affine{ir.CreateFSub(top, y), nullptr, number(-1), magnitude, 1};
  }
  return std::nullopt;
}

} // namespace arbiter::fp::llvm_back
