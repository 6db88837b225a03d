// Nested display lists: names, types, depth, primitives left open.
#include <cstring>

#include "harness.h"

namespace paths {

namespace {

GLfloat env(GLuint index = 0) {
  GLfloat value[4] = {};
  glGetProgramEnvParameterfvARB(kFragment, index, value);
  return value[0];
}
void setEnv(float value, GLuint index = 0) {
  glProgramEnvParameter4fARB(kFragment, index, value, 0, 0, 0);
}

/// Tests a chain longer than MAX_LIST_NESTING: how deep it goes, with and without commands of the
/// layer.
void depth(Recorder &r) {
  usePrograms();
  const int length = integer(GL_MAX_LIST_NESTING) + 8;
  const GLuint first = glGenLists(length + 1);
  for (const bool withEnv : {true, false}) {
    for (int i = 0; i < length; ++i) {
      glNewList(first + GLuint(i), GL_COMPILE);
      if (withEnv)
        setEnv(float(i + 1));
      glTranslatef(1, 0, 0);
      glCallList(first + GLuint(i) + 1);
      glEndList();
    }
    glLoadIdentity();
    glCallList(first);
    GLfloat matrix[16] = {};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    r.value(withEnv ? "deepest with ours" : "deepest of plain ones", matrix[12]);
    r.value("env", env());
  }
}

/// Tests lists that call themselves, and each other.
void recursion(Recorder &r) {
  usePrograms();
  const GLuint first = glGenLists(3);
  glNewList(first, GL_COMPILE);
  glTranslatef(1, 0, 0);
  setEnv(3);
  glCallList(first);
  glEndList();
  glCallList(first);
  GLfloat matrix[16] = {};
  glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
  r.value("itself", matrix[12]);
}

/// Tests plain lists around lists with commands of the layer around plain lists.
void alternatingLists(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint first = glGenLists(5);
  glNewList(first + 4, GL_COMPILE);
  gradient(-0.5f, -0.5f, 0.5f, 0.5f);
  glEndList();
  glNewList(first + 3, GL_COMPILE);
  tint(1, 0, 1);
  glCallList(first + 4);
  glProgramEnvParameter4fARB(kVertex, 0, 0.5f, 0.5f, 0, 0);
  glEndList();
  glNewList(first + 2, GL_COMPILE);
  glPushMatrix();
  glCallList(first + 3);
  glCallList(first + 4);
  glPopMatrix();
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  glBindProgramARB(kFragment, programs.fragment);
  glCallList(first + 2);
  tint(1, 1, 0);
  glCallList(first + 4);
  glEndList();
  glNewList(first, GL_COMPILE_AND_EXECUTE);
  glCallList(first + 1);
  glEndList();
  r.picture("executed");
  glClear(GL_COLOR_BUFFER_BIT);
  glProgramEnvParameter4fARB(kVertex, 0, -0.5f, -0.5f, 0, 0);
  glCallList(first);
  r.picture("called");
}

/// Tests an outer list that is compiled when names for programs exist, but no program.
void compiledBefore(Recorder &r) {
  const GLuint first = glGenLists(3);
  GLuint program = 0;
  glGenProgramsARB(1, &program);
  glNewList(first, GL_COMPILE);
  glPushAttrib(GL_ENABLE_BIT);
  glCallList(first + 1);
  glRectf(-1, -1, 0, 1);
  glPopAttrib();
  glRectf(0, -1, 1, 0);
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  glColor4f(0, 0, 1, 1);
  glEndList();
  glCallList(first);
  r.picture("without programs");
  glBindProgramARB(kFragment, program);
  load(kGreen);
  glNewList(first + 1, GL_COMPILE);
  glColor4f(1, 0, 0, 1);
  glEnable(kFragment);
  glEndList();
  glCallList(first);
  r.picture("with a program inside");
  r.value("enabled", glIsEnabled(kFragment));
  r.value("depth", integer(GL_ATTRIB_STACK_DEPTH));
}

template <typename T> void callCells(Recorder &r, const char *what, GLenum type, const T *lists) {
  glClear(GL_COLOR_BUFFER_BIT);
  glCallLists(4, type, lists);
  r.errors(what);
  r.picture(what);
}

/// Makes lists that draw a cell each, with a command of the layer in it.
void makeCells(GLuint base, int count) {
  for (int i = 0; i < count; ++i) {
    glNewList(base + GLuint(i), GL_COMPILE);
    tint(float(i % 2), 1, float(i) / 4);
    gradient(float(i) / 2 - 1, -1, float(i) / 2 - 0.6f, 1);
    glEndList();
  }
}

void everyType(Recorder &r) {
  usePrograms();
  makeCells(300, 4);
  makeCells(70000, 4);
  const GLbyte bytes[4] = {-100, -99, -97, 5};
  const GLubyte unsignedBytes[4] = {200, 203, 201, 0};
  const GLshort shorts[4] = {-100, -98, -97, 5};
  const GLushort unsignedShorts[4] = {203, 202, 201, 200};
  const GLint ints[4] = {-97, -98, 69602, 5};
  const GLuint unsignedInts[4] = {0xFFFFFF9Cu, 0xFFFFFF9Du, 69603, 5};
  const GLfloat floats[4] = {-99.5f, -97.9f, 69601.25f, 5};
  const GLubyte two[8] = {0, 200, 0, 203, 1, 0, 0, 201};
  const GLubyte three[12] = {0, 0, 200, 1, 15, 0xE2, 0, 0, 201, 0, 0, 0};
  const GLubyte four[16] = {0, 0, 0, 200, 0, 1, 15, 0xE2, 0, 0, 0, 203, 0xFF, 0xFF, 0xFF, 0xFF};
  glListBase(400);
  callCells(r, "byte", GL_BYTE, bytes);
  callCells(r, "short", GL_SHORT, shorts);
  callCells(r, "int", GL_INT, ints);
  callCells(r, "unsigned int", GL_UNSIGNED_INT, unsignedInts);
  callCells(r, "float", GL_FLOAT, floats);
  glListBase(100);
  callCells(r, "unsigned byte", GL_UNSIGNED_BYTE, unsignedBytes);
  callCells(r, "unsigned short", GL_UNSIGNED_SHORT, unsignedShorts);
  callCells(r, "two bytes", GL_2_BYTES, two);
  callCells(r, "three bytes", GL_3_BYTES, three);
  callCells(r, "four bytes", GL_4_BYTES, four);
  callCells(r, "double is no type", GL_DOUBLE, floats);
  glCallLists(-1, GL_BYTE, bytes);
  r.errors("negative count");
  glCallLists(0, GL_BYTE, nullptr);
  r.errors("no count");
}

/// Tests the types in a list: the array is copied, and ListBase counts when it is executed.
void typesInLists(Recorder &r) {
  usePrograms();
  makeCells(300, 4);
  makeCells(500, 3);
  GLubyte two[8] = {0, 200, 0, 203, 0, 202, 0, 201};
  GLfloat floats[2] = {200.5f, 203};
  const GLuint list = glGenLists(1);
  glListBase(0);
  glNewList(list, GL_COMPILE);
  glListBase(100);
  glCallLists(3, GL_2_BYTES, two);
  glListBase(300);
  glCallLists(2, GL_FLOAT, floats);
  glCallLists(2, GL_DOUBLE, floats);
  glEndList();
  std::memset(two, 7, sizeof two);
  std::memset(floats, 7, sizeof floats);
  r.value("base when compiled", integer(GL_LIST_BASE));
  r.errors("compiled");
  glCallList(list);
  r.errors("called");
  r.picture("called");
  r.value("base when called", integer(GL_LIST_BASE));
}

/// Tests whether a called list's change of ListBase affects the rest of CallLists.
void baseChangesInside(Recorder &r) {
  usePrograms();
  makeCells(300, 4);
  makeCells(301 + 16, 3);
  glNewList(300, GL_COMPILE);
  tint(1, 1, 1);
  glListBase(316);
  glEndList();
  const GLubyte names[4] = {0, 1, 2, 3};
  glListBase(300);
  glCallLists(4, GL_UNSIGNED_BYTE, names);
  r.value("base", integer(GL_LIST_BASE));
  r.picture("which lists");
}

/// Draws a quad that looks the same along either diagonal. The bare host splits quads of lists
/// along the lists' or immediate mode's diagonal, depending on whether earlier lists left
/// primitives open.
void plane(float x0, float y0, float x1, float y1) {
  glBegin(GL_QUADS);
  glColor4f(0, 0, 1, 1), glVertex2f(x0, y0);
  glColor4f(1, 0, 1, 1), glVertex2f(x1, y0);
  glColor4f(1, 1, 1, 1), glVertex2f(x1, y1);
  glColor4f(0, 1, 1, 1), glVertex2f(x0, y1);
  glEnd();
}

/// Tests Begin in one list, vertices in the next, End in a third, with commands of the layer in
/// other lists.
void openPrimitive(Recorder &r) {
  usePrograms();
  const GLuint first = glGenLists(4);
  glNewList(first, GL_COMPILE);
  tint(1, 1, 0);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0, 0, 1);
  glVertex2f(-1, -1);
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  glVertex2f(1, -1);
  glVertex2f(0, 1);
  glEndList();
  glNewList(first + 2, GL_COMPILE);
  glEnd();
  tint(0, 1, 1);
  glEndList();
  glNewList(first + 3, GL_COMPILE);
  glCallList(first);
  glCallList(first + 1);
  glCallList(first + 2);
  plane(0.5f, 0.5f, 1, 1);
  glEndList();
  glCallList(first);
  glCallList(first + 1);
  glCallList(first + 2);
  r.errors("called one after another");
  r.picture("called one after another");
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(first + 3);
  r.errors("called in a list");
  r.picture("called in a list");
}

/// Tests a glBegin that stays open across nested calls, in compiled lists and outside.
void nestedInPrimitive(Recorder &r) {
  usePrograms();
  const GLuint first = glGenLists(4);
  glNewList(first, GL_COMPILE);
  glColor4f(0, 1, 0, 1);
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  tint(1, 1, 1);
  glBegin(GL_QUADS);
  glColor4f(1, 0, 0, 1);
  glVertex2f(-1, 1);
  glVertex2f(-1, -1);
  glCallList(first);
  glEnd();
  tint(1, 1, 0);
  plane(-0.2f, -0.2f, 0.2f, 0.2f);
  glEndList();
  glCallList(first + 1);
  r.errors("a list of vertices");
  r.picture("a list of vertices");
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glColor4f(0, 0, 1, 1);
  glVertex2f(-1, 1);
  glVertex2f(-1, -1);
  glCallList(first);
  glEnd();
  r.errors("immediate mode");
  r.picture("immediate mode");
  glNewList(first + 2, GL_COMPILE);
  tint(1, 0, 0); // an error between Begin and End
  glVertex2f(1, -1);
  glVertex2f(1, 1);
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  glBegin(GL_QUADS);
  glVertex2f(-1, 1);
  glVertex2f(-1, -1);
  glCallList(first + 2);
  glEnd();
  r.errors("a command of ours between Begin and End");
  r.picture("a command of ours between Begin and End");
  glNewList(first + 3, GL_COMPILE_AND_EXECUTE);
  tint(1, 1, 1);
  glBegin(GL_QUADS);
  glVertex2f(-1, 1);
  glVertex2f(-1, -1);
  glCallList(first);
  glEnd();
  tint(0, 0, 1);
  glEndList();
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(first + 3);
  r.errors("compile and execute");
  r.picture("compile and execute");
}

} // namespace

const std::vector<Case> kNestedListCases = {
    {"nested-depth", depth},
    {"nested-recursion", recursion},
    {"nested-alternating", alternatingLists},
    {"nested-compiled-before", compiledBefore},
    {"nested-every-type", everyType},
    {"nested-types-in-lists", typesInLists},
    {"nested-base-changes", baseChangesInside},
    {"nested-open-primitive", openPrimitive},
    {"nested-in-primitive", nestedInPrimitive},
};

} // namespace paths
