#include "fp_compiler/back/llvm/testing/machine.h"

#include <cstdlib>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/back/llvm/program/emit.h"
#include "fp_compiler/back/llvm/program/program.h"
#include "fp_compiler/ir/reads.h"

namespace arbiter::fp::llvm_back {

namespace {
/// The arguments of the code: structures of arrays with `count` lanes each, a multiple of 16.
struct Arrays {
  const float *attributes; ///< [attribute][component][lane]
  const float *parameters; ///< [row][component]
  float *outputs; ///< [output][component][lane], then an array with 1 where a lane is killed
};
using Function = void (*)(const Arrays *, std::uint32_t count);

class ArrayHooks final : public ProgramHooks {
public:
  ArrayHooks(Code &code, const ir::Program &program, Value *arrays, Value *count)
      : m_code(code), m_program(program), m_count(count),
        m_attributes(code.field(code.ir.getPtrTy(), arrays, offsetof(Arrays, attributes))),
        m_parameters(code.field(code.ir.getPtrTy(), arrays, offsetof(Arrays, parameters))),
        m_outputs(code.field(code.ir.getPtrTy(), arrays, offsetof(Arrays, outputs))) {}

  void at(Value *first) {
    m_first = first;
    m_killed = llvm::Constant::getNullValue(m_code.i1);
  }

  Vec attribute(int index, unsigned needed) override {
    return each(needed, [&](int c) {
      return m_code.ir.CreateAlignedLoad(m_code.f32, lane(m_attributes, 4 * index + c),
                                         llvm::Align(4));
    });
  }
  Vec parameter(int index, unsigned needed) override {
    return each(needed, [&](int c) {
      return m_code.splat(m_code.field(m_code.ir.getFloatTy(), m_parameters,
                                       std::size_t(4 * index + c) * sizeof(float)));
    });
  }
  Vec texture(const ir::Instruction &instruction, const std::array<Vec, 3> &operands,
              unsigned needed) override {
    const Vec &operand = operands[0];
    const bool level = instruction.op == ir::Opcode::Txb || instruction.op == ir::Opcode::Txl;
    return each(needed, [&](int c) -> Value * {
      const std::uint8_t reads = ir::operandMask(instruction, 0);
      if (c == 3 && instruction.op == ir::Opcode::Txd)
        return m_code.ir.CreateFSub(operands[1][0], operands[2][0]);
      if (c == 3)
        return level && (reads & 8) ? operand[3] : m_code.splat(0.0f);
      if (!(ir::coordinateMask(instruction.target) >> c & 1))
        return m_code.splat(0.0f);
      Value *const value = operand[std::size_t(c)];
      return instruction.op == ir::Opcode::Txp ? m_code.ir.CreateFDiv(value, operand[3]) : value;
    });
  }
  bool hasQuads() override { return true; }
  void kill(Value *lanes) override { m_killed = m_code.ir.CreateOr(m_killed, lanes); }

  /// Returns a relative operand by selects over all rows. vertex.cpp's gather is compared with it.
  Vec relative(int array, Value *index, unsigned needed) override {
    const auto &rows = m_program.arrays[std::size_t(array)].rows;
    return each(needed, [&](int c) {
      Value *value = m_code.splat(0.0f);
      for (std::size_t row = 0; row < rows.size(); ++row)
        value = m_code.select(m_code.ir.CreateICmpEQ(index, m_code.splat(int(row))),
                              rowOf(rows[row], c), value);
      return value;
    });
  }

  void store(const ProgramResults &results) {
    int at = 0;
    for (const Vec &output : results.outputs)
      for (Value *const value : output)
        put(at++, value ? value : m_code.splat(0.0f));
    put(at, m_code.ir.CreateUIToFP(m_killed, m_code.f32));
  }

private:
  template <typename F> static Vec each(unsigned needed, F function) {
    Vec value = {};
    for (int c = 0; c < 4; ++c)
      if (needed >> c & 1)
        value[std::size_t(c)] = function(c);
    return value;
  }
  Value *rowOf(std::uint16_t row, int component) {
    const ir::Parameter &parameter = m_program.parameters[row];
    if (parameter.kind == ir::ParameterKind::Constant)
      return m_code.splat(parameter.constant[std::size_t(component)]);
    return this->parameter(row, 1u << component)[std::size_t(component)];
  }
  void put(int array, Value *value) {
    m_code.ir.CreateAlignedStore(value, lane(m_outputs, array), llvm::Align(4));
  }
  Value *lane(Value *base, int array) {
    Value *const start = m_code.ir.CreateMul(m_count, m_code.ir.getInt64(std::uint64_t(array)));
    return m_code.ir.CreateGEP(m_code.ir.getFloatTy(), base, m_code.ir.CreateAdd(start, m_first));
  }

  Code &m_code;
  const ir::Program &m_program;
  Value *m_count, *m_attributes, *m_parameters, *m_outputs;
  Value *m_first = nullptr, *m_killed = nullptr;
};

void writeBody(Code &code, llvm::Function *function, const ir::Program &program,
               Numerics numerics) {
  llvm::IRBuilder<> &ir = code.ir;
  auto *const entry = llvm::BasicBlock::Create(code.context(), "entry", function);
  auto *const loop = llvm::BasicBlock::Create(code.context(), "loop", function);
  auto *const end = llvm::BasicBlock::Create(code.context(), "end", function);
  ir.SetInsertPoint(entry);
  Value *const count = ir.CreateZExt(function->getArg(1), ir.getInt64Ty());
  ArrayHooks hooks(code, program, function->getArg(0), count);
  ir.CreateBr(loop);
  ir.SetInsertPoint(loop);
  llvm::PHINode *const first = ir.CreatePHI(ir.getInt64Ty(), 2);
  first->addIncoming(ir.getInt64(0), entry);
  hooks.at(first);
  hooks.store(writeProgram(code, program, numerics, hooks));
  Value *const next = ir.CreateAdd(first, ir.getInt64(std::uint64_t(code.lanes)));
  first->addIncoming(next, ir.GetInsertBlock());
  ir.CreateCondBr(ir.CreateICmpULT(next, count), loop, end);
  ir.SetInsertPoint(end);
  ir.CreateRetVoid();
}
} // namespace

std::string nameInTests(const std::string &cpu) {
  return cpu.empty() ? "host" : cpu.substr(0, cpu.find('.'));
}

std::vector<std::string> testedCpus() {
  std::vector<std::string> result = {""};
  for (const char *const name : {"avx512", "avx2", "sse4.1", "neon"})
    if (chooseCpu(name))
      result.emplace_back(name);
  return result;
}

std::array<std::size_t, 4> quadOf(const std::string &name, std::size_t lane) {
  const std::optional<Cpu> cpu = chooseCpu(name);
  const auto lanes = std::size_t(cpu ? cpu->lanes() : 4);
  const auto width = std::size_t(cpu ? cpu->blockWidth() : 2);
  const std::size_t vector = lane / lanes * lanes, in = lane % lanes;
  const std::size_t first = vector + in / width / 2 * 2 * width + in % width / 2 * 2;
  return {first, first + 1, first + width, first + width + 1};
}

TestMachine::TestMachine(const ir::Program &program, Numerics numerics, const std::string &name)
    : m_program(program) {
  const std::optional<Cpu> cpu = chooseCpu(name);
  if (!cpu) {
    m_reason = "no such processor: " + name;
    return;
  }
  const auto bytes = emit(
      *cpu, 1,
      [&](Code &code, llvm::Function *function, std::string &) {
        writeBody(code, function, program, numerics);
        return true;
      },
      Emit::Object, m_reason);
  if (!bytes.empty())
    m_code = Linked::link({{bytes.data(), bytes.size()}, "test"}, kEntrySymbol, m_reason);
}

std::vector<TestMachine::Result> TestMachine::run(const std::vector<Attributes> &lanes,
                                                  const std::vector<ir::Vec4> &parameters) const {
  constexpr std::size_t kWhole = 16;
  const std::size_t count = (lanes.size() + kWhole - 1) / kWhole * kWhole;
  const std::size_t outputs = m_program.outputs.size();
  std::vector<float> in(m_program.attributes.size() * 4 * count + 1);
  std::vector<float> out((outputs * 4 + 1) * count);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    for (std::size_t i = 0; i < m_program.attributes.size() * 4; ++i)
      in[i * count + lane] = lanes[lane][i / 4][i % 4];
  const Arrays arrays = {in.data(), parameters.empty() ? nullptr : parameters[0].data(),
                         out.data()};
  reinterpret_cast<Function>(m_code->entry())(&arrays, std::uint32_t(count));
  std::vector<Result> results(lanes.size());
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    results[lane].outputs.resize(outputs);
    for (std::size_t i = 0; i < outputs * 4; ++i)
      results[lane].outputs[i / 4][i % 4] = out[i * count + lane];
    results[lane].killed = out[outputs * 4 * count + lane] != 0.0f;
  }
  return results;
}

} // namespace arbiter::fp::llvm_back
