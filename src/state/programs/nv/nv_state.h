#pragma once
#include <array>
#include <cstdint>
#include <memory>

#include <GL/gl.h>
#include <GL/glext.h>

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

} // namespace arbiter::state
