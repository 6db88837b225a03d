#pragma once
#include "state/core/capability.h"
#include "state/core/context.h"
#include "state/era/era_state.h"
#include "state/era/sgix_shadow.h"
#include "state/era/texture_range.h"
#include "state/era/vertex_array_range.h"
#include "state/raster_draw/context_state.h"

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

/// Which textures are bound, and what they are, chooses among the programs of texture shaders and
/// of register combiners.
[[nodiscard]] inline bool texturesChoose(const Context &context) {
  return context.textureShaders || context.combiners;
}
[[nodiscard]] inline bool BindTexture(Context &context, GLenum, GLuint) {
  return !texturesChoose(context) && context.listMode == 0;
}

/// Where it is not known to be the matrix that is current already.
inline void noteMatrixMode(Context &context, GLenum mode) {
  using software::dirty::kMatrixMode;
  const bool stays = mode == GL_MODELVIEW && context.listMode == 0 && context.software &&
                     (context.dirty & kMatrixMode) == 0 &&
                     context.software->mirror.clock.currentMatrix() ==
                         software::GenerationCounter::CurrentMatrix::Modelview;
  if (!stays)
    context.dirty |= kMatrixMode;
}

/// The layer has a part in MATRIXi_NV and COLOR, in VERTEX_ATTRIB_ARRAYi_NV and in vertex array
/// ranges.
[[nodiscard]] inline bool MatrixMode(Context &context, GLenum mode) {
  noteMatrixMode(context, mode);
  return mode - GL_MATRIX0_NV >= 8u && mode != GL_COLOR && !context.imagesPixels;
}
[[nodiscard]] inline bool EnableClientState(Context &, GLenum array) {
  return array - GL_VERTEX_ATTRIB_ARRAY0_NV >= 16u && !isVertexArrayRange(array);
}
[[nodiscard]] inline bool DisableClientState(Context &context, GLenum array) {
  return EnableClientState(context, array);
}

/// The layer has NV_vertex_program's evaluator maps, and evaluates where one of them was named.
/// Meshes are draws.
#define ARBITER_MAP(name)                                                                          \
  template <typename... Arguments>                                                                 \
  [[nodiscard]] bool name(Context &, GLenum target, Arguments...) {                                \
    return target - GL_MAP1_VERTEX_ATTRIB0_4_NV >= 32u;                                            \
  }
ARBITER_MAP(Map1d)
ARBITER_MAP(Map1f)
ARBITER_MAP(Map2d)
ARBITER_MAP(Map2f)
ARBITER_MAP(GetMapdv)
ARBITER_MAP(GetMapfv)
ARBITER_MAP(GetMapiv)
#undef ARBITER_MAP
#define ARBITER_EVALUATES(name)                                                                    \
  template <typename... Arguments> [[nodiscard]] bool name(Context &context, Arguments...) {       \
    return !context.mapsNamed;                                                                     \
  }
ARBITER_EVALUATES(EvalCoord1d)
ARBITER_EVALUATES(EvalCoord1f)
ARBITER_EVALUATES(EvalCoord2d)
ARBITER_EVALUATES(EvalCoord2f)
ARBITER_EVALUATES(EvalCoord1dv)
ARBITER_EVALUATES(EvalCoord1fv)
ARBITER_EVALUATES(EvalCoord2dv)
ARBITER_EVALUATES(EvalCoord2fv)
ARBITER_EVALUATES(EvalPoint1)
ARBITER_EVALUATES(EvalPoint2)
#undef ARBITER_EVALUATES
[[nodiscard]] inline bool isHostsMesh(Context &context) {
  if (context.attention != 0 || context.mapsNamed)
    return false;
  ++*context.drawCounter;
  return true;
}
[[nodiscard]] inline bool EvalMesh1(Context &context, GLenum, GLint, GLint) {
  return isHostsMesh(context);
}
[[nodiscard]] inline bool EvalMesh2(Context &context, GLenum, GLint, GLint, GLint, GLint) {
  return isHostsMesh(context);
}

/// Where a draw goes straight to the host a primitive does, vertex by vertex.
[[nodiscard]] inline bool Begin(Context &context, GLenum mode) {
  if (context.attention != 0 || context.softwarePossible || context.mapsNamed ||
      context.listMode != 0)
    return false;
  ++*context.drawCounter;
  if (mode <= GL_POLYGON)
    context.insideBeginEnd = true;
  return true;
}
/// No primitive of the rasterizer's ends, nor one of a list's.
[[nodiscard]] inline bool End(Context &context) {
  if (context.attention != 0 || context.softwarePossible || context.listMode != 0)
    return false;
  context.insideBeginEnd = false;
  return true;
}

/// The element is neither recorded nor of arrays that alias.
[[nodiscard]] inline bool ArrayElement(Context &context, GLint) {
  return !context.softwareListens && !context.attributesAlias;
}

/// Names of APPLE_vertex_array_object's are the layer's.
[[nodiscard]] inline bool BindVertexArray(Context &context, GLuint) {
  return !context.era || !context.era->vertexArrays.any();
}

[[nodiscard]] inline bool GetPointerv(Context &, GLenum pname, void **) {
  return pname != GL_VERTEX_ARRAY_RANGE_POINTER_NV;
}

/// The layer has raised none.
[[nodiscard]] inline bool GetError(Context &context) { return context.pendingError == GL_NO_ERROR; }

/// Of the parameters of textures the layer has a part in the comparison and the ranges, and in all
/// of them where textures choose among programs.
[[nodiscard]] constexpr bool compares(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_MODE || pname == GL_DEPTH_TEXTURE_MODE ||
         isSgixShadow(pname) || isTextureRange(pname);
}
[[nodiscard]] inline bool TexParameteri(Context &context, GLenum, GLenum pname, GLint) {
  return !compares(pname) && !texturesChoose(context);
}
[[nodiscard]] inline bool TexParameterf(Context &context, GLenum, GLenum pname, GLfloat) {
  return !compares(pname) && !texturesChoose(context);
}

} // namespace arbiter::state::straight
