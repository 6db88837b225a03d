#include "fp_compiler/front/words/keywords.h"

#include <algorithm>
#include <array>

namespace arbiter::fp {

namespace {

using namespace ir;

struct OpcodeRow {
  std::uint32_t code;
  Opcode op;
  std::uint32_t traits;
};

constexpr std::uint32_t pack(const char *three) {
  return std::uint32_t(std::uint8_t(three[0])) << 16 | std::uint32_t(std::uint8_t(three[1])) << 8 |
         std::uint8_t(three[2]);
}

constexpr std::array<OpcodeRow, kOpcodeCount> makeOpcodes() {
  std::array<OpcodeRow, kOpcodeCount> rows = {{
#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc)                                  \
  {pack(mnemonic), Opcode::Enumerator, traits},
#include "fp_compiler/ir/ops.def"
#undef FP_OP
  }};
  std::sort(rows.begin(), rows.end(),
            [](const OpcodeRow &a, const OpcodeRow &b) { return a.code < b.code; });
  return rows;
}
constexpr auto kOpcodes = makeOpcodes();

#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc)                                  \
  static_assert(sizeof(mnemonic) == 4, "the search packs three letters");
#include "fp_compiler/ir/ops.def"
#undef FP_OP

const OpcodeRow *findOpcode(std::string_view word) {
  const std::uint32_t code = pack(word.data());
  const auto *row =
      std::lower_bound(kOpcodes.begin(), kOpcodes.end(), code,
                       [](const OpcodeRow &r, std::uint32_t wanted) { return r.code < wanted; });
  return row != kOpcodes.end() && row->code == code ? row : nullptr;
}

/// Returns a word of at most eight letters as one number.
constexpr std::uint64_t packWord(std::string_view word) {
  std::uint64_t packed = 0;
  for (const char c : word)
    packed = packed << 8 | std::uint8_t(c);
  return packed;
}

constexpr Keyword onlyIf(bool holds, Keyword keyword) { return holds ? keyword : Keyword::None; }

/// Returns the keyword that is not an opcode. `language` decides about words that only one language
/// has.
Keyword findOther(std::string_view word, const ArbLanguage &language) {
  if (word.size() > 8)
    return Keyword::None;
  const bool vertex = language.language == Language::ArbVertex;
  switch (packWord(word)) {
#define FP_KEYWORD(Enumerator, text, languages, section, doc)                                      \
  case packWord(text):                                                                             \
    static_assert(sizeof(text) <= 9, "a word is packed into eight bytes");                         \
    return onlyIf(isOf(Languages::languages, vertex), Keyword::Enumerator);
#include "fp_compiler/front/words/words.def"
  default:
    return Keyword::None;
  }
}

} // namespace

Word classify(std::string_view identifier, const ArbLanguage &language) {
  const bool saturate =
      language.saturates && identifier.size() == 7 && identifier.substr(3) == "_SAT";
  if (identifier.size() == 3 || saturate) {
    const OpcodeRow *row = findOpcode(identifier);
    // KIL_SAT is not an instruction and not reserved.
    if (row && (row->traits & language.foreign) == 0 && !(saturate && (row->traits & Kills) != 0))
      return {Keyword::Opcode, row->op, saturate};
  }
  return {findOther(identifier, language)};
}

bool beginsStatement(Keyword keyword) {
  switch (keyword) {
  case Keyword::Opcode:
  case Keyword::Address:
  case Keyword::Alias:
  case Keyword::Attrib:
  case Keyword::Option:
  case Keyword::Output:
  case Keyword::Param:
  case Keyword::Temp:
  case Keyword::End:
    return true;
  case Keyword::None:
  case Keyword::Attributes:
  case Keyword::Program:
  case Keyword::Result:
  case Keyword::State:
  case Keyword::Texture:
    return false;
  }
  return false;
}

} // namespace arbiter::fp
