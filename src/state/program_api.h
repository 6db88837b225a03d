#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

#include "state/context.h"

/// The program API below the entry points: what runs when a command is executed, be it called or
/// replayed from a display list. Arguments that list compilation does not check are checked here.
namespace arbiter::state {

/// True where a command of ours may run. Inside Begin/End it raises INVALID_OPERATION (2.6.3).
[[nodiscard]] bool outsideBeginEnd(Context &context, const char *command);
/// Marks that the share group uses the fragment target: lists are cut from now on.
void noteProgramApiUse(Context &context);
/// Makes the next draw look at what is in force.
void invalidateProgram(Context &context);

/// ProgramString (3.11.1) into the bound object of the fragment target.
void loadFragmentProgram(Context &context, ProgramObject &object, GLenum format, GLsizei length,
                         const void *string);
/// ProgramString of the vertex target, for the bound object or the one of that name: length and
/// shape are checked, then the host parses.
void loadVertexProgram(Context &context, GLenum format, GLsizei length, const void *string);
void loadNamedVertexProgram(Context &context, GLuint name, GLenum format, GLsizei length,
                            const void *string);
/// Records ProgramString, or the named one if `object` is not zero, in the list being compiled.
void recordProgramString(Context &context, Command::Kind kind, GLuint object, GLenum format,
                         GLsizei length, const void *string);
/// The object of that name of the fragment target, made at first use as BindProgram would
/// (EXT_direct_state_access); null after an error.
[[nodiscard]] std::shared_ptr<ProgramObject> namedFragmentProgram(Context &context, GLuint name);
/// BindProgram of the fragment target.
void bindFragmentProgram(Context &context, GLuint name);
/// `count` env parameters of the fragment target from `index` on.
void setEnv(Context &context, GLuint index, GLsizei count, const Vec4 *values);
/// The same for the local parameters of `object`.
void setLocal(Context &context, ProgramObject &object, GLuint index, GLsizei count,
              const Vec4 *values);
void setFragmentEnable(Context &context, bool enabled);
void useProgram(Context &context, GLuint name);
void pushAttrib(Context &context, GLbitfield mask);
void popAttrib(Context &context);

/// GetProgramiv on an object of the fragment target. False: pname is not known.
[[nodiscard]] bool queryProgram(Context &context, const ProgramObject &object, GLenum pname,
                                GLint *params);

} // namespace arbiter::state
