// Generates programs in NVIDIA's own languages, and the same statements under NVIDIA's options.
// Both must compute the same, and so must the optimised code of the first. values_test.cpp covers
// RSQ and POW, which differ in meaning.
#include <bit>
#include <cmath>

#include <gtest/gtest.h>

#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/front/testing/nvidia.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/ir/validate.h"
#include "fp_compiler/testing/specials.h"

namespace arbiter::fp {
namespace {

using ir::NativeLanguage;
using ir::Opcode;
using ir::Vec4;

constexpr int kTemporaries = 4, kParameters = 4;

/// Writes a program in both forms.
class Writer {
public:
  Writer(std::uint32_t seed, NativeLanguage language)
      : m_state(seed * 2654435761u + 1), m_language(language),
        m_fragment(language == NativeLanguage::Fp1), m_conditions(m_fragment || isSecond()) {
    own = std::string(headerOf(language)) + "\n";
    option = m_fragment ? "!!ARBfp1.0\nOPTION NV_fragment_program;\n"
                        : "!!ARBvp1.0\nOPTION NV_vertex_program2;\n";
    option += "TEMP R0, R1, R2, R3, N;\nPARAM c[4] = { program." +
              std::string(m_fragment ? "local" : "env") + "[0..3] };\n";
    option += m_fragment ? "" : "ADDRESS A0;\n";
    if (!m_fragment)
      both("ARL A0.x, ", 0, ";\n");
    for (int i = 0; i < 24; ++i)
      statement();
    for (; m_labels > 0; --m_labels)
      same("l" + std::to_string(m_labels) + ": ");
    own += m_fragment ? "\nMOV o[COLR], R0;\nEND\n" : "\nMOV o[HPOS], R0;\nEND\n";
    option += m_fragment ? "\nMOV result.color, R0;\nEND\n" : "\nMOV result.position, R0;\nEND\n";
  }

  std::string own, option;

private:
  [[nodiscard]] bool isSecond() const { return m_language == NativeLanguage::Vp2; }
  std::uint32_t below(std::uint32_t limit) {
    m_state ^= m_state << 13;
    m_state ^= m_state >> 17;
    m_state ^= m_state << 5;
    return m_state % limit;
  }
  bool chance(std::uint32_t percent) { return below(100) < percent; }
  void same(const std::string &piece) {
    own += piece;
    option += piece;
  }
  std::string temporary() { return "R" + std::to_string(below(kTemporaries)); }

  std::string swizzle(bool scalar) {
    std::string word = ".";
    for (int i = 0; i < (scalar ? 1 : 4); ++i)
      word += "xyzw"[below(4)];
    return word;
  }

  /// Writes the row of the first parameter in both forms.
  void both(const std::string &before, std::uint32_t row, const std::string &behind) {
    const std::string index = "[" + std::to_string(row) + "].x";
    own += before + (m_fragment ? "p" : "c") + index + behind;
    option += before + "c" + index + behind;
  }

  void operand(bool scalar) {
    const bool bars = m_conditions && chance(20);
    const std::string suffix = scalar || chance(50) ? swizzle(scalar) : "";
    same(std::string(chance(25) ? "-" : "") + (bars ? "|" : ""));
    if (chance(60)) {
      same(temporary());
    } else if (chance(70)) {
      const bool relative = !m_fragment && m_relative;
      const std::string index =
          relative ? "[A0.x+" + std::to_string(m_row) + "]" : "[" + std::to_string(m_row) + "]";
      own += (m_fragment ? "p" : "c") + index;
      option += "c" + index;
    } else {
      own += m_fragment ? "f[TEX1]" : "v[TEX1]";
      option += m_fragment ? "fragment.texcoord[1]" : "vertex.texcoord[1]";
    }
    same(suffix + (bars ? "|" : ""));
  }

  std::string condition() {
    constexpr const char *kRules[] = {"EQ", "GE", "GT", "LE", "LT", "NE", "TR", "FL"};
    return std::string(kRules[below(8)]) + (chance(50) ? swizzle(chance(50)) : "");
  }

  std::string suffix(const ir::OpInfo &op) {
    std::string word;
    if (m_fragment && !op.has(ir::NoPrecision) && chance(40))
      word += op.has(ir::NoFixed) || chance(50) ? (chance(50) ? "R" : "H") : "X";
    if (m_conditions && !op.has(ir::NoCondition) && chance(40))
      word += "C";
    if (m_fragment && !op.has(ir::NoSaturate) && chance(20))
      word += "_SAT";
    return word;
  }

  void statement() {
    if (isSecond() && chance(10))
      return same("BRA l" + std::to_string(++m_labels) + " (" + condition() + ");\n");
    if (m_fragment && chance(4))
      return same("KIL " + condition() + ";\n");
    const auto op = Opcode(below(ir::kOpcodeRowCount));
    const ir::OpInfo &row = info(op);
    const bool packs =
        int(op) >= ir::kOpcodeCount && int(op) < ir::kCodeOpcodeCount && ir::carriesBits(op);
    if (!nv::offers(m_language, op) || packs || row.has(ir::Flow) || row.has(ir::Kills) ||
        op == Opcode::Arl || op == Opcode::Arr || op == Opcode::Ara || op == Opcode::Rsq ||
        op == Opcode::Pow)
      return statement();
    m_row = below(kParameters);
    m_relative = chance(30);
    const bool null = m_conditions && chance(10);
    const std::string name = row.mnemonic + suffix(row) + " ";
    const std::string target = temporary();
    own += name + (!null ? target : m_fragment ? "RC" : "CC");
    option += name + (null ? "N" : target);
    constexpr const char *kMasks[] = {"", ".x", ".yz", ".xw", ".xyz", ".w"};
    same(kMasks[below(6)] +
         (m_conditions && chance(40) ? " (" + condition() + ")" : std::string()));
    for (int i = 0; i < row.operandCount(); ++i) {
      same(", ");
      operand(row.shapes[i] == 'S');
    }
    own += row.has(ir::Texture) ? ", TEX0, 2D;\n" : ";\n";
    option += row.has(ir::Texture) ? ", texture[0], 2D;\n" : ";\n";
  }

  std::uint32_t m_state;
  NativeLanguage m_language;
  bool m_fragment, m_conditions;
  std::uint32_t m_row = 0; ///< the one parameter of the statement
  bool m_relative = false;
  int m_labels = 0;
};

ir::Evaluation run(const ir::Program &program) {
  ir::Inputs given;
  const std::vector<Vec4> attributes(program.attributes.size(), Vec4{0.75f, -1.5f, 2, 1});
  given.attributes = attributes;
  given.parameter = [](const ir::Parameter &parameter) -> Vec4 {
    using testing::kInf, testing::kNan;
    constexpr Vec4 kRows[] = {
        {-2, 0, 2, kNan}, {1, 2, 3, 4}, {0.5f, -0.25f, 1.75f, -0.0f}, {kInf, -kInf, 1e30f, 7}};
    return parameter.index < kParameters ? kRows[parameter.index] : Vec4{};
  };
  given.texture = [](const ir::Sample &sample) {
    return Vec4{sample.coordinate[0], 0.5f, sample.lod.value_or(-1), 1};
  };
  return ir::evaluate(program, given);
}

bool equal(const Vec4 &a, const Vec4 &b) {
  for (std::size_t i = 0; i < 4; ++i)
    if (std::bit_cast<std::uint32_t>(a[i]) != std::bit_cast<std::uint32_t>(b[i]) &&
        !(std::isnan(a[i]) && std::isnan(b[i])))
      return false;
  return true;
}

TEST(NativeRandom, TheSameAsUnderTheOptions) {
  constexpr std::uint32_t kPrograms = 120;
  std::uint32_t compared = 0;
  for (const NativeLanguage language :
       {NativeLanguage::Fp1, NativeLanguage::Vp1, NativeLanguage::Vp11, NativeLanguage::Vp2}) {
    for (std::uint32_t seed = 0; seed < kPrograms; ++seed) {
      const Writer writer(seed, language);
      CheckResult own = testing_support::check(writer.own, testing_support::offering(1));
      const CheckResult option =
          testing_support::check(writer.option, testing_support::offering(1));
      ASSERT_TRUE(own.ok()) << own.errorString(writer.own) << writer.own;
      ASSERT_TRUE(option.ok()) << option.errorString(writer.option) << writer.option;
      EXPECT_EQ(own.counts.instructions, option.counts.instructions) << writer.own;
      ASSERT_TRUE(ir::validate(*own.program).empty()) << writer.own;
      const ir::Evaluation expected = run(*option.program), before = run(*own.program);
      optimise(*own.program);
      ASSERT_TRUE(ir::validate(*own.program).empty()) << writer.own;
      const ir::Evaluation after = run(*own.program);
      ASSERT_EQ(expected.killed, before.killed) << writer.own;
      ASSERT_EQ(expected.killed, after.killed) << writer.own;
      if (expected.killed)
        continue;
      ASSERT_TRUE(equal(before.outputs.at(0), expected.outputs.at(0)))
          << writer.own << writer.option;
      ASSERT_TRUE(equal(after.outputs.at(0), expected.outputs.at(0)))
          << writer.own << ir::print(*own.program);
      ++compared;
    }
  }
  EXPECT_GT(compared, 3 * kPrograms);
}

} // namespace
} // namespace arbiter::fp
