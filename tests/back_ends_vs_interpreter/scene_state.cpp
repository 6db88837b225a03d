#include <cmath>
#include <utility>

#include "scene_data.h"

namespace arbiter::differential {

using namespace fp::ir;

namespace {
Matrix transposed(const Matrix &m) {
  Matrix result;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      result[r][c] = m[c][r];
  return result;
}

/// Inverts a matrix by Gauss-Jordan elimination in double precision.
Matrix inverted(const Matrix &m) {
  double a[4][8] = {};
  for (std::size_t r = 0; r < 4; ++r) {
    for (std::size_t c = 0; c < 4; ++c)
      a[r][c] = double(m[r][c]);
    a[r][4 + r] = 1;
  }
  for (int column = 0; column < 4; ++column) {
    int pivot = column;
    for (int r = column; r < 4; ++r)
      if (std::fabs(a[r][column]) > std::fabs(a[pivot][column]))
        pivot = r;
    std::swap(a[pivot], a[column]);
    for (int r = 0; r < 4; ++r) {
      const double factor = r == column ? 0 : a[r][column] / a[column][column];
      for (int c = 0; c < 8; ++c)
        a[r][c] -= factor * a[column][c];
    }
  }
  Matrix result;
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      result[r][c] = float(a[r][4 + c] / a[r][r]);
  return result;
}

Matrix product(const Matrix &a, const Matrix &b) {
  Matrix result = {};
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      for (std::size_t k = 0; k < 4; ++k)
        result[r][c] += a[r][k] * b[k][c];
  return result;
}

Matrix matrixOf(const StateRef &ref) {
  constexpr Matrix kOne = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  switch (ref.item) {
  case StateItem::MatrixModelview:
    return kModelview;
  case StateItem::MatrixProjection:
    return kProjection;
  case StateItem::MatrixMvp:
    return product(kProjection, kModelview);
  case StateItem::MatrixTexture:
    return ref.index < 2 ? kTexture[ref.index] : kOne;
  case StateItem::MatrixProgram:
    return ref.index < 2 ? kProgram[ref.index] : kOne;
  default:
    return kOne;
  }
}

Vec4 matrixRow(const StateRef &ref) {
  const Matrix m = matrixOf(ref);
  switch (ref.modifier) {
  case MatrixModifier::Plain:
    return m[ref.row];
  case MatrixModifier::Inverse:
    return inverted(m)[ref.row];
  case MatrixModifier::Transpose:
    return transposed(m)[ref.row];
  case MatrixModifier::InvTrans:
    return transposed(inverted(m))[ref.row];
  }
  return {};
}

Vec4 halfAngle(const Vec4 &position) {
  const auto normalized = [](const Vec4 &v) {
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return Vec4{v[0] / length, v[1] / length, v[2] / length, 1};
  };
  Vec4 sum = normalized(position);
  sum[2] += 1;
  return normalized(sum);
}

Vec4 lightProduct(const Vec4 &light, const Vec4 &material) {
  return {light[0] * material[0], light[1] * material[1], light[2] * material[2], material[3]};
}

Vec4 sceneColor(const Material &material) {
  Vec4 color = material.emission;
  for (std::size_t i = 0; i < 3; ++i)
    color[i] += kSceneAmbient[i] * material.ambient[i];
  color[3] = material.diffuse[3];
  return color;
}

Vec4 stateValue(const StateRef &ref) {
  const Material &material = kMaterials[ref.back];
  const Light &light = kLights[ref.index & 1];
  switch (ref.item) {
  case StateItem::MaterialAmbient:
    return material.ambient;
  case StateItem::MaterialDiffuse:
    return material.diffuse;
  case StateItem::MaterialSpecular:
    return material.specular;
  case StateItem::MaterialEmission:
    return material.emission;
  case StateItem::MaterialShininess:
    return {material.shininess, 0, 0, 1};
  case StateItem::LightAmbient:
    return light.ambient;
  case StateItem::LightDiffuse:
    return light.diffuse;
  case StateItem::LightSpecular:
    return light.specular;
  case StateItem::LightPosition:
    return light.position;
  case StateItem::LightAttenuation:
    return light.attenuation;
  case StateItem::LightSpotDirection:
    return light.spot;
  case StateItem::LightHalf:
    return halfAngle(light.position);
  case StateItem::LightModelAmbient:
    return kSceneAmbient;
  case StateItem::LightModelSceneColor:
    return sceneColor(material);
  case StateItem::LightProdAmbient:
    return lightProduct(light.ambient, material.ambient);
  case StateItem::LightProdDiffuse:
    return lightProduct(light.diffuse, material.diffuse);
  case StateItem::LightProdSpecular:
    return lightProduct(light.specular, material.specular);
  case StateItem::TexEnvColor:
    return texEnvColor(ref.index);
  case StateItem::FogColor:
    return kFogColor;
  case StateItem::FogParams:
    return {kFogDensity, kFogStart, kFogEnd, 1.0f / (kFogEnd - kFogStart)};
  case StateItem::DepthRange:
    return {kDepthNear, kDepthFar, kDepthFar - kDepthNear, 1};
  case StateItem::MatrixModelview:
  case StateItem::MatrixProjection:
  case StateItem::MatrixMvp:
  case StateItem::MatrixTexture:
  case StateItem::MatrixPalette:
  case StateItem::MatrixProgram:
    return matrixRow(ref);
  case StateItem::TexGenEye:
  case StateItem::TexGenObject:
  case StateItem::ClipPlane:
  case StateItem::PointSize:
  case StateItem::PointAttenuation:
    break; // vertex programs
  case StateItem::FogFactors:
    break; // no program names it
  }
  return {};
}

Vec4 madeUp(std::uint64_t seed) {
  fp::testing::Random random(seed * 7919 + 17);
  using R = fp::testing::InputRanges;
  const auto next = [&] { return random.real(R::kParameterLow, R::kParameterHigh); };
  const float x = next(), y = next(), z = next(), w = next();
  return {x, y, z, w};
}
} // namespace

Vec4 parameterValue(const Parameter &parameter) {
  switch (parameter.kind) {
  case ParameterKind::Constant:
    return parameter.constant;
  case ParameterKind::Env:
    return madeUp(1000u + parameter.index);
  case ParameterKind::Local:
    return madeUp(2000u + parameter.index);
  case ParameterKind::State:
    return stateValue(parameter.state);
  }
  return {};
}

Vec4 transformed(const Matrix &m, const Vec4 &v) {
  Vec4 result = {};
  for (std::size_t r = 0; r < 4; ++r)
    for (std::size_t c = 0; c < 4; ++c)
      result[r] += m[r][c] * v[c];
  return result;
}

Matrix columns(const Matrix &m) { return transposed(m); }

} // namespace arbiter::differential
