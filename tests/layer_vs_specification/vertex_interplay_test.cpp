// Vertex programs with the rest of GL: lists, feedback and selection, the application's GLSL, share
// groups, and fixed-function passes over the same geometry.
#include <cmath>
#include <vector>

#include "vertex_draws.h"

namespace api {
namespace {

TEST_F(VertexDraws, DisplayLists) {
  const GLuint red = makeProgram(through("MOV result.color, {1,0,0,1};"), kVertex);
  const GLuint tinted = makeProgram(through("MOV result.color, program.env[0];"), kVertex);
  glNewList(1, GL_COMPILE);
  glBindProgramARB(kVertex, red);
  drawQuad();
  glEndList();
  glNewList(2, GL_COMPILE);
  glProgramEnvParameter4fARB(kVertex, 0, 0, 1, 0, 1);
  glBindProgramARB(kVertex, tinted);
  drawQuad();
  glEndList();
  clear();
  glCallList(1);
  EXPECT_EQ(readPixel(), kRedPixel);
  glCallList(2);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glNewList(3, GL_COMPILE_AND_EXECUTE);
  glBindProgramARB(kVertex, red);
  drawQuad();
  glEndList();
  EXPECT_EQ(readPixel(), kRedPixel);
  glDeleteLists(1, 3);
}

TEST_F(VertexDraws, FeedbackMode) {
  makeProgram("!!ARBvp1.0\nADD result.position, vertex.position, {0.5, 0, 0, 0};\n"
              "MOV result.color, {0,1,0,1};\nEND",
              kVertex);
  GLfloat buffer[64] = {};
  glFeedbackBuffer(64, GL_3D_COLOR, buffer);
  glRenderMode(GL_FEEDBACK);
  glBegin(GL_POINTS);
  glVertex2f(0, 0);
  glEnd();
  ASSERT_EQ(glRenderMode(GL_RENDER), 8);
  EXPECT_EQ(buffer[0], GLfloat(GL_POINT_TOKEN));
  EXPECT_NEAR(buffer[1], 24.0f, 0.01f) << "the program's position";
  EXPECT_NEAR(buffer[2], 16.0f, 0.01f);
  EXPECT_EQ(buffer[5], 1.0f) << "the program's colour";
}

TEST_F(VertexDraws, SelectionMode) {
  makeProgram("!!ARBvp1.0\nADD result.position, vertex.position, program.env[0];\nEND", kVertex);
  const auto hits = [] {
    GLuint buffer[16] = {};
    glSelectBuffer(16, buffer);
    glRenderMode(GL_SELECT);
    glInitNames();
    glPushName(42);
    glRectf(-0.5f, -0.5f, 0.5f, 0.5f);
    return glRenderMode(GL_RENDER);
  };
  EXPECT_EQ(hits(), 1);
  glProgramEnvParameter4fARB(kVertex, 0, 5, 0, 0, 0);
  EXPECT_EQ(hits(), 0) << "the program moved it out of the volume";
}

TEST_F(VertexDraws, RasterPosIsTransformed) {
  makeProgram("!!ARBvp1.0\nADD result.position, vertex.position, {0.5, -0.25, 0, 0};\n"
              "MOV result.color, {0,1,0,1};\nEND",
              kVertex);
  glRasterPos2f(0, 0);
  GLfloat position[4] = {}, color[4] = {};
  glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
  glGetFloatv(GL_CURRENT_RASTER_COLOR, color);
  EXPECT_NEAR(position[0], 24.0f, 0.01f);
  EXPECT_NEAR(position[1], 12.0f, 0.01f);
  EXPECT_EQ(color[1], 1.0f);
  EXPECT_EQ(color[0], 0.0f);
  glRasterPos2f(2, 0);
  EXPECT_EQ(integer(GL_CURRENT_RASTER_POSITION_VALID), 0);
}

TEST_F(VertexDraws, BesideTheApplicationsGlsl) {
  makeProgram(through("MOV result.color, program.env[1];"), kVertex);
  glProgramEnvParameter4fARB(kVertex, 1, 1, 0, 0, 1);
  const GLuint swap = makeGlsl(nullptr, "void main() { gl_FragColor = gl_Color.grba; }");
  EXPECT_EQ(drawn(), kRedPixel);
  glUseProgram(swap);
  EXPECT_EQ(drawn(), kGreenPixel) << "GLSL fragments after an ARB vertex program";
  glProgramEnvParameter4fARB(kVertex, 1, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  glPushAttrib(GL_ALL_ATTRIB_BITS);
  glDisable(kVertex);
  EXPECT_EQ(drawn(), kBluePixel) << "fixed-function vertices";
  glPopAttrib();
  EXPECT_EQ(drawn(), kRedPixel);
  makeProgram("!!ARBvp1.0\nMOV result.position, nothing;\nEND", kVertex);
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, drawQuad());
  const GLuint both = makeGlsl("void main() { gl_Position = gl_Vertex; }",
                               "void main() { gl_FragColor = vec4(0, 1, 0, 1); }");
  glUseProgram(both);
  EXPECT_EQ(drawn(), kGreenPixel) << "an invalid program that is not enabled is no error";
  glUseProgram(0);
  glDeleteProgram(swap);
  glDeleteProgram(both);
}

TEST_F(VertexDraws, TransformFeedbackOfTheApplications) {
  if (epoxy_gl_version() < 30)
    GTEST_SKIP() << "the host has no GL 3.0: transform feedback";
  makeProgram(kThrough, kVertex);
  EXPECT_EQ(drawn(), kBluePixel); // the linked program is bound on the host
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glBeginTransformFeedback(GL_POINTS));
  const GLuint glsl = makeGlsl("varying vec4 twice;\n"
                               "void main() { gl_Position = gl_Vertex; twice = 2.0 * gl_Vertex; }",
                               nullptr);
  const char *const names[] = {"twice"};
  glTransformFeedbackVaryings(glsl, 1, names, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(glsl);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, 64, nullptr, GL_STATIC_READ);
  glUseProgram(glsl);
  glBeginTransformFeedback(GL_POINTS);
  glBegin(GL_POINTS);
  glVertex2f(0.5f, 0.25f);
  glEnd();
  glEndTransformFeedback();
  GLfloat out[4] = {};
  glGetBufferSubData(GL_TRANSFORM_FEEDBACK_BUFFER, 0, sizeof out, out);
  EXPECT_EQ(out[0], 1.0f);
  EXPECT_EQ(out[1], 0.5f);
  glUseProgram(0);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(VertexDraws, ShareGroups) {
  BARE_HOST_DIFFERS("draws nothing with a program that another context loaded again");
  const GLuint name = makeProgram(through("MOV result.color, {1,0,0,1};"), kVertex);
  EXPECT_EQ(drawn(), kRedPixel);
  {
    const GlContext other(&m_context);
    EXPECT_TRUE(glIsProgramARB(name));
    glBindProgramARB(kVertex, name);
    glEnable(kVertex);
    EXPECT_EQ(drawn(), kRedPixel);
    load(through("MOV result.color, {0,1,0,1};"), kVertex);
    EXPECT_EQ(drawn(), kGreenPixel);
    glFinish();
  }
  m_context.makeCurrent();
  glBindProgramARB(kVertex, name);
  EXPECT_EQ(drawn(), kGreenPixel);
}

/// There are several passes over the same geometry, some by fixed function and some by programs.
TEST_F(VertexDraws, PositionInvarianceIsExact) {
  GLuint depth = 0;
  glGenRenderbuffers(1, &depth);
  glBindRenderbuffer(GL_RENDERBUFFER, depth);
  glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, 32, 32);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
  makeProgram("!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, vertex.color;\nEND",
              kVertex);
  glEnable(GL_DEPTH_TEST);
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.7, 0.9, -0.8, 0.6, 1.1, 17.3);
  glMatrixMode(GL_MODELVIEW);
  const auto surface = [] {
    for (int row = 0; row < 12; ++row) {
      glBegin(GL_TRIANGLE_STRIP);
      for (int column = 0; column <= 12; ++column)
        for (int i = 0; i < 2; ++i) {
          const float x = float(column) / 3.1f - 2.0f, y = float(row + i) / 2.9f - 2.0f;
          glVertex3f(x, y, std::sin(3.7f * x) * std::cos(2.3f * y) * 0.7f);
        }
      glEnd();
    }
  };
  std::vector<GLubyte> pixels(std::size_t(32 * 32 * 4));
  for (int angle = 0; angle < 10; ++angle) {
    for (const bool programFirst : {false, true}) {
      glLoadIdentity();
      glTranslatef(0.1f, -0.07f, -4.3f);
      glRotatef(float(angle) * 7.7f, 0.3f, 0.9f, -0.2f);
      glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
      glDepthFunc(GL_LESS);
      (programFirst ? glEnable : glDisable)(kVertex);
      glColor4f(1, 0, 0, 1);
      surface();
      (programFirst ? glDisable : glEnable)(kVertex);
      glDepthFunc(GL_EQUAL);
      glColor4f(0, 1, 0, 1);
      surface();
      glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
      int red = 0, green = 0;
      for (std::size_t i = 0; i < pixels.size(); i += 4) {
        red += pixels[i] == 255;
        green += pixels[i + 1] == 255;
      }
      EXPECT_EQ(red, 0) << "pixels whose depth differs, angle " << angle;
      EXPECT_GT(green, 200);
    }
  }
  glDisable(GL_DEPTH_TEST);
  glLoadIdentity();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

} // namespace
} // namespace api
