#include "fp_compiler/front/words/parts.h"

#include <algorithm>
#include <iterator>

#include "fp_compiler/front/lexer.h"
#include "util/text/letters.h"

namespace arbiter::fp {

using ir::Opcode;

namespace {
constexpr int kSelectors = 4; // of SWZ
constexpr const char *kOrdinals[] = {"first", "second", "third", "fourth"};
constexpr std::size_t kLongest = 40; ///< the longest part that a hint shows, in bytes

/// True for one value on one line, without an operator.
bool isValue(std::string_view part) {
  constexpr std::string_view kOthers = "_$.[]{}";
  if (part.empty() || part.size() > kLongest)
    return false;
  bool inBraces = false, sign = true;
  for (const char c : part) {
    inBraces = (inBraces && c != '}') || c == '{';
    if (!isLetterOrDigit(c) && kOthers.find(c) == std::string_view::npos &&
        !(inBraces && std::string_view(", +-").find(c) != std::string_view::npos) &&
        !(sign && (c == '-' || c == '+')))
      return false;
    sign = false;
  }
  return true;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos)
    return {};
  return text.substr(first, text.find_last_not_of(" \t\r\n") + 1 - first);
}
} // namespace

const char *ordinal(int number) {
  return number >= 0 && number < int(std::size(kOrdinals)) ? kOrdinals[number] : "next";
}

std::string partName(Opcode op, Part part) {
  const ir::OpInfo &row = info(op);
  const std::string of = std::string(" of ") + row.mnemonic;
  switch (part.kind) {
  case PartKind::Destination:
    return "the destination" + of;
  case PartKind::Operand:
    if (row.operandCount() > 1)
      return "the " + std::string(ordinal(part.number)) + " operand" + of;
    return (row.has(ir::Texture) ? "the coordinate" : "the operand") + of;
  case PartKind::Selector:
    return "the " + std::string(ordinal(part.number)) + " selector" + of;
  case PartKind::Unit:
    return "the texture image unit" + of;
  case PartKind::Target:
    return "the texture target" + of;
  }
  return {};
}

bool beginsInstruction(Opcode op, Part part) {
  return part.kind == PartKind::Destination ||
         (part.kind == PartKind::Operand && part.number == 0 && info(op).has(ir::Kills));
}

int partCount(Opcode op) {
  const ir::OpInfo &row = info(op);
  if (row.has(ir::Flow))
    return 0;
  return row.operandCount() + (row.has(ir::Kills) ? 0 : 1) + (row.has(ir::Texture) ? 2 : 0) +
         (op == Opcode::Swz ? kSelectors : 0);
}

bool isOnLaterLine(std::string_view text, std::uint32_t from, std::uint32_t to) {
  return text.substr(from, to - from).find_first_of("\r\n") != std::string_view::npos;
}

bool beginsLine(std::string_view text, Span last, const Token &first) {
  if (first.kind != TokenKind::Identifier || !isOnLaterLine(text, last.end, first.span.begin))
    return false;
  const Token second = Lexer(text, first.span.end).next();
  return (second.kind == TokenKind::Identifier || second.kind == TokenKind::Equals) &&
         !isOnLaterLine(text, first.span.end, second.span.begin);
}

PartTexts partsBehind(std::string_view text, std::uint32_t begin) {
  constexpr int kLooked = 64;
  Lexer lexer(text, begin);
  PartTexts parts;
  int braces = 0;
  Span last = {begin, begin};
  for (int i = 0; i < kLooked; ++i) {
    const Token token = lexer.next();
    const bool ends = token.kind == TokenKind::Semicolon || token.kind == TokenKind::EndOfText ||
                      beginsLine(text, last, token);
    last = token.span;
    if (ends && i == 0)
      return {};
    if (ends || (token.kind == TokenKind::Comma && braces == 0)) {
      parts.push_back(trimmed(text.substr(begin, token.span.begin - begin)));
      begin = token.span.end;
    }
    if (ends)
      return parts;
    braces += token.kind == TokenKind::OpenBrace ? 1 : token.kind == TokenKind::CloseBrace ? -1 : 0;
  }
  return {};
}

std::string withComponent(std::string_view value) {
  const std::size_t first = value.find_first_not_of("+-");
  const std::size_t dot = value.rfind('.');
  if (first == std::string_view::npos)
    return std::string(value);
  if (value[first] == '.' || (value[first] >= '0' && value[first] <= '9'))
    return std::string(value.substr(0, first)) + "{" + std::string(value.substr(first)) + "}.x";
  const bool letters = value.back() != '}' && dot != std::string_view::npos &&
                       dot + 1 < value.size() && value.size() - dot <= 5 &&
                       value.find_first_not_of("xyzwrgba", dot + 1) == std::string_view::npos;
  return letters ? std::string(value.substr(0, dot + 2)) : std::string(value) + ".x";
}

std::string componentHint(std::string_view operand) {
  const std::string shown = isValue(operand) ? withComponent(operand) : std::string();
  const bool constant = shown.find('{') != std::string::npos;
  return std::string(constant ? "a constant needs it too" : "choose one of x, y, z, w") +
         ": write " + (shown.empty() ? ".x behind it" : shown);
}

std::string shownPart(const PartTexts &parts, std::size_t index, std::string_view otherwise,
                      bool scalar) {
  const bool known = index < parts.size() && isValue(parts[index]);
  const std::string_view shown = known ? parts[index] : otherwise;
  return scalar ? withComponent(shown) : std::string(shown);
}

std::string usageHint(Opcode op, const PartTexts &parts, std::string_view unit) {
  const ir::OpInfo &row = info(op);
  std::string text;
  std::size_t at = 0;
  const auto add = [&](std::string_view otherwise, bool scalar = false) {
    text += (text.empty() ? " " : ", ") + shownPart(parts, at, otherwise, scalar);
    ++at;
  };
  if (!row.has(ir::Kills))
    add(op == Opcode::Arl ? "A.x" : "dst");
  for (int i = 0; i < row.operandCount(); ++i)
    add(row.operandCount() > 1 ? ordinal(i)
        : row.has(ir::Texture) ? "coord"
                               : "value",
        row.shapes[i] == 'S');
  if (op == Opcode::Swz)
    for (const char *const selector : {"x", "y", "z", "w"})
      add(selector);
  if (row.has(ir::Texture)) {
    const std::string_view kind = unit.substr(0, unit.find_first_of("[0123456789"));
    const bool named = at < parts.size() && parts[at].starts_with(kind);
    text += ", " + (named ? shownPart(parts, at, unit) : std::string(unit));
    const bool target = at + 1 < parts.size() && !parts[at + 1].empty();
    text += ", " + (target ? shownPart(parts, at + 1, "2D") : std::string("2D"));
  }
  return std::string("write ") + row.mnemonic + text + ";";
}

} // namespace arbiter::fp
