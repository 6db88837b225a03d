#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/core/context.h"
#include "state/core/errors.h"
#include "state/programs/nv/evaluation.h"

namespace arbiter::state {

/// What four program parameters in a row follow (NV_vertex_program, "NVP", 2.14.5).
struct TrackedMatrix {
  GLenum matrix = GL_NONE; ///< never TEXTURE: it is TEXTUREi from the beginning
  GLenum transform = GL_IDENTITY_NV;
};

/// What a context keeps of NVIDIA's program API beside the rows of the program targets. A context
/// has one where the profile has NVIDIA's languages.
struct NvState {
  /// c[0] to c[255] (NV_vertex_program2 2.14.1.2), which are the vertex target's env parameters.
  static constexpr GLuint kParameters = 256;
  static constexpr GLuint kAttributes = 16; ///< v[0] to v[15]

  /// By address / 4. ProgramTarget::tracked has a bit for each that is not NONE.
  std::array<TrackedMatrix, kParameters / 4> tracked{};
  std::uint32_t enabledMaps = 0; ///< of evaluators
  /// Those that were defined; null before the first one.
  std::unique_ptr<std::array<EvaluatorMap, kEvaluatorMaps>> maps;
  std::unique_ptr<Evaluation> evaluation; ///< of the last Begin; null where the host evaluates
};

/// A command of NVIDIA's in a context that does not have them: the host's where it draws all
/// programs; else the profile's card does not know it.
template <typename Result, typename... Parameters, typename... Arguments>
Result absentCommand(Context &context, Result (*host)(Parameters...), Arguments... arguments) {
  if (!context.offered)
    return host(arguments...);
  raise(context, GL_INVALID_OPERATION, "a command of NV_vertex_program, which is not offered");
  return Result();
}

} // namespace arbiter::state
