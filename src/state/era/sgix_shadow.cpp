#include "state/era/sgix_shadow.h"

#include "state/core/core_context.h"
#include "state/era/era_state.h"

namespace arbiter::state {

bool hasSgixShadow(const CoreContext &context, GLenum pname) {
  return isSgixShadow(pname) && context.era && context.era->offered.sgixShadow;
}

ShadowParameter arbShadow(GLenum pname, GLint value) {
  if (pname == GL_TEXTURE_COMPARE_SGIX)
    return {GL_TEXTURE_COMPARE_MODE, value != 0 ? GL_COMPARE_R_TO_TEXTURE : GL_NONE};
  switch (value) {
  case GL_TEXTURE_LEQUAL_R_SGIX:
    return {GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL};
  case GL_TEXTURE_GEQUAL_R_SGIX:
    return {GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL};
  default:
    return {GL_TEXTURE_COMPARE_FUNC, 0, false};
  }
}

GLint sgixShadowValue(GLenum pname, GLint arb) {
  if (pname == GL_TEXTURE_COMPARE_SGIX)
    return arb == GL_COMPARE_R_TO_TEXTURE ? GL_TRUE : GL_FALSE;
  return arb == GL_GEQUAL ? GL_TEXTURE_GEQUAL_R_SGIX : GL_TEXTURE_LEQUAL_R_SGIX;
}

} // namespace arbiter::state
