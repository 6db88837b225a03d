// Vertex programs that cannot be written in ARB's language, as they choose between values, with
// fragment programs. The way the host runs the two must be invisible. Needs a profile that has the
// languages (nv40).
#include <memory>
#include <string>

#include "nv_commands.h"

namespace api::nv {
namespace {

/// Returns a program whose color is env[1] if env[0].x is above zero, else the vertex's.
std::string choosing(const std::string &more = "") {
  return "!!ARBvp1.0\nOPTION NV_vertex_program2;\nTEMP r, c;\n"
         "MOV result.position, vertex.position;\nMOV r, vertex.color;\n"
         "MOVC c.x, program.env[0].x;\nMOV r (GT.x), program.env[1];\n"
         "MOV result.color, r;\n" +
         more + "END\n";
}
constexpr char kThroughFp[] = "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND";
constexpr char kSwapFp[] = "!!ARBfp1.0\nMOV result.color, fragment.color.yxzw;\nEND";
/// Outputs the color times env[2], plus local[0].
constexpr char kScaledFp[] = "!!ARBfp1.0\nMAD result.color, fragment.color, program.env[2], "
                             "program.local[0];\nEND";
constexpr char kThroughArb[] = "!!ARBvp1.0\nMOV result.position, vertex.position;\n"
                               "MOV result.color, vertex.color;\nEND";

class NvStages : public NvTest {
protected:
  void SetUp() override {
    NvTest::SetUp();
    if (IsSkipped())
      return;
    glEnable(kVertex);
    glEnable(kFragment);
    m_vertex = makeProgram(choosing(), kVertex);
    m_fragment = makeProgram(kThroughFp);
    setColor(1, 0, 0);
    choose(true);
    ASSERT_EQ(glGetError(), GLenum(GL_NO_ERROR)) << glGetString(GL_PROGRAM_ERROR_STRING_ARB);
  }

  /// Sets the color that the program chooses instead of blue.
  static void setColor(GLfloat r, GLfloat g, GLfloat b) {
    glProgramEnvParameter4fARB(kVertex, 1, r, g, b, 1);
  }
  static void choose(bool other) {
    glProgramEnvParameter4fARB(kVertex, 0, other ? 1.0f : -1.0f, 0, 0, 0);
  }

  GLuint m_vertex = 0, m_fragment = 0;
};

TEST_F(NvStages, ParametersOfEitherStage) {
  EXPECT_EQ(drawn(), kRedPixel);
  choose(false);
  EXPECT_EQ(drawn(), kBluePixel);
  const GLuint scaled = makeProgram(kScaledFp);
  glProgramEnvParameter4fARB(kFragment, 2, 0, 0, 0, 1);
  glProgramLocalParameter4fARB(kFragment, 0, 0, 1, 0, 0);
  EXPECT_EQ(drawn(), kGreenPixel);
  glProgramEnvParameter4fARB(kFragment, 2, 0, 0, 1, 1);
  glProgramLocalParameter4fARB(kFragment, 0, 0, 0, 0, 0);
  EXPECT_EQ(drawn(), kBluePixel);
  choose(true);
  setColor(0, 0, 1);
  EXPECT_EQ(drawn(), kBluePixel);
  glBindProgramARB(kFragment, m_fragment);
  setColor(0, 1, 0);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDeleteProgramsARB(1, &scaled);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(NvStages, EitherStageIsLoadedAnew) {
  EXPECT_EQ(drawn(), kRedPixel);
  api::load(kSwapFp);
  EXPECT_EQ(drawn(), kGreenPixel);
  api::load(choosing("MOV result.color, r.yxzw;\n"), kVertex);
  EXPECT_EQ(drawn(), kRedPixel);
  for (int i = 0; i < 8; ++i) {
    api::load(choosing("MOV result.texcoord[1], {" + std::to_string(i) + "};\n"), kVertex);
    EXPECT_EQ(drawn(), kGreenPixel);
    api::load(i % 2 != 0 ? kSwapFp : kThroughFp);
    EXPECT_EQ(drawn(), i % 2 != 0 ? kGreenPixel : kRedPixel);
    api::load(kSwapFp);
  }
}

TEST_F(NvStages, InTurnsWithProgramsOfTheArbAndFixedFunction) {
  const GLuint through = makeProgram(kThroughArb, kVertex), swap = makeProgram(kSwapFp);
  for (int turn = 0; turn < 3; ++turn) {
    glBindProgramARB(kFragment, m_fragment);
    glBindProgramARB(kVertex, m_vertex);
    EXPECT_EQ(drawn(), kRedPixel);
    glBindProgramARB(kVertex, through);
    EXPECT_EQ(drawn(), kBluePixel);
    glBindProgramARB(kFragment, swap);
    glBindProgramARB(kVertex, m_vertex);
    EXPECT_EQ(drawn(), kGreenPixel);
    glDisable(kFragment);
    EXPECT_EQ(drawn(), kRedPixel) << "fixed function's fragments";
    glDisable(kVertex);
    EXPECT_EQ(drawn(), kBluePixel) << "fixed function";
    glEnable(kFragment);
    EXPECT_EQ(drawn(), kBluePixel) << "fixed function's vertices";
    glEnable(kVertex);
    EXPECT_EQ(drawn(), kGreenPixel);
  }
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(kVertex);
  EXPECT_EQ(drawn(), kBluePixel);
  glPopAttrib();
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(NvStages, NothingOfTheHostsShows) {
  NEEDS("GL_ARB_separate_shader_objects");
  EXPECT_EQ(drawn(), kRedPixel);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0);
  EXPECT_EQ(integer(GL_PROGRAM_PIPELINE_BINDING), 0);
  GLfloat binding = -1;
  glGetFloatv(GL_PROGRAM_PIPELINE_BINDING, &binding);
  EXPECT_EQ(binding, 0.0f);
  for (GLuint name = 1; name < 64; ++name) {
    EXPECT_FALSE(glIsProgramPipeline(name)) << name;
    EXPECT_FALSE(glIsProgram(name)) << name;
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBindProgramPipeline(name));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glValidateProgramPipeline(name));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glActiveShaderProgram(name, 0));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glUseProgramStages(name, GL_FRAGMENT_SHADER_BIT, 0));
    EXPECT_NO_GL_ERROR(glDeleteProgramPipelines(1, &name));
  }
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glUniform4f(0, 1, 1, 1, 1));
  EXPECT_EQ(drawn(), kRedPixel);
  EXPECT_GL_ERROR(GL_INVALID_VALUE, glDeleteProgramPipelines(-1, nullptr));
}

TEST_F(NvStages, BesideTheApplicationsGlsl) {
  const GLuint both = makeGlsl("void main() { gl_Position = gl_Vertex; }",
                               "void main() { gl_FragColor = vec4(0, 1, 0, 1); }");
  EXPECT_EQ(drawn(), kRedPixel);
  glUseProgram(both);
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), GLint(both));
  EXPECT_EQ(drawn(), kGreenPixel);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kRedPixel);
  glNewList(1, GL_COMPILE);
  glUseProgram(both);
  glEndList();
  glNewList(2, GL_COMPILE);
  glUseProgram(0);
  glEndList();
  glCallList(1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glCallList(2);
  EXPECT_EQ(drawn(), kRedPixel);
  glDeleteLists(1, 2);
  glDeleteProgram(both);
}

TEST_F(NvStages, BesideTheApplicationsPipelines) {
  NEEDS("GL_ARB_separate_shader_objects");
  const char *const text = "void main() { gl_FragColor = vec4(0, 1, 0, 1); }";
  const GLuint green = glCreateShaderProgramv(GL_FRAGMENT_SHADER, 1, &text);
  EXPECT_EQ(drawn(), kRedPixel);
  GLuint pipeline = 0;
  glGenProgramPipelines(1, &pipeline);
  glUseProgramStages(pipeline, GL_FRAGMENT_SHADER_BIT, green);
  EXPECT_EQ(drawn(), kRedPixel);
  const char *const vertex = "void main() { gl_Position = gl_Vertex; }";
  const GLuint whole = glCreateShaderProgramv(GL_VERTEX_SHADER, 1, &vertex);
  glUseProgramStages(pipeline, GL_VERTEX_SHADER_BIT, whole);
  glBindProgramPipeline(pipeline);
  EXPECT_EQ(integer(GL_PROGRAM_PIPELINE_BINDING), GLint(pipeline));
  EXPECT_EQ(drawn(), kGreenPixel);
  glBindProgramPipeline(0);
  EXPECT_EQ(drawn(), kRedPixel);
  // Binding a pipeline is not recorded in a list.
  glNewList(1, GL_COMPILE);
  glBindProgramPipeline(pipeline);
  glEndList();
  EXPECT_EQ(integer(GL_PROGRAM_PIPELINE_BINDING), GLint(pipeline));
  EXPECT_EQ(drawn(), kGreenPixel);
  glDeleteProgramPipelines(1, &pipeline); // unbinds it
  EXPECT_EQ(integer(GL_PROGRAM_PIPELINE_BINDING), 0);
  EXPECT_EQ(drawn(), kRedPixel);
  glCallList(1);
  EXPECT_EQ(drawn(), kRedPixel);
  glDeleteLists(1, 1);
  glDeleteProgram(green);
  glDeleteProgram(whole);
}

TEST_F(NvStages, DisplayLists) {
  const GLuint through = makeProgram(kThroughArb, kVertex), swap = makeProgram(kSwapFp);
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE}) {
    glNewList(1, mode);
    glBindProgramARB(kVertex, m_vertex);
    glBindProgramARB(kFragment, swap);
    drawQuad();
    glBindProgramARB(kVertex, through);
    glBindProgramARB(kFragment, m_fragment);
    glEndList();
    glNewList(2, mode);
    drawQuad();
    glEndList();
    clear();
    glCallList(1);
    EXPECT_EQ(readPixel(), kGreenPixel);
    EXPECT_EQ(drawn(), kBluePixel);
    glBindProgramARB(kVertex, m_vertex);
    clear();
    glCallList(2);
    EXPECT_EQ(readPixel(), kRedPixel);
    choose(false);
    clear();
    glCallList(2);
    EXPECT_EQ(readPixel(), kBluePixel);
    choose(true);
    glDeleteLists(1, 2);
  }
}

TEST_F(NvStages, FeedbackAndTheRasterPosition) {
  EXPECT_EQ(drawn(), kRedPixel);
  GLfloat buffer[64] = {};
  glFeedbackBuffer(64, GL_3D_COLOR, buffer);
  glRenderMode(GL_FEEDBACK);
  glBegin(GL_POINTS);
  glVertex2f(0, 0);
  glEnd();
  ASSERT_EQ(glRenderMode(GL_RENDER), 8);
  EXPECT_EQ(buffer[4], 1.0f) << "the program's colour";
  EXPECT_EQ(drawn(), kRedPixel);
  setColor(0, 1, 0);
  glRasterPos2f(0.5f, 0);
  GLfloat color[4] = {}, position[4] = {};
  glGetFloatv(GL_CURRENT_RASTER_COLOR, color);
  glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
  EXPECT_EQ(color[1], 1.0f);
  EXPECT_NEAR(position[0], 24.0f, 0.01f);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(NvStages, ResultsThatNothingWrites) {
  api::load("!!ARBfp1.0\nADD result.color, fragment.texcoord[2], fragment.color.secondary;\nEND");
  EXPECT_EQ(drawn(), (Pixel{0, 0, 0, 255}));
  api::load(choosing("MOV result.texcoord[2], r;\n"), kVertex);
  EXPECT_EQ(drawn(), kRedPixel);
  api::load(choosing("MOV result.color.secondary, r.yxzw;\n"), kVertex);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(NvStages, SidesPointsAndFog) {
  api::load(choosing("MOV result.color.back, r.yxzw;\n"), kVertex);
  glEnable(GL_VERTEX_PROGRAM_TWO_SIDE);
  EXPECT_EQ(drawn(), kRedPixel);
  glFrontFace(GL_CW);
  EXPECT_EQ(drawn(), kGreenPixel);
  glFrontFace(GL_CCW);
  glDisable(GL_VERTEX_PROGRAM_TWO_SIDE);

  api::load(choosing("MOV result.pointsize.x, 12.0;\n"), kVertex);
  glEnable(GL_VERTEX_PROGRAM_POINT_SIZE);
  clear();
  glBegin(GL_POINTS);
  glVertex2f(0, 0);
  glEnd();
  EXPECT_EQ(readPixel(20, 16), kRedPixel);
  EXPECT_EQ(readPixel(24, 16), kBlack);
  glDisable(GL_VERTEX_PROGRAM_POINT_SIZE);

  api::load("!!ARBfp1.0\nOPTION ARB_fog_linear;\nMOV result.color, fragment.color;\nEND");
  const GLfloat green[] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, green);
  api::load(choosing("MOV result.fogcoord.x, 1.0;\n"), kVertex);
  EXPECT_EQ(drawn(), kGreenPixel) << "at the end of the fog";
  api::load(choosing("MOV result.fogcoord.x, 0.0;\n"), kVertex);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(NvStages, DistancesClip) {
  api::load(choosing("MOV result.clip[1].x, vertex.position.x;\n"), kVertex);
  for (const bool clips : {false, true, false}) {
    (clips ? glEnable : glDisable)(GL_CLIP_PLANE1);
    (void)drawn();
    EXPECT_EQ(readPixel(4, 16), clips ? kBlack : kRedPixel);
    EXPECT_EQ(readPixel(20, 16), kRedPixel);
  }
}

TEST_F(NvStages, ContextsOfAShareGroup) {
  EXPECT_EQ(drawn(), kRedPixel);
  for (int i = 0; i < 4; ++i) {
    const GlContext second(&m_context);
    glEnable(kVertex);
    glEnable(kFragment);
    glBindProgramARB(kVertex, m_vertex);
    glBindProgramARB(kFragment, m_fragment);
    setColor(0, 1, 0);
    choose(true);
    api::load(kThroughFp);
    EXPECT_EQ(drawn(), kGreenPixel);
    api::load(i % 2 != 0 ? kThroughFp : kSwapFp);
    EXPECT_EQ(drawn(), i % 2 != 0 ? kGreenPixel : kRedPixel);
    m_context.makeCurrent();
    EXPECT_EQ(drawn(), i % 2 != 0 ? kRedPixel : kGreenPixel);
    second.makeCurrent();
    EXPECT_EQ(drawn(), i % 2 != 0 ? kGreenPixel : kRedPixel);
  }
  m_context.makeCurrent();
  EXPECT_EQ(drawn(), kRedPixel);
  {
    const GlContext second(&m_context);
    glDeleteProgramsARB(1, &m_vertex);
    glDeleteProgramsARB(1, &m_fragment);
  }
  m_context.makeCurrent();
  EXPECT_EQ(drawn(), kRedPixel) << "they live while they are bound";
  makeProgram(choosing(), kVertex);
  makeProgram(kSwapFp);
  EXPECT_EQ(drawn(), kGreenPixel);
}

} // namespace
} // namespace api::nv
