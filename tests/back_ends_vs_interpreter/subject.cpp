#include "subject.h"

#include <cmath>
#include <limits>

#include "fp_compiler/compiler.h"
#include "fp_compiler/fixed_function.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"
#include "fp_compiler/testing/random_nv.h"
#include "gl_host.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
Subject checked(fp::ir::Language language, std::string text, const fp::Limits &limits) {
  fp::CheckResult result = fp::checkProgram(language, text, {limits, fp::LimitPolicy::Enforce});
  std::string error = result.ok() ? "" : result.errorString(text);
  return {std::move(text), std::move(result.program), std::move(error)};
}

/// Returns a number that can be written: no numeral is infinite, and some hosts keep denormal
/// constants.
float spellable(float value) {
  if (std::isinf(value))
    return std::copysign(std::numeric_limits<float>::max(), value);
  return flushed(value);
}

/// Puts an infinity into many products of a program, and sometimes a zero into the other factor.
class Wild {
public:
  Wild(Program &program, std::uint64_t seed) : m_program(program), m_random(seed) {}

  void run() {
    const std::uint16_t coordinate = attribute();
    const Operand texcoord = {.file = File::Attribute, .index = coordinate};
    const Operand infinite = temporary("infinite"), zeros = temporary("zeros");
    for (Instruction &instruction : m_program.code) {
      if (info(instruction.op).has(Texture)) {
        instruction.op = Opcode::Tex;
        instruction.src[0] = texcoord;
      } else if (multiplies(instruction.op) && m_random.chance(40)) {
        const std::size_t factor = std::size_t(m_random.below(2));
        instruction.src[factor] = infinite;
        instruction.src[factor].negate = std::uint8_t(m_random.below(16));
        if (m_random.chance(70))
          instruction.src[1 - factor] = zeros;
      }
    }
    Instruction first = writing(Opcode::Rcp, infinite);
    first.src[0] = constant(0.0f);
    first.src[0].swizzle.fill(Select::X);
    Instruction second = writing(Opcode::Slt, zeros);
    second.src = {texcoord, constant(0.5f), {}};
    m_program.code.insert(m_program.code.begin(), {first, second});
  }

private:
  static bool multiplies(Opcode op) {
    switch (op) {
    case Opcode::Mul:
    case Opcode::Mad:
    case Opcode::Dp3:
    case Opcode::Dp4:
    case Opcode::Dph:
    case Opcode::Dst:
    case Opcode::Lrp:
    case Opcode::Xpd:
      return true;
    default:
      return false;
    }
  }
  std::uint16_t attribute() {
    m_program.attributes.push_back({AttributeKind::TexCoord, 7});
    return std::uint16_t(m_program.attributes.size() - 1);
  }
  Operand temporary(const char *name) {
    m_program.temporaries.push_back({name});
    return {.file = File::Temporary, .index = std::uint16_t(m_program.temporaries.size() - 1)};
  }
  Operand constant(float value) {
    m_program.parameters.push_back(
        {.kind = ParameterKind::Constant, .constant = {value, value, value, value}});
    return {.file = File::Parameter, .index = std::uint16_t(m_program.parameters.size() - 1)};
  }
  static Instruction writing(Opcode op, const Operand &target) {
    Instruction instruction;
    instruction.op = op;
    instruction.dst.file = File::Temporary;
    instruction.dst.index = target.index;
    instruction.dst.mask = 0xF;
    return instruction;
  }

  Program &m_program;
  fp::testing::Random m_random;
};

Subject atiUnder(const fp::Limits &limits, std::uint64_t seed, bool peer) {
  // Beyond unit 4 the scene has shadow textures, which these shaders do not compare. One shader of
  // four reads a register that it did not write.
  const fp::ati::Shader shader = fp::testing::randomAtiShader(
      seed,
      {.sampledUnits = 0x1F, .tameDivisors = true, .defined = peer || seed % 4 != 0, .peer = peer});
  Subject subject =
      checked(fp::ir::Language::AtiFragment, fp::testing::spell(shader, seed), limits);
  if (!subject.program)
    return subject;
  fp::testing::Random random(seed);
  fp::FixedFunction state;
  state.targets = fp::testing::kUnitTargets;
  // Without GLSL, clamping before these stages is host-dependent with float buffers.
  state.colorSum = !peer && random.chance(30);
  if (!peer && random.chance(30))
    state.fog = fp::ir::FogMode(1 + random.below(3));
  subject.program = fp::withFixedFunction(*std::move(subject.program), state);
  return subject;
}
} // namespace

fp::Limits suiteLimits() {
  fp::Limits limits;
  limits.api = {1024, 1024, 1024, 1024, 64, 256, 16, 2};
  limits.native = limits.api;
  limits.localParameters = limits.envParameters = 16;
  limits.textureCoords = limits.textureImageUnits = limits.textureUnits = 8;
  limits.programMatrices = 8;
  limits.drawBuffers = kColorBuffers;
  limits.nvOptions = 2;
  return limits;
}

Subject subjectOf(fp::ir::Language language, std::string text) {
  return checked(language, std::move(text), suiteLimits());
}

Subject arbSubject(std::uint64_t seed) {
  return subjectOf(Language::ArbFragment,
                   fp::testing::spell(fp::testing::randomProgram(seed), seed));
}

Subject vertexSubject(std::uint64_t seed) {
  return subjectOf(Language::ArbVertex,
                   fp::testing::spell(fp::testing::randomVertexProgram(seed), seed));
}

namespace {
Subject nvProgram(std::uint64_t seed, bool vertex, bool peer = false) {
  const NvOption option = seed % 2 == 0 ? NvOption::First : NvOption::Second;
  return subjectOf(vertex ? Language::ArbVertex : Language::ArbFragment,
                   fp::testing::randomNvProgram(
                       seed, {.vertex = vertex,
                              .option = option,
                              .vertexUnits = peer ? 1 : int(fp::testing::kUnitTargets.size()),
                              .peer = peer}));
}
} // namespace

Subject nvSubject(std::uint64_t seed) { return nvProgram(seed, false); }
Subject nvPeerSubject(std::uint64_t seed) { return nvProgram(seed, false, true); }
Subject nvVertexPeerSubject(std::uint64_t seed) { return nvProgram(seed, true, true); }
Subject nvVertexSubject(std::uint64_t seed) { return nvProgram(seed, true); }

Subject unwrittenSubject(std::uint64_t seed) {
  return subjectOf(Language::ArbFragment,
                   fp::testing::spell(fp::testing::randomProgram(seed, {.unwritten = true}), seed));
}

Subject unwrittenVertexSubject(std::uint64_t seed) {
  return subjectOf(
      Language::ArbVertex,
      fp::testing::spell(fp::testing::randomVertexProgram(seed, {.unwritten = true}), seed));
}

Subject wildSubject(std::uint64_t seed) {
  Program program = fp::testing::randomProgram(seed, {.wild = true});
  for (Parameter &parameter : program.parameters)
    for (float &value : parameter.constant)
      value = spellable(value);
  Wild(program, seed).run();
  return checked(Language::ArbFragment, fp::testing::spell(program, seed), suiteLimits());
}

Subject atiSubject(std::uint64_t seed) {
  fp::Limits limits = suiteLimits();
  limits.atiRegisterRange = seed % 2 ? 8 : 0;
  return atiUnder(limits, seed, false);
}

Subject atiSubjectOfHost(std::uint64_t seed) { return atiUnder(suiteLimits(), seed, false); }
Subject atiSubjectOfPeer(std::uint64_t seed) { return atiUnder(suiteLimits(), seed, true); }

} // namespace arbiter::differential
