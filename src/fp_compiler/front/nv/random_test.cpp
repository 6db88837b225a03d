// Generated programs under NVIDIA's options: they load, their code is valid, and the passes change
// nothing of what they compute. A text with a token less or more is refused or computes, too.
#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp {
namespace {

using ir::NvOption;
using ir::Opcode;
using ir::Vec4;

CompileOptions offered() {
  CompileOptions options = testing_support::generous();
  options.limits.nvOptions = 2;
  return options;
}

/// A text of one option.
class Writer {
public:
  Writer(std::uint32_t seed, bool vertex, NvOption option)
      : m_state(seed * 2654435761u + 1), m_vertex(vertex), m_option(option),
        m_language(arbLanguage(vertex ? ir::Language::ArbVertex : ir::Language::ArbFragment)) {}

  std::string text() {
    const bool second = m_option == NvOption::Second;
    m_text = std::string(m_language.header) + "\nOPTION " +
             (m_vertex ? (second ? "NV_vertex_program3" : "NV_vertex_program2")
                       : (second ? "NV_fragment_program2" : "NV_fragment_program")) +
             ";\nTEMP r0, r1, r2, r3;\nPARAM c[4] = { program.local[0..3] };\n" +
             (m_vertex ? "ADDRESS A;\n" : "");
    for (int i = 0; i < 24; ++i)
      statement();
    for (; m_open > 0; --m_open)
      m_text += "ENDIF;\n";
    for (; m_labels > 0; --m_labels)
      m_text += "l" + std::to_string(m_labels) + ": ";
    return m_text + "\nMOV result." + (m_vertex ? "position" : "color") + ", r0;\nEND\n";
  }

private:
  std::uint32_t below(std::uint32_t limit) {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 17;
    m_state ^= m_state << 5;
    return m_state % limit;
  }
  bool chance(std::uint32_t percent) { return below(100) < percent; }
  std::string temporary() { return "r" + std::to_string(below(4)); }

  std::string swizzle(bool scalar) {
    std::string word = ".";
    for (int i = 0; i < (scalar ? 1 : 4); ++i)
      word += "xyzw"[below(4)];
    return word;
  }

  std::string operand(bool scalar) {
    const std::string name = chance(60)   ? temporary()
                             : chance(70) ? "c[" + std::to_string(below(4)) + "]"
                                          : std::string(m_language.attributes) + ".texcoord[1]";
    const std::string value = name + (scalar || chance(50) ? swizzle(scalar) : "");
    const std::string sign = chance(25) ? "-" : "";
    return chance(20) ? sign + "|" + value + "|" : sign + value;
  }

  std::string condition() {
    constexpr const char *kRules[] = {"EQ", "GE", "GT", "LE", "LT", "NE", "TR", "FL"};
    const bool numbered = m_vertex && m_option == NvOption::Second && chance(40);
    return std::string(kRules[below(8)]) + (numbered ? (chance(50) ? "0" : "1") : "") +
           (chance(50) ? swizzle(chance(50)) : "");
  }

  std::string suffix(const ir::OpInfo &op) {
    const bool second = m_option == NvOption::Second;
    std::string word;
    if (!m_vertex && !op.has(ir::NoPrecision) && chance(40))
      word += op.has(ir::NoFixed) || chance(50) ? (chance(50) ? "R" : "H") : "X";
    if (!op.has(ir::NoCondition) && chance(40))
      word += m_vertex && second ? (chance(50) ? "C1" : "C") : "C";
    if (!op.has(ir::NoSaturate) && (!m_vertex || second) && chance(20))
      word += !m_vertex && second && chance(50) ? "_SSAT" : "_SAT";
    return word;
  }

  void statement() {
    if (!m_vertex && m_option == NvOption::Second && chance(15))
      return block();
    if (m_vertex && chance(10)) {
      m_text += "BRA l" + std::to_string(++m_labels) + " (" + condition() + ");\n";
      return;
    }
    if (!m_vertex && chance(4)) {
      m_text += "KIL " + condition() + ";\n";
      return;
    }
    const auto op = Opcode(below(ir::kOpcodeRowCount));
    const ir::OpInfo &row = info(op);
    // What they pack is bits, and an identity such as x*1 keeps the denormals that a product loses.
    if (int(op) >= ir::kOpcodeCount && int(op) < ir::kCodeOpcodeCount && ir::carriesBits(op))
      return statement();
    if (!nv::offers(m_language, m_option, op) || row.has(ir::Flow) || row.has(ir::Kills) ||
        op == Opcode::Swz || op == Opcode::Arl || op == Opcode::Arr || op == Opcode::Ara)
      return statement();
    m_text += row.mnemonic + suffix(row) + " " + temporary();
    constexpr const char *kMasks[] = {"", ".x", ".yz", ".xw", ".xyz", ".w"};
    m_text += kMasks[below(6)] + (chance(40) ? " (" + condition() + ")" : std::string());
    for (int i = 0; i < row.operandCount(); ++i)
      m_text += ", " + operand(row.shapes[i] == 'S');
    m_text += row.has(ir::Texture) ? ", texture[0], 2D;\n" : ";\n";
  }

  void block() {
    if (m_open > 0 && chance(60)) {
      m_text += "ENDIF;\n";
      --m_open;
    } else {
      m_text += "IF " + condition() + ";\n";
      ++m_open;
    }
  }

  std::uint32_t m_state;
  bool m_vertex;
  NvOption m_option;
  const ArbLanguage &m_language;
  std::string m_text;
  int m_open = 0, m_labels = 0;
};

ir::Inputs inputs(std::span<const Vec4> attributes) {
  ir::Inputs given;
  given.attributes = attributes;
  given.parameter = [](const ir::Parameter &parameter) -> Vec4 {
    constexpr float kInf = std::numeric_limits<float>::infinity();
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr Vec4 kRows[] = {
        {-2, 0, 2, kNan}, {1, 2, 3, 4}, {0.5f, -0.25f, 1.75f, -0.0f}, {kInf, -kInf, 1e30f, 7}};
    return kRows[parameter.index & 3];
  };
  given.texture = [](const ir::Sample &sample) {
    return Vec4{sample.coordinate[0], 0.5f, sample.lod.value_or(-1), 1};
  };
  return given;
}

bool same(const Vec4 &a, const Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]) &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

TEST(NvRandom, PassesKeepTheMeaning) {
  constexpr std::uint32_t kPrograms = 150;
  std::uint32_t compared = 0;
  for (std::uint32_t seed = 0; seed < 4 * kPrograms; ++seed) {
    const std::string text =
        Writer(seed, seed & 1, seed & 2 ? NvOption::Second : NvOption::First).text();
    CheckResult result = testing_support::check(text, offered());
    ASSERT_TRUE(result.ok()) << result.errorString(text) << text;
    ir::Program program = std::move(*result.program);
    ASSERT_TRUE(ir::validate(program).empty()) << text;
    const std::vector<Vec4> attributes(program.attributes.size(), Vec4{0.75f, -1.5f, 2, 1});
    const ir::Evaluation before = ir::evaluate(program, inputs(attributes));
    optimise(program);
    ASSERT_TRUE(ir::validate(program).empty()) << text;
    const ir::Evaluation after = ir::evaluate(program, inputs(attributes));
    ASSERT_EQ(before.killed, after.killed) << text;
    for (std::size_t i = 0; i < before.outputs.size(); ++i)
      ASSERT_TRUE(same(before.outputs[i], after.outputs[i])) << text << ir::print(program);
    compared += before.killed ? 0 : 1;
  }
  EXPECT_GT(compared, kPrograms);
}

TEST(NvRandom, TextsWithATokenLessOrMore) {
  const std::string texts[] = {
      "!!ARBfp1.0\nOPTION NV_fragment_program2;\nSHORT TEMP a, b;\nLOOP {4, 0, 1};\n"
      "ADDHC_SSAT a.xy (GT.xxzw), |a|, -|fragment.texcoord[A0.x + 1]|;\nIF EQ.x;\nBRK (LT);\n"
      "CAL sub (NE.y);\nELSE;\nKIL GE;\nENDIF;\nENDLOOP;\nREP -program.local[0];\nENDREP;\n"
      "MOV result.color, a;\nRET;\nsub:\nRFL b, a, a;\nRET (TR);\nEND\n",
      "!!ARBvp1.0\nOPTION NV_vertex_program3;\nADDRESS A;\nTEMP r;\nstart:\nARLC A.xw (EQ), "
      "vertex.color;\nPUSHA A;\nPOPA A;\nMOVC1 r, vertex.attrib[A.y - 1];\nBRA start (LT1.z);\n"
      "TXL result.texcoord[A.x + 2], r, texture[0], CUBE;\nMOV result.position, r;\nEND\n"};
  int loaded = 0, refused = 0;
  for (const std::string &text : texts)
    testing_support::forEachTokenEdit(text, [&](const std::string &edited) {
      const CheckResult result = testing_support::check(edited, offered());
      if (!result.ok()) {
        ++refused;
        EXPECT_LE(std::size_t(result.errorPosition()), edited.size()) << edited;
        return;
      }
      ++loaded;
      EXPECT_TRUE(ir::validate(*result.program).empty()) << edited;
      const std::vector<Vec4> attributes(result.program->attributes.size(), Vec4{1, 1, 1, 1});
      static_cast<void>(ir::evaluate(*result.program, inputs(attributes)));
    });
  EXPECT_GT(refused, 100);
  EXPECT_GT(loaded, 0);
}

} // namespace
} // namespace arbiter::fp
