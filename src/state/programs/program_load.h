#pragma once
#include <memory>
#include <string_view>

#include <GL/gl.h>

#include "fp_compiler/compilation.h"
#include "state/core/context.h"
#include "state/objects/display_list.h"

/// A program's text, or a shader's commands, on their way into a program object.
namespace arbiter::state {

struct Replacement;

/// What the compiler is told for programs of the target.
[[nodiscard]] fp::CompileOptions compileOptions(const ProgramTarget &row);
/// The text through the compiler, or from the program cache.
[[nodiscard]] fp::Compilation compileText(const Context &context, const ProgramTarget &row,
                                          std::string_view text);
/// What an object holds after a load of `text`: the GLSL of a valid replacement or else of the text
/// itself, with the answers that the application expects.
/// \param own of the text; \param replacement null where there is none
/// \returns null where neither is valid.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
compileProgram(const Context &context, Target target, std::string_view text,
               const fp::Compilation &own, const Replacement *replacement);
/// A text into `object`, in the language of its target or one of NVIDIA's for it, which the header
/// tells. False after INVALID_OPERATION: it is not valid, and the object is as it was.
bool loadText(Context &context, ProgramObject &object, std::string_view text);
/// ProgramString (3.11.1) into `object`.
void loadProgram(Context &context, ProgramObject &object, GLenum format, GLsizei length,
                 const void *string);
/// Records ProgramString, or the named one if `object` is not zero, in the list being compiled.
void recordProgramString(Context &context, Command::Kind kind, const ProgramTarget &row,
                         GLuint object, GLenum format, GLsizei length, const void *string);
/// What the commands of ATI_fragment_shader said, or what stands in for it. Where programs are
/// captured, replaced or controlled a shader has a text of ATI_text_fragment_shader and is known by
/// that, as programs are by theirs; unless that language has no words for it. The context's
/// constants are program.env[0] to [7] there.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
compileFragmentShader(const Context &context, const fp::ati::Shader &shader);
/// EndFragmentShaderATI has defined it: the capture's record, and clients of control, hear of it,
/// if it has a text.
void noteShaderText(const Context &context, const CompiledProgram &compiled);
/// What emitted GLSL may use of the host.
[[nodiscard]] fp::GlslHost glslHost(const HostCaps &caps);

} // namespace arbiter::state
