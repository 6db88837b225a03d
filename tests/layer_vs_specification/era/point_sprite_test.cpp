// NV_point_sprite: the state POINT_SPRITE_R_MODE_NV.
#include "point_sprites.h"

namespace api {
namespace {

TEST_F(EraPointSprites, State) {
  EXPECT_EQ(rMode(), GL_ZERO);
  EXPECT_EQ(glIsEnabled(GL_POINT_SPRITE_NV), GL_FALSE);
  EXPECT_EQ(replaces(), GL_FALSE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  EXPECT_EQ(rMode(), GL_S);
  const GLint r = GL_R;
  glPointParameterivNV(GL_POINT_SPRITE_R_MODE_NV, &r);
  EXPECT_EQ(rMode(), GL_R);
  glPointParameterf(GL_POINT_SPRITE_R_MODE_NV, GLfloat(GL_S));
  EXPECT_EQ(rMode(), GL_S);
  const GLfloat zero = 0;
  glPointParameterfv(GL_POINT_SPRITE_R_MODE_NV, &zero);
  EXPECT_EQ(rMode(), GL_ZERO);
  GLfloat asFloat = -1;
  GLdouble asDouble = -1;
  GLboolean asBoolean = GL_TRUE;
  glGetFloatv(GL_POINT_SPRITE_R_MODE_NV, &asFloat);
  glGetDoublev(GL_POINT_SPRITE_R_MODE_NV, &asDouble);
  glGetBooleanv(GL_POINT_SPRITE_R_MODE_NV, &asBoolean);
  EXPECT_EQ(asFloat, 0.0f);
  EXPECT_EQ(asDouble, 0.0);
  EXPECT_EQ(asBoolean, GL_FALSE);
  glPointParameteriNV(GL_POINT_SIZE_MIN, 2); // the others are unchanged
  GLfloat least = 0;
  glGetFloatv(GL_POINT_SIZE_MIN, &least);
  EXPECT_EQ(least, 2.0f);
}

TEST_F(EraPointSprites, Errors) {
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_T));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glPointParameterf(GL_POINT_SPRITE_R_MODE_NV, -1));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glPointParameteriNV(GL_TEXTURE_2D, GL_S));
  glBegin(GL_POINTS);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_R);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(rMode(), GL_S);
}

TEST_F(EraPointSprites, AttributesOfPoints) {
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_R);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_TRUE);
  glPushAttrib(GL_POINT_BIT);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_FALSE);
  glPopAttrib();
  EXPECT_EQ(rMode(), GL_R);
  EXPECT_EQ(replaces(), GL_TRUE);
  glPushAttrib(GL_TEXTURE_BIT | GL_ENABLE_BIT);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  glPopAttrib();
  EXPECT_EQ(rMode(), GL_S);
}

TEST_F(EraPointSprites, ListsHoldTheMode) {
  glNewList(1, GL_COMPILE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_R);
  glEndList();
  EXPECT_EQ(rMode(), GL_ZERO);
  glCallList(1);
  EXPECT_EQ(rMode(), GL_R);
  glNewList(1, GL_COMPILE_AND_EXECUTE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_S);
  glTexEnvi(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, GL_TRUE);
  glEndList();
  EXPECT_EQ(rMode(), GL_S);
  EXPECT_EQ(replaces(), GL_TRUE);
  glNewList(1, GL_COMPILE);
  glPointParameteriNV(GL_POINT_SPRITE_R_MODE_NV, GL_T);
  glEndList();
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCallList(1));
  glDeleteLists(1, 1);
}

} // namespace
} // namespace api
