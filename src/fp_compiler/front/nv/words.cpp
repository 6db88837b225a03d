#include "fp_compiler/front/nv/words.h"

#include <algorithm>
#include <array>

namespace arbiter::fp::nv {

using ir::NativeLanguage;
using ir::NvOption;
using ir::Opcode;
using ir::OpInfo;

namespace {

constexpr std::string_view kMnemonics[] = {
#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc) mnemonic,
#define FP_NV_OP(Enumerator, mnemonic, shapes, traits, section, doc) mnemonic,
#define FP_NV_WORD(Enumerator, mnemonic, shapes, traits, section, doc) mnemonic,
#include "fp_compiler/ir/ops.def"
};
static_assert(std::size(kMnemonics) == std::size_t(ir::kOpcodeRowCount));

constexpr std::size_t kShortest = 2, kLongest = 7;

using Rows = std::array<std::uint8_t, ir::kOpcodeRowCount>;
/// The opcodes' numbers, sorted by mnemonic.
constexpr Rows kSorted = [] {
  Rows rows = {};
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = std::uint8_t(i);
  std::sort(rows.begin(), rows.end(),
            [](std::uint8_t a, std::uint8_t b) { return kMnemonics[a] < kMnemonics[b]; });
  return rows;
}();

std::optional<Opcode> find(std::string_view mnemonic) {
  const auto *const row = std::lower_bound(
      kSorted.begin(), kSorted.end(), mnemonic,
      [](std::uint8_t r, std::string_view wanted) { return kMnemonics[r] < wanted; });
  if (row == kSorted.end() || kMnemonics[*row] != mnemonic)
    return std::nullopt;
  return Opcode(*row);
}

/// Removes \p prefix if the text begins with it. Returns whether it does.
bool accept(std::string_view &rest, std::string_view prefix) {
  if (!rest.starts_with(prefix))
    return false;
  rest.remove_prefix(prefix.size());
  return true;
}

/// The suffixes that a language allows after an opcode's name.
struct Suffixes {
  bool precision = false, condition = false, secondCondition = false;
  bool saturate = false, signedSaturate = false;
};

Suffixes suffixesOf(bool vertex, NvOption option) {
  const bool second = option == NvOption::Second;
  return {!vertex, true, vertex && second, !vertex || second, !vertex && second};
}

Suffixes suffixesOf(NativeLanguage language) {
  const bool fragment = language == NativeLanguage::Fp1;
  return {.precision = fragment,
          .condition = fragment || language == NativeLanguage::Vp2,
          .saturate = fragment};
}

/// Reads the suffixes. Returns false if the opcode cannot have them.
bool readSuffix(std::string_view rest, const OpInfo &row, const Suffixes &may, Word &word) {
  if (may.precision && !row.has(ir::NoPrecision)) {
    word.nv.full = accept(rest, "R");
    word.nv.half =
        !word.nv.full && (accept(rest, "H") || (!row.has(ir::NoFixed) && accept(rest, "X")));
  }
  if (may.condition && !row.has(ir::NoCondition) && accept(rest, "C")) {
    word.nv.updates = 1;
    if (may.secondCondition && !accept(rest, "0") && accept(rest, "1"))
      word.nv.updates = 2;
  }
  if (row.has(ir::NoSaturate) || !may.saturate)
    return rest.empty();
  word.saturate = rest == "_SAT";
  word.nv.signedSaturate = may.signedSaturate && rest == "_SSAT";
  return rest.empty() || word.saturate || word.nv.signedSaturate;
}

template <typename Offers>
std::optional<Opcode> longestBase(std::string_view identifier, const Offers &offered) {
  for (std::size_t size = std::min(identifier.size(), kLongest); size >= kShortest; --size) {
    const std::optional<Opcode> op = find(identifier.substr(0, size));
    if (op && offered(*op))
      return op;
  }
  return std::nullopt;
}

/// Returns the opcode that the whole identifier spells; nothing if it spells none.
template <typename Offers>
std::optional<Word> spelled(std::string_view identifier, const Suffixes &may,
                            const Offers &offered) {
  for (std::size_t size = std::min(identifier.size(), kLongest); size >= kShortest; --size) {
    const std::optional<Opcode> op = find(identifier.substr(0, size));
    if (!op || !offered(*op))
      continue;
    Word word = {Keyword::Opcode, *op};
    if (readSuffix(identifier.substr(size), info(*op), may, word))
      return word;
  }
  return std::nullopt;
}

} // namespace

bool offers(const ArbLanguage &language, NvOption option, Opcode op) {
  const OpInfo &row = info(op);
  if (int(op) < ir::kOpcodeCount && !row.has(language.foreign))
    return true;
  const bool vertex = language.language == ir::Language::ArbVertex;
  const bool second = option == NvOption::Second;
  return vertex ? row.has(ir::OfV2) || (second && row.has(ir::OfV3))
                : row.has(ir::OfF1) || (second && row.has(ir::OfF2));
}

bool offers(NativeLanguage language, Opcode op) {
  const OpInfo &row = info(op);
  switch (language) {
  case NativeLanguage::None:
    break;
  case NativeLanguage::Fp1:
    return row.has(ir::OfFp1);
  case NativeLanguage::Vp1:
  case NativeLanguage::Vsp1:
    return row.has(ir::OfVp1);
  case NativeLanguage::Vp11:
    return row.has(ir::OfVp1) || row.has(ir::OfVp11);
  case NativeLanguage::Vp2:
    return row.has(ir::OfVp1) || row.has(ir::OfVp11) || row.has(ir::OfVp2);
  }
  return false;
}

std::optional<Opcode> baseOf(std::string_view identifier, const ArbLanguage &language,
                             NvOption option) {
  return longestBase(identifier, [&](Opcode op) { return offers(language, option, op); });
}

std::optional<Opcode> baseOf(std::string_view identifier, NativeLanguage language) {
  return longestBase(identifier, [&](Opcode op) { return offers(language, op); });
}

Word classify(std::string_view identifier, const ArbLanguage &language, NvOption option) {
  const bool vertex = language.language == ir::Language::ArbVertex;
  if (const auto word = spelled(identifier, suffixesOf(vertex, option),
                                [&](Opcode op) { return offers(language, option, op); }))
    return *word;
  const Word plain = fp::classify(identifier, language);
  return plain.keyword == Keyword::Opcode ? Word{} : plain;
}

Word classify(std::string_view identifier, NativeLanguage language) {
  if (identifier == "END")
    return {Keyword::End};
  const bool declares = identifier == "DEFINE" || identifier == "DECLARE";
  if (declares && language == NativeLanguage::Fp1)
    return {Keyword::Param};
  const bool second = language == NativeLanguage::Vp11 || language == NativeLanguage::Vp2;
  if (identifier == "OPTION" && second)
    return {Keyword::Option};
  const auto word =
      spelled(identifier, suffixesOf(language), [&](Opcode op) { return offers(language, op); });
  return word ? *word : Word{};
}

std::optional<Rule> ruleOf(std::string_view word) {
  constexpr std::string_view kWords[] = {"EQ", "GE", "GT", "LE", "LT", "NE", "TR", "FL"};
  const auto *const found = std::find(std::begin(kWords), std::end(kWords), word);
  if (found == std::end(kWords))
    return std::nullopt;
  return Rule(found - std::begin(kWords));
}

} // namespace arbiter::fp::nv
