#include "apps/scene/edit.h"

#include <cassert>
#include <charconv>
#include <cmath>

#include "apps/scene/panel/token.h"

namespace arbiter::scene {

std::string numberText(double value) {
  const auto number = float(value);
  if (!std::isfinite(number))
    return "0";
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, number == 0 ? 0.0f : number);
  return {buffer, end.ptr};
}

Edit setNumber(const Number &number, double value) {
  assert(number.written());
  return {number.span, numberText(value)};
}

Edit addArgument(fp::Span word, std::string_view name, double value) {
  return {{word.end, word.end}, " " + std::string(name) + " " + numberText(value)};
}

Edit setWord(fp::Span word, std::string_view text) { return {word, std::string(text)}; }

Edit addLine(std::string_view text, std::string_view words) {
  const auto lines = panelLines(text);
  const std::size_t from = lines.empty() ? 0 : lines.back().begin;
  const std::size_t end = std::min(text.find_first_of("\r\n", from), text.size());
  const std::string_view rest = text.substr(end);
  const std::string ending(rest.starts_with("\r\n") ? "\r\n"
                           : rest.starts_with("\r") ? "\r"
                                                    : "\n");
  const auto at = std::uint32_t(end);
  return {{at, at}, ending + "#@ " + std::string(words)};
}

std::string applied(std::string_view text, const Edit &edit) {
  assert(edit.span.begin <= edit.span.end && edit.span.end <= text.size());
  std::string result(text.substr(0, edit.span.begin));
  result += edit.text;
  result += text.substr(edit.span.end);
  return result;
}

std::string withNumber(std::string_view text, const Number &number, double value) {
  return applied(text, setNumber(number, value));
}

} // namespace arbiter::scene
