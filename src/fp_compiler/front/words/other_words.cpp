#include "fp_compiler/front/words/other_words.h"

#include <algorithm>

#include "fp_compiler/front/lexer.h"
#include "fp_compiler/front/words/suggest.h"

namespace arbiter::fp {

namespace {

struct Row {
  std::string_view words;
  std::string_view opcodes;
  std::string_view advice;
};

constexpr Row kRows[] = {
#define OTHER_WORDS(words, opcodes, advice) {words, opcodes, advice},
#include "fp_compiler/front/words/other_words.def"
};

constexpr std::string_view kSaturations[] = {"SATURATE", "SAT", "CLAMP01"};

std::string upper(std::string_view word) {
  std::string result(word);
  for (char &c : result)
    c = c >= 'a' && c <= 'z' ? char(c - 'a' + 'A') : c;
  return result;
}

std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> result;
  while (!words.empty()) {
    const std::size_t end = std::min(words.find(' '), words.size());
    result.push_back(words.substr(0, end));
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return result;
}

bool contains(const std::vector<std::string_view> &words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// The language's own spelling of a word in capitals; empty if it has none.
std::string_view spelled(std::string_view capitals, const Vocabulary &vocabulary) {
  const auto found = std::find_if(vocabulary.words.begin(), vocabulary.words.end(),
                                  [&](std::string_view each) { return upper(each) == capitals; });
  return found == vocabulary.words.end() ? std::string_view() : *found;
}

/// "DP3, RSQ and MUL"
std::string listed(const std::vector<std::string_view> &words, const char *last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + std::string(words[i]);
  return text;
}

/// A word in capitals without what may stand behind an opcode, and what of that is kept.
struct Cut {
  std::string_view base;
  std::string_view suffix;
};
Cut cut(std::string_view capitals, const Vocabulary &vocabulary) {
  const std::size_t bar = std::min(capitals.rfind('_'), capitals.size());
  const std::string_view tail = capitals.substr(bar);
  if (tail == "_SAT" && vocabulary.saturate == "_SAT")
    return {capitals.substr(0, bar), "_SAT"};
  return {tail == "_PP" ? capitals.substr(0, bar) : capitals, ""};
}

std::string asked(std::string_view word, const Cut &whole) {
  return "did you mean '" + std::string(word) + std::string(whole.suffix) + "'?";
}

/// Leaves those that have as many parts, if any has.
void keepFitting(std::vector<std::string_view> &words, int parts, const Vocabulary &vocabulary) {
  const auto misfits = [&](std::string_view word) { return vocabulary.parts(word) != parts; };
  if (parts != 0 && !std::all_of(words.begin(), words.end(), misfits))
    std::erase_if(words, misfits);
}

/// Returns a row's advice if the language has all opcodes that it names; else an empty text.
std::string advice(const Row &row, const Vocabulary &vocabulary) {
  const std::vector<std::string_view> opcodes = split(row.opcodes);
  const bool all = std::all_of(opcodes.begin(), opcodes.end(), [&](std::string_view each) {
    return !spelled(each, vocabulary).empty();
  });
  if (!all || !row.advice.empty())
    return all ? std::string(row.advice) : std::string();
  return opcodes.empty() ? "" : listed(opcodes, " and ") + " together do it";
}

std::string saturationHint(const Vocabulary &vocabulary) {
  if (vocabulary.saturate == "_SAT")
    return "write _SAT behind the opcode that computes it, as in MUL_SAT";
  if (!vocabulary.saturate.empty())
    return "write " + std::string(vocabulary.saturate) +
           " behind the result that it is computed to";
  return spelled("MAX", vocabulary).empty() ? "" : "MAX with 0 and MIN with 1 together do it";
}

} // namespace

int partsBehind(std::string_view text, std::uint32_t begin) {
  constexpr int kLooked = 64;
  Lexer lexer(text, begin);
  int parts = 1, braces = 0;
  for (int i = 0; i < kLooked; ++i) {
    const TokenKind kind = lexer.next().kind;
    if (kind == TokenKind::Semicolon || kind == TokenKind::EndOfText)
      return i == 0 ? 0 : parts;
    braces += kind == TokenKind::OpenBrace ? 1 : kind == TokenKind::CloseBrace ? -1 : 0;
    parts += kind == TokenKind::Comma && braces == 0 ? 1 : 0;
  }
  return 0;
}

std::string meaningHint(std::string_view word, int parts, const Vocabulary &vocabulary) {
  const std::string capitals = upper(word);
  const Cut whole = cut(capitals, vocabulary);
  if (std::find(std::begin(kSaturations), std::end(kSaturations), whole.base) !=
      std::end(kSaturations))
    return saturationHint(vocabulary);
  if (const std::string_view own = spelled(whole.base, vocabulary); !own.empty())
    return asked(own, whole);
  std::vector<std::string_view> meant;
  std::string instead;
  for (const Row &row : kRows) {
    const std::vector<std::string_view> words = split(row.words);
    if (!contains(words, whole.base))
      continue;
    std::string_view found;
    for (const std::string_view each : words)
      found = found.empty() ? spelled(each, vocabulary) : found;
    if (!found.empty())
      meant.push_back(found);
    else if (instead.empty())
      instead = advice(row, vocabulary);
  }
  keepFitting(meant, parts, vocabulary);
  if (meant.empty())
    return instead;
  if (meant.size() > 1)
    return "the words for it are " + listed(meant, " and ");
  return asked(meant[0], whole);
}

std::string spellingHint(std::string_view word, int parts, const Vocabulary &vocabulary) {
  const std::string capitals = upper(word);
  const Cut whole = cut(capitals, vocabulary);
  std::vector<std::string_view> near = allNearest(whole.base, vocabulary.words);
  keepFitting(near, parts, vocabulary);
  return near.empty() ? std::string() : asked(near[0], whole);
}

std::string statementHint(std::string_view word, int parts, const Vocabulary &vocabulary) {
  if (std::string hint = meaningHint(word, parts, vocabulary); !hint.empty())
    return hint;
  return spellingHint(word, parts, vocabulary);
}

} // namespace arbiter::fp
