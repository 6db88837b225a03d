// The application's own GLSL beside assembly programs: alternating, for one of the stages,
// pipelines, transform feedback.
#include <array>

#include "harness.h"

namespace paths {

namespace {

constexpr char kVertexText[] =
    "uniform vec4 shift;\nvoid main() { gl_Position = gl_Vertex + shift;\n"
    "  gl_FrontColor = gl_Color.gbra; gl_TexCoord[0] = gl_Color; }";
constexpr char kFragmentText[] = "uniform vec4 scale;\nvoid main() { gl_FragColor = gl_Color * "
                                 "scale; }";

void alternating(Recorder &r) {
  const Programs programs = usePrograms();
  const GLuint both = makeGlsl(kVertexText, kFragmentText);
  const GLuint vertices = makeGlsl(kVertexText, nullptr);
  const GLuint fragments = makeGlsl(nullptr, kFragmentText);
  for (int i = 0; i < 3; ++i) {
    const float y = float(i) * 0.6f - 1;
    tint(1, float(i) / 2, 1);
    glUseProgram(both);
    glUniform4f(glGetUniformLocation(both, "scale"), 1, 1, float(i) / 2, 1);
    gradient(-1, y, -0.6f, y + 0.4f);
    glUseProgram(0);
    gradient(-0.6f, y, -0.2f, y + 0.4f);
    glUseProgram(vertices);
    gradient(-0.2f, y, 0.2f, y + 0.4f);
    glUseProgram(fragments);
    glUniform4f(glGetUniformLocation(fragments, "scale"), float(i) / 2, 1, 1, 1);
    gradient(0.2f, y, 0.6f, y + 0.4f);
    r.value("current", integer(GL_CURRENT_PROGRAM) == GLint(fragments));
    glUseProgram(0);
    gradient(0.6f, y, 1, y + 0.4f);
    r.value("bound", programiv(GL_PROGRAM_BINDING_ARB) == GLint(programs.fragment));
  }
  r.picture("fifteen quads");
}

/// Tests every combination of GLSL, assembly and fixed function in the stages.
void everyCombination(Recorder &r) {
  usePrograms();
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0, 0);
  tint(1, 0.75f, 0.5f);
  const GLuint vertices = makeGlsl(kVertexText, nullptr);
  const GLuint fragments = makeGlsl(nullptr, kFragmentText);
  glUseProgram(fragments);
  glUniform4f(glGetUniformLocation(fragments, "scale"), 0.5f, 1, 1, 1);
  int cell = 0;
  for (const GLuint glsl : {0u, vertices, fragments})
    for (const bool vertex : {false, true})
      for (const bool fragment : {false, true}) {
        glUseProgram(glsl);
        (vertex ? glEnable : glDisable)(kVertex);
        (fragment ? glEnable : glDisable)(kFragment);
        const float x = float(cell % 4) * 0.5f - 1, y = float(cell / 4) * 0.5f - 1;
        gradient(x, y, x + 0.45f, y + 0.45f);
        ++cell;
      }
  r.picture("twelve combinations");
}

/// Tests that a shader still works after it was detached from the linked program.
void detachedAfterLinking(Recorder &r) {
  usePrograms();
  tint(1, 0, 0);
  for (const bool withFragments : {true, false}) {
    const GLuint program = makeGlsl(
        kVertexText, withFragments ? "void main() { gl_FragColor = vec4(0, 1, 1, 1); }" : nullptr);
    std::array<GLuint, 4> shaders{};
    GLsizei count = 0;
    glGetAttachedShaders(program, 4, &count, shaders.data());
    for (GLsizei i = 0; i < count; ++i) {
      glDetachShader(program, shaders[std::size_t(i)]);
      glDeleteShader(shaders[std::size_t(i)]);
    }
    glUseProgram(program);
    gradient(withFragments ? -1 : 0, -1, withFragments ? 0 : 1, 1);
    r.value("shaders", count);
  }
  r.picture("shaded all the same");
  glUseProgram(0);
  gradient(-0.2f, -0.2f, 0.2f, 0.2f);
  r.picture("without");
}

/// Tests a shader that is attached but not linked: the executable is that of the last LinkProgram.
void attachedAfterLinking(Recorder &r) {
  usePrograms();
  tint(1, 1, 0);
  const GLuint program = makeGlsl(kVertexText, nullptr);
  const GLuint shader = glCreateShader(GL_FRAGMENT_SHADER);
  const char *const text = "void main() { gl_FragColor = vec4(0, 1, 1, 1); }";
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glUseProgram(program);
  gradient(-1, -1, 0, 1);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  r.check(linked != 0, "linked");
  gradient(0, -1, 1, 0);
  r.pixel("with the shader", 48, 16, {0, 255, 255, 255});
  // A failed link leaves the effective program.
  const char *const bad = "void main() { nothing; }";
  glShaderSource(shader, 1, &bad, nullptr);
  glCompileShader(shader);
  glLinkProgram(program);
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  r.check(linked == 0, "a link that fails");
  r.errors("failed link");
  gradient(0, 0, 1, 1);
  r.errors("after it");
  r.pixel("with the executable that stays", 48, 48, {0, 255, 255, 255});
  r.picture("three states");
}

/// Tests ARB_shader_objects' names of the same calls.
void objectApi(Recorder &r) {
  if (!epoxy_has_gl_extension("GL_ARB_shader_objects"))
    return r.skip("GL_ARB_shader_objects is not offered here");
  usePrograms();
  const GLhandleARB program = glCreateProgramObjectARB();
  const GLhandleARB vertex = glCreateShaderObjectARB(GL_VERTEX_SHADER_ARB);
  const char *text = kVertexText;
  glShaderSourceARB(vertex, 1, &text, nullptr);
  glCompileShaderARB(vertex);
  glAttachObjectARB(program, vertex);
  glLinkProgramARB(program);
  tint(0, 1, 1);
  gradient(-1, -1, 0, 0);
  r.value("handle", glGetHandleARB(GL_PROGRAM_OBJECT_ARB) == 0);
  glUseProgramObjectARB(program);
  r.value("handle", glGetHandleARB(GL_PROGRAM_OBJECT_ARB) == program);
  glUniform4fARB(glGetUniformLocationARB(program, "shift"), 0.1f, 0.1f, 0, 0);
  gradient(0, -1, 0.8f, 0);
  glDeleteObjectARB(program);
  gradient(-1, 0, 0, 0.8f);
  glUseProgramObjectARB(0);
  gradient(0, 0.2f, 0.8f, 1);
  GLint deleted = 1;
  glGetObjectParameterivARB(program, GL_OBJECT_DELETE_STATUS_ARB, &deleted);
  r.errors("a handle that is gone");
  r.picture("four quads");
}

GLuint separable(GLenum stage, const char *text) { return glCreateShaderProgramv(stage, 1, &text); }

void pipelines(Recorder &r) {
  usePrograms();
  tint(1, 0.5f, 1);
  const GLuint vertex =
      separable(GL_VERTEX_SHADER, "#version 120\nvoid main() { gl_Position = gl_Vertex;\n"
                                  "  gl_FrontColor = gl_Color.brga; }");
  const GLuint fragment = separable(GL_FRAGMENT_SHADER, "#version 120\nvoid main() { gl_FragColor "
                                                        "= gl_Color * vec4(1, 1, 0.5, 1); }");
  GLuint pipeline = 0;
  glGenProgramPipelines(1, &pipeline);
  glBindProgramPipeline(pipeline);
  gradient(-1, -1, -0.5f, -0.5f); // no stage
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, vertex);
  gradient(-0.5f, -1, 0, -0.5f); // vertices
  glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, fragment);
  gradient(0, -1, 0.5f, -0.5f); // both
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, 0);
  gradient(0.5f, -1, 1, -0.5f); // fragments
  glUseProgramStages(pipeline, GL_ALL_SHADER_BITS, 0);
  gradient(-1, 0, -0.5f, 0.5f);
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, vertex);
  glDisable(kFragment);
  gradient(-0.5f, 0, 0, 0.5f);
  glEnable(kFragment);
  tint(0, 1, 1);
  gradient(0, 0, 0.5f, 0.5f);
  glUseProgram(makeGlsl(kVertexText, kFragmentText)); // overrides the pipeline
  gradient(0.5f, 0, 1, 0.5f);
  glUseProgram(0);
  gradient(-1, 0.5f, -0.5f, 1);
  glBindProgramPipeline(0);
  gradient(-0.5f, 0.5f, 0, 1);
  r.errors("pipelines");
  r.picture("every mixture");
  r.value("pipeline", integer(GL_PROGRAM_PIPELINE_BINDING));
}

/// Tests transform feedback by the application's GLSL between draws of assembly programs.
void transformFeedback(Recorder &r) {
  usePrograms();
  const GLuint program = makeGlsl(
      "varying vec4 seen;\nvoid main() { seen = gl_Vertex * 2.0; gl_Position = gl_Vertex;\n"
      "  gl_FrontColor = vec4(1, 1, 0, 1); }",
      "varying vec4 seen;\nvoid main() { gl_FragColor = gl_Color + 0.1 * seen; }");
  const char *const names[] = {"seen"};
  glTransformFeedbackVaryings(program, 1, names, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 1024, nullptr, GL_STREAM_READ);
  gradient(-1, -1, 0, 0);
  glBeginTransformFeedback(GL_TRIANGLES);
  r.errors("begun without a program");
  glUseProgram(program);
  glBeginTransformFeedback(GL_TRIANGLES);
  glBegin(GL_TRIANGLES);
  glVertex2f(0, 0), glVertex2f(1, 0), glVertex2f(0.5f, 1);
  glEnd();
  glUseProgram(0);
  r.errors("UseProgram while it is active");
  glEndTransformFeedback();
  glUseProgram(0);
  gradient(-1, 0, 0, 1);
  std::array<GLfloat, 12> captured{};
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof captured, captured.data());
  for (const GLfloat value : captured)
    r.value("captured", value);
  r.picture("between draws");
}

/// Tests a geometry shader, which needs GLSL vertices; the fragments may come from an assembly
/// program.
void geometryShader(Recorder &r) {
  usePrograms();
  tint(1, 1, 0.5f);
  const GLuint program = glCreateProgram();
  const std::array<std::pair<GLenum, const char *>, 2> stages = {
      {{GL_VERTEX_SHADER, "#version 150 compatibility\nvoid main() { gl_Position = gl_Vertex;\n"
                          "  gl_FrontColor = gl_Color; }"},
       {GL_GEOMETRY_SHADER,
        "#version 150 compatibility\nlayout(triangles) in;\n"
        "layout(triangle_strip, max_vertices = 3) out;\n"
        "void main() { for (int i = 0; i < 3; ++i) { gl_Position = gl_in[i].gl_Position * "
        "vec4(0.5, 0.5, 1, 1);\n gl_FrontColor = gl_in[i].gl_FrontColor.brga; EmitVertex(); } }"}}};
  for (const auto &[type, text] : stages) {
    const GLuint shader = glCreateShader(type);
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (!linked)
    return r.skip("the host lacks it: geometry shaders");
  glUseProgram(program);
  glBegin(GL_TRIANGLES);
  glColor4f(1, 0, 0, 1), glVertex2f(-1, -1);
  glColor4f(0, 1, 0, 1), glVertex2f(1, -1);
  glColor4f(0, 0, 1, 1), glVertex2f(0, 1);
  glEnd();
  r.errors("geometry");
  r.picture("half the size");
}

/// Tests that no query about programs reveals the layer's linked program.
void nothingShows(Recorder &r) {
  usePrograms();
  gradient(-1, -1, 0, 0);
  r.value("current", integer(GL_CURRENT_PROGRAM));
  for (GLuint name = 1; name < 20; ++name)
    r.value("known", glIsProgram(name) + 2 * glIsShader(name));
  glUniform1f(0, 1);
  r.errors("uniform");
  const GLuint program = makeGlsl(kVertexText, kFragmentText);
  r.value("is one", glIsProgram(program));
  gradient(0, 0, 1, 1);
  glUseProgram(program);
  GLfloat value[4] = {};
  const GLint where = glGetUniformLocation(program, "scale");
  glUniform4f(where, 1, 2, 3, 4);
  glGetUniformfv(program, where, value);
  r.value("uniform", value[2]);
  glUseProgram(0);
  gradient(0, -1, 1, 0);
  glValidateProgram(program);
  glDeleteProgram(program);
  r.value("deleted", glIsProgram(program));
  gradient(-1, 0, 0, 1);
  r.picture("four quads");
}

} // namespace

const std::vector<Case> kGlslCases = {
    {"glsl-alternating", alternating},
    {"glsl-every-combination", everyCombination},
    {"glsl-detached-after-linking", detachedAfterLinking},
    {"glsl-attached-after-linking", attachedAfterLinking,
     "does not take up a stage that the current program gains by LinkProgram"},
    {"glsl-object-api", objectApi},
    {"glsl-pipelines", pipelines},
    {"glsl-transform-feedback", transformFeedback},
    {"glsl-geometry-shader", geometryShader},
    {"glsl-nothing-shows", nothingShows},
};

} // namespace paths
