#pragma once
#include <cstdint>

#include <GL/gl.h>

#include "state/target.h"

namespace arbiter::state {

/// Whom Enable and Disable of a capability concern.
enum class Capability : std::uint8_t {
  Host,          ///< the host alone
  ProgramTarget, ///< the layer, where the target is offered
  ChoosesForm,   ///< the host, and which form an ATI shader is drawn in (fixed_function.h)
  ClipPlane,     ///< the host, and which form a vertex program is drawn in (clip_planes.h)
};

/// One look at `cap` on the way of each Enable and Disable, most of which are the host's alone.
[[nodiscard]] constexpr Capability capabilityOf(GLenum cap) {
  switch (cap) {
  case infoOf(Target::Fragment).name:
  case infoOf(Target::Vertex).name:
  case infoOf(Target::AtiText).name:
  case infoOf(Target::AtiApi).name:
    return Capability::ProgramTarget;
  case GL_FOG:
  case GL_LIGHTING:
  case GL_COLOR_SUM:
  case GL_TEXTURE_1D:
  case GL_TEXTURE_2D:
  case GL_TEXTURE_3D:
  case GL_TEXTURE_CUBE_MAP:
  case GL_TEXTURE_RECTANGLE:
    return Capability::ChoosesForm;
  case GL_CLIP_PLANE0: // CLIP_DISTANCEi has the same values
  case GL_CLIP_PLANE1:
  case GL_CLIP_PLANE2:
  case GL_CLIP_PLANE3:
  case GL_CLIP_PLANE4:
  case GL_CLIP_PLANE5:
  case GL_CLIP_DISTANCE6:
  case GL_CLIP_DISTANCE7:
    return Capability::ClipPlane;
  default:
    return Capability::Host;
  }
}

} // namespace arbiter::state
