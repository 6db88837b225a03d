// Display lists and other state: attribute stacks, invalid programs, GLSL, other contexts.
#include "harness.h"

namespace paths {

namespace {

/// Tests a list of only the host's commands that is called while the effective program cannot draw:
/// its draws are errors, its other commands are not.
void plainListInvalid(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint list = glGenLists(3);
  glNewList(list, GL_COMPILE);
  glTranslatef(1, 2, 3);
  gradient();
  glColor4f(0.25f, 0.5f, 0.75f, 1);
  glEndList();
  glNewList(list + 1, GL_COMPILE);
  glTranslatef(1, 2, 3);
  glEndList();
  glNewList(list + 2, GL_COMPILE);
  glRasterPos2f(0, 0);
  glRectf(-1, -1, 1, 1);
  glEndList();
  for (const GLenum target : {kFragment, kVertex}) {
    const std::string name = target == kVertex ? "vertex" : "fragment";
    glBindProgramARB(target, 0);
    glLoadIdentity();
    glCallList(list);
    r.errors(name + ": a list that draws");
    r.picture(name + ": a list that draws");
    GLfloat matrix[16] = {}, color[4] = {};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix);
    glGetFloatv(GL_CURRENT_COLOR, color);
    r.value("translated", matrix[12]);
    r.value("green", color[1]);
    glCallList(list + 1);
    r.errors(name + ": a list that does not");
    glCallList(list + 2);
    r.errors(name + ": RasterPos and Rect");
    const GLuint names[] = {list, list + 1};
    glCallLists(2, GL_UNSIGNED_INT, names);
    r.errors(name + ": CallLists");
    glBegin(GL_QUADS);
    r.errors(name + ": Begin");
    glRectf(-1, -1, 1, 1);
    r.errors(name + ": Rect");
    glLoadIdentity();
    glBindProgramARB(target, target == kVertex ? programs.vertex : programs.fragment);
  }
  glCallList(list);
  r.errors("valid again");
  r.picture("valid again");
}

/// Tests the attribute stack in lists: balanced, across lists, across the program API's first use.
void attribStack(Recorder &r) {
  const GLuint first = glGenLists(6);
  glNewList(first, GL_COMPILE);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  glPopAttrib();
  glEndList();
  usePrograms();
  glNewList(first + 2, GL_COMPILE);
  glPushAttrib(GL_ENABLE_BIT | GL_CURRENT_BIT);
  glDisable(kVertex);
  glDisable(kFragment);
  glColor4f(1, 1, 0, 1);
  glRectf(-1, -1, -0.5f, 1);
  glPopAttrib();
  gradient(-0.4f, -1, 0, 1);
  glEndList();
  glCallList(first + 2);
  r.picture("in one list");
  r.value("fragment enabled", glIsEnabled(kFragment));
  r.value("vertex enabled", glIsEnabled(kVertex));
  // One list pushes and another pops; both are older than the programs.
  glCallList(first);
  glDisable(kFragment);
  r.value("depth", integer(GL_ATTRIB_STACK_DEPTH));
  glCallList(first + 1);
  r.value("restored by a list", glIsEnabled(kFragment));
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  glDisable(kVertex);
  glCallList(first + 1);
  r.value("pushed outside, popped by a list", glIsEnabled(kFragment) + 2 * glIsEnabled(kVertex));
  glCallList(first);
  glDisable(kVertex);
  glPopAttrib();
  r.value("pushed by a list, popped outside", glIsEnabled(kFragment) + 2 * glIsEnabled(kVertex));
  glNewList(first + 3, GL_COMPILE_AND_EXECUTE);
  glPushAttrib(GL_LIGHTING_BIT);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  glPushAttrib(GL_COLOR_BUFFER_BIT);
  glPopAttrib();
  glCallList(first + 1);
  r.value("inner pop", glIsEnabled(kFragment));
  glPopAttrib();
  glEndList();
  r.value("enabled", glIsEnabled(kFragment) + 2 * glIsEnabled(kVertex));
  r.value("depth", integer(GL_ATTRIB_STACK_DEPTH));
  glCallList(first + 3);
  r.value("enabled", glIsEnabled(kFragment) + 2 * glIsEnabled(kVertex));
  r.errors("so far");
  glCallList(first + 1);
  r.errors("underflow");
  for (int i = 0; i < integer(GL_MAX_ATTRIB_STACK_DEPTH) + 2; ++i)
    glCallList(first);
  r.errors("overflow");
  glDisable(kFragment);
  for (int i = 0; i < integer(GL_MAX_ATTRIB_STACK_DEPTH); ++i)
    glPopAttrib();
  r.errors("popped");
  r.value("enabled", glIsEnabled(kFragment) + 2 * glIsEnabled(kVertex));
}

/// Tests that client attributes are not part of lists, and contain no program state.
void clientAttributes(Recorder &r) {
  usePrograms();
  const GLfloat corners[8] = {-1, -1, 1, -1, 1, 1, -1, 1};
  const GLfloat colors[16] = {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 1};
  glVertexPointer(2, GL_FLOAT, 0, corners);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
  glColorPointer(4, GL_FLOAT, 0, colors);
  glEnableClientState(GL_COLOR_ARRAY);
  tint(1, 1, 0);
  glDrawArrays(GL_QUADS, 0, 4);
  glPopClientAttrib();
  glEndList();
  r.value("client depth", integer(GL_CLIENT_ATTRIB_STACK_DEPTH));
  r.value("colour array", glIsEnabled(GL_COLOR_ARRAY));
  glCallList(list);
  r.picture("called");
  if (epoxy_has_gl_extension("GL_EXT_direct_state_access")) {
    glPushClientAttribDefaultEXT(GL_CLIENT_ALL_ATTRIB_BITS);
    r.value("defaults", glIsEnabled(GL_VERTEX_ARRAY));
    glNewList(list, GL_COMPILE);
    tint(0, 1, 0);
    glPopClientAttrib();
    glEndList();
    r.value("back", glIsEnabled(GL_VERTEX_ARRAY));
    glCallList(list);
    glDrawArrays(GL_QUADS, 0, 4);
    r.picture("after the defaults");
  }
  r.value("client depth", integer(GL_CLIENT_ATTRIB_STACK_DEPTH));
}

/// Tests GLSL programs that lists make current, including nested lists.
void glslInLists(Recorder &r) {
  const GLuint first = glGenLists(5);
  const GLuint glsl = makeGlsl("uniform float high;\nvoid main() { gl_FrontColor = gl_Color.bgra;\n"
                               "  gl_Position = gl_Vertex + vec4(0.0, high, 0.0, 0.0); }",
                               "void main() { gl_FragColor = gl_Color; }");
  const GLuint vertices =
      makeGlsl("void main() { gl_FrontColor = gl_Color.grba; gl_Position = gl_Vertex; }", nullptr);
  glNewList(first, GL_COMPILE); // older than the programs
  glUseProgram(glsl);
  glEndList();
  glNewList(first + 1, GL_COMPILE);
  glUseProgram(0);
  glEndList();
  usePrograms();
  tint(1, 0.5f, 0);
  glCallList(first);
  r.value("current", integer(GL_CURRENT_PROGRAM) == GLint(glsl));
  gradient(-1, -1, -0.5f, -0.5f);
  glCallList(first + 1);
  r.value("current", integer(GL_CURRENT_PROGRAM));
  gradient(-0.5f, -1, 0, -0.5f);
  glNewList(first + 2, GL_COMPILE);
  glUseProgram(glsl);
  glUniform1f(glGetUniformLocation(glsl, "high"), 0.5f);
  gradient(0, -1, 0.5f, -0.5f);
  glCallList(first + 1);
  tint(0, 1, 1);
  gradient(0.5f, -1, 1, -0.5f);
  glUseProgram(vertices);
  gradient(-1, 0, -0.5f, 0.5f);
  glUseProgram(0);
  gradient(-0.5f, 0.5f, 0, 1);
  glEndList();
  r.value("current while compiled", integer(GL_CURRENT_PROGRAM));
  glCallList(first + 2);
  r.value("current", integer(GL_CURRENT_PROGRAM));
  r.picture("both kinds");
  glNewList(first + 3, GL_COMPILE_AND_EXECUTE);
  glUseProgram(glsl);
  r.value("current in the list", integer(GL_CURRENT_PROGRAM) == GLint(glsl));
  gradient(0, 0, 0.5f, 0.5f);
  glUseProgram(9999);
  glUseProgram(0);
  tint(1, 1, 0);
  gradient(0.5f, 0.5f, 1, 1);
  glEndList();
  r.errors("a program that is none");
  r.picture("compile and execute");
}

/// Tests a list with a feedback copy, on which the next draw depends.
void feedbackCopy(Recorder &r) {
  usePrograms();
  checkered(64);
  const GLuint list = glGenLists(2);
  glNewList(list + 1, GL_COMPILE);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 32, 64);
  glEndList();
  glNewList(list, GL_COMPILE);
  gradient(-1, -1, 1, 1);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, 64, 64);
  load("!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
       "SUB result.color, 1, t;\nEND");
  gradient(-1, -1, 0, 0);
  glCallList(list + 1);
  gradient(0, 0, 1, 1);
  glEndList();
  glCallList(list);
  r.picture("two passes");
}

void compiledThereCalledHere(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint list = glGenLists(2);
  glNewList(list, GL_COMPILE);
  glBindProgramARB(kVertex, programs.vertex);
  glBindProgramARB(kFragment, programs.fragment);
  glEnable(kVertex);
  glEnable(kFragment);
  glProgramEnvParameter4fARB(kVertex, 0, 0.2f, 0.2f, 0, 0);
  gradient(-1, -1, 0, 0);
  glEndList();
  const GLXContext other = createContext(mainContext());
  makeCurrent(other);
  glViewport(0, 0, kSize, kSize);
  r.value("enabled there", glIsEnabled(kFragment));
  glCallList(list);
  r.picture("called there");
  r.value("enabled there", glIsEnabled(kFragment));
  glNewList(list, GL_COMPILE); // edited there
  glProgramEnvParameter4fARB(kVertex, 0, 0.5f, 0.5f, 0, 0);
  tint(1, 0, 1);
  gradient(-1, -1, 0, 0);
  glEndList();
  glFlush();
  makeCurrent(mainContext());
  glCallList(list);
  r.picture("edited there, called here");
  destroyContext(other);
  glNewList(list + 1, GL_COMPILE);
  glCallList(list);
  glEndList();
  glCallList(list + 1);
  r.picture("its author is gone");
  r.value("is list", glIsList(list));
}

} // namespace

const std::vector<Case> kListStateCases = {
    {"list-plain-invalid", plainListInvalid},
    {"list-attribute-stack", attribStack},
    {"list-client-attributes", clientAttributes},
    {"list-glsl", glslInLists},
    {"list-feedback-copy", feedbackCopy,
     "reads on past the end of its own copy of a recorded string"},
    {"list-of-another-context", compiledThereCalledHere},
};

} // namespace paths
