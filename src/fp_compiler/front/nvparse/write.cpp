// Writes the state as a text, with nvparse's own words where it had them.
#include <charconv>

#include "fp_compiler/front/nvparse/text.h"
#include "fp_compiler/front/nvparse/words.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp::nvparse {

namespace {

using combiners::Input;
using combiners::Mapping;
using combiners::Portion;
using combiners::Register;
using combiners::Scale;
using combiners::Usage;
using texture_shader::Row;

std::string number(float value) {
  char digits[64];
  const auto end =
      std::to_chars(std::begin(digits), std::end(digits), value, std::chars_format::fixed);
  std::string text(std::begin(digits), end.ptr);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}

std::string numbers(const ir::Vec4 &value, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += (i == 0 ? "" : ", ") + number(value[i]);
  return text;
}

std::string named(const Input &input, Usage usage) {
  const char *const components = input.usage == usage          ? ""
                                 : input.usage == Usage::Rgb   ? ".rgb"
                                 : input.usage == Usage::Alpha ? ".a"
                                                               : ".b";
  return wordOf(input.source) + components;
}

std::string mapped(const Input &input, Usage usage) {
  std::string name = named(input, usage);
  switch (input.mapping) {
  case Mapping::UnsignedIdentity:
    return "unsigned(" + name + ")";
  case Mapping::UnsignedInvert:
    return "unsigned_invert(" + name + ")";
  case Mapping::ExpandNormal:
    return "expand(" + name + ")";
  case Mapping::ExpandNegate:
    return "-expand(" + name + ")";
  case Mapping::HalfBiasNormal:
    return "half_bias(" + name + ")";
  case Mapping::HalfBiasNegate:
    return "-half_bias(" + name + ")";
  case Mapping::SignedIdentity:
    return name;
  case Mapping::SignedNegate:
    return "-" + name;
  }
  return name;
}

std::string finalInput(const Input &input, Usage usage = Usage::Rgb) {
  return input.mapping == Mapping::UnsignedInvert ? mapped(input, usage) : named(input, usage);
}

class CombinerWriter {
public:
  explicit CombinerWriter(const Text &text) : m_state(*text.combiners), m_values(text.values) {}

  std::string write() {
    const bool perStage = m_state.perStageConstants;
    bool marked = false;
    for (int stage = 0; stage < m_state.count && perStage; ++stage)
      for (int which = 0; which < 2; ++which)
        marked |= value(combiners::stageConstant(stage, which)).has_value();
    for (int which = 0; which < 2; ++which)
      constant("", which, combiners::globalConstant(which));
    if (perStage && !marked)
      m_text += "per_stage_constants();\n";
    for (int stage = 0; stage < m_state.count; ++stage)
      general(stage);
    final();
    return m_text;
  }

private:
  [[nodiscard]] const std::optional<ir::Vec4> &value(int parameter) const {
    return m_values[std::size_t(parameter)];
  }

  void constant(const char *indent, int which, int parameter) {
    if (const std::optional<ir::Vec4> &is = value(parameter))
      m_text +=
          std::string(indent) + "const" + std::to_string(which) + " = (" + numbers(*is, 4) + ");\n";
  }

  void general(int i) {
    const combiners::Stage &stage = m_state.stages[std::size_t(i)];
    m_text += "{\n";
    if (m_state.perStageConstants)
      for (int which = 0; which < 2; ++which)
        constant("  ", which, combiners::stageConstant(i, which));
    const bool rgb = !isNothing(stage.rgb, Usage::Rgb);
    const bool alpha = !isNothing(stage.alpha, Usage::Alpha);
    if (rgb || !alpha)
      portion(stage.rgb, Usage::Rgb);
    if (alpha)
      portion(stage.alpha, Usage::Alpha);
    m_text += "}\n";
  }

  static bool isZero(const Input &input, Usage usage) {
    return input == Input{Register::Zero, Mapping::UnsignedIdentity, usage};
  }
  static bool isNothing(const Portion &portion, Usage usage) {
    for (const Input &input : portion.inputs)
      if (!isZero(input, usage))
        return false;
    return portion.ab == Register::Discard && portion.scale == Scale::None && !portion.bias &&
           !portion.abDot && !needsSecond(portion, usage);
  }
  static bool needsSum(const Portion &portion) {
    return portion.sum != Register::Discard || portion.mux;
  }
  static bool needsSecond(const Portion &portion, Usage usage) {
    return portion.cd != Register::Discard || portion.cdDot || needsSum(portion) ||
           !isZero(portion.inputs[2], usage) || !isZero(portion.inputs[3], usage);
  }

  void product(Register to, const Input &a, const Input &b, bool dot, Usage usage) {
    m_text += "    " + wordOf(to) + " = " + mapped(a, usage);
    if (dot || b != Input{Register::Zero, Mapping::UnsignedInvert, usage})
      m_text += (dot ? " . " : " * ") + mapped(b, usage);
    m_text += ";\n";
  }

  void portion(const Portion &portion, Usage usage) {
    m_text += usage == Usage::Rgb ? "  rgb {\n" : "  alpha {\n";
    const auto &[a, b, c, d] = portion.inputs;
    product(portion.ab, a, b, portion.abDot, usage);
    if (needsSecond(portion, usage))
      product(portion.cd, c, d, portion.cdDot, usage);
    if (needsSum(portion))
      m_text += "    " + wordOf(portion.sum) + (portion.mux ? " = mux();\n" : " = sum();\n");
    if (portion.bias)
      m_text += portion.scale == Scale::ByTwo ? "    bias_by_negative_one_half_scale_by_two();\n"
                                              : "    bias_by_negative_one_half();\n";
    else if (portion.scale != Scale::None)
      m_text += portion.scale == Scale::ByTwo    ? "    scale_by_two();\n"
                : portion.scale == Scale::ByFour ? "    scale_by_four();\n"
                                                 : "    scale_by_one_half();\n";
    m_text += "  }\n";
  }

  void final() {
    const auto &[a, b, c, d, e, f, g] = m_state.finals;
    if (m_state.sumClamp)
      m_text += "clamp_color_sum();\n";
    bool reads = !isZero(e, Usage::Rgb) || !isZero(f, Usage::Rgb);
    for (const Input &input : {a, b, c, d})
      reads |= input.source == Register::ETimesF;
    if (reads)
      m_text += "final_product = " + finalInput(e) + " * " + finalInput(f) + ";\n";
    m_text += "out.rgb = ";
    const bool noLast = isZero(d, Usage::Rgb);
    if (isZero(a, Usage::Rgb) && isZero(b, Usage::Rgb) && isZero(c, Usage::Rgb))
      m_text += finalInput(d);
    else if (isZero(c, Usage::Rgb))
      m_text += finalInput(a) + " * " + finalInput(b) + (noLast ? "" : " + " + finalInput(d));
    else
      m_text += "lerp(" + finalInput(a) + ", " + finalInput(b) + ", " + finalInput(c) + ")" +
                (noLast ? "" : " + " + finalInput(d));
    m_text += ";\nout.a = " + finalInput(g, Usage::Alpha) + ";\n";
  }

  const combiners::State &m_state;
  const texture_shader::Values &m_values;
  std::string m_text;
};

class ShaderWriter {
public:
  explicit ShaderWriter(const Text &text) : m_state(*text.shaders), m_values(text.values) {}

  std::string write() {
    int units = m_state.units;
    while (units > 1 && operation(units - 1) == texture_shader::Operation::None)
      --units;
    for (int unit = 0; unit < units;)
      unit += stages(unit, units);
    return m_text;
  }

private:
  [[nodiscard]] texture_shader::Operation operation(int unit) const {
    return m_state.stages[std::size_t(unit)].operation;
  }

  /// Writes the longest run that begins there, or one stage. Returns the number of stages.
  int stages(int unit, int units) {
    const auto rows = operationWords();
    const OperationWord *best = nullptr;
    for (const OperationWord &row : rows)
      if (row.stage == 1 && (!best || row.stages > best->stages) && isRun(&row, unit, units))
        best = &row;
    if (!best)
      return 1; // every operation has a word of one stage
    for (int i = 0; i < best->stages; ++i)
      stage(best[i], unit + i);
    return best->stages;
  }

  [[nodiscard]] bool isRun(const OperationWord *first, int unit, int units) const {
    if (unit + first->stages > units)
      return false;
    for (int i = 0; i < first->stages; ++i)
      if (operation(unit + i) != first[i].operation)
        return false;
    return true;
  }

  void stage(const OperationWord &row, int unit) {
    const texture_shader::Stage &stage = m_state.stages[std::size_t(unit)];
    const std::string previous = wordOf(combiners::textureRegister(stage.previous));
    m_text += std::string(row.word) + "(";
    switch (row.arguments) {
    case Arguments::None:
      break;
    case Arguments::Cull:
      for (unsigned i = 0; i < 4; ++i)
        m_text += std::string(i == 0 ? "" : ", ") +
                  ((stage.cullLess >> i & 1u) != 0 ? "LESS_THAN_ZERO" : "GEQUAL_TO_ZERO");
      break;
    case Arguments::Dot:
    case Arguments::Eye:
      m_text += stage.mapping == texture_shader::Mapping::ExpandNormal ? "expand(" + previous + ")"
                : stage.mapping == texture_shader::Mapping::ForceBlueToOne
                    ? "force_blue_to_one(" + previous + ")"
                    : previous;
      break;
    default:
      m_text += previous;
    }
    values(row, unit);
    m_text += ");\n";
  }

  void values(const OperationWord &row, int unit) {
    const auto value = [&](int of, Row which) -> const std::optional<ir::Vec4> & {
      return m_values[std::size_t(texture_shader::parameter(of, which))];
    };
    if (row.arguments == Arguments::Eye) {
      if (const auto &eye = value(unit + row.stages - 1, Row::Eye))
        m_text += ", " + numbers(*eye, 3);
    } else if (row.arguments == Arguments::Matrix || row.arguments == Arguments::Scale) {
      const bool scales = row.arguments == Arguments::Scale;
      const auto &matrix = value(unit, Row::Matrix);
      const auto &scale = value(unit, Row::ScaleBias);
      if (matrix && (!scales || scale))
        m_text += ", " + numbers(*matrix, 4) + (scales ? ", " + numbers(*scale, 2) : "");
    }
  }

  const texture_shader::State &m_state;
  const texture_shader::Values &m_values;
  std::string m_text;
};

} // namespace

std::string write(const Text &text) {
  std::string result;
  if (text.shaders)
    result += std::string(kShaderHeader) + "\n" + ShaderWriter(text).write();
  if (text.combiners)
    result += std::string(kCombinerHeader) + "\n" + CombinerWriter(text).write();
  return result;
}

} // namespace arbiter::fp::nvparse
