#pragma once
#include <cstring>
#include <gtest/gtest.h>
#include <span>

#include "fp_compiler/front/testing/test_support.h"

/// Tests programs with one planted error each.
namespace arbiter::fp::testing_support {

/// Statements of a program with @ before the first wrong byte. R0 and R1 are temporaries.
struct Planted {
  const char *id;
  const char *statements;
};

/// Text between the header and the planted statements, and the replacement of their newlines.
struct Surrounding {
  const char *name;
  const char *before;
  const char *newline;
};

inline constexpr Surrounding kSurroundings[] = {
    {"LF", "\nTEMP R0, R1;\n", "\n"},
    {"CRLF and comments", "\r\n# a comment; MOV x, y;\r\n\r\n\tTEMP R0,R1;#\r\n",
     " # it's \xE4\r\n"},
    {"CR only", "\r#\rTEMP R0 , R1\r;", "\r"},
    {"one line", "TEMP R0,R1;", " "},
};

inline std::string replaceNewlines(std::string_view text, std::string_view newline) {
  std::string replaced;
  for (char c : text)
    replaced += c == '\n' ? std::string(newline) : std::string(1, c);
  return replaced;
}

/// Expects each ID at its position in each surrounding. Returns the number of programs.
inline int expectPlanted(const char *header, std::span<const Planted> all) {
  int programs = 0;
  for (const Surrounding &around : kSurroundings) {
    for (const Planted &planted : all) {
      if (std::string_view(around.newline) == " " && std::strchr(planted.statements, '#'))
        continue; // on one line a comment would hide the rest
      std::string text = header;
      text += around.before;
      text += replaceNewlines(planted.statements, around.newline);
      const std::size_t marker = text.find('@');
      EXPECT_NE(marker, std::string::npos) << planted.statements;
      text.erase(marker, 1);
      const CheckResult result = check(text);
      EXPECT_EQ(firstError(result), planted.id) << around.name << ": " << planted.statements;
      EXPECT_EQ(result.errorPosition(), std::int32_t(marker))
          << around.name << ": " << planted.statements << "\n"
          << result.errorString(text);
      ++programs;
    }
  }
  return programs;
}

/// Expects each ID at its position in whole texts of one language.
inline void expectPlantedHeaders(ir::Language language, std::span<const Planted> all) {
  for (const Planted &planted : all) {
    std::string text = planted.statements;
    const std::size_t marker = text.find('@');
    text.erase(marker, 1);
    const CheckResult result = checkProgram(language, text, small());
    EXPECT_EQ(firstError(result), planted.id) << planted.statements;
    EXPECT_EQ(result.errorPosition(), std::int32_t(marker)) << planted.statements;
  }
}

} // namespace arbiter::fp::testing_support
