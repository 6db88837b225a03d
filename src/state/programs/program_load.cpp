// Implements ProgramString (3.11.1; ARB_vertex_program 2.14.1): passes the text to the compiler.
#include "state/programs/program_load.h"
#include "state/core/context_hooks.h"
#include "state/programs/program_context.h"
#include "state/programs/variants/drop_variants.h"

#include <algorithm>
#include <cstring>

#include "fp_compiler/ati/lower.h"
#include "fp_compiler/front/ati/write.h"
#include "fp_compiler/ir/print.h"
#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/identity/active_profile.h"
#include "state/programs/parameters.h"
#include "state/programs/program_bind.h"
#include "state/programs/program_cache.h"
#include "state/programs/replacement.h"
#include "state/programs/variants/array_variants.h"
#include "state/programs/variants/ati_variants.h"
#include "state/programs/variants/attribute_forms.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/programs/variants/depth_variants.h"
#include "state/report/capture.h"
#include "state/report/refusals.h"
#include "state/share/share_group.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// Checks ProgramString's format and length. Returns false after an error.
bool checkArguments(ProgramContext &context, GLenum format, GLsizei length) {
  if (format != GL_PROGRAM_FORMAT_ASCII_ARB) {
    raise(context, GL_INVALID_ENUM, "ProgramString: format is not PROGRAM_FORMAT_ASCII");
    return false;
  }
  if (length < 0) {
    raise(context, GL_INVALID_VALUE, "ProgramString: the length is negative");
    return false;
  }
  return true;
}

/// True if the text's language does not belong to the target. State programs have a target of their
/// own, which has no other language and is unknown to the compiler.
bool isOfOtherTarget(Target target, std::string_view text) {
  const bool isState = fp::nativeLanguageOf(text) == fp::ir::NativeLanguage::Vsp1;
  return isState != (target == Target::VertexState);
}

fp::Compilation refuseTarget(Target target) {
  fp::Compilation refused;
  const char *const hint = target == Target::VertexState
                               ? "VERTEX_STATE_PROGRAM_NV takes texts that begin with !!VSP1.0"
                               : "load it for GL_VERTEX_STATE_PROGRAM_NV";
  refused.check.diagnostics.push_back({.id = "native_header",
                                       .span = {0, 1},
                                       .message = "the header is one of another target",
                                       .hint = hint});
  return refused;
}

/// Sets named parameters to the values in their declarations, as a load does (NV_fragment_program
/// 3.11.2.3).
void storeFirstValues(ProgramObject &object, const fp::NativeInterface &native) {
  for (const fp::NamedParameter &parameter : native.named)
    if (parameter.local < object.locals.size())
      object.locals[parameter.local].store(parameter.value);
}

} // namespace

fp::CompileOptions compileOptions(const ProgramTarget &row) {
  fp::CompileOptions options;
  options.limits = row.limits;
  options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
  return options;
}

fp::GlslHost glslHost(const HostCaps &caps) {
  fp::GlslHost host;
  host.textureRectangle = caps.textureRectangle;
  host.fragCoordConventions = caps.fragCoordConventions;
  host.drawBuffers = caps.drawBuffers;
  host.bitEncoding = caps.bitEncoding;
  host.negativeFogDistances = caps.negativeFogDistances;
  host.clipPlanes = false; // the clipped variant of a program is made when it is needed
  return host;
}

fp::Compilation compileText(const ProgramContext &context, const ProgramTarget &row,
                            std::string_view text) {
  if (isOfOtherTarget(row.target, text))
    return refuseTarget(row.target);
  return compileCached(
      {row.info().language, compileOptions(row), glslHost(context.caps), context.numerics}, text);
}

std::shared_ptr<const CompiledProgram> compileProgram(const ProgramContext &context, Target target,
                                                      std::string_view text,
                                                      const fp::Compilation &own,
                                                      const Replacement *replacement) {
  const bool replaced = replacement && replacement->result.ok();
  const fp::CheckResult &source = replaced ? replacement->result : own.check;
  if (!source.ok())
    return nullptr;
  // The application's queries are answered for its own text, if that is valid.
  const fp::CheckResult &answers = own.check.ok() ? own.check : source;
  auto compiled = std::make_shared<CompiledProgram>();
  compiled->target = target;
  compiled->text = text;
  compiled->hash = hashBytes(text);
  if (replaced)
    compiled->replacement = replacement->text;
  compiled->warnings = own.check.ok() ? own.check.errorString(text) : std::string();
  compiled->counts = answers.counts;
  compiled->nativeCounts = answers.nativeCounts;
  compiled->underNativeLimits = answers.underNativeLimits;
  compiled->native = source.native;
  if (infoOf(target).language == fp::ir::Language::AtiFragment)
    compiled->ati = std::make_shared<const AtiVariants>(*source.program, glslHost(context.caps),
                                                        context.numerics);
  else {
    const bool alias = target == Target::Vertex && context.attributesAlias;
    const auto renamed = alias ? withConventionalAttributes(*source.program) : nullptr;
    compiled->program =
        renamed ? renamed : std::make_shared<const fp::ir::Program>(*source.program);
    compiled->glsl = replaced || renamed ? fp::emitGlsl(*compiled->program, glslHost(context.caps),
                                                        context.numerics)
                                         : own.glsl;
  }
  if (target == Target::Vertex &&
      (context.attributesAlias || compiled->native.language != fp::ir::NativeLanguage::None))
    compiled->arrays = std::make_shared<const ArrayVariants>(
        *compiled->program, glslHost(context.caps), context.numerics, context.caps.clipDistances());
  if (target == Target::Fragment)
    compiled->depths =
        std::make_shared<const DepthVariants>(glslHost(context.caps), context.numerics);
  if (target == Target::Vertex) {
    fp::GlslHost clipping = glslHost(context.caps);
    clipping.clipPlanes = true;
    compiled->clipped = std::make_shared<const ClippedVariant>(clipping, context.numerics,
                                                               context.caps.clipDistances());
  }
  if (debugFlag(DebugFlag::Ir))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), fp::ir::print(*source.program));
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), compiled->glsl.text);
  return compiled;
}

namespace {

/// Finds out whether the profile alone refuses the text.
Refusal refusalOf(const ProgramContext &context, const ProgramTarget &row, std::string_view text,
                  const fp::CheckResult &refused) {
  const auto loads = [&](const fp::CompileOptions &options) {
    return !isOfOtherTarget(row.target, text) &&
           fp::checkProgram(row.info().language, text, options).ok();
  };
  return noteRefusal(row.info().word, text, [&] {
    Refusal refusal;
    fp::CompileOptions options = compileOptions(row);
    options.limits =
        limitsUnder(*fp::hw::findBuiltin("host"), row.target, *context.host, context.caps);
    if (!loads(options))
      return refusal;
    options = compileOptions(row);
    options.policy = fp::LimitPolicy::Report;
    refusal.byReport = loads(options);
    for (const fp::Diagnostic &each : refused.diagnostics)
      if (each.severity == fp::Severity::Error && refusal.reason.empty())
        refusal.reason =
            "line " + std::to_string(fp::locate(text, each.span.begin).line) + ": " + each.message;
    return refusal;
  });
}

} // namespace

void loadProgram(ProgramContext &context, ProgramObject &object, GLenum format, GLsizei length,
                 const void *string) {
  if (!checkArguments(context, format, length))
    return;
  loadText(context, object,
           string ? std::string_view(static_cast<const char *>(string), std::size_t(length))
                  : std::string_view());
}

bool loadText(ProgramContext &context, ProgramObject &object, std::string_view text) {
  const std::shared_ptr<const CompiledProgram> old = context.group->compiledOf(object);
  // For a repeated text, only named parameters and the last error may change.
  if (old && old->text == text) {
    context.errors.position = -1;
    context.errors.text = old->warnings;
    if (!old->native.named.empty()) {
      storeFirstValues(object, old->native);
      noteLocalsChanged(context, object);
    }
    return true;
  }

  const ProgramTarget &row = context.row(object.target);
  const fp::Compilation own = compileText(context, row, text);
  const fp::CheckResult &result = own.check;
  context.errors.position = result.errorPosition();
  context.errors.text = result.errorString(text);
  if (debugFlag(DebugFlag::Text))
    logText(LogLevel::Debug, "state", toHex(hashBytes(text)), text);
  std::optional<Replacement> replacement;
  if (replacing())
    replacement = findReplacement(object.target, hashBytes(text), compileOptions(row));
  std::shared_ptr<const CompiledProgram> compiled =
      compileProgram(context, object.target, text, own, replacement ? &*replacement : nullptr);
  const Refusal refusal = compiled ? Refusal() : refusalOf(context, row, text, result);
  context.hooks->noteLoadedProgram(context, object, text, result, refusal);
  captureLoad(context, object, text, result, compiled.get());
  if (!compiled) {
    logInfo("state", "context %u: program %u refused:\n%s", context.serial, object.name,
            context.errors.text.c_str());
    raise(context, GL_INVALID_OPERATION, "ProgramString: the program is not valid");
    return false;
  }

  if (!context.errors.text.empty()) // over a limit with ARBITER_LIMITS=report, or replaced
    logInfo("state", "context %u: program %u loads with warnings:\n%s", context.serial, object.name,
            context.errors.text.c_str());
  if (!result.ok()) { // only the replacement is valid
    context.errors.position = -1;
    context.errors.text.clear();
  }
  if (controlled())
    noteLoadedText(object, compiled->hash);
  storeFirstValues(object, compiled->native);
  context.group->setCompiled(object, std::move(compiled));
  if (row.bound.get() == &object)
    invalidateProgram(context);
  if (old)
    dropVariants(context, *old);
  return true;
}

// --- Shaders made by the commands of ATI_fragment_shader ---

namespace {

fp::CheckResult checkReported(const ProgramTarget &row, std::string_view text) {
  fp::CompileOptions options = compileOptions(row);
  options.policy = fp::LimitPolicy::Report;
  return fp::checkProgram(row.info().language, text, options);
}

/// Sets the shader's text, if something needs one and the compiler would accept it.
void name(CompiledProgram &compiled, const ProgramTarget &row, const fp::ati::Shader &shader) {
  if (!capturing() && !replacing())
    return;
  std::optional<std::string> text = fp::ati::write(shader);
  if (!text)
    return;
  const fp::CheckResult own = checkReported(row, *text);
  if (!own.ok())
    return;
  compiled.text = std::move(*text);
  compiled.hash = hashBytes(compiled.text);
  compiled.counts = own.counts;
  compiled.nativeCounts = own.nativeCounts;
  compiled.commands = std::make_shared<const fp::ati::Shader>(shader);
}

} // namespace

std::shared_ptr<const CompiledProgram> compileFragmentShader(const ProgramContext &context,
                                                             const fp::ati::Shader &shader) {
  const ProgramTarget &row = context.row(Target::AtiApi);
  auto compiled = std::make_shared<CompiledProgram>();
  compiled->target = Target::AtiApi;
  compiled->underNativeLimits = true;
  name(*compiled, row, shader);
  std::optional<Replacement> replacement;
  if (compiled->commands && replacing())
    replacement = findReplacement(Target::AtiApi, compiled->hash, compileOptions(row));
  const bool replaced = replacement && replacement->result.ok();
  if (replaced)
    compiled->replacement = replacement->text;
  fp::ir::Program program =
      replaced ? std::move(*replacement->result.program)
               : fp::ati::lower(shader, {.registerRange = row.limits.atiRegisterRange,
                                         .clampConstants = false});
  const std::string listing = fp::ir::print(program);
  if (!compiled->commands)
    compiled->hash = hashBytes(listing);
  if (debugFlag(DebugFlag::Ir))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), listing);
  compiled->ati = std::make_shared<const AtiVariants>(std::move(program), glslHost(context.caps),
                                                      context.numerics);
  return compiled;
}

void noteShaderText(const ProgramContext &context, const CompiledProgram &compiled) {
  if (!compiled.commands)
    return;
  if (controlled())
    ProgramEdits::instance().noteLoad(textFileName(compiled.target, compiled.hash));
  if (capturing())
    CaptureRecord::instance()->loaded(context.serial, compiled.target, compiled.text,
                                      checkReported(context.row(Target::AtiApi), compiled.text), {},
                                      &compiled);
}

void recordProgramString(ProgramContext &context, Command::Kind kind, const ProgramTarget &row,
                         GLuint object, GLenum format, GLsizei length, const void *string) {
  Command command{.kind = kind, .target = row.info().name, .object = object};
  command.format = format;
  command.count = length;
  // A text over the limit is refused when it is executed; a part that is too long suffices for
  // that.
  if (string && length > 0) {
    command.count = std::min<GLsizei>(length, GLsizei(fp::kMaxTextBytes) + 1);
    command.bytes.assign(static_cast<const char *>(string), std::size_t(command.count));
  }
  context.list->record(context, std::move(command));
}

} // namespace arbiter::state
