#include <epoxy/gl.h>
#include <utility>

#include "gl_host.h"
#include "scene_data.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
void load(GLenum mode, const Matrix &rows) {
  glMatrixMode(mode);
  glLoadMatrixf(columns(rows)[0].data());
}

void applyLight(GLenum name, const Light &l) {
  glLightfv(name, GL_AMBIENT, l.ambient.data());
  glLightfv(name, GL_DIFFUSE, l.diffuse.data());
  glLightfv(name, GL_SPECULAR, l.specular.data());
  glLightfv(name, GL_POSITION, l.position.data());
  glLightfv(name, GL_SPOT_DIRECTION, l.spot.data());
  glLightf(name, GL_SPOT_CUTOFF, l.cutoffDegrees);
  glLightf(name, GL_CONSTANT_ATTENUATION, l.attenuation[0]);
  glLightf(name, GL_LINEAR_ATTENUATION, l.attenuation[1]);
  glLightf(name, GL_QUADRATIC_ATTENUATION, l.attenuation[2]);
  glLightf(name, GL_SPOT_EXPONENT, l.attenuation[3]);
}

void applyMaterial(GLenum face, const Material &m) {
  glMaterialfv(face, GL_AMBIENT, m.ambient.data());
  glMaterialfv(face, GL_DIFFUSE, m.diffuse.data());
  glMaterialfv(face, GL_SPECULAR, m.specular.data());
  glMaterialfv(face, GL_EMISSION, m.emission.data());
  glMaterialf(face, GL_SHININESS, m.shininess);
}

/// The value at the window's lower left corner, and the change across the window in x and in y,
/// small enough to stay inside fp::testing::InputRanges.
struct Plane {
  Vec4 origin, dx, dy;
};

Plane planeOf(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::ColorPrimary:
    return {{0.125f, 0.625f, 0.25f, 0.5f},
            {0.75f, -0.375f, 0.25f, 0.375f},
            {0.0625f, -0.25f, 0.375f, 0}};
  case AttributeKind::ColorSecondary:
    return {{0.625f, 0.125f, 0.5f, 0}, {-0.5f, 0.25f, 0.375f, 0}, {0.125f, 0.5f, -0.375f, 0}};
  case AttributeKind::TexCoord: {
    const float shift = 0.0625f * float(attribute.index);
    return {{-1.0f + shift, 0.75f - shift, 0.125f, 0.625f + shift},
            {2.75f, -0.25f + shift, 0.5f, 0.5f},
            {0.375f, 1.25f, -1.0f + shift, 0.25f}};
  }
  case AttributeKind::FogCoord:
    return {{0.125f, 0, 0, 1}, {1, 0, 0, 0}, {0.75f, 0, 0, 0}};
  case AttributeKind::Position:
    return {{0, 0, 0.25f, 1}, {kSide, 0, 0.25f, 0}, {0, kSide, 0.125f, 0}};
  case AttributeKind::Facing:
    return {{1, 0, 0, 1}, {}, {}};
  case AttributeKind::Normal:
  case AttributeKind::Generic:
    break; // vertex programs
  }
  return {};
}

Vec4 at(const Plane &plane, float u, float v) {
  Vec4 value;
  for (std::size_t i = 0; i < 4; ++i)
    value[i] = plane.origin[i] + u * plane.dx[i] + v * plane.dy[i];
  return value;
}
} // namespace

void applyState(bool programMatrices) {
  // The current modelview matrix transforms positions of lights.
  glMatrixMode(GL_MODELVIEW);
  glLoadIdentity();
  for (int i = 0; i < 2; ++i) {
    applyMaterial(i == 0 ? GL_FRONT : GL_BACK, kMaterials[i]);
    applyLight(GL_LIGHT0 + GLenum(i), kLights[i]);
    glActiveTexture(GL_TEXTURE0 + GLenum(i));
    glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, texEnvColor(i).data());
    load(GL_TEXTURE, kTexture[i]);
  }
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, kSceneAmbient.data());
  glFogfv(GL_FOG_COLOR, kFogColor.data());
  glFogf(GL_FOG_DENSITY, kFogDensity);
  glFogf(GL_FOG_START, kFogStart);
  glFogf(GL_FOG_END, kFogEnd);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glDepthRange(double(kDepthNear), double(kDepthFar));
  load(GL_MODELVIEW, kModelview);
  load(GL_PROJECTION, kProjection);
  if (programMatrices) {
    load(GL_MATRIX0_ARB, kProgram[0]);
    load(GL_MATRIX1_ARB, kProgram[1]);
  }
  glMatrixMode(GL_MODELVIEW);
  glClampColorARB(GL_CLAMP_VERTEX_COLOR_ARB, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_ALWAYS);
}

Vec4 attributeValue(const Attribute &attribute, float x, float y) {
  const Vec4 value = at(planeOf(attribute), x / float(kSide), y / float(kSide));
  if (attribute.kind == AttributeKind::TexCoord && attribute.index < 2)
    return transformed(kTexture[attribute.index], value);
  return value;
}

void drawQuad() {
  constexpr std::pair<float, float> kCorners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto &[u, v] : kCorners) {
    glColor4fv(at(planeOf({AttributeKind::ColorPrimary, 0}), u, v).data());
    glSecondaryColor3fv(at(planeOf({AttributeKind::ColorSecondary, 0}), u, v).data());
    glFogCoordf(at(planeOf({AttributeKind::FogCoord, 0}), u, v)[0]);
    for (std::uint8_t i = 0; i < 8; ++i)
      glMultiTexCoord4fv(GL_TEXTURE0 + i, at(planeOf({AttributeKind::TexCoord, i}), u, v).data());
    // Window z is near + (far - near) * (clip z + 1) / 2.
    const float z = at(planeOf({AttributeKind::Position, 0}), u, v)[2];
    glVertex3f(2 * u - 1, 2 * v - 1, 2 * (z - kDepthNear) / (kDepthFar - kDepthNear) - 1);
  }
  glEnd();
}

void applyEnvParameters(unsigned target) {
  for (std::uint16_t i = 0; i < 16; ++i)
    glProgramEnvParameter4fvARB(target, i, parameterValue({ParameterKind::Env, {}, i, {}}).data());
}

void applyLocalParameters(unsigned target) {
  for (std::uint16_t i = 0; i < 16; ++i)
    glProgramLocalParameter4fvARB(target, i,
                                  parameterValue({ParameterKind::Local, {}, i, {}}).data());
}

} // namespace arbiter::differential
