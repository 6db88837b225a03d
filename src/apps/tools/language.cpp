#include "apps/tools/language.h"

#include <algorithm>
#include <iterator>

#include "fp_compiler/ati/limits.h"
#include "fp_compiler/front/nvparse/limits.h"

namespace arbiter::tools {

using fp::ir::Language;

namespace {
constexpr LanguageRow kLanguages[] = {
    {"arbfp", "!!ARBfp1.0", Language::ArbFragment}, {"arbvp", "!!ARBvp1.0", Language::ArbVertex},
    {"atifs", "!!ATIfs1.0", Language::AtiFragment}, {"rc", "!!RC1.0", Language::Combiners},
    {"ts", "!!TS1.0", Language::TextureShaders},
};
static_assert(std::size(kLanguages) == kLanguageCount);

constexpr std::string_view kLimitId = "limit_"; ///< prefix of the diagnostics of API limits
} // namespace

std::span<const LanguageRow> languageRows() { return kLanguages; }

const LanguageRow &languageRow(Language language) {
  for (const LanguageRow &row : kLanguages)
    if (row.language == language)
      return row;
  return kLanguages[0];
}

std::vector<std::string> languageNames() {
  std::vector<std::string> names = {"auto"};
  for (const LanguageRow &row : kLanguages)
    names.emplace_back(row.name);
  return names;
}

Language chooseLanguage(std::string_view name, std::string_view text) {
  for (const LanguageRow &row : kLanguages)
    if (name == row.name)
      return row.language;
  return fp::languageOfText(text).value_or(Language::ArbFragment);
}

std::vector<fp::FileProgram> choosePrograms(std::string_view name, std::string_view file) {
  std::vector<fp::FileProgram> programs = fp::programsOf(file);
  const Language language = chooseLanguage(name, programs.front().in(file));
  if (name != "auto")
    std::erase_if(programs, [language](const auto &each) { return each.language != language; });
  if (programs.empty())
    programs.push_back({language, {0, std::uint32_t(file.size())}});
  return programs;
}

fp::FileProgram chooseProgram(std::string_view name, std::string_view file) {
  const std::vector<fp::FileProgram> programs = choosePrograms(name, file);
  for (const fp::FileProgram &program : programs)
    if (program.language == Language::ArbFragment)
      return program;
  return programs.front();
}

std::string languageTitle(Language language, std::string_view text) {
  const fp::ir::NativeLanguage own = fp::nativeLanguageOf(text);
  const std::string_view header =
      own == fp::ir::NativeLanguage::None ? languageRow(language).header : fp::ir::headerOf(own);
  return std::string(header.substr(2)); // without "!!"
}

std::string titleOf(const std::string &name, std::string_view file,
                    const fp::FileProgram &program) {
  if (fp::programsOf(file).size() == 1)
    return name;
  return name + ", " + languageTitle(program.language, program.in(file)) + " of line " +
         std::to_string(fp::locate(file, program.span.begin).line);
}

fp::Limits limitsOf(const fp::hw::Profile &profile, Language language) {
  if (language == Language::AtiFragment)
    return fp::ati::limitsOf(profile.fragment);
  if (isNvparse(language)) {
    fp::Limits limits = profile.fragment;
    limits.generalCombiners = profile.combiners.general;
    limits.perStageConstants = profile.combiners.perStageConstants;
    limits.textureShaders = profile.textureShaders;
    return fp::nvparse::limitsOf(limits);
  }
  return language == Language::ArbVertex ? profile.vertex : profile.fragment;
}

bool hasPrograms(const fp::Limits &limits, Language language) {
  // Only ARBfp can be missing. Drivers run vertex programs on the processor, and limitsOf() gives
  // limits of the other languages for every card.
  return language != Language::ArbFragment || limits.native.instructions != 0;
}

std::string_view lackOf(const fp::Limits &limits, Language language) {
  if (!hasPrograms(limits, language))
    return "the card has no fragment programs";
  if (language == Language::ArbVertex && limits.native.instructions == 0)
    return "the card has no vertex programs of its own: its driver runs them on the processor";
  return {};
}

bool isOfLimit(const fp::Diagnostic &diagnostic) {
  return std::string_view(diagnostic.id).starts_with(kLimitId);
}

const fp::ResourceRow *limitedRow(const fp::Diagnostic &diagnostic) {
  std::string key(std::string_view(diagnostic.id).substr(kLimitId.size()));
  std::replace(key.begin(), key.end(), '-', '_');
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (key == row.name)
      return &row;
  return nullptr;
}

} // namespace arbiter::tools
