#pragma once
#include <string>

#include "apps/scene/panel/panel.h"
#include "apps/scene/panel/token.h"

/// The parser's position in one line, and its diagnostics; all parts of the parser use it.
namespace arbiter::scene {

inline constexpr int kMaxNesting = 3; ///< of "of"

/// Reads the tokens of a line. Every read function returns false after an error or a warning; the
/// rest of the clause is then skipped.
class Reader {
public:
  Reader(std::vector<Token> tokens, Panel &panel) : m_tokens(std::move(tokens)), m_panel(panel) {}

  [[nodiscard]] const Token &peek(std::size_t ahead = 0) const {
    return m_tokens[std::min(m_at + ahead, m_tokens.size() - 1)];
  }
  const Token &take() {
    const Token &token = peek();
    m_last = token.span.end;
    m_at += m_at + 1 < m_tokens.size();
    return token;
  }
  [[nodiscard]] bool at(TokenKind kind) const { return peek().kind == kind; }
  [[nodiscard]] bool atWord(std::string_view word) const {
    return at(TokenKind::Word) && peek().text == word;
  }
  [[nodiscard]] bool atEnd() const { return at(TokenKind::End) || at(TokenKind::Comma); }
  bool accept(TokenKind kind) { return at(kind) && (take(), true); }
  bool acceptWord(std::string_view word) { return atWord(word) && (take(), true); }
  void skipClause();
  /// Returns the end of the last taken token.
  [[nodiscard]] std::uint32_t last() const { return m_last; }
  [[nodiscard]] Panel &panel() { return m_panel; }

  bool error(fp::Span span, const char *id, std::string message, std::string hint = {});
  bool warning(fp::Span span, const char *id, std::string message, std::string hint = {});
  /// Reports an error at the next token: "expected WHAT".
  bool expected(const std::string &what, std::string hint = {});
  /// Warns that the next word is not in \p rows.
  bool unknownWord(const std::string &what, std::span<const WordRow> rows);

  bool number(const std::string &what, double low, double high, Number &number);
  bool integer(const std::string &what, double low, double high, Number &number);
  /// Reads a word or a string.
  bool name(const std::string &what, Name &name);
  /// Reads the name of a file beside the document. Absolute names, and names that leave the folder,
  /// are errors.
  bool file(const std::string &what, Name &name);
  bool onOff(bool &on);
  /// Warns of unexpected words behind a complete clause.
  bool leftOver();

  template <typename Enum> bool word(const std::string &what, Chosen<Enum> &chosen) {
    if (!at(TokenKind::Word))
      return expected(what, wordList(wordsOf<Enum>()));
    const auto found = findWord<Enum>(peek().text);
    if (!found)
      return unknownWord(what, wordsOf<Enum>());
    chosen = {*found, take().span};
    return true;
  }
  /// Fills in the defaults of the word's arguments.
  static void defaults(const WordRow &row, Arguments &arguments);
  /// Reads one "name number" of the word, if there is one. \returns false if it is wrong.
  bool argument(const WordRow &row, Arguments &arguments, bool &found);

  /// Returns "one of checker, noise ..".
  static std::string wordList(std::span<const WordRow> rows);

private:
  void add(fp::Severity severity, fp::Span span, const char *id, std::string message,
           std::string hint);

  std::vector<Token> m_tokens;
  Panel &m_panel;
  std::size_t m_at = 0;
  std::uint32_t m_last = 0;
};

/// These functions read what follows the clause's first word.
bool readMesh(Reader &reader);
bool readCamera(Reader &reader);
bool readCoordinate(Reader &reader);
bool readParameter(Reader &reader, Setting space, std::uint32_t begin);
bool readTexture(Reader &reader, std::uint32_t begin);
/// Reads a clause behind a texture's: filter, wrap or compare. It applies to the last texture if \p
/// good.
/// \returns true if it was one.
bool readSampler(Reader &reader, bool good);
bool readSetting(Reader &reader, Setting setting, std::uint32_t begin);

} // namespace arbiter::scene
