// Unit 0 has normals, 1 the light's direction by a cube map, 2 the half vector's, 3 an attenuation
// by distance.
#include "techniques.h"

#include <cmath>

namespace techniques {

namespace {

struct Vector {
  float x, y, z;
};
Vector operator-(const Vector &a, const Vector &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vector normalised(const Vector &v) {
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return {v.x / length, v.y / length, v.z / length};
}
void appendNormal(Picture &texels, const Vector &v) {
  for (const float c : {v.x, v.y, v.z})
    texels.push_back(byteOf(c * 0.5f + 0.5f));
  texels.push_back(255);
}

void makeBumpTextures() {
  Picture texels;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float phase = float(x) * 0.2f, other = float(y) * 0.15f;
      appendNormal(texels, normalised({-0.7f * std::cos(phase), -0.7f * std::sin(other), 1.0f}));
    }
  glActiveTexture(GL_TEXTURE0);
  bindNew(GL_TEXTURE_2D, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  glEnable(GL_TEXTURE_2D);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE2}) {
    glActiveTexture(unit);
    bindNew(GL_TEXTURE_CUBE_MAP, GL_LINEAR);
    constexpr int kSide = 32;
    for (int face = 0; face < 6; ++face) {
      Picture side;
      for (int t = 0; t < kSide; ++t)
        for (int s = 0; s < kSide; ++s) {
          const float a = (float(s) + 0.5f) * 2 / kSide - 1, b = (float(t) + 0.5f) * 2 / kSide - 1;
          const Vector directions[] = {{1, -b, -a}, {-1, -b, a}, {a, 1, b},
                                       {a, -1, -b}, {a, -b, 1},  {-a, -b, -1}};
          appendNormal(side, normalised(directions[face]));
        }
      glTexImage2D(GLenum(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face), 0, GL_RGBA8, kSide, kSide, 0,
                   GL_RGBA, GL_UNSIGNED_BYTE, side.data());
    }
    glEnable(GL_TEXTURE_CUBE_MAP);
  }
  glActiveTexture(GL_TEXTURE3);
  bindNew(GL_TEXTURE_2D, GL_LINEAR);
  Picture falloff;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      const float distance = std::hypot(float(x) - 31.5f, float(y) - 31.5f) / 31.5f;
      const std::uint8_t value = byteOf(1.0f - distance * distance);
      falloff.insert(falloff.end(), {value, value, value, 255});
    }
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, falloff.data());
  glEnable(GL_TEXTURE_2D);
}

/// Sets stage 0 to both dot products. Stage 1 squares the specular one, subtracts one half, and
/// doubles it. The final combiner squares that again, multiplies diffuse by the light's color, and
/// both by the attenuation.
void bumpsByCombiners() {
  glEnable(GL_REGISTER_COMBINERS_NV);
  const GLfloat light[] = {1.0f, 0.8f, 0.5f, 1.0f};
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, light);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 3);
  input(GL_COMBINER0_NV, GL_VARIABLE_A_NV, GL_TEXTURE0, GL_EXPAND_NORMAL_NV);
  input(GL_COMBINER0_NV, GL_VARIABLE_B_NV, GL_TEXTURE1, GL_EXPAND_NORMAL_NV);
  input(GL_COMBINER0_NV, GL_VARIABLE_C_NV, GL_TEXTURE0, GL_EXPAND_NORMAL_NV);
  input(GL_COMBINER0_NV, GL_VARIABLE_D_NV, GL_TEXTURE2, GL_EXPAND_NORMAL_NV);
  glCombinerOutputNV(GL_COMBINER0_NV, GL_RGB, GL_SPARE0_NV, GL_SPARE1_NV, GL_DISCARD_NV, GL_NONE,
                     GL_NONE, GL_TRUE, GL_TRUE, GL_FALSE);
  input(GL_COMBINER1_NV, GL_VARIABLE_A_NV, GL_SPARE1_NV);
  input(GL_COMBINER1_NV, GL_VARIABLE_B_NV, GL_SPARE1_NV);
  input(GL_COMBINER1_NV, GL_VARIABLE_C_NV, GL_ZERO);
  input(GL_COMBINER1_NV, GL_VARIABLE_D_NV, GL_ZERO);
  glCombinerOutputNV(GL_COMBINER1_NV, GL_RGB, GL_SPARE1_NV, GL_DISCARD_NV, GL_DISCARD_NV,
                     GL_SCALE_BY_TWO_NV, GL_BIAS_BY_NEGATIVE_ONE_HALF_NV, GL_FALSE, GL_FALSE,
                     GL_FALSE);
  input(GL_COMBINER2_NV, GL_VARIABLE_A_NV, GL_SPARE0_NV);
  input(GL_COMBINER2_NV, GL_VARIABLE_B_NV, GL_CONSTANT_COLOR0_NV);
  input(GL_COMBINER2_NV, GL_VARIABLE_C_NV, GL_ZERO);
  input(GL_COMBINER2_NV, GL_VARIABLE_D_NV, GL_ZERO);
  glCombinerOutputNV(GL_COMBINER2_NV, GL_RGB, GL_SPARE0_NV, GL_DISCARD_NV, GL_DISCARD_NV, GL_NONE,
                     GL_NONE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (const GLenum stage : {GL_COMBINER0_NV, GL_COMBINER1_NV, GL_COMBINER2_NV})
    noAlpha(stage);
  final(GL_VARIABLE_E_NV, GL_SPARE1_NV);
  final(GL_VARIABLE_F_NV, GL_SPARE1_NV);
  final(GL_VARIABLE_A_NV, GL_TEXTURE3);
  final(GL_VARIABLE_B_NV, GL_SPARE0_NV);
  final(GL_VARIABLE_C_NV, GL_ZERO);
  final(GL_VARIABLE_D_NV, GL_E_TIMES_F_NV);
  opaque();
}

void bumpsByProgram() {
  useProgram("!!ARBfp1.0\n"
             "TEMP normal, light, half, falloff, diffuse, specular;\n"
             "PARAM expand = {2, -1, 0, 1};\n"
             "TXP normal, fragment.texcoord[0], texture[0], 2D;\n"
             "TEX light, fragment.texcoord[1], texture[1], CUBE;\n"
             "TEX half, fragment.texcoord[2], texture[2], CUBE;\n"
             "TXP falloff, fragment.texcoord[3], texture[3], 2D;\n"
             "MAD normal, normal, expand.x, expand.y;\n"
             "MAD light, light, expand.x, expand.y;\n"
             "MAD half, half, expand.x, expand.y;\n"
             "DP3_SAT diffuse, normal, light;\n"
             "DP3_SAT specular, normal, half;\n"
             "MUL specular, specular, specular;\n"
             "MAD_SAT specular, specular, expand.x, expand.y;\n"
             "MUL diffuse, diffuse, program.env[0];\n"
             "MUL specular, specular, specular;\n"
             "MAD result.color.xyz, diffuse, falloff, specular;\n"
             "MOV result.color.w, expand.w;\nEND");
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 1.0f, 0.8f, 0.5f, 1.0f);
}

void drawBumps() {
  constexpr int kSteps = 16;
  constexpr Vector kLight = {0.3f, 0.2f, 0.5f}, kEye = {0, 0, 2};
  const auto vertex = [&](int column, int row) {
    const Vector at = {float(column) * 2 / kSteps - 1, float(row) * 2 / kSteps - 1, 0};
    const Vector light = normalised(kLight - at), eye = normalised(kEye - at);
    glMultiTexCoord2f(GL_TEXTURE0, at.x * 0.5f + 0.5f, at.y * 0.5f + 0.5f);
    glMultiTexCoord3f(GL_TEXTURE1, light.x, light.y, light.z);
    glMultiTexCoord3f(GL_TEXTURE2, light.x + eye.x, light.y + eye.y, light.z + eye.z);
    glMultiTexCoord2f(GL_TEXTURE3, (at.x - kLight.x) * 0.4f + 0.5f,
                      (at.y - kLight.y) * 0.4f + 0.5f);
    glVertex3f(at.x, at.y, at.z);
  };
  glBegin(GL_QUADS);
  for (int row = 0; row < kSteps; ++row)
    for (int column = 0; column < kSteps; ++column) {
      vertex(column, row);
      vertex(column + 1, row);
      vertex(column + 1, row + 1);
      vertex(column, row + 1);
    }
  glEnd();
}

} // namespace

const Technique kBumps = {"bumps", makeBumpTextures, bumpsByCombiners, bumpsByProgram, drawBumps};

} // namespace techniques
