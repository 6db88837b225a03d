#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/compilation.h"
#include "state/core/context.h"
#include "state/lists/display_list.h"

/// The program API below the entry points: what runs when a command is executed, be it called or
/// replayed from a display list. Arguments that list compilation does not check are checked here.
namespace arbiter::state {

struct Replacement;

/// True where a command of ours may run. Inside Begin/End it raises INVALID_OPERATION (2.6.3).
[[nodiscard]] bool outsideBeginEnd(Context &context, const char *command);
/// Marks that the share group uses a program target: display lists are divided into segments from
/// now on.
void noteProgramApiUse(Context &context);
/// Makes the next draw look at what is effective.
void invalidateProgram(Context &context);

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
/// ProgramString (3.11.1) into `object`, in the language of its target.
void loadProgram(Context &context, ProgramObject &object, GLenum format, GLsizei length,
                 const void *string);
/// Records ProgramString, or the named one if `object` is not zero, in the list being compiled.
void recordProgramString(Context &context, Command::Kind kind, const ProgramTarget &row,
                         GLuint object, GLenum format, GLsizei length, const void *string);
/// The object of that name and target, made at first use as BindProgram would
/// (EXT_direct_state_access); null after an error.
[[nodiscard]] std::shared_ptr<ProgramObject> namedProgram(Context &context,
                                                          const ProgramTarget &row, GLuint name);
void bindProgram(Context &context, ProgramTarget &row, GLuint name);
/// `count` env parameters of the target from `index` on.
void setEnv(Context &context, ProgramTarget &row, GLuint index, GLsizei count, const Vec4 *values);
/// The same for the local parameters of `object`.
void setLocal(Context &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values);
void setEnabled(Context &context, ProgramTarget &row, bool enabled);
/// BindFragmentShaderATI.
void bindFragmentShader(Context &context, GLuint name);
/// SetFragmentShaderConstantATI: the shader's own constant between Begin- and
/// EndFragmentShaderATI, else the context's. `constant` is 0 to 7.
void setFragmentShaderConstant(Context &context, int constant, const Vec4 &value);
/// Deletes this context's linked programs of a program that left its object.
void dropVariants(Context &context, const CompiledProgram &compiled);
/// What emitted GLSL may use of the host.
[[nodiscard]] fp::GlslHost glslHost(const HostCaps &caps);
void useProgram(Context &context, GLuint name);
void pushAttrib(Context &context, GLbitfield mask);
/// The attribute stack's entry of ours, after the host's.
void pushEnables(Context &context, GLbitfield mask);
void popAttrib(Context &context);
/// A recorded CopyTex(Sub)Image.
void copyTexture(Context &context, const Command &command);

/// GetProgramiv on an object of the target. False: pname is not known.
[[nodiscard]] bool queryProgram(Context &context, const ProgramTarget &row,
                                const ProgramObject &object, GLenum pname, GLint *params);

} // namespace arbiter::state
