#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/core/errors.h"
#include "state/programs/nv/evaluation.h"
#include "state/programs/program_context.h"

namespace arbiter::state {

/// The matrix that four consecutive program parameters track (NV_vertex_program, "NVP", 2.14.5).
struct TrackedMatrix {
  GLenum matrix = GL_NONE; ///< never TEXTURE, but the TEXTUREi that it meant
  GLenum transform = GL_IDENTITY_NV;
};

/// A context's state of NVIDIA's program API beside the program targets. A context has one if the
/// profile has NVIDIA's languages.
struct NvState {
  /// The number of c[] (NV_vertex_program2 2.14.1.2), which are the vertex target's env parameters.
  static constexpr GLuint kParameters = 256;
  static constexpr GLuint kAttributes = 16; ///< v[0] to v[15]

  /// Indexed by address / 4. ProgramTarget::tracked has a bit for each that is not NONE.
  std::array<TrackedMatrix, kParameters / 4> tracked{};
  std::uint32_t enabledMaps = 0; ///< evaluator maps that are enabled
  /// The maps that were defined; null before the first one.
  std::unique_ptr<std::array<EvaluatorMap, kEvaluatorMaps>> maps;
  std::unique_ptr<Evaluation> evaluation; ///< maps since the last Begin; null if the host evaluates
};

/// Handles a command of NVIDIA's in a context that does not offer it. It is passed to the host if
/// the host draws all programs. Otherwise it is an error, because the profile's card does not have
/// it.
template <typename Result, typename... Parameters, typename... Arguments>
Result absentCommand(ProgramContext &context, Result (*host)(Parameters...),
                     Arguments... arguments) {
  if (!context.offered)
    return host(arguments...);
  raise(context, GL_INVALID_OPERATION, "a command of NV_vertex_program, which is not offered");
  return Result();
}

/// Executes `own` in a context that offers NVIDIA's commands, and absentCommand() in others.
template <typename Context, typename... Parameters, typename... Arguments>
void commandOfNv(Context &context, void (*own)(Context &, Parameters...),
                 void (*host)(Parameters...), Arguments... arguments) {
  if (!context.nv)
    return absentCommand(context, host, arguments...);
  own(context, arguments...);
}

} // namespace arbiter::state
