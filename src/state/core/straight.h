#pragma once
#include "state/core/capability.h"
#include "state/core/context.h"

/// The commands that are called most of those that the layer has a part in, and mostly are the
/// host's alone. Each function is asked by the entry point of its name, in line and with the
/// command's arguments, in a context that is not passed through. True: the command is the host's
/// alone, and all that the layer notes of it is noted. False: nothing is done that the handler of
/// the same name does not do as well, which is called next.
namespace arbiter::state::straight {

[[nodiscard]] inline bool isHosts(Context &context, GLenum cap) {
  const CapabilityRow &row = rowOfCapability(cap);
  if (row.capability != Capability::Host)
    return false;
  noteDirty(context, row);
  return true;
}
[[nodiscard]] inline bool Enable(Context &context, GLenum cap) { return isHosts(context, cap); }
[[nodiscard]] inline bool Disable(Context &context, GLenum cap) { return isHosts(context, cap); }

/// The layer has a part in MATRIXi_NV, and in VERTEX_ATTRIB_ARRAYi_NV.
[[nodiscard]] inline bool MatrixMode(Context &, GLenum mode) { return mode - GL_MATRIX0_NV >= 8u; }
[[nodiscard]] inline bool EnableClientState(Context &, GLenum array) {
  return array - GL_VERTEX_ATTRIB_ARRAY0_NV >= 16u;
}
[[nodiscard]] inline bool DisableClientState(Context &context, GLenum array) {
  return EnableClientState(context, array);
}

/// The layer has raised none.
[[nodiscard]] inline bool GetError(Context &context) { return context.pendingError == GL_NO_ERROR; }

/// Of the parameters of textures the layer has a part in the comparison alone.
[[nodiscard]] inline bool TexParameteri(Context &, GLenum, GLenum pname, GLint) {
  return pname != GL_TEXTURE_COMPARE_MODE;
}
[[nodiscard]] inline bool TexParameterf(Context &, GLenum, GLenum pname, GLfloat) {
  return pname != GL_TEXTURE_COMPARE_MODE;
}

} // namespace arbiter::state::straight
