#include "fp_compiler/front/native/header.h"

#include <algorithm>

#include "fp_compiler/native_interface.h"

namespace arbiter::fp::native {

namespace {
using ir::Language;
using ir::NativeLanguage;

struct HeaderRow {
  std::string_view begin;
  Language stage;
};
constexpr HeaderRow kHeaders[] = {{"!!FP", Language::ArbFragment},
                                  {"!!FCP", Language::ArbFragment},
                                  {"!!VP", Language::ArbVertex},
                                  {"!!VSP", Language::ArbVertex}};

/// Returns how many bytes at the text's beginning agree with a header.
std::size_t agreement(std::string_view text) {
  std::size_t most = 0;
  for (const NativeLanguage language :
       {NativeLanguage::Fp1, NativeLanguage::Vp1, NativeLanguage::Vp11, NativeLanguage::Vp2,
        NativeLanguage::Vsp1}) {
    const std::string_view header = headerOf(language);
    const std::size_t size = std::min(header.size(), text.size());
    const auto *const differs =
        std::mismatch(header.begin(), header.begin() + size, text.begin()).first;
    most = std::max(most, std::size_t(differs - header.begin()));
  }
  return most;
}
} // namespace

std::optional<Language> stageOfHeader(std::string_view text) {
  for (const HeaderRow &row : kHeaders)
    if (text.starts_with(row.begin))
      return row.stage;
  return std::nullopt;
}

void refuseHeader(Language target, std::string_view text, Reporter &reporter) {
  const std::string_view line = text.substr(0, text.find_first_of(" \t\r\n#"));
  const bool taken = nativeLanguageOf(text) != NativeLanguage::None;
  const auto at = std::uint32_t(taken ? 2 : agreement(text));
  const Span where = {at, std::min(at + 1, std::uint32_t(text.size()))};
  if (taken)
    return reporter.error(DiagnosticId::NativeHeader, where,
                          quote(line) + (target == Language::ArbFragment ? " is no fragment program"
                                                                         : " is no vertex program"),
                          target == Language::ArbFragment ? "load it for GL_VERTEX_PROGRAM_NV"
                                                          : "load it for GL_FRAGMENT_PROGRAM_NV");
  reporter.error(DiagnosticId::NativeHeader, where, "there is no language " + quote(line),
                 "NVIDIA's are !!FP1.0, !!VP1.0, !!VP1.1, !!VP2.0 and !!VSP1.0; later ones are "
                 "options of !!ARBfp1.0 and !!ARBvp1.0");
}

} // namespace arbiter::fp::native
