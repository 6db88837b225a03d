// Reads rows of GL's state that no fragment program can show.
#include <epoxy/gl.h>

#include "apps/tools/debug/gl/frame_drawer.h"

namespace arbiter::tools::debug {

namespace {

using fp::ir::StateItem;
using fp::ir::StateRef;
using Vec4 = Drawer::Vec4;

/// Returns a plane of texture coordinate generation, which is state of a texture unit.
Vec4 texGen(const StateRef &state) {
  Vec4 plane = {};
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  glActiveTexture(GL_TEXTURE0 + state.index);
  glGetTexGenfv(GL_S + state.row,
                state.item == StateItem::TexGenEye ? GL_EYE_PLANE : GL_OBJECT_PLANE, plane.data());
  glActiveTexture(GLenum(active));
  return plane;
}

Vec4 clipPlane(unsigned index) {
  GLdouble plane[4] = {};
  glGetClipPlane(GL_CLIP_PLANE0 + index, plane);
  return {float(plane[0]), float(plane[1]), float(plane[2]), float(plane[3])};
}

Vec4 pointSize() {
  constexpr GLenum kNames[] = {GL_POINT_SIZE, GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX,
                               GL_POINT_FADE_THRESHOLD_SIZE};
  Vec4 value = {};
  for (std::size_t i = 0; i < 4; ++i)
    glGetFloatv(kNames[i], &value[i]);
  return value;
}

Vec4 pointAttenuation() {
  Vec4 value = {0, 0, 0, 1};
  glGetFloatv(GL_POINT_DISTANCE_ATTENUATION, value.data());
  return value;
}

} // namespace

Result<Vec4, DebugError> FrameDrawer::vertexState(const StateRef &state) {
  Vec4 value = {};
  if (state.item == StateItem::TexGenEye || state.item == StateItem::TexGenObject)
    value = texGen(state);
  else if (state.item == StateItem::ClipPlane)
    value = clipPlane(state.index);
  else
    value = state.item == StateItem::PointSize ? pointSize() : pointAttenuation();
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return DebugError{"GL error " + std::to_string(code)};
  return value;
}

} // namespace arbiter::tools::debug
