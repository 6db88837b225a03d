#include "fp_compiler/testing/random_ati.h"

#include <algorithm>
#include <vector>

#include "fp_compiler/testing/random.h"

namespace arbiter::fp::testing {

using namespace ati;

namespace {
constexpr int kTextTexCoords = 6; ///< t0 to t5

class Generator {
public:
  Generator(std::uint64_t seed, const RandomAtiOptions &options)
      : m_random(seed), m_options(options) {}

  Shader run() {
    for (Constant &constant : m_shader.constants)
      constant = randomConstant();
    for (bool &q : m_usesQ)
      q = m_random.chance(50);
    m_shader.passCount = std::uint8_t(m_random.chance(40) ? 1 : 2);
    for (int i = 0; i < m_shader.passCount; ++i)
      pass(i);
    return m_shader;
  }

private:
  Constant randomConstant() {
    Constant constant;
    constant.kind = ConstantKind(m_random.below(3));
    constant.index = std::uint8_t(m_random.below(kConstants));
    if (constant.kind == ConstantKind::Value)
      for (float &value : constant.value)
        value = float(m_random.below(65)) / 64.0f;
    return constant;
  }

  void pass(int number) {
    m_last = number + 1 == m_shader.passCount;
    Pass &pass = m_shader.passes[std::size_t(number)];
    setups(pass, number);
    const int most = m_random.chance(20) ? kMaxPairs : 5;
    pass.pairCount = std::uint8_t(1 + m_random.below(most));
    for (std::size_t i = 0; i < pass.pairCount; ++i) {
      // A colour operation and the alpha operation after it would be one pair.
      const bool alphaAlone = i == 0 || pass.pairs[i - 1].alpha;
      pass.pairs[i] = pair(alphaAlone);
    }
  }

  void setups(Pass &pass, int number) {
    // One choice of coordinates for a source in a pass: the API form asks for that (AFS:716).
    std::array<Coordinates, kTextTexCoords + kRegisters> chosen;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const bool divided = m_random.chance(25);
      const bool q = i < kTextTexCoords && m_usesQ[i];
      chosen[i] = q ? (divided ? Coordinates::StqDq : Coordinates::Stq)
                    : (divided ? Coordinates::StrDr : Coordinates::Str);
    }
    const auto always = std::size_t(m_random.below(kRegisters));
    for (std::size_t i = 0; i < kRegisters; ++i) {
      if (i != always && m_random.chance(35))
        continue;
      Setup &setup = pass.setups[i];
      setup.fromRegister = number > 0 && m_random.chance(50);
      setup.source = std::uint8_t(m_random.below(setup.fromRegister ? kRegisters : kTextTexCoords));
      setup.coordinates = chosen[setup.source + (setup.fromRegister ? kTextTexCoords : 0)];
      const bool wild = m_options.tameSamples && setup.coordinates == Coordinates::StrDr;
      const bool sample = !wild && m_options.sampledUnits >> i & 1 && m_random.chance(60);
      setup.kind = sample ? SetupKind::SampleMap : SetupKind::PassTexCoord;
    }
  }

  Pair pair(bool alphaAlone) {
    Pair pair;
    const int shape = m_random.below(alphaAlone ? 10 : 8);
    if (shape < 8)
      pair.color = operation(false, std::uint8_t(1 + m_random.below(7)));
    if (shape >= 8)
      pair.alpha = operation(true, 0);
    if (shape < 3)
      pair.alpha = whole(*pair.color);
    else if (shape < 6 && pair.color->op != Op::Dot4)
      pair.alpha = operation(true, 0);
    return pair;
  }

  /// The alpha half of an instruction that writes all components, or a dot product's copy.
  std::optional<Operation> whole(const Operation &color) {
    for (int i = 0; i < argumentCount(color.op); ++i)
      if (color.arguments[std::size_t(i)].source == Source::Secondary &&
          color.arguments[std::size_t(i)].replicate == Replicate::None)
        return {};
    Operation alpha = color;
    alpha.mask = Operation().mask;
    if (isDot(alpha.op) && m_options.separateDots && m_random.chance(60)) {
      alpha.destination = std::uint8_t(m_random.below(kRegisters));
      alpha.scale = Scale(m_random.below(7));
      alpha.saturate = m_random.chance(50);
    }
    return alpha;
  }

  Operation operation(bool alpha, std::uint8_t mask) {
    Operation op;
    do
      op.op = Op(m_random.below(int(Op::Dot2Add) + 1));
    while (alpha && isDot(op.op));
    // r0 is the result: a shader that seldom writes it says little.
    op.destination = std::uint8_t(m_random.chance(30) ? 0 : m_random.below(kRegisters));
    if (!alpha)
      op.mask = m_random.chance(50) ? 7 : mask;
    op.scale = m_random.chance(50) ? Scale::None : Scale(m_random.below(7));
    op.saturate = m_random.chance(40);
    std::vector<std::uint8_t> constants;
    for (int i = 0; i < argumentCount(op.op); ++i)
      op.arguments[std::size_t(i)] = argument(alpha, op.op, constants);
    return op;
  }

  Argument argument(bool alpha, Op op, std::vector<std::uint8_t> &constants) {
    Argument argument;
    const int kind = m_random.below(20);
    if (kind < 10) {
      argument.source = Source::Register;
      argument.index = std::uint8_t(m_random.below(kRegisters));
    } else if (kind < 14) {
      argument.source = Source::Constant;
      argument.index = constants.size() == 2 ? constants[std::size_t(m_random.below(2))]
                                             : std::uint8_t(m_random.below(kConstants));
      if (std::find(constants.begin(), constants.end(), argument.index) == constants.end())
        constants.push_back(argument.index);
    } else if (kind < 18 && m_last) {
      argument.source = kind < 16 ? Source::Primary : Source::Secondary;
    } else {
      argument.source = m_random.chance(50) ? Source::Zero : Source::One;
    }
    argument.replicate = m_random.chance(50) ? Replicate::None : Replicate(1 + m_random.below(4));
    // The secondary colour has no alpha (ATFS:843).
    if (argument.source == Source::Secondary) {
      const bool whole = argument.replicate == Replicate::None && (alpha || op == Op::Dot4);
      if (whole || argument.replicate == Replicate::Alpha)
        argument.replicate = Replicate(1 + m_random.below(3));
    }
    argument.complement = m_random.chance(20);
    argument.bias = m_random.chance(20);
    argument.twice = m_random.chance(20);
    argument.negate = m_random.chance(20);
    return argument;
  }

  Random m_random;
  const RandomAtiOptions &m_options;
  Shader m_shader;
  std::array<bool, kTextTexCoords> m_usesQ = {};
  bool m_last = false;
};
} // namespace

Shader randomAtiShader(std::uint64_t seed, const RandomAtiOptions &options) {
  return Generator(seed, options).run();
}

} // namespace arbiter::fp::testing
