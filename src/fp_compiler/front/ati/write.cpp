#include "fp_compiler/front/ati/write.h"

#include <algorithm>
#include <cstdio>

#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/ati/words.h"

namespace arbiter::fp::ati {

namespace {

constexpr int kNamedSets = 6; // t0 to t5

std::string withNumber(const char *letter, int number) { return letter + std::to_string(number); }

/// Returns a number that reads back as the same float.
std::string literal(float value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", double(value));
  return text;
}

class Writer {
public:
  explicit Writer(const Shader &shader) : m_shader(shader) {}

  std::optional<std::string> run() {
    m_text = std::string(kHeader) + "\n";
    constants();
    for (int i = 0; i < m_shader.passCount; ++i) {
      const Pass &pass = m_shader.passes[std::size_t(i)];
      m_text += i + 1 == m_shader.passCount ? "StartOutputPass;\n" : "StartPrelimPass;\n";
      for (std::size_t reg = 0; reg < pass.setups.size(); ++reg)
        setup(pass.setups[reg], int(reg));
      for (std::size_t j = 0; j < pass.pairCount; ++j)
        pair(pass.pairs[j]);
      m_text += "EndPass;\n";
    }
    return m_hasWords ? std::optional(m_text) : std::nullopt;
  }

private:
  void need(bool hasWords) { m_hasWords = m_hasWords && hasWords; }
  void line(const std::string &text) { m_text += "  " + text + ";\n"; }

  // --- Constants ---

  void note(const std::optional<Operation> &operation, std::array<bool, kConstants> &read) const {
    for (int i = 0; operation && i < argumentCount(operation->op); ++i) {
      const Argument &argument = operation->arguments[std::size_t(i)];
      if (argument.source == Source::Constant)
        read[argument.index] = true;
    }
  }

  [[nodiscard]] std::array<bool, kConstants> constantsRead() const {
    std::array<bool, kConstants> read{};
    for (std::size_t i = 0; i < m_shader.passCount; ++i)
      for (std::size_t j = 0; j < m_shader.passes[i].pairCount; ++j) {
        const Pair &pair = m_shader.passes[i].pairs[j];
        note(pair.color, read);
        if (pair.alpha && !isDot(pair.alpha->op)) // a dot product's arguments are its colour's
          note(pair.alpha, read);
      }
    return read;
  }

  void constants() {
    const std::array<bool, kConstants> read = constantsRead();
    if (std::find(read.begin(), read.end(), true) == read.end())
      return;
    m_text += "StartConstants;\n";
    for (std::size_t i = 0; i < read.size(); ++i)
      if (read[i])
        line(withNumber("CONSTANT c", int(i)) + " = " + bound(m_shader.constants[i]));
    m_text += "EndConstants;\n";
  }

  std::string bound(const Constant &constant) {
    if (constant.kind != ConstantKind::Value)
      return (constant.kind == ConstantKind::Env ? "program.env[" : "program.local[") +
             std::to_string(constant.index) + "]";
    std::string text;
    for (const float component : constant.value) {
      need(component >= 0.0f && component <= 1.0f);
      text += (text.empty() ? "{ " : ", ") + literal(component);
    }
    return text + " }";
  }

  // --- Passes ---

  void setup(const Setup &setup, int reg) {
    if (setup.kind == SetupKind::None)
      return;
    need(setup.fromRegister || setup.source < kNamedSets);
    line(withNumber(setup.kind == SetupKind::SampleMap ? "SampleMap r" : "PassTexCoord r", reg) +
         ", " + withNumber(setup.fromRegister ? "r" : "t", setup.source) + "." +
         std::string(name(setup.coordinates)));
  }

  void pair(const Pair &pair) {
    if (pair.color && pair.alpha && isDot(pair.alpha->op)) { // one statement, of both
      need(pair.color->destination == pair.alpha->destination &&
           pair.color->scale == pair.alpha->scale && pair.color->saturate == pair.alpha->saturate);
      return statement(*pair.color, pair.color->mask | kAlpha);
    }
    if (pair.color)
      statement(*pair.color, pair.color->mask);
    if (pair.alpha)
      statement(*pair.alpha, kAlpha);
  }

  void statement(const Operation &op, int mask) {
    std::string text = std::string(name(op.op)) + withNumber(" r", op.destination);
    if (mask != (7 | kAlpha)) {
      text += ".";
      for (int i = 0; i < 4; ++i)
        if ((mask >> i & 1) != 0)
          text += "rgba"[i];
    }
    if (op.scale != Scale::None)
      text += "." + std::string(name(op.scale));
    if (op.saturate)
      text += ".sat";
    for (int i = 0; i < argumentCount(op.op); ++i)
      text += ", " + spelled(op.arguments[std::size_t(i)]);
    line(text);
  }

  static std::string spelled(const Argument &argument) {
    std::string text;
    switch (argument.source) {
    case Source::Register:
      text = withNumber("r", argument.index);
      break;
    case Source::Constant:
      text = withNumber("c", argument.index);
      break;
    case Source::Zero:
    case Source::One:
      text = argument.source == Source::Zero ? "0" : "1";
      break;
    case Source::Primary:
    case Source::Secondary:
      text = argument.source == Source::Primary ? "color0" : "color1";
      break;
    }
    if (argument.replicate != Replicate::None)
      text += std::string(".") + "rgba"[int(argument.replicate) - 1];
    return text + (argument.negate ? ".neg" : "") + (argument.twice ? ".2x" : "") +
           (argument.bias ? ".bias" : "") + (argument.complement ? ".comp" : "");
  }

  const Shader &m_shader;
  std::string m_text;
  bool m_hasWords = true;
};

} // namespace

std::optional<std::string> write(const Shader &shader) { return Writer(shader).run(); }

} // namespace arbiter::fp::ati
