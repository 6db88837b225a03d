// Compares the words of NVIDIA's options and languages with the specifications' tables
// (specified.def). It fails for an opcode, a precision, a condition or a saturation that only one
// side has. opcode_cases.def covers what each opcode computes.
#include <map>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/opcode_frame.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::nv {
namespace {

using testing::kLanguages;
using testing::Language;

constexpr const char *kSpecified[][3] = {
#define SPECIFIED(language, modifiers, opcodes) {language, modifiers, opcodes},
#define TAKEN(language, modifiers, opcodes) {language, modifiers, opcodes},
#include "fp_compiler/front/nv/specified.def"
};

/// Returns the modifiers of each opcode of a language, including the rows of TAKEN.
std::map<std::string, std::string> specified(const std::string &language) {
  std::map<std::string, std::string> result;
  for (const auto &[name, modifiers, opcodes] : kSpecified) {
    std::istringstream words(language == name ? opcodes : "");
    for (std::string word; words >> word;)
      result[word] = modifiers;
  }
  return result;
}

bool spells(const Language &language, const std::string &text, ir::Opcode op) {
  const Word word = language.word(text);
  return word.keyword == Keyword::Opcode && word.op == op;
}

TEST(NvSpecified, OpcodesAreTheTables) {
  for (const Language &language : kLanguages) {
    auto left = specified(language.name);
    for (int i = 0; i < ir::kOpcodeRowCount; ++i) {
      const std::string mnemonic = ir::info(ir::Opcode(i)).mnemonic;
      EXPECT_EQ(language.has(ir::Opcode(i)), left.erase(mnemonic) > 0)
          << language.name << ": " << mnemonic;
    }
    for (const auto &[mnemonic, modifiers] : left)
      ADD_FAILURE() << language.name << ": no opcode " << mnemonic;
  }
}

TEST(NvSpecified, ModifiersAreTheTables) {
  constexpr struct {
    char column;
    const char *suffix;
  } kSuffixes[] = {{'R', "R"}, {'H', "H"}, {'X', "X"}, {'C', "C"}, {'S', "_SAT"}};
  for (const Language &language : kLanguages) {
    const auto rows = specified(language.name);
    for (int i = 0; i < ir::kOpcodeRowCount; ++i) {
      const auto op = ir::Opcode(i);
      const auto row = rows.find(ir::info(op).mnemonic);
      if (row == rows.end())
        continue;
      const auto &[mnemonic, modifiers] = *row;
      for (const auto &[column, suffix] : kSuffixes)
        EXPECT_EQ(spells(language, mnemonic + suffix, op),
                  modifiers.find(column) != std::string::npos)
            << language.name << ": " << mnemonic << suffix;
      const bool isSigned = std::string(language.name) == "F2" && modifiers.ends_with('S');
      EXPECT_EQ(spells(language, mnemonic + "_SSAT", op), isSigned)
          << language.name << ": " << mnemonic << "_SSAT";
    }
  }
}

} // namespace
} // namespace arbiter::fp::nv
