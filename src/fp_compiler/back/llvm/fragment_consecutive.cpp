#include "fp_compiler/back/llvm/fragment_consecutive.h"

#include <vector>

#include <llvm/IR/Intrinsics.h>

namespace arbiter::fp::llvm_back {

namespace {
const abi::SamplerKey &samplerOf(const jit::FragmentProgram &program, const abi::FragmentKey &key,
                                 std::size_t index) {
  return key.samplers[program.program().code[index].unit];
}

/// Texels of whole 32-bit words, colours.
bool isWords(abi::Layout layout) {
  return layout != abi::Layout::None && layout < abi::Layout::Depth16 &&
         abi::bytesOf(layout) % 4 == 0;
}

/// A linear filter that gives the texel alone at its centre. One that reaches the border weighs in
/// floats, which keep the least part of a neighbour.
bool isPlainLinear(const abi::SamplerKey &sampler) {
  const auto reaches = [](abi::Wrap wrap) {
    return wrap == abi::Wrap::Clamp || wrap == abi::Wrap::ClampToBorder ||
           wrap == abi::Wrap::MirrorClamp || wrap == abi::Wrap::MirrorClampToBorder;
  };
  return sampler.format.layout == abi::Layout::U8x4 && !reaches(sampler.wrap[0]) &&
         !reaches(sampler.wrap[1]);
}
} // namespace

bool ConsecutiveSamples::isCandidate(const jit::FragmentProgram &program,
                                     const abi::FragmentKey &key, std::size_t index,
                                     const AffineFlow &flow) {
  const ir::Instruction &instruction = program.program().code[index];
  const abi::SamplerKey &sampler = samplerOf(program, key, index);
  const AffineFlow::Axes *const axes = flow.coordinate(index);
  // TXP divides, which is not affine. The level of detail must not matter, TXB's neither.
  return axes && instruction.op != ir::Opcode::Txp && !sampler.shadow &&
         isWords(sampler.format.layout) && sampler.magnify == sampler.minify &&
         (sampler.magnify == abi::Filter::Nearest || isPlainLinear(sampler)) &&
         sampler.mip == abi::MipFilter::None &&
         (sampler.dimension == abi::Dimension::Tex2D ||
          sampler.dimension == abi::Dimension::Rect) &&
         (*axes)[0] && (*axes)[0]->slope && (*axes)[1];
}

ConsecutiveSamples::ConsecutiveSamples(Code &code, const jit::FragmentProgram &program,
                                       const abi::FragmentKey &key, const Places &places,
                                       const AffineFlow &flow, Value *data, Value *count)
    : m_code(code), m_program(program), m_key(key), m_places(places), m_data(data), m_count(count) {
  llvm::IRBuilder<> &ir = code.ir;
  m_good = ir.getTrue();
  m_begin = ir.getInt32(0);
  m_end = count;
  writeIn(code, places.item, [&] {
    m_last = ir.CreateSIToFP(ir.CreateSub(count, ir.getInt32(1)), ir.getDoubleTy());
    for (std::size_t i = 0; i < program.program().code.size(); ++i)
      if (ir::info(program.program().code[i].op).has(ir::Texture) &&
          isCandidate(program, key, i, flow))
        add(i, *flow.coordinate(i));
    // Whole vectors: an incomplete one costs the edges' loop no more. Behind a row 64 bytes may be
    // read, which are less than a vector of larger texels.
    bool large = false;
    for (const auto &[index, sample] : m_samples)
      large |= abi::bytesOf(sample.key->format.layout) > 4;
    Value *const lanes = ir.getInt32(unsigned(code.lanes));
    Value *const mask = ir.getInt32(~unsigned(code.lanes - 1));
    m_begin = ir.CreateAnd(ir.CreateAdd(m_begin, ir.getInt32(unsigned(code.lanes - 1))), mask);
    Value *const length = ir.CreateSub(m_end, m_begin);
    Value *const whole = ir.CreateAdd(m_begin, ir.CreateAnd(length, mask));
    m_end = large ? whole : ir.CreateSelect(ir.CreateICmpEQ(m_end, count), m_end, whole);
    Value *const use = ir.CreateAnd(m_good, ir.CreateICmpSGE(length, lanes));
    m_begin = ir.CreateSelect(use, m_begin, count);
    m_end = ir.CreateSelect(use, m_end, count);
  });
}

Value *ConsecutiveSamples::texels(std::size_t index, Value *column) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const Sample &sample = m_samples.at(index);
  const auto bytes = unsigned(abi::bytesOf(sample.key->format.layout));
  const auto offset = [&](Value *texel) {
    return ir.CreateMul(ir.CreateSExt(texel, ir.getInt64Ty()), ir.getInt64(bytes));
  };
  Value *const first = writeIn(m_code, m_places.item, [&] {
    return ir.CreateGEP(ir.getInt8Ty(), sample.row, offset(sample.first));
  });
  return ir.CreateGEP(ir.getInt8Ty(), first, offset(column));
}

Value *ConsecutiveSamples::part(const Sample &sample, Value *index, Value *wanted,
                                Value *others) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const int words = abi::bytesOf(sample.key->format.layout) / 4;
  Value *const inside = ir.CreateICmpULT(ir.CreateAdd(m_code.splat(index), m_code.iota()),
                                         m_code.splat(sample.width));
  std::vector<int> spread;
  for (int i = 0; i < m_code.lanes * words; ++i)
    spread.push_back(i / words);
  Value *const mask = ir.CreateShuffleVector(ir.CreateAnd(inside, wanted), spread);
  Value *const offset =
      ir.CreateMul(ir.CreateSExt(index, ir.getInt64Ty()), ir.getInt64(unsigned(4 * words)));
  auto *const type = llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(m_code.lanes * words));
  return ir.CreateMaskedLoad(type, ir.CreateGEP(ir.getInt8Ty(), sample.row, offset), llvm::Align(1),
                             mask, others ? others : llvm::Constant::getNullValue(type));
}

Value *ConsecutiveSamples::wrappedTexels(std::size_t index, const PixelPlace &place) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const Sample &sample = m_samples.at(index);
  Value *const from = ir.CreateAdd(sample.first, place.column);
  Value *const isLeft = ir.CreateICmpSLT(from, ir.getInt32(0));
  Value *beyond = nullptr;
  if (sample.key->wrap[0] == abi::Wrap::Repeat) {
    Value *const other =
        ir.CreateSelect(isLeft, ir.CreateAdd(from, sample.width), ir.CreateSub(from, sample.width));
    beyond = part(sample, other, place.covered, nullptr);
  } else if (sample.key->wrap[0] == abi::Wrap::ClampToEdge) {
    Value *const edge =
        ir.CreateSelect(isLeft, ir.getInt32(0), ir.CreateSub(sample.width, ir.getInt32(1)));
    const int words = abi::bytesOf(sample.key->format.layout) / 4;
    Value *const offset =
        ir.CreateMul(ir.CreateSExt(edge, ir.getInt64Ty()), ir.getInt64(unsigned(4 * words)));
    Value *const texel =
        ir.CreateAlignedLoad(llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(words)),
                             ir.CreateGEP(ir.getInt8Ty(), sample.row, offset), llvm::Align(1));
    std::vector<int> repeat;
    for (int i = 0; i < m_code.lanes * words; ++i)
      repeat.push_back(i % words);
    beyond = ir.CreateShuffleVector(texel, repeat);
  }
  return part(sample, from, place.covered, beyond);
}

ConsecutiveSamples::Axis ConsecutiveSamples::axis(const Affine &coordinate, Value *size,
                                                  bool normalised, bool linear, bool advances) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto number = [&](double value) { return llvm::ConstantFP::get(ir.getDoubleTy(), value); };
  const auto scaled = [&](Value *value) { return normalised ? ir.CreateFMul(value, size) : value; };
  Value *const begin = scaled(coordinate.base);
  Value *end = begin;
  if (coordinate.slope)
    end = ir.CreateFAdd(begin, ir.CreateFMul(scaled(coordinate.slope), m_last));
  // Three more roundings: the scale by the size, the wrap, and a linear filter's half texel.
  Value *const error = ir.CreateFMul(ir.CreateFAdd(scaled(coordinate.magnitude), number(1)),
                                     number(double(coordinate.rounds + 3) * 0x1p-24));
  Axis axis;
  axis.first = ir.CreateUnaryIntrinsic(llvm::Intrinsic::floor, begin);
  Value *const firstFraction = ir.CreateFSub(begin, axis.first);
  Value *lastFraction = ir.CreateFSub(end, axis.first);
  if (advances)
    lastFraction = ir.CreateFSub(lastFraction, m_last);
  // How far from the texel's edge, or centre, every pixel must stay.
  Value *const low = linear ? ir.CreateFAdd(error, number(0.5 - kLinearReach)) : error;
  Value *const high =
      linear ? ir.CreateFSub(number(0.5 + kLinearReach), error) : ir.CreateFSub(number(1), error);
  axis.good = ir.CreateFCmpOLT(error, number(0.25));
  for (Value *const fraction : {firstFraction, lastFraction}) {
    axis.good = both(axis.good, ir.CreateFCmpOGT(fraction, low));
    axis.good = both(axis.good, ir.CreateFCmpOLT(fraction, high));
  }
  // So that indices are exact as i32; false for NaN.
  axis.good = both(axis.good, ir.CreateFCmpOLT(scaled(coordinate.magnitude), number(0x1p24)));
  return axis;
}

Value *ConsecutiveSamples::both(Value *a, Value *b) { return m_code.ir.CreateAnd(a, b); }

void ConsecutiveSamples::add(std::size_t index, const AffineFlow::Axes &axes) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const abi::SamplerKey &key = samplerOf(m_program, m_key, index);
  const unsigned unit = m_program.program().code[index].unit;
  const bool normalised = key.dimension != abi::Dimension::Rect;
  const bool linear = key.magnify == abi::Filter::Linear;
  struct Image {
    Value *base, *rowStride, *width, *height;
  };
  const Image image = writeIn(m_code, m_places.entry, [&] {
    Value *const view = m_code.field(ir.getPtrTy(), m_data,
                                     offsetof(abi::FragmentData, textures) + sizeof(void *) * unit);
    Value *const level = m_code.field(ir.getPtrTy(), view, offsetof(abi::TextureView, levels));
    return Image{
        m_code.field(ir.getPtrTy(), level, offsetof(abi::TextureLevel, base)),
        m_code.field(ir.getInt64Ty(), level, offsetof(abi::TextureLevel, rowStride)),
        m_code.field(ir.getInt32Ty(), level, offsetof(abi::TextureLevel, width)),
        m_code.field(ir.getInt32Ty(), level, offsetof(abi::TextureLevel, height)),
    };
  });
  llvm::Type *const number = ir.getDoubleTy();
  const auto constant = [&](double value) { return llvm::ConstantFP::get(number, value); };
  const auto floor = [&](Value *value) {
    return ir.CreateUnaryIntrinsic(llvm::Intrinsic::floor, value);
  };
  const auto toInt = [&](Value *value) {
    return ir.CreateFreeze(ir.CreateFPToSI(value, ir.getInt32Ty()));
  };
  Value *const width = ir.CreateSIToFP(image.width, number);
  Value *const height = ir.CreateSIToFP(image.height, number);
  Axis s = axis(*axes[0], width, normalised, linear, true);
  Axis t = axis(*axes[1], height, normalised, linear, false);
  m_good = both(m_good, both(s.good, t.good));

  // Along the row: the stretch of the span that needs no wrapping, in that repetition of the image
  // in which the middle of the span lies.
  if (key.wrap[0] == abi::Wrap::Repeat) {
    Value *const middle = ir.CreateFAdd(s.first, ir.CreateFMul(m_last, constant(0.5)));
    Value *const times = floor(ir.CreateFDiv(ir.CreateFAdd(middle, constant(0.5)), width));
    s.first = ir.CreateFSub(s.first, ir.CreateFMul(times, width));
  }
  Value *const first = toInt(s.first);
  const auto larger = [&](Value *a, Value *b) {
    return ir.CreateSelect(ir.CreateICmpSGT(a, b), a, b);
  };
  const auto smaller = [&](Value *a, Value *b) {
    return ir.CreateSelect(ir.CreateICmpSLT(a, b), a, b);
  };
  m_begin = larger(m_begin, ir.CreateNeg(first));
  m_end = smaller(m_end, ir.CreateSub(image.width, first));
  // Beyond the edges: once around at most, any distance unless one vector reaches both edges, or
  // not at all.
  Value *const startsInside = ir.CreateICmpSGE(first, ir.getInt32(0));
  if (key.wrap[0] == abi::Wrap::Repeat)
    m_good = both(m_good, ir.CreateICmpSLE(m_count, image.width));
  else if (key.wrap[0] == abi::Wrap::ClampToEdge)
    m_good = both(m_good,
                  ir.CreateOr(startsInside,
                              ir.CreateICmpSGE(image.width, ir.getInt32(unsigned(m_code.lanes)))));
  else
    m_good =
        both(m_good, ir.CreateAnd(startsInside,
                                  ir.CreateICmpSLE(m_count, ir.CreateSub(image.width, first))));

  // Across: one row, wrapped here.
  if (key.wrap[1] == abi::Wrap::Repeat) {
    Value *const times = floor(ir.CreateFDiv(ir.CreateFAdd(t.first, constant(0.5)), height));
    t.first = ir.CreateFSub(t.first, ir.CreateFMul(times, height));
  }
  Value *row = toInt(t.first);
  if (key.wrap[1] == abi::Wrap::ClampToEdge)
    row = smaller(larger(row, ir.getInt32(0)), ir.CreateSub(image.height, ir.getInt32(1)));
  else
    m_good = both(m_good, ir.CreateICmpULT(row, image.height));

  Value *const offset = ir.CreateMul(ir.CreateSExt(row, ir.getInt64Ty()), image.rowStride);
  m_samples[index] = {&key, ir.CreateGEP(ir.getInt8Ty(), image.base, offset), first, image.width};
}

} // namespace arbiter::fp::llvm_back
