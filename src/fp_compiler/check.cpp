#include <algorithm>
#include <bit>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/combiners/lower.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/arb/parser.h"
#include "fp_compiler/front/ati/parser.h"
#include "fp_compiler/front/native/header.h"
#include "fp_compiler/front/native/parser.h"
#include "fp_compiler/front/nvparse/text.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/inspect.h"
#include "fp_compiler/texture_shader/lower.h"
#include "fp_compiler/texture_shader/operations.h"

namespace arbiter::fp {

namespace {

/// Parses a text in one of NVIDIA's own languages. Returns nothing if the target does not offer it.
std::optional<ParseResult> parseNative(ir::Language target, std::string_view text,
                                       const CompileOptions &options, NameTable *names) {
  const ir::NativeLanguage language = nativeLanguageOf(text);
  const bool named = language != ir::NativeLanguage::None;
  const bool any = options.limits.nvOptions != 0 || options.limits.nvVertexProgram != 0;
  if (!any || !native::stageOfHeader(text) ||
      (named && stageOf(language) == target && !takesLanguage(options.limits, language)))
    return std::nullopt;
  if (named && stageOf(language) == target)
    return native::parse(language, text, options, names);
  ParseResult refused;
  Reporter reporter;
  native::refuseHeader(target, text, reporter);
  refused.diagnostics = reporter.take();
  return refused;
}

/// Says of a program that loads with more indirections than the card has whether the card runs it.
void sayHowItRuns(std::vector<Diagnostic> &diagnostics, bool fits) {
  for (Diagnostic &each : diagnostics)
    if (each.severity == Severity::Warning && each.id == info(DiagnosticId::LimitIndirections).id)
      each.message += fits ? "; what the card makes of it fits" : ", but not natively";
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
    if (options.policy == LimitPolicy::Enforce)
      sayHowItRuns(result.diagnostics, native.fits);
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
    // No text can use more than any hardware of this language has.
    result.underNativeLimits = true;
  }
  return result;
}

/// Returns the default texture environments: a unit with a stage modulates its texture with the
/// colour before it.
texture_shader::Environments defaultEnvironments(const texture_shader::State &shaders) {
  texture_shader::Environments environments;
  for (std::size_t unit = 0; unit < environments.size(); ++unit)
    if (shaders.stages[unit].operation != texture_shader::Operation::None)
      environments[unit].mode = texture_shader::EnvironmentMode::Modulate;
  return environments;
}

/// Lowers the text's state, without fog. Textures are 2D colour textures unless the text says
/// otherwise.
ir::Program lowerNvparse(const nvparse::Text &text, Numerics numerics) {
  const bool fx9 = numerics == Numerics::Fx9;
  ir::Program program;
  if (text.shaders) {
    texture_shader::Key key;
    key.shaders = *text.shaders;
    key.combines = text.combiners.has_value();
    key.fx9 = fx9;
    if (key.combines)
      key.combiners = *text.combiners;
    else
      key.environments = defaultEnvironments(key.shaders);
    program = texture_shader::lower(texture_shader::essential(key));
  } else {
    const combiners::State state = combiners::essential(*text.combiners);
    combiners::Surroundings around;
    around.fx9 = fx9;
    const std::uint32_t read = combiners::texturesRead(state);
    for (std::size_t unit = 0; unit < around.texels.size(); ++unit) {
      around.targets[unit] = ir::TexTarget::Tex2D;
      if ((read >> unit & 1u) != 0)
        around.texels[unit] = combiners::Texel::Color;
    }
    program = combiners::lower(state, around);
  }
  texture_shader::bindValues(program, text.values);
  return program;
}

/// Returns the longest chain of texture stages in which each reads the result of the one before.
std::uint32_t chainOf(const texture_shader::State &state) {
  std::array<std::uint32_t, texture_shader::kUnits> depth{};
  std::uint32_t most = 1;
  for (std::size_t unit = 0; unit < state.units; ++unit) {
    const texture_shader::Stage &stage = state.stages[unit];
    const texture_shader::OperationInfo &info = texture_shader::infoOf(stage.operation);
    const bool reads = texture_shader::readsPrevious(info.family) && stage.previous < unit;
    depth[unit] = (reads ? depth[stage.previous] : 0u) + (info.target ? 1u : 0u);
    most = std::max(most, depth[unit]);
  }
  return most;
}

/// Counts resources. General combiner stages are ALU instructions. Texture units that are sampled
/// or have a stage are texture instructions. The rest is what the program uses.
ResourceCounts countNvparse(const nvparse::Text &text, const ir::Program &program) {
  ResourceCounts counts;
  if (text.combiners) {
    counts.aluInstructions = text.combiners->count;
    counts.texInstructions = std::uint32_t(
        std::popcount(combiners::texturesRead(combiners::essential(*text.combiners))));
    counts.temporaries = combiners::registersWritten(*text.combiners);
  }
  counts.texIndirections = text.shaders ? chainOf(*text.shaders) : 1;
  if (text.shaders) {
    counts.texInstructions = 0;
    for (const texture_shader::Stage &stage : text.shaders->stages)
      counts.texInstructions += stage.operation != texture_shader::Operation::None ? 1 : 0;
  }
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  for (const ir::Parameter &parameter : program.parameters) {
    const bool isEnv = parameter.kind == ir::ParameterKind::Env;
    counts.parameters += isEnv ? 1 : 0;
  }
  for (const std::optional<ir::Vec4> &value : text.values)
    counts.parameters += value ? 1 : 0;
  counts.attribs = std::uint32_t(program.attributes.size());
  return counts;
}

CheckResult checkNvparse(ir::Language language, std::string_view text,
                         const CompileOptions &options, NameTable *names) {
  nvparse::ParseResult parsed = nvparse::parse(language, text, options, names);
  CheckResult result;
  result.diagnostics = std::move(parsed.diagnostics);
  if (parsed.text) {
    result.program = lowerNvparse(*parsed.text, options.numerics);
    result.counts = result.nativeCounts = countNvparse(*parsed.text, *result.program);
    const Limits &limits = options.limits;
    result.underNativeLimits = result.counts.aluInstructions <= limits.generalCombiners ||
                               (!parsed.text->combiners && limits.textureShaders != 0);
  }
  return result;
}

CheckResult checkIn(ir::Language language, std::string_view text, const CompileOptions &options,
                    NameTable *names) {
  switch (language) {
  case ir::Language::ArbFragment:
  case ir::Language::ArbVertex:
    return checkArbProgram(arbLanguage(language), text, options, names);
  case ir::Language::Combiners:
  case ir::Language::TextureShaders:
    return checkNvparse(language, text, options, names);
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
  if (text.starts_with("!!RC"))
    return ir::Language::Combiners;
  if (text.starts_with("!!TS"))
    return ir::Language::TextureShaders;
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
