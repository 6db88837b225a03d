#include "fp_compiler/front/words/language.h"

#include <algorithm>
#include <span>

#include "fp_compiler/front/words/keywords.h"

namespace arbiter::fp {

namespace {

constexpr ArbLanguage kFragment = {.language = ir::Language::ArbFragment,
                                   .header = "!!ARBfp1.0",
                                   .name = "fragment program",
                                   .attributes = "fragment",
                                   .foreign = ir::VertexOnly,
                                   .foreignId = DiagnosticId::VertexOnly,
                                   .foreignName = "vertex programs",
                                   .nvOptions = "NV_fragment_program",
                                   .saturates = true,
                                   .colorLetters = true,
                                   .addresses = false};

constexpr ArbLanguage kVertex = {.language = ir::Language::ArbVertex,
                                 .header = "!!ARBvp1.0",
                                 .name = "vertex program",
                                 .attributes = "vertex",
                                 .foreign = ir::FragmentOnly,
                                 .foreignId = DiagnosticId::FragmentOnly,
                                 .foreignName = "fragment programs",
                                 .nvOptions = "NV_vertex_program",
                                 .saturates = false,
                                 .colorLetters = false,
                                 .addresses = true};

struct HintRow {
  std::string_view word;
  std::string_view hint;
};

constexpr HintRow kVertexWords[] = {
    {"EXP", "use EX2"},
    {"LOG", "use LG2"},
    {"ARL", "arrays of a fragment program take constant indexes only"},
    {"ADDRESS", "arrays of a fragment program take constant indexes only"},
    {"vertex", "a fragment program reads fragment.*"},
};

constexpr HintRow kFragmentWords[] = {
    {"CMP", "use SLT for the condition and MAD to choose"},
    {"COS", "approximate it, or pass the value in a parameter"},
    {"SIN", "approximate it, or pass the value in a parameter"},
    {"SCS", "approximate it, or pass the values in a parameter"},
    {"fragment", "a vertex program reads vertex.*"},
};

constexpr std::string_view kNvFragment[] = {
    "DDX", "DDY", "PK2H", "PK2US", "PK4B",  "PK4UB", "RFL",     "SEQ",    "SFL", "SGT",
    "SLE", "SNE", "STR",  "TXD",   "UP2H",  "UP2US", "UP4B",    "UP4UB",  "X2D", "BRK",
    "CAL", "DIV", "DP2",  "DP2A",  "ELSE",  "ENDIF", "ENDLOOP", "ENDREP", "IF",  "LOOP",
    "NRM", "REP", "RET",  "TXL",   "SHORT", "LONG",  "FLOAT",   "INT"};

// Instructions of NV_vertex_program2_option and NV_vertex_program3. SIN, COS and the samples are
// missing because fragment programs have them too, and the error says so.
constexpr std::string_view kNvVertex[] = {"ARA", "ARR",   "BRA",  "CAL", "RCC", "RET",
                                          "SEQ", "SFL",   "SGT",  "SLE", "SNE", "SSG",
                                          "STR", "PUSHA", "POPA", "TXL"};

std::string_view find(std::span<const HintRow> rows, std::string_view word) {
  const auto row =
      std::find_if(rows.begin(), rows.end(), [&](const HintRow &r) { return r.word == word; });
  return row == rows.end() ? std::string_view() : row->hint;
}

} // namespace

const ArbLanguage &arbLanguage(ir::Language language) {
  return language == ir::Language::ArbVertex ? kVertex : kFragment;
}

std::string_view foreignHint(std::string_view word, const ArbLanguage &language) {
  return language.addresses ? find(kFragmentWords, word) : find(kVertexWords, word);
}

bool isNvInstruction(std::string_view word, const ArbLanguage &language) {
  const std::string_view base = word.substr(0, word.find('_'));
  const auto listed = [&](std::span<const std::string_view> words) {
    return std::find(words.begin(), words.end(), base) != words.end();
  };
  return language.language == ir::Language::ArbVertex ? listed(kNvVertex) : listed(kNvFragment);
}

std::vector<std::string_view> statementWords(const ArbLanguage &language) {
  std::vector<std::string_view> words = {"ALIAS", "ATTRIB", "OUTPUT", "PARAM", "TEMP", "END"};
  if (language.addresses)
    words.emplace_back("ADDRESS");
  for (int i = 0; i < ir::kOpcodeCount; ++i)
    if (const ir::OpInfo &op = info(ir::Opcode(i)); !op.has(language.foreign))
      words.emplace_back(op.mnemonic);
  return words;
}

} // namespace arbiter::fp
