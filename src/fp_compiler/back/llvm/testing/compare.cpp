#include "fp_compiler/back/llvm/testing/compare.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "fp_compiler/analysis/value_range.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::llvm_back {

using ir::Opcode;
using ir::Vec4;

bool approximates(Opcode op) {
  switch (op) {
  case Opcode::Cos:
  case Opcode::Sin:
  case Opcode::Scs:
  case Opcode::Ex2:
  case Opcode::Exp:
  case Opcode::Lg2:
  case Opcode::Log:
  case Opcode::Pow:
  case Opcode::Lit:
  case Opcode::Rsq:
    return true;
  default:
    return false;
  }
}

namespace {

struct Expected {
  ir::Evaluation evaluation;
  /// A result is the least normal number. The processor may flush it to zero, because it detects
  /// underflow before rounding.
  bool edge = false;
};

using Function = std::function<Vec4(Opcode, const ir::Operands &)>;

/// The interpreter's inputs for one lane. It must not move, because the functions refer to it.
struct Lane {
  Lane(const ir::Program &program, Numerics numerics, const TestMachine::Attributes &attributes,
       const std::vector<Vec4> &parameters, const Function &function) {
    inputs.attributes = attributes;
    inputs.numerics = numerics;
    inputs.parameter = [&](const ir::Parameter &wanted) {
      return parameters[std::size_t(&wanted - program.parameters.data())];
    };
    inputs.texture = [](const ir::Sample &sample) {
      const float fourth = sample.gradient ? sample.gradient->x[0] - sample.gradient->y[0]
                           : sample.lod    ? *sample.lod
                                           : sample.bias;
      return Vec4{sample.coordinate[0], sample.coordinate[1], sample.coordinate[2], fourth};
    };
    inputs.operands = [this](const ir::Instruction &, ir::Operands &operands) { last = operands; };
    inputs.result = [this, &function](const ir::Instruction &instruction, Vec4 &value) {
      if (approximates(instruction.op)) {
        value = function(instruction.op, last);
        for (float &component : value)
          component = ir::flushed(component);
      }
      for (const float component : value)
        edge |= std::fabs(component) == 0x1p-126f;
    };
  }
  Lane(const Lane &) = delete;
  Lane &operator=(const Lane &) = delete;

  ir::Inputs inputs;
  ir::Operands last = {};
  bool edge = false;
};

bool hasDerivatives(const ir::Program &program) {
  return std::any_of(program.code.begin(), program.code.end(), [](const auto &instruction) {
    return instruction.op == Opcode::Ddx || instruction.op == Opcode::Ddy;
  });
}

/// Returns the expected results of all lanes.
std::vector<Expected> expectedOf(const ir::Program &program, Numerics numerics,
                                 const std::string &cpu,
                                 const std::vector<TestMachine::Attributes> &attributes,
                                 const std::vector<Vec4> &parameters, const Function &function) {
  std::vector<std::unique_ptr<Lane>> lanes;
  lanes.reserve(attributes.size());
  for (const TestMachine::Attributes &each : attributes)
    lanes.push_back(std::make_unique<Lane>(program, numerics, each, parameters, function));
  std::vector<Expected> expected(lanes.size());
  const bool quads = hasDerivatives(program);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    if (!quads) {
      expected[lane].evaluation = ir::evaluate(program, lanes[lane]->inputs);
      continue;
    }
    const std::array<std::size_t, 4> quad = quadOf(cpu, lane);
    if (quad[0] != lane)
      continue; // already evaluated with its quad
    const std::array<ir::Evaluation, 4> values =
        ir::evaluateQuad(program, {lanes[quad[0]]->inputs, lanes[quad[1]]->inputs,
                                   lanes[quad[2]]->inputs, lanes[quad[3]]->inputs});
    for (std::size_t i = 0; i < 4; ++i)
      expected[quad[i]].evaluation = values[i];
  }
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    expected[lane].edge = lanes[lane]->edge;
    if (quads)
      for (const std::size_t neighbour : quadOf(cpu, lane))
        expected[lane].edge |= lanes[neighbour]->edge;
  }
  return expected;
}

/// Returns numbers for attributes and rows; for a wild program one in four is special.
std::vector<Vec4> numbers(testing::Random &random, std::size_t count, bool wild) {
  std::vector<Vec4> result(count);
  for (Vec4 &vector : result)
    for (float &component : vector)
      component =
          wild && random.chance(25)
              ? testing::kSpecials[std::size_t(random.below(int(testing::kSpecials.size())))]
              : random.real(-2, 2);
  return result;
}

/// Clamps attributes to the ranges that the compiler assumes (analysis/value_range.h).
void keepToRanges(const ir::Program &program, Numerics numerics,
                  TestMachine::Attributes &attributes) {
  for (std::size_t i = 0; i < attributes.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      float &value = attributes[i][std::size_t(c)];
      const analysis::ValueRange known =
          analysis::rangeOfAttribute(program.attributes[i], program.language, c, numerics);
      if (known.number)
        value = std::isnan(value) ? known.lo : std::clamp(value, known.lo, known.hi);
    }
}

/// Returns the first output component that differs, as text; empty if none does.
std::string difference(const ir::Program &program, const TestMachine::Result &actual,
                       const ir::Evaluation &expected, int &compared) {
  for (std::size_t o = 0; o < program.outputs.size(); ++o)
    for (std::size_t c = 0; c < 4; ++c) {
      if (!(ir::resultMask(program.outputs[o].kind) >> c & 1))
        continue;
      ++compared;
      // A result of PK* may have the bits of a denormal.
      const bool bits = ir::flushed(expected.outputs[o][c]) != expected.outputs[o][c];
      const float value = bits ? actual.outputs[o][c] : ir::flushed(actual.outputs[o][c]);
      if (!testing::sameBits(value, expected.outputs[o][c]))
        return "o" + std::to_string(o) + "[" + std::to_string(c) + "] is " + std::to_string(value) +
               ", not " + std::to_string(expected.outputs[o][c]);
    }
  return {};
}
} // namespace

/// Runs single opcodes as machine code.
class Comparison::Functions {
public:
  Functions(Numerics numerics, std::string cpu) : m_numerics(numerics), m_cpu(std::move(cpu)) {}

  Vec4 operator()(Opcode op, const ir::Operands &operands) {
    auto &entry = m_entries[op];
    if (!entry) {
      entry = std::make_unique<Entry>();
      ir::Builder b(ir::Language::ArbVertex);
      const ir::Target result = b.result(ir::OutputKind::FrontPrimary);
      const ir::Source first = b.attribute(ir::AttributeKind::Generic, 1);
      const ir::Source second = b.attribute(ir::AttributeKind::Generic, 2);
      const auto operand = [&](int i, const ir::Source &source) {
        return ir::info(op).shapes[i] == 'S' ? source.swz("x") : source;
      };
      if (ir::info(op).operandCount() == 1)
        b.op(op, result, {operand(0, first)});
      else
        b.op(op, result, {operand(0, first), operand(1, second)});
      entry->program = b.take();
      entry->machine = std::make_unique<TestMachine>(entry->program, m_numerics, m_cpu);
    }
    return entry->machine->run({{operands[0], operands[1]}}, {})[0].outputs[0];
  }

private:
  struct Entry {
    ir::Program program;
    std::unique_ptr<TestMachine> machine;
  };
  Numerics m_numerics;
  std::string m_cpu;
  std::map<Opcode, std::unique_ptr<Entry>> m_entries;
};

Comparison::Comparison(Numerics numerics, const std::string &cpu)
    : m_numerics(numerics), m_cpu(cpu), m_functions(std::make_unique<Functions>(numerics, cpu)) {}
Comparison::~Comparison() = default;

std::string Comparison::run(const ir::Program &given, std::uint64_t seed, bool wild) {
  ir::Program program = given;
  program.options.fog = ir::FogMode::None;
  program.options.colorSum = false;
  const TestMachine machine(program, m_numerics, m_cpu);
  if (!machine.reason().empty())
    return machine.reason();
  testing::Random random(seed * 977 + 5);
  std::vector<Vec4> parameters = numbers(random, program.parameters.size(), wild);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (program.parameters[i].kind == ir::ParameterKind::Constant)
      parameters[i] = program.parameters[i].constant;
  std::vector<TestMachine::Attributes> lanes;
  for (int i = 0; i < 16; ++i) {
    lanes.push_back(numbers(random, program.attributes.size(), wild));
    keepToRanges(program, m_numerics, lanes.back());
  }
  const auto results = machine.run(lanes, parameters);
  const Function function = std::ref(*m_functions);
  const std::vector<Expected> all =
      expectedOf(program, m_numerics, m_cpu, lanes, parameters, function);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    const auto &[expected, edge] = all[lane];
    if (edge) {
      ++edges;
      continue;
    }
    std::string problem;
    if (results[lane].killed != expected.killed)
      problem = expected.killed ? "it is not killed" : "it is killed";
    else if (!expected.killed)
      problem = difference(program, results[lane], expected, compared);
    killed += expected.killed;
    if (!problem.empty())
      return "lane " + std::to_string(lane) + ": " + problem + "\n" + ir::print(program);
  }
  return {};
}

} // namespace arbiter::fp::llvm_back
