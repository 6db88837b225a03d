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
    m_text = isVertex() ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n";
    options();
    temporaries();
    addresses();
    attributes();
    parameters();
    arrays();
    outputs();
    for (const Instruction &instruction : m_program.code)
      statement(instruction);
    m_text += m_random.chance(50) ? "END" : "END\n# the end\n";
    return m_text;
  }

private:
  bool isVertex() const { return m_program.language == Language::ArbVertex; }

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
    option(o.positionInvariant, "ARB_position_invariant");
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

  void addresses() {
    for (std::size_t i = 0; i < m_program.addresses.size(); ++i) {
      m_addresses.push_back((m_random.chance(30) ? "at" : "addr_") + std::to_string(i));
      line("ADDRESS " + m_addresses.back() + ";");
    }
  }

  void attributes() {
    for (std::size_t i = 0; i < m_program.attributes.size(); ++i) {
      const Attribute &attribute = m_program.attributes[i];
      const std::string stage = isVertex() ? "vertex." : "fragment.";
      std::string binding = bindingText(attribute, m_program.language);
      if (attribute.kind == AttributeKind::ColorPrimary && m_random.chance(50))
        binding = stage + "color";
      if (attribute.kind == AttributeKind::TexCoord && attribute.index == 0 && m_random.chance(50))
        binding = stage + "texcoord";
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

  /// Returns a vector, shortened if the defaults 0, 0, 1 allow it.
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

  /// Writes the arrays that are read by address. A run of env rows may be written as a range.
  void arrays() {
    for (std::size_t i = 0; i < m_program.arrays.size(); ++i) {
      const std::vector<std::uint16_t> &rows = m_program.arrays[i].rows;
      const std::string size = std::to_string(rows.size());
      const Parameter &first = m_program.parameters[rows.front()];
      std::string list;
      if (first.kind == ParameterKind::Env && m_random.chance(60)) {
        list = "program.env[" + std::to_string(first.index) + ".." +
               std::to_string(first.index + rows.size() - 1) + "]";
      } else {
        for (const std::uint16_t row : rows) {
          const Parameter &parameter = m_program.parameters[row];
          list += (list.empty() ? "" : ", ") + (parameter.kind == ParameterKind::Constant
                                                    ? constant(parameter.constant)
                                                    : bindingText(parameter));
        }
      }
      m_arrays.push_back("rows" + std::to_string(i));
      line("PARAM " + m_arrays.back() + "[" + (m_random.chance(50) ? size : "") + "] = { " + list +
           " };");
    }
  }

  std::string vertexResult(const Output &output) {
    if (output.kind == OutputKind::FrontPrimary)
      return m_random.chance(50) ? "result.color" : "result.color.primary";
    if (output.kind == OutputKind::FrontSecondary && m_random.chance(50))
      return "result.color.secondary";
    if (output.kind == OutputKind::BackPrimary && m_random.chance(50))
      return "result.color.back";
    return bindingText(output);
  }

  std::string fragmentResult(const Output &output) {
    std::string binding = output.kind == OutputKind::Depth ? "result.depth" : "result.color";
    if (output.kind == OutputKind::Color && output.index != 0)
      binding += "[" + std::to_string(output.index) + "]";
    return binding;
  }

  void outputs() {
    for (std::size_t i = 0; i < m_program.outputs.size(); ++i) {
      const Output &output = m_program.outputs[i];
      std::string binding = isVertex() ? vertexResult(output) : fragmentResult(output);
      if (m_random.chance(30)) {
        line("OUTPUT out" + std::to_string(i) + " = " + binding + ";");
        binding = "out" + std::to_string(i);
      }
      m_outputs.push_back(binding);
    }
  }

  /// Returns the letters of components. Only fragment programs may use rgba.
  const char *letters() { return !isVertex() && m_random.chance(30) ? "rgba" : "xyzw"; }

  std::string nameOf(const Operand &operand) {
    if (operand.relative)
      return element(operand);
    switch (operand.file) {
    case File::Temporary:
      return m_temporaries[operand.index];
    case File::Attribute:
      return m_attributes[operand.index];
    default:
      return m_parameters[operand.index];
    }
  }

  std::string element(const Operand &operand) {
    std::string text = m_arrays[operand.index] + "[" + m_addresses[operand.address] + ".x";
    if (operand.offset != 0 || m_random.chance(20))
      text += (operand.offset < 0 ? " - " : " + ") + std::to_string(std::abs(int(operand.offset)));
    return text + "]";
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
    if (dst.file == File::Address)
      return m_addresses[dst.index] + ".x";
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
  std::vector<std::string> m_temporaries, m_attributes, m_parameters, m_outputs, m_addresses,
      m_arrays;
};
} // namespace

std::string spell(const Program &program, std::uint64_t seed) {
  return Speller(program, seed).run();
}

} // namespace arbiter::fp::testing
