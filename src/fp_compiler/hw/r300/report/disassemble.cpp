#include "fp_compiler/hw/r300/report/disassemble.h"

#include <algorithm>
#include <charconv>

#include "fp_compiler/hw/r300/check/reads.h"
#include "fp_compiler/ir/print.h"

namespace arbiter::fp::hw::r300 {

namespace {
std::string number(std::uint64_t value) { return std::to_string(value); }

std::string real(float value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, value);
  return std::string(digits, end.ptr);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text;
}

std::string letters(std::uint8_t mask) {
  std::string text;
  for (std::size_t c = 0; c < 4; ++c)
    if (mask >> c & 1)
      text += "xyzw"[c];
  return text;
}

const char *nameOf(RgbOp op) {
  constexpr const char *kNames[] = {"nop", "mad", "dp3", "dp4", "min",
                                    "max", "cnd", "cmp", "frc", "repl_alpha"};
  return kNames[std::size_t(op)];
}
const char *nameOf(AlphaOp op) {
  constexpr const char *kNames[] = {"nop", "mad", "dp",  "min", "max", "cnd",
                                    "cmp", "frc", "ex2", "lg2", "rcp", "rsq"};
  return kNames[std::size_t(op)];
}
const char *nameOf(TexOp op) {
  constexpr const char *kNames[] = {"tex", "txp", "txb", "kil"};
  return kNames[std::size_t(op)];
}
const char *nameOf(RgbSelect select) {
  constexpr const char *kNames[] = {"xyz", "xxx", "yyy", "zzz", "www", "yzx",
                                    "zxy", "wzy", "0",   "1",   "0.5"};
  return kNames[std::size_t(select)];
}
const char *nameOf(AlphaSelect select) {
  constexpr const char *kNames[] = {"x", "y", "z", "w", "0", "1", "0.5"};
  return kNames[std::size_t(select)];
}
const char *nameOf(Presubtract operation) {
  constexpr const char *kNames[] = {"", "1-2*s0", "s1-s0", "s1+s0", "1-s0"};
  return kNames[std::size_t(operation)];
}
const char *suffixOf(Modifier modifier) {
  constexpr const char *kNames[] = {"", "_x2", "_x4", "_x8", "_d2", "_d4", "_d8"};
  return kNames[std::size_t(modifier)];
}
const char *reasonOf(Cause cause) {
  constexpr const char *kNames[] = {
      "",         "swizzle", "texture operand", "texture result",   "rectangle coordinates",
      "position", "fog",     "copy to result",  "node needs a pair"};
  return kNames[std::size_t(cause)];
}

/// One half of a pair in columns, or a texture instruction, whose text spans all columns.
struct Row {
  std::string place, addresses, target, operation, note;
  bool texture = false;
};

class Writer {
public:
  Writer(const Code &code, const ir::Program &program, std::string_view text, const Chip &chip)
      : m_code(code), m_program(program), m_hasText(!text.empty()), m_chip(chip) {
    // CR LF, LF and CR each end a line.
    for (std::size_t i = 0; i < text.size(); ++i)
      if (text[i] == '\n' || (text[i] == '\r' && text.substr(i + 1, 1) != "\n"))
        m_lineStarts.push_back(i + 1);
  }

  std::string run() {
    totals();
    interpolants();
    constants();
    collect();
    std::size_t row = 0;
    // Nodes are counted from 1, as in the reasons of a report.
    for (std::size_t i = 0; i < m_code.nodes.size(); ++i) {
      m_text += "\nnode " + number(i + 1) + "\n";
      for (std::size_t end = m_nodeEnds[i]; row < end; ++row)
        line(m_rows[row]);
    }
    return std::move(m_text);
  }

private:
  void total(std::size_t used, std::uint32_t limit, const char *what) {
    m_text += "; " + number(used) + " of " + number(limit) + " " + what;
    m_text += used > limit ? ": does not fit\n" : "\n";
  }

  void totals() {
    m_text += "; Radeon 9700 (R300) fragment program\n";
    total(m_code.nodes.size(), m_chip.nodes, "nodes");
    total(m_code.pairs.size(), m_chip.pairs, "pairs");
    total(m_code.textures.size(), m_chip.textures, "texture instructions");
    total(m_code.temporaries, m_chip.temporaries, "registers");
    total(m_code.constants.size(), m_chip.constants, "constants");
    total(m_code.interpolators, m_chip.interpolators, "texture coordinate interpolators");
  }

  void interpolants() {
    if (!m_code.interpolants.empty())
      m_text += "\ninterpolants\n";
    for (const Interpolant &interpolant : m_code.interpolants)
      m_text +=
          "  r" + number(interpolant.temporary) + " = " + attribute(interpolant.attribute) + "\n";
  }

  std::string attribute(std::uint16_t index) const {
    if (index == kFogCoordinate)
      return "fog coordinate (f, 0, 0, 1)";
    if (index == kSecondaryColor)
      return "secondary colour";
    if (index >= m_program.attributes.size())
      return "?";
    const ir::Attribute &attribute = m_program.attributes[index];
    std::string name = ir::bindingText(attribute, m_program.language);
    if (attribute.kind == ir::AttributeKind::Position)
      return name + ", as the clip position";
    if (attribute.kind == ir::AttributeKind::FogCoord)
      return name + " (f, 0, 0, 1)";
    return name;
  }

  void constants() {
    if (!m_code.constants.empty())
      m_text += "\nconstants\n";
    for (std::size_t i = 0; i < m_code.constants.size(); ++i) {
      const Constant &constant = m_code.constants[i];
      m_text += "  c" + number(i) + " = " + value(constant);
      if (constant.kind != Constant::Kind::Parameter)
        m_text += "  ; " + note(constant.origin, "the driver's");
      m_text += "\n";
    }
  }

  std::string value(const Constant &constant) const {
    switch (constant.kind) {
    case Constant::Kind::Parameter:
      return constant.index < m_program.parameters.size()
                 ? ir::bindingText(m_program.parameters[constant.index])
                 : "?";
    case Constant::Kind::Value:
      break;
    case Constant::Kind::RectangleScale:
      return "(1/width, 1/height, 1, 1) of texture[" + number(constant.index) + "]";
    case Constant::Kind::ViewportScale:
      return "viewport scale";
    case Constant::Kind::ViewportOffset:
      return "viewport offset";
    case Constant::Kind::FogColor:
      return "state.fog.color";
    case Constant::Kind::FogFactors:
      return "(-1/(end-start), end/(end-start), -density/ln 2, density/sqrt(ln 2)) of the fog";
    }
    std::string text;
    for (const float component : constant.value)
      text += (text.empty() ? "{" : ", ") + real(component);
    return text + "}";
  }

  std::size_t lineOf(const ir::Instruction &instruction) const {
    const auto after =
        std::upper_bound(m_lineStarts.begin(), m_lineStarts.end(), instruction.span.begin);
    return std::size_t(after - m_lineStarts.begin()) + 1;
  }

  /// Returns "line 7: MUL" or, without text, "3: MUL".
  std::string originText(std::uint16_t origin) const {
    if (origin >= m_program.code.size())
      return "";
    const ir::Instruction &instruction = m_program.code[origin];
    const std::string place =
        !m_hasText ? number(origin + 1u) : "line " + number(lineOf(instruction));
    return place + ": " + ir::info(instruction.op).mnemonic;
  }

  std::string note(std::uint16_t origin, const std::string &reason) const {
    const std::string text = originText(origin);
    return text.empty() || reason.empty() ? text + reason : text + ", " + reason;
  }

  /// Writes all rows and measures the columns, so that the halves are aligned.
  void collect() {
    for (const Node &node : m_code.nodes) {
      for (std::uint32_t i = 0; i < node.textures; ++i)
        texture(m_code.textures[node.firstTexture + i]);
      for (std::uint32_t i = 0; i < node.pairs; ++i)
        pair(node.firstPair + i);
      m_nodeEnds.push_back(m_rows.size());
    }
    for (const Row &row : m_rows) {
      m_addressWidth = std::max(m_addressWidth, row.addresses.size());
      m_targetWidth = std::max(m_targetWidth, row.target.size());
      m_operationWidth = std::max(m_operationWidth, row.operation.size());
    }
  }

  void line(const Row &row) {
    std::string text = padded(row.place, 12);
    if (row.texture)
      text += padded(row.operation, m_addressWidth + m_targetWidth + m_operationWidth + 3);
    else
      text += padded(row.addresses, m_addressWidth) + " " + padded(row.target, m_targetWidth) +
              "  " + padded(row.operation, m_operationWidth);
    if (!row.note.empty())
      text += "  ; " + row.note;
    text.erase(text.find_last_not_of(' ') + 1);
    m_text += text + "\n";
  }

  void texture(const Texture &texture) {
    std::string text = "r" + number(texture.source);
    if (texture.op != TexOp::Kill)
      text = "r" + number(texture.destination) + " = " + text + ", texture[" +
             number(texture.unit) + "], " + ir::targetText(texture.target);
    m_rows.push_back(
        {std::string("      ") + nameOf(texture.op), "", "", text, note(texture.origin, ""), true});
  }

  void pair(std::size_t index) {
    const Pair &pair = m_code.pairs[index];
    std::string place = number(index);
    place.insert(0, 5 - std::min<std::size_t>(5, place.size()), ' ');
    half(place + " rgb", pair.rgb, argumentCount(pair.rgb.op));
    half("      alpha", pair.alpha, argumentCount(pair.alpha.op, pair.rgb.op));
  }

  template <typename Half>
  void half(const std::string &place, const Half &half, std::size_t arguments) {
    using Op = decltype(half.op);
    Row row = {place, addresses(half), target(half), nameOf(half.op), "", false};
    if (half.op != Op::None) {
      row.operation += std::string(suffixOf(half.modifier)) + (half.clamp ? "_sat" : "");
      row.note = note(half.origin, reasonOf(half.cause));
    } else if (half.cause == Cause::EmptyNode) {
      row.note = reasonOf(half.cause);
    }
    for (std::size_t i = 0; i < arguments; ++i)
      row.operation += (i ? ", " : " ") + argument(half.arguments[i]);
    m_rows.push_back(std::move(row));
  }

  template <typename Half> static std::string addresses(const Half &half) {
    std::string text;
    for (std::size_t i = 0; i < half.sources.size(); ++i) {
      const Source &source = half.sources[i];
      if (source.bank == Source::Bank::None)
        continue;
      text += (text.empty() ? "s" : " s") + number(i) +
              (source.bank == Source::Bank::Constant ? "=c" : "=r") + number(source.index);
    }
    if (half.presubtract != Presubtract::None)
      text += std::string(text.empty() ? "pre=" : " pre=") + nameOf(half.presubtract);
    return text;
  }

  /// Returns "r2.xyz o0.xyz =", or an empty text for an idle half.
  template <typename Half> static std::string target(const Half &half) {
    std::string text;
    if (half.mask)
      text += "r" + number(half.temporary) + "." + letters(half.mask) + " ";
    if (half.outputMask)
      text += "o" + number(half.output) + "." + letters(half.outputMask) + " ";
    if (half.depth)
      text += "depth ";
    return text.empty() ? text : text + "=";
  }

  template <typename Argument> static std::string argument(const Argument &argument) {
    using Select = decltype(argument.select);
    std::string text = nameOf(argument.select);
    if (argument.select < Select::Zero)
      text =
          (argument.source == kPresubtracted ? std::string("pre") : "s" + number(argument.source)) +
          "." + text;
    if (argument.absolute)
      text = "|" + text + "|";
    return argument.negate ? "-" + text : text;
  }

  const Code &m_code;
  const ir::Program &m_program;
  bool m_hasText;
  std::vector<std::size_t> m_lineStarts; ///< without the first line
  const Chip &m_chip;
  std::vector<Row> m_rows;
  std::vector<std::size_t> m_nodeEnds; ///< indices into m_rows
  std::size_t m_addressWidth = 0, m_targetWidth = 0, m_operationWidth = 0;
  std::string m_text;
};
} // namespace

std::string disassemble(const Code &code, const ir::Program &program, std::string_view text,
                        const Chip &chip) {
  return Writer(code, program, text, chip).run();
}

} // namespace arbiter::fp::hw::r300
