#include "fp_compiler/back/llvm/fragment/fragment_affine.h"

#include <algorithm>

#include <llvm/IR/Intrinsics.h>

#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::llvm_back {

AffineFlow::AffineFlow(Code &code, const jit::FragmentProgram &program, const abi::FragmentKey &key,
                       const Places &places, Interpolator &interpolator, Value *data,
                       const SpanGroup &spans)
    : m_code(code), m_program(program), m_key(key), m_places(places), m_interpolator(interpolator),
      m_data(data), m_spans(spans), m_temporaries(program.program().temporaries.size()) {
  for (Axes &axes : m_temporaries)
    for (std::optional<Affine> &axis : axes)
      axis = uniform(number(0)); // registers are zero until written
  const std::vector<ir::Instruction> &instructions = program.program().code;
  if (ir::hasLoops(program.program()))
    return; // AffineFlow follows only straight-line code
  writeIn(code, places.group, [&] {
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
  return made([&](Value *v) { return m_code.ir.CreateUnaryIntrinsic(llvm::Intrinsic::fabs, v); },
              value);
}

Value *AffineFlow::sum(Value *a, Value *b) {
  return made([&](Value *one, Value *other) { return m_code.ir.CreateFAdd(one, other); }, a, b);
}

Value *AffineFlow::product(Value *a, Value *b) {
  return made([&](Value *one, Value *other) { return m_code.ir.CreateFMul(one, other); }, a, b);
}

Value *AffineFlow::greater(Value *a, Value *b) {
  return made(
      [&](Value *one, Value *other) {
        return m_code.ir.CreateSelect(m_code.ir.CreateFCmpOGT(one, other), one, other);
      },
      a, b);
}

Value *AffineFlow::wide(Value *number) {
  return made(
      [&](Value *from) -> Value * {
        llvm::Type *to = m_code.ir.getDoubleTy();
        if (from->getType()->isVectorTy())
          to = llvm::FixedVectorType::get(to, m_spans.size());
        return from->getType()->isIntOrIntVectorTy() ? m_code.ir.CreateSIToFP(from, to)
                                                     : m_code.ir.CreateFPExt(from, to);
      },
      number);
}

std::optional<Affine> AffineFlow::negated(std::optional<Affine> value, bool negate) {
  if (!value || !negate)
    return value;
  for (Value **part : {&value->base, &value->slope, &value->slopeY})
    if (*part)
      *part = made([&](Value *v) { return m_code.ir.CreateFNeg(v); }, *part);
  return value;
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
    return add(operand(0), negated(operand(1), true));
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
  const auto term = [&](int c) {
    return multiply(read(instruction.src[0], c), read(instruction.src[1], c));
  };
  if (homogeneous) // the sums are in the order of ir/semantics.h
    return add(add(term(0), add(term(2), read(instruction.src[1], 3))), term(1));
  std::optional<Affine> sum = term(terms - 1);
  for (int c = terms - 2; c >= 0; --c)
    sum = add(sum, term(c));
  return sum;
}

std::optional<Affine> AffineFlow::add(const std::optional<Affine> &a,
                                      const std::optional<Affine> &b) {
  if (!a || !b)
    return std::nullopt;
  const auto both = [&](Value *one, Value *other) {
    return !one ? other : !other ? one : sum(one, other);
  };
  return Affine{sum(a->base, b->base), both(a->slope, b->slope), both(a->slopeY, b->slopeY),
                sum(a->magnitude, b->magnitude), std::max(a->rounds, b->rounds) + 1};
}

std::optional<Affine> AffineFlow::multiply(const std::optional<Affine> &a,
                                           const std::optional<Affine> &b) {
  const auto varies = [](const Affine &value) { return value.slope || value.slopeY; };
  if (!a || !b || (varies(*a) && varies(*b)))
    return std::nullopt;
  // The factor of a slope does not vary, so that slopes stay scalars.
  const auto scaled = [&](Value *one, Value *other) -> Value * {
    return one ? product(one, b->base) : other ? product(other, a->base) : nullptr;
  };
  return Affine{product(a->base, b->base), scaled(a->slope, b->slope), scaled(a->slopeY, b->slopeY),
                product(a->magnitude, b->magnitude), a->rounds + b->rounds + 1};
}

std::optional<Affine> AffineFlow::read(const ir::Operand &operand, int component) {
  const ir::Select select = operand.swizzle[std::size_t(component)];
  const bool negate = operand.negate >> component & 1;
  if (select == ir::Select::Zero || select == ir::Select::One)
    return negated(uniform(number(select == ir::Select::One ? 1 : 0)), negate);
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
    if (parameter.kind == ir::ParameterKind::Constant) {
      value = uniform(number(double(parameter.constant[std::size_t(from)])));
    } else {
      value = uniform(wide(writeIn(m_code, m_places.entry, [&] {
        llvm::IRBuilder<> &ir = m_code.ir;
        Value *const rows =
            m_code.field(ir.getPtrTy(), m_data, offsetof(abi::FragmentData, parameters));
        return m_code.field(ir.getFloatTy(), rows,
                            sizeof(float) * (4u * operand.index + unsigned(from)));
      })));
    }
  }
  return negated(value, negate);
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
  const std::size_t plane = Interpolator::planeOf(input, component);
  if (how == abi::Interpolation::Flat)
    return uniform(wide(m_interpolator.constant(plane)));
  Value *const slope = wide(m_interpolator.slope(plane, false));
  Value *const slopeY = wide(m_interpolator.slope(plane, true));
  Value *const y =
      wide(m_code.ir.CreateSub(m_spans.y(), m_spans.inLanes(m_interpolator.originY())));
  Value *const along = product(slope, wide(m_spans.x())), *const up = product(slopeY, y);
  Value *const row = sum(wide(m_interpolator.constant(plane)), along);
  Value *const base = sum(row, up);
  // Each sum is rounded, and so is each product without fused multiply-add.
  Value *most = greater(magnitudeOf(row), magnitudeOf(base));
  const bool inOne = m_code.cpu.family != Cpu::Family::Sse41;
  if (!inOne)
    most = greater(most, greater(magnitudeOf(along), magnitudeOf(up)));
  Value *const across = magnitudeOf(product(slope, wide(m_spans.count())));
  const Affine value{base, slope, slopeY, sum(most, across), inOne ? 2 : 4};
  return how == abi::Interpolation::Even ? multiply(value, uniform(wide(m_interpolator.evenW())))
                                         : value;
}

std::optional<Affine> AffineFlow::position(int component) {
  const ir::Options &options = m_program.program().options;
  // Window coordinates are below 2^15, so that they and their halves are exact.
  Value *const centre = number(options.pixelCenterInteger ? 0 : 0.5);
  if (component == 0) {
    Value *const x = wide(m_spans.x());
    Value *const last = sum(x, wide(m_spans.count()));
    return Affine{sum(x, centre), number(1), nullptr, sum(last, number(1)), 0};
  }
  if (component == 1) {
    Value *const y = sum(wide(m_spans.y()), centre);
    Value *const magnitude = sum(y, number(1));
    if (!options.originUpperLeft)
      return Affine{y, nullptr, number(1), magnitude, 0};
    Value *const height = wide(writeIn(m_code, m_places.entry, [&] {
      return m_code.field(m_code.ir.getFloatTy(), m_data,
                          offsetof(abi::FragmentData, windowHeight));
    }));
    Value *const top = sum(height, number(options.pixelCenterInteger ? -1 : 0));
    Value *const fromTop = sum(top, made([&](Value *v) { return m_code.ir.CreateFNeg(v); }, y));
    return Affine{fromTop, nullptr, number(-1), sum(magnitude, magnitudeOf(height)), 1};
  }
  return std::nullopt;
}

} // namespace arbiter::fp::llvm_back
