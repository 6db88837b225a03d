#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

class Context;

/// SGIX_shadow is ARB_shadow by other names: TEXTURE_COMPARE_SGIX is TEXTURE_COMPARE_MODE, and its
/// operator TEXTURE_COMPARE_FUNC.
///
/// The words of SGIX_shadow have LEQUAL_R pass where the texel is less than or equal to R. NVIDIA's
/// driver (580.159) passes where R is less than or equal to the texel, as programs that draw
/// shadows by it take for granted, and as ARB_shadow has it for LEQUAL: so does the layer.

[[nodiscard]] constexpr bool isSgixShadow(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_SGIX || pname == GL_TEXTURE_COMPARE_OPERATOR_SGIX;
}
/// Whether the layer has SGIX_shadow here, and `pname` is of it.
[[nodiscard]] bool hasSgixShadow(const Context &context, GLenum pname);

/// ARB_shadow's name of the parameter, and its value of `value`. Not valid: the operator is none of
/// SGIX_shadow's (INVALID_OPERATION, SGIX_shadow, Errors).
struct ShadowParameter {
  GLenum pname = 0;
  GLint value = 0;
  bool valid = true;
};
[[nodiscard]] ShadowParameter arbShadow(GLenum pname, GLint value);
/// The other way: ARB_shadow's name that answers a query of SGIX_shadow's, and its answer in
/// SGIX_shadow's terms. A function that SGIX_shadow has no name for reads as LEQUAL_R.
[[nodiscard]] constexpr GLenum arbShadowName(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_SGIX ? GL_TEXTURE_COMPARE_MODE : GL_TEXTURE_COMPARE_FUNC;
}
[[nodiscard]] GLint sgixShadowValue(GLenum pname, GLint arb);

} // namespace arbiter::state
