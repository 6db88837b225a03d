#include "fp_compiler/testing/random_ati.h"

#include <algorithm>
#include <optional>
#include <utility>
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
      // After a colour operation, an alpha operation would join its pair.
      const bool alphaAlone = i == 0 || pass.pairs[i - 1].alpha;
      const bool result = m_options.defined && m_last && i + 1 == pass.pairCount;
      pass.pairs[i] = result ? resultPair() : pair(alphaAlone);
      markWritten(pass.pairs[i]);
    }
  }

  /// Returns a pair that writes all of r0.
  Pair resultPair() {
    Pair pair;
    do {
      pair.color = operation(false, 7);
      pair.color->mask = 7;
      pair.color->destination = 0;
      pair.alpha = *pair.color;
    } while (!validWhole(*pair.color) || (m_options.peer && readsResult(*pair.alpha, *pair.color)));
    return pair;
  }

  void markWritten(const Pair &pair) {
    if (pair.color)
      m_written[pair.color->destination] |= pair.color->mask;
    if (pair.alpha)
      m_written[pair.alpha->destination] |= 8;
  }

  /// True if the operation may also be an alpha operation with the same arguments.
  bool validWhole(const Operation &op) const {
    for (int i = 0; i < argumentCount(op.op); ++i) {
      const Argument &a = op.arguments[std::size_t(i)];
      const bool alpha = a.replicate == Replicate::None && !isDot(op.op);
      if (a.source == Source::Secondary && a.replicate == Replicate::None)
        return false;
      if (m_options.defined && alpha && a.source == Source::Register && !(m_written[a.index] & 8))
        return false;
    }
    return true;
  }

  void setups(Pass &pass, int number) {
    // The API form requires one choice of coordinates for a source in a pass (AFS:716).
    std::array<Coordinates, kTextTexCoords + kRegisters> chosen;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      const bool tame = m_options.tameDivisors && i >= kTextTexCoords;
      const bool divided = m_random.chance(25) && !tame;
      const bool q = i < kTextTexCoords && m_usesQ[i];
      chosen[i] = q ? (divided ? Coordinates::StqDq : Coordinates::Stq)
                    : (divided ? Coordinates::StrDr : Coordinates::Str);
    }
    const std::array<std::uint8_t, kRegisters> before = std::exchange(m_written, {});
    const auto always = std::size_t(m_random.below(kRegisters));
    for (std::size_t i = 0; i < kRegisters; ++i) {
      if (i != always && m_random.chance(35))
        continue;
      Setup &setup = pass.setups[i];
      setup.fromRegister = number > 0 && m_random.chance(50);
      setup.source = std::uint8_t(m_random.below(setup.fromRegister ? kRegisters : kTextTexCoords));
      if (m_options.defined && setup.fromRegister && (before[setup.source] & 7) != 7)
        setup.fromRegister = false;
      setup.coordinates = chosen[setup.source + (setup.fromRegister ? kTextTexCoords : 0)];
      const bool wild =
          (m_options.tameDivisors && setup.coordinates == Coordinates::StrDr) ||
          (m_options.defined && (i == 2 || i == 3) && setup.coordinates >= Coordinates::StrDr);
      const bool sample = !wild && m_options.sampledUnits >> i & 1 && m_random.chance(60);
      setup.kind = sample ? SetupKind::SampleMap : SetupKind::PassTexCoord;
      m_written[i] = sample ? 0xF : 7;
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
    if (m_options.peer && pair.alpha && pair.color && readsResult(*pair.alpha, *pair.color))
      pair.alpha.reset();
    return pair;
  }

  static bool readsResult(const Operation &alpha, const Operation &color) {
    return std::any_of(alpha.arguments.begin(), alpha.arguments.end(), [&](const Argument &a) {
      return a.source == Source::Register && a.index == color.destination;
    });
  }

  /// Returns the alpha half of an instruction that writes all components, or the copy of a dot
  /// product.
  std::optional<Operation> whole(const Operation &color) {
    if (!validWhole(color))
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
    while ((alpha && isDot(op.op)) || (m_options.peer && op.op == Op::Dot2Add));
    // Writes r0 often, because it is the result: a shader that seldom writes it tests little.
    op.destination = std::uint8_t(m_random.chance(30) ? 0 : m_random.below(kRegisters));
    if (!alpha)
      op.mask = m_random.chance(50) ? 7 : mask;
    op.scale = m_random.chance(50) ? Scale::None : Scale(m_random.below(7));
    op.saturate = m_random.chance(40);
    std::vector<std::uint8_t> constants;
    for (int i = 0; i < argumentCount(op.op); ++i)
      op.arguments[std::size_t(i)] = argument(alpha ? 8 : op.mask, op.op, i, constants);
    return op;
  }

  /// Returns the components that an operation reads of its argument.
  static std::uint8_t components(std::uint8_t mask, Op op, int at) {
    switch (op) {
    case Op::Dot3:
      return 7;
    case Op::Dot4:
      return 0xF;
    case Op::Dot2Add:
      return at < 2 ? 3 : 4;
    default:
      return mask;
    }
  }

  /// Returns a register that has these components written, if there is one.
  std::optional<std::uint8_t> readable(std::uint8_t needed) {
    const auto first = std::uint8_t(m_random.below(kRegisters));
    for (std::uint8_t i = 0; i < kRegisters; ++i) {
      const auto reg = std::uint8_t((first + i) % kRegisters);
      if (!m_options.defined || (m_written[reg] & needed) == needed)
        return reg;
    }
    return {};
  }

  Argument argument(std::uint8_t mask, Op op, int at, std::vector<std::uint8_t> &constants) {
    Argument argument;
    argument.replicate = m_random.chance(50) ? Replicate::None : Replicate(1 + m_random.below(4));
    const std::uint8_t needed = argument.replicate == Replicate::None
                                    ? components(mask, op, at)
                                    : std::uint8_t(1 << (int(argument.replicate) - 1));
    const bool factor = m_options.defined && op == Op::Lerp && at == 0;
    const std::optional<std::uint8_t> reg = readable(needed);
    int kind = m_random.below(20);
    if (kind < 10 && (!reg || factor))
      kind += 10;
    if (kind < 10) {
      argument.source = Source::Register;
      argument.index = *reg;
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
    // The secondary colour has no alpha (ATFS:843).
    if (argument.source == Source::Secondary) {
      const bool whole = argument.replicate == Replicate::None && (mask == 8 || op == Op::Dot4);
      if (whole || argument.replicate == Replicate::Alpha)
        argument.replicate = Replicate(1 + m_random.below(3));
    }
    argument.complement = m_random.chance(20);
    argument.bias = !factor && m_random.chance(20);
    argument.twice = !factor && m_random.chance(20);
    argument.negate = !factor && m_random.chance(20);
    return argument;
  }

  Random m_random;
  const RandomAtiOptions &m_options;
  Shader m_shader;
  std::array<bool, kTextTexCoords> m_usesQ = {};
  std::array<std::uint8_t, kRegisters> m_written = {}; ///< components written in the current pass
  bool m_last = false;
};
} // namespace

Shader randomAtiShader(std::uint64_t seed, const RandomAtiOptions &options) {
  return Generator(seed, options).run();
}

} // namespace arbiter::fp::testing
