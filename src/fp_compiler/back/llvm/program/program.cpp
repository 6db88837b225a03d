#include "fp_compiler/back/llvm/program/program.h"

#include <limits>
#include <optional>

#include "fp_compiler/analysis/live_values.h"
#include "fp_compiler/analysis/range_analysis.h"
#include "fp_compiler/back/llvm/code/quads.h"
#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/program/arithmetic.h"
#include "fp_compiler/back/llvm/program/loops.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::llvm_back {

using ir::File;
using ir::Instruction;
using ir::Operand;
using ir::Select;

namespace {
class Walk {
public:
  Walk(Code &code, const ir::Program &program, Numerics numerics, ProgramHooks &hooks)
      : m_code(code), m_program(program), m_numerics(ir::numericsOf(program.language, numerics)),
        m_hooks(hooks), m_live(analysis::liveOf(program)), m_ranges(program, m_numerics),
        m_temporaries(program.temporaries.size()), m_attributes(program.attributes.size()),
        m_parameters(program.parameters.size()), m_addresses(program.addresses.size()) {
    m_results.outputs.resize(program.outputs.size());
  }

  ProgramResults run() {
    if (ir::hasLoops(m_program))
      prepareLoops();
    for (std::size_t i = 0; i < m_program.code.size(); ++i) {
      if (m_live.written[i] != 0)
        step(i, analysis::narrowed(m_program.code[i], m_live.written[i]));
      if (m_numerics == Numerics::Legacy)
        m_ranges.step(m_program.code[i]);
    }
    if (m_killed)
      m_hooks.kill(m_killed);
    return std::move(m_results);
  }

private:
  void step(std::size_t index, const Instruction &instruction);
  void write(const ir::Destination &dst, const Vec &value);
  void kill(Value *lanes);
  Vec derivative(const Instruction &instruction, const OperandValues &operands);
  // Loops.
  void prepareLoops();
  void flow(std::size_t index, const Instruction &instruction, const Vec &operand);
  void beginLoop(std::size_t index, Value *count);
  std::vector<LoopSlot> changedIn(std::size_t begin);
  /// Keeps the old value of a register's component in lanes that do not run.
  Value *masked(Value *value, Value *before, std::uint8_t kept, std::size_t component);
  /// Returns the operand's components at the positions in \p mask, swizzled and negated.
  Vec fetch(const Operand &operand, unsigned mask, unsigned registerMask);
  Vec source(const Operand &operand, unsigned registerMask);
  Vec row(std::uint16_t index);
  Value *address(const Operand &operand);
  Value *addressOf(Value *value);
  analysis::OperandFacts facts(const Instruction &instruction) const {
    return m_numerics == Numerics::Legacy ? m_ranges.facts(instruction) : analysis::OperandFacts{};
  }

  Code &m_code;
  const ir::Program &m_program;
  Numerics m_numerics;
  ProgramHooks &m_hooks;
  analysis::LiveValues m_live;
  analysis::RangeAnalysis m_ranges;
  /// Null components have not been written or read yet.
  std::vector<Vec> m_temporaries, m_attributes, m_parameters;
  std::vector<Value *> m_addresses;
  ProgramResults m_results;
  std::optional<Loops> m_loops; ///< set if the program has loops
  /// For each open loop: live values, including those of outer loops.
  std::vector<analysis::RegisterMasks> m_kept;
  Value *m_killed = nullptr; ///< set if the program has loops
};

bool isEmpty(const Vec &value) { return !value[0] && !value[1] && !value[2] && !value[3]; }

Vec Walk::row(std::uint16_t index) {
  const ir::Parameter &parameter = m_program.parameters[index];
  Vec &value = m_parameters[index];
  if (!isEmpty(value))
    return value;
  const bool bits = m_program.options.nv != ir::NvOption::None; // keep denormals too
  if (parameter.kind == ir::ParameterKind::Constant)
    for (std::size_t i = 0; i < 4; ++i)
      value[i] = m_code.splat(bits ? parameter.constant[i]
                                   : ir::loaded(parameter.constant[i], m_numerics));
  else
    value = m_hooks.parameter(index, m_live.parameters[index]);
  return value;
}

/// Returns the row index of a relative operand. The hook checks its range; addressOf() only
/// prevents overflow of the sum.
Value *Walk::address(const Operand &operand) {
  Value *const base = m_addresses[operand.address];
  Value *const offset = m_code.splat(int(operand.offset));
  return base ? m_code.ir.CreateAdd(base, offset) : offset;
}

Value *Walk::addressOf(Value *value) {
  Value *const floor = m_code.floor(value);
  Value *const fits = m_code.ir.CreateFCmpOLT(absolute(m_code, floor), m_code.splat(0x1p30f));
  return m_code.select(fits, m_code.toInt(floor),
                       m_code.splat(std::numeric_limits<int>::min() / 2));
}

Vec Walk::source(const Operand &operand, unsigned registerMask) {
  switch (operand.file) {
  case File::Temporary:
    return m_temporaries[operand.index];
  case File::Attribute: {
    Vec &value = m_attributes[operand.index];
    if (isEmpty(value))
      value = m_hooks.attribute(operand.index, m_live.attributes[operand.index]);
    return value;
  }
  case File::Parameter:
    return operand.relative ? m_hooks.relative(operand.index, address(operand), registerMask)
                            : row(operand.index);
  case File::Output:
  case File::Address:
    break; // never read
  }
  return {};
}

Vec Walk::fetch(const Operand &operand, unsigned mask, unsigned registerMask) {
  const Vec from = registerMask != 0 ? source(operand, registerMask) : Vec{};
  Vec value = {};
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(mask >> i & 1))
      continue;
    const Select select = operand.swizzle[i];
    value[i] = select == Select::Zero  ? nullptr
               : select == Select::One ? m_code.splat(1.0f)
                                       : from[std::size_t(select)];
    if (!value[i])
      value[i] = m_code.splat(0.0f);
    if (operand.negate >> i & 1)
      value[i] = m_code.ir.CreateFNeg(value[i]);
  }
  return value;
}

void Walk::step(std::size_t index, const Instruction &instruction) {
  const ir::OpInfo &row = ir::info(instruction.op);
  OperandValues operands = {};
  for (int i = 0; i < row.operandCount(); ++i)
    operands[std::size_t(i)] =
        fetch(instruction.src[std::size_t(i)], ir::operandMask(instruction, i),
              ir::registerMask(instruction, i));
  if (row.has(ir::Flow))
    return flow(index, instruction, operands[0]);
  if (row.has(ir::Kills))
    return kill(kills(m_code, operands[0]));
  if (instruction.op == ir::Opcode::Arl) {
    Value *&address = m_addresses[instruction.dst.index];
    address = masked(
        addressOf(operands[0][0]), address ? address : m_code.splat(0),
        m_kept.empty() ? std::uint8_t(0) : m_kept.back().addresses[instruction.dst.index], 0);
    return;
  }
  const unsigned needed = instruction.dst.mask;
  const bool derives = instruction.op == ir::Opcode::Ddx || instruction.op == ir::Opcode::Ddy;
  write(instruction.dst, row.has(ir::Texture) ? m_hooks.texture(instruction, operands, needed)
                         : derives            ? derivative(instruction, operands)
                                              : apply(m_code, instruction.op, operands, needed,
                                                      facts(instruction), m_numerics, m_program.language));
}

void Walk::write(const ir::Destination &dst, const Vec &value) {
  const bool output = dst.file == File::Output;
  Vec &target = output ? m_results.outputs[dst.index] : m_temporaries[dst.index];
  std::uint8_t kept = 0;
  if (!m_kept.empty())
    kept = (output ? m_kept.back().outputs : m_kept.back().temporaries)[dst.index];
  for (std::size_t i = 0; i < 4; ++i)
    if (dst.mask >> i & 1)
      target[i] = masked(dst.saturate ? m_code.saturate(value[i]) : value[i], target[i], kept, i);
}

Value *Walk::masked(Value *value, Value *before, std::uint8_t kept, std::size_t component) {
  if (!(kept >> component & 1))
    return value;
  return m_code.select(m_loops->running(), value, before ? before : m_code.splat(0.0f));
}

void Walk::kill(Value *lanes) {
  if (!m_loops)
    return m_hooks.kill(lanes);
  if (Value *const running = m_loops->running())
    lanes = m_code.ir.CreateAnd(lanes, running);
  m_killed = m_killed ? m_code.ir.CreateOr(m_killed, lanes) : lanes;
}

/// Returns DDX or DDY. Without quads, the result is that of apply().
Vec Walk::derivative(const Instruction &instruction, const OperandValues &operands) {
  const unsigned needed = instruction.dst.mask;
  Value *const running = m_loops ? m_loops->running() : nullptr;
  Vec value = {};
  const bool quads = m_hooks.hasQuads();
  if (!quads || running)
    value = apply(m_code, instruction.op, operands, needed, {}, m_numerics);
  if (!quads)
    return value;
  Value *const whole = running ? wholeQuads(m_code, running) : nullptr;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!(needed >> i & 1))
      continue;
    Value *const change = changeInQuad(m_code, operands[0][i], instruction.op == ir::Opcode::Ddy);
    value[i] = whole ? m_code.select(whole, change, value[i]) : change;
  }
  return value;
}

/// Starts a program with loops. All inputs are read before the code, because a value first read
/// inside a loop would not be available after it.
void Walk::prepareLoops() {
  Value *const wanted = m_hooks.wanted();
  m_loops.emplace(m_code, m_program, wanted ? wanted : llvm::Constant::getAllOnesValue(m_code.i1));
  for (std::size_t i = 0; i < m_attributes.size(); ++i)
    if (m_live.attributes[i] != 0)
      m_attributes[i] = m_hooks.attribute(int(i), m_live.attributes[i]);
  for (std::size_t i = 0; i < m_parameters.size(); ++i)
    if (m_live.parameters[i] != 0)
      (void)row(std::uint16_t(i));
}

void Walk::flow(std::size_t index, const Instruction &instruction, const Vec &operand) {
  switch (instruction.op) {
  case ir::Opcode::Rep:
    beginLoop(index, operand[0]);
    break;
  case ir::Opcode::Endrep:
    m_loops->end();
    m_kept.pop_back();
    m_ranges.forget();
    break;
  default: // BRK
    m_loops->leave(m_code.ir.CreateFCmpUNE(operand[0], m_code.splat(0.0f)));
  }
  m_hooks.setRunning(m_loops->running());
}

void Walk::beginLoop(std::size_t index, Value *count) {
  analysis::RegisterMasks kept = m_live.kept.at(index);
  if (!m_kept.empty())
    analysis::add(kept, m_kept.back());
  m_kept.push_back(std::move(kept));
  m_loops->begin(count, changedIn(index));
  m_ranges.forget();
}

/// Returns the live values that the loop beginning there writes, each component once.
std::vector<LoopSlot> Walk::changedIn(std::size_t begin) {
  analysis::RegisterMasks open = m_kept.back(); // components that are not slots yet
  std::vector<LoopSlot> slots;
  const auto add = [&](Vec &target, std::uint8_t &left, std::uint8_t written) {
    for (std::size_t i = 0; i < 4; ++i)
      if (left & written & (1u << i))
        slots.push_back({&target[i], m_code.splat(0.0f)});
    left = std::uint8_t(left & ~written);
  };
  bool kills = false;
  std::size_t depth = 0;
  for (std::size_t i = begin;; ++i) {
    const Instruction &instruction = m_program.code[i];
    depth += instruction.op == ir::Opcode::Rep ? 1 : 0;
    if (instruction.op == ir::Opcode::Endrep && --depth == 0)
      break;
    const ir::OpInfo &row = ir::info(instruction.op);
    kills |= row.has(ir::Kills);
    if (!row.hasDestination() || m_live.written[i] == 0)
      continue;
    const ir::Destination &dst = instruction.dst;
    if (dst.file == File::Output) {
      add(m_results.outputs[dst.index], open.outputs[dst.index], m_live.written[i]);
    } else if (dst.file == File::Temporary) {
      add(m_temporaries[dst.index], open.temporaries[dst.index], m_live.written[i]);
    } else if (open.addresses[dst.index] != 0) {
      slots.push_back({&m_addresses[dst.index], m_code.splat(0)});
      open.addresses[dst.index] = 0;
    }
  }
  if (kills)
    slots.push_back({&m_killed, llvm::Constant::getNullValue(m_code.i1)});
  return slots;
}
} // namespace

ProgramResults writeProgram(Code &code, const ir::Program &program, Numerics numerics,
                            ProgramHooks &hooks) {
  return Walk(code, program, numerics, hooks).run();
}

} // namespace arbiter::fp::llvm_back
