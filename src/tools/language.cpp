#include "tools/language.h"

#include "fp_compiler/ati/limits.h"

namespace arbiter::tools {

using fp::ir::Language;

namespace {
constexpr LanguageRow kLanguages[] = {
    {"arbfp", "!!ARBfp1.0", Language::ArbFragment},
    {"arbvp", "!!ARBvp1.0", Language::ArbVertex},
    {"atifs", "!!ATIfs1.0", Language::AtiFragment},
};
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

std::string languageTitle(Language language, std::string_view text) {
  const fp::ir::NativeLanguage own = fp::nativeLanguageOf(text);
  const std::string_view header =
      own == fp::ir::NativeLanguage::None ? languageRow(language).header : fp::ir::headerOf(own);
  return std::string(header.substr(2));
}

fp::Limits limitsOf(const fp::hw::Profile &profile, Language language) {
  if (language == Language::AtiFragment)
    return fp::ati::limitsOf(profile.fragment);
  return language == Language::ArbVertex ? profile.vertex : profile.fragment;
}

} // namespace arbiter::tools
