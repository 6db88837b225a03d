#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>
#include <GL/glext.h>

#include "state/mirror/dirty_bits.h"

namespace arbiter::state {

/// Returns the groups of state (dirty_bits.h) that PopAttrib restores after PushAttrib of `mask`.
/// They follow the attribute groups of OpenGL 2.1, tables 6.5 to 6.27.
[[nodiscard]] constexpr std::uint32_t dirtyGroupsOfAttributes(GLbitfield mask) {
  using namespace dirty;
  struct Row {
    GLbitfield bit;
    std::uint32_t groups;
  };
  constexpr std::uint32_t kEnables = kTextureBindings | kTextureParameters | kViewport | kRaster |
                                     kPixelOps | kTransform | kLighting | kTexGen | kFog | kQueries;
  constexpr std::array<Row, 20> kRows = {{
      // the colour may set a material
      {GL_CURRENT_BIT, kCurrent | kLighting | kRasterPosition},
      {GL_POINT_BIT, kRaster | kTexGen | kTextureParameters},
      {GL_LINE_BIT, kRaster},
      {GL_POLYGON_BIT, kRaster},
      {GL_POLYGON_STIPPLE_BIT, kRaster},
      {GL_PIXEL_MODE_BIT, kPixelStore | kFramebuffer},    // includes READ_BUFFER
      {GL_LIGHTING_BIT, kLighting | kRaster | kPixelOps}, // SHADE_MODEL, CLAMP_VERTEX_COLOR
      {GL_FOG_BIT, kFog | kLighting},                     // COLOR_SUM
      {GL_DEPTH_BUFFER_BIT, kPixelOps},
      {GL_ACCUM_BUFFER_BIT, 0},
      {GL_STENCIL_BUFFER_BIT, kPixelOps},
      {GL_VIEWPORT_BIT, kViewport},
      // DEPTH_CLAMP, CLIP_ORIGIN
      {GL_TRANSFORM_BIT, kTransform | kMatrixMode | kRaster | kViewport},
      {GL_ENABLE_BIT, kEnables},
      {GL_COLOR_BUFFER_BIT, kPixelOps | kFramebuffer | kRaster}, // DRAW_BUFFER, clamps
      {GL_HINT_BIT, kRaster},
      {GL_EVAL_BIT | GL_LIST_BIT, 0},
      {GL_TEXTURE_BIT, kTextureBindings | kTextureParameters | kTexGen},
      {GL_SCISSOR_BIT, kViewport},
      {GL_MULTISAMPLE_BIT, kPixelOps},
  }};
  std::uint32_t groups = kProgramState;
  GLbitfield known = 0;
  for (const Row &row : kRows) {
    known |= row.bit;
    if ((mask & row.bit) != 0)
      groups |= row.groups;
  }
  return (mask & ~known) != 0 ? kAll : groups; // ALL_ATTRIB_BITS has bits that mean nothing
}

} // namespace arbiter::state
