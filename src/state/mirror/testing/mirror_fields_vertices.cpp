#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/mirror/testing/mirror_fields.h"

#include <gtest/gtest.h>

#include "state/raster_draw/fixed_function/fixed_vertex.h"

namespace arbiter::state::testing {
namespace {

/// Runs `act` on each unit and restores the active one.
template <typename Do> void onUnits(Do act) {
  GLint active = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
  for (int unit = 0; unit < 8; ++unit) {
    glActiveTexture(GLenum(GL_TEXTURE0 + unit));
    act(unit);
  }
  glActiveTexture(GLenum(active));
}

constexpr Field kVertices[] = {
    {"normals and planes", dirty::kTransform,
     [](Numbers &n) -> Check {
       const bool normalize = n.chance(50), rescale = n.chance(50);
       const int planes = n.below(64);
       turn(GL_NORMALIZE, normalize);
       turn(GL_RESCALE_NORMAL, rescale);
       for (int i = 0; i < 6; ++i)
         turn(GLenum(GL_CLIP_PLANE0 + i), (planes >> i & 1) != 0);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.vertex.normalize, normalize);
         EXPECT_EQ(m.vertex.rescale, rescale);
         EXPECT_EQ(m.vertex.clipPlanes, planes);
       };
     }},
    {"texture matrices", dirty::kTransform,
     [](Numbers &n) -> Check {
       const int moved = n.below(256);
       GLint mode = 0;
       glGetIntegerv(GL_MATRIX_MODE, &mode);
       glMatrixMode(GL_TEXTURE);
       onUnits([&](int unit) {
         glLoadIdentity();
         if ((moved >> unit & 1) != 0)
           glTranslatef(0, 1, 0);
       });
       glMatrixMode(GLenum(mode));
       return [=](const Mirror &m) { EXPECT_EQ(m.vertex.textureMatrix, moved); };
     }},
    {"light model", dirty::kLighting,
     [](Numbers &n) -> Check {
       const bool lighting = n.chance(70), two = n.chance(50), local = n.chance(50),
                  separate = n.chance(50);
       turn(GL_LIGHTING, lighting);
       glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, two);
       glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, local);
       glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL,
                     separate ? GL_SEPARATE_SPECULAR_COLOR : GL_SINGLE_COLOR);
       return [=](const Mirror &m) {
         EXPECT_EQ(m.vertex.lighting, lighting);
         if (!lighting)
           return;
         EXPECT_EQ(m.vertex.twoSided, two);
         EXPECT_EQ(m.vertex.localViewer, local);
         EXPECT_EQ(m.vertex.separateSpecular, separate);
       };
     }},
    {"colour material", dirty::kLighting,
     [](Numbers &n) -> Check {
       constexpr GLenum kFaces[] = {GL_FRONT, GL_BACK, GL_FRONT_AND_BACK};
       constexpr GLenum kParts[] = {GL_EMISSION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
                                    GL_AMBIENT_AND_DIFFUSE};
       constexpr int kBits[] = {1, 2, 4, 8, 6};
       const int face = n.below(3), part = n.below(5);
       const bool on = n.chance(50);
       glColorMaterial(kFaces[face], kParts[part]);
       turn(GL_COLOR_MATERIAL, on);
       return [=](const Mirror &m) {
         if (!m.vertex.lighting)
           return;
         EXPECT_EQ(m.vertex.colorMaterial, on);
         EXPECT_EQ(m.vertex.colorMaterialFace, on ? face + 1 : 0);
         EXPECT_EQ(m.vertex.colorMaterialParts, on ? kBits[part] : 0);
       };
     }},
    {"lights", dirty::kLighting,
     [](Numbers &n) -> Check {
       const int on = n.below(256), positional = n.below(256), spots = n.below(256),
                 attenuated = n.below(256);
       for (int i = 0; i < 8; ++i) {
         const auto light = GLenum(GL_LIGHT0 + i);
         const auto bit = [&](int mask) { return (mask >> i & 1) != 0; };
         const GLfloat position[4] = {1, 2, 3, bit(positional) ? 2.0f : 0.0f};
         turn(light, bit(on));
         glLightfv(light, GL_POSITION, position);
         glLightf(light, GL_SPOT_CUTOFF, bit(spots) ? 45 : 180);
         glLightf(light, GL_LINEAR_ATTENUATION, bit(attenuated) ? 0.5f : 0);
       }
       return [=](const Mirror &m) {
         if (!m.vertex.lighting)
           return; // then the mirror does not query lights
         EXPECT_EQ(m.vertex.lights, on);
         EXPECT_EQ(m.vertex.positional, on & positional);
         EXPECT_EQ(m.vertex.spots, on & spots);
         EXPECT_EQ(m.vertex.attenuated, on & positional & attenuated);
       };
     }},
    {"texture coordinate generation", dirty::kTexGen,
     [](Numbers &n) -> Check {
       constexpr GLint kModes[] = {GL_OBJECT_LINEAR, GL_EYE_LINEAR, GL_SPHERE_MAP,
                                   GL_REFLECTION_MAP, GL_NORMAL_MAP};
       std::array<std::array<std::uint8_t, 4>, 8> wanted{};
       onUnits([&](int unit) {
         for (GLenum c = 0; c < 4; ++c) {
           const int mode = n.below(c == 3 ? 2 : 5);
           const bool on = n.chance(50);
           if (!(c == 2 && mode == 2)) // r has no sphere map
             glTexGeni(GL_S + c, GL_TEXTURE_GEN_MODE, kModes[mode]);
           else
             glTexGeni(GL_S + c, GL_TEXTURE_GEN_MODE, GL_EYE_LINEAR);
           turn(GL_TEXTURE_GEN_S + c, on);
           wanted[std::size_t(unit)][c] = std::uint8_t(!on                   ? 0
                                                       : c == 2 && mode == 2 ? 2
                                                                             : 1 + mode);
         }
       });
       return [=](const Mirror &m) { EXPECT_EQ(m.vertex.texGen, wanted); };
     }},
    {"fog source and point attenuation", dirty::kFog,
     [](Numbers &n) -> Check {
       const bool depth = n.chance(50), attenuated = n.chance(50);
       const GLfloat factors[3] = {1, 0, attenuated ? 0.5f : 0};
       constexpr std::pair<GLenum, FogFrom> kModes[] = {
           {GL_EYE_PLANE_ABSOLUTE_NV, FogFrom::AbsoluteDepth},
           {GL_EYE_PLANE, FogFrom::Depth},
           {GL_EYE_RADIAL_NV, FogFrom::Distance}};
       const auto [mode, from] = kModes[n.below(3)];
       glFogi(GL_FOG_COORD_SRC, depth ? GL_FRAGMENT_DEPTH : GL_FOG_COORD);
       glFogi(GL_FOG_DISTANCE_MODE_NV, GLint(mode));
       glPointParameterfv(GL_POINT_DISTANCE_ATTENUATION, factors);
       return [depth, attenuated, expected = from](const Mirror &m) {
         if (depth)
           EXPECT_EQ(m.vertex.fogFrom, expected);
         else // the host decides
           EXPECT_TRUE(m.vertex.fogFrom == FogFrom::Coordinate ||
                       m.vertex.fogFrom == FogFrom::AbsoluteCoordinate);
         EXPECT_EQ(m.vertex.pointAttenuation, attenuated);
       };
     }},
};

} // namespace

std::span<const Field> vertexFields() { return kVertices; }

} // namespace arbiter::state::testing
