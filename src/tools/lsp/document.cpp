#include "tools/lsp/document.h"
#include <algorithm>

#include "fp_compiler/front/lexer.h"
#include "tools/language.h"

namespace arbiter::tools::lsp {

namespace {

using fp::ir::Language;

struct EndingRow {
  std::string_view ending;
  Language language;
};
constexpr EndingRow kEndings[] = {
    {".vp", Language::ArbVertex},        {".arbvp", Language::ArbVertex},
    {".vert", Language::ArbVertex},      {".atifs", Language::AtiFragment},
    {".fp", Language::ArbFragment},      {".arbfp", Language::ArbFragment},
    {".frag", Language::ArbFragment},    {".nvrc", Language::Combiners},
    {".nvts", Language::TextureShaders},
};

std::vector<fp::Token> tokensOf(std::string_view text, Language language) {
  std::vector<fp::Token> tokens;
  if (text.size() > fp::kMaxTextBytes)
    return tokens;
  const auto words = isNvparse(language)                 ? fp::Words::Calls
                     : language == Language::AtiFragment ? fp::Words::Suffixes
                                                         : fp::Words::Identifiers;
  const fp::ir::NativeLanguage own = fp::nativeLanguageOf(text);
  const std::string_view header =
      own == fp::ir::NativeLanguage::None ? languageRow(language).header : fp::ir::headerOf(own);
  const std::uint32_t begin = text.starts_with(header) ? std::uint32_t(header.size())
                              : text.starts_with("!")
                                  ? std::uint32_t(std::min(text.find_first_of("\r\n"), text.size()))
                                  : 0;
  fp::Lexer lexer(text, begin, words);
  for (fp::Token token = lexer.next(); token.kind != fp::TokenKind::EndOfText; token = lexer.next())
    tokens.push_back(token);
  return tokens;
}

} // namespace

Document::Document(std::string uri, std::string languageId, std::string text, Encoding encoding)
    : m_uri(std::move(uri)), m_languageId(std::move(languageId)), m_encoding(encoding) {
  setText(std::move(text));
}

void Document::setText(std::string text) {
  forget(); // what is known views the text
  m_text = std::move(text);
  m_map = TextMap(m_text, m_encoding);
  changed = true;
}

bool Document::change(const Json &change) {
  const std::string *piece = stringAt(change, {"text"});
  if (!piece)
    return false;
  const Json *range = member(change, {"range"});
  if (!range) {
    setText(*piece);
    return true;
  }
  const Json *start = member(*range, {"start"});
  const Json *end = member(*range, {"end"});
  const auto from = start ? m_map.offset(*start) : std::nullopt;
  const auto to = end ? m_map.offset(*end) : std::nullopt;
  if (!from || !to || *to < *from)
    return false;
  std::string text = m_text;
  text.replace(*from, *to - *from, *piece);
  setText(std::move(text));
  return true;
}

/// As the header says; without one, as the editor or the file's name says.
Language Document::language() const {
  if (const auto named = fp::languageOfText(m_text))
    return *named;
  for (const LanguageRow &row : languageRows())
    if (m_languageId == row.name)
      return row.language;
  for (const EndingRow &row : kEndings)
    if (std::string_view(m_uri).ends_with(row.ending))
      return row.language;
  return Language::ArbFragment;
}

namespace {
/// NVIDIA's option among those at the text's beginning, if the profile has it: it decides which
/// words there are.
fp::ir::NvOption nvOptionOf(std::string_view text, const std::vector<fp::Token> &tokens,
                            const fp::Limits &limits) {
  const auto word = [&](std::size_t i) {
    return text.substr(tokens[i].span.begin, tokens[i].span.end - tokens[i].span.begin);
  };
  using fp::ir::NvOption;
  NvOption option = NvOption::None;
  for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
    if (word(i) != "OPTION")
      continue;
    const std::string_view name = word(i + 1);
    if (name == "NV_fragment_program2" || name == "NV_vertex_program3")
      option = NvOption::Second;
    else if (name == "NV_fragment_program" || name == "NV_vertex_program2")
      option = NvOption::First;
  }
  return std::uint32_t(option) <= limits.nvOptions ? option : NvOption::None;
}
} // namespace

const Analysis &Document::analysis(const fp::hw::Profile &profile) {
  if (m_analysis)
    return *m_analysis;
  m_analysis = std::make_unique<Analysis>();
  Analysis &made = *m_analysis;
  made.language = language();
  made.limits = limitsOf(profile, made.language);
  made.tokens = tokensOf(m_text, made.language);
  made.nv = nvOptionOf(m_text, made.tokens, made.limits);
  if (fp::takesLanguage(made.limits, fp::nativeLanguageOf(m_text)))
    made.ownLanguage = fp::nativeLanguageOf(m_text);
  fp::CompileOptions options;
  options.limits = made.limits;
  made.inspection = fp::inspectProgram(made.language, m_text, options);
  const fp::CheckResult &check = made.inspection.check;
  if (check.ok() && made.language != Language::AtiFragment && !isNvparse(made.language))
    made.native = fp::hw::explainNative(*check.program, check.counts, made.limits);
  return made;
}

const std::vector<advise::Advice> &Document::advice(const fp::hw::Profile &profile) {
  if (!m_advice) {
    const Analysis &known = analysis(profile);
    m_advice = std::make_unique<std::vector<advise::Advice>>();
    if (known.inspection.check.ok())
      *m_advice = advise::advise(m_text, {known.language, known.limits});
  }
  return *m_advice;
}

} // namespace arbiter::tools::lsp
