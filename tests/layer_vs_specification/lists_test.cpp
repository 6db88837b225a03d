// Display lists: which commands of the program API are compiled. That the layer splits lists is
// invisible.
#include <cstring>

#include "fixture.h"

namespace api {
namespace {

class Lists : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    m_list = glGenLists(4);
    glEnable(kFragment);
  }
  GLuint m_list = 0;
};

TEST_F(Lists, CompiledCommandsRunWhenCalled) {
  const GLuint red = makeProgram(kRed);
  const GLuint green = makeProgram(kGreen);
  glNewList(m_list, GL_COMPILE);
  glBindProgramARB(kFragment, red);
  glEnable(kFragment);
  drawQuad();
  glEndList();
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(green)) << "COMPILE executed";
  glDisable(kFragment);
  clear();
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kRedPixel);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(red));
  EXPECT_TRUE(glIsEnabled(kFragment));
}

TEST_F(Lists, BeginInsideOfBeginIsAnErrorWhenCalled) {
  for (const bool vertex : {false, true}) {
    glNewList(m_list, GL_COMPILE);
    glBegin(GL_POINTS);
    if (vertex)
      glVertex2f(0, 0);
    glBegin(GL_LINES);
    glVertex2f(0, 0);
    EXPECT_NO_GL_ERROR(glEnd(); glEndList());
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glCallList(m_list));
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glEnd()); // nothing is open
  }
}

TEST_F(Lists, TheStringIsCopiedWhenRecorded) {
  BARE_HOST_DIFFERS("reads on past the end of its own copy, which has no terminator");
  makeProgram(kRed);
  char text[] = "!!ARBfp1.0\nMOV result.color, {0,1,0,1};\nEND";
  glNewList(m_list, GL_COMPILE);
  glProgramStringARB(kFragment, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
  glEndList();
  std::memset(text, '!', sizeof text);
  EXPECT_EQ(drawn(), kRedPixel);
  glCallList(m_list);
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(Lists, ParametersBetweenDraws) {
  makeProgram(kEnv0);
  glNewList(m_list, GL_COMPILE);
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  glRectf(-1, -1, 0, 1);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  glRectf(0, -1, 1, 1);
  glEndList();
  clear();
  glCallList(m_list);
  EXPECT_EQ(readPixel(8, 16), kRedPixel);
  EXPECT_EQ(readPixel(24, 16), kGreenPixel);
}

TEST_F(Lists, CompileAndExecute) {
  makeProgram(kEnv0);
  clear();
  glNewList(m_list, GL_COMPILE_AND_EXECUTE);
  EXPECT_EQ(integer(GL_LIST_MODE), GL_COMPILE_AND_EXECUTE);
  EXPECT_EQ(integer(GL_LIST_INDEX), GLint(m_list));
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  EXPECT_EQ(integer(GL_LIST_INDEX), GLint(m_list)) << "a segment's name shows";
  glRectf(-1, -1, 0, 1);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  glRectf(0, -1, 1, 1);
  glEndList();
  EXPECT_EQ(integer(GL_LIST_INDEX), 0);
  EXPECT_EQ(readPixel(8, 16), kRedPixel) << "while compiled";
  EXPECT_EQ(readPixel(24, 16), kGreenPixel);
  clear();
  glProgramEnvParameter4fARB(kFragment, 0, 0, 0, 1, 1);
  glCallList(m_list);
  EXPECT_EQ(readPixel(8, 16), kRedPixel) << "when called";
  EXPECT_EQ(readPixel(24, 16), kGreenPixel);
}

TEST_F(Lists, PlainListsDrawWithWhatIsInForce) {
  glDisable(kFragment);
  glNewList(m_list, GL_COMPILE);
  drawQuad();
  glEndList();
  clear();
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kBluePixel);
  makeProgram(kRed);
  glEnable(kFragment);
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kRedPixel);
  load(kGreen);
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glDisable(kFragment);
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kBluePixel) << "the layer's program is not in the list";
}

TEST_F(Lists, NestedListsAndListBase) {
  const GLuint red = makeProgram(kRed);
  const GLuint green = makeProgram(kGreen);
  glNewList(m_list + 1, GL_COMPILE);
  glBindProgramARB(kFragment, red);
  glEndList();
  glNewList(m_list + 2, GL_COMPILE);
  drawQuad();
  glEndList();
  const GLubyte offsets[] = {1, 2};
  glNewList(m_list, GL_COMPILE);
  glCallLists(2, GL_UNSIGNED_BYTE, offsets);
  glEndList();
  glListBase(m_list);
  clear();
  glBindProgramARB(kFragment, green);
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kRedPixel);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(red));
  // The inner list is redefined: the outer one calls the new one.
  glNewList(m_list + 1, GL_COMPILE);
  glBindProgramARB(kFragment, green);
  glEndList();
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kGreenPixel);
}

TEST_F(Lists, AListThatCallsItselfEnds) {
  makeProgram(kEnv0);
  glNewList(m_list, GL_COMPILE);
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  glCallList(m_list);
  glEndList();
  EXPECT_NO_GL_ERROR(glCallList(m_list));
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Lists, QueriesAreNotCompiled) {
  glNewList(m_list, GL_COMPILE);
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  EXPECT_NE(name, 0u);
  EXPECT_TRUE(glIsEnabled(kFragment));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), 0);
  glDeleteProgramsARB(1, &name);
  glEndList();
  EXPECT_NO_GL_ERROR(glCallList(m_list));
}

TEST_F(Lists, ErrorsAreRaisedWhenCalled) {
  makeProgram(kRed);
  glNewList(m_list, GL_COMPILE);
  EXPECT_NO_GL_ERROR(load(kBad));
  EXPECT_NO_GL_ERROR(glProgramEnvParameter4fARB(kFragment, 0xFFFFu, 0, 0, 0, 0));
  glEndList();
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glCallList(m_list));
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(Lists, AttributesArePushedAndPoppedInLists) {
  makeProgram(kRed);
  glNewList(m_list, GL_COMPILE);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  glRectf(-1, -1, 0, 1);
  glPopAttrib();
  glRectf(0, -1, 1, 1);
  glEndList();
  clear();
  glColor4f(0, 0, 1, 1);
  glCallList(m_list);
  EXPECT_EQ(readPixel(8, 16), kBluePixel);
  EXPECT_EQ(readPixel(24, 16), kRedPixel);
  EXPECT_TRUE(glIsEnabled(kFragment));
  EXPECT_EQ(integer(GL_ATTRIB_STACK_DEPTH), 0);
}

TEST_F(Lists, UseProgramInLists) {
  makeProgram(kRed);
  const GLuint glsl = makeGlsl(nullptr, "void main() { gl_FragColor = vec4(0, 1, 0, 1); }");
  glNewList(m_list, GL_COMPILE);
  glUseProgram(glsl);
  glRectf(-1, -1, 0, 1);
  glUseProgram(0);
  glRectf(0, -1, 1, 1);
  glEndList();
  EXPECT_EQ(integer(GL_CURRENT_PROGRAM), 0);
  clear();
  glCallList(m_list);
  EXPECT_EQ(readPixel(8, 16), kGreenPixel);
  EXPECT_EQ(readPixel(24, 16), kRedPixel);
}

TEST_F(Lists, SegmentsAreInvisible) {
  makeProgram(kEnv0);
  glNewList(m_list, GL_COMPILE);
  for (int i = 0; i < 8; ++i)
    glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  glEndList();
  EXPECT_TRUE(glIsList(m_list));
  for (GLuint name = 0xFFFFFE00u; name != 0; ++name)
    ASSERT_FALSE(glIsList(name)) << name;
  glDeleteLists(0xFFFFFE00u, 0x1FF); // all of them exist
  glCallList(m_list);
  EXPECT_EQ(drawn(), kRedPixel) << "the application deleted a segment";
  const GLuint next = glGenLists(3);
  EXPECT_NE(next, 0u);
  EXPECT_LT(next, 0x10000u) << "GenLists gives names beyond the segments'";
  glDeleteLists(m_list, 4);
  EXPECT_FALSE(glIsList(m_list));
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_NO_GL_ERROR(glCallList(m_list)); // nothing is left of it
  EXPECT_EQ(drawn(), kGreenPixel);
}

TEST_F(Lists, RedefinitionReplacesTheWholeList) {
  makeProgram(kEnv0);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  glNewList(m_list, GL_COMPILE);
  glProgramEnvParameter4fARB(kFragment, 0, 1, 0, 0, 1);
  drawQuad();
  glEndList();
  glNewList(m_list, GL_COMPILE);
  drawQuad();
  glEndList();
  clear();
  glCallList(m_list);
  EXPECT_EQ(readPixel(), kGreenPixel) << "the old list's command ran";
}

TEST_F(Lists, ADrawInAListOfAnInvalidProgramShowsNothing) {
  makeProgram(kRed);
  glNewList(m_list, GL_COMPILE);
  drawQuad();
  glEndList();
  glBindProgramARB(kFragment, 0);
  clear();
  glCallList(m_list);
  (void)glGetError(); // raised by the bare host; the layer cannot see into the host's list
  EXPECT_EQ(readPixel(), kBlack);
}

} // namespace
} // namespace api
