// Generic vertex attributes that alias the conventional ones by number (NV_vertex_program, table
// X.2; ARB_vertex_program, interactions with it). Either command sets a register and either name
// reads it: as current values, between Begin and End, in lists, with programs and without.
#include <algorithm>

#include "aliased_attributes.h"

namespace api::aliases {
namespace {

/// A register with two names.
struct Register {
  GLuint number;
  const char *name; ///< in a program
  int components;   ///< of the conventional command
  void (*set)(const GLfloat *v);
};
#define TEXCOORD(unit)                                                                             \
  {                                                                                                \
    8 + (unit), "vertex.texcoord[" #unit "]", 4,                                                   \
        [](const GLfloat *v) { glMultiTexCoord4fv(GL_TEXTURE0 + (unit), v); }                      \
  }
const Register kRegisters[] = {
    {2, "vertex.normal", 3, [](const GLfloat *v) { glNormal3fv(v); }},
    {3, "vertex.color", 4, [](const GLfloat *v) { glColor4fv(v); }},
    {4, "vertex.color.secondary", 3, [](const GLfloat *v) { glSecondaryColor3fv(v); }},
    {5, "vertex.fogcoord", 1, [](const GLfloat *v) { glFogCoordfv(v); }},
    TEXCOORD(0),
    TEXCOORD(1),
    TEXCOORD(2),
    TEXCOORD(3),
    TEXCOORD(4),
    TEXCOORD(5),
    TEXCOORD(6),
    TEXCOORD(7)};
#undef TEXCOORD

/// Returns the register's value after its conventional command.
Value conventional(const Register &row, const Value &v) {
  Value all = {0, 0, 0, 1};
  std::copy_n(v.begin(), row.components, all.begin());
  return all;
}

void expectPixel(const Pixel &pixel, const Value &value) {
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(pixel[i], value[i] * 255.0f, 1.01f) << "component " << i;
}

TEST_F(AliasedAttributes, AreOneWhicheverCommandSetsThem) {
  GLfloat step = 0;
  glEnable(kVertex);
  for (const Register &row : kRegisters) {
    if (row.number >= 8 + GLuint(integer(GL_MAX_TEXTURE_COORDS)))
      break;
    const std::string generic = "vertex.attrib[" + std::to_string(row.number) + "]";
    const GLuint programs[] = {makeProgram(shows(row.name), kVertex),
                               makeProgram(shows(generic), kVertex)};
    const auto expect = [&](const Value &value) {
      for (const GLuint program : programs) {
        glBindProgramARB(kVertex, program);
        SCOPED_TRACE(program == programs[0] ? row.name : generic);
        expectPixel(pixelOf(quad), value);
      }
      GLfloat current[4] = {};
      glGetVertexAttribfv(row.number, GL_CURRENT_VERTEX_ATTRIB, current);
      EXPECT_EQ((Value{current[0], current[1], current[2], current[3]}), value) << generic;
    };
    const auto next = [&] { return Value{0.2f + (step += 0.004f), 0.4f, 0.6f - step, 0.8f}; };
    for (int round = 0; round < 2; ++round) {
      SCOPED_TRACE(round);
      Value value = next();
      row.set(value.data());
      expect(conventional(row, value));
      value = next();
      glVertexAttrib4fv(row.number, value.data());
      expect(value);
      if (hasNv) {
        value = next();
        row.set(value.data());
        value = next();
        attrib4fNv(row.number, value[0], value[1], value[2], value[3]);
        expect(value);
      }
    }
    glVertexAttrib4f(row.number, 0, 0, 0, 1);
  }
}

TEST_F(AliasedAttributes, TheLastCommandCounts) {
  for (const Reader reader : kReaders) {
    read(reader);
    for (const auto &first : colorCommands())
      for (const auto &second : colorCommands()) {
        first(kRed);
        second(kGreen);
        ASSERT_EQ(pixelOf(quad), kGreenPixel);
        const auto between = [&] {
          glBegin(GL_QUADS);
          for (int i = 0; i < 4; ++i) {
            first(kGreen);
            second(kBlue);
            glVertex2fv(kCorners + 2 * i);
          }
          glEnd();
        };
        ASSERT_EQ(pixelOf(between), kBluePixel) << "between Begin and End";
        ASSERT_EQ(pixelOf(quad), kBluePixel) << "after it";
      }
  }
}

TEST_F(AliasedAttributes, AnswersAreOfTheOneValue) {
  glColor4f(0.25f, 0.5f, 0.75f, 1);
  GLfloat floats[4] = {};
  glGetVertexAttribfvARB(3, GL_CURRENT_VERTEX_ATTRIB_ARB, floats);
  EXPECT_EQ(floats[0], 0.25f);
  EXPECT_EQ(floats[2], 0.75f);
  GLdouble doubles[4] = {};
  glGetVertexAttribdvARB(3, GL_CURRENT_VERTEX_ATTRIB_ARB, doubles);
  EXPECT_EQ(doubles[1], 0.5);
  glMultiTexCoord4f(GL_TEXTURE2, 3, 4, 5, 6);
  GLint integers[4] = {};
  glGetVertexAttribivARB(10, GL_CURRENT_VERTEX_ATTRIB_ARB, integers);
  EXPECT_EQ(integers[3], 6);
  glVertexAttrib4fARB(3, 0.5f, 0.25f, 0, 1);
  glGetFloatv(GL_CURRENT_COLOR, floats);
  EXPECT_EQ(floats[0], 0.5f);
  glVertexAttrib3fARB(2, 4, 5, 6);
  glGetFloatv(GL_CURRENT_NORMAL, floats);
  EXPECT_EQ(floats[2], 6);
  glVertexAttrib1fARB(5, 9);
  glGetFloatv(GL_CURRENT_FOG_COORD, floats);
  EXPECT_EQ(floats[0], 9);
  glPushAttrib(GL_CURRENT_BIT);
  glVertexAttrib4fARB(3, 1, 1, 1, 1);
  glPopAttrib();
  glGetVertexAttribfvARB(3, GL_CURRENT_VERTEX_ATTRIB_ARB, floats);
  EXPECT_EQ(floats[1], 0.25f);
  glBegin(GL_POINTS);
  glGetVertexAttribfvARB(3, GL_CURRENT_VERTEX_ATTRIB_ARB, floats);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
}

TEST_F(AliasedAttributes, Lists) {
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
    for (const Reader reader : kReaders)
      for (const auto &command : colorCommands()) {
        read(reader);
        const GLuint list = glGenLists(1);
        glVertexAttrib4fARB(3, 1, 0, 0, 1);
        clear();
        glNewList(list, mode);
        command(kGreen);
        quad();
        glBegin(GL_TRIANGLES);
        for (int i = 0; i < 3; ++i) { // the lower right half
          command(kBlue);
          glVertex2fv(kCorners + 2 * i);
        }
        glEnd();
        glEndList();
        const auto expect = [](const char *when) {
          EXPECT_EQ(readPixel(28, 3), kBluePixel) << when;
          EXPECT_EQ(readPixel(3, 28), kGreenPixel) << when;
        };
        if (mode == GL_COMPILE_AND_EXECUTE)
          expect("as it is compiled");
        glColor4f(1, 0, 0, 1);
        clear();
        glCallList(list);
        expect("when it is called");
        ASSERT_EQ(pixelOf(quad), kBluePixel) << "the value stays";
        glDeleteLists(list, 1);
      }
}

TEST_F(AliasedAttributes, FixedFunctionReadsEveryRegister) {
  glDisable(kVertex);
  constexpr GLubyte kTexels[2][4] = {{255, 0, 0, 255}, {0, 255, 0, 255}};
  GLuint texture = 0;
  glGenTextures(1, &texture);
  for (const GLuint unit : {0u, 1u}) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 2, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, kTexels);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    // Each vertex has its own values: from an array, and from VertexAttrib between Begin and End.
    const GLfloat coordinates[4][2] = {{0.75f, 0.5f}, {0.75f, 0.5f}, {0.75f, 0.5f}, {0.75f, 0.5f}};
    glEnable(GL_TEXTURE_2D);
    glMultiTexCoord2f(GL_TEXTURE0 + unit, 0.25f, 0.5f);
    EXPECT_EQ(pixelOf(quad), kRedPixel);
    glVertexAttrib2fv(8 + unit, coordinates[0]);
    EXPECT_EQ(pixelOf(quad), kGreenPixel) << unit;
    glMultiTexCoord2f(GL_TEXTURE0 + unit, 0.25f, 0.5f);
    const Arrays arrays(false);
    arrays.position();
    glVertexAttribPointer(8 + unit, 2, GL_FLOAT, GL_FALSE, 0, coordinates);
    glEnableVertexAttribArray(8 + unit);
    EXPECT_EQ(pixelOf(kDraws[0].second), kGreenPixel) << unit;
    glDisableVertexAttribArray(8 + unit);
    glDisable(GL_TEXTURE_2D);
  }
  glActiveTexture(GL_TEXTURE0);
  glDeleteTextures(1, &texture);
  glColor4f(0, 0, 0, 1);
  glEnable(GL_COLOR_SUM);
  glVertexAttrib3f(4, 0, 0, 1);
  EXPECT_EQ(pixelOf(quad), kBluePixel);
  glDisable(GL_COLOR_SUM);
  glFogi(GL_FOG_MODE, GL_LINEAR);
  glFogi(GL_FOG_COORD_SRC, GL_FOG_COORD);
  glFogfv(GL_FOG_COLOR, kGreen.data());
  glEnable(GL_FOG);
  glVertexAttrib1f(5, 1);
  EXPECT_EQ(pixelOf(quad), kGreenPixel);
  glFogCoordf(0);
  EXPECT_EQ(pixelOf(quad), (Pixel{0, 0, 0, 255}));
  glDisable(GL_FOG);
  glEnable(GL_LIGHTING);
  glEnable(GL_LIGHT0);
  glNormal3f(0, 0, -1);
  EXPECT_LT(pixelOf(quad)[0], 60) << "ambient alone";
  glVertexAttrib3f(2, 0, 0, 1);
  EXPECT_GT(pixelOf(quad)[0], 200);
  glDisable(GL_LIGHT0);
  glDisable(GL_LIGHTING);
}

TEST_F(AliasedAttributes, TheApplicationsGlslHasItsGenericOnes) {
  const GLuint program = makeGlsl("#version 120\nattribute vec4 given;\nvarying vec4 color;\n"
                                  "void main() { gl_Position = gl_Vertex; color = given; }",
                                  "#version 120\nvarying vec4 color;\n"
                                  "void main() { gl_FragColor = color; }");
  glBindAttribLocation(program, 3, "given");
  glLinkProgram(program);
  glDisable(kVertex);
  glVertexAttrib4f(3, 0, 1, 0, 1);
  glUseProgram(program);
  EXPECT_EQ(pixelOf(quad), kGreenPixel);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glVertexAttrib4f(3, 0, 0, 1, 1);
  quad();
  glEndList();
  EXPECT_EQ(pixelOf([&] { glCallList(list); }), kBluePixel);
  glDeleteLists(list, 1);
  {
    const Arrays arrays(false);
    arrays.position();
    arrays.genericColor();
    EXPECT_EQ(pixelOf(kDraws[0].second), kCyanPixel);
  }
  glUseProgram(0);
  glDeleteProgram(program);
}

/// In OpenGL 2.1 generic attributes do not alias conventional ones in GLSL, and linkers number them
/// freely.
TEST_F(AliasedAttributes, TheApplicationsGlslKeepsThemApart) {
  const GLuint program =
      makeGlsl("#version 120\nattribute vec4 given;\nvarying vec4 color;\n"
               "void main() { gl_Position = gl_Vertex; color = vec4(given.r, gl_Color.g, 0, 1); }",
               "#version 120\nvarying vec4 color;\nvoid main() { gl_FragColor = color; }");
  glBindAttribLocation(program, 3, "given");
  glLinkProgram(program);
  glDisable(kVertex);
  glUseProgram(program);
  const auto draw = [] {
    glColor4f(0, 1, 0, 1);
    glVertexAttrib4f(3, 1, 0, 0, 1);
    quad();
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 3; ++i) {
      glColor4f(0, 1, 0, 1);
      glVertexAttrib4f(3, 1, 0, 0, 1);
      glVertex2fv(kCorners + 2 * i);
    }
    glEnd();
  };
  constexpr Pixel kYellowPixel = {255, 255, 0, 255};
  EXPECT_EQ(pixelOf(draw), kYellowPixel);
  const GLuint list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  draw();
  glEndList();
  EXPECT_EQ(pixelOf([&] { glCallList(list); }), kYellowPixel);
  glDeleteLists(list, 1);
  GLfloat current[4] = {};
  glGetVertexAttribfv(3, GL_CURRENT_VERTEX_ATTRIB, current);
  EXPECT_EQ(current[0], 1) << "the generic one's own";
  glUseProgram(0);
  glVertexAttrib4f(3, 0, 0, 1, 1);
  EXPECT_EQ(pixelOf(quad), kBluePixel) << "fixed function has one again";
  glDeleteProgram(program);
}

/// The default profile's card keeps them separate, and so does the host.
TEST_F(ApiTest, AttributesAreApartWhereTheyDoNotAlias) {
  if (attributesAlias() || !epoxy_has_gl_extension("GL_ARB_vertex_program"))
    GTEST_SKIP() << "attributes alias here";
  glEnable(kVertex);
  const GLuint programs[] = {makeProgram(shows("vertex.color"), kVertex),
                             makeProgram(shows("vertex.attrib[3]"), kVertex)};
  glColor4f(1, 0, 0, 1);
  glVertexAttrib4f(3, 0, 1, 0, 1);
  glBindProgramARB(kVertex, programs[0]);
  EXPECT_EQ(pixelOf(quad), kRedPixel);
  glBindProgramARB(kVertex, programs[1]);
  EXPECT_EQ(pixelOf(quad), kGreenPixel);
  glColor4f(0, 0, 1, 1);
  EXPECT_EQ(pixelOf(quad), kGreenPixel);
}

} // namespace
} // namespace api::aliases
