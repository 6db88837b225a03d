// Apple's vertex array objects and texture ranges: object state that today's hosts lack.
#include <cstring>

#include "fixture.h"

namespace api {
namespace {

class EraObjects : public ApiTest {};

GLint texParameter(GLenum target, GLenum pname) {
  GLint value = -1;
  glGetTexParameteriv(target, pname, &value);
  return value;
}

void *rangePointer(GLenum target) {
  void *pointer = &pointer;
  glGetTexParameterPointervAPPLE(target, GL_TEXTURE_RANGE_POINTER_APPLE, &pointer);
  return pointer;
}

void *pointerOf(GLenum array) {
  void *pointer = nullptr;
  glGetPointerv(array, &pointer);
  return pointer;
}

/// Rectangles of the left and of the right half, in the application's memory.
const GLfloat kLeft[] = {-1, -1, 0, -1, 0, 1, -1, 1};
const GLfloat kRight[] = {0, -1, 1, -1, 1, 1, 0, 1};
const GLubyte kRedCorners[] = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};

TEST_F(EraObjects, AnObjectHasArraysInTheApplicationsMemory) {
  NEEDS("GL_APPLE_vertex_array_object");
  GLuint names[2] = {};
  glGenVertexArraysAPPLE(2, names);
  EXPECT_EQ(glIsVertexArrayAPPLE(names[0]), GL_FALSE) << "not bound yet";
  glVertexPointer(2, GL_FLOAT, 0, kRight); // in the default object
  glEnableClientState(GL_VERTEX_ARRAY);
  glColor4f(0, 1, 0, 1);

  glBindVertexArrayAPPLE(names[0]);
  EXPECT_EQ(glIsVertexArrayAPPLE(names[0]), GL_TRUE);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), GLint(names[0]));
  EXPECT_EQ(glIsEnabled(GL_VERTEX_ARRAY), GL_FALSE) << "as at initialisation";
  EXPECT_EQ(pointerOf(GL_VERTEX_ARRAY_POINTER), nullptr);
  EXPECT_NO_GL_ERROR(glVertexPointer(2, GL_FLOAT, 0, kLeft));
  glEnableClientState(GL_VERTEX_ARRAY);
  EXPECT_NO_GL_ERROR(glColorPointer(4, GL_UNSIGNED_BYTE, 0, kRedCorners));
  glEnableClientState(GL_COLOR_ARRAY);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(8, 16)[0], 255);
  EXPECT_EQ(readPixel(24, 16)[3], 0);

  glBindVertexArrayAPPLE(0);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 0);
  EXPECT_EQ(pointerOf(GL_VERTEX_ARRAY_POINTER), kRight);
  EXPECT_EQ(glIsEnabled(GL_COLOR_ARRAY), GL_FALSE);
  clear();
  glColor4f(0, 1, 0, 1);
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(8, 16)[3], 0);
  EXPECT_EQ(readPixel(24, 16)[1], 255);

  glBindVertexArrayAPPLE(names[0]);
  EXPECT_EQ(pointerOf(GL_COLOR_ARRAY_POINTER), kRedCorners);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(8, 16)[0], 255);
  glDeleteVertexArraysAPPLE(2, names);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 0) << "it was bound";
  EXPECT_EQ(glIsVertexArrayAPPLE(names[0]), GL_FALSE);
  EXPECT_EQ(pointerOf(GL_VERTEX_ARRAY_POINTER), kRight);
  glDisableClientState(GL_VERTEX_ARRAY);
}

TEST_F(EraObjects, AllArraysAreOfTheObject) {
  NEEDS("GL_APPLE_vertex_array_object");
  GLuint buffer = 0, elements = 0;
  glGenBuffers(1, &buffer);
  glGenBuffers(1, &elements);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 256, nullptr, GL_STATIC_DRAW);
  glBindVertexArrayAPPLE(77); // a name need not be generated
  glVertexAttribPointer(3, 2, GL_SHORT, GL_TRUE, 12, reinterpret_cast<void *>(8));
  glVertexAttribDivisor(3, 5);
  glEnableVertexAttribArray(3);
  glClientActiveTexture(GL_TEXTURE2);
  glTexCoordPointer(3, GL_FLOAT, 24, reinterpret_cast<void *>(4));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  glClientActiveTexture(GL_TEXTURE0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  GLfloat memory[16] = {};
  glNormalPointer(GL_SHORT, 6, memory);
  glSecondaryColorPointer(3, GL_FLOAT, 12, memory);
  glFogCoordPointer(GL_FLOAT, 4, memory + 1);
  glIndexPointer(GL_SHORT, 2, memory + 2);
  glEdgeFlagPointer(1, memory + 3);
  glEnableClientState(GL_EDGE_FLAG_ARRAY);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);

  for (int turn = 0; turn < 2; ++turn) {
    glBindVertexArrayAPPLE(turn == 0 ? 0 : 78);
    GLint value = -1;
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &value);
    EXPECT_EQ(value, 0);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &value);
    EXPECT_EQ(value, 0);
    EXPECT_EQ(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), 0);
    EXPECT_EQ(integer(GL_NORMAL_ARRAY_TYPE), GL_FLOAT);
    EXPECT_EQ(pointerOf(GL_SECONDARY_COLOR_ARRAY_POINTER), nullptr);
    EXPECT_EQ(glIsEnabled(GL_EDGE_FLAG_ARRAY), GL_FALSE);
    glBindVertexArrayAPPLE(77);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &value);
    EXPECT_EQ(value, 1);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_DIVISOR, &value);
    EXPECT_EQ(value, 5);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_TYPE, &value);
    EXPECT_EQ(value, GL_SHORT);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_NORMALIZED, &value);
    EXPECT_EQ(value, 1);
    glGetVertexAttribiv(3, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &value);
    EXPECT_EQ(value, GLint(buffer));
    void *pointer = nullptr;
    glGetVertexAttribPointerv(3, GL_VERTEX_ATTRIB_ARRAY_POINTER, &pointer);
    EXPECT_EQ(pointer, reinterpret_cast<void *>(8));
    EXPECT_EQ(integer(GL_ELEMENT_ARRAY_BUFFER_BINDING), GLint(elements));
    EXPECT_EQ(integer(GL_ARRAY_BUFFER_BINDING), 0) << "is of no object";
    EXPECT_EQ(integer(GL_NORMAL_ARRAY_TYPE), GL_SHORT);
    EXPECT_EQ(integer(GL_NORMAL_ARRAY_STRIDE), 6);
    EXPECT_EQ(pointerOf(GL_SECONDARY_COLOR_ARRAY_POINTER), memory);
    EXPECT_EQ(pointerOf(GL_FOG_COORD_ARRAY_POINTER), memory + 1);
    EXPECT_EQ(pointerOf(GL_INDEX_ARRAY_POINTER), memory + 2);
    EXPECT_EQ(pointerOf(GL_EDGE_FLAG_ARRAY_POINTER), memory + 3);
    EXPECT_EQ(glIsEnabled(GL_EDGE_FLAG_ARRAY), GL_TRUE);
    EXPECT_EQ(integer(GL_CLIENT_ACTIVE_TEXTURE), GL_TEXTURE0);
    glClientActiveTexture(GL_TEXTURE2);
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_SIZE), 3);
    EXPECT_EQ(integer(GL_TEXTURE_COORD_ARRAY_BUFFER_BINDING), GLint(buffer));
    EXPECT_EQ(glIsEnabled(GL_TEXTURE_COORD_ARRAY), GL_TRUE);
    glClientActiveTexture(GL_TEXTURE0);
  }
  const GLuint names[] = {77, 78};
  glDeleteVertexArraysAPPLE(2, names);
  glDeleteBuffers(1, &buffer);
  glDeleteBuffers(1, &elements);
}

TEST_F(EraObjects, BindingPointsAreOfTheObject) {
  NEEDS("GL_APPLE_vertex_array_object");
  NEEDS("GL_ARB_vertex_attrib_binding");
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, 256, nullptr, GL_STATIC_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArrayAPPLE(5);
  glVertexAttribFormat(2, 3, GL_FLOAT, GL_FALSE, 20);
  glVertexAttribBinding(2, 7);
  glBindVertexBuffer(7, buffer, 32, 28);
  glVertexBindingDivisor(7, 2);
  glBindVertexArrayAPPLE(0);
  GLint value = -1;
  glGetVertexAttribiv(2, GL_VERTEX_ATTRIB_BINDING, &value);
  EXPECT_EQ(value, 2);
  glBindVertexArrayAPPLE(5);
  glGetVertexAttribiv(2, GL_VERTEX_ATTRIB_BINDING, &value);
  EXPECT_EQ(value, 7);
  glGetVertexAttribiv(2, GL_VERTEX_ATTRIB_RELATIVE_OFFSET, &value);
  EXPECT_EQ(value, 20);
  glGetVertexAttribiv(2, GL_VERTEX_ATTRIB_ARRAY_SIZE, &value);
  EXPECT_EQ(value, 3);
  GLint64 offset = -1;
  glGetInteger64i_v(GL_VERTEX_BINDING_OFFSET, 7, &offset);
  EXPECT_EQ(offset, 32);
  glGetIntegeri_v(GL_VERTEX_BINDING_STRIDE, 7, &value);
  EXPECT_EQ(value, 28);
  glGetIntegeri_v(GL_VERTEX_BINDING_DIVISOR, 7, &value);
  EXPECT_EQ(value, 2);
  const GLuint name = 5;
  glDeleteVertexArraysAPPLE(1, &name);
  glGetVertexAttribiv(2, GL_VERTEX_ATTRIB_BINDING, &value);
  EXPECT_EQ(value, 2);
  glDeleteBuffers(1, &buffer);
}

TEST_F(EraObjects, BothKindsShareNames) {
  NEEDS("GL_APPLE_vertex_array_object");
  glBindVertexArrayAPPLE(1);
  glVertexPointer(2, GL_FLOAT, 0, kLeft);
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  EXPECT_NE(name, 1u) << "in use";
  glBindVertexArray(name); // an ARB object, because of its first bind
  glPushClientAttrib(GL_CLIENT_PIXEL_STORE_BIT);
  glBindVertexArrayAPPLE(3);
  glPopClientAttrib();
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 3) << "of another group";
  const GLuint names[] = {3, 4};
  glDeleteVertexArraysAPPLE(2, names);
}

TEST_F(EraObjects, AnObjectHasItsRange) {
  NEEDS("GL_APPLE_vertex_array_object");
  NEEDS("GL_APPLE_vertex_array_range");
  GLfloat memory[4] = {};
  glVertexArrayRangeAPPLE(16, memory);
  glBindVertexArrayAPPLE(9);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_APPLE), 0);
  glVertexArrayRangeAPPLE(8, memory + 1);
  glBindVertexArrayAPPLE(0);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_APPLE), 16);
  EXPECT_EQ(pointerOf(GL_VERTEX_ARRAY_RANGE_POINTER_APPLE), memory);
  glBindVertexArrayAPPLE(9);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_RANGE_LENGTH_APPLE), 8);
  EXPECT_EQ(pointerOf(GL_VERTEX_ARRAY_RANGE_POINTER_APPLE), memory + 1);
  const GLuint name = 9;
  glDeleteVertexArraysAPPLE(1, &name);
}

TEST_F(EraObjects, ObjectsAreOfOneContextAndOutsideOfPrimitives) {
  NEEDS("GL_APPLE_vertex_array_object");
  glNewList(1, GL_COMPILE);
  glBindVertexArrayAPPLE(6);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 6) << "executed at once";
  glEndList();
  glBindVertexArrayAPPLE(0);
  glCallList(1);
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 0);
  glDeleteLists(1, 1);
  glBegin(GL_POINTS);
  glBindVertexArrayAPPLE(6);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(integer(GL_VERTEX_ARRAY_BINDING_APPLE), 0);
  {
    const GlContext other(&m_context);
    other.makeCurrent();
    EXPECT_EQ(glIsVertexArrayAPPLE(6), GL_FALSE);
    m_context.makeCurrent();
  }
  EXPECT_EQ(glIsVertexArrayAPPLE(6), GL_TRUE);
  GLuint names[] = {6};
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glGenVertexArraysAPPLE(-1, names));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glDeleteVertexArraysAPPLE(-1, names));
  EXPECT_EQ(glIsVertexArrayAPPLE(6), GL_TRUE);
  glDeleteVertexArraysAPPLE(1, names);
}

TEST_F(EraObjects, ATextureHasARange) {
  NEEDS("GL_APPLE_texture_range");
  GLubyte memory[64] = {};
  GLuint names[2] = {};
  glGenTextures(2, names);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  EXPECT_EQ(rangePointer(GL_TEXTURE_2D), nullptr);
  EXPECT_EQ(texParameter(GL_TEXTURE_2D, GL_TEXTURE_RANGE_LENGTH_APPLE), 0);
  EXPECT_EQ(texParameter(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE), GL_STORAGE_PRIVATE_APPLE);
  glTextureRangeAPPLE(GL_TEXTURE_2D, sizeof memory, memory);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE, GL_STORAGE_SHARED_APPLE);
  glBindTexture(GL_TEXTURE_2D, names[1]);
  EXPECT_EQ(rangePointer(GL_TEXTURE_2D), nullptr) << "of another texture";
  const GLfloat cached = GL_STORAGE_CACHED_APPLE;
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE, &cached);
  GLfloat value = 0;
  glGetTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE, &value);
  EXPECT_EQ(value, cached);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  EXPECT_EQ(rangePointer(GL_TEXTURE_2D), memory);
  EXPECT_EQ(texParameter(GL_TEXTURE_2D, GL_TEXTURE_RANGE_LENGTH_APPLE), GLint(sizeof memory));
  EXPECT_EQ(texParameter(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE), GL_STORAGE_SHARED_APPLE);
  {
    const GlContext other(&m_context);
    other.makeCurrent();
    glBindTexture(GL_TEXTURE_2D, names[0]);
    EXPECT_EQ(rangePointer(GL_TEXTURE_2D), memory) << "textures are shared";
    m_context.makeCurrent();
  }
  // The memory belongs to the application; an image in it is read when it is specified.
  memory[0] = 200;
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, memory);
  memory[0] = 0;
  GLubyte read[4] = {};
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, read);
  EXPECT_EQ(read[0], 200);
  glDeleteTextures(2, names);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  EXPECT_EQ(rangePointer(GL_TEXTURE_2D), nullptr) << "a new object of the name";
  glDeleteTextures(1, names);
}

TEST_F(EraObjects, ATexturesRangeIsInListsAndOnTheStack) {
  NEEDS("GL_APPLE_texture_range");
  GLubyte memory[64] = {};
  glNewList(1, GL_COMPILE);
  glTextureRangeAPPLE(GL_TEXTURE_1D, 8, memory);
  glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_STORAGE_HINT_APPLE, GL_STORAGE_CACHED_APPLE);
  glEndList();
  EXPECT_EQ(rangePointer(GL_TEXTURE_1D), nullptr);
  glPushAttrib(GL_TEXTURE_BIT);
  glCallList(1);
  EXPECT_EQ(rangePointer(GL_TEXTURE_1D), memory);
  EXPECT_EQ(texParameter(GL_TEXTURE_1D, GL_TEXTURE_STORAGE_HINT_APPLE), GL_STORAGE_CACHED_APPLE);
  glPushAttrib(GL_TEXTURE_BIT);
  glTextureRangeAPPLE(GL_TEXTURE_1D, 9, memory + 1);
  glPopAttrib();
  EXPECT_EQ(rangePointer(GL_TEXTURE_1D), memory);
  EXPECT_EQ(texParameter(GL_TEXTURE_1D, GL_TEXTURE_RANGE_LENGTH_APPLE), 8);
  glPopAttrib();
  EXPECT_EQ(rangePointer(GL_TEXTURE_1D), nullptr);
  EXPECT_EQ(texParameter(GL_TEXTURE_1D, GL_TEXTURE_STORAGE_HINT_APPLE), GL_STORAGE_PRIVATE_APPLE);
  glPushAttrib(GL_ENABLE_BIT);
  glCallList(1);
  glPopAttrib();
  EXPECT_EQ(rangePointer(GL_TEXTURE_1D), memory) << "of another group";
  glTextureRangeAPPLE(GL_TEXTURE_1D, 0, nullptr);
  glDeleteLists(1, 1);
}

TEST_F(EraObjects, ErrorsOfTextureRanges) {
  NEEDS("GL_APPLE_texture_range");
  GLubyte memory[4] = {};
  void *pointer = nullptr;
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glTextureRangeAPPLE(GL_TEXTURE_ENV, 4, memory));
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glTextureRangeAPPLE(GL_TEXTURE_2D, -1, memory));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetTexParameterPointervAPPLE(
                                       GL_TEXTURE_ENV, GL_TEXTURE_RANGE_POINTER_APPLE, &pointer));
  EXPECT_GL_ERROR(GL_INVALID_ENUM, glGetTexParameterPointervAPPLE(
                                       GL_TEXTURE_2D, GL_TEXTURE_RANGE_LENGTH_APPLE, &pointer));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_STORAGE_HINT_APPLE, GL_LINEAR));
  EXPECT_GL_ERROR(GL_INVALID_ENUM,
                  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_RANGE_LENGTH_APPLE, 4));
  glBegin(GL_POINTS);
  glTextureRangeAPPLE(GL_TEXTURE_2D, 4, memory);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(rangePointer(GL_TEXTURE_2D), nullptr);
}

} // namespace
} // namespace api
