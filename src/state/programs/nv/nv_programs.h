#pragma once
#include <memory>
#include <string_view>

#include <GL/gl.h>

#include "state/objects/target.h"

/// Program objects as NV_vertex_program ("NVP") and NV_fragment_program ("NFP") have them: by name,
/// and a name is a program's once a text was loaded. They are the objects that BindProgramARB
/// knows. What follows is below the entry points: it runs when a command is executed, be it called
/// or replayed from a display list, in a context that has an NvState.
namespace arbiter::state {

class Context;
struct ProgramObject;

/// The row of VERTEX_PROGRAM_NV or FRAGMENT_PROGRAM_NV; null where the target is none of them.
[[nodiscard]] ProgramTarget *nvRowOf(Context &context, GLenum target);
/// The existing object of that name (NVP 6.1.13); null where there is none. Raises nothing.
[[nodiscard]] std::shared_ptr<ProgramObject> existingProgram(Context &context, GLuint id);

/// LoadProgramNV (NVP 2.14.1.7): a text that is not valid leaves the program as it was.
/// \error INVALID_ENUM target; INVALID_VALUE id 0 or length < 0
/// \error INVALID_OPERATION the id is a program's of another target, or the text is not valid
void loadNvProgram(Context &context, GLenum target, GLuint id, GLsizei length, const void *text);
/// BindProgramNV (NVP 2.14.1.8): a name that was never loaded is bound too, and stays free.
/// \error INVALID_ENUM target; INVALID_OPERATION the id is a program's of another target
void bindNvProgram(Context &context, GLenum target, GLuint id);

/// ProgramParameters4NV: c[index] to c[index + count - 1]; all of them, or after an error none.
/// \error INVALID_ENUM target; INVALID_VALUE index + count or count < 0
/// \error INVALID_OPERATION one of them follows a matrix (NVP 2.14.5)
void setNvParameters(Context &context, GLenum target, GLuint index, GLsizei count,
                     const Vec4 *values);

/// ExecuteProgramNV (NVP 2.14.4) with v[0] = `input`: writes c[].
/// \error INVALID_ENUM target; INVALID_OPERATION the id is no state program's, or the program
///        writes a parameter that follows a matrix
void executeStateProgram(Context &context, GLenum target, GLuint id, const Vec4 &input);

/// ProgramNamedParameter4NV (NFP 3.11.1): of the program `id`, whether it is bound or not.
/// \error INVALID_OPERATION the id is no fragment program's; INVALID_VALUE the program has no
///        parameter of that name
void setNamedParameter(Context &context, GLuint id, std::string_view name, const Vec4 &value);
/// GetProgramNamedParameterNV, with the same errors. False after one.
[[nodiscard]] bool namedParameter(Context &context, GLuint id, std::string_view name, Vec4 &value);

} // namespace arbiter::state
