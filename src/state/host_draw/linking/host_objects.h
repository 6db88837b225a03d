#pragma once
#include <string>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/ir/interface.h"
#include "state/objects/program_object.h"
#include "state/objects/target.h"

/// What the host has of a program: a shader of GLSL, a program of GLSL, or a program object of its
/// own ARB path. Each is 0 if the host refuses it, which is logged.
namespace arbiter::state {

class Context;
struct ProgramPair;

[[nodiscard]] inline bool isVertex(const CompiledProgram &compiled) {
  return isOfVertices(compiled.target);
}

/// A shader of `compiled`'s stage with the text `glsl`.
[[nodiscard]] GLuint compileShader(Context &context, const CompiledProgram &compiled,
                                   const std::string &glsl);
/// A program of those of the two shaders that are not 0.
[[nodiscard]] GLuint linkProgram(Context &context, const ProgramPair &pair, GLuint vertex,
                                 GLuint fragment);
/// An object of the host's ARB path that holds the program. Raises no error.
/// \param defined results of a vertex program beside those that it writes (undefined_results.h)
[[nodiscard]] GLuint loadAssembly(Context &context, const CompiledProgram &compiled,
                                  const std::vector<fp::ir::Output> &defined);

} // namespace arbiter::state
