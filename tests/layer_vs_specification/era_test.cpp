// Extensions of the era that today's hosts lack: fences, vertex array ranges, hints, shadows by
// SGI's names. Extensions that are announced work, and the entry points of others have no effect.
#include <cstdlib>
#include <cstring>
#include <string>

#include "fixture.h"

namespace api {
namespace {

bool has(const char *extension) { return epoxy_has_gl_extension(extension); }

class Era : public ApiTest {};

/// Draws a triangle over the whole framebuffer, in one color.
void fill(GLfloat red, GLfloat green) {
  glColor4f(red, green, 0, 1);
  glBegin(GL_TRIANGLES);
  glVertex2f(-1, -1);
  glVertex2f(3, -1);
  glVertex2f(-1, 3);
  glEnd();
}

TEST_F(Era, AnnouncedAsTheProfileHasThem) {
  BARE_HOST_DIFFERS("it announces its own");
  const char *const name = std::getenv("ARBITER_PROFILE");
  const std::string profile = name ? name : "r300";
  const bool nvidia = profile == "host" || profile == "nv40" || profile == "nv30";
  for (const char *const extension :
       {"GL_NV_fence", "GL_NV_vertex_array_range", "GL_NV_vertex_array_range2",
        "GL_NV_multisample_filter_hint", "GL_SGIX_depth_texture", "GL_SGIX_shadow",
        "GL_ARB_imaging", "GL_NV_point_sprite"})
    EXPECT_EQ(has(extension), nvidia) << extension;
  for (const char *const extension :
       {"GL_APPLE_fence", "GL_APPLE_vertex_array_range", "GL_APPLE_client_storage",
        "GL_APPLE_transform_hint", "GL_APPLE_float_pixels", "GL_APPLE_vertex_array_object",
        "GL_APPLE_texture_range"})
    EXPECT_EQ(has(extension), profile == "host") << extension;
  for (const char *const extension :
       {"GL_ATIX_texture_env_combine3", "GL_EXT_vertex_shader", "GL_ATI_envmap_bumpmap"})
    EXPECT_EQ(has(extension), profile == "host" || profile == "r300") << extension;
}

TEST_F(Era, NvFence) {
  NEEDS("GL_NV_fence");
  GLuint names[2] = {};
  glGenFencesNV(2, names);
  EXPECT_NE(names[0], names[1]);
  EXPECT_EQ(glIsFenceNV(names[0]), GL_FALSE) << "not set yet";
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, EXPECT_EQ(glTestFenceNV(names[0]), GL_TRUE));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glFinishFenceNV(names[0]));
  GLint value = -1;
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glGetFenceivNV(names[0], GL_FENCE_STATUS_NV, &value));
  EXPECT_EQ(value, -1);

  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  fill(1, 0);
  glSetFenceNV(names[0], GL_ALL_COMPLETED_NV);
  EXPECT_EQ(glIsFenceNV(names[0]), GL_TRUE);
  glGetFenceivNV(names[0], GL_FENCE_CONDITION_NV, &value);
  EXPECT_EQ(value, GL_ALL_COMPLETED_NV);
  glFinishFenceNV(names[0]);
  EXPECT_EQ(glTestFenceNV(names[0]), GL_TRUE);
  glGetFenceivNV(names[0], GL_FENCE_STATUS_NV, &value);
  EXPECT_EQ(value, GL_TRUE);
  EXPECT_EQ(readPixel()[0], 255);

  EXPECT_GL_ERROR(GL_INVALID_ENUM, glSetFenceNV(names[1], GL_FENCE_STATUS_NV));
  EXPECT_EQ(glIsFenceNV(names[1]), GL_FALSE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetFenceivNV(names[0], GL_ALL_COMPLETED_NV, &value));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGenFencesNV(-1, names));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glDeleteFencesNV(-1, names));
  glSetFenceNV(names[0] + 100, GL_ALL_COMPLETED_NV);
  EXPECT_EQ(glIsFenceNV(names[0] + 100), GL_TRUE) << "a name need not come from GenFences";
  const GLuint all[] = {names[0], names[1], names[0] + 100, 12345};
  glDeleteFencesNV(4, all);
  EXPECT_EQ(glIsFenceNV(names[0]), GL_FALSE);
}

// TestFence needs no other call before it returns true. NVIDIA's present drivers do, after a flush
// too.
TEST_F(Era, TestFenceAloneEventuallyReturnsTrue) {
  NEEDS("GL_NV_fence");
  GLuint name = 0;
  glGenFencesNV(1, &name);
  fill(0, 1);
  glSetFenceNV(name, GL_ALL_COMPLETED_NV);
  int tests = 0;
  while (glTestFenceNV(name) == GL_FALSE && tests < 10'000'000)
    ++tests;
  EXPECT_LT(tests, 10'000'000);
  glDeleteFencesNV(1, &name);
}

TEST_F(Era, FencesHaveTheirPlaceInLists) {
  NEEDS("GL_NV_fence");
  glNewList(1, GL_COMPILE);
  fill(1, 1);
  glSetFenceNV(7, GL_ALL_COMPLETED_NV);
  EXPECT_EQ(glIsFenceNV(7), GL_FALSE);
  glEndList();
  EXPECT_EQ(glIsFenceNV(7), GL_FALSE) << "compiled, not called";
  glCallList(1);
  EXPECT_EQ(glIsFenceNV(7), GL_TRUE);
  glFinishFenceNV(7);
  glDeleteLists(1, 1);
  const GLuint name = 7;
  glDeleteFencesNV(1, &name);
}

TEST_F(Era, AWrongConditionIsAnErrorOfTheCall) {
  NEEDS("GL_NV_fence");
  glNewList(1, GL_COMPILE);
  EXPECT_NO_GL_ERROR(glSetFenceNV(7, GL_FENCE_STATUS_NV));
  glEndList();
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glCallList(1));
  EXPECT_EQ(glIsFenceNV(7), GL_FALSE);
  glBegin(GL_POINTS);
  glSetFenceNV(7, GL_FENCE_STATUS_NV);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  glDeleteLists(1, 1);
}

TEST_F(Era, AFenceIsTestedWhileAListIsCompiled) {
  NEEDS("GL_NV_fence");
  fill(1, 0);
  glSetFenceNV(7, GL_ALL_COMPLETED_NV);
  glNewList(1, GL_COMPILE);
  fill(0, 1);
  glFinishFenceNV(7);
  EXPECT_EQ(glTestFenceNV(7), GL_TRUE) << "executed at once";
  const GLuint name = 7;
  glDeleteFencesNV(1, &name);
  EXPECT_EQ(glIsFenceNV(7), GL_FALSE);
  glEndList();
  EXPECT_EQ(readPixel()[0], 255);
  glCallList(1);
  EXPECT_EQ(readPixel()[1], 255);
  EXPECT_EQ(glIsFenceNV(7), GL_FALSE) << "nothing of it is in the list";
  glDeleteLists(1, 1);
}

TEST_F(Era, FencesAreOfOneContext) {
  NEEDS("GL_NV_fence");
  glSetFenceNV(7, GL_ALL_COMPLETED_NV);
  {
    const GlContext other(&m_context);
    other.makeCurrent();
    EXPECT_EQ(glIsFenceNV(7), GL_FALSE);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glFinishFenceNV(7));
    glSetFenceNV(9, GL_ALL_COMPLETED_NV); // deleted with the context
    m_context.makeCurrent();
  }
  EXPECT_EQ(glIsFenceNV(7), GL_TRUE);
  EXPECT_EQ(glIsFenceNV(9), GL_FALSE);
  glFinishFenceNV(7);
  const GLuint name = 7;
  glDeleteFencesNV(1, &name);
}

TEST_F(Era, NoFencesBetweenBeginAndEnd) {
  NEEDS("GL_NV_fence");
  GLuint name = 99;
  glBegin(GL_TRIANGLES);
  glSetFenceNV(1, GL_ALL_COMPLETED_NV);
  glGenFencesNV(1, &name);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(name, 99u);
  EXPECT_EQ(glIsFenceNV(1), GL_FALSE);
}

TEST_F(Era, AppleFence) {
  NEEDS("GL_APPLE_fence");
  GLuint name = 0, texture = 0;
  glGenFencesAPPLE(1, &name);
  EXPECT_EQ(glIsFenceAPPLE(name), GL_FALSE);
  EXPECT_EQ(glTestFenceAPPLE(name), GL_TRUE) << "never set: as if it were done";
  glFinishFenceAPPLE(name);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, EXPECT_EQ(glTestFenceAPPLE(name + 9), GL_TRUE));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glFinishFenceAPPLE(name + 9));
  fill(1, 0);
  glSetFenceAPPLE(name);
  EXPECT_EQ(glIsFenceAPPLE(name), GL_TRUE);
  glFinishObjectAPPLE(GL_FENCE_APPLE, GLint(name));
  EXPECT_EQ(glTestObjectAPPLE(GL_FENCE_APPLE, name), GL_TRUE);
  glGenTextures(1, &texture);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glFinishObjectAPPLE(GL_TEXTURE, GLint(texture)));
  glBindTexture(GL_TEXTURE_2D, texture);
  EXPECT_NO_GL_ERROR(glFinishObjectAPPLE(GL_TEXTURE, GLint(texture)));
  EXPECT_NO_GL_ERROR(glFinishObjectAPPLE(GL_DRAW_PIXELS_APPLE, 0));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, EXPECT_EQ(glTestObjectAPPLE(GL_BUFFER, 0), GL_TRUE));
  glDeleteTextures(1, &texture);
  glDeleteFencesAPPLE(1, &name);
  EXPECT_EQ(glIsFenceAPPLE(name), GL_FALSE);
}

TEST_F(Era, NvVertexArrayRange) {
  NEEDS("GL_NV_vertex_array_range");
  alignas(32) GLfloat vertices[] = {-1, -1, 3, -1, -1, 3};
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), 0);
  EXPECT_GE(integer(GL_MAX_VERTEX_ARRAY_RANGE_ELEMENT_NV), 65535);
  EXPECT_EQ(glIsEnabled(GL_VERTEX_ARRAY_RANGE_NV), GL_FALSE);
  glVertexArrayRangeNV(sizeof vertices, vertices);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), GLint(sizeof vertices));
  void *pointer = nullptr;
  glGetPointerv(GL_VERTEX_ARRAY_RANGE_POINTER_NV, &pointer);
  EXPECT_EQ(pointer, vertices);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_VALID_NV), 0) << "neither enabled";
  glEnableClientState(GL_VERTEX_ARRAY_RANGE_NV);
  EXPECT_EQ(glIsEnabled(GL_VERTEX_ARRAY_RANGE_NV), GL_TRUE);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_VALID_NV), 0) << "without VERTEX_ARRAY";
  glVertexPointer(2, GL_FLOAT, 0, vertices);
  glEnableClientState(GL_VERTEX_ARRAY);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_VALID_NV), 1);
  glColor4f(0, 1, 0, 1);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFlushVertexArrayRangeNV();
  EXPECT_EQ(readPixel()[1], 255);

  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glVertexArrayRangeNV(0, nullptr);
  glDisableClientState(GL_VERTEX_ARRAY_RANGE_NV);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_VALID_NV), 0);
  glPopClientAttrib();
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_VALID_NV), 1);
  glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  glVertexArrayRangeNV(8, vertices);
  glPopClientAttrib();
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), 8) << "of another group";

  EXPECT_GL_ERROR(GL_INVALID_VALUE, glVertexArrayRangeNV(-1, vertices));
  glBegin(GL_POINTS);
  glVertexArrayRangeNV(4, vertices);
  glFlushVertexArrayRangeNV();
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), 8);
  glDisableClientState(GL_VERTEX_ARRAY_RANGE_WITHOUT_FLUSH_NV);
  EXPECT_EQ(glIsEnabled(GL_VERTEX_ARRAY_RANGE_NV), GL_FALSE);
  glDisableClientState(GL_VERTEX_ARRAY);
}

TEST_F(Era, ARangeIsNoPartOfAList) {
  NEEDS("GL_NV_vertex_array_range");
  GLfloat memory[4] = {};
  glNewList(1, GL_COMPILE);
  glVertexArrayRangeNV(sizeof memory, memory);
  glEndList();
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), GLint(sizeof memory)) << "executed at once";
  glVertexArrayRangeNV(0, nullptr);
  glCallList(1);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_NV), 0);
  glDeleteLists(1, 1);
}

TEST_F(Era, AppleVertexArrayRange) {
  NEEDS("GL_APPLE_vertex_array_range");
  GLfloat vertices[] = {-1, -1, 3, -1, -1, 3};
  glVertexArrayRangeAPPLE(sizeof vertices, vertices);
  glEnableClientState(GL_VERTEX_ARRAY_RANGE_APPLE);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_STORAGE_HINT_APPLE), GL_STORAGE_CLIENT_APPLE);
  glVertexArrayParameteriAPPLE(GL_VERTEX_ARRAY_STORAGE_HINT_APPLE, GL_STORAGE_CACHED_APPLE);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_STORAGE_HINT_APPLE), GL_STORAGE_CACHED_APPLE);
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glVertexArrayParameteriAPPLE(GL_VERTEX_ARRAY_STORAGE_HINT_APPLE, GL_TRUE));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glVertexArrayParameteriAPPLE(GL_VERTEX_ARRAY_RANGE_APPLE,
                                                                GL_STORAGE_CACHED_APPLE));
  EXPECT_NO_GL_ERROR(glFlushVertexArrayRangeAPPLE(8, vertices));
  glDisableClientState(GL_VERTEX_ARRAY_RANGE_APPLE);
}

void testHint(GLenum target) {
  EXPECT_EQ(integer(target), GL_DONT_CARE);
  glPushAttrib(GL_HINT_BIT);
  glHint(target, GL_NICEST);
  EXPECT_EQ(integer(target), GL_NICEST);
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glHint(target, GL_TRUE));
  glNewList(1, GL_COMPILE);
  glHint(target, GL_FASTEST);
  glEndList();
  EXPECT_EQ(integer(target), GL_NICEST);
  glCallList(1);
  EXPECT_EQ(integer(target), GL_FASTEST);
  glPopAttrib();
  EXPECT_EQ(integer(target), GL_DONT_CARE);
  glPushAttrib(GL_ENABLE_BIT);
  glCallList(1);
  glPopAttrib();
  EXPECT_EQ(integer(target), GL_FASTEST) << "of another group";
  glBegin(GL_POINTS);
  glHint(target, GL_NICEST);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(target), GL_FASTEST);
  glDeleteLists(1, 1);
}

TEST_F(Era, MultisampleFilterHint) {
  NEEDS("GL_NV_multisample_filter_hint");
  testHint(GL_MULTISAMPLE_FILTER_HINT_NV);
}

TEST_F(Era, TransformHint) {
  NEEDS("GL_APPLE_transform_hint");
  testHint(GL_TRANSFORM_HINT_APPLE);
}

TEST_F(Era, ClientStorage) {
  NEEDS("GL_APPLE_client_storage");
  EXPECT_EQ(integer(GL_UNPACK_CLIENT_STORAGE_APPLE), GL_FALSE);
  glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  glPixelStorei(GL_UNPACK_CLIENT_STORAGE_APPLE, GL_TRUE);
  EXPECT_EQ(integer(GL_UNPACK_CLIENT_STORAGE_APPLE), GL_TRUE);
  const GLubyte texels[] = {10, 20, 30, 40};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  GLubyte read[4] = {};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(std::memcmp(read, texels, 4), 0);
  glPixelStoref(GL_UNPACK_CLIENT_STORAGE_APPLE, 0);
  EXPECT_EQ(integer(GL_UNPACK_CLIENT_STORAGE_APPLE), GL_FALSE);
  glPixelStorei(GL_UNPACK_CLIENT_STORAGE_APPLE, GL_TRUE);
  glPopClientAttrib();
  EXPECT_EQ(integer(GL_UNPACK_CLIENT_STORAGE_APPLE), GL_FALSE);
}

TEST_F(Era, FloatPixels) {
  NEEDS("GL_APPLE_float_pixels");
  const GLushort halves[] = {0x3C00, 0xC000, 0x3800, 0x4400}; // 1, -2, 0.5, 4
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA_FLOAT16_APPLE, 1, 1, 0, GL_RGBA, GL_HALF_APPLE, halves);
  GLfloat read[4] = {};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_FLOAT, read);
  const GLfloat expected[] = {1, -2, 0.5f, 4};
  EXPECT_EQ(std::memcmp(read, expected, sizeof read), 0);
}

/// Samples a 1x1 depth texture of one half at r, and returns the comparison's result.
GLubyte shadowAt(GLfloat r) {
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  glTexCoord3f(0, 0, r);
  fill(1, 1);
  glDisable(GL_TEXTURE_2D);
  return readPixel()[0];
}

TEST_F(Era, SgixShadow) {
  NEEDS("GL_SGIX_shadow");
  const GLfloat depth = 0.5f;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24_SGIX, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &depth);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  GLint value = -1;
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, &value);
  EXPECT_EQ(value, GL_FALSE);
  glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, &value);
  EXPECT_EQ(value, GL_TEXTURE_LEQUAL_R_SGIX);
  EXPECT_NEAR(shadowAt(0.25f), 128, 1) << "the depth itself";

  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, GL_TRUE);
  EXPECT_EQ(shadowAt(0.25f), 255) << "nearer than the depth: lit";
  EXPECT_EQ(shadowAt(0.75f), 0);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, GL_TEXTURE_GEQUAL_R_SGIX);
  EXPECT_EQ(shadowAt(0.25f), 0);
  EXPECT_EQ(shadowAt(0.75f), 255);
  GLfloat number = -1;
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, &number);
  EXPECT_EQ(number, GLfloat(GL_TEXTURE_GEQUAL_R_SGIX));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, GL_LEQUAL));
  const GLint off = GL_FALSE;
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, &off);
  EXPECT_NEAR(shadowAt(0.25f), 128, 1);
  const GLint operation = GL_TEXTURE_LEQUAL_R_SGIX;
  glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, &operation);
  glNewList(1, GL_COMPILE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, GL_TRUE);
  glEndList();
  EXPECT_NEAR(shadowAt(0.25f), 128, 1);
  glCallList(1);
  EXPECT_EQ(shadowAt(0.75f), 0);
  glDeleteLists(1, 1);
}

} // namespace
} // namespace api
