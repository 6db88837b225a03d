#include <charconv>

#include "fp_compiler/testing/random.h"
#include "fp_compiler/testing/random_ati.h"

namespace arbiter::fp::testing {

using namespace ati;

namespace {
constexpr const char *kOps[] = {"MOV", "ADD",  "MUL", "SUB",  "DOT3",   "DOT4",
                                "MAD", "LERP", "CND", "CND0", "DOT2ADD"};
constexpr const char *kCoordinates[] = {".str", ".stq", ".str_dr", ".stq_dq"};
constexpr const char *kScales[] = {"", ".2x", ".4x", ".8x", ".half", ".quarter", ".eighth"};
constexpr const char *kReplicates[] = {"", ".r", ".g", ".b", ".a"};

std::string plain(float value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed);
  return std::string(digits, end.ptr);
}

class Speller {
public:
  Speller(const Shader &shader, std::uint64_t seed) : m_shader(shader), m_random(seed) {}

  std::string run() {
    m_text = "!!ATIfs1.0\n";
    constants();
    for (int i = 0; i < m_shader.passCount; ++i) {
      const Pass &pass = m_shader.passes[std::size_t(i)];
      line(i + 1 == m_shader.passCount ? "StartOutputPass;" : "StartPrelimPass;");
      for (std::size_t reg = 0; reg < pass.setups.size(); ++reg)
        setup(pass.setups[reg], reg);
      for (std::size_t j = 0; j < pass.pairCount; ++j)
        pair(pass.pairs[j]);
      line("EndPass;");
    }
    return m_text;
  }

private:
  void line(const std::string &text) {
    m_text += m_random.chance(10) ? "\t" + text : text;
    if (m_random.chance(8))
      m_text += " # " + std::to_string(m_random.below(1000)) + "; EndPass;";
    m_text += m_random.chance(5) ? "\r\n" : "\n";
  }

  void constants() {
    line("StartConstants;");
    for (std::size_t i = 0; i < m_shader.constants.size(); ++i) {
      const Constant &c = m_shader.constants[i];
      std::string value;
      switch (c.kind) {
      case ConstantKind::Env:
        value = "program.env[" + std::to_string(c.index) + "]";
        break;
      case ConstantKind::Local:
        value = "program.local[" + std::to_string(c.index) + "]";
        break;
      case ConstantKind::Value:
        value = "{ " + plain(c.value[0]) + ", " + plain(c.value[1]) + ", " + plain(c.value[2]) +
                ", " + plain(c.value[3]) + " }";
        break;
      }
      line("CONSTANT c" + std::to_string(i) + " = " + value + ";");
    }
    line("EndConstants;");
  }

  void setup(const Setup &setup, std::size_t reg) {
    if (setup.kind == SetupKind::None)
      return;
    line((setup.kind == SetupKind::SampleMap ? "SampleMap r" : "PassTexCoord r") +
         std::to_string(reg) + ", " + (setup.fromRegister ? "r" : "t") +
         std::to_string(setup.source) + kCoordinates[std::size_t(setup.coordinates)] + ";");
  }

  void pair(const Pair &pair) {
    if (pair.color && pair.alpha) {
      Operation same = *pair.color;
      same.mask = pair.alpha->mask;
      if (same == *pair.alpha && (isDot(same.op) || m_random.chance(80)))
        return statement(*pair.color, pair.color->mask | 8);
    }
    if (pair.color)
      statement(*pair.color, pair.color->mask);
    if (pair.alpha)
      statement(*pair.alpha, 8);
  }

  void statement(const Operation &op, int mask) {
    std::string text = std::string(kOps[std::size_t(op.op)]) + " r" +
                       std::to_string(op.destination) + maskText(mask) +
                       kScales[std::size_t(op.scale)] + (op.saturate ? ".sat" : "");
    for (int i = 0; i < argumentCount(op.op); ++i)
      text += (m_random.chance(10) ? " , " : ", ") + argument(op.arguments[std::size_t(i)]);
    line(text + ";");
  }

  std::string maskText(int mask) {
    if (mask == 0xF && m_random.chance(70))
      return "";
    std::string text = ".";
    for (int i = 0; i < 4; ++i)
      if (mask >> i & 1)
        text += "rgba"[i];
    return text;
  }

  static std::string argument(const Argument &argument) {
    std::string text;
    switch (argument.source) {
    case Source::Register:
      text = "r" + std::to_string(argument.index);
      break;
    case Source::Constant:
      text = "c" + std::to_string(argument.index);
      break;
    case Source::Zero:
      text = "0";
      break;
    case Source::One:
      text = "1";
      break;
    case Source::Primary:
      text = "color0";
      break;
    case Source::Secondary:
      text = "color1";
      break;
    }
    text += kReplicates[std::size_t(argument.replicate)];
    return text + (argument.negate ? ".neg" : "") + (argument.twice ? ".2x" : "") +
           (argument.bias ? ".bias" : "") + (argument.complement ? ".comp" : "");
  }

  const Shader &m_shader;
  Random m_random;
  std::string m_text;
};
} // namespace

std::string spell(const ati::Shader &shader, std::uint64_t seed) {
  return Speller(shader, seed).run();
}

} // namespace arbiter::fp::testing
