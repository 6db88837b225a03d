// Draws with vertex programs, alone and with fragment programs: single pixels are compared.
#include "vertex_draws.h"

namespace api {
namespace {

TEST_F(VertexDraws, AloneBeforeFixedFunctionFragments) {
  makeProgram(through("MOV result.color, program.env[2];"), kVertex);
  glProgramEnvParameter4fARB(kVertex, 2, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  glProgramEnvParameter4fARB(kVertex, 2, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  makeProgram(through("MOV result.color, program.local[0];"), kVertex);
  glProgramLocalParameter4fARB(kVertex, 0, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  glDisable(kVertex);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(VertexDraws, TextureEnvironmentAfterAVertexProgram) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  const GLubyte texels[] = {255, 0, 0, 255, 0, 255, 0, 255};
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glEnable(GL_TEXTURE_2D);
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  makeProgram(through("MAD result.texcoord[0], vertex.position, 0.5, {0.5, 0.5, 0, 0.5};"),
              kVertex);
  clear();
  drawQuad();
  EXPECT_EQ(readPixel(4, 16), kRedPixel);
  EXPECT_EQ(readPixel(28, 16), kGreenPixel);
}

TEST_F(VertexDraws, BothTargets) {
  glEnable(kFragment);
  makeProgram(through("MOV result.texcoord[3], program.env[0];"), kVertex);
  makeProgram("!!ARBfp1.0\nADD result.color, fragment.texcoord[3], program.env[0];\nEND");
  glProgramEnvParameter4fARB(kVertex, 0, 0, 1, 0, 0);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 0, 0, 1);
  EXPECT_EQ(drawn(), kGreenPixel);
  glProgramEnvParameter4fARB(kVertex, 0, 1, 0, 0, 0);
  EXPECT_EQ(drawn(), kRedPixel);
  glProgramEnvParameter4fARB(kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(drawn(), (Pixel{255, 255, 0, 255}));
  glDisable(kVertex);
  makeProgram(kGreen);
  EXPECT_EQ(drawn(), kGreenPixel) << "fixed-function vertices";
  glEnable(kVertex);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDisable(kFragment);
  makeProgram(kThrough, kVertex);
  EXPECT_EQ(drawn(), kBluePixel) << "fixed-function fragments";
}

TEST_F(VertexDraws, PairsOfProgramsInTurn) {
  glEnable(kFragment);
  const GLuint vertices[] = {makeProgram(through("MOV result.texcoord[0], {1,0,0,1};"), kVertex),
                             makeProgram(through("MOV result.texcoord[0], {0,1,0,1};"), kVertex)};
  const GLuint fragments[] = {
      makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\nEND"),
      makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[0].yxzw;\nEND")};
  for (int round = 0; round < 2; ++round)
    for (int v = 0; v < 2; ++v)
      for (int f = 0; f < 2; ++f) {
        glBindProgramARB(kVertex, vertices[v]);
        glBindProgramARB(kFragment, fragments[f]);
        EXPECT_EQ(drawn(), v == f ? kRedPixel : kGreenPixel) << v << f;
      }
  glBindProgramARB(kVertex, vertices[0]);
  glDeleteProgramsARB(1, &vertices[1]);
  EXPECT_EQ(drawn(), kGreenPixel) << "the other pair's program went";
}

TEST_F(VertexDraws, TrackedMatricesAndState) {
  makeProgram("!!ARBvp1.0\nPARAM mvp[4] = { state.matrix.mvp };\n"
              "DP4 result.position.x, mvp[0], vertex.position;\n"
              "DP4 result.position.y, mvp[1], vertex.position;\n"
              "DP4 result.position.z, mvp[2], vertex.position;\n"
              "DP4 result.position.w, mvp[3], vertex.position;\n"
              "MOV result.color, state.material.diffuse;\nEND",
              kVertex);
  const GLfloat red[4] = {1, 0, 0, 1}, green[4] = {0, 1, 0, 1};
  glMaterialfv(GL_FRONT, GL_DIFFUSE, red);
  glMatrixMode(GL_PROJECTION);
  glOrtho(0, 2, 0, 2, -1, 1);
  glMatrixMode(GL_MODELVIEW);
  glScalef(2, 2, 1);
  clear();
  glRectf(0, 0, 0.5f, 1);
  EXPECT_EQ(readPixel(4, 16), kRedPixel);
  EXPECT_EQ(readPixel(28, 16), kBlack);
  glMaterialfv(GL_FRONT, GL_DIFFUSE, green);
  glTranslatef(0.5f, 0, 0);
  clear();
  glRectf(0, 0, 0.5f, 1);
  EXPECT_EQ(readPixel(4, 16), kBlack);
  EXPECT_EQ(readPixel(28, 16), kGreenPixel);
  glLoadIdentity();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

TEST_F(VertexDraws, RelativeAddressing) {
  makeProgram("!!ARBvp1.0\nADDRESS a;\nPARAM rows[4] = { program.env[10..13] };\n"
              "MOV result.position, vertex.position;\n"
              "ARL a.x, vertex.attrib[5].x;\n"
              "MOV result.color, rows[a.x + 1];\nEND",
              kVertex);
  glProgramEnvParameter4fARB(kVertex, 11, 1, 0, 0, 1);
  glProgramEnvParameter4fARB(kVertex, 13, 0, 1, 0, 1);
  glVertexAttrib1f(5, 0.75f);
  EXPECT_EQ(drawn(), kRedPixel) << "ARL rounds down";
  glVertexAttrib1f(5, 2.0f);
  EXPECT_EQ(drawn(), kGreenPixel);
  glProgramEnvParameter4fARB(kVertex, 13, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
}

TEST_F(VertexDraws, TwoSidedColor) {
  makeProgram(through("MOV result.color, {1,0,0,1};\nMOV result.color.back, {0,1,0,1};"), kVertex);
  EXPECT_EQ(drawn(), kRedPixel) << "without TWO_SIDE the front colour";
  glEnable(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
  EXPECT_EQ(drawn(), kRedPixel);
  glFrontFace(GL_CW);
  EXPECT_EQ(drawn(), kGreenPixel);
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.color;\nEND");
  EXPECT_EQ(drawn(), kGreenPixel) << "read by a fragment program";
  glFrontFace(GL_CCW);
  EXPECT_EQ(drawn(), kRedPixel);
  glDisable(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
}

TEST_F(VertexDraws, FlatShading) {
  makeProgram(kThrough, kVertex);
  const auto triangle = [] {
    clear();
    glBegin(GL_TRIANGLES);
    glColor4f(1, 0, 0, 1), glVertex2f(-1, -1);
    glColor4f(1, 0, 0, 1), glVertex2f(3, -1);
    glColor4f(0, 1, 0, 1), glVertex2f(-1, 3);
    glEnd();
  };
  glShadeModel(GL_FLAT);
  triangle();
  EXPECT_EQ(readPixel(1, 1), kGreenPixel) << "the last vertex provokes";
  glShadeModel(GL_SMOOTH);
  triangle();
  EXPECT_NE(readPixel(16, 16), kGreenPixel);
}

TEST_F(VertexDraws, ColorsAreClamped) {
  makeProgram(through("MOV result.color, {-1, 2, -3, 1};"), kVertex);
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMUL result.color, fragment.color, {1, 0.5, 1, 1};\nEND");
  const Pixel pixel = drawn();
  EXPECT_NEAR(pixel[1], 128, 1) << "2 was not clamped to 1 before interpolation";
  EXPECT_EQ(pixel[0], 0);
}

TEST_F(VertexDraws, PointSize) {
  makeProgram(through("MOV result.color, vertex.color;\nMOV result.pointsize, program.env[0].x;"),
              kVertex);
  glProgramEnvParameter4fARB(kVertex, 0, 12, 0, 0, 0);
  const auto point = [] {
    clear();
    glColor4f(0, 0, 1, 1);
    glBegin(GL_POINTS);
    glVertex2f(0, 0);
    glEnd();
    return readPixel(20, 16);
  };
  EXPECT_EQ(point(), kBlack) << "PointSize rules where the program's is not enabled";
  glEnable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
  EXPECT_EQ(point(), kBluePixel);
  glProgramEnvParameter4fARB(kVertex, 0, 2, 0, 0, 0);
  EXPECT_EQ(point(), kBlack);
  glDisable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
  glPointSize(12);
  EXPECT_EQ(point(), kBluePixel);
  glPointSize(1);
}

TEST_F(VertexDraws, PointSprites) {
  makeProgram(through("MOV result.texcoord[0], {0.25, 0.25, 0, 1};"), kVertex);
  glEnable(kFragment);
  makeProgram("!!ARBfp1.0\nMOV result.color, fragment.texcoord[0];\nMOV result.color.w, 1;\nEND");
  glEnable(GL_POINT_SPRITE);
  glTexEnvi(GL_POINT_SPRITE, GL_COORD_REPLACE, GL_TRUE);
  glPointSize(32);
  clear();
  glBegin(GL_POINTS);
  glVertex2f(0, 0);
  glEnd();
  EXPECT_LT(readPixel(1, 16)[0], 40);
  EXPECT_GT(readPixel(30, 16)[0], 215) << "the sprite's coordinate did not replace the program's";
  glDisable(GL_POINT_SPRITE);
  glPointSize(1);
}

TEST_F(VertexDraws, FogCoordinates) {
  makeProgram(through("MOV result.color, {1,0,0,1};\nMOV result.fogcoord.x, program.env[0].x;"),
              kVertex);
  const GLfloat green[4] = {0, 1, 0, 1};
  glFogfv(GL_FOG_COLOR, green);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogf(GL_FOG_START, 0);
  glFogf(GL_FOG_END, 1);
  glEnable(GL_FOG);
  glProgramEnvParameter4fARB(kVertex, 0, 0, 0, 0, 0);
  EXPECT_EQ(drawn(), kRedPixel);
  glProgramEnvParameter4fARB(kVertex, 0, 1, 0, 0, 0);
  EXPECT_EQ(drawn(), kGreenPixel);
  glDisable(GL_FOG);
}

TEST_F(VertexDraws, ClipPlanesNeedPositionInvariance) {
  const GLdouble left[4] = {-1, 0, 0, 0}; // keeps x <= 0
  glClipPlane(GL_CLIP_PLANE0, left);
  glEnable(GL_CLIP_PLANE0);
  makeProgram("!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.color, vertex.color;\nEND",
              kVertex);
  clear();
  drawQuad();
  EXPECT_EQ(readPixel(4, 16), kBluePixel);
  EXPECT_EQ(readPixel(28, 16), kBlack) << "position-invariant programs are clipped";
  glDisable(GL_CLIP_PLANE0);
  EXPECT_EQ(drawn(), kBluePixel);
}

TEST_F(VertexDraws, GenericAttributesOfEveryKind) {
  makeProgram(through("MOV result.color, vertex.attrib[7];"), kVertex);
  glVertexAttrib4f(7, 1, 0, 0, 1);
  EXPECT_EQ(drawn(), kRedPixel);
  glVertexAttrib4Nub(7, 0, 255, 0, 255);
  EXPECT_EQ(drawn(), kGreenPixel);
  const GLfloat corners[] = {-1, -1, 1, -1, 1, 1, -1, 1};
  const GLubyte colors[] = {255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255, 255, 0, 0, 255};
  const GLubyte indexes[] = {0, 1, 2, 3};
  glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, corners);
  glVertexAttribPointer(7, 4, GL_UNSIGNED_BYTE, GL_TRUE, 0, colors);
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(7);
  clear();
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indexes);
  EXPECT_EQ(readPixel(), kRedPixel) << "arrays";
  clear();
  glBegin(GL_QUADS);
  for (GLint i = 0; i < 4; ++i)
    glArrayElement(i);
  glEnd();
  EXPECT_EQ(readPixel(), kRedPixel) << "ArrayElement";
  glDisableVertexAttribArray(7);
  glVertexAttrib4f(7, 0, 1, 0, 1);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kGreenPixel) << "the current value beside an array";
  glDisableVertexAttribArray(0);
  clear();
  glBegin(GL_QUADS); // attribute 0 provokes a vertex
  glVertexAttrib2f(0, -1, -1), glVertexAttrib2f(0, 1, -1);
  glVertexAttrib2f(0, 1, 1), glVertexAttrib2f(0, -1, 1);
  glEnd();
  EXPECT_EQ(readPixel(), kGreenPixel) << "VertexAttrib of attribute 0";
}

} // namespace
} // namespace api
