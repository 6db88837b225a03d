#pragma once
#include <memory>
#include <string_view>

#include <GL/gl.h>

#include "fp_compiler/compilation.h"
#include "state/objects/display_list.h"
#include "state/programs/program_context.h"

/// Loads a program's text, or a shader's commands, into a program object.
namespace arbiter::state {

struct Replacement;

/// Returns the compiler's options for programs of the target.
[[nodiscard]] fp::CompileOptions compileOptions(const ProgramTarget &row);
/// Compiles the text, or reads the result from the program cache.
[[nodiscard]] fp::Compilation compileText(const ProgramContext &context, const ProgramTarget &row,
                                          std::string_view text);
/// Returns what an object holds after a load of `text`. It has the GLSL of a valid replacement, or
/// else of the text itself, with the answers that the application expects.
/// \param own the result for the text
/// \param replacement null if there is none
/// \returns null if neither is valid
[[nodiscard]] std::shared_ptr<const CompiledProgram>
compileProgram(const ProgramContext &context, Target target, std::string_view text,
               const fp::Compilation &own, const Replacement *replacement);
/// Loads a text into `object`. Its header tells the language: that of the target, or one of
/// NVIDIA's for it. Returns false after INVALID_OPERATION, if the text is not valid; the object is
/// unchanged then.
bool loadText(ProgramContext &context, ProgramObject &object, std::string_view text);
/// Executes ProgramString (3.11.1) for `object`.
void loadProgram(ProgramContext &context, ProgramObject &object, GLenum format, GLsizei length,
                 const void *string);
/// Records ProgramString, or NamedProgramString if `object` is not zero, in the list being
/// compiled.
void recordProgramString(ProgramContext &context, Command::Kind kind, const ProgramTarget &row,
                         GLuint object, GLenum format, GLsizei length, const void *string);
/// Compiles a shader made by the commands of ATI_fragment_shader, or its replacement. While
/// programs are captured, replaced or controlled, the shader also has a text of
/// ATI_text_fragment_shader, which identifies it as texts identify programs, unless that language
/// cannot express it. The context's constants are program.env[0] to [7] in the text.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
compileFragmentShader(const ProgramContext &context, const fp::ati::Shader &shader);
/// Reports a shader defined by EndFragmentShaderATI to the capture and to clients of control, if it
/// has a text.
void noteShaderText(const ProgramContext &context, const CompiledProgram &compiled);
/// Returns the host's features that emitted GLSL may use.
[[nodiscard]] fp::GlslHost glslHost(const HostCaps &caps);

} // namespace arbiter::state
