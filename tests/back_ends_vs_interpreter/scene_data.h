#pragma once
#include "fp_compiler/testing/random.h"
#include "scene.h"

/// The numbers of the scene. All differ, so that a mix-up is noticed, and are exact in binary.
namespace arbiter::differential {

using Matrix = std::array<Vec4, 4>; ///< rows

/// The projection inverts the modelview matrix, so that object coordinates are clip coordinates.
inline constexpr Matrix kModelview = {
    {{0, -2, 0, 0}, {0.5f, 0, 0, 0}, {0, 0, 1, 0.25f}, {0, 0, 0, 1}}};
inline constexpr Matrix kProjection = {
    {{0, 2, 0, 0}, {-0.5f, 0, 0, 0}, {0, 0, 1, -0.25f}, {0, 0, 0, 1}}};
inline constexpr Matrix kTexture[2] = {
    {{{0.5f, 0.25f, 0, 0.125f}, {-0.25f, 0.5f, 0, 0}, {0, 0, 0.75f, 0}, {0, 0, 0, 1}}},
    {{{0.75f, 0, 0.25f, 0}, {0, 0.5f, 0.5f, 0}, {0.25f, 0, 0.75f, -0.25f}, {0, 0, 0, 1}}}};
inline constexpr Matrix kProgram[2] = {
    {{{1, 0.5f, 0, 0.25f}, {0, 1, 0.5f, 0}, {0.25f, 0, 1, 0.5f}, {0, 0.25f, 0, 1}}},
    {{{0.5f, -0.5f, 0, 1}, {0.5f, 0.5f, 0, -1}, {0, 0, 1, 0.5f}, {0, 0, 0, 1}}}};

inline constexpr float kDepthNear = 0.125f, kDepthFar = 0.875f;
inline constexpr float kFogDensity = 0.75f, kFogStart = 0.25f, kFogEnd = 1.75f;
inline constexpr Vec4 kFogColor = {0.25f, 0.5f, 0.75f, 0.625f};
inline constexpr Vec4 kSceneAmbient = {0.125f, 0.25f, 0.375f, 0.5f};

struct Material {
  Vec4 ambient, diffuse, specular, emission;
  float shininess;
};
inline constexpr Material kMaterials[2] = {{{0.5f, 0.25f, 0.75f, 0.875f},
                                            {0.25f, 0.5f, 1, 0.625f},
                                            {1, 0.75f, 0.5f, 0.375f},
                                            {0.125f, 0.25f, 0.5f, 1},
                                            1.5f},
                                           {{0.75f, 0.5f, 0.25f, 0.25f},
                                            {0.5f, 1, 0.25f, 0.75f},
                                            {0.25f, 0.5f, 0.75f, 0.125f},
                                            {0.5f, 0.125f, 0.25f, 1},
                                            0.75f}};

struct Light {
  Vec4 ambient, diffuse, specular, position;
  Vec4 attenuation; ///< constant, linear, quadratic, spot exponent
  Vec4 spot;        ///< direction, cosine of the cutoff
  float cutoffDegrees;
};
inline constexpr Light kLights[2] = {{{0.25f, 0.5f, 0.75f, 1},
                                      {0.5f, 0.75f, 1, 0.5f},
                                      {1, 0.5f, 0.25f, 0.75f},
                                      {1, 2, 2, 0},
                                      {1, 0.5f, 0.25f, 2},
                                      {0, 0.5f, -1, 0.5f},
                                      60.0f},
                                     {{0.5f, 0.5f, 0.25f, 1},
                                      {0.25f, 1, 0.5f, 1},
                                      {0.5f, 0.25f, 1, 1},
                                      {-0.5f, 1, 0.75f, 1},
                                      {0.5f, 0.25f, 1, 1},
                                      {1, 0, -0.5f, 0.70710678f},
                                      45.0f}};

constexpr Vec4 texEnvColor(int unit) {
  return {0.125f * float(unit + 1), 0.75f, 0.5f, 1.0f - 0.25f * float(unit)};
}

[[nodiscard]] Vec4 transformed(const Matrix &m, const Vec4 &v);
/// Returns the matrix column by column, as GL loads it.
[[nodiscard]] Matrix columns(const Matrix &m);

} // namespace arbiter::differential
