#include <algorithm>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/native/header.h"
#include "fp_compiler/front/native/parser.h"
#include "fp_compiler/front/parser.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/inspect.h"

namespace arbiter::fp {

namespace {

/// A text of NVIDIA's own languages, where the target has them.
std::optional<ParseResult> parseNative(ir::Language target, std::string_view text,
                                       const CompileOptions &options, NameTable *names) {
  if (options.limits.nvOptions == 0 || !native::stageOfHeader(text))
    return std::nullopt;
  const ir::NativeLanguage language = nativeLanguageOf(text);
  if (language != ir::NativeLanguage::None && stageOf(language) == target)
    return native::parse(language, text, options, names);
  ParseResult refused;
  Reporter reporter;
  native::refuseHeader(target, text, reporter);
  refused.diagnostics = reporter.take();
  return refused;
}

CheckResult checkArbProgram(const ArbLanguage &language, std::string_view text,
                            const CompileOptions &options, NameTable *names) {
  std::optional<ParseResult> own = parseNative(language.language, text, options, names);
  ParseResult parsed = own ? std::move(*own) : parseArbProgram(language, text, options, names);
  CheckResult result;
  result.native = std::move(parsed.native);
  result.diagnostics = std::move(parsed.diagnostics);
  result.program = std::move(parsed.program);
  if (result.program) {
    result.counts = parsed.counts;
    const hw::NativeCounts native = hw::countNative(*result.program, parsed.counts, options.limits);
    result.nativeCounts = native.counts;
    result.underNativeLimits = native.fits;
  }
  return result;
}

CheckResult checkAtiShader(std::string_view text, const CompileOptions &options, NameTable *names) {
  ati::ParseResult parsed = ati::parse(text, options, names);
  CheckResult result;
  result.diagnostics = std::move(parsed.diagnostics);
  if (parsed.shader) {
    result.program = ati::lower(*parsed.shader, {options.limits.atiRegisterRange});
    result.counts = result.nativeCounts = parsed.counts;
    // The text cannot ask for more than any hardware of this language has.
    result.underNativeLimits = true;
  }
  return result;
}

CheckResult checkIn(ir::Language language, std::string_view text, const CompileOptions &options,
                    NameTable *names) {
  switch (language) {
  case ir::Language::ArbFragment:
  case ir::Language::ArbVertex:
    return checkArbProgram(arbLanguage(language), text, options, names);
  case ir::Language::AtiFragment:
    break;
  }
  return checkAtiShader(text, options, names);
}

} // namespace

std::int32_t CheckResult::errorPosition() const {
  const auto found = std::find_if(diagnostics.begin(), diagnostics.end(), [](const Diagnostic &d) {
    return d.severity == Severity::Error;
  });
  return found == diagnostics.end() ? -1 : std::int32_t(found->span.begin);
}

std::string CheckResult::errorString(std::string_view text) const {
  return renderAll("program", text, diagnostics);
}

std::optional<ir::Language> languageOfText(std::string_view text) {
  if (text.starts_with("!!ARBfp"))
    return ir::Language::ArbFragment;
  if (text.starts_with("!!ARBvp"))
    return ir::Language::ArbVertex;
  if (text.starts_with("!!ATIfs"))
    return ir::Language::AtiFragment;
  return native::stageOfHeader(text);
}

CheckResult checkProgram(ir::Language language, std::string_view text,
                         const CompileOptions &options) {
  return checkIn(language, text, options, nullptr);
}

Inspection inspectProgram(ir::Language language, std::string_view text,
                          const CompileOptions &options) {
  Inspection inspection;
  inspection.check = checkIn(language, text, options, &inspection.names);
  inspection.names.sort();
  return inspection;
}

CheckResult checkFragmentProgram(std::string_view text, const CompileOptions &options) {
  return checkProgram(ir::Language::ArbFragment, text, options);
}

} // namespace arbiter::fp
