// Tests that every opcode, suffix and rule of NVIDIA's options and languages has a case in
// opcode_cases.def. Each case must hold before and after optimisation, and agree with NVIDIA's
// driver.
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/opcode_frame.h"
#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/ir/validate.h"

namespace arbiter::fp::nv {
namespace {

using ir::NativeLanguage;
using ir::Vec4;
using testing::kLanguages;
using testing::Language;
using testing::translated;
using testing::wholeText;

struct Case {
  const char *languages, *sources, *statements, *value, *nvidia;
};
constexpr Case kCases[] = {
#define OPCODE_CASE(languages, sources, statements, value, nvidia)                                 \
  {languages, sources, statements, value, nvidia},
#include "fp_compiler/front/nv/opcode_cases.def"
};
struct ConditionCase {
  const char *rule, *value, *nvidia;
};
constexpr ConditionCase kConditionCases[] = {
#define CONDITION_CASE(rule, value, nvidia) {rule, value, nvidia},
#include "fp_compiler/front/nv/opcode_cases.def"
};

std::optional<ir::Opcode> opcodeOf(std::string_view mnemonic) {
  for (int i = 0; i < ir::kOpcodeRowCount; ++i)
    if (mnemonic == ir::info(ir::Opcode(i)).mnemonic)
      return ir::Opcode(i);
  return {};
}

std::vector<std::optional<float>> numbers(const std::string &text) {
  std::vector<std::optional<float>> values;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    values.push_back(word == "_" ? std::nullopt
                                 : std::optional(std::strtof(word.c_str(), nullptr)));
  return values;
}

bool near(float value, float expected) {
  if (std::isnan(expected) || std::isinf(expected))
    return std::isnan(expected) ? std::isnan(value) : value == expected;
  return std::fabs(value - expected) <= 2e-6f * std::max(std::fabs(expected), 1e-30f) ||
         std::fabs(value - expected) <= 2e-7f;
}

/// Checks a case.
/// \param change applies the suffix to a component of the case's value
template <typename Change>
void expectCase(const Language &language, const Case &each, const std::string &statements,
                const std::string &behind, Change change) {
  CompileOptions options = testing_support::generous();
  options.limits.nvOptions = 2;
  options.limits.localParameters = 64;
  const std::string text = wholeText(language, each.sources, statements, behind);
  CheckResult result = testing_support::check(text, options);
  ASSERT_TRUE(result.ok()) << text << result.errorString(text);
  for (const bool optimised : {false, true}) {
    if (optimised)
      optimise(*result.program);
    EXPECT_TRUE(ir::validate(*result.program).empty()) << text;
    const ir::Evaluation evaluation = testing::evaluated(*result.program);
    const std::string where =
        text + (optimised ? "optimised:\n" : "lowered:\n") + ir::print(*result.program);
    const bool killed = std::string_view(each.value) == "killed";
    EXPECT_EQ(evaluation.killed, killed) << where;
    if (killed)
      continue;
    const auto expected = numbers(each.value);
    ASSERT_EQ(expected.size(), 4u) << each.statements;
    const Vec4 &value = evaluation.outputs.back();
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_TRUE(near(value[i], change(*expected[i])))
          << "component " << i << " is " << value[i] << " and not " << change(*expected[i]) << "\n"
          << where;
  }
}

/// Replaces each star by nothing, or by the suffix if it follows the given opcode.
std::string suffixed(std::string statements, std::string_view mnemonic, const std::string &suffix) {
  for (auto star = statements.find('*'); star != std::string::npos; star = statements.find('*')) {
    const std::string_view before = std::string_view(statements).substr(0, star);
    const bool same =
        before.ends_with(mnemonic) &&
        (before.size() == mnemonic.size() ||
         !std::isalnum(static_cast<unsigned char>(before[before.size() - mnemonic.size() - 1])));
    statements.replace(star, 1, same ? suffix : "");
  }
  return statements;
}

/// Returns the opcodes with stars, and whether they write r.
std::map<std::string, bool> starred(const std::string &statements) {
  std::map<std::string, bool> result;
  for (auto star = statements.find('*'); star != std::string::npos;
       star = statements.find('*', star + 1)) {
    std::size_t begin = star;
    while (begin > 0 && std::isalnum(static_cast<unsigned char>(statements[begin - 1])))
      --begin;
    result[statements.substr(begin, star - begin)] = statements.compare(star + 1, 2, " r") == 0;
  }
  return result;
}

bool isOf(const Language &language, const Case &each) {
  std::istringstream names(each.languages);
  bool any = false, named = false;
  for (std::string name; names >> name; any = true)
    named |= name == language.name;
  for (const auto &[mnemonic, writes] : starred(each.statements))
    if (!language.has(*opcodeOf(mnemonic)))
      return false;
  return named || !any;
}

constexpr const char *kPrecisions[] = {"", "R", "H", "X"};
constexpr const char *kUpdates[] = {"", "C", "C0", "C1"};
constexpr const char *kSaturations[] = {"", "_SAT", "_SSAT"};

void runSuffix(const Language &language, const Case &each, const std::string &mnemonic, bool writes,
               const std::string &suffix) {
  const Word word = language.word(mnemonic + suffix);
  const bool spelled = word.keyword == Keyword::Opcode && word.op == opcodeOf(mnemonic);
  if (!spelled)
    return;
  if (!writes && (word.saturate || word.nv.signedSaturate))
    return; // of an address: another row
  std::string behind;
  if (writes && word.nv.updates != 0) {
    const std::string test = word.nv.updates == 2 ? "1" : "";
    behind = translated(language, "MOV t, k.x; MOV t (GT" + test + "), k.y; MOV t (LT" + test +
                                      "), k.z; MOV r, t;\n");
  }
  expectCase(language, each, suffixed(each.statements, mnemonic, suffix), behind, [&](float value) {
    if (word.saturate)
      value = ir::saturated(value);
    if (word.nv.signedSaturate)
      value = std::isnan(value) ? -1.0f : std::min(std::max(value, -1.0f), 1.0f);
    if (!behind.empty())
      value = value > 0 ? 1.0f : value < 0 ? -1.0f : 0.0f;
    return value;
  });
}

TEST(NvOpcodeCases, EachValueWithEachSuffix) {
  for (const Language &language : kLanguages)
    for (const Case &each : kCases) {
      if (!isOf(language, each))
        continue;
      SCOPED_TRACE(language.name);
      for (const auto &[mnemonic, writes] : starred(each.statements))
        for (const char *const precision : kPrecisions)
          for (const char *const update : kUpdates)
            for (const char *const saturation : kSaturations)
              runSuffix(language, each, mnemonic, writes,
                        std::string(precision) + update + saturation);
      if (::testing::Test::HasFatalFailure())
        return;
    }
}

TEST(NvOpcodeCases, EachRule) {
  for (const Language &language : kLanguages) {
    if (!language.conditions())
      continue;
    for (const ConditionCase &each : kConditionCases)
      for (const std::string code : {"", "0", "1"}) {
        const bool second = language.word("MOVC1").keyword == Keyword::Opcode;
        if (!code.empty() && !second)
          continue;
        SCOPED_TRACE(language.name);
        const Case made = {"", "0", "", each.value, each.nvidia};
        expectCase(language, made, "MOVC" + code + " s, a; MOV r (" + each.rule + code + "), k.y;",
                   "", [](float value) { return value; });
      }
  }
}

/// Compares the cases with the driver's answers.
TEST(NvOpcodeCases, AreAsNvidiaHasThem) {
  const auto compare = [](const char *value, const std::string &nvidia, const char *what) {
    if (nvidia == value)
      return;
    const auto computed = numbers(value), theirs = numbers(nvidia);
    ASSERT_EQ(computed.size(), theirs.size()) << what;
    for (std::size_t i = 0; i < computed.size(); ++i)
      EXPECT_TRUE(!theirs[i] || near(*computed[i], *theirs[i])) << what << " component " << i;
  };
  for (const Case &each : kCases)
    compare(each.value, each.nvidia, each.statements);
  for (const ConditionCase &each : kConditionCases)
    compare(each.value, each.nvidia, each.rule);
}

/// Fails for a new opcode, rule or suffix without a case.
TEST(NvOpcodeCases, NothingLacksOne) {
  for (const Language &language : kLanguages) {
    std::set<std::string> cases;
    for (const Case &each : kCases)
      if (isOf(language, each))
        for (const auto &[mnemonic, writes] : starred(each.statements))
          cases.insert(mnemonic);
    for (int i = 0; i < ir::kOpcodeRowCount; ++i) {
      const std::string mnemonic = ir::info(ir::Opcode(i)).mnemonic;
      if (!language.has(ir::Opcode(i)))
        continue;
      EXPECT_TRUE(cases.contains(mnemonic)) << language.name << ": no case of " << mnemonic;
      for (const char letter : std::string("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789")) {
        const Word word = language.word(mnemonic + letter);
        const bool isSuffix = word.keyword == Keyword::Opcode && word.op == ir::Opcode(i);
        EXPECT_TRUE(!isSuffix || std::string("RHXC").find(letter) != std::string::npos)
            << language.name << ": no case has the suffix of " << mnemonic << letter;
      }
    }
  }
  for (int rule = 0; rule <= int(Rule::Fl); ++rule)
    EXPECT_TRUE(
        std::any_of(std::begin(kConditionCases), std::end(kConditionCases),
                    [&](const ConditionCase &each) { return ruleOf(each.rule) == Rule(rule); }))
        << "no case of rule " << rule;
  // State programs must have the opcodes of !!VP1.0.
  for (int i = 0; i < ir::kOpcodeRowCount; ++i)
    EXPECT_EQ(offers(NativeLanguage::Vsp1, ir::Opcode(i)),
              offers(NativeLanguage::Vp1, ir::Opcode(i)));
}

} // namespace
} // namespace arbiter::fp::nv
