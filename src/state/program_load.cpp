// ProgramString (3.11.1): the fragment target's text goes to our compiler, the vertex target's to
// the host after a look at its size and shape.
#include <algorithm>
#include <cstring>

#include "fp_compiler/ir/print.h"
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/errors.h"
#include "state/program_api.h"
#include "state/share_group.h"
#include "state/statistics.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

/// What a vertex program may hold before the host's parser sees it. Far above any real program and
/// any limit of a host, far below what is known to crash or to stall one.
constexpr std::size_t kMaxVertexStatements = 32768;
constexpr std::size_t kMaxListElements = 4000;

bool checkArguments(Context &context, GLenum format, GLsizei length) {
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

fp::CompileOptions compileOptions(const Context &context) {
  fp::CompileOptions options;
  options.limits = context.limits;
  options.policy = settings().enforceLimits ? fp::LimitPolicy::Enforce : fp::LimitPolicy::Report;
  return options;
}

fp::GlslHost glslHost(const HostCaps &caps) {
  fp::GlslHost host;
  host.textureRectangle = caps.textureRectangle;
  host.fragCoordConventions = caps.fragCoordConventions;
  host.drawBuffers = caps.drawBuffers;
  return host;
}

/// The first byte of a vertex program that the host must not see, with the reason; npos if none.
std::size_t unsafeVertexText(std::string_view text, const char *&reason) {
  if (text.size() > fp::kMaxTextBytes) {
    reason = "the program is longer than 1 MiB";
    return fp::kMaxTextBytes;
  }
  std::size_t statements = 0;
  std::size_t elements = 0; // of all lists: the host keeps one table of constants a program
  int depth = 0;
  bool comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\0') {
      reason = "a NUL byte";
      return i;
    }
    if (comment) {
      comment = c != '\n' && c != '\r';
      continue;
    }
    comment = c == '#';
    depth += c == '{' ? 1 : c == '}' ? -1 : 0;
    statements += c == ';' ? 1 : 0;
    // A list's elements are parted by commas at depth 1; a vector's components, deeper or not, are
    // at most four.
    elements += (c == ',' && depth == 1) || (c == '{' && depth == 1) ? 1 : 0;
    if (statements > kMaxVertexStatements || elements > kMaxListElements) {
      reason = elements > kMaxListElements ? "lists of more than 4000 constants"
                                           : "more than 32768 statements";
      return i;
    }
  }
  return std::string_view::npos;
}

void takeHostError(Context &context) {
  GLint position = -1;
  context.host->GetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
  context.errorPosition = position;
  const auto *const text =
      reinterpret_cast<const char *>(context.host->GetString(GL_PROGRAM_ERROR_STRING_ARB));
  context.errorString = text ? text : "";
}

} // namespace

void loadFragmentProgram(Context &context, ProgramObject &object, GLenum format, GLsizei length,
                         const void *string) {
  if (!checkArguments(context, format, length))
    return;
  const std::string_view text =
      string ? std::string_view(static_cast<const char *>(string), std::size_t(length))
             : std::string_view();
  const std::shared_ptr<const CompiledProgram> old = context.group->compiledOf(object);
  if (old && old->text == text) { // nothing can have changed but the last error
    context.errorPosition = -1;
    context.errorString = old->warnings;
    return;
  }

  const fp::CheckResult result = fp::checkFragmentProgram(text, compileOptions(context));
  context.errorPosition = result.errorPosition();
  context.errorString = result.errorString(text);
  noteLoadedProgram(context, object.name, text, result);
  if (debugFlag(DebugFlag::Text))
    logText(LogLevel::Debug, "state", toHex(hashBytes(text)), text);
  if (!result.ok()) {
    logInfo("state", "context %u: program %u refused:\n%s", context.serial, object.name,
            context.errorString.c_str());
    return raise(context, GL_INVALID_OPERATION, "ProgramString: the program is not valid");
  }

  if (!context.errorString.empty()) // over a limit, under ARBITER_LIMITS=report
    logInfo("state", "context %u: program %u loads with warnings:\n%s", context.serial, object.name,
            context.errorString.c_str());
  auto compiled = std::make_shared<CompiledProgram>();
  compiled->text = text;
  compiled->hash = hashBytes(text);
  compiled->warnings = context.errorString;
  compiled->counts = result.counts;
  compiled->nativeCounts = result.nativeCounts;
  compiled->underNativeLimits = result.underNativeLimits;
  compiled->glsl = fp::emitGlsl(*result.program, glslHost(context.caps));
  if (debugFlag(DebugFlag::Ir))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), fp::ir::print(*result.program));
  if (debugFlag(DebugFlag::Glsl))
    logText(LogLevel::Debug, "state", toHex(compiled->hash), compiled->glsl.text);
  context.group->setCompiled(object, std::move(compiled));
  if (context.fragmentProgram.get() == &object)
    invalidateProgram(context);
  if (old)
    context.variants.drop(context, old.get());
}

namespace {

/// The text for the host's parser, ended by NUL whatever it reads past the length; false after an
/// error.
bool vertexText(Context &context, GLenum format, GLsizei length, const void *string,
                std::string &text) {
  if (!checkArguments(context, format, length))
    return false;
  if (string)
    text.assign(static_cast<const char *>(string), std::size_t(length));
  const char *reason = "";
  const std::size_t unsafe = unsafeVertexText(text, reason);
  if (unsafe != std::string_view::npos) {
    context.errorPosition = GLint(unsafe);
    context.errorString = std::string("error: ") + reason + "; not passed to the host's parser";
    raise(context, GL_INVALID_OPERATION, "ProgramString: unsafe vertex program");
    return false;
  }
  // Bytes that are not ASCII can only stand in comments of a valid program.
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c & 0x80) != 0; }, '?');
  return true;
}

} // namespace

void loadVertexProgram(Context &context, GLenum format, GLsizei length, const void *string) {
  std::string text;
  if (!vertexText(context, format, length, string, text))
    return;
  context.host->ProgramStringARB(GL_VERTEX_PROGRAM_ARB, format, GLsizei(text.size()), text.data());
  if (context.listMode)
    return;
  takeHostError(context);
  GLint name = 0;
  context.host->GetProgramivARB(GL_VERTEX_PROGRAM_ARB, GL_PROGRAM_BINDING_ARB, &name);
  noteVertexProgram(context, GLuint(name), text,
                    context.errorPosition >= 0 ? std::string_view(context.errorString)
                                               : std::string_view());
}

void loadNamedVertexProgram(Context &context, GLuint name, GLenum format, GLsizei length,
                            const void *string) {
  std::string text;
  if (!vertexText(context, format, length, string, text))
    return;
  context.host->NamedProgramStringEXT(name, GL_VERTEX_PROGRAM_ARB, format, GLsizei(text.size()),
                                      text.data());
  if (!context.listMode)
    takeHostError(context);
}

void recordProgramString(Context &context, Command::Kind kind, GLuint object, GLenum format,
                         GLsizei length, const void *string) {
  Command command{.kind = kind, .object = object};
  command.format = format;
  command.count = length;
  // A text over the limit is refused when executed: so much of it suffices for that.
  if (string && length > 0) {
    command.count = std::min<GLsizei>(length, GLsizei(fp::kMaxTextBytes) + 1);
    command.bytes.assign(static_cast<const char *>(string), std::size_t(command.count));
  }
  context.list.record(context, std::move(command));
}

namespace handlers {

void ProgramStringARB(Context &context, GLenum target, GLenum format, GLsizei len,
                      const void *string) {
  if (!outsideBeginEnd(context, "ProgramString between Begin and End"))
    return;
  if (target == GL_VERTEX_PROGRAM_ARB)
    return loadVertexProgram(context, format, len, string);
  if (target != GL_FRAGMENT_PROGRAM_ARB)
    return context.host->ProgramStringARB(target, format, len, string);
  noteProgramApiUse(context);
  if (context.listMode)
    return recordProgramString(context, Command::Kind::ProgramString, 0, format, len, string);
  loadFragmentProgram(context, *context.fragmentProgram, format, len, string);
}

} // namespace handlers
} // namespace arbiter::state
