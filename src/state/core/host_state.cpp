// fetchState queries a program's GL state from the host (3.11.3.2, tables X.3.1 to X.3.7). It does
// so at each draw, for state that GLSL has no built-in for, or none to be trusted.
#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "fp_compiler/ir/fog.h"
#include "host/host_table.h"
#include "state/core/core_context.h"
#include "state/core/host_state.h"
#include "state/core/unit_scope.h"

namespace arbiter::state {

namespace {

using fp::ir::MatrixModifier;
using fp::ir::StateItem;
using fp::ir::StateRef;

glm::mat4 getMatrix(const host::HostTable &host, GLenum pname) {
  glm::mat4 matrix(1.0f);
  host.GetFloatv(pname, glm::value_ptr(matrix));
  return matrix;
}

/// Returns a program matrix. GL lets it be read only as the current matrix (AFP 3698-3707).
glm::mat4 getProgramMatrix(const host::HostTable &host, GLuint index) {
  GLint mode = GL_MODELVIEW;
  host.GetIntegerv(GL_MATRIX_MODE, &mode);
  host.MatrixMode(GL_MATRIX0_ARB + index);
  const glm::mat4 matrix = getMatrix(host, GL_CURRENT_MATRIX_ARB);
  host.MatrixMode(GLenum(mode));
  return matrix;
}

/// Returns the product of two matrices, rounded as hosts of the same width round it: on 32-bit x86
/// they sum with x87. Then a pass that uses a product made by the host matches a pass that uses
/// state.matrix.mvp.
glm::mat4 productOf(const glm::mat4 &a, const glm::mat4 &b) {
#if defined(__i386__)
  using Sum = long double;
#else
  using Sum = float;
#endif
  glm::mat4 product;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row) {
      Sum sum = Sum(a[0][row]) * b[column][0];
      for (int k = 1; k < 4; ++k)
        sum += Sum(a[k][row]) * b[column][k];
      product[column][row] = float(sum);
    }
  return product;
}

glm::mat4 plainMatrix(const host::HostTable &host, const StateRef &state) {
  switch (state.item) {
  case StateItem::MatrixProjection:
    return getMatrix(host, GL_PROJECTION_MATRIX);
  case StateItem::MatrixMvp:
    return productOf(getMatrix(host, GL_PROJECTION_MATRIX), getMatrix(host, GL_MODELVIEW_MATRIX));
  case StateItem::MatrixTexture: {
    const UnitScope unit(host, state.index);
    return getMatrix(host, GL_TEXTURE_MATRIX);
  }
  case StateItem::MatrixProgram:
    return getProgramMatrix(host, state.index);
  default: // no profile has palettes and further modelview matrices
    return getMatrix(host, GL_MODELVIEW_MATRIX);
  }
}

/// Returns the matrix with its modifier applied.
glm::mat4 modifiedMatrix(const host::HostTable &host, const StateRef &state) {
  glm::mat4 matrix = plainMatrix(host, state);
  const bool inverse =
      state.modifier == MatrixModifier::Inverse || state.modifier == MatrixModifier::InvTrans;
  // The inverse of a singular matrix is undefined (2.14.3.2). The layer returns zero, as for all
  // undefined results.
  if (inverse)
    matrix = glm::determinant(matrix) != 0.0f ? glm::inverse(matrix) : glm::mat4(0.0f);
  if (state.modifier == MatrixModifier::Transpose || state.modifier == MatrixModifier::InvTrans)
    matrix = glm::transpose(matrix);
  return matrix;
}

void matrixRow(const host::HostTable &host, const StateRef &state, GLfloat value[4]) {
  const glm::mat4 matrix = modifiedMatrix(host, state);
  const int row = state.row & 3;
  for (int column = 0; column < 4; ++column)
    value[column] = matrix[column][row];
}

void material(const host::HostTable &host, bool back, GLenum pname, GLfloat value[4]) {
  host.GetMaterialfv(back ? GL_BACK : GL_FRONT, pname, value);
}

void lightProduct(const host::HostTable &host, const StateRef &state, GLenum pname,
                  GLfloat value[4]) {
  GLfloat light[4] = {};
  material(host, state.back, pname, value);
  host.GetLightfv(GL_LIGHT0 + state.index, pname, light);
  for (int i = 0; i < 3; ++i) // w stays the material's alpha
    value[i] *= light[i];
}

void sceneColor(const host::HostTable &host, bool back, GLfloat value[4]) {
  GLfloat ambient[4] = {}, emission[4] = {}, diffuse[4] = {}, model[4] = {};
  material(host, back, GL_AMBIENT, ambient);
  material(host, back, GL_EMISSION, emission);
  material(host, back, GL_DIFFUSE, diffuse);
  host.GetFloatv(GL_LIGHT_MODEL_AMBIENT, model);
  for (int i = 0; i < 3; ++i)
    value[i] = model[i] * ambient[i] + emission[i];
  value[3] = diffuse[3];
}

void light(const host::HostTable &host, const StateRef &state, GLfloat value[4]) {
  const GLenum name = GL_LIGHT0 + state.index;
  switch (state.item) {
  case StateItem::LightAttenuation:
    host.GetLightfv(name, GL_CONSTANT_ATTENUATION, &value[0]);
    host.GetLightfv(name, GL_LINEAR_ATTENUATION, &value[1]);
    host.GetLightfv(name, GL_QUADRATIC_ATTENUATION, &value[2]);
    host.GetLightfv(name, GL_SPOT_EXPONENT, &value[3]);
    break;
  case StateItem::LightSpotDirection: {
    GLfloat cutoff = 180.0f;
    host.GetLightfv(name, GL_SPOT_DIRECTION, value);
    host.GetLightfv(name, GL_SPOT_CUTOFF, &cutoff);
    value[3] = cutoff == 180.0f ? -1.0f : std::cos(glm::radians(cutoff));
    break;
  }
  default: { // LightHalf, for an infinite light and an infinite viewer on +z
    GLfloat position[4] = {};
    host.GetLightfv(name, GL_POSITION, position);
    const glm::vec3 direction(position[0], position[1], position[2]);
    const float length = glm::length(direction);
    const glm::vec3 half =
        (length > 0.0f ? direction / length : glm::vec3(0.0f)) + glm::vec3(0.0f, 0.0f, 1.0f);
    const float halfLength = glm::length(half);
    for (int i = 0; i < 3; ++i)
      value[i] = halfLength > 0.0f ? half[i] / halfLength : 0.0f;
    value[3] = 1.0f;
    break;
  }
  }
}

void fogParams(const host::HostTable &host, GLfloat value[4]) {
  host.GetFloatv(GL_FOG_DENSITY, &value[0]);
  host.GetFloatv(GL_FOG_START, &value[1]);
  host.GetFloatv(GL_FOG_END, &value[2]);
  const GLfloat span = value[2] - value[1];
  value[3] = span != 0.0f ? 1.0f / span : 0.0f;
}

/// Gets the coefficients of a texture generation plane (2.10.4). GL returns eye planes transformed,
/// as it keeps them.
void texGen(const host::HostTable &host, const StateRef &state, GLfloat value[4]) {
  const UnitScope unit(host, state.index);
  const GLenum pname = state.item == StateItem::TexGenEye ? GL_EYE_PLANE : GL_OBJECT_PLANE;
  host.GetTexGenfv(GL_S + (state.row & 3u), pname, value);
}

void clipPlane(const host::HostTable &host, unsigned plane, GLfloat value[4]) {
  GLdouble equation[4] = {};
  host.GetClipPlane(GL_CLIP_PLANE0 + plane, equation);
  for (int i = 0; i < 4; ++i)
    value[i] = GLfloat(equation[i]);
}

} // namespace

void fetchState(CoreContext &context, const StateRef &state, GLfloat value[4]) {
  const host::HostTable &host = *context.host;
  std::fill_n(value, 4, 0.0f);
  switch (state.item) {
  case StateItem::MaterialAmbient:
    return material(host, state.back, GL_AMBIENT, value);
  case StateItem::MaterialDiffuse:
    return material(host, state.back, GL_DIFFUSE, value);
  case StateItem::MaterialSpecular:
    return material(host, state.back, GL_SPECULAR, value);
  case StateItem::MaterialEmission:
    return material(host, state.back, GL_EMISSION, value);
  case StateItem::MaterialShininess:
    material(host, state.back, GL_SHININESS, value);
    value[3] = 1.0f;
    return;
  case StateItem::LightAmbient:
    return host.GetLightfv(GL_LIGHT0 + state.index, GL_AMBIENT, value);
  case StateItem::LightDiffuse:
    return host.GetLightfv(GL_LIGHT0 + state.index, GL_DIFFUSE, value);
  case StateItem::LightSpecular:
    return host.GetLightfv(GL_LIGHT0 + state.index, GL_SPECULAR, value);
  case StateItem::LightPosition:
    return host.GetLightfv(GL_LIGHT0 + state.index, GL_POSITION, value);
  case StateItem::LightAttenuation:
  case StateItem::LightSpotDirection:
  case StateItem::LightHalf:
    return light(host, state, value);
  case StateItem::LightModelAmbient:
    return host.GetFloatv(GL_LIGHT_MODEL_AMBIENT, value);
  case StateItem::LightModelSceneColor:
    return sceneColor(host, state.back, value);
  case StateItem::LightProdAmbient:
    return lightProduct(host, state, GL_AMBIENT, value);
  case StateItem::LightProdDiffuse:
    return lightProduct(host, state, GL_DIFFUSE, value);
  case StateItem::LightProdSpecular:
    return lightProduct(host, state, GL_SPECULAR, value);
  case StateItem::TexEnvColor: {
    const UnitScope unit(host, state.index);
    return host.GetTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, value);
  }
  case StateItem::FogColor:
    return host.GetFloatv(GL_FOG_COLOR, value);
  case StateItem::FogParams:
    return fogParams(host, value);
  case StateItem::FogFactors: {
    fp::ir::Vec4 params;
    fogParams(host, params.data());
    std::ranges::copy(fp::ir::fogFactors(params), value);
    return;
  }
  case StateItem::DepthRange:
    host.GetFloatv(GL_DEPTH_RANGE, value);
    value[2] = value[1] - value[0];
    value[3] = 1.0f;
    return;
  case StateItem::MatrixModelview:
  case StateItem::MatrixProjection:
  case StateItem::MatrixMvp:
  case StateItem::MatrixTexture:
  case StateItem::MatrixPalette:
  case StateItem::MatrixProgram:
    return matrixRow(host, state, value);
  case StateItem::TexGenEye:
  case StateItem::TexGenObject:
    return texGen(host, state, value);
  case StateItem::ClipPlane:
    return clipPlane(host, state.index, value);
  case StateItem::PointSize:
    host.GetFloatv(GL_POINT_SIZE, &value[0]);
    host.GetFloatv(GL_POINT_SIZE_MIN, &value[1]);
    host.GetFloatv(GL_POINT_SIZE_MAX, &value[2]);
    return host.GetFloatv(GL_POINT_FADE_THRESHOLD_SIZE, &value[3]);
  case StateItem::PointAttenuation:
    host.GetFloatv(GL_POINT_DISTANCE_ATTENUATION, value);
    value[3] = 1.0f;
    return;
  }
}

void fetchMatrix(CoreContext &context, const StateRef &state, GLfloat rows[4][4]) {
  const glm::mat4 matrix = modifiedMatrix(*context.host, state);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      rows[row][column] = matrix[column][row];
}

} // namespace arbiter::state
