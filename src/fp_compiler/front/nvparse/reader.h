#pragma once
#include <initializer_list>
#include <string>
#include <string_view>

#include "fp_compiler/front/nvparse/text.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/words/word_tokens.h"

namespace arbiter::fp::nvparse {

/// The common part of both parsers: tokens, numbers, reports. A function that returns bool returns
/// false after it has reported a syntax error. The statement is then skipped.
class Reader {
public:
  Reader(WordTokens &tokens, std::string_view text, const CompileOptions &options,
         Reporter &reporter, NameTable *names)
      : m_tokens(tokens), m_text(text), m_options(options), m_reporter(reporter), m_names(names) {}

protected:
  [[nodiscard]] std::string_view text(const Token &token) const { return m_tokens.text(token); }
  bool expect(TokenKind kind, const char *what, std::string hint = {});
  bool unexpected(const char *expected, std::string hint = {});
  /// Expects the semicolon of a statement.
  bool endStatement(const char *expected = "';'");
  /// Parses "()".
  bool parseEmpty();
  /// Parses a number with an optional sign.
  bool parseNumber(float &value);
  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  void warning(DiagnosticId id, Span span, std::string message, std::string hint = {});
  /// Reports an error, or a warning if limits are only reported.
  void limit(DiagnosticId id, Span span, std::string message, std::string hint = {});
  /// Reports a word that is not one of the allowed words.
  bool unknownWord(const char *expected, std::initializer_list<std::string_view> words);
  void note(const Token &name, Access access, SymbolKind kind);
  /// Skips past the next semicolon, or up to the end of a block or of the text.
  void recover();

  WordTokens &m_tokens;
  std::string_view m_text;
  const CompileOptions &m_options;
  Reporter &m_reporter;
  NameTable *m_names; ///< null where names are not wanted
};

} // namespace arbiter::fp::nvparse
