#include "apps/scene/panel/reader.h"

#include <cmath>
#include <sstream>

#include "util/suggest.h"

namespace arbiter::scene {

namespace {

constexpr std::size_t kMaxName = 255; ///< bytes; the file systems' own limit of file names

std::string shown(double value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

/// Quotes text for a message. The bytes may end within a character, or be many.
std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::string shown(text.substr(0, kShown));
  for (char &c : shown)
    c = c >= ' ' && c <= '~' ? c : '?';
  return "'" + shown + (text.size() > kShown ? "..'" : "'");
}

/// Returns the words that are not empty.
std::vector<std::string_view> names(std::span<const WordRow> rows) {
  std::vector<std::string_view> words;
  for (const WordRow &row : rows)
    if (!row.word.empty())
      words.push_back(row.word);
  return words;
}

bool leadsOut(std::string_view name) {
  return name.empty() || name.front() == '/' || name.find('\\') != std::string_view::npos ||
         name.find('\0') != std::string_view::npos || name.find("..") != std::string_view::npos;
}

} // namespace

double Arguments::get(const WordRow &row, std::string_view name) const {
  const auto rows = row.arguments();
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].word == name)
      return numbers[i].value;
  return 0;
}

void Reader::add(fp::Severity severity, fp::Span span, const char *id, std::string message,
                 std::string hint) {
  if (m_panel.diagnostics.size() < kMaxPanelDiagnostics)
    m_panel.diagnostics.push_back({severity, id, span, std::move(message), std::move(hint)});
}

bool Reader::error(fp::Span span, const char *id, std::string message, std::string hint) {
  add(fp::Severity::Error, span, id, std::move(message), std::move(hint));
  return false;
}

bool Reader::warning(fp::Span span, const char *id, std::string message, std::string hint) {
  add(fp::Severity::Warning, span, id, std::move(message), std::move(hint));
  return false;
}

bool Reader::expected(const std::string &what, std::string hint) {
  const Token &token = peek();
  const std::string got = token.kind == TokenKind::End ? "the end of the line" : quoted(token.text);
  return error(token.span, "panel_syntax", "expected " + what + ", not " + got, std::move(hint));
}

bool Reader::unknownWord(const std::string &what, std::span<const WordRow> rows) {
  const Token &token = peek();
  const auto words = names(rows);
  const std::string_view near = nearest(token.text, words);
  return warning(token.span, "panel_word",
                 quoted(token.text) + " is no " + what + " and has no effect",
                 near.empty() ? wordList(rows) : "did you mean '" + std::string(near) + "'?");
}

void Reader::skipClause() {
  while (!atEnd())
    take();
}

bool Reader::number(const std::string &what, double low, double high, Number &number) {
  if (!at(TokenKind::Number))
    return expected(what, "a number from " + shown(low) + " to " + shown(high));
  const Token &token = peek();
  if (token.value < low || token.value > high)
    return error(token.digits(), "panel_range",
                 what + " is from " + shown(low) + " to " + shown(high));
  number = {token.value, token.digits()};
  take();
  return true;
}

bool Reader::integer(const std::string &what, double low, double high, Number &result) {
  const fp::Span span = peek().span;
  if (!number(what, low, high, result))
    return false;
  return result.value == std::floor(result.value) ||
         error(span, "panel_range", what + " is a whole number");
}

bool Reader::name(const std::string &what, Name &name) {
  if (!at(TokenKind::Word) && !at(TokenKind::String))
    return expected(what, "a word, or anything in double quotes");
  const Token &token = take();
  if (token.text.size() > kMaxName)
    return error(token.span, "panel_range", "a name has at most 255 bytes");
  name = {std::string(token.text), token.span};
  return true;
}

bool Reader::file(const std::string &what, Name &result) {
  if (!name(what, result))
    return false;
  return !leadsOut(result.text) ||
         error(result.span, "panel_file",
               quoted(result.text) + " leads out of the document's folder",
               "put the file beside the document and write its name alone");
}

bool Reader::leftOver() {
  return warning(peek().span, "panel_word", quoted(peek().text) + " has no meaning here",
                 "a comma begins the next setting");
}

bool Reader::onOff(bool &on) {
  if (!atWord("on") && !atWord("off"))
    return expected("on or off");
  on = take().text == "on";
  return true;
}

void Reader::defaults(const WordRow &row, Arguments &arguments) {
  const auto rows = row.arguments();
  for (std::size_t i = 0; i < rows.size(); ++i)
    arguments.numbers[i] = {rows[i].fallback, {}};
}

bool Reader::argument(const WordRow &row, Arguments &arguments, bool &found) {
  const auto rows = row.arguments();
  found = false;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!acceptWord(rows[i].word))
      continue;
    found = true;
    return number(std::string(rows[i].word), rows[i].low, rows[i].high, arguments.numbers[i]);
  }
  return true;
}

std::string Reader::wordList(std::span<const WordRow> rows) {
  std::string list;
  for (const std::string_view word : names(rows))
    list += (list.empty() ? "one of " : ", ") + std::string(word);
  return list;
}

} // namespace arbiter::scene
