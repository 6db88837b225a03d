// Tests every way to draw, with a vertex and an effective fragment program.
#include <array>

#include "harness.h"

namespace paths {

namespace {

struct Vertex {
  GLfloat position[2];
  GLfloat color[4];
};
/// Returns two rows of five points.
std::array<Vertex, 10> strip() {
  std::array<Vertex, 10> vertices{};
  for (int i = 0; i < 10; ++i)
    vertices[std::size_t(i)] = {{float(i / 2) * 0.4f - 0.8f, i % 2 ? 0.3f : -0.3f},
                                {float(i % 3) / 2, float(i % 4) / 3, float(i % 5) / 4, 1}};
  return vertices;
}
const std::array<Vertex, 10> kStrip = strip();

/// Sets the strip's arrays, in client memory or at an offset of the bound buffer.
void pointAt(const Vertex *base) {
  const auto *const bytes = reinterpret_cast<const char *>(base);
  glVertexPointer(2, GL_FLOAT, sizeof(Vertex), bytes);
  glColorPointer(4, GL_FLOAT, sizeof(Vertex), bytes + sizeof kStrip[0].position);
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_COLOR_ARRAY);
}
void useBuffer() {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof kStrip, kStrip.data(), GL_STATIC_DRAW);
  pointAt(nullptr);
}
void move(float x, float y) { glProgramEnvParameter4fARB(kVertex, 0, x, y, 0, 0); }

void clientArrays(Recorder &r) {
  usePrograms();
  pointAt(kStrip.data());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 10);
  move(0, 0.6f);
  const GLubyte bytes[] = {0, 1, 2, 3, 2, 5};
  glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, bytes);
  move(0, -0.6f);
  const GLushort shorts[] = {4, 5, 6, 7, 8, 9};
  glDrawRangeElements(GL_TRIANGLE_STRIP, 4, 9, 6, GL_UNSIGNED_SHORT, shorts);
  move(0.2f, 0.6f);
  glBegin(GL_TRIANGLE_STRIP);
  for (int i = 6; i < 10; ++i)
    glArrayElement(i);
  glEnd();
  move(0, 0);
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_COLOR_ARRAY);
  const GLfloat interleaved[] = {1, 0, 0, -1, -1, 0, 0, 1, 0, -0.5f, -1, 0, 0, 0, 1, -1, -0.5f, 0};
  glInterleavedArrays(GL_C3F_V3F, 0, interleaved);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  r.picture("client arrays");
}

void buffersAndObjects(Recorder &r) {
  usePrograms();
  GLuint arrays[2] = {};
  glGenVertexArrays(2, arrays);
  glBindVertexArray(arrays[0]);
  useBuffer();
  glBindVertexArray(arrays[1]);
  useBuffer();
  glDisableClientState(GL_COLOR_ARRAY);
  GLuint elements = 0;
  glGenBuffers(1, &elements);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
  const GLuint indexes[] = {0, 1, 2, 3, 4, 5};
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indexes, indexes, GL_STATIC_DRAW);
  glBindVertexArray(arrays[0]);
  move(0, 0.5f);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 10);
  glBindVertexArray(arrays[1]);
  glColor4f(1, 0.5f, 0, 1);
  move(0, -0.5f);
  glDrawElements(GL_TRIANGLE_STRIP, 6, GL_UNSIGNED_INT, nullptr);
  move(0.8f, -0.5f);
  glColor4f(0, 0.5f, 1, 1);
  glDrawElementsBaseVertex(GL_TRIANGLE_STRIP, 2, GL_UNSIGNED_INT, nullptr, 4);
  glDrawElementsBaseVertex(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_INT, nullptr, 2);
  r.picture("two objects");
  r.value("bound", integer(GL_VERTEX_ARRAY_BINDING) == GLint(arrays[1]));
  r.value("buffer", integer(GL_ELEMENT_ARRAY_BUFFER_BINDING) == GLint(elements));
}

void multiDraws(Recorder &r) {
  usePrograms();
  pointAt(kStrip.data());
  const GLint firsts[] = {0, 6};
  const GLsizei counts[] = {4, 4};
  move(0, 0.5f);
  glMultiDrawArrays(GL_TRIANGLE_STRIP, firsts, counts, 2);
  const GLubyte indexes[] = {0, 1, 2, 7, 8, 9};
  const void *const pointers[] = {indexes, indexes + 3};
  const GLsizei threes[] = {3, 3};
  move(0, -0.5f);
  glMultiDrawElements(GL_TRIANGLES, threes, GL_UNSIGNED_BYTE, pointers, 2);
  const GLint bases[] = {2, -2};
  move(0, 0);
  glMultiDrawElementsBaseVertex(GL_TRIANGLES, threes, GL_UNSIGNED_BYTE, pointers, 2, bases);
  r.picture("several at once");
}

/// Tests that an instanced draw puts all instances at the same place: an ARB program has no
/// instance number.
void instanced(Recorder &r) {
  usePrograms();
  useBuffer();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  tint(0.25f, 0.25f, 0.25f);
  move(0, 0.5f);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 10, 3);
  const GLubyte indexes[] = {0, 1, 2, 3};
  GLuint elements = 0;
  glGenBuffers(1, &elements);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, elements);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indexes, indexes, GL_STATIC_DRAW);
  move(0, -0.5f);
  glDrawElementsInstanced(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr, 2);
  glDrawElementsInstancedBaseVertex(GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, nullptr, 4, 6);
  r.picture("in place");
  // A divisor advances an attribute once for each instance.
  const GLfloat offsets[] = {-0.6f, -0.2f, 0, 0, 0, 0.1f, 0, 0, 0.6f, 0.4f, 0, 0};
  GLuint perInstance = 0;
  glGenBuffers(1, &perInstance);
  glBindBuffer(GL_ARRAY_BUFFER, perInstance);
  glBufferData(GL_ARRAY_BUFFER, sizeof offsets, offsets, GL_STATIC_DRAW);
  load("!!ARBvp1.0\nTEMP p;\nMAD p, vertex.position, {0.3, 0.3, 1, 1}, vertex.attrib[9];\n"
       "MOV result.position, p;\nMOV result.color, vertex.color;\nEND",
       kVertex);
  glVertexAttribPointerARB(9, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArrayARB(9);
  glVertexAttribDivisorARB(9, 1);
  glDisable(GL_BLEND);
  glClear(GL_COLOR_BUFFER_BIT);
  tint(1, 1, 1);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 10, 3);
  glDrawArraysInstancedBaseInstance(GL_TRIANGLE_STRIP, 0, 3, 1, 1);
  r.picture("by divisor");
  r.errors("instanced");
}

void indirect(Recorder &r) {
  usePrograms();
  useBuffer();
  const GLubyte indexes[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
  GLuint buffers[2] = {};
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof indexes, indexes, GL_STATIC_DRAW);
  const GLuint commands[] = {4, 1, 0, 0, 4, 1, 6, 0, /* elements: */ 4, 1, 2, 1, 0};
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, buffers[1]);
  glBufferData(GL_DRAW_INDIRECT_BUFFER, sizeof commands, commands, GL_STATIC_DRAW);
  glDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr);
  move(0, 0.6f);
  glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, 2, 16);
  move(0, -0.6f);
  glDrawElementsIndirect(GL_TRIANGLE_STRIP, GL_UNSIGNED_BYTE,
                         reinterpret_cast<const void *>(8 * sizeof(GLuint)));
  r.picture("indirect");
  r.errors("indirect");
}

void restart(Recorder &r) {
  usePrograms();
  useBuffer();
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  const GLubyte indexes[] = {0, 1, 2, 3, 77, 6, 7, 8, 9};
  glEnable(GL_PRIMITIVE_RESTART);
  glPrimitiveRestartIndex(77);
  glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_BYTE, indexes);
  r.picture("two strips");
}

void provokingVertex(Recorder &r) {
  usePrograms();
  pointAt(kStrip.data());
  glShadeModel(GL_FLAT);
  move(0, 0.5f);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 10);
  r.pixel("the third vertex'", 8, 46, {255, 170, 128, 255}); // of the first triangle
  glProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  move(0, -0.5f);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 10);
  r.pixel("the first vertex'", 8, 14, {0, 0, 0, 255});
  r.pixel("the second vertex'", 16, 22, {128, 85, 64, 255}); // of the second triangle
  glDisable(kVertex);
  glProvokingVertex(GL_LAST_VERTEX_CONVENTION);
  glDrawArrays(GL_QUAD_STRIP, 0, 10);
  r.picture("flat");
}

/// Tests changes of the effective program between draws of the same arrays.
void programsBetween(Recorder &r) {
  const Programs programs = usePrograms();
  useBuffer();
  for (int i = 0; i < 4; ++i) {
    (i % 2 ? glDisable : glEnable)(kVertex);
    (i / 2 ? glDisable : glEnable)(kFragment);
    glLoadIdentity();
    glTranslatef(0, float(i) * 0.3f - 0.6f, 0);
    move(0, float(i) * 0.3f - 0.6f);
    tint(1, float(i) / 3, 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 10);
  }
  r.picture("four kinds");
  r.value("bound", programiv(GL_PROGRAM_BINDING_ARB, kVertex) == GLint(programs.vertex));
}

void twoSides(Recorder &r) {
  usePrograms();
  load("!!ARBvp1.0\nMOV result.position, vertex.position;\n"
       "MOV result.color.front, vertex.color;\nMOV result.color.back, {0, 0.5, 1, 1};\n"
       "MOV result.color.front.secondary, {0.2, 0, 0, 0};\n"
       "MOV result.color.back.secondary, {0, 0.4, 0, 0};\nEND",
       kVertex);
  load("!!ARBfp1.0\nADD result.color, fragment.color, fragment.color.secondary;\nEND");
  for (const bool two : {false, true}) {
    (two ? glEnable : glDisable)(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
    gradient(two ? 0.1f : -0.9f, -0.9f, two ? 0.9f : -0.1f, -0.1f);
    gradient(two ? 0.9f : -0.1f, 0.1f, two ? 0.1f : -0.9f, 0.9f); // seen from behind
  }
  r.picture("by a vertex program");
  glDisable(kVertex);
  glDisable(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, 1);
  const GLfloat back[] = {1, 1, 0, 1};
  glMaterialfv(GL_BACK, GL_AMBIENT_AND_DIFFUSE, back);
  glNormal3f(0, 0, 1);
  gradient(-0.9f, -0.9f, -0.1f, 0.9f);
  glNormal3f(0, 0, -1);
  gradient(0.9f, -0.9f, 0.1f, 0.9f);
  r.picture("by lighting");
}

void pointsAndLines(Recorder &r) {
  usePrograms();
  checkered();
  load("!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, vertex.color;\n"
       "MUL result.pointsize.x, vertex.texcoord[0].x, 24;\n"
       "MOV result.texcoord[0], vertex.texcoord[0];\nEND",
       kVertex);
  load("!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
       "MUL result.color, t, fragment.color;\nEND");
  glEnable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
  for (const bool sprite : {false, true}) {
    if (sprite) {
      glEnable(GL_POINT_SPRITE);
      glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
    }
    glBegin(GL_POINTS);
    glColor4f(1, 1, 1, 1);
    glTexCoord2f(0.9f, 0.4f), glVertex2f(sprite ? 0.5f : -0.5f, 0.5f);
    glTexCoord2f(0.4f, 0.9f), glVertex2f(sprite ? 0.5f : -0.5f, -0.2f);
    glEnd();
  }
  glDisable(GL_POINT_SPRITE);
  glLineWidth(3);
  glEnable(GL_LINE_STIPPLE);
  glLineStipple(2, 0x3333);
  glBegin(GL_LINE_STRIP);
  glTexCoord2f(0, 0), glVertex2f(-0.9f, -0.9f);
  glTexCoord2f(1, 1), glVertex2f(0.9f, -0.6f);
  glEnd();
  glDisable(GL_LINE_STIPPLE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
  gradient(-0.8f, 0.6f, 0.8f, 0.9f);
  r.picture("points and lines");
}

void clipPlanes(Recorder &r) {
  usePrograms();
  const GLdouble plane[] = {1, 1, 0, 0.5};
  glClipPlane(GL_CLIP_PLANE0, plane);
  glEnable(GL_CLIP_PLANE0);
  glDisable(kVertex);
  gradient(-1, -1, 0, 1);
  glEnable(kVertex);
  load("!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, vertex.color.bgra;\nEND",
       kVertex);
  gradient(0, -1, 1, 1);
  gradient(-1, -0.6f, 1, 0.1f);
  r.picture("clipped");
}

/// Tests planes that are enabled and disabled while a vertex program is effective: by calls, stacks
/// and lists.
void changingClipPlanes(Recorder &r) {
  usePrograms();
  load("!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, vertex.color.bgra;\nEND",
       kVertex);
  const GLdouble plane[] = {0, 1, 0, -0.25};
  glClipPlane(GL_CLIP_PLANE1, plane);
  glMatrixMode(GL_PROJECTION); // the planes in eye space differ from those in clip space
  glScalef(1, 0.5f, 1);
  glMatrixMode(GL_MODELVIEW);
  gradient(-1, -1, -0.75f, 1);
  glEnable(GL_CLIP_PLANE1);
  gradient(-0.75f, -1, -0.5f, 1);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(GL_CLIP_PLANE1);
  gradient(-0.5f, -1, -0.25f, 1);
  glPopAttrib();
  gradient(-0.25f, -1, 0, 1);
  glDisable(GL_CLIP_PLANE1);
  r.picture("calls and stack");
  glClear(GL_COLOR_BUFFER_BIT);
  glNewList(1, GL_COMPILE_AND_EXECUTE);
  gradient(-1, -1, -0.5f, 1);
  glEnable(GL_CLIP_PLANE1);
  gradient(-0.5f, -1, 0, 1);
  glEndList();
  glDisable(GL_CLIP_PLANE1);
  glTranslatef(1, 0, 0);
  glCallList(1);
  glDisable(GL_CLIP_PLANE1);
  glDeleteLists(1, 1);
  r.picture("lists");
}

/// Tests feedback positions from a vertex program, and selection hits.
void feedbackMode(Recorder &r) {
  usePrograms();
  load("!!ARBvp1.0\nADD result.position, vertex.position, program.env[0];\n"
       "MOV result.color, {0.25, 0.5, 0.75, 1};\nMOV result.texcoord[0], vertex.color;\nEND",
       kVertex);
  move(0.25f, 0.25f);
  GLfloat feedback[64] = {};
  glFeedbackBuffer(64, GL_4D_COLOR_TEXTURE, feedback);
  glRenderMode(GL_FEEDBACK);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0, 0, 1), glVertex2f(-0.5f, -0.5f);
  glColor4f(0, 1, 0, 1), glVertex2f(0.5f, -0.5f);
  glColor4f(0, 0, 1, 1), glVertex2f(0, 0.5f);
  glEnd();
  glPassThrough(7);
  glRasterPos2f(0, 0);
  glBitmap(0, 0, 0, 0, 0, 0, nullptr);
  const GLint count = glRenderMode(GL_RENDER);
  r.value("values", count);
  for (int i = 0; i < count; ++i)
    r.value("feedback", double(int(feedback[i] * 100 + 0.5f)));
  GLuint names[32] = {};
  glSelectBuffer(32, names);
  glRenderMode(GL_SELECT);
  glInitNames();
  glPushName(5);
  gradient(-0.5f, -0.5f, 0.5f, 0.5f);
  glLoadName(6);
  move(5, 5);
  gradient(-0.5f, -0.5f, 0.5f, 0.5f);
  r.value("hits", glRenderMode(GL_RENDER));
  r.value("name", names[3]);
  r.errors("modes");
}

void rasterPosition(Recorder &r) {
  usePrograms();
  load("!!ARBvp1.0\nADD result.position, vertex.position, program.env[0];\n"
       "MUL result.color, vertex.color, {0.5, 1, 1, 1};\n"
       "MOV result.texcoord[0], vertex.color;\nEND",
       kVertex);
  move(0.25f, -0.25f);
  glColor4f(1, 0.5f, 0.25f, 1);
  glRasterPos2f(-0.5f, 0);
  GLfloat position[4] = {}, color[4] = {}, coordinates[4] = {};
  glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
  glGetFloatv(GL_CURRENT_RASTER_COLOR, color);
  glGetFloatv(GL_CURRENT_RASTER_TEXTURE_COORDS, coordinates);
  r.value("x", position[0]);
  r.value("y", position[1]);
  r.value("red", color[0]);
  r.value("s", coordinates[0]);
  const GLubyte bits[8] = {0xFF, 0x81, 0x81, 0x81, 0x81, 0x81, 0x81, 0xFF};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glBitmap(8, 8, 0, 0, 10, 0, bits);
  glBitmap(8, 8, 0, 0, 10, 0, bits);
  move(5, 5);
  glRasterPos2f(0, 0);
  r.value("valid", integer(GL_CURRENT_RASTER_POSITION_VALID));
  glWindowPos2i(40, 40);
  glBitmap(8, 8, 0, 0, 10, 0, bits);
  r.picture("bitmaps");
}

} // namespace

const std::vector<Case> kDrawCases = {
    {"draw-client-arrays", clientArrays},
    {"draw-buffers-and-objects", buffersAndObjects},
    {"draw-several", multiDraws},
    {"draw-instanced", instanced},
    {"draw-indirect", indirect},
    {"draw-restart", restart},
    {"draw-provoking-vertex", provokingVertex,
     "interpolates colours that ShadeModel FLAT holds for an assembly program"},
    {"draw-programs-between", programsBetween},
    {"draw-two-sides", twoSides},
    {"draw-points-and-lines", pointsAndLines},
    {"draw-clip-planes", clipPlanes},
    {"draw-changing-clip-planes", changingClipPlanes},
    {"draw-feedback-mode", feedbackMode},
    {"draw-raster-position", rasterPosition},
};

} // namespace paths
