// Whole programs against the interpreter, to the bit: where an opcode's result is an approximation,
// the interpreter is given the machine code's own value of that one opcode.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>

#include "fp_compiler/back/glsl/known.h"
#include "fp_compiler/back/llvm/test_machine.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp::llvm_back {
namespace {

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

/// Single opcodes as machine code.
class Functions {
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

struct Expected {
  ir::Evaluation evaluation;
  /// A result is the least normal number: the processor may have made a zero of it, as it finds
  /// one too small before it is rounded to a denormal.
  bool edge = false;
};

Expected expectedOf(const ir::Program &program, Numerics numerics,
                    const TestMachine::Attributes &attributes, const std::vector<Vec4> &parameters,
                    Functions &functions) {
  Expected expected;
  ir::Inputs inputs;
  inputs.attributes = attributes;
  inputs.numerics = numerics;
  inputs.parameter = [&](const ir::Parameter &wanted) {
    return parameters[std::size_t(&wanted - program.parameters.data())];
  };
  inputs.texture = [](const ir::Sample &sample) {
    return Vec4{sample.coordinate[0], sample.coordinate[1], sample.coordinate[2], sample.bias};
  };
  ir::Operands last = {};
  inputs.operands = [&](const ir::Instruction &, ir::Operands &operands) { last = operands; };
  inputs.result = [&](const ir::Instruction &instruction, Vec4 &value) {
    if (approximates(instruction.op)) {
      value = functions(instruction.op, last);
      for (float &component : value)
        component = ir::flushed(component);
    }
    for (const float component : value)
      expected.edge |= std::fabs(component) == 0x1p-126f;
  };
  expected.evaluation = ir::evaluate(program, inputs);
  return expected;
}

/// Numbers for attributes and rows; of a wild program one in four is special.
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

/// Keeps attributes to what is taken of them whatever the application does (glsl/known.h).
void keepToKnown(const ir::Program &program, Numerics numerics,
                 TestMachine::Attributes &attributes) {
  for (std::size_t i = 0; i < attributes.size(); ++i)
    for (int c = 0; c < 4; ++c) {
      float &value = attributes[i][std::size_t(c)];
      const glsl::Known known =
          glsl::knownAttribute(program.attributes[i], program.language, c, numerics);
      if (known.number)
        value = std::isnan(value) ? known.lo : std::clamp(value, known.lo, known.hi);
    }
}

struct Tally {
  int compared = 0, edges = 0, killed = 0;
};

/// Runs the program on made-up numbers and compares every component that counts.
void compare(const ir::Program &program, Numerics numerics, const std::string &cpu,
             std::uint64_t seed, bool wild, Functions &functions, Tally &tally) {
  testing::Random random(seed * 977 + 5);
  const TestMachine machine(program, numerics, cpu);
  ASSERT_EQ(machine.reason(), "");
  std::vector<Vec4> parameters = numbers(random, program.parameters.size(), wild);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (program.parameters[i].kind == ir::ParameterKind::Constant)
      parameters[i] = program.parameters[i].constant;
  std::vector<TestMachine::Attributes> lanes;
  for (int i = 0; i < 16; ++i) {
    lanes.push_back(numbers(random, program.attributes.size(), wild));
    keepToKnown(program, numerics, lanes.back());
  }
  const auto results = machine.run(lanes, parameters);
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    const auto [expected, edge] = expectedOf(program, numerics, lanes[lane], parameters, functions);
    if (edge) {
      ++tally.edges;
      continue;
    }
    ASSERT_EQ(results[lane].killed, expected.killed) << "seed " << seed << "\n"
                                                     << ir::print(program);
    if (expected.killed) {
      ++tally.killed;
      continue;
    }
    for (std::size_t o = 0; o < program.outputs.size(); ++o)
      for (std::size_t c = 0; c < 4; ++c) {
        if (!(ir::resultMask(program.outputs[o].kind) >> c & 1))
          continue;
        ++tally.compared;
        const float actual = ir::flushed(results[lane].outputs[o][c]);
        ASSERT_TRUE(testing::sameBits(actual, expected.outputs[o][c]))
            << "seed " << seed << ", o" << o << "[" << c << "] is " << actual << ", not "
            << expected.outputs[o][c] << ", lane " << lane << "\n"
            << ir::print(program);
      }
  }
}

ir::Program generated(std::uint64_t seed, bool vertex, bool wild) {
  testing::RandomOptions options;
  options.wild = wild;
  options.maxInstructions = 24;
  ir::Program program =
      vertex ? testing::randomVertexProgram(seed, options) : testing::randomProgram(seed, options);
  // What the options add is the caller's, not the walk's.
  program.options.fog = ir::FogMode::None;
  program.options.colorSum = false;
  return program;
}

class ProgramTest : public ::testing::TestWithParam<std::tuple<std::string, Numerics>> {};

TEST_P(ProgramTest, GeneratedProgramsAgreeToTheBit) {
  const auto &[cpu, numerics] = GetParam();
  Functions functions(numerics, cpu);
  Tally tally;
  constexpr std::uint64_t kPrograms = 150;
  for (std::uint64_t seed = 0; seed < kPrograms && !HasFatalFailure(); ++seed) {
    const bool vertex = seed % 3 == 0, wild = seed % 2 == 1;
    ir::Program program = generated(seed, vertex, wild);
    if (seed % 5 == 0)
      opt::run(program, numerics);
    compare(program, numerics, cpu, seed, wild, functions, tally);
  }
  EXPECT_GT(tally.compared, 10000);
  EXPECT_LT(tally.edges, tally.compared / 40) << "most of the test is left out";
}

INSTANTIATE_TEST_SUITE_P(All, ProgramTest,
                         ::testing::Combine(::testing::ValuesIn(testedCpus()),
                                            ::testing::Values(Numerics::Host, Numerics::Legacy)),
                         [](const auto &param) {
                           const std::string &cpu = std::get<0>(param.param);
                           return (cpu.empty() ? std::string("host") : cpu) +
                                  (std::get<1>(param.param) == Numerics::Host ? "Host" : "Legacy");
                         });

/// One lane of a program built here, on this processor.
TestMachine::Result lane(const ir::Program &program, const TestMachine::Attributes &attributes,
                         const std::vector<Vec4> &parameters = {}) {
  const TestMachine machine(program, Numerics::Host, "");
  EXPECT_EQ(machine.reason(), "");
  return machine.run({attributes}, parameters)[0];
}

constexpr Vec4 kNumbers = {1, 2, 3, 4};

TEST(Program, OperandsAreReadBeforeAnythingIsWritten) {
  ir::Builder b;
  const ir::Target t = b.temporary();
  b.op(Opcode::Mov, t, {b.attribute(ir::AttributeKind::TexCoord)});
  b.op(Opcode::Mov, t.mask("xy"), {t.read().swz("yxzw")});
  b.op(Opcode::Mov, b.color(), {t.read()});
  EXPECT_EQ(lane(b.program(), {kNumbers}).outputs[0], (Vec4{2, 1, 3, 4}));
}

TEST(Program, WhatIsNotWrittenIsZero) {
  ir::Builder b;
  const ir::Target t = b.temporary();
  b.op(Opcode::Mov, t.mask("y"), {b.attribute(ir::AttributeKind::TexCoord)});
  b.op(Opcode::Add, b.color().mask("xyz"), {t.read(), b.constant(0.5f)});
  EXPECT_EQ(lane(b.program(), {kNumbers}).outputs[0], (Vec4{0.5f, 2.5f, 0.5f, 0}));
}

TEST(Program, KilDiscardsBelowZeroOnly) {
  ir::Builder b;
  b.kil(b.attribute(ir::AttributeKind::TexCoord));
  b.op(Opcode::Mov, b.color(), {b.constant(1)});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(lane(b.program(), {kNumbers}).killed);
  EXPECT_FALSE(lane(b.program(), {{-0.0f, nan, 0, 1}}).killed);
  EXPECT_FALSE(lane(b.program(), {{-1e-40f, 0, 0, 1}}).killed);
  EXPECT_TRUE(lane(b.program(), {{1, 1, 1, -1e-30f}}).killed);
}

TEST(Program, SaturationMakesZeroOfNan) {
  ir::Builder b;
  b.op(Opcode::Mov, b.color().sat(), {b.attribute(ir::AttributeKind::TexCoord)});
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(lane(b.program(), {{nan, -1, 0.25f, 7}}).outputs[0], (Vec4{0, 0, 0.25f, 1}));
}

TEST(Program, TexturesSeeTheirCoordinates) {
  ir::Builder b;
  const ir::Source at = b.attribute(ir::AttributeKind::TexCoord);
  b.tex(Opcode::Txp, b.color(0), at, 0, ir::TexTarget::Tex3D);
  b.tex(Opcode::Txb, b.color(1), at.swz("wzyx"), 1, ir::TexTarget::Tex2D);
  b.tex(Opcode::Tex, b.color(2).mask("xw"), -at, 2, ir::TexTarget::Tex1D);
  const auto outputs = lane(b.program(), {{1, 2, 3, 2}}).outputs;
  EXPECT_EQ(outputs[0], (Vec4{0.5f, 1, 1.5f, 0}));
  EXPECT_EQ(outputs[1], (Vec4{2, 3, 0, 1}));
  EXPECT_EQ(outputs[2], (Vec4{-1, 0, 0, 0}));
}

} // namespace
} // namespace arbiter::fp::llvm_back
