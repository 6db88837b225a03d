#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

struct CoreContext;

/// SGIX_shadow is ARB_shadow by other names: TEXTURE_COMPARE_SGIX is TEXTURE_COMPARE_MODE, and its
/// operator is TEXTURE_COMPARE_FUNC.
///
/// The text of SGIX_shadow lets LEQUAL_R pass if the texel is less than or equal to R. NVIDIA's
/// driver (580.159) passes if R is less than or equal to the texel. Programs that draw shadows with
/// it expect that, and ARB_shadow's LEQUAL does the same. So does the layer.
/// shadows by it take for granted, and as ARB_shadow has it for LEQUAL: so does the layer.

[[nodiscard]] constexpr bool isSgixShadow(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_SGIX || pname == GL_TEXTURE_COMPARE_OPERATOR_SGIX;
}
/// True if the layer has SGIX_shadow here and `pname` belongs to it.
[[nodiscard]] bool hasSgixShadow(const CoreContext &context, GLenum pname);

/// ARB_shadow's parameter and value for one of SGIX_shadow. It is not valid if the operator is none
/// of SGIX_shadow's (INVALID_OPERATION, SGIX_shadow, Errors).
struct ShadowParameter {
  GLenum pname = 0;
  GLint value = 0;
  bool valid = true;
};
[[nodiscard]] ShadowParameter arbShadow(GLenum pname, GLint value);
/// Returns ARB_shadow's parameter for a query of SGIX_shadow's. sgixShadowValue() translates its
/// answer; a function without a name in SGIX_shadow reads as LEQUAL_R.
[[nodiscard]] constexpr GLenum arbShadowName(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_SGIX ? GL_TEXTURE_COMPARE_MODE : GL_TEXTURE_COMPARE_FUNC;
}
[[nodiscard]] GLint sgixShadowValue(GLenum pname, GLint arb);

} // namespace arbiter::state
