#include "state/core/depth_images.h"

#include <GL/glext.h>

#include "state/core/core_context.h"
#include "state/share/share_group.h"

namespace arbiter::state {

namespace {

bool hasDepths(GLenum internalFormat) {
  switch (internalFormat) {
  case GL_DEPTH_COMPONENT:
  case GL_DEPTH_COMPONENT16:
  case GL_DEPTH_COMPONENT24:
  case GL_DEPTH_COMPONENT32:
  case GL_DEPTH_COMPONENT32F:
  case GL_DEPTH_COMPONENT32F_NV:
  case GL_DEPTH_STENCIL:
  case GL_DEPTH24_STENCIL8:
  case GL_DEPTH32F_STENCIL8:
  case GL_DEPTH32F_STENCIL8_NV:
    return true;
  default:
    return false;
  }
}

} // namespace

void noteInternalFormat(CoreContext &context, GLenum internalFormat) {
  if (hasDepths(internalFormat) &&
      !context.group->depthImagesUsed.exchange(true, std::memory_order_relaxed))
    context.attention |= attention::kProgram;
}

} // namespace arbiter::state
