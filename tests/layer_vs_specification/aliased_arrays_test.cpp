// Arrays of attributes that alias under two names (ARB_vertex_program, interactions with
// NV_vertex_program): which array counts, the separate enables, lists, elements.
#include "aliased_attributes.h"

namespace api::aliases {
namespace {

class AliasedArrays : public AliasedAttributes {};

TEST_F(AliasedArrays, AnArrayOfEitherNameReachesEveryReader) {
  for (const bool inBuffer : {false, true})
    for (const Reader reader : kReaders)
      for (const auto &[name, draw] : kDraws)
        for (const bool generic : {false, true}) {
          SCOPED_TRACE(std::string(name) + (generic ? ", generic" : ", conventional") +
                       (inBuffer ? ", in a buffer" : "") + ", reader " +
                       std::to_string(int(reader)));
          const Arrays arrays(inBuffer);
          read(reader);
          glColor4f(1, 0, 0, 1);
          generic ? arrays.genericPosition() : arrays.position();
          generic ? arrays.genericColor() : arrays.color();
          EXPECT_EQ(pixelOf(draw), kCyanPixel);
        }
}

TEST_F(AliasedArrays, TheGenericArrayCountsBesideTheConventionalOne) {
  constexpr GLubyte kRedColors[4][4] = {
      {255, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}, {255, 0, 0, 255}};
  for (const Reader reader : kReaders)
    for (const auto &[name, draw] : kDraws) {
      SCOPED_TRACE(std::string(name) + ", reader " + std::to_string(int(reader)));
      const Arrays arrays(false);
      read(reader);
      arrays.position();
      glColorPointer(4, GL_UNSIGNED_BYTE, 0, kRedColors);
      glEnableClientState(GL_COLOR_ARRAY);
      arrays.genericColor();
      EXPECT_EQ(pixelOf(draw), kCyanPixel);
      glDisableVertexAttribArray(3);
      EXPECT_EQ(pixelOf(draw), kRedPixel) << "the generic one is disabled";
      glDisableClientState(GL_COLOR_ARRAY);
      glVertexAttrib4f(3, 0, 1, 0, 1);
      EXPECT_EQ(pixelOf(draw), kGreenPixel) << "and the other";
      arrays.genericColor();
      glColor4f(0, 0, 1, 1);
      EXPECT_EQ(pixelOf(quad), kBluePixel) << "no array reaches Begin and End";
    }
}

TEST_F(AliasedArrays, ListsOfArrays) {
  for (const GLenum mode : {GL_COMPILE, GL_COMPILE_AND_EXECUTE})
    for (const Reader reader : kReaders)
      for (const auto &[name, draw] : kDraws) {
        SCOPED_TRACE(std::string(name) + ", reader " + std::to_string(int(reader)));
        read(reader);
        const GLuint list = glGenLists(1);
        {
          const Arrays arrays(true);
          arrays.position();
          arrays.genericColor();
          glColor4f(1, 0, 0, 1);
          clear();
          glNewList(list, mode);
          draw();
          glEndList();
          if (mode == GL_COMPILE_AND_EXECUTE) {
            EXPECT_EQ(readPixel(), kCyanPixel);
          }
        }
        glColor4f(1, 0, 0, 1);
        EXPECT_EQ(pixelOf([&] { glCallList(list); }), kCyanPixel);
        glDeleteLists(list, 1);
      }
}

TEST_F(AliasedArrays, ArraysOfNvidiasEnablesAreOfProgramsAlone) {
  NEEDS("GL_NV_vertex_program");
  for (const auto &[name, draw] : kDraws) {
    SCOPED_TRACE(name);
    const Arrays arrays(false);
    arrays.position();
    arrays.pointAtGenericColor();
    glEnableClientState(GL_VERTEX_ATTRIB_ARRAY0_NV + 3);
    for (const Reader reader : kReaders) {
      read(reader);
      glColor4f(0, 1, 0, 1);
      EXPECT_EQ(pixelOf(draw), reader == Reader::FixedFunction ? kGreenPixel : kCyanPixel)
          << int(reader);
    }
    glEnableVertexAttribArray(3); // enables both
    EXPECT_EQ(pixelOf(draw), kCyanPixel);
    glDisableClientState(GL_VERTEX_ATTRIB_ARRAY0_NV + 3);
  }
}

TEST_F(AliasedArrays, ElementsOfArrays) {
  if (!rasterizerDrawsAll())
    GTEST_SKIP() << "the host may draw: a primitive of its own has its elements";
  for (const Reader reader : kReaders) {
    const Arrays arrays(false);
    read(reader);
    glColor4f(1, 0, 0, 1);
    arrays.position();
    arrays.genericColor();
    const auto draw = [] {
      glBegin(GL_QUADS);
      for (int i = 0; i < 4; ++i)
        glArrayElement(i);
      glEnd();
    };
    EXPECT_EQ(pixelOf(draw), kCyanPixel) << int(reader);
  }
}

} // namespace
} // namespace api::aliases
