#include <algorithm>
#include <charconv>
#include <cmath>

#include "fp_compiler/ir/print.h"
#include "fp_compiler/testing/random.h"

namespace arbiter::fp::testing {

using namespace ir;

namespace {
std::string plain(float value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  return std::string(digits, end.ptr);
}

class Speller {
public:
  Speller(const Program &program, std::uint64_t seed) : m_program(program), m_random(seed) {}

  std::string run() {
    m_text = "!!ARBfp1.0\n";
    options();
    temporaries();
    attributes();
    parameters();
    outputs();
    for (const Instruction &instruction : m_program.code)
      statement(instruction);
    m_text += m_random.chance(50) ? "END" : "END\n# the end\n";
    return m_text;
  }

private:
  void line(const std::string &text) {
    m_text += text;
    if (m_random.chance(8))
      m_text += " # " + std::to_string(m_random.below(1000)) + "; END";
    m_text += m_random.chance(5) ? "\r\n" : "\n";
  }

  void options() {
    const Options &o = m_program.options;
    constexpr const char *kFog[] = {"", "exp", "exp2", "linear"};
    constexpr const char *kHint[] = {"", "fastest", "nicest"};
    const auto option = [&](bool given, const std::string &name) {
      if (given)
        line("OPTION " + name + ";");
    };
    option(o.fog != FogMode::None, std::string("ARB_fog_") + kFog[std::size_t(o.fog)]);
    option(o.precision != Precision::Unspecified,
           std::string("ARB_precision_hint_") + kHint[std::size_t(o.precision)]);
    option(o.shadow, "ARB_fragment_program_shadow");
    option(o.drawBuffers, m_random.chance(50) ? "ARB_draw_buffers" : "ATI_draw_buffers");
    option(o.originUpperLeft, "ARB_fragment_coord_origin_upper_left");
    option(o.pixelCenterInteger, "ARB_fragment_coord_pixel_center_integer");
  }

  void temporaries() {
    std::string list;
    for (std::size_t i = 0; i < m_program.temporaries.size(); ++i) {
      std::string name = (m_random.chance(20) ? "$tmp_" : "r") + std::to_string(i);
      if (m_random.chance(20)) {
        line("TEMP " + name + ";");
      } else {
        list += (list.empty() ? "" : ", ") + name;
      }
      m_temporaries.push_back(name);
    }
    if (!list.empty())
      line("TEMP " + list + ";");
    for (std::string &name : m_temporaries)
      if (m_random.chance(10)) {
        line("ALIAS also_" + name.substr(1) + " = " + name + ";");
        name = "also_" + name.substr(1);
      }
  }

  void attributes() {
    for (std::size_t i = 0; i < m_program.attributes.size(); ++i) {
      const Attribute &attribute = m_program.attributes[i];
      std::string binding = bindingText(attribute);
      if (attribute.kind == AttributeKind::ColorPrimary && m_random.chance(50))
        binding = "fragment.color";
      if (attribute.kind == AttributeKind::TexCoord && attribute.index == 0 && m_random.chance(50))
        binding = "fragment.texcoord";
      if (m_random.chance(40)) {
        line("ATTRIB in" + std::to_string(i) + " = " + binding + ";");
        binding = "in" + std::to_string(i);
      }
      m_attributes.push_back(binding);
    }
  }

  std::string numeral(float value) {
    std::string text = plain(value);
    if (text.starts_with("0.") && m_random.chance(40))
      text.erase(0, 1);
    else if (text.find_first_of(".e") == std::string::npos && m_random.chance(50))
      text += m_random.chance(50) ? "." : ".0e+0";
    return text;
  }

  /// A vector, shortened where the defaults 0, 0, 1 allow it.
  std::string constant(const Vec4 &value) {
    std::size_t count = 4;
    const Vec4 defaults = {0, 0, 0, 1};
    while (count > 1 && value[count - 1] == defaults[count - 1] &&
           !std::signbit(value[count - 1]) && m_random.chance(70))
      --count;
    std::string text = "{";
    for (std::size_t i = 0; i < count; ++i)
      text += (i ? ", " : "") + numeral(value[i]);
    return text + "}";
  }

  static bool broadcasts(const Vec4 &value) {
    return std::all_of(value.begin(), value.end(), [&](float v) {
      return v == value[0] && std::signbit(v) == std::signbit(value[0]);
    });
  }

  void parameters() {
    std::string array;
    std::vector<std::size_t> members;
    for (std::size_t i = 0; i < m_program.parameters.size(); ++i) {
      const Parameter &parameter = m_program.parameters[i];
      const bool isConstant = parameter.kind == ParameterKind::Constant;
      const std::string binding =
          isConstant ? constant(parameter.constant) : bindingText(parameter);
      m_parameters.push_back(binding);
      const int style = m_random.below(4);
      if (style == 1) {
        const bool scalar = isConstant && broadcasts(parameter.constant) && m_random.chance(60);
        line("PARAM k" + std::to_string(i) + " = " +
             (scalar ? numeral(parameter.constant[0]) : binding) + ";");
        m_parameters.back() = "k" + std::to_string(i);
      } else if (style == 2) {
        array += (array.empty() ? "" : ", ") + binding;
        m_parameters.back() = "table[" + std::to_string(members.size()) + "]";
        members.push_back(i);
      }
    }
    if (!members.empty())
      line("PARAM table[" + (m_random.chance(50) ? std::to_string(members.size()) : "") + "] = {" +
           array + "};");
  }

  void outputs() {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
      const Output &output = m_program.outputs[i];
      std::string binding = output.kind == OutputKind::Depth ? "result.depth" : "result.color";
      if (output.kind == OutputKind::Color && output.index != 0)
        binding += "[" + std::to_string(output.index) + "]";
      if (m_random.chance(30)) {
        line("OUTPUT out" + std::to_string(i) + " = " + binding + ";");
        binding = "out" + std::to_string(i);
      }
      m_outputs.push_back(binding);
    }
  }

  const char *letters() { return m_random.chance(30) ? "rgba" : "xyzw"; }

  std::string nameOf(const Operand &operand) const {
    switch (operand.file) {
    case File::Temporary:
      return m_temporaries[operand.index];
    case File::Attribute:
      return m_attributes[operand.index];
    default:
      return m_parameters[operand.index];
    }
  }

  std::string source(const Operand &operand, bool scalar) {
    std::string text = std::string(operand.negate ? "-" : "") + nameOf(operand);
    if (operand.swizzle == kIdentity && !scalar)
      return text;
    const char *names = letters();
    text += '.';
    const bool one = std::all_of(operand.swizzle.begin(), operand.swizzle.end(),
                                 [&](Select s) { return s == operand.swizzle[0]; });
    for (std::size_t i = 0; i < (one ? 1u : 4u); ++i)
      text += names[int(operand.swizzle[i])];
    return text;
  }

  std::string extended(const Operand &operand) {
    const std::string names = std::string(letters()) + "01";
    std::string text = nameOf(operand);
    for (std::size_t i = 0; i < 4; ++i)
      text += std::string(", ") + (operand.negate >> i & 1 ? "-" : "") +
              names[std::size_t(operand.swizzle[i])];
    return text;
  }

  std::string destination(const Destination &dst) {
    std::string text = dst.file == File::Output ? m_outputs[dst.index] : m_temporaries[dst.index];
    if (dst.mask == 0xF && m_random.chance(90))
      return text;
    const char *names = letters();
    text += '.';
    for (int i = 0; i < 4; ++i)
      if (dst.mask >> i & 1)
        text += names[i];
    return text;
  }

  void statement(const Instruction &instruction) {
    const OpInfo &row = info(instruction.op);
    std::string text = row.mnemonic;
    if (!row.has(Kills))
      text += (instruction.dst.saturate ? "_SAT " : " ") + destination(instruction.dst) + ",";
    for (int i = 0; i < row.operandCount(); ++i) {
      const Operand &operand = instruction.src[std::size_t(i)];
      text += (i ? ", " : " ") + (instruction.op == Opcode::Swz
                                      ? extended(operand)
                                      : source(operand, row.shapes[i] == 'S'));
    }
    if (row.has(Texture))
      text +=
          ", texture[" + std::to_string(instruction.unit) + "], " + targetText(instruction.target);
    line(text + ";");
  }

  const Program &m_program;
  Random m_random;
  std::string m_text;
  std::vector<std::string> m_temporaries, m_attributes, m_parameters, m_outputs;
};
} // namespace

std::string spell(const Program &program, std::uint64_t seed) {
  return Speller(program, seed).run();
}

} // namespace arbiter::fp::testing
