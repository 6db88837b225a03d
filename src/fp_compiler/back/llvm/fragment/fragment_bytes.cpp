#include "fp_compiler/back/llvm/fragment/fragment_bytes.h"

#include <llvm/IR/IntrinsicsX86.h>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::llvm_back {

namespace {
/// A component depends on one byte of a texel (0 to 3), or on one of these.
constexpr int kUniform = -1, kOther = -2;

int joined(int a, int b) { return a == kUniform ? b : b == kUniform || a == b ? a : kOther; }

class ByteFlow {
public:
  ByteFlow(const ir::Program &program, const abi::FragmentKey &key)
      : m_program(program), m_key(key), m_live(analysis::liveOf(program)),
        m_temporaries(program.temporaries.size(), kAllUniform),
        m_outputs(program.outputs.size(), kAllUniform) {}

  /// Runs the analysis. Returns false unless there is exactly one sample, and no KIL or loop.
  bool run() {
    if (ir::hasLoops(m_program))
      return false;
    for (std::size_t i = 0; i < m_program.code.size(); ++i) {
      if (m_live.written[i] == 0)
        continue;
      const ir::Instruction &instruction = m_program.code[i];
      const ir::OpInfo &row = ir::info(instruction.op);
      m_work += workOf(instruction.op);
      if (row.has(ir::Kills) || (row.has(ir::Texture) && m_sample))
        return false;
      Four result = {};
      for (int c = 0; c < 4; ++c)
        result[std::size_t(c)] =
            row.has(ir::Texture) ? texel(instruction, c) : made(instruction, c);
      if (row.has(ir::Texture))
        m_sample = i;
      Four &to = instruction.dst.file == ir::File::Output ? m_outputs[instruction.dst.index]
                                                          : m_temporaries[instruction.dst.index];
      for (std::size_t c = 0; c < 4; ++c)
        if (instruction.dst.mask >> c & 1)
          to[c] = result[c];
    }
    return m_sample.has_value();
  }
  [[nodiscard]] std::size_t sample() const { return *m_sample; }
  /// Returns the approximate cost in vec4 operations.
  [[nodiscard]] int work() const { return m_work; }
  /// Returns the dependence of a component of output colour 0.
  [[nodiscard]] int color(int component) const {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i)
      if (m_program.outputs[i] == ir::Output{ir::OutputKind::Color, 0})
        return m_outputs[i][std::size_t(component)];
    return kUniform;
  }

private:
  using Four = std::array<int, 4>;
  static constexpr Four kAllUniform = {kUniform, kUniform, kUniform, kUniform};

  static int workOf(ir::Opcode op) {
    switch (op) {
    case ir::Opcode::Mov:
    case ir::Opcode::Swz:
    case ir::Opcode::Tex:
    case ir::Opcode::Txb:
    case ir::Opcode::Txp:
      return 0;
    case ir::Opcode::Cos:
    case ir::Opcode::Ex2:
    case ir::Opcode::Lg2:
    case ir::Opcode::Lit:
    case ir::Opcode::Pow:
    case ir::Opcode::Rcp:
    case ir::Opcode::Rsq:
    case ir::Opcode::Scs:
    case ir::Opcode::Sin:
      return 4;
    default:
      return 1;
    }
  }

  int texel(const ir::Instruction &instruction, int component) const {
    const abi::From from = m_key.samplers[instruction.unit].format.swizzle[std::size_t(component)];
    return from <= abi::From::C3 ? int(from) : kUniform;
  }

  int read(const ir::Operand &operand, int component) const {
    const ir::Select select = operand.swizzle[std::size_t(component)];
    if (select > ir::Select::W || operand.file == ir::File::Parameter)
      return kUniform;
    return operand.file == ir::File::Temporary ? m_temporaries[operand.index][std::size_t(select)]
                                               : kOther;
  }

  int made(const ir::Instruction &instruction, int component) const {
    const ir::OpInfo &row = ir::info(instruction.op);
    int result = kUniform;
    for (int i = 0; i < row.operandCount(); ++i) {
      const unsigned mask =
          row.has(ir::PerComponent) ? 1u << component : ir::operandMask(instruction, i);
      for (int c = 0; c < 4; ++c)
        if (mask >> c & 1)
          result = joined(result, read(instruction.src[std::size_t(i)], c));
    }
    return result;
  }

  const ir::Program &m_program;
  const abi::FragmentKey &m_key;
  analysis::LiveValues m_live;
  std::vector<Four> m_temporaries, m_outputs;
  std::optional<std::size_t> m_sample;
  int m_work = 0;
};

/// True if only the write mask comes between the program's colour and the buffer.
bool isPlain(const jit::FragmentProgram &program, const abi::FragmentKey &key) {
  return key.lanes == abi::Lanes::Row && key.alphaTest == abi::Compare::Always &&
         !key.logicOpEnabled && key.coverage == abi::Coverage::Whole &&
         key.depthStencil.layout == abi::Layout::None && !program.shape().writesDepth;
}
/// True if one instruction looks up 64 bytes in tables of 256.
bool permutesBytes(const Cpu &cpu) {
  return cpu.family == Cpu::Family::Avx512 && llvm::StringRef(cpu.features).contains("+avx512vbmi");
}

/// Returns the cost of a pixel's look-ups in vec4 operations. Look-ups in memory cost the same on
/// every processor, but operations cost less with wider vectors.
int costOfLookUp(const Cpu &cpu) { return permutesBytes(cpu) ? 3 : cpu.lanes() / 2; }

/// Returns a mask with 0xFF for each byte of a pixel that comes from byte `source` of the texel.
std::uint32_t maskOf(const ByteProgram &program, int source) {
  std::uint32_t mask = 0;
  for (unsigned k = 0; k < 4; ++k)
    if (program.source[k] == source)
      mask |= 0xFFu << 8 * k;
  return mask;
}
} // namespace

std::optional<ByteProgram> byteProgramOf(const Cpu &cpu, const jit::FragmentProgram &program,
                                         const abi::FragmentKey &key) {
  ByteFlow flow(program.program(), key);
  if (!isPlain(program, key) || !flow.run() || flow.work() <= costOfLookUp(cpu))
    return std::nullopt;
  const abi::SamplerKey &sampler = key.samplers[program.program().code[flow.sample()].unit];
  if (!abi::isPlainWord(sampler.format))
    return std::nullopt;
  ByteProgram result;
  result.sample = flow.sample();
  int targets = 0;
  for (std::size_t i = 0; i < key.targets.size(); ++i)
    if (key.targets[i].format.layout != abi::Layout::None) {
      result.target = i;
      ++targets;
    }
  const abi::ColorTargetKey &target = key.targets[result.target];
  if (targets != 1 || target.format.layout != abi::Layout::U8x4 || target.blend.enabled ||
      (program.program().options.drawBuffers && result.target != 0))
    return std::nullopt;
  for (int c = 3; c >= 0; --c) {
    const int from = flow.color(c);
    if (from == kOther)
      return std::nullopt;
    if (target.format.swizzle[std::size_t(c)] <= abi::From::C3)
      result.source[std::size_t(target.format.swizzle[std::size_t(c)])] = std::max(from, 0);
  }
  return result;
}

llvm::VectorType *ByteTables::bytes() const {
  return llvm::FixedVectorType::get(m_code.ir.getInt8Ty(), 64);
}

ByteTables::ByteTables(Code &code, const ByteProgram &program, Value *items, Value *itemCount,
                       const Places &places, const std::function<Value *(Value *texels)> &pixelsOf)
    : m_code(code), m_program(program), m_permutes(permutesBytes(code.cpu)) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *pixelTable = nullptr;
  writeIn(code, places.entry, [&] {
    const auto frame = [&](unsigned size) {
      llvm::AllocaInst *const memory = ir.CreateAlloca(llvm::ArrayType::get(ir.getInt8Ty(), size));
      memory->setAlignment(llvm::Align(64));
      return memory;
    };
    if (m_permutes)
      pixelTable = frame(kWords);
    m_tables = frame(m_permutes ? kWords : 4 * kWords);
    m_ready = ir.CreateAlloca(ir.getInt1Ty());
    ir.CreateStore(ir.getFalse(), m_ready);
  });
  llvm::Function *const function = places.entry->getParent();
  const auto block = [&](const char *name) {
    return llvm::BasicBlock::Create(code.context(), name, function);
  };
  auto *const fill = block("bytes.fill");
  auto *const done = block("bytes.done");
  // Making the tables costs as much as some hundreds of pixels.
  constexpr unsigned kLeastPixels = 4096;
  // The middle span is typical of a rectangle, and about average for a triangle.
  Value *const half = ir.CreateZExt(ir.CreateLShr(itemCount, 1), ir.getInt64Ty());
  Value *const middle =
      ir.CreateGEP(ir.getInt8Ty(), items, ir.CreateMul(half, ir.getInt64(sizeof(abi::Span))));
  Value *const width = ir.CreateZExt(
      code.field(ir.getInt16Ty(), middle, offsetof(abi::Span, count)), ir.getInt32Ty());
  llvm::BasicBlock *const before = ir.GetInsertBlock();
  ir.CreateCondBr(ir.CreateICmpUGE(ir.CreateMul(width, itemCount), ir.getInt32(kLeastPixels)), fill,
                  done);

  ir.SetInsertPoint(fill);
  llvm::PHINode *const number = ir.CreatePHI(ir.getInt32Ty(), 2);
  number->addIncoming(ir.getInt32(0), before);
  Value *const values = ir.CreateAdd(code.splat(number), code.iota());
  Value *const pixels = pixelsOf(ir.CreateMul(values, code.splat(0x01010101)));
  const auto store = [&](Value *table, Value *words) {
    ir.CreateAlignedStore(words, ir.CreateGEP(ir.getInt32Ty(), table, number),
                          llvm::Align(4u * unsigned(code.lanes)));
  };
  if (m_permutes)
    store(pixelTable, pixels);
  else
    for (int source = 0; source < 4; ++source)
      if (const std::uint32_t mask = maskOf(program, source))
        store(tableOf(source), ir.CreateAnd(pixels, code.splat(int(mask))));
  Value *const following = ir.CreateAdd(number, ir.getInt32(unsigned(code.lanes)));
  number->addIncoming(following, ir.GetInsertBlock());
  auto *const filled = block("bytes.filled");
  ir.CreateCondBr(ir.CreateICmpULT(following, ir.getInt32(256)), fill, filled);
  ir.SetInsertPoint(filled);
  if (m_permutes)
    splitTable(pixelTable);
  ir.CreateStore(ir.getTrue(), m_ready);
  ir.CreateBr(done);
  ir.SetInsertPoint(done);
}

/// Splits the pixel table into one table of 256 bytes for each byte of a pixel.
void ByteTables::splitTable(Value *pixelTable) {
  llvm::IRBuilder<> &ir = m_code.ir;
  auto *const dwords = llvm::FixedVectorType::get(ir.getInt32Ty(), 64);
  for (unsigned part = 0; part < 4; ++part) {
    Value *const all = ir.CreateAlignedLoad(
        dwords, ir.CreateConstGEP1_32(ir.getInt8Ty(), pixelTable, 256 * part), llvm::Align(64));
    for (unsigned k = 0; k < 4; ++k)
      ir.CreateAlignedStore(
          ir.CreateTrunc(ir.CreateLShr(all, llvm::ConstantInt::get(dwords, 8 * k)), bytes()),
          ir.CreateConstGEP1_32(ir.getInt8Ty(), m_tables, 256 * k + 64 * part), llvm::Align(64));
  }
}

Value *ByteTables::tableOf(int source) {
  return m_code.ir.CreateConstGEP1_32(m_code.ir.getInt8Ty(), m_tables, kWords * unsigned(source));
}

Value *ByteTables::ready() { return m_code.ir.CreateLoad(m_code.ir.getInt1Ty(), m_ready); }

void ByteTables::load() {
  if (!m_permutes)
    return; // words are looked up in memory
  llvm::IRBuilder<> &ir = m_code.ir;
  for (unsigned k = 0; k < 4; ++k)
    for (unsigned part = 0; part < 4; ++part)
      m_loaded[k][part] = ir.CreateAlignedLoad(
          bytes(), ir.CreateConstGEP1_32(ir.getInt8Ty(), m_tables, 256 * k + 64 * part),
          llvm::Align(64));
}

Value *ByteTables::pixels(Value *texels) {
  return m_permutes ? permuted(texels) : lookedUp(texels);
}

/// Looks up two pixels at a time, because a 64-bit address register holds two.
Value *ByteTables::lookedUp(Value *texels) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const auto pixel = [&](Value *pair, unsigned shift) {
    Value *found = nullptr;
    for (int source = 0; source < 4; ++source)
      if (maskOf(m_program, source)) {
        Value *const byte =
            ir.CreateAnd(ir.CreateLShr(pair, shift + 8 * unsigned(source)), ir.getInt64(0xFF));
        Value *const word = ir.CreateAlignedLoad(
            ir.getInt32Ty(), ir.CreateGEP(ir.getInt32Ty(), tableOf(source), byte), llvm::Align(4));
        found = found ? ir.CreateOr(found, word) : word;
      }
    return ir.CreateZExt(found, ir.getInt64Ty());
  };
  const auto pairs = unsigned(m_code.lanes) / 2;
  auto *const type = llvm::FixedVectorType::get(ir.getInt64Ty(), pairs);
  Value *out = llvm::PoisonValue::get(type);
  for (unsigned i = 0; i < pairs; ++i) {
    Value *const pair = ir.CreateAlignedLoad(
        ir.getInt64Ty(), ir.CreateConstGEP1_32(ir.getInt64Ty(), texels, i), llvm::Align(1));
    out = ir.CreateInsertElement(out,
                                 ir.CreateOr(pixel(pair, 0), ir.CreateShl(pixel(pair, 32), 32)), i);
  }
  return ir.CreateBitCast(out, m_code.i32);
}

Value *ByteTables::permuted(Value *texels) {
  llvm::IRBuilder<> &ir = m_code.ir;
  Value *in = ir.CreateAlignedLoad(bytes(), texels, llvm::Align(1));
  if (m_program.source != std::array{0, 1, 2, 3}) {
    std::vector<int> indices;
    indices.reserve(64);
    for (int i = 0; i < 64; ++i)
      indices.push_back(i / 4 * 4 + m_program.source[std::size_t(i % 4)]);
    in = ir.CreateShuffleVector(in, indices);
  }
  Value *const upper = ir.CreateICmpSLT(in, llvm::Constant::getNullValue(bytes()));
  const auto lookUp = [&](Value *low, Value *high) {
    return ir.CreateIntrinsic(llvm::Intrinsic::x86_avx512_vpermi2var_qi_512, {}, {low, in, high});
  };
  Value *out = nullptr;
  for (unsigned k = 0; k < 4; ++k) {
    const auto &table = m_loaded[k];
    Value *const found =
        ir.CreateSelect(upper, lookUp(table[2], table[3]), lookUp(table[0], table[1]));
    std::vector<int> indices;
    for (unsigned i = 0; i < 64; ++i)
      indices.push_back(int(i % 4 == k ? 64 + i : i));
    out = out ? ir.CreateShuffleVector(out, found, indices) : found;
  }
  return ir.CreateBitCast(out, m_code.i32);
}

} // namespace arbiter::fp::llvm_back
