#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

#include "fp_compiler/front/core/reader.h"
#include "fp_compiler/front/nvparse/text.h"

namespace arbiter::fp::nvparse {

/// The common part of both parsers: their words, numbers and limits.
class Reader : protected fp::Reader {
protected:
  Reader(const SourceText &source, const CompileOptions &options)
      : fp::Reader(source, Words::Calls), m_options(options) {}

  /// Returns whether a word is next, with which every statement begins. Reports and consumes
  /// another token.
  bool atStatement(const char *expected);
  /// Parses "()".
  bool parseEmpty();
  /// Parses a number with an optional sign.
  bool parseNumber(float &value);
  /// Reports an error, or a warning if limits are only reported.
  void limit(DiagnosticId id, Span span, std::string message, std::string hint = {});
  /// Reports a word that is not one of the allowed words.
  bool unknownWord(const char *expected, std::initializer_list<std::string_view> words);

  [[nodiscard]] bool endsStatement(const Token &token) const override {
    return token.kind == TokenKind::CloseBrace;
  }
  [[nodiscard]] bool mayResume() const override { return endsStatement(m_tokens.peek()); }
  [[nodiscard]] std::string hintAt(const Token &token) const override;

  const CompileOptions &m_options;
};

} // namespace arbiter::fp::nvparse
