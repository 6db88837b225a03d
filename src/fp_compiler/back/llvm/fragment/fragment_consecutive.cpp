#include "fp_compiler/back/llvm/fragment/fragment_consecutive.h"

#include <set>
#include <vector>

#include <llvm/IR/Intrinsics.h>

namespace arbiter::fp::llvm_back {

namespace {
const abi::SamplerKey &samplerOf(const jit::FragmentProgram &program, const abi::FragmentKey &key,
                                 std::size_t index) {
  return key.samplers[program.program().code[index].unit];
}

/// True for colour texels of whole 32-bit words.
bool isWords(abi::Layout layout) {
  return layout != abi::Layout::None && layout < abi::Layout::Depth16 &&
         abi::bytesOf(layout) % 4 == 0;
}

/// True if the linear filter returns a texel unchanged near its centre. The byte filter does
/// (sample_bytes.cpp); the float filter keeps a small part of a neighbour.
bool isPlainLinear(const abi::SamplerKey &sampler) {
  return abi::isPlainWord(sampler.format) && isSimple(sampler.wrap[0]) && isSimple(sampler.wrap[1]);
}
} // namespace

bool ConsecutiveSamples::isCandidate(const jit::FragmentProgram &program,
                                     const abi::FragmentKey &key, std::size_t index,
                                     const AffineFlow &flow) {
  const ir::Instruction &instruction = program.program().code[index];
  const abi::SamplerKey &sampler = samplerOf(program, key, index);
  const AffineFlow::Axes *const axes = flow.coordinate(index);
  // TXP divides, so that it is not affine. The level of detail, also TXB's, must not matter.
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
                                       const AffineFlow &flow, const SpanGroup &spans, Value *data,
                                       Value *number)
    : m_code(code), m_program(program), m_key(key), m_places(places), m_spans(spans), m_data(data) {
  llvm::IRBuilder<> &ir = code.ir;
  std::map<std::size_t, Found> found;
  writeIn(code, places.group, [&] {
    m_good = llvm::ConstantInt::getTrue(llvm::FixedVectorType::get(ir.getInt1Ty(), spans.size()));
    m_begin = integer(0);
    m_end = spans.count();
    m_last = toDouble(ir.CreateSub(spans.count(), integer(1)));
    for (std::size_t i = 0; i < program.program().code.size(); ++i)
      if (ir::info(program.program().code[i].op).has(ir::Texture) &&
          isCandidate(program, key, i, flow))
        found[i] = find(i, *flow.coordinate(i));
    if (found.empty())
      return;
    // The range is rounded to whole vectors, because the edge loop handles incomplete ones at the
    // same cost. Up to 64 bytes may be read beyond a row, which is less than a vector of larger
    // texels.
    bool large = false;
    for (const auto &[index, sample] : found)
      large |= abi::bytesOf(samplerOf(program, key, index).format.layout) > 4;
    Value *const mask = integer(-code.lanes);
    m_begin = ir.CreateAnd(ir.CreateAdd(m_begin, integer(code.lanes - 1)), mask);
    Value *const length = ir.CreateSub(m_end, m_begin);
    Value *const whole = ir.CreateAdd(m_begin, ir.CreateAnd(length, mask));
    m_end = large ? whole : ir.CreateSelect(ir.CreateICmpEQ(m_end, spans.count()), m_end, whole);
    Value *const use = ir.CreateAnd(m_good, ir.CreateICmpSGE(length, integer(code.lanes)));
    m_begin = ir.CreateSelect(use, m_begin, spans.count());
    m_end = ir.CreateSelect(use, m_end, spans.count());
  });
  if (found.empty())
    return;
  m_good = spans.ofItem(m_good, number);
  m_begin = spans.ofItem(m_begin, number);
  m_end = spans.ofItem(m_end, number);
  for (const auto &each : found) {
    const std::size_t index = each.first;
    const Found &sample = each.second;
    Value *const offset = spans.ofItem(sample.offset, number);
    Value *const first = spans.ofItem(sample.first, number);
    Value *const texel = writeIn(code, places.item,
                                 [&] { return ir.CreateGEP(ir.getInt8Ty(), sample.base, offset); });
    m_samples[index] = {&samplerOf(program, key, index), texel, first, sample.width,
                        sample.rowStride};
  }
}

Value *ConsecutiveSamples::texels(std::size_t index, Value *column) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const Sample &sample = m_samples.at(index);
  const auto bytes = unsigned(abi::bytesOf(sample.key->format.layout));
  return ir.CreateGEP(ir.getInt8Ty(), sample.texel,
                      ir.CreateMul(ir.CreateSExt(column, ir.getInt64Ty()), ir.getInt64(bytes)));
}

void ConsecutiveSamples::prefetch(Value *column) const {
  constexpr unsigned kRows = 2;
  std::set<unsigned> units;
  for (const auto &[index, sample] : m_samples) {
    if (!units.insert(m_program.program().code[index].unit).second)
      continue;
    llvm::IRBuilder<> &ir = m_code.ir;
    Value *const above = ir.CreateGEP(ir.getInt8Ty(), texels(index, column),
                                      ir.CreateMul(sample.rowStride, ir.getInt64(kRows)));
    m_code.prefetch(above, unsigned(m_code.lanes * abi::bytesOf(sample.key->format.layout)), false);
  }
}

Value *ConsecutiveSamples::texelsFrom(const Sample &sample, Value *pointer, Value *mask,
                                      Value *others) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const int words = abi::bytesOf(sample.key->format.layout) / 4;
  std::vector<int> spread;
  spread.reserve(std::size_t(m_code.lanes * words));
  for (int i = 0; i < m_code.lanes * words; ++i)
    spread.push_back(i / words);
  auto *const type = llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(m_code.lanes * words));
  return ir.CreateMaskedLoad(type, pointer, llvm::Align(1), ir.CreateShuffleVector(mask, spread),
                             others ? others : llvm::Constant::getNullValue(type));
}

Value *ConsecutiveSamples::wrappedTexels(std::size_t index, const PixelPlace &place) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  const Sample &sample = m_samples.at(index);
  const int words = abi::bytesOf(sample.key->format.layout) / 4;
  const auto beside = [&](Value *pointer, Value *texels) {
    Value *const offset =
        ir.CreateMul(ir.CreateSExt(texels, ir.getInt64Ty()), ir.getInt64(unsigned(4 * words)));
    return ir.CreateGEP(ir.getInt8Ty(), pointer, offset);
  };
  Value *const from = ir.CreateAdd(sample.first, place.column);
  Value *const pointer = beside(sample.texel, place.column);
  // Usually only some of a program's samples cross an edge at the same place.
  llvm::Function *const function = m_places.entry->getParent();
  const auto block = [&](const char *name) {
    return llvm::BasicBlock::Create(m_code.context(), name, function);
  };
  auto *const crossing = block("crossing");
  auto *const after = block("crossed");
  auto *const type = llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(m_code.lanes * words));
  Value *const end = ir.CreateAdd(from, ir.getInt32(unsigned(m_code.lanes)));
  auto *const plain = block("within");
  ir.CreateCondBr(
      ir.CreateAnd(ir.CreateICmpSGE(from, ir.getInt32(0)), ir.CreateICmpSLE(end, sample.width)),
      plain, crossing);
  ir.SetInsertPoint(plain);
  Value *const whole = ir.CreateAlignedLoad(type, pointer, llvm::Align(1));
  ir.CreateBr(after);
  ir.SetInsertPoint(crossing);
  Value *const isLeft = ir.CreateICmpSLT(from, ir.getInt32(0));
  Value *const isInside =
      ir.CreateICmpULT(ir.CreateAdd(m_code.splat(from), m_code.iota()), m_code.splat(sample.width));
  Value *beyond = nullptr;
  if (sample.key->wrap[0] == abi::Wrap::Repeat) {
    // It wraps at most once, because a span is no longer than the row.
    Value *const around = ir.CreateSelect(isLeft, sample.width, ir.CreateNeg(sample.width));
    beyond = texelsFrom(sample, beside(pointer, around),
                        ir.CreateAnd(place.covered, ir.CreateNot(isInside)), nullptr);
  } else if (sample.key->wrap[0] == abi::Wrap::ClampToEdge) {
    Value *const edge =
        ir.CreateSelect(isLeft, ir.getInt32(0), ir.CreateSub(sample.width, ir.getInt32(1)));
    Value *const texel = ir.CreateAlignedLoad(
        llvm::FixedVectorType::get(ir.getInt32Ty(), unsigned(words)),
        beside(sample.texel, ir.CreateSub(edge, sample.first)), llvm::Align(1));
    std::vector<int> repeat;
    repeat.reserve(std::size_t(m_code.lanes * words));
    for (int i = 0; i < m_code.lanes * words; ++i)
      repeat.push_back(i % words);
    beyond = ir.CreateShuffleVector(texel, repeat);
  }
  Value *const parts = texelsFrom(sample, pointer, ir.CreateAnd(place.covered, isInside), beyond);
  ir.CreateBr(after);
  ir.SetInsertPoint(after);
  llvm::PHINode *const texels = ir.CreatePHI(type, 2);
  texels->addIncoming(whole, plain);
  texels->addIncoming(parts, crossing);
  return texels;
}

Value *ConsecutiveSamples::number(double value) const {
  return m_spans.inLanes(llvm::ConstantFP::get(m_code.ir.getDoubleTy(), value));
}

Value *ConsecutiveSamples::integer(int value) const {
  return m_spans.inLanes(m_code.ir.getInt32(unsigned(value)));
}

Value *ConsecutiveSamples::toInt(Value *value) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  return ir.CreateFreeze(
      ir.CreateFPToSI(value, llvm::FixedVectorType::get(ir.getInt32Ty(), m_spans.size())));
}

Value *ConsecutiveSamples::toDouble(Value *value) const {
  llvm::IRBuilder<> &ir = m_code.ir;
  return ir.CreateSIToFP(value, llvm::FixedVectorType::get(ir.getDoubleTy(), m_spans.size()));
}

Value *ConsecutiveSamples::larger(Value *a, Value *b) const {
  return m_code.ir.CreateSelect(m_code.ir.CreateICmpSGT(a, b), a, b);
}

Value *ConsecutiveSamples::smaller(Value *a, Value *b) const {
  return m_code.ir.CreateSelect(m_code.ir.CreateICmpSLT(a, b), a, b);
}

ConsecutiveSamples::Axis ConsecutiveSamples::axis(const Affine &coordinate, Value *size,
                                                  bool normalised, bool linear, bool advances) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto scaled = [&](Value *value) {
    Value *const spans = m_spans.inLanes(value);
    return normalised ? ir.CreateFMul(spans, size) : spans;
  };
  Value *const begin = scaled(coordinate.base);
  Value *end = begin;
  if (coordinate.slope)
    end = ir.CreateFAdd(begin, ir.CreateFMul(scaled(coordinate.slope), m_last));
  // There are three more roundings: the scale by the size, the wrap, and a linear filter's half
  // texel.
  Value *const error = ir.CreateFMul(ir.CreateFAdd(scaled(coordinate.magnitude), number(1)),
                                     number(double(coordinate.rounds + 3) * 0x1p-24));
  Axis axis;
  axis.first = ir.CreateUnaryIntrinsic(llvm::Intrinsic::floor, begin);
  Value *const firstFraction = ir.CreateFSub(begin, axis.first);
  Value *lastFraction = ir.CreateFSub(end, axis.first);
  if (advances)
    lastFraction = ir.CreateFSub(lastFraction, m_last);
  // Every pixel must stay this far from the texel's edge, or this close to its centre.
  Value *low = error, *high = ir.CreateFSub(number(1), error);
  if (linear) {
    Value *const reach = ir.CreateFSub(number(kLinearReach), error);
    low = ir.CreateFSub(number(0.5), reach);
    high = ir.CreateFAdd(number(0.5), reach);
  }
  axis.good = ir.CreateFCmpOLT(error, number(0.25));
  for (Value *const fraction : {firstFraction, lastFraction}) {
    axis.good = both(axis.good, ir.CreateFCmpOGT(fraction, low));
    axis.good = both(axis.good, ir.CreateFCmpOLT(fraction, high));
  }
  // Indices must be exact as i32. The comparison is false for NaN.
  axis.good = both(axis.good, ir.CreateFCmpOLT(scaled(coordinate.magnitude), number(0x1p24)));
  return axis;
}

Value *ConsecutiveSamples::both(Value *a, Value *b) { return m_code.ir.CreateAnd(a, b); }

ConsecutiveSamples::Found ConsecutiveSamples::find(std::size_t index,
                                                   const AffineFlow::Axes &axes) {
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
  // Shifts `first` by the repetition of the image that contains `at`.
  const auto repeated = [&](Value *first, Value *at, Value *inverse, Value *size) {
    Value *const times = ir.CreateUnaryIntrinsic(
        llvm::Intrinsic::floor,
        ir.CreateFMul(ir.CreateFAdd(at, number(0.5)), m_spans.inLanes(inverse)));
    return ir.CreateFSub(first, ir.CreateFMul(times, size));
  };
  // Returns a size as double, and its reciprocal. A product with the reciprocal is exact enough.
  // The number of repetitions is below 2^24 and is looked up half a texel from the edge.
  const auto sizeOf = [&](Value *size) {
    return writeIn(m_code, m_places.entry, [&] {
      Value *const one = ir.CreateSIToFP(size, ir.getDoubleTy());
      return std::pair{one, ir.CreateFDiv(llvm::ConstantFP::get(ir.getDoubleTy(), 1), one)};
    });
  };
  const auto [widthNumber, widthInverse] = sizeOf(image.width);
  const auto [heightNumber, heightInverse] = sizeOf(image.height);
  Value *const width = m_spans.inLanes(widthNumber), *const height = m_spans.inLanes(heightNumber);
  Value *const columns = m_spans.inLanes(image.width), *const rows = m_spans.inLanes(image.height);
  Axis s = axis(*axes[0], width, normalised, linear, true);
  Axis t = axis(*axes[1], height, normalised, linear, false);
  m_good = both(m_good, both(s.good, t.good));

  // Along the row, this is the part of the span that needs no wrapping, in the repetition of the
  // image that contains the middle of the span.
  if (key.wrap[0] == abi::Wrap::Repeat) {
    Value *const middle = ir.CreateFAdd(s.first, ir.CreateFMul(m_last, number(0.5)));
    s.first = repeated(s.first, middle, widthInverse, width);
  }
  Value *const first = toInt(s.first);
  m_begin = larger(m_begin, ir.CreateNeg(first));
  m_end = smaller(m_end, ir.CreateSub(columns, first));
  // Beyond the edges, Repeat may wrap at most once. ClampToEdge allows any distance unless one
  // vector reaches both edges. Other modes allow none.
  Value *const startsInside = ir.CreateICmpSGE(first, integer(0));
  if (key.wrap[0] == abi::Wrap::Repeat)
    m_good = both(m_good, ir.CreateICmpSLE(m_spans.count(), columns));
  else if (key.wrap[0] == abi::Wrap::ClampToEdge)
    m_good =
        both(m_good, ir.CreateOr(startsInside, ir.CreateICmpSGE(columns, integer(m_code.lanes))));
  else
    m_good =
        both(m_good, ir.CreateAnd(startsInside,
                                  ir.CreateICmpSLE(m_spans.count(), ir.CreateSub(columns, first))));

  // Across, the span reads one row, which is wrapped here.
  if (key.wrap[1] == abi::Wrap::Repeat)
    t.first = repeated(t.first, t.first, heightInverse, height);
  Value *row = toInt(t.first);
  if (key.wrap[1] == abi::Wrap::ClampToEdge)
    row = smaller(larger(row, integer(0)), ir.CreateSub(rows, integer(1)));
  else
    m_good = both(m_good, ir.CreateICmpULT(row, rows));

  auto *const offsets = llvm::FixedVectorType::get(ir.getInt64Ty(), m_spans.size());
  const auto bytes = unsigned(abi::bytesOf(key.format.layout));
  Value *const along =
      ir.CreateMul(ir.CreateSExt(first, offsets), m_spans.inLanes(ir.getInt64(bytes)));
  Value *const across = ir.CreateMul(ir.CreateSExt(row, offsets), m_spans.inLanes(image.rowStride));
  return {image.base, image.rowStride, image.width, ir.CreateAdd(along, across), first};
}

} // namespace arbiter::fp::llvm_back
