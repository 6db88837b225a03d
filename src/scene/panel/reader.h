#pragma once
#include <string>

#include "scene/panel/panel.h"
#include "scene/panel/token.h"

/// What the parts of the parser share: a place in one line, and how to complain of it.
namespace arbiter::scene {

inline constexpr int kMaxNesting = 3; ///< of "of"

/// Every read function returns false after an error or a warning; the rest of the clause is then
/// skipped.
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
  /// Where the token that was taken last ends.
  [[nodiscard]] std::uint32_t last() const { return m_last; }
  [[nodiscard]] Panel &panel() { return m_panel; }

  bool error(fp::Span span, const char *id, std::string message, std::string hint = {});
  bool warning(fp::Span span, const char *id, std::string message, std::string hint = {});
  /// An error at the token here: "expected WHAT".
  bool expected(const std::string &what, std::string hint = {});
  /// A warning of the word here, which is none of \p rows.
  bool unknownWord(const std::string &what, std::span<const WordRow> rows);

  bool number(const std::string &what, double low, double high, Number &number);
  bool integer(const std::string &what, double low, double high, Number &number);
  /// A word or a string.
  bool name(const std::string &what, Name &name);
  /// A name of a file beside the document: no absolute one, none that leads out of the folder.
  bool file(const std::string &what, Name &name);
  bool onOff(bool &on);
  /// A warning of what a clause that is read already goes on with.
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
  /// One "name number" of the word, if one stands here. \returns false if it is wrong.
  bool argument(const WordRow &row, Arguments &arguments, bool &found);

  /// "one of checker, noise ..".
  static std::string wordList(std::span<const WordRow> rows);

private:
  void add(fp::Severity severity, fp::Span span, const char *id, std::string message,
           std::string hint);

  std::vector<Token> m_tokens;
  Panel &m_panel;
  std::size_t m_at = 0;
  std::uint32_t m_last = 0;
};

/// Each reads what follows the clause's first word.
bool readMesh(Reader &reader);
bool readCamera(Reader &reader);
bool readCoordinate(Reader &reader);
bool readParameter(Reader &reader, Setting space, std::uint32_t begin);
bool readTexture(Reader &reader, std::uint32_t begin);
/// A clause behind a texture's: filter, wrap or compare, of the last texture if \p good.
/// \returns whether it was one.
bool readSampler(Reader &reader, bool good);
bool readSetting(Reader &reader, Setting setting, std::uint32_t begin);

} // namespace arbiter::scene
