#pragma once
#include <gtest/gtest.h>
#include <string>

#include "fp_compiler/front/nvparse/text.h"

namespace arbiter::fp::nvparse {

/// Returns limits of a card with all that the texts can name.
inline CompileOptions wholeCard(std::uint32_t units = 8) {
  CompileOptions options;
  options.limits.generalCombiners = 8;
  options.limits.perStageConstants = 1;
  options.limits.textureShaders = 3;
  options.limits.textureUnits = units;
  return options;
}

/// A text and what it was read as.
struct ParsedText {
  std::string text;
  ParseResult result;
  ParsedText(ir::Language language, std::string whole, const CompileOptions &options)
      : text(std::move(whole)), result(parse(language, text, options)) {}
  [[nodiscard]] std::string said() const { return renderAll("text", text, result.diagnostics); }
};

/// Expects the first diagnostic and the part of the text that it marks.
inline void expectFinding(const ParsedText &parsed, const char *id, const std::string &piece,
                          bool isError = true) {
  ASSERT_FALSE(parsed.result.diagnostics.empty()) << parsed.text;
  EXPECT_EQ(!parsed.result.text, isError) << parsed.said();
  const Diagnostic &first = parsed.result.diagnostics.front();
  EXPECT_EQ(first.id, std::string(id)) << parsed.said();
  EXPECT_EQ(parsed.text.substr(first.span.begin, first.span.end - first.span.begin), piece)
      << parsed.said();
}

} // namespace arbiter::fp::nvparse
