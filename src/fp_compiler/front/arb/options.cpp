#include <algorithm>
#include <iterator>

#include "fp_compiler/front/arb/parser.h"
#include "util/suggest.h"

namespace arbiter::fp {

namespace {

using ir::Language;

/// Sets what the option asks for. Returns false if it conflicts with an option before it.
using Apply = bool (*)(ir::Options &);

template <ir::FogMode mode> bool fog(ir::Options &options) {
  if (options.fog != ir::FogMode::None && options.fog != mode)
    return false;
  options.fog = mode;
  return true;
}

template <ir::Precision wanted> bool precision(ir::Options &options) {
  if (options.precision != ir::Precision::Unspecified && options.precision != wanted)
    return false;
  options.precision = wanted;
  return true;
}

template <ir::NvOption wanted> bool nvidia(ir::Options &options) {
  if (options.nv != ir::NvOption::None && options.nv != wanted)
    return false;
  options.nv = wanted;
  return true;
}

template <bool ir::Options::*flag> bool set(ir::Options &options) { return options.*flag = true; }

struct Conflict {
  DiagnosticId id;
  const char *message;
  const char *hint;
};
constexpr Conflict kFogs = {DiagnosticId::ConflictingFog, "a second, different fog option",
                            "a program may have one of ARB_fog_exp, ARB_fog_exp2 and "
                            "ARB_fog_linear"};
constexpr Conflict kPrecisions = {
    DiagnosticId::ConflictingPrecision, "both precision hints",
    "keep either ARB_precision_hint_fastest or ARB_precision_hint_nicest"};

constexpr Conflict kNvidia = {DiagnosticId::ConflictingNv, "a second, different option of NVIDIA",
                              "the later one of the two has all that the other one has"};

struct OptionRow {
  std::string_view name;
  Language language;
  Apply apply;
  const Conflict *conflict; ///< where `apply` may be false
};

/// The options of ARB_fragment_program 3.11.4.5, of its extensions, and of ARB_vertex_program
/// 2.14.4.5.
constexpr OptionRow kOptions[] = {
#define FP_OPTION(word, language, apply, conflict, section, doc)                                   \
  {word, Language::language, apply, conflict},
#include "fp_compiler/front/words/words.def"
};

} // namespace

void Parser::applyOption(const Token &token) {
  const auto row = std::find_if(std::begin(kOptions), std::end(kOptions), [&](const auto &option) {
    return option.name == text(token) && option.language == m_language.language;
  });
  ir::Options options = m_options;
  // Vertex programs that may sample can use this option for shadow targets too. It may come before
  // or after NV_vertex_program3, or without it (NV_vertex_program3, dependencies on
  // ARB_fragment_program_shadow).
  if (m_language.language == Language::ArbVertex &&
      m_limits.nvOptions >= std::uint32_t(ir::NvOption::Second) &&
      text(token) == "ARB_fragment_program_shadow") {
    m_options.shadow = true;
    return;
  }
  if (row != std::end(kOptions) && !row->apply(options))
    error(row->conflict->id, token.span, row->conflict->message, row->conflict->hint);
  else if (row == std::end(kOptions) || std::uint32_t(options.nv) > m_limits.nvOptions)
    refuseOption(token);
  else
    m_options = options;
}

void Parser::refuseOption(const Token &token) {
  const std::string_view name = text(token);
  const std::string option = "OPTION " + std::string(name.substr(0, 48));
  std::vector<std::string_view> offered;
  bool other = false;
  ir::Options asked; // what the option would set
  for (const OptionRow &row : kOptions) {
    other |= row.name == name && row.language != m_language.language;
    if (row.language != m_language.language)
      continue;
    if (!row.name.starts_with("NV_"))
      offered.push_back(row.name);
    else if (row.name == name)
      row.apply(asked);
  }
  if (other)
    error(DiagnosticId::UnsupportedOption, token.span,
          option + ": " + m_language.foreignName + " only",
          name == "ARB_position_invariant"
              ? "remove it; a fragment program keeps the rasterizer's position"
              : "remove it");
  else if (name.starts_with("NV_"))
    error(DiagnosticId::UnsupportedOption, token.span, option + " is not offered",
          asked.nv == ir::NvOption::First ? "the profiles from nv30 to nv40 and host have it"
          : asked.nv == ir::NvOption::Second
              ? "the profiles nv40 and host have it"
              : "no profile has it; use a path of the application that needs no such option");
  else
    error(DiagnosticId::UnsupportedOption, token.span, "OPTION " + quote(name) + " is not offered",
          didYouMean(name, offered));
}

} // namespace arbiter::fp
