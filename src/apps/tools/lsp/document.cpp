#include "apps/tools/lsp/document.h"
#include <algorithm>

#include "apps/tools/language.h"
#include "fp_compiler/doubts/doubts.h"
#include "fp_compiler/front/lexer.h"

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

/// Returns a program's tokens with positions in the file.
std::vector<fp::Token> tokensOf(std::string_view file, const fp::FileProgram &program) {
  const std::string_view text = program.in(file);
  const Language language = program.language;
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
    tokens.push_back(
        {token.kind, {token.span.begin + program.span.begin, token.span.end + program.span.begin}});
  return tokens;
}

} // namespace

Document::Document(std::string uri, std::string languageId, std::string text, Encoding encoding)
    : m_uri(std::move(uri)), m_languageId(std::move(languageId)), m_encoding(encoding) {
  setText(std::move(text));
}

void Document::setText(std::string text) {
  forget(); // the analyses refer to the old text
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

/// Finds the programs by their headers. Without a header, the editor's language or the file name's
/// ending decides the language.
std::vector<fp::FileProgram> Document::programs() const {
  std::vector<fp::FileProgram> found = fp::programsOf(m_text);
  if (fp::languageOfText(found.front().in(m_text)))
    return found;
  Language &language = found.front().language;
  for (const LanguageRow &row : languageRows())
    if (m_languageId == row.name) {
      language = row.language;
      return found;
    }
  for (const EndingRow &row : kEndings)
    if (std::string_view(m_uri).ends_with(row.ending)) {
      language = row.language;
      break;
    }
  return found;
}

namespace {
/// Returns the NVIDIA option that the text names, if the profile has it. It adds words to the
/// language.
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

Analysis Document::analysed(const fp::FileProgram &program, const fp::hw::Profile &profile) const {
  Analysis made;
  made.program = program;
  made.language = program.language;
  made.limits = limitsOf(profile, made.language);
  made.tokens = tokensOf(m_text, program);
  made.nv = nvOptionOf(m_text, made.tokens, made.limits);
  const fp::ir::NativeLanguage native = fp::nativeLanguageOf(program.in(m_text));
  if (fp::takesLanguage(made.limits, native))
    made.ownLanguage = native;
  fp::CompileOptions options;
  options.limits = made.limits;
  made.inspection = fp::inspectProgramIn(m_text, program, options);
  fp::addDoubts(m_text, program, made.inspection.check);
  const fp::CheckResult &check = made.inspection.check;
  if (check.ok() && made.language != Language::AtiFragment && !isNvparse(made.language))
    made.native = fp::hw::explainNative(*check.program, check.counts, made.limits);
  return made;
}

const std::vector<Analysis> &Document::analyses(const fp::hw::Profile &profile) {
  if (m_analyses.empty())
    for (const fp::FileProgram &program : programs()) {
      m_analyses.push_back(analysed(program, profile));
      m_analyses.back().isFirst = m_analyses.size() == 1;
    }
  return m_analyses;
}

const Analysis &Document::analysis(const fp::hw::Profile &profile, std::uint32_t offset) {
  const std::vector<Analysis> &all = analyses(profile);
  const auto after = std::find_if(all.begin() + 1, all.end(), [offset](const Analysis &each) {
    return offset < each.program.span.begin;
  });
  return *(after - 1);
}

const std::vector<advise::Advice> &Document::advice(const fp::hw::Profile &profile) {
  if (m_advice)
    return *m_advice;
  m_advice = std::make_unique<std::vector<advise::Advice>>();
  for (const Analysis &known : analyses(profile)) {
    if (!known.inspection.check.ok())
      continue;
    for (advise::Advice &advice :
         advise::advise(known.program.in(m_text), {known.language, known.limits})) {
      advise::move(advice, known.program.span.begin);
      m_advice->push_back(std::move(advice));
    }
  }
  return *m_advice;
}

} // namespace arbiter::tools::lsp
