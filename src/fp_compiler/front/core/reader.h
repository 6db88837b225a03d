#pragma once
#include <string>
#include <string_view>

#include "fp_compiler/front/core/unexpected.h"
#include "fp_compiler/front/header.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/reporter.h"
#include "fp_compiler/front/words/names.h"
#include "fp_compiler/limits.h"

namespace arbiter::fp {

/// A text that a parser reads.
struct SourceText {
  std::string_view text;
  std::uint32_t begin; ///< of the statements
  Reporter &reporter;
  NameTable *names; ///< gets every name of the text; null where names are not wanted
};

/// The core of every front end's parser: tokens, reports, recovery. The parser derives from it and
/// has one function for each statement. A function that returns bool returns false after it has
/// reported a syntax error. The statement is then skipped, and parsing continues at the next one.
/// After a semantic error the statement continues.
class Reader {
protected:
  Reader(const SourceText &source, Words words)
      : m_text(source.text), m_reporter(source.reporter), m_names(source.names),
        m_tokens(source.text, source.begin, words) {}
  Reader(const Reader &) = delete;
  Reader &operator=(const Reader &) = delete;
  virtual ~Reader() = default;

  [[nodiscard]] std::string_view text(const Token &token) const { return m_tokens.text(token); }
  [[nodiscard]] Span spanFrom(std::uint32_t begin) const { return {begin, m_tokens.lastEnd()}; }
  [[nodiscard]] bool at(TokenKind kind) const { return m_tokens.at(kind); }
  [[nodiscard]] bool atWord(std::string_view word, int ahead = 0) const;
  bool acceptWord(std::string_view word);
  /// True at a byte that is no token of most languages, such as a bar, a colon or a parenthesis.
  [[nodiscard]] bool atByte(char byte) const;
  bool acceptByte(char byte);
  bool expectByte(char byte);
  /// Consumes a sign, if there is one. Returns whether it is a minus.
  bool acceptSign();

  bool expect(TokenKind kind, const char *what, std::string hint = {});
  /// Consumes a word. \param what is expected
  bool expectWord(const char *what, Token &word);
  /// Consumes a numeral where the tokens are words. \param integer excludes a point and an exponent
  bool expectNumeral(const char *what, bool integer, Token &numeral);
  /// Parses the semicolon of a statement.
  bool endStatement(const char *expected = "';'", std::string hint = {});
  bool unexpected(const char *expected, std::string hint = {});
  virtual bool unexpectedToken(const Token &token, const char *expected, std::string hint = {});
  /// Returns whether a word is next, with which every statement begins. Reports and skips what
  /// stands in its place.
  bool atStatement(const char *expected, const char *hint = "");
  /// Goes on to the next statement, after an error.
  void recover();

  void error(DiagnosticId id, Span span, std::string message, std::string hint = {});
  void warning(DiagnosticId id, Span span, std::string message, std::string hint = {});
  /// Declares a name here, or reports that it is declared twice.
  template <typename Names, typename Meaning>
  void declareIn(Names &names, const Token &name, Meaning meaning, SymbolKind kind) {
    note(name, Access::Declare, kind);
    meaning.declared = name.span;
    if (const Meaning *const before = names.declare(text(name), meaning))
      redeclared(name, before->declared);
  }
  /// Adds the name to the table of names, if there is one.
  void note(const Token &name, Access access, SymbolKind kind = SymbolKind::Unknown) {
    if (m_names)
      m_names->add(text(name), name.span, access, kind);
  }

  // The differences between the languages.
  /// True for a token that begins another statement, or ends the block.
  [[nodiscard]] virtual bool endsStatement(const Token &token) const = 0;
  /// True if the next token is one at which recover() may stop.
  [[nodiscard]] virtual bool mayResume() const;
  /// Takes note of a token that recover() skips.
  virtual void skipped(const Token &) {}
  /// Returns the bytes that are tokens of the language besides those of the lexer.
  [[nodiscard]] virtual std::string_view ownBytes() const { return {}; }
  /// Returns the hint for an unexpected token that has none.
  [[nodiscard]] virtual std::string hintAt(const Token &) const { return {}; }
  [[nodiscard]] bool isByteOf(const Token &token, std::string_view bytes) const;

  std::string_view m_text;
  Reporter &m_reporter;
  NameTable *m_names; ///< null where names are not wanted
  TokenStream m_tokens;

private:
  void redeclared(const Token &name, Span before);
};

/// Checks the header of a text, and calls \p parse with the source and the result. If \p names is
/// not null, a text with a wrong header is parsed too.
template <typename Result, typename Parse>
[[nodiscard]] Result readText(std::string_view header, std::string_view text, NameTable *names,
                              const Parse &parse) {
  Reporter reporter;
  Result result;
  const bool good = checkHeader(header, text, reporter);
  if (good || (names && text.size() <= kMaxTextBytes)) {
    const auto begin = good ? std::uint32_t(header.size()) : endOfWrongHeader(text);
    parse(SourceText{text, begin, reporter, names}, result);
  }
  result.diagnostics = reporter.take();
  return result;
}

} // namespace arbiter::fp
