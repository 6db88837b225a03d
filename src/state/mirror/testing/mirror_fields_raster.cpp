#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/mirror/testing/mirror_fields.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

namespace arbiter::state::testing {
namespace {

swrast::PolygonMode modeOf(GLenum mode) {
  return mode == GL_POINT  ? swrast::PolygonMode::Point
         : mode == GL_LINE ? swrast::PolygonMode::Line
                           : swrast::PolygonMode::Fill;
}

constexpr Field kRaster[] = {
    {"viewport", dirty::kViewport,
     [](Numbers &n) -> Check {
       const int box[4] = {n.below(9) - 4, n.below(9), n.below(64), n.below(64)};
       glViewport(box[0], box[1], box[2], box[3]);
       return [=](const Mirror &m) {
         for (int i = 0; i < 4; ++i)
           EXPECT_EQ(m.raster.viewport[i], float(box[i]));
       };
     }},
    {"depth range", dirty::kViewport,
     [](Numbers &n) -> Check {
       const float near = n.real(0, 1), far = n.real(0, 1);
       glDepthRange(near, far);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.depthNear, near);
         EXPECT_EQ(m.raster.depthFar, far);
         EXPECT_EQ(m.constants.depthMinimum, m.raster.depthClamp ? std::min(near, far) : 0.0f);
         EXPECT_EQ(m.constants.depthMaximum, m.raster.depthClamp ? std::max(near, far) : 1.0f);
       };
     }},
    {"scissor", dirty::kViewport,
     [](Numbers &n) -> Check {
       const swrast::Rect box = {n.below(9) - 4, n.below(9), n.below(64), n.below(64)};
       const bool on = n.chance(60);
       turn(GL_SCISSOR_TEST, on);
       glScissor(box.x, box.y, box.width, box.height);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.scissorEnabled, on);
         if (on) {
           EXPECT_EQ(m.scissor, box);
         } else
           EXPECT_GE(m.scissor.width, 16384);
       };
     }},
    {"culling", dirty::kRaster,
     [](Numbers &n) -> Check {
       constexpr GLenum kFaces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
       const bool on = n.chance(60), clockwise = n.chance(50);
       const GLenum face = n.of(kFaces);
       turn(GL_CULL_FACE, on);
       glCullFace(face);
       glFrontFace(clockwise ? GL_CW : GL_CCW);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.cullFront, on && face != GL_BACK);
         EXPECT_EQ(m.raster.cullBack, on && face != GL_FRONT);
         EXPECT_EQ(m.raster.frontIsClockwise, clockwise);
       };
     }},
    {"shading", dirty::kRaster,
     [](Numbers &n) -> Check {
       const bool flat = n.chance(50), first = n.chance(50), clamp = n.chance(50);
       glShadeModel(flat ? GL_FLAT : GL_SMOOTH);
       glProvokingVertex(first ? GL_FIRST_VERTEX_CONVENTION : GL_LAST_VERTEX_CONVENTION);
       turn(GL_DEPTH_CLAMP, clamp);
       GLint follows = 1;
       glGetIntegerv(GL_QUADS_FOLLOW_PROVOKING_VERTEX_CONVENTION, &follows);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.flatShade, flat);
         EXPECT_EQ(m.raster.provokingIsFirst, first);
         EXPECT_EQ(m.raster.quadsProvokingIsFirst, first && follows != GL_FALSE);
         EXPECT_EQ(m.raster.depthClamp, clamp);
       };
     }},
    {"polygon modes", dirty::kRaster,
     [](Numbers &n) -> Check {
       constexpr GLenum kModes[] = {GL_POINT, GL_LINE, GL_FILL};
       const GLenum front = n.of(kModes), back = n.of(kModes);
       glPolygonMode(GL_FRONT, front);
       glPolygonMode(GL_BACK, back);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.front, modeOf(front));
         EXPECT_EQ(m.raster.back, modeOf(back));
       };
     }},
    {"polygon offset", dirty::kRaster,
     [](Numbers &n) -> Check {
       const int on = n.below(8);
       const float factor = n.real(-4, 4), units = n.real(-4, 4);
       turn(GL_POLYGON_OFFSET_FILL, (on & 1) != 0);
       turn(GL_POLYGON_OFFSET_LINE, (on & 2) != 0);
       turn(GL_POLYGON_OFFSET_POINT, (on & 4) != 0);
       glPolygonOffset(factor, units);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.offsetFill, (on & 1) != 0);
         EXPECT_EQ(m.raster.offsetLine, (on & 2) != 0);
         EXPECT_EQ(m.raster.offsetPoint, (on & 4) != 0);
         EXPECT_EQ(m.raster.offsetFactor, factor);
         EXPECT_EQ(m.raster.offsetUnits, units);
       };
     }},
    {"polygon stipple", dirty::kRaster,
     [](Numbers &n) -> Check {
       const bool on = n.chance(70);
       std::vector<GLubyte> rows(128);
       for (GLubyte &byte : rows)
         byte = GLubyte(n.below(256));
       turn(GL_POLYGON_STIPPLE, on);
       glPolygonStipple(rows.data());
       // The pack state must not affect the query.
       glPixelStorei(GL_PACK_LSB_FIRST, n.below(2));
       glPixelStorei(GL_PACK_ROW_LENGTH, 64 * n.below(2));
       glPixelStorei(GL_PACK_SKIP_PIXELS, n.below(2));
       return [=](const Mirror &m) {
         ASSERT_EQ(m.raster.polygonStipple != nullptr, on);
         if (on) {
           EXPECT_EQ(std::memcmp(m.raster.polygonStipple, rows.data(), 128), 0);
         }
       };
     }},
    {"lines", dirty::kRaster,
     [](Numbers &n) -> Check {
       const float width = n.real(0.5f, 5);
       const bool smooth = n.chance(30), stipple = n.chance(50);
       const int factor = 1 + n.below(9), pattern = n.below(65536);
       glLineWidth(width);
       turn(GL_LINE_SMOOTH, smooth);
       turn(GL_LINE_STIPPLE, stipple);
       glLineStipple(factor, GLushort(pattern));
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.lineWidth, width);
         EXPECT_EQ(m.smoothLines, smooth);
         EXPECT_EQ(m.raster.lineStippleFactor, stipple ? factor : 0);
         if (stipple) {
           EXPECT_EQ(m.raster.lineStipple, pattern);
         }
       };
     }},
    {"points", dirty::kRaster,
     [](Numbers &n) -> Check {
       const float size = n.real(0.5f, 20), low = n.real(0, 3), high = n.real(4, 30);
       const bool smooth = n.chance(30), byProgram = n.chance(50), twoSide = n.chance(50);
       glPointSize(size);
       glPointParameterf(GL_POINT_SIZE_MIN, low);
       glPointParameterf(GL_POINT_SIZE_MAX, high);
       turn(GL_POINT_SMOOTH, smooth);
       turn(GL_VERTEX_PROGRAM_POINT_SIZE, byProgram);
       turn(GL_VERTEX_PROGRAM_TWO_SIDE, twoSide);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.raster.pointSize, size);
         EXPECT_EQ(m.raster.pointSizeMinimum, low);
         EXPECT_EQ(m.raster.pointSizeMaximum, high);
         EXPECT_EQ(m.smoothPoints, smooth);
         EXPECT_EQ(m.pointSizeFromProgram, byProgram);
         EXPECT_EQ(m.twoSidedColor, twoSide);
       };
     }},
    {"point sprites", dirty::kTexGen,
     [](Numbers &n) -> Check {
       const bool on = n.chance(60), lower = n.chance(50);
       const int units = n.below(256);
       turn(GL_POINT_SPRITE, on);
       glPointParameteri(GL_POINT_SPRITE_COORD_ORIGIN, lower ? GL_LOWER_LEFT : GL_UPPER_LEFT);
       GLint active = 0;
       glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
       for (int unit = 0; unit < 8; ++unit) {
         glActiveTexture(GLenum(GL_TEXTURE0 + unit));
         glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, units >> unit & 1);
       }
       glActiveTexture(GLenum(active));
       return [=](const Mirror &m) {
         EXPECT_EQ(m.spriteCoords, on ? units : 0);
         if (on) {
           EXPECT_EQ(m.raster.spriteOriginLowerLeft, lower);
         }
       };
     }},
};

} // namespace

std::span<const Field> rasterFields() { return kRaster; }

} // namespace arbiter::state::testing
