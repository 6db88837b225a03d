// ATI_envmap_bumpmap: its state, errors and formats; random states are drawn and compared with
// plain C++.
#include "bump_map.h"

#include <cstdlib>
#include <string>

#include "../fixture.h"

namespace api {
namespace {

using bump::Images;
using bump::Kind;
using bump::State;
using BumpMatrix = std::array<GLfloat, 4>;

class EraBumpMaps : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_ATI_envmap_bumpmap");
  }
};

GLint environment(GLenum pname) {
  GLint value = -1;
  glGetTexEnviv(GL_TEXTURE_ENV, pname, &value);
  return value;
}

BumpMatrix matrixNow() {
  BumpMatrix matrix{};
  glGetTexBumpParameterfvATI(GL_BUMP_ROT_MATRIX_ATI, matrix.data());
  return matrix;
}

void setMatrix(const BumpMatrix &matrix) {
  glTexBumpParameterfvATI(GL_BUMP_ROT_MATRIX_ATI, matrix.data());
}

TEST_F(EraBumpMaps, InitialState) {
  GLint size = 0, count = 0;
  glGetTexBumpParameterivATI(GL_BUMP_ROT_MATRIX_SIZE_ATI, &size);
  glGetTexBumpParameterivATI(GL_BUMP_NUM_TEX_UNITS_ATI, &count);
  EXPECT_EQ(size, 4);
  ASSERT_GE(count, 1);
  ASSERT_LE(count, 32);
  std::vector<GLint> units(std::size_t(count), -1);
  glGetTexBumpParameterivATI(GL_BUMP_TEX_UNITS_ATI, units.data());
  for (int i = 0; i < count; ++i)
    EXPECT_EQ(units[std::size_t(i)], GL_TEXTURE0 + i);
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 0, 0, 1}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE0);
}

TEST_F(EraBumpMaps, StateIsOfTheUnit) {
  glActiveTexture(GL_TEXTURE1);
  setMatrix({0.5f, -0.25f, 2, 8});
  glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE2);
  const GLfloat bumps = GLfloat(GL_BUMP_ENVMAP_ATI);
  glTexEnvfv(GL_TEXTURE_ENV, GL_COMBINE_RGB, &bumps);
  EXPECT_EQ(matrixNow(), (BumpMatrix{0.5f, -0.25f, 2, 8}));
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE2);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_BUMP_ENVMAP_ATI);
  GLfloat asFloat = 0;
  glGetTexEnvfv(GL_TEXTURE_ENV, GL_COMBINE_RGB, &asFloat);
  EXPECT_EQ(asFloat, bumps);
  glActiveTexture(GL_TEXTURE0);
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 0, 0, 1}));
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE0);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  glActiveTexture(GL_TEXTURE1);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_INTERPOLATE);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_INTERPOLATE);
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE2) << "it is kept";
  const GLint integers[] = {2147483647, 0, -2147483647 - 1, 2147483647};
  GLint back[4] = {};
  glTexBumpParameterivATI(GL_BUMP_ROT_MATRIX_ATI, integers);
  glGetTexBumpParameterivATI(GL_BUMP_ROT_MATRIX_ATI, back);
  EXPECT_EQ(matrixNow()[0], 1.0f);
  EXPECT_EQ(matrixNow()[2], -1.0f);
  EXPECT_EQ(back[0], 2147483647);
  EXPECT_EQ(back[2], -2147483647 - 1);
  glActiveTexture(GL_TEXTURE0);
}

TEST_F(EraBumpMaps, Errors) {
  BumpMatrix matrix = {3, 3, 3, 3};
  GLint value = -1;
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glTexBumpParameterfvATI(GL_BUMP_ROT_MATRIX_SIZE_ATI, matrix.data()));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexBumpParameterivATI(GL_BUMP_TARGET_ATI, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetTexBumpParameterivATI(GL_BUMP_TARGET_ATI, &value));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetTexBumpParameterfvATI(GL_DUDV_ATI, matrix.data()));
  EXPECT_EQ(value, -1);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE0 + 32));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, 3));
  EXPECT_GL_ERROR(GL_INVALID_VALUE,
                  glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE0 + 31));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_BUMP_ENVMAP_ATI));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_BUMP_ENVMAP_ATI));
  glBegin(GL_POINTS);
  glTexBumpParameterfvATI(GL_BUMP_ROT_MATRIX_ATI, matrix.data());
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  glBegin(GL_POINTS);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_BUMP_ENVMAP_ATI);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 0, 0, 1}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE0);
  // This is a unit that only has coordinates in programs, if there is one.
  GLint units = 0, images = 0;
  glGetTexBumpParameterivATI(GL_BUMP_NUM_TEX_UNITS_ATI, &units);
  glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &images);
  if (images > units) {
    glActiveTexture(GL_TEXTURE0 + GLenum(units));
    EXPECT_GL_ERROR(GL_INVALID_VALUE,
                    glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_BUMP_ENVMAP_ATI));
    glActiveTexture(GL_TEXTURE0);
  }
}

TEST_F(EraBumpMaps, AttributesAndLists) {
  glPushAttrib(GL_TEXTURE_BIT); // before the first command of the extension
  setMatrix({2, 3, 4, 5});
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_BUMP_ENVMAP_ATI);
  glPushAttrib(GL_TEXTURE_BIT);
  setMatrix({6, 7, 8, 9});
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
  glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE1);
  glPopAttrib();
  EXPECT_EQ(matrixNow(), (BumpMatrix{2, 3, 4, 5}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_BUMP_ENVMAP_ATI);
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE0);
  glPopAttrib();
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 0, 0, 1}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  glNewList(1, GL_COMPILE);
  setMatrix({1, 2, 3, 4});
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_BUMP_ENVMAP_ATI);
  glTexEnvi(GL_TEXTURE_ENV, GL_BUMP_TARGET_ATI, GL_TEXTURE1);
  glEndList();
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 0, 0, 1}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_MODULATE);
  glCallList(1);
  EXPECT_EQ(matrixNow(), (BumpMatrix{1, 2, 3, 4}));
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_BUMP_ENVMAP_ATI);
  EXPECT_EQ(environment(GL_BUMP_TARGET_ATI), GL_TEXTURE1);
  glNewList(1, GL_COMPILE);
  glTexEnvi(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
  glEndList();
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_BUMP_ENVMAP_ATI);
  glCallList(1);
  EXPECT_EQ(environment(GL_COMBINE_RGB), GL_REPLACE);
  glDeleteLists(1, 1);
}

TEST_F(EraBumpMaps, ImagesOfOffsets) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLbyte bytes[] = {127, -127, 64, 0, -1, 1, -128, 100};
  EXPECT_NO_GL_ERROR(
      glTexImage2D(GL_TEXTURE_2D, 0, GL_DUDV_ATI, 2, 2, 0, GL_DUDV_ATI, GL_BYTE, bytes));
  GLint internal = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &internal);
  EXPECT_EQ(internal, GL_DUDV_ATI);
  std::array<GLfloat, 8> floats{};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DUDV_ATI, GL_FLOAT, floats.data());
  for (std::size_t i = 0; i < 8; ++i)
    EXPECT_NEAR(floats[i], std::max(GLfloat(bytes[i]) / 127, -1.0f), 1e-6f) << i;
  const GLfloat beyond[] = {2, -3};
  EXPECT_NO_GL_ERROR(glTexSubImage2D(GL_TEXTURE_2D, 0, 1, 0, 1, 1, GL_DUDV_ATI, GL_FLOAT, beyond));
  std::array<GLbyte, 8> back{};
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DUDV_ATI, GL_BYTE, back.data());
  EXPECT_EQ(back, (std::array<GLbyte, 8>{127, -127, 127, -127, -1, 1, -127, 100}));
  const GLushort halves[] = {65535, 0};
  EXPECT_NO_GL_ERROR(glTexImage2D(GL_TEXTURE_2D, 0, GL_DU8DV8_ATI, 1, 1, 0, GL_DUDV_ATI,
                                  GL_UNSIGNED_SHORT, halves));
  glGetTexImage(GL_TEXTURE_2D, 0, GL_DUDV_ATI, GL_FLOAT, floats.data());
  EXPECT_EQ(floats[0], 1.0f);
  EXPECT_EQ(floats[1], 0.0f);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_DUDV_ATI, GL_BYTE, bytes));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glTexImage2D(GL_TEXTURE_2D, 0, GL_DUDV_ATI, 1, 1, 0, GL_RGBA, GL_BYTE, bytes));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, floats.data()));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTexImage2D(GL_TEXTURE_2D, 0, GL_DUDV_ATI, 1, 1, 0, GL_DUDV_ATI,
                                                GL_RGBA, bytes));
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glDeleteTextures(1, &name);
}

int states() {
  const char *const count = std::getenv("BUMP_STATES");
  return count ? std::atoi(count) : 200;
}

TEST_F(EraBumpMaps, RandomStates) {
  std::mt19937 random(244);
  for (int i = 0; i < states() && !HasFailure(); ++i) {
    SCOPED_TRACE("state " + std::to_string(i));
    const Images images = bump::randomImages(random);
    const State state = bump::randomState(random);
    bump::define(images);
    bump::draw(state);
    EXPECT_LE(bump::difference(state, images), 3); // filters have eight bits
  }
}

/// Returns a state in which one unit bumps another by a constant offset.
State simple() {
  State state;
  state.units[0].kind = Kind::Bump;
  state.units[0].target = 1;
  state.units[0].matrix = {0.25f, 0, 0, 0.5f};
  state.units[1].kind = Kind::Colors;
  state.units[1].environment = GL_REPLACE;
  return state;
}

TEST_F(EraBumpMaps, MatrixAndTargetReachTheNextDraw) {
  std::mt19937 random(1);
  const Images images = bump::randomImages(random);
  bump::define(images);
  State state = simple();
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
  state.units[0].matrix = {0, 0.3f, -0.2f, 0};
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
  state.units[0].target = 2; // a unit that is not enabled
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
  state.units[0].kind = Kind::Colors; // fixed function of the host again
  state.units[0].environment = GL_REPLACE;
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
  state.units[0].kind = Kind::Off;
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
}

TEST_F(EraBumpMaps, InLists) {
  std::mt19937 random(2);
  const Images images = bump::randomImages(random);
  bump::define(images);
  const State state = simple();
  glNewList(1, GL_COMPILE);
  bump::draw(state);
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  for (int i = 0; i < 2; ++i) {
    glCallList(1);
    EXPECT_LE(bump::difference(state, images), 3);
  }
  glDeleteLists(1, 1);
}

TEST_F(EraBumpMaps, ProgramsOfFragmentsTakeItsPlace) {
  std::mt19937 random(3);
  const Images images = bump::randomImages(random);
  bump::define(images);
  const State state = simple();
  bump::draw(state);
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMOV result.color, {0, 1, 0, 1};\nEND");
  bump::draw(state);
  EXPECT_EQ(readPixel(16, 16), kGreenPixel);
  glDisable(kFragment);
  bump::draw(state);
  EXPECT_LE(bump::difference(state, images), 3);
}

} // namespace
} // namespace api
