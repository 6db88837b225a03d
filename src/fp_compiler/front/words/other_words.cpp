#include "fp_compiler/front/words/other_words.h"

#include <algorithm>

#include "util/suggest.h"

namespace arbiter::fp {

namespace {

struct Row {
  std::string_view words;
  std::string_view opcodes;
  std::string_view advice;
};

constexpr Row kRows[] = {
#define OTHER_WORDS(words, opcodes, advice) {words, opcodes, advice},
#define OTHER_FUNCTION(name, opcodes, advice)
#include "fp_compiler/front/words/other_words.def"
};

constexpr Row kFunctions[] = {
#define OTHER_WORDS(words, opcodes, advice)
#define OTHER_FUNCTION(name, opcodes, advice) {name, opcodes, advice},
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
void keepFitting(std::vector<std::string_view> &words, const PartTexts &parts,
                 const Vocabulary &vocabulary) {
  const auto misfits = [&](std::string_view word) {
    return vocabulary.parts(word) != int(parts.size());
  };
  if (!parts.empty() && !std::all_of(words.begin(), words.end(), misfits))
    std::erase_if(words, misfits);
}

/// Returns an example with the author's parts in place of $0 to $3. "$1.x" is one component.
std::string example(std::string_view pattern, const PartTexts &parts) {
  constexpr std::string_view kOthers[] = {"dst", "first", "second", "third"};
  std::string text;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern[at] != '$') {
      text += pattern[at];
      continue;
    }
    const auto index = std::size_t(pattern[++at] - '0');
    const bool scalar = pattern.substr(at + 1).starts_with(".x");
    text += shownPart(parts, index, kOthers[index], scalar);
    at += scalar ? 2 : 0;
  }
  return text;
}

/// Returns a row's advice if the language has all opcodes that it names; else an empty text.
std::string advice(const Row &row, const PartTexts &parts, const Vocabulary &vocabulary) {
  const std::vector<std::string_view> opcodes = split(row.opcodes);
  const bool all = std::all_of(opcodes.begin(), opcodes.end(), [&](std::string_view each) {
    return !spelled(each, vocabulary).empty();
  });
  const bool shows = row.advice.find('$') != std::string_view::npos;
  if (!all || (!row.advice.empty() && !shows))
    return all ? std::string(row.advice) : std::string();
  if (opcodes.empty())
    return {};
  const std::string done = listed(opcodes, " and ") + " together do it";
  return shows ? done + ": " + example(row.advice, parts) : done;
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

namespace {
/// The meanings of a word in the language, or what is advised where it has none.
struct Meaning {
  std::vector<std::string_view> words;
  std::string instead;
};

Meaning meaningOf(std::string_view capitals, const PartTexts &parts, const Vocabulary &vocabulary) {
  Meaning meaning;
  for (const Row &row : kRows) {
    const std::vector<std::string_view> words = split(row.words);
    if (!contains(words, capitals))
      continue;
    std::string_view found;
    for (const std::string_view each : words)
      found = found.empty() ? spelled(each, vocabulary) : found;
    if (!found.empty())
      meaning.words.push_back(found);
    else if (meaning.instead.empty())
      meaning.instead = advice(row, parts, vocabulary);
  }
  return meaning;
}

/// Returns how the language does a function that no opcode equals; else an empty text.
std::string functionHint(std::string_view capitals, const Vocabulary &vocabulary) {
  for (const Row &row : kFunctions)
    if (row.words == capitals)
      if (std::string hint = advice(row, {}, vocabulary); !hint.empty())
        return hint;
  return {};
}

bool isSaturation(std::string_view capitals) {
  return std::find(std::begin(kSaturations), std::end(kSaturations), capitals) !=
         std::end(kSaturations);
}
} // namespace

std::string meaningHint(std::string_view word, const PartTexts &parts,
                        const Vocabulary &vocabulary) {
  const std::string capitals = upper(word);
  const Cut whole = cut(capitals, vocabulary);
  if (isSaturation(whole.base))
    return saturationHint(vocabulary);
  if (const std::string_view own = spelled(whole.base, vocabulary); !own.empty())
    return asked(own, whole);
  Meaning meaning = meaningOf(whole.base, parts, vocabulary);
  if (meaning.words.empty() && meaning.instead.empty()) // "EXP" and "LERP" are Direct3D's words too
    return functionHint(whole.base, vocabulary);
  keepFitting(meaning.words, parts, vocabulary);
  if (meaning.words.empty())
    return meaning.instead;
  if (meaning.words.size() > 1)
    return "the words for it are " + listed(meaning.words, " and ");
  return asked(meaning.words[0], whole);
}

std::string callHint(std::string_view word, const Vocabulary &vocabulary) {
  const std::string capitals = upper(word);
  if (isSaturation(capitals))
    return saturationHint(vocabulary);
  if (std::string hint = functionHint(capitals, vocabulary); !hint.empty())
    return hint;
  const Meaning meaning = meaningOf(capitals, {}, vocabulary);
  if (meaning.words.empty())
    return meaning.instead;
  return listed(meaning.words, " or ") + " does what " + std::string(word) + " does";
}

std::string spellingHint(std::string_view word, const PartTexts &parts,
                         const Vocabulary &vocabulary) {
  const std::string capitals = upper(word);
  const Cut whole = cut(capitals, vocabulary);
  std::vector<std::string_view> near = allNearest(whole.base, vocabulary.words);
  keepFitting(near, parts, vocabulary);
  return near.empty() ? std::string() : asked(near[0], whole);
}

std::string statementHint(std::string_view word, const PartTexts &parts,
                          const Vocabulary &vocabulary) {
  if (std::string hint = meaningHint(word, parts, vocabulary); !hint.empty())
    return hint;
  return spellingHint(word, parts, vocabulary);
}

} // namespace arbiter::fp
