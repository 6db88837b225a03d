#include "statements.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <vector>

namespace arbiter::fuzz {

namespace {
using Random = std::mt19937_64;
using Statements = std::vector<std::string>;

std::size_t below(Random &random, std::size_t count) { return std::size_t(random() % count); }

template <std::size_t N>
std::string_view oneOf(Random &random, const std::array<std::string_view, N> &words) {
  return words[below(random, N)];
}

constexpr std::array<std::string_view, 12> kBegins = {
    "IF GT.x;",        "IF LE.yyzw;",      "IF TR;",   "IF FL;",
    "IF NE.w;",        "REP 2;",           "REP 0;",   "REP program.local[1].x;",
    "LOOP {3, 0, 1};", "LOOP {2, 1, -1};", "REP 255;", "IF EQ.x;"};
constexpr std::array<std::string_view, 14> kWhole = {"BRK (GT.x);",
                                                     "BRK (NE.wzyx);",
                                                     "BRK (TR);",
                                                     "RET (LT.y);",
                                                     "KIL LT.z;",
                                                     "ELSE;",
                                                     "CAL sub (GE.x);",
                                                     "BRA end (NE.x);",
                                                     "ENDIF;",
                                                     "ENDREP;",
                                                     "SUBC r1.x, r1.x, 1.0;",
                                                     "MOVC r0, r2;",
                                                     "DDX r3, r0;",
                                                     "TEX r4, r0, texture[0], 2D;"};
constexpr std::array<std::string_view, 10> kConditions = {"EQ", "NE", "LT", "GT", "LE",
                                                          "GE", "TR", "FL", "UN", "NE0"};
constexpr std::array<std::string_view, 14> kNumerals = {
    "0", "1", "2", "3", "4", "-1.0", "0.5", "2.5", "255", "1e30", "-0.0", "65536", "7", "1e-40"};
constexpr std::array<std::string_view, 8> kSwizzles = {"x",  "y",  "z",   "w",
                                                       "xy", "yw", "xyz", "wzyx"};
constexpr std::array<std::string_view, 10> kSuffixes = {"C",     "R",     "H",  "X",       "_SAT",
                                                        "_SSAT", "C_SAT", "HC", "RC_SSAT", ""};

/// Splits at each semicolon; the rest is the last statement.
Statements cut(std::string_view text) {
  Statements statements;
  std::size_t begin = 0;
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] == ';') {
      statements.emplace_back(text.substr(begin, at + 1 - begin));
      begin = at + 1;
    }
  statements.emplace_back(text.substr(begin));
  return statements;
}

std::string joined(const Statements &statements) {
  std::string text;
  for (const std::string &statement : statements)
    text += statement;
  return text;
}

bool isWord(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Replaces one word by another of its kind, if it has a kind.
void editWord(std::string &statement, Random &random) {
  const std::size_t from = below(random, statement.size() + 1);
  std::size_t begin = from;
  while (begin < statement.size() && !isWord(statement[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < statement.size() && isWord(statement[end]))
    ++end;
  if (begin == end)
    return;
  const std::string word = statement.substr(begin, end - begin);
  std::string other;
  bool isCondition = false;
  for (const std::string_view each : kConditions)
    isCondition = isCondition || word == each;
  if (isCondition)
    other = oneOf(random, kConditions);
  else if (std::isdigit(static_cast<unsigned char>(word[0])) != 0)
    other = oneOf(random, kNumerals);
  else if (begin > 0 && statement[begin - 1] == '.')
    other = oneOf(random, kSwizzles);
  else if (std::isupper(static_cast<unsigned char>(word[0])) != 0)
    other = word + std::string(oneOf(random, kSuffixes));
  else if (word.size() == 2 && word[0] == 'r')
    other = "r" + std::to_string(below(random, 5));
  else
    return;
  statement.replace(begin, end - begin, other);
}

void wrap(Statements &statements, std::size_t at, Random &random) {
  const std::size_t last = at + below(random, std::min<std::size_t>(4, statements.size() - at));
  const std::string begin(oneOf(random, kBegins));
  std::string_view end = "\nENDREP;";
  if (begin.starts_with("IF"))
    end = "\nENDIF;";
  else if (begin.starts_with("LOOP"))
    end = "\nENDLOOP;";
  statements.insert(statements.begin() + std::ptrdiff_t(last), std::string(end));
  statements.insert(statements.begin() + std::ptrdiff_t(at), "\n" + begin);
}

void edit(Statements &statements, Random &random) {
  const std::size_t at = below(random, statements.size()), other = below(random, statements.size());
  const auto place = statements.begin() + std::ptrdiff_t(at);
  switch (below(random, 8)) {
  case 0:
    if (statements.size() > 1)
      statements.erase(place);
    break;
  case 1:
    statements.insert(place, std::string(statements[other]));
    break;
  case 2:
    std::swap(statements[at], statements[other]);
    break;
  case 3:
    statements.insert(place, "\n" + std::string(oneOf(random, kWhole)));
    break;
  case 4:
  case 5:
    wrap(statements, at, random);
    break;
  default:
    editWord(statements[at], random);
  }
}
} // namespace

std::string editStatements(std::string text, Random &random) {
  Statements statements = cut(text);
  for (std::size_t edits = 1 + below(random, 4); edits > 0; --edits)
    edit(statements, random);
  return joined(statements);
}

std::string spliceStatements(const std::string &text, const std::string &other, Random &random) {
  Statements first = cut(text);
  const Statements second = cut(other);
  first.resize(below(random, first.size()) + 1);
  first.insert(first.end(), second.begin() + std::ptrdiff_t(below(random, second.size())),
               second.end());
  return joined(first);
}

} // namespace arbiter::fuzz
