// The vertex target where it is the host's: names in the common name space, and a look at size and
// shape of the text before the host's parser sees it.
#include <algorithm>

#include "host/host_table.h"
#include "state/errors.h"
#include "state/program_api.h"
#include "state/share_group.h"
#include "state/statistics.h"

namespace arbiter::state {

namespace {

/// What a vertex program may hold before the host's parser sees it. Far above any real program and
/// any limit of a host, far below what is known to crash or to stall one.
constexpr std::size_t kMaxVertexStatements = 32768;
constexpr std::size_t kMaxListElements = 4000;

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

/// The text for the host's parser, ended by NUL whatever it reads past the length; false after an
/// error.
bool vertexText(Context &context, GLenum format, GLsizei length, const void *string,
                std::string &text) {
  if (!checkProgramString(context, format, length))
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

void vertexStringOfHost(Context &context, GLenum format, GLsizei length, const void *string) {
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

void namedVertexStringOfHost(Context &context, GLuint name, GLenum format, GLsizei length,
                             const void *string) {
  if (!outsideBeginEnd(context, "NamedProgramString between Begin and End"))
    return;
  // In a list the host makes the object when it executes it.
  const auto object = context.listMode ? context.group->find(name)
                                       : context.group->findOrCreate(name, Target::Vertex, 0);
  if (object && object->target != Target::Vertex)
    return raise(context, GL_INVALID_OPERATION, "NamedProgramString: another target's object");
  std::string text;
  if (!vertexText(context, format, length, string, text))
    return;
  context.host->NamedProgramStringEXT(name, GL_VERTEX_PROGRAM_ARB, format, GLsizei(text.size()),
                                      text.data());
  if (!context.listMode)
    takeHostError(context);
}

/// A vertex program takes its name in the common name space when it is first bound.
void bindVertexProgramOfHost(Context &context, GLuint name) {
  if (name != 0) {
    const auto object = context.group->findOrCreate(name, Target::Vertex, 0);
    if (object->target != Target::Vertex)
      return raise(context, GL_INVALID_OPERATION, "BindProgram: the object has another target");
  }
  context.host->BindProgramARB(GL_VERTEX_PROGRAM_ARB, name);
}

} // namespace arbiter::state
