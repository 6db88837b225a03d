#include "techniques.h"

#include <array>
#include <cmath>

namespace techniques {

namespace {

constexpr float kWeight = 0.28f;

void makeGlowImage() {
  Picture texels;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const float dx = float(x - 90), dy = float(y - 140), ring = std::hypot(dx, dy);
      const bool lit = std::abs(ring - 60.0f) < 9.0f || (x / 16 % 5 == 0 && y % 64 < 7);
      texels.insert(texels.end(), {byteOf(lit ? 1.0f : 0.02f), byteOf(lit ? 0.55f : 0.03f),
                                   byteOf(lit ? float(x) / kSize : 0.1f), 255});
    }
  for (GLenum unit = 0; unit < 4; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    if (unit == 0)
      bindNew(GL_TEXTURE_RECTANGLE, GL_LINEAR);
    GLint name = 0;
    if (unit != 0) {
      glActiveTexture(GL_TEXTURE0);
      glGetIntegerv(GL_TEXTURE_BINDING_RECTANGLE, &name);
      glActiveTexture(GL_TEXTURE0 + unit);
      glBindTexture(GL_TEXTURE_RECTANGLE, GLuint(name));
    }
    glEnable(GL_TEXTURE_RECTANGLE);
  }
  glTexImage2D(GL_TEXTURE_RECTANGLE, 0, GL_RGBA8, kSize, kSize, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
}

void glowByCombiners() {
  glEnable(GL_REGISTER_COMBINERS_NV);
  const GLfloat weight[] = {kWeight, kWeight, kWeight, kWeight};
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, weight);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 2);
  const GLenum sums[] = {GL_SPARE0_NV, GL_SPARE1_NV};
  for (GLenum i = 0; i < 2; ++i) {
    const GLenum stage = GL_COMBINER0_NV + i;
    input(stage, GL_VARIABLE_A_NV, GL_TEXTURE0 + 2 * i);
    input(stage, GL_VARIABLE_B_NV, GL_CONSTANT_COLOR0_NV);
    input(stage, GL_VARIABLE_C_NV, GL_TEXTURE1 + 2 * i);
    input(stage, GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV);
    glCombinerOutputNV(stage, GL_RGB, GL_DISCARD_NV, GL_DISCARD_NV, sums[i], GL_NONE, GL_NONE,
                       GL_FALSE, GL_FALSE, GL_FALSE);
    noAlpha(stage);
  }
  final(GL_VARIABLE_A_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV);
  final(GL_VARIABLE_B_NV, GL_SPARE0_NV);
  final(GL_VARIABLE_C_NV, GL_ZERO);
  final(GL_VARIABLE_D_NV, GL_SPARE1_NV);
  opaque();
}

void glowByProgram() {
  useProgram("!!ARBfp1.0\n"
             "TEMP near, far, one, two;\n"
             "PARAM weight = program.env[0];\n"
             "TXP one, fragment.texcoord[0], texture[0], RECT;\n"
             "TXP two, fragment.texcoord[1], texture[1], RECT;\n"
             "MUL near, one, weight;\n"
             "MAD near, two, weight, near;\n"
             "TXP one, fragment.texcoord[2], texture[2], RECT;\n"
             "TXP two, fragment.texcoord[3], texture[3], RECT;\n"
             "MUL far, one, weight;\n"
             "MAD far, two, weight, far;\n"
             "ADD result.color.xyz, near, far;\n"
             "MOV result.color.w, {1}.x;\nEND");
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, kWeight, kWeight, kWeight, kWeight);
}

void drawGlow() {
  constexpr float kOffsets[4][2] = {{-6.5f, -6.5f}, {6.5f, -6.5f}, {-6.5f, 6.5f}, {6.5f, 6.5f}};
  glBegin(GL_QUADS);
  for (const auto &corner : {std::array{0.0f, 0.0f}, {1.0f, 0.0f}, {1.0f, 1.0f}, {0.0f, 1.0f}}) {
    for (GLenum unit = 0; unit < 4; ++unit)
      glMultiTexCoord2f(GL_TEXTURE0 + unit, corner[0] * kSize + kOffsets[unit][0],
                        corner[1] * kSize + kOffsets[unit][1]);
    glVertex2f(corner[0] * 2 - 1, corner[1] * 2 - 1);
  }
  glEnd();
}

} // namespace

const Technique kGlow = {"glow", makeGlowImage, glowByCombiners, glowByProgram, drawGlow};

} // namespace techniques
