#pragma once
#include <string>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/ir/interface.h"
#include "state/objects/program_object.h"
#include "state/objects/target.h"

/// Creates the host's objects for a program: a GLSL shader, a GLSL program, or an ARB program
/// object. Functions return 0 and log it if the host refuses.
namespace arbiter::state {

struct DrawContext;
struct ProgramPair;

[[nodiscard]] inline bool isVertex(const CompiledProgram &compiled) {
  return isOfVertices(compiled.target);
}

/// Compiles a shader of the stage of `compiled` from the text `glsl`.
[[nodiscard]] GLuint compileShader(DrawContext &context, const CompiledProgram &compiled,
                                   const std::string &glsl);
/// Links a program from those of the two shaders that are not 0.
[[nodiscard]] GLuint linkProgram(DrawContext &context, const ProgramPair &pair, GLuint vertex,
                                 GLuint fragment);
/// Loads the program into an object of the host's ARB path. Raises no error.
/// \param defined additional results that a vertex program must write (undefined_results.h)
[[nodiscard]] GLuint loadAssembly(DrawContext &context, const CompiledProgram &compiled,
                                  const std::vector<fp::ir::Output> &defined);

} // namespace arbiter::state
