#include "fp_compiler/front/keywords.h"

#include <algorithm>
#include <array>

namespace arbiter::fp {

namespace {

using namespace ir;

struct OpcodeRow {
  std::uint32_t code;
  Opcode op;
  std::uint16_t traits;
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

Keyword findAttributes(std::string_view word, const ArbLanguage &language) {
  return word == language.attributes ? Keyword::Attributes : Keyword::None;
}

/// The words that are no opcodes; `language` decides about those that only one language has.
Keyword findOther(std::string_view word, const ArbLanguage &language) {
  switch (word.size()) {
  case 3:
    return word == "END" ? Keyword::End : Keyword::None;
  case 4:
    return word == "TEMP" ? Keyword::Temp : Keyword::None;
  case 5:
    return word == "PARAM"   ? Keyword::Param
           : word == "ALIAS" ? Keyword::Alias
           : word == "state" ? Keyword::State
                             : Keyword::None;
  case 6:
    return word == "ATTRIB"   ? Keyword::Attrib
           : word == "OPTION" ? Keyword::Option
           : word == "OUTPUT" ? Keyword::Output
           : word == "result" ? Keyword::Result
                              : findAttributes(word, language);
  case 7:
    return word == "program"                          ? Keyword::Program
           : word == "texture" && !language.addresses ? Keyword::Texture
           : word == "ADDRESS" && language.addresses  ? Keyword::Address
                                                      : Keyword::None;
  case 8:
    return findAttributes(word, language);
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
    // KIL_SAT is neither an instruction nor reserved.
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
