#include "fp_compiler/front/c_like/tokens.h"

#include <algorithm>

#include "fp_compiler/span.h"
#include "util/text/letters.h"

namespace arbiter::fp::c_like {

namespace {

constexpr std::uint32_t kLongestShown = 32; ///< the longest operand that a hint repeats, in bytes

bool isOfOperand(char c) {
  return isLetterOrDigit(c) || std::string_view("_$.[]").find(c) != std::string_view::npos;
}

/// Returns the operand that ends before a byte, or begins there; empty if there is none.
std::string_view operandBefore(std::string_view text, std::uint32_t at) {
  while (at > 0 && text[at - 1] == ' ')
    --at;
  std::uint32_t begin = at;
  while (begin > 0 && at - begin < kLongestShown && isOfOperand(text[begin - 1]))
    --begin;
  return text.substr(begin, at - begin);
}
/// Returns the operand that begins behind a byte, with its sign.
std::string_view operandAfter(std::string_view text, std::uint32_t at) {
  while (at < text.size() && text[at] == ' ')
    ++at;
  std::uint32_t end = at;
  if (end + 1 < text.size() && text[end] == '-' && isOfOperand(text[end + 1]))
    ++end;
  while (end < text.size() && end - at < kLongestShown && isOfOperand(text[end]))
    ++end;
  return text.substr(at, end - at);
}

std::string_view instructionFor(char c) {
  switch (c) {
  case '*':
    return "MUL";
  case '/':
    return "RCP and MUL";
  case '+':
    return "ADD";
  case '-':
    return "SUB";
  case '<':
    return "SLT";
  case '>':
    return "SLT with its operands exchanged";
  default:
    return {};
  }
}

/// True in a statement of KIL or CMP, whose condition is that an operand is below zero.
bool testsBelowZero(std::string_view text, std::uint32_t at) {
  const std::size_t end = text.find_last_of(";\n", at);
  const std::size_t begin =
      text.find_first_not_of(" \t", end == std::string_view::npos ? 0 : end + 1);
  const std::string_view word = text.substr(std::min(begin, text.size()), 3);
  return word == "KIL" || word == "CMP";
}

/// True if every bracket within an operand is closed. If not, the operator is in an index.
bool isWhole(std::string_view operand) {
  int open = 0;
  for (const char c : operand) {
    open += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (open < 0)
      return false;
  }
  return !operand.empty() && open == 0;
}

/// True for the f of "2.0f": a word right behind a numeral.
bool isLetterOfNumeral(std::string_view text, Span word) {
  const std::string_view letters = text.substr(word.begin, word.end - word.begin);
  if (letters != "f" && letters != "F" && letters != "h" && letters != "lf")
    return false;
  std::uint32_t begin = word.begin;
  while (begin > 0 && (isDigit(text[begin - 1]) || text[begin - 1] == '.'))
    --begin;
  const bool ofName = begin > 0 && isOfOperand(text[begin - 1]);
  return begin < word.begin && !ofName &&
         text.substr(begin, word.begin - begin).find_first_of("0123456789") !=
             std::string_view::npos;
}

/// Returns the hint for numbers in parentheses, which begin at a byte.
std::string vectorHint(std::string_view text, std::uint32_t at) {
  const std::size_t end = text.find(')', at);
  if (end == std::string_view::npos || end - at > kLongestShown)
    return {};
  const std::string_view inside = text.substr(at + 1, end - at - 1);
  const bool numbers = inside.find_first_of("0123456789") != std::string_view::npos &&
                       inside.find_first_not_of("0123456789.eE+-, ") == std::string_view::npos;
  return numbers ? "a constant vector stands in braces: {" + std::string(inside) + "}" : "";
}

} // namespace

std::string tokenHint(std::string_view text, const Token &token) {
  const std::uint32_t at = token.span.begin;
  if (at >= text.size())
    return {};
  if (token.kind == TokenKind::Identifier && isLetterOfNumeral(text, token.span)) {
    const std::string_view number = operandBefore(text, at);
    return "a number takes no letter: write " + std::string(number);
  }
  if (token.kind == TokenKind::InvalidByte && text[at] == '(')
    return vectorHint(text, at);
  // "//" and "/*" begin comments of other languages.
  if (text[at] == '/' && at + 1 < text.size() && (text[at + 1] == '/' || text[at + 1] == '*'))
    return {};
  const std::string_view instruction = instructionFor(text[at]);
  const std::string_view first = operandBefore(text, at);
  const std::string_view second = operandAfter(text, token.span.end);
  if (instruction.empty() || !isWhole(first) || !isWhole(second))
    return {};
  if ((text[at] == '<' || text[at] == '>') && testsBelowZero(text, at)) {
    const std::string less(text[at] == '<' ? first : second);
    const std::string more(text[at] == '<' ? second : first);
    return "an operand is one value, and below zero is the condition: SUB computes " + less +
           " - " + more + " before it";
  }
  return "an operand is one value; " + std::string(instruction) +
         (text[at] == '/' ? " compute " : " computes ") + std::string(first) + " " + text[at] +
         " " + std::string(second) + " before it";
}

} // namespace arbiter::fp::c_like
