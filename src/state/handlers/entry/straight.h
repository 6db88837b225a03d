#pragma once
#include "state/core/capability.h"
#include "state/era/era_state.h"
#include "state/era/sgix_shadow.h"
#include "state/era/texture_range.h"
#include "state/era/vertex_array_range.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"

/// Fast paths of frequent commands that mostly are the host's alone. An entry point calls the
/// function of its name inline, unless its context is passed through. If it returns true, the
/// command goes to the host, and the layer has noted all it must. If it returns false, it has done
/// nothing, and the handler of that name is called next.
namespace arbiter::state::straight {

[[nodiscard]] inline bool isHosts(RasterContext &context, GLenum cap) {
  const CapabilityRow &row = rowOfCapability(cap);
  if (row.capability != Capability::Host)
    return false;
  noteDirty(context, row);
  return true;
}
[[nodiscard]] inline bool Enable(RasterContext &context, GLenum cap) {
  return isHosts(context, cap);
}
[[nodiscard]] inline bool Disable(RasterContext &context, GLenum cap) {
  return isHosts(context, cap);
}

/// True if the bound textures choose among the programs of texture shaders and register combiners.
[[nodiscard]] inline bool texturesChoose(const RasterContext &context) {
  return context.textureShaders || context.combiners;
}
[[nodiscard]] inline bool BindTexture(RasterContext &context, GLenum, GLuint) {
  return !texturesChoose(context) && context.listMode == 0;
}

/// Marks the matrix mode dirty, unless it is known to stay the modelview matrix.
inline void noteMatrixMode(RasterContext &context, GLenum mode) {
  using dirty::kMatrixMode;
  const bool stays =
      mode == GL_MODELVIEW && context.listMode == 0 && context.software &&
      (context.dirty & kMatrixMode) == 0 &&
      context.software->mirror.clock.currentMatrix() == GenerationCounter::CurrentMatrix::Modelview;
  if (!stays)
    context.dirty |= kMatrixMode;
}

/// True if the mode or array is the host's alone. The layer handles MATRIXi_NV and COLOR,
/// VERTEX_ATTRIB_ARRAYi_NV and vertex array ranges.
[[nodiscard]] inline bool MatrixMode(RasterContext &context, GLenum mode) {
  noteMatrixMode(context, mode);
  return mode - GL_MATRIX0_NV >= 8u && mode != GL_COLOR && !context.imagesPixels;
}
[[nodiscard]] inline bool EnableClientState(RasterContext &, GLenum array) {
  return array - GL_VERTEX_ATTRIB_ARRAY0_NV >= 16u && !isVertexArrayRange(array);
}
[[nodiscard]] inline bool DisableClientState(RasterContext &context, GLenum array) {
  return EnableClientState(context, array);
}

/// True if the command uses none of NV_vertex_program's evaluator maps, which are the layer's. Once
/// one of these was named, the layer evaluates too. Meshes are draws.
#define ARBITER_MAP(name)                                                                          \
  template <typename... Arguments>                                                                 \
  [[nodiscard]] bool name(RasterContext &context, GLenum target, Arguments...) {                   \
    return target - GL_MAP1_VERTEX_ATTRIB0_4_NV >= 32u || !context.nv;                             \
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
  template <typename... Arguments> [[nodiscard]] bool name(RasterContext &context, Arguments...) { \
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
[[nodiscard]] inline bool isHostsMesh(RasterContext &context) {
  if (context.attention != 0 || context.mapsNamed)
    return false;
  ++*context.drawCounter;
  return true;
}
[[nodiscard]] inline bool EvalMesh1(RasterContext &context, GLenum, GLint, GLint) {
  return isHostsMesh(context);
}
[[nodiscard]] inline bool EvalMesh2(RasterContext &context, GLenum, GLint, GLint, GLint, GLint) {
  return isHostsMesh(context);
}

/// True if the primitive goes to the host vertex by vertex, as a draw would go there directly.
[[nodiscard]] inline bool Begin(RasterContext &context, GLenum mode) {
  if (context.attention != 0 || context.softwarePossible || context.mapsNamed ||
      context.listMode != 0)
    return false;
  ++*context.drawCounter;
  if (mode <= GL_POLYGON)
    context.insideBeginEnd = true;
  return true;
}
/// True if the End closes a primitive of neither the rasterizer nor a list.
[[nodiscard]] inline bool End(RasterContext &context) {
  if (context.attention != 0 || context.softwarePossible || context.listMode != 0)
    return false;
  context.insideBeginEnd = false;
  return true;
}

/// True if the element is not recorded and no array aliases another.
[[nodiscard]] inline bool ArrayElement(RasterContext &context, GLint) {
  return !context.softwareListens && !context.attributesAlias;
}

/// Names made by APPLE_vertex_array_object are the layer's.
[[nodiscard]] inline bool BindVertexArray(RasterContext &context, GLuint) {
  return !context.era || !context.era->vertexArrays.any();
}

[[nodiscard]] inline bool GetPointerv(RasterContext &, GLenum pname, void **) {
  return pname != GL_VERTEX_ARRAY_RANGE_POINTER_NV;
}

/// True if the layer has raised no error.
[[nodiscard]] inline bool GetError(RasterContext &context) {
  return context.errors.pending == GL_NO_ERROR;
}

/// True for texture parameters that the layer handles: comparison and ranges. It handles all of
/// them if textures choose among programs.
[[nodiscard]] constexpr bool compares(GLenum pname) {
  return pname == GL_TEXTURE_COMPARE_MODE || pname == GL_DEPTH_TEXTURE_MODE ||
         isSgixShadow(pname) || isTextureRange(pname);
}
[[nodiscard]] inline bool TexParameteri(RasterContext &context, GLenum, GLenum pname, GLint) {
  return !compares(pname) && !texturesChoose(context);
}
[[nodiscard]] inline bool TexParameterf(RasterContext &context, GLenum, GLenum pname, GLfloat) {
  return !compares(pname) && !texturesChoose(context);
}

} // namespace arbiter::state::straight
