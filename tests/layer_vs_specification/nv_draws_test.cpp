// Draws with programs in NVIDIA's own languages: parameters, tracked matrices, attributes by
// number, arrays, lists. Needs a profile that has the languages (nv40).
#include <cstddef>
#include <string>

#include "nv_commands.h"

namespace api::nv {
namespace {

TEST_F(NvTest, AFragmentProgramWithItsParameters) {
  use(kFragmentNv, 1,
      "!!FP1.0\nDECLARE blue = {0,0,1,1};\nDEFINE half = {0.5,0,0,0};\n"
      "MOV R0, p[3];\nADD o[COLR], R0, blue;\nEND");
  EXPECT_EQ(quad(), kBluePixel);
  setNamed(1, "blue", {0, 1, 0, 1});
  EXPECT_EQ(quad(), kGreenPixel);
  glProgramLocalParameter4fARB(kFragmentNv, 3, 1, 0, 0, 0);
  EXPECT_EQ(quad(), (Pixel{255, 255, 0, 255}));
  glBindProgramARB(kFragment, 1);
  api::load("!!FP1.0\nDECLARE blue = {0,0,1,1};\nDEFINE half = {0.5,0,0,0};\n"
            "MOV R0, p[3];\nADD o[COLR], R0, blue;\nEND");
  EXPECT_EQ(quad(), (Pixel{255, 0, 255, 255}))
      << "the same text gives named parameters their values";
  glDisable(GL_FRAGMENT_PROGRAM_ARB); // it is the same enable as ARB's
  glColor4f(1, 0, 0, 1);
  EXPECT_EQ(quad(), kRedPixel);
}

TEST_F(NvTest, AVertexProgramReadsAttributesByNumber) {
  use(kVertexNv, 2, kThroughVp);
  VertexAttrib4fNV(3, 0, 1, 0, 1);
  EXPECT_EQ(quad(), kGreenPixel);
  GLfloat color[4] = {};
  glGetFloatv(GL_CURRENT_COLOR, color);
  EXPECT_EQ(color[1], 1.0f) << "attribute 3 is the colour";
  glColor4f(1, 0, 0, 1);
  GetVertexAttribfvNV(3, GL_CURRENT_ATTRIB_NV, color);
  EXPECT_EQ(color[0], 1.0f) << "and the colour is attribute 3";
  EXPECT_EQ(quad(), kRedPixel);
  VertexAttrib4ubNV(3, 0, 0, 255, 255);
  EXPECT_EQ(quad(), kBluePixel);
}

TEST_F(NvTest, EveryAttributeReachesTheProgram) {
  // Each attribute is set by its number, and by the equivalent conventional command.
  for (GLuint i = 1; i < 16; ++i) {
    use(kVertexNv, 3,
        "!!VP1.0\nMOV o[HPOS], v[0];\nMOV o[COL0].xyz, v[" + std::to_string(i) + "].xxxx;\nEND");
    VertexAttrib4fNV(i, 0.2f, 0, 0, 1);
    const Pixel pixel = quad();
    EXPECT_NEAR(pixel[0], 51, 1) << i;
    EXPECT_EQ(pixel[0], pixel[2]) << i;
    VertexAttrib4fNV(i, 0, 0, 0, 1);
  }
}

/// An attribute whose conventional command sets fewer components, and the remaining components.
struct Wider {
  GLuint number;
  std::string beyond; ///< a swizzle of the components that only VertexAttribNV sets
  void (*conventional)(GLfloat);
};
const Wider kWider[] = {{2, "w", [](GLfloat x) { glNormal3f(x, 0, 0); }},
                        {4, "w", [](GLfloat x) { glSecondaryColor3f(x, 0, 0); }},
                        {5, "y", [](GLfloat x) { glFogCoordf(x); }},
                        {5, "z", [](GLfloat x) { glFogCoordf(x); }},
                        {5, "w", [](GLfloat x) { glFogCoordf(x); }}};

TEST_F(NvTest, AttributesHaveFourComponents) {
  for (const Wider &wider : kWider) {
    const std::string v = "v[" + std::to_string(wider.number) + "].";
    use(kVertexNv, 4,
        "!!VP1.0\nMOV o[HPOS], v[0];\nMOV o[COL0].xyz, " + v + wider.beyond + ";\nMOV o[COL0].x, " +
            v + "x;\nEND");
    SCOPED_TRACE(v + wider.beyond);
    const GLubyte usual = wider.beyond == "w" ? 255 : 0;
    wider.conventional(0.2f);
    EXPECT_NEAR(quad()[0], 51, 1);
    EXPECT_EQ(quad()[1], usual);
    VertexAttrib4fNV(wider.number, 0.4f, 0.6f, 0.6f, 0.6f);
    EXPECT_NEAR(quad()[0], 102, 1);
    EXPECT_NEAR(quad()[1], 153, 1);
    GLfloat current[4] = {};
    GetVertexAttribfvNV(wider.number, GL_CURRENT_ATTRIB_NV, current);
    EXPECT_EQ(current[0], 0.4f);
    EXPECT_EQ(current[3], 0.6f);
    glPushAttrib(GL_CURRENT_BIT);
    wider.conventional(1);
    EXPECT_EQ(quad()[0], 255);
    EXPECT_EQ(quad()[1], usual) << "the conventional command sets the others too";
    GetVertexAttribfvNV(wider.number, GL_CURRENT_ATTRIB_NV, current);
    EXPECT_EQ(current[3], 1.0f);
    glPopAttrib();
    EXPECT_NEAR(quad()[1], 153, 1);
    // The values are those of vertices, in a primitive and in a list.
    const auto draw = [&] {
      glBegin(GL_QUADS);
      VertexAttrib4fNV(wider.number, 0, 0.8f, 0.8f, 0.8f);
      vertices();
      glEnd();
    };
    clear();
    draw();
    EXPECT_NEAR(readPixel()[1], 204, 1);
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    draw();
    glEndList();
    VertexAttrib4fNV(wider.number, 0, 0, 0, 1);
    clear();
    glCallList(list);
    EXPECT_NEAR(readPixel()[1], 204, 1);
    EXPECT_NEAR(quad()[1], 204, 1) << "it stays current";
    glDeleteLists(list, 1);
    // The values come from an array.
    const GLfloat values[4][4] = {
        {1, .4f, .4f, .4f}, {1, .4f, .4f, .4f}, {1, .4f, .4f, .4f}, {1, .4f, .4f, .4f}};
    constexpr GLfloat kCorners[] = {-1, -1, 1, -1, 1, 1, -1, 1};
    VertexAttribPointerNV(wider.number, 4, GL_FLOAT, 0, values);
    glVertexPointer(2, GL_FLOAT, 0, kCorners);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_VERTEX_ATTRIB_ARRAY0_NV + wider.number);
    clear();
    glDrawArrays(GL_QUADS, 0, 4);
    EXPECT_EQ(readPixel()[0], 255);
    EXPECT_NEAR(readPixel()[1], 102, 1);
    glDisableClientState(GL_VERTEX_ATTRIB_ARRAY0_NV + wider.number);
    glDisableClientState(GL_VERTEX_ARRAY);
    VertexAttrib4fNV(wider.number, 0, 0, 0, 1);
  }
}

TEST_F(NvTest, Attribute0MakesVertices) {
  use(kVertexNv, 2, kThroughVp);
  clear();
  const GLfloat several[] = {1, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 1}; // attributes 0 to 3
  glBegin(GL_TRIANGLE_STRIP);
  VertexAttrib4fNV(3, 0, 0, 1, 1);
  VertexAttrib2fNV(0, -1, -1);
  VertexAttrib2fNV(0, 1, -1);
  VertexAttrib2fNV(0, -1, 1);
  VertexAttribs4fvNV(0, 4, several); // the color is set before the vertex
  glEnd();
  EXPECT_EQ(readPixel(), kBluePixel);
  EXPECT_EQ(readPixel(30, 30), kBluePixel);
}

TEST_F(NvTest, TrackedMatricesAreThoseOfState) {
  const char *const state = "!!ARBvp1.0\nPARAM m[4] = { state.matrix.mvp };\n"
                            "DP4 result.position.x, m[0], vertex.position;\n"
                            "DP4 result.position.y, m[1], vertex.position;\n"
                            "DP4 result.position.z, m[2], vertex.position;\n"
                            "DP4 result.position.w, m[3], vertex.position;\n"
                            "MOV result.color, vertex.color;\nEND";
  load(kVertexNv, 4,
       "!!VP1.0\nDP4 o[HPOS].x, c[8], v[OPOS];\nDP4 o[HPOS].y, c[9], v[OPOS];\n"
       "DP4 o[HPOS].z, c[10], v[OPOS];\nDP4 o[HPOS].w, c[11], v[OPOS];\n"
       "MOV o[COL0], v[COL0];\nEND");
  const GLuint arb = makeProgram(state, kVertex);
  TrackMatrixNV(kVertexNv, 8, GL_MODELVIEW_PROJECTION_NV, GL_IDENTITY_NV);
  glEnable(kVertex);
  glColor4f(0, 1, 0, 1);
  glMatrixMode(GL_PROJECTION);
  glScalef(0.5f, 0.5f, 1);
  glMatrixMode(GL_MODELVIEW);
  const auto picture = [&](GLenum target, GLuint program) {
    (target == kVertex ? glBindProgramARB(kVertex, program) : BindProgramNV(kVertexNv, program));
    (void)quad();
    std::array<GLubyte, 32 * 32 * 4> pixels{};
    glReadPixels(0, 0, 32, 32, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  };
  for (int step = 0; step < 4; ++step) {
    glTranslatef(0.3f, -0.2f, 0);
    glRotatef(25, 0, 0, 1);
    EXPECT_EQ(picture(kVertexNv, 4), picture(kVertex, arb)) << step;
    EXPECT_NE(readPixel(0, 0), kGreenPixel) << "the quad is not everything";
  }
  glLoadIdentity();
  glMatrixMode(GL_PROJECTION);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

TEST_F(NvTest, ProgramMatricesHaveNvidiasNames) {
  TrackMatrixNV(kVertexNv, 20, GL_MATRIX0_NV + 1, GL_TRANSPOSE_NV);
  glMatrixMode(GL_MATRIX0_NV + 1);
  glLoadIdentity();
  glTranslatef(5, 6, 7);
  GLfloat last[4] = {}, matrix[16] = {};
  GetProgramParameterfvNV(kVertexNv, 23, GL_PROGRAM_PARAMETER_NV, last);
  EXPECT_EQ(last[0], 5);
  EXPECT_EQ(last[3], 1);
  glMatrixMode(GL_MATRIX0_ARB + 1);
  glGetFloatv(GL_CURRENT_MATRIX_NV, matrix);
  EXPECT_EQ(matrix[13], 6);
  glLoadIdentity();
  glMatrixMode(GL_MODELVIEW);
}

TEST_F(NvTest, AStateProgramWritesWhatDrawsRead) {
  load(kState, 5, "!!VSP1.0\nMUL c[30], v[0], c[31];\nEND");
  use(kVertexNv, 6, "!!VP1.0\nMOV o[HPOS], v[OPOS];\nMOV o[COL0], c[30];\nEND");
  ProgramParameter4fNV(kVertexNv, 31, 0, 1, 1, 1);
  const GLfloat input[] = {1, 1, 0, 1};
  ExecuteProgramNV(kState, 5, input);
  EXPECT_EQ(quad(), kGreenPixel);
}

struct Vertex {
  GLfloat position[2];
  GLubyte color[4];
};
constexpr Vertex kGreenQuad[] = {{{-1, -1}, {0, 255, 0, 255}},
                                 {{1, -1}, {0, 255, 0, 255}},
                                 {{1, 1}, {0, 255, 0, 255}},
                                 {{-1, 1}, {0, 255, 0, 255}}};

void pointAt(const Vertex *first) {
  VertexAttribPointerNV(0, 2, GL_FLOAT, sizeof(Vertex), first ? first->position : nullptr);
  VertexAttribPointerNV(3, 4, GL_UNSIGNED_BYTE, sizeof(Vertex),
                        reinterpret_cast<const char *>(first) + offsetof(Vertex, color));
}

TEST_F(NvTest, AttributeArrays) {
  use(kVertexNv, 2, kThroughVp);
  glColor4f(1, 0, 0, 1);
  pointAt(kGreenQuad);
  const GLenum arrays[] = {GL_VERTEX_ATTRIB_ARRAY0_NV, GL_VERTEX_ATTRIB_ARRAY0_NV + 3};
  for (const GLenum array : arrays)
    glEnableClientState(array);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kGreenPixel);
  const GLubyte indices[] = {0, 1, 2, 3};
  clear();
  glDrawElements(GL_QUADS, 4, GL_UNSIGNED_BYTE, indices);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glColor4f(1, 0, 0, 1); // undefined after a draw of arrays
  glDisableClientState(arrays[1]);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kRedPixel) << "the current colour, where the array is disabled";
  glEnableClientState(arrays[1]);
  EXPECT_EQ(quad(), kRedPixel) << "between Begin and End too";
  for (const GLenum array : arrays)
    glDisableClientState(array);
}

TEST_F(NvTest, AnArrayOfABufferBesideAConventionalOne) {
  use(kVertexNv, 2, kThroughVp);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof kGreenQuad, kGreenQuad, GL_STATIC_DRAW);
  pointAt(nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glVertexPointer(2, GL_FLOAT, sizeof(Vertex), kGreenQuad);
  glEnableClientState(GL_VERTEX_ARRAY);
  glPushClientAttrib(GL_CLIENT_VERTEX_ARRAY_BIT);
  glEnableClientState(GL_VERTEX_ATTRIB_ARRAY0_NV + 3);
  glColor4f(1, 0, 0, 1);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kGreenPixel);
  glPopClientAttrib();
  glColor4f(1, 0, 0, 1);
  clear();
  glDrawArrays(GL_QUADS, 0, 4);
  EXPECT_EQ(readPixel(), kRedPixel) << "the enable came back";
  glDisableClientState(GL_VERTEX_ARRAY);
  glDeleteBuffers(1, &buffer);
}

TEST_F(NvTest, Lists) {
  load(kVertexNv, 2, kThroughVp);
  glEnable(kVertexNv);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  load(kFragmentNv, 7, "!!FP1.0\nDECLARE c = {1,0,0,1};\nMUL o[COLR], c, f[COL0];\nEND");
  setNamed(7, "c", {0, 1, 0, 1});
  BindProgramNV(kFragmentNv, 7);
  BindProgramNV(kVertexNv, 2);
  glEnable(kFragmentNv);
  VertexAttrib4fNV(3, 1, 1, 1, 1);
  glBegin(GL_QUADS);
  vertices();
  glEnd();
  VertexAttrib4fNV(3, 1, 0, 1, 1);
  glEndList();
  EXPECT_FALSE(IsProgramNV(7));
  for (int call = 0; call < 2; ++call) {
    clear();
    glCallList(list);
    EXPECT_EQ(readPixel(), kGreenPixel);
  }
  EXPECT_TRUE(IsProgramNV(7));
  EXPECT_EQ(quad(), (Pixel{0, 0, 0, 255})) << "no green is left of the colour";
  glDeleteLists(list, 1);
}

TEST_F(NvTest, AVertexProgramSamplesTheUnitThatItNames) {
  constexpr GLubyte kTexels[3][4] = {{255, 0, 0, 255}, {0, 0, 255, 255}, {0, 255, 0, 255}};
  constexpr Pixel kExpected[3] = {kRedPixel, kBluePixel, kGreenPixel};
  constexpr GLuint kUnits[3] = {0, 1, 16}; // the last is beyond fragment programs' units
  GLuint textures[3];
  glGenTextures(3, textures);
  for (int i = 0; i < 3; ++i) {
    glActiveTexture(GL_TEXTURE0 + kUnits[i]);
    glBindTexture(GL_TEXTURE_2D, textures[i]);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels[i]);
  }
  glActiveTexture(GL_TEXTURE0);
  for (int i = 0; i < 3; ++i) {
    use(kVertexNv, GLuint(20 + i),
        "!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP t;\nMOV result.position, vertex.position;\n"
        "TEX t, {0.5,0.5,0,0}, texture[" +
            std::to_string(kUnits[i]) + "], 2D;\nMOV result.color, t;\nEND");
    EXPECT_EQ(quad(), kExpected[i]) << kUnits[i];
  }
  glDeleteTextures(3, textures);
}

TEST_F(NvTest, BothStagesReadOneTargetOfAUnit) {
  const auto fragment = [](const char *target) {
    return std::string("!!FP1.0\nTEX o[COLR], {0.5,0.5,0,0}, TEX0, ") + target + ";\nEND";
  };
  use(kVertexNv, 22,
      "!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP t;\nMOV result.position, vertex.position;\n"
      "TEX t, {0.5,0.5,0,0}, texture[0], 2D;\nMOV result.color, t;\nEND");
  use(kFragmentNv, 23, fragment("3D"));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDrawArrays(GL_POINTS, 0, 1));
  use(kFragmentNv, 24, fragment("2D"));
  constexpr GLubyte kBlue[] = {0, 0, 255, 255};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kBlue);
  EXPECT_NO_GL_ERROR(glDrawArrays(GL_POINTS, 0, 1));
  EXPECT_EQ(quad(), kBluePixel);
  glDisable(kFragmentNv);
}

TEST_F(NvTest, AVertexProgramReadsDepthsUncompared) {
  constexpr GLfloat kDepth = 0.6f; // compared with 0.5: 1 or 0
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_R_TO_TEXTURE);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, 1, 1, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
               &kDepth);
  use(kVertexNv, 25,
      "!!ARBvp1.0\nOPTION NV_vertex_program3;\nTEMP t;\nMOV result.position, vertex.position;\n"
      "TEX t, {0.5,0.5,0.5,0}, texture[0], 2D;\nMOV result.color, t;\nEND");
  EXPECT_NEAR(quad()[0], 153, 1);
}

TEST_F(NvTest, DrawsWithoutAProgramAreErrors) {
  for (const GLenum target : {kVertexNv, kFragmentNv}) {
    BindProgramNV(target, 0);
    glEnable(target);
    EXPECT_GL_ERROR(GL_INVALID_OPERATION, glDrawArrays(GL_POINTS, 0, 1));
    glDisable(target);
  }
}

TEST_F(NvTest, AttributeStacksHoldTheEnables) {
  use(kFragmentNv, 8, "!!FP1.0\nMOV o[COLR], {0,0,1,1};\nEND");
  glDisable(kFragmentNv);
  glColor4f(1, 0, 0, 1);
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(kFragmentNv);
  EXPECT_EQ(quad(), kBluePixel);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(kFragmentNv));
  EXPECT_EQ(quad(), kRedPixel);
}

TEST_F(NvTest, ProgramsAreSharedWithTheArbsCommands) {
  load(kFragmentNv, 9, "!!FP1.0\nMOV o[COLR], {0,1,0,1};\nEND");
  glBindProgramARB(kFragment, 9);
  glEnable(kFragment);
  EXPECT_EQ(quad(), kGreenPixel);
  api::load("!!FP1.0\nMOV o[COLR], {0,0,1,1};\nEND"); // the header decides
  EXPECT_EQ(quad(), kBluePixel);
  load(kFragmentNv, 9, kRed);
  EXPECT_EQ(quad(), kRedPixel);
  const GLuint name = 9;
  DeleteProgramsNV(1, &name);
  EXPECT_FALSE(glIsProgramARB(9));
}

} // namespace
} // namespace api::nv
