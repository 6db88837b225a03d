// Display lists: which commands are compiled, when they take effect, and that compiled commands
// never change.
#include <cstring>

#include "harness.h"

namespace paths {

namespace {

constexpr char kTop[] = "!!ARBvp1.0\nADD result.position, vertex.position, {0, 0.3, 0, 0};\n"
                        "MOV result.color, vertex.color.gbra;\nEND";

/// Tests every command of both targets, with a draw after each change.
void everyCommand(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint otherVertex = makeProgram(kTop, kVertex);
  const GLuint otherFragment = makeProgram("!!ARBfp1.0\nMOV result.color, fragment.color.b;\nEND");
  glBindProgramARB(kVertex, programs.vertex);
  glBindProgramARB(kFragment, programs.fragment);
  const GLuint list = glGenLists(1);
  const GLfloat low[4] = {0.2f, 0.2f, 0.2f, 0};
  const GLdouble shift[4] = {-0.5, -0.5, 0, 0};
  glNewList(list, GL_COMPILE);
  glDisable(kVertex);
  glDisable(kFragment);
  gradient(-1, -1, -0.5f, -0.5f);
  glEnable(kVertex);
  glEnable(kFragment);
  glProgramEnvParameter4dvARB(kVertex, 0, shift);
  gradient(0, 0.5f, 0.5f, 1);
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0, 0);
  glProgramLocalParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  gradient(0.5f, 0.5f, 1, 1);
  glProgramEnvParameter4fvARB(kFragment, 0, low);
  gradient(0, -1, 0.5f, -0.5f);
  glBindProgramARB(kVertex, otherVertex);
  gradient(0.5f, -1, 1, -0.5f);
  glBindProgramARB(kFragment, otherFragment);
  gradient(-1, -0.5f, -0.5f, 0);
  load("!!ARBvp1.0\nMOV result.position, vertex.position;\nMOV result.color, 0.75;\nEND", kVertex);
  load("!!ARBfp1.0\nMOV result.color, fragment.color;\nEND");
  gradient(-0.5f, -0.5f, 0, 0);
  glEndList();
  r.picture("compiled only");
  r.value("vertex enabled", glIsEnabled(kVertex));
  r.value("vertex binding", programiv(GL_PROGRAM_BINDING_ARB, kVertex) == GLint(programs.vertex));
  glCallList(list);
  r.picture("called");
  r.value("vertex binding", programiv(GL_PROGRAM_BINDING_ARB, kVertex) == GLint(otherVertex));
  r.value("fragment binding", programiv(GL_PROGRAM_BINDING_ARB) == GLint(otherFragment));
  r.value("vertex length", programiv(GL_PROGRAM_LENGTH_ARB, kVertex));
}

void compileAndExecute(Recorder &r) {
  usePrograms();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE_AND_EXECUTE);
  gradient(-1, -1, 0, 0);
  glProgramEnvParameter4fARB(kVertex, 0, 0.25f, 0.25f, 0, 0);
  tint(0, 1, 1);
  gradient(-0.25f, -0.25f, 0.5f, 0.5f);
  load(kTop, kVertex);
  gradient(-1, 0, -0.5f, 0.5f);
  r.value("list index", integer(GL_LIST_INDEX) == GLint(list));
  r.value("list mode", integer(GL_LIST_MODE));
  r.value("enabled in it", glIsEnabled(kVertex));
  glEndList();
  r.picture("while compiled");
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(list);
  r.picture("called");
}

/// Tests a text that fails to load: it raises the error when the list is executed, and keeps the
/// program.
void errorsInLists(Recorder &r) {
  usePrograms();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  load(kBad);
  load("!!ARBvp1.0\nMOV result.position, nothing;\nEND", kVertex);
  glProgramEnvParameter4fARB(kVertex, 100000, 0, 0, 0, 0);
  glBindProgramARB(0x1234, 1);
  gradient();
  glEndList();
  r.errors("while compiled");
  glCallList(list);
  r.errors("called");
  r.picture("called");
  glNewList(list, GL_COMPILE_AND_EXECUTE);
  load(kBad);
  glEndList();
  r.errors("compile and execute");
  glNewList(list, GL_COMPILE);
  glNewList(list + 1, GL_COMPILE);
  r.errors("NewList in NewList");
  glEndList();
  glEndList();
  r.errors("EndList twice");
  glNewList(0, GL_COMPILE);
  r.errors("NewList 0");
  glNewList(list, GL_TRIANGLES);
  r.errors("NewList of a mode that is none");
  r.value("index", integer(GL_LIST_INDEX));
  r.value("mode", integer(GL_LIST_MODE));
}

/// Tests the commands that are not compiled: Gen, Delete, Is, Gets (AFP 3686-3690).
void notCompiled(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  r.value("generated", name != 0);
  r.value("is program", glIsProgramARB(programs.vertex));
  r.value("binding", programiv(GL_PROGRAM_BINDING_ARB, kVertex) == GLint(programs.vertex));
  GLfloat value[4] = {};
  glGetProgramLocalParameterfvARB(kFragment, 0, value);
  r.value("local", value[0]);
  glDeleteProgramsARB(1, &programs.fragment);
  r.value("deleted", glIsProgramARB(programs.fragment));
  r.value("deleted binding", programiv(GL_PROGRAM_BINDING_ARB));
  glEndList();
  glCallList(list);
  r.errors("called");
}

/// Tests that a list contains the program's name, which is looked up when the list is executed.
void programDeleted(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBindProgramARB(kVertex, programs.vertex);
  glBindProgramARB(kFragment, programs.fragment);
  glProgramLocalParameter4fARB(kFragment, 0, 1, 0, 1, 1);
  gradient();
  glEndList();
  glCallList(list);
  r.picture("before");
  glDeleteProgramsARB(1, &programs.fragment);
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(list);
  r.errors("fragment program deleted");
  r.picture("fragment program deleted");
  r.value("it exists again", glIsProgramARB(programs.fragment));
  load(kGreen);
  glCallList(list);
  r.picture("loaded again");
  glDeleteProgramsARB(1, &programs.vertex);
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(list);
  r.errors("vertex program deleted");
  r.picture("vertex program deleted");
}

/// Tests that the named commands of EXT_direct_state_access are compiled too.
void namedCommands(Recorder &r) {
  if (!epoxy_has_gl_extension("GL_EXT_direct_state_access"))
    return r.skip("GL_EXT_direct_state_access is not offered here");
  const Programs programs = usePrograms();
  GLuint other[2] = {};
  glGenProgramsARB(2, other);
  const GLuint list = glGenLists(1);
  const char *const green = "!!ARBfp1.0\nMUL result.color, fragment.color, program.local[3];\nEND";
  const GLfloat values[8] = {1, 0, 1, 1, 0, 1, 0, 1};
  const GLdouble doubles[4] = {0, 0, 1, 1};
  glNewList(list, GL_COMPILE);
  glNamedProgramStringEXT(other[0], kFragment, GL_PROGRAM_FORMAT_ASCII_ARB,
                          GLsizei(std::strlen(green)), green);
  glNamedProgramStringEXT(other[1], kVertex, GL_PROGRAM_FORMAT_ASCII_ARB,
                          GLsizei(std::strlen(kTop)), kTop);
  glNamedProgramLocalParameters4fvEXT(other[0], kFragment, 2, 2, values);
  glNamedProgramLocalParameter4fEXT(programs.fragment, kFragment, 0, 0.5f, 0.5f, 0.5f, 1);
  glNamedProgramLocalParameter4dvEXT(programs.fragment, kFragment, 1, doubles);
  gradient(-1, -1, 0, 0);
  glBindProgramARB(kFragment, other[0]);
  glBindProgramARB(kVertex, other[1]);
  gradient(0, 0, 1, 0.5f);
  glEndList();
  r.value("made when compiled", glIsProgramARB(other[0]));
  GLfloat local[4] = {};
  glGetNamedProgramLocalParameterfvEXT(programs.fragment, kFragment, 0, local);
  r.value("local when compiled", local[0]);
  glCallList(list);
  r.picture("called");
  r.errors("called");
  glGetNamedProgramLocalParameterfvEXT(programs.fragment, kFragment, 0, local);
  r.value("local when called", local[0]);
}

void isListAndDelete(Recorder &r) {
  usePrograms();
  const GLuint first = glGenLists(3);
  r.value("generated", glIsList(first) + 2 * glIsList(first + 2) + 4 * glIsList(first + 3));
  glNewList(first, GL_COMPILE);
  tint(1, 0, 0);
  gradient();
  tint(0, 1, 0);
  glEndList();
  glNewList(77777, GL_COMPILE);
  tint(0, 0, 1);
  glEndList();
  r.value("given", glIsList(77777));
  glDeleteLists(first, 3);
  r.value("deleted", glIsList(first));
  glCallList(first);
  r.errors("call of a deleted list");
  r.picture("nothing");
  glDeleteLists(first, -1);
  r.errors("negative range");
  glCallList(77777);
  gradient();
  r.picture("the other list");
  r.value("range 0", glGenLists(0));
  glGenLists(-1);
  r.errors("negative GenLists");
}

/// Tests lists that are redefined repeatedly, with and without commands of the layer.
void redefined(Recorder &r) {
  usePrograms();
  const GLuint list = glGenLists(2);
  for (int i = 0; i < 40; ++i) {
    glNewList(list, GL_COMPILE);
    if (i % 3 != 0)
      tint(float(i) / 40, 1, 0);
    gradient(-1, -1, float(i) / 20 - 1, 1);
    if (i % 5 != 0)
      tint(1, 1, float(i) / 40);
    glEndList();
    glNewList(list + 1, GL_COMPILE);
    glCallList(list);
    glEndList();
    glCallList(list + 1);
  }
  r.picture("after forty");
  GLuint most = 0;
  for (GLuint name = 1; name < 200; ++name)
    most += glIsList(name);
  r.value("lists", most);
}

/// Tests that color, texture coordinate and normal continue from list to list.
void currentValues(Recorder &r) {
  usePrograms();
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  glColor4f(1, 0.5f, 0, 1);
  glTexCoord2f(0.25f, 0.75f);
  tint(1, 1, 1);
  glRectf(-1, -1, 0, 0);
  glColor3f(0, 0.5f, 1);
  tint(1, 0.5f, 1);
  glEndList();
  glNewList(list + 1, GL_COMPILE);
  glRectf(0, 0, 1, 1);
  glEndList();
  glCallList(list);
  glCallList(list + 1);
  glRectf(-1, 0, 0, 1);
  GLfloat color[4] = {}, coordinates[4] = {};
  glGetFloatv(GL_CURRENT_COLOR, color);
  glGetFloatv(GL_CURRENT_TEXTURE_COORDS, coordinates);
  r.value("blue", color[2]);
  r.value("t", coordinates[1]);
  r.picture("three rectangles");
}

/// Tests other commands in lists that draw with or read what is effective.
void pixelsInLists(Recorder &r) {
  usePrograms();
  const GLubyte texels[16] = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  const GLubyte bits[8] = {0xAA, 0x55, 0xAA, 0x55, 0xAA, 0x55, 0xAA, 0x55};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  tint(1, 1, 1);
  glColor4f(1, 1, 0, 1);
  glRasterPos2f(-1, -1);
  glPixelZoom(16, 16);
  glDrawPixels(2, 2, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glPixelZoom(1, 1);
  tint(0.5f, 1, 0);
  glRasterPos2f(0, 0);
  glBitmap(8, 8, 0, 0, 8, 8, bits);
  glBitmap(8, 8, 0, 0, 8, 8, bits);
  tint(1, 0, 0);
  glRasterPos2f(-1, 0.25f);
  glCopyPixels(0, 0, 16, 16, GL_COLOR);
  glEndList();
  glCallList(list);
  r.picture("called");
}

void evaluators(Recorder &r) {
  usePrograms();
  const GLfloat points[12] = {-0.9f, -0.9f, 0, 0.9f, -0.9f, 0, -0.9f, 0.9f, 0, 0.9f, 0.9f, 0};
  const GLfloat colors[16] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 0, 1};
  glMap2f(GL_MAP2_VERTEX_3, 0, 1, 3, 2, 0, 1, 6, 2, points);
  glMap2f(GL_MAP2_COLOR_4, 0, 1, 4, 2, 0, 1, 8, 2, colors);
  glEnable(GL_MAP2_VERTEX_3);
  glEnable(GL_MAP2_COLOR_4);
  glMapGrid2f(6, 0, 1, 6, 0, 1);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  tint(1, 1, 0);
  glEvalMesh2(GL_FILL, 0, 6, 0, 3);
  tint(0, 1, 1);
  glEvalMesh2(GL_FILL, 0, 6, 3, 6);
  glEndList();
  glCallList(list);
  r.picture("two halves");
}

/// Tests that vertex arrays are read when a list is compiled.
void arraysInLists(Recorder &r) {
  usePrograms();
  GLfloat corners[8] = {-1, -1, 0, -1, 0, 0, -1, 0};
  const GLubyte indexes[4] = {0, 1, 2, 3};
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_FLOAT, 0, corners);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glColor4f(1, 1, 0, 1);
  glDrawArrays(GL_QUADS, 0, 4);
  glProgramEnvParameter4fARB(kVertex, 0, 1, 1, 0, 0);
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indexes);
  tint(0, 1, 1);
  glProgramEnvParameter4fARB(kVertex, 0, 1, 0, 0, 0);
  glBegin(GL_QUADS);
  for (GLint i = 0; i < 4; ++i)
    glArrayElement(i);
  glEnd();
  glEndList();
  std::memset(corners, 0, sizeof corners);
  glCallList(list);
  r.picture("as compiled");
}

/// Tests the diagonal along which quads are split: lists use another one than immediate mode.
void quadsInLists(Recorder &r) {
  usePrograms();
  gradient(-1, -1, 0, 0);
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  gradient(0, -1, 1, 0);
  glBegin(GL_QUAD_STRIP);
  glColor4f(1, 0, 0, 1), glVertex2f(0, 0);
  glColor4f(0, 1, 0, 1), glVertex2f(0, 1);
  glColor4f(0, 0, 1, 1), glVertex2f(0.5f, 0);
  glColor4f(1, 1, 1, 1), glVertex2f(0.5f, 1);
  glColor4f(1, 0, 0, 1), glVertex2f(1, 0);
  glColor4f(0, 1, 1, 1), glVertex2f(1, 1);
  glEnd();
  glRectf(-0.5f, -0.5f, 0.25f, 0.25f);
  glEndList();
  glCallList(list);
  glNewList(list + 1, GL_COMPILE_AND_EXECUTE);
  gradient(-1, 0, 0, 1);
  glEndList();
  r.picture("immediate, called, executed");
  glClear(GL_COLOR_BUFFER_BIT);
  glCallList(list + 1);
  r.picture("executed, then called");
}

} // namespace

const std::vector<Case> kListCases = {
    {"list-every-command", everyCommand,
     "reads on past the end of its own copy of a recorded string"},
    {"list-compile-and-execute", compileAndExecute,
     "reads on past the end of its own copy of a recorded string"},
    {"list-errors", errorsInLists, "reads on past the end of its own copy of a recorded string"},
    {"list-not-compiled", notCompiled},
    {"list-program-deleted", programDeleted},
    {"list-named-commands", namedCommands,
     "reads on past the end of its own copy of a recorded string"},
    {"list-is-and-delete", isListAndDelete},
    {"list-redefined", redefined},
    {"list-current-values", currentValues},
    {"list-pixels", pixelsInLists},
    {"list-evaluators", evaluators},
    {"list-arrays", arraysInLists},
    {"list-quads", quadsInLists},
};

} // namespace paths
