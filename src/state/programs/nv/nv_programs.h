#pragma once
#include <memory>
#include <string_view>

#include <GL/gl.h>

#include "host/parameter_values.h"
#include "state/objects/target.h"

/// Program objects by the commands of NV_vertex_program ("NVP") and NV_fragment_program ("NFP").
/// Objects are addressed by name, and a name becomes a program's when a text is loaded. They are
/// the same objects as BindProgramARB's. These functions execute a command, whether it was called
/// or is replayed from a display list. They require a context with an NvState.
namespace arbiter::state {

struct ProgramContext;
struct ProgramObject;

/// Returns the target of VERTEX_PROGRAM_NV or FRAGMENT_PROGRAM_NV, or null for another name.
[[nodiscard]] ProgramTarget *nvRowOf(ProgramContext &context, GLenum target);
/// Returns the existing object of that name (NVP 6.1.13), or null. Raises no error.
[[nodiscard]] std::shared_ptr<ProgramObject> existingProgram(ProgramContext &context, GLuint id);

/// Executes LoadProgramNV (NVP 2.14.1.7). A text that is not valid leaves the program unchanged.
/// \error INVALID_ENUM for target; INVALID_VALUE if id is 0 or length < 0
/// \error INVALID_OPERATION if id is a program of another target, or the text is not valid
void loadNvProgram(ProgramContext &context, GLenum target, GLuint id, GLsizei length,
                   const void *text);
/// Executes BindProgramNV (NVP 2.14.1.8). A name that was never loaded is bound too, and stays
/// free.
/// \error INVALID_ENUM for target; INVALID_OPERATION if id is a program of another target
void bindNvProgram(ProgramContext &context, GLenum target, GLuint id);

/// Executes ProgramParameters4NV: sets c[index] to c[index + count - 1], or none after an error.
/// \error INVALID_ENUM for target; INVALID_VALUE for index + count, or if count < 0
/// \error INVALID_OPERATION if one of them tracks a matrix (NVP 2.14.5)
void setNvParameters(ProgramContext &context, GLenum target, GLuint index, GLsizei count,
                     const Vec4 *values);

/// Executes ExecuteProgramNV (NVP 2.14.4) with v[0] = `input`, which writes c[].
/// \error INVALID_ENUM for target; INVALID_OPERATION if id is no state program, or if the program
/// writes a parameter that tracks a matrix
void executeStateProgram(ProgramContext &context, GLenum target, GLuint id, const Vec4 &input);

/// Executes ProgramNamedParameter4NV (NFP 3.11.1) for the program `id`, which need not be bound.
/// \error INVALID_OPERATION if id is no fragment program; INVALID_VALUE if the program has no
/// parameter of that name
void setNamedParameter(ProgramContext &context, GLuint id, std::string_view name,
                       host::ParameterValues values);
/// Executes GetProgramNamedParameterNV, with the same errors as setNamedParameter(). Returns false
/// after one.
[[nodiscard]] bool namedParameter(ProgramContext &context, GLuint id, std::string_view name,
                                  Vec4 &value);

} // namespace arbiter::state
