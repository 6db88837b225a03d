// ATI_fragment_shader: names, and every rule of AFS's section Errors.
#include "ati_shader.h"

namespace api {
namespace {

using namespace ati;

constexpr GLuint kReg0 = GL_REG_0_ATI;
constexpr GLuint kReg1 = GL_REG_1_ATI;
constexpr Arg kZero = {GL_ZERO};

/// Begins and ends shader definitions; the shader need not be valid.
class AtiErrors : public ApiTest {
protected:
  void begin() { glBeginFragmentShaderATI(); }
  void finish(GLenum error = GL_NO_ERROR) { EXPECT_GL_ERROR(error, glEndFragmentShaderATI()); }
};

#define EXPECT_INVALID_ENUM(call) EXPECT_GL_ERROR(GL_INVALID_ENUM, call)
#define EXPECT_INVALID_OPERATION(call) EXPECT_GL_ERROR(GL_INVALID_OPERATION, call)

TEST_F(AtiErrors, Names) {
  EXPECT_GL_ERROR(GL_INVALID_VALUE, EXPECT_EQ(glGenFragmentShadersATI(0), 0u));
  const GLuint first = glGenFragmentShadersATI(3);
  ASSERT_NE(first, 0u);
  const GLuint next = glGenFragmentShadersATI(1);
  EXPECT_TRUE(next < first || next >= first + 3) << next;
  EXPECT_NO_GL_ERROR(glDeleteFragmentShaderATI(0));
  EXPECT_NO_GL_ERROR(glDeleteFragmentShaderATI(first + 1));
  EXPECT_NO_GL_ERROR(glDeleteFragmentShaderATI(987654)); // unused
  // GenFragmentShadersATI did not return this name
  EXPECT_NO_GL_ERROR(glBindFragmentShaderATI(4242));
  const GLuint more = glGenFragmentShadersATI(2);
  EXPECT_TRUE(more + 1 < 4242 || more > 4242);
}

TEST_F(AtiErrors, NamesInARow) {
  BARE_HOST_DIFFERS("names of all 32 bits are not searched");
  glBindFragmentShaderATI(5);
  const GLuint row = glGenFragmentShadersATI(0xFFFFFF00u);
  EXPECT_EQ(row, 6u);
  // So many consecutive names do not exist
  EXPECT_NO_GL_ERROR(EXPECT_EQ(glGenFragmentShadersATI(1000), 0u));
}

TEST_F(AtiErrors, InsideAPair) {
  begin();
  EXPECT_INVALID_OPERATION(EXPECT_EQ(glGenFragmentShadersATI(1), 0u));
  EXPECT_INVALID_OPERATION(glBindFragmentShaderATI(2));
  EXPECT_INVALID_OPERATION(glDeleteFragmentShaderATI(2));
  EXPECT_INVALID_OPERATION(glBeginFragmentShaderATI());
  moveAll(GL_ONE);
  finish();
}

TEST_F(AtiErrors, OutsideAPair) {
  EXPECT_INVALID_OPERATION(glEndFragmentShaderATI());
  EXPECT_INVALID_OPERATION(pass(kReg0, GL_TEXTURE0));
  EXPECT_INVALID_OPERATION(sample(kReg0, GL_TEXTURE0));
  EXPECT_INVALID_OPERATION(color1(GL_MOV_ATI, kReg0, kZero));
  EXPECT_INVALID_OPERATION(color2(GL_ADD_ATI, kReg0, kZero, kZero));
  EXPECT_INVALID_OPERATION(color3(GL_MAD_ATI, kReg0, kZero, kZero, kZero));
  EXPECT_INVALID_OPERATION(alpha1(GL_MOV_ATI, kReg0, kZero));
  EXPECT_INVALID_OPERATION(alpha2(GL_ADD_ATI, kReg0, kZero, kZero));
  EXPECT_INVALID_OPERATION(alpha3(GL_MAD_ATI, kReg0, kZero, kZero, kZero));
}

TEST_F(AtiErrors, BetweenBeginAndEnd) {
  BARE_HOST_DIFFERS("it does not look for Begin");
  const GLfloat value[4] = {};
  glBegin(GL_POINTS);
  glBeginFragmentShaderATI();
  glBindFragmentShaderATI(3);
  glDeleteFragmentShaderATI(3);
  glSetFragmentShaderConstantATI(GL_CON_0_ATI, value);
  glEnable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_EQ(glGenFragmentShadersATI(1), 0u);
  glEnd();
  EXPECT_EQ(glGetError(), GLenum(GL_INVALID_OPERATION));
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
  EXPECT_INVALID_OPERATION(glEndFragmentShaderATI()); // no pair is open
}

TEST_F(AtiErrors, Registers) {
  begin();
  for (const GLuint dst : {GLuint(GL_NONE), GLuint(GL_CON_0_ATI), GLuint(GL_REG_5_ATI + 1),
                           GLuint(GL_TEXTURE0), GLuint(GL_REG_0_ATI - 1)}) {
    EXPECT_INVALID_ENUM(pass(dst, GL_TEXTURE0));
    EXPECT_INVALID_ENUM(sample(dst, GL_TEXTURE0));
    EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, dst, kZero));
    EXPECT_INVALID_ENUM(alpha1(GL_MOV_ATI, dst, kZero));
  }
  for (const GLuint source : {GLuint(GL_NONE), GLuint(GL_CON_0_ATI), GLuint(GL_REG_5_ATI + 1),
                              GLuint(GL_TEXTURE0 + 8), GLuint(GL_TEXTURE0 - 1)}) {
    EXPECT_INVALID_ENUM(pass(kReg0, source));
    EXPECT_INVALID_ENUM(sample(kReg0, source));
  }
  for (const GLenum swizzle : {GL_NONE, GL_SWIZZLE_STR_ATI - 1})
    EXPECT_INVALID_ENUM(pass(kReg0, GL_TEXTURE0, swizzle));
  finish(GL_INVALID_OPERATION); // the shader is empty
}

TEST_F(AtiErrors, SwizzlesOfOldRevisions) {
  BARE_HOST_DIFFERS("takes any name from STR on");
  begin();
  EXPECT_INVALID_ENUM(pass(kReg0, GL_TEXTURE0, GL_SWIZZLE_STRQ_ATI));
  EXPECT_INVALID_ENUM(sample(kReg0, GL_TEXTURE0, GL_SWIZZLE_STRQ_DQ_ATI));
  finish(GL_INVALID_OPERATION);
}

TEST_F(AtiErrors, Arguments) {
  begin();
  for (const GLuint source : {GLuint(GL_TEXTURE0), GLuint(GL_CON_7_ATI + 1), GLuint(GL_RED),
                              GLuint(GL_REG_5_ATI + 1), 2u}) {
    EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, kReg0, {source}));
    EXPECT_INVALID_ENUM(color2(GL_ADD_ATI, kReg0, kZero, {source}));
    EXPECT_INVALID_ENUM(color3(GL_MAD_ATI, kReg0, kZero, kZero, {source}));
    EXPECT_INVALID_ENUM(alpha1(GL_MOV_ATI, kReg0, {source}));
    EXPECT_INVALID_ENUM(alpha3(GL_MAD_ATI, kReg0, kZero, kZero, {source}));
  }
  finish(GL_INVALID_OPERATION);
}

TEST_F(AtiErrors, OpcodesOfTheirCommands) {
  BARE_HOST_DIFFERS("an opcode of another command is taken");
  begin();
  EXPECT_INVALID_ENUM(color1(GL_ADD_ATI, kReg0, kZero));
  EXPECT_INVALID_ENUM(color2(GL_MAD_ATI, kReg0, kZero, kZero));
  EXPECT_INVALID_ENUM(color3(GL_MOV_ATI, kReg0, kZero, kZero, kZero));
  EXPECT_INVALID_ENUM(alpha1(GL_RED, kReg0, kZero));
  EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, kReg0, {GL_ZERO, GL_RGB}));
  EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, kReg0, {GL_ZERO, GL_NONE, 0x10}));
  EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, kReg0, kZero, 8));
  finish(GL_INVALID_OPERATION);
}

TEST_F(AtiErrors, DestinationModifiers) {
  begin();
  constexpr GLuint kScales[] = {GL_2X_BIT_ATI,   GL_4X_BIT_ATI,      GL_8X_BIT_ATI,
                                GL_HALF_BIT_ATI, GL_QUARTER_BIT_ATI, GL_EIGHTH_BIT_ATI};
  for (const GLuint a : kScales)
    for (const GLuint b : kScales) {
      if (a == b)
        continue;
      EXPECT_INVALID_ENUM(color1(GL_MOV_ATI, kReg0, kZero, GL_NONE, a | b));
      EXPECT_INVALID_ENUM(alpha1(GL_MOV_ATI, kReg0, kZero, a | b | GL_SATURATE_BIT_ATI));
    }
  EXPECT_INVALID_ENUM(alpha1(GL_MOV_ATI, kReg0, kZero, 0x80));
  for (const GLuint scale : kScales)
    EXPECT_NO_GL_ERROR(
        color1(GL_MOV_ATI, kReg0, kZero, GL_NONE, scale | GLuint(GL_SATURATE_BIT_ATI)));
  finish();
}

TEST_F(AtiErrors, Passes) {
  begin();
  EXPECT_INVALID_OPERATION(pass(kReg0, kReg1)); // a register in the first pass
  EXPECT_NO_GL_ERROR(pass(kReg0, GL_TEXTURE0));
  EXPECT_INVALID_OPERATION(pass(kReg0, GL_TEXTURE1));   // twice in a pass
  EXPECT_INVALID_OPERATION(sample(kReg0, GL_TEXTURE1)); // twice in a pass
  color1(GL_MOV_ATI, kReg0, kZero);
  EXPECT_INVALID_OPERATION(pass(kReg0, kReg0, GL_SWIZZLE_STQ_ATI)); // registers have no q
  EXPECT_INVALID_OPERATION(sample(kReg0, kReg0, GL_SWIZZLE_STQ_DQ_ATI));
  EXPECT_NO_GL_ERROR(pass(kReg0, kReg0, GL_SWIZZLE_STR_DR_ATI)); // the second pass
  EXPECT_INVALID_OPERATION(sample(kReg0, GL_TEXTURE0));          // twice in a pass
  EXPECT_NO_GL_ERROR(sample(kReg1, kReg0));                      // one register, two swizzles
  color1(GL_MOV_ATI, kReg0, kZero);
  EXPECT_INVALID_OPERATION(pass(kReg0, GL_TEXTURE0));    // a third pass
  EXPECT_INVALID_OPERATION(sample(GL_REG_2_ATI, kReg0)); // a third pass
  finish();
}

TEST_F(AtiErrors, OneFamilyOfCoordinates) {
  begin();
  EXPECT_NO_GL_ERROR(pass(kReg0, GL_TEXTURE3, GL_SWIZZLE_STR_ATI));
  EXPECT_INVALID_OPERATION(sample(GL_REG_2_ATI, GL_TEXTURE3, GL_SWIZZLE_STQ_ATI));
  EXPECT_NO_GL_ERROR(sample(GL_REG_2_ATI, GL_TEXTURE3, GL_SWIZZLE_STR_DR_ATI));
  EXPECT_NO_GL_ERROR(sample(GL_REG_3_ATI, GL_TEXTURE4, GL_SWIZZLE_STQ_DQ_ATI));
  color1(GL_MOV_ATI, kReg0, kZero);
  // The rule is for the whole shader
  EXPECT_INVALID_OPERATION(pass(kReg0, GL_TEXTURE3, GL_SWIZZLE_STQ_DQ_ATI));
  EXPECT_NO_GL_ERROR(pass(kReg0, GL_TEXTURE4, GL_SWIZZLE_STQ_ATI));
  color1(GL_MOV_ATI, kReg0, kZero);
  finish();
}

TEST_F(AtiErrors, EightPairsAPass) {
  const auto eight = [] {
    for (int i = 0; i < 8; ++i)
      EXPECT_NO_GL_ERROR(moveAll(GL_ZERO));
    EXPECT_INVALID_OPERATION(color1(GL_MOV_ATI, kReg0, kZero));
    EXPECT_INVALID_OPERATION(alpha1(GL_MOV_ATI, kReg0, kZero));
  };
  begin();
  eight();
  pass(kReg0, GL_TEXTURE0);
  eight();
  finish();
  begin();
  for (int i = 0; i < 4; ++i) { // they do not form pairs: alpha comes first
    alpha1(GL_MOV_ATI, kReg0, kZero);
    alpha1(GL_MOV_ATI, kReg0, kZero);
  }
  EXPECT_INVALID_OPERATION(alpha1(GL_MOV_ATI, kReg0, kZero));
  EXPECT_INVALID_OPERATION(color1(GL_MOV_ATI, kReg0, kZero));
  finish();
}

TEST_F(AtiErrors, SecondaryColorHasNoAlpha) {
  constexpr GLuint kSecondary = GL_SECONDARY_INTERPOLATOR_ATI;
  begin();
  EXPECT_INVALID_OPERATION(color1(GL_MOV_ATI, kReg0, {kSecondary, GL_ALPHA}));
  EXPECT_INVALID_OPERATION(alpha1(GL_MOV_ATI, kReg0, {kSecondary, GL_ALPHA}));
  EXPECT_INVALID_OPERATION(alpha1(GL_MOV_ATI, kReg0, {kSecondary}));
  EXPECT_INVALID_OPERATION(color2(GL_DOT4_ATI, kReg0, {kSecondary}, kZero));
  EXPECT_INVALID_OPERATION(color2(GL_DOT4_ATI, kReg0, kZero, {kSecondary, GL_ALPHA}));
  EXPECT_NO_GL_ERROR(color1(GL_MOV_ATI, kReg0, {kSecondary}));
  EXPECT_NO_GL_ERROR(color2(GL_DOT3_ATI, kReg0, {kSecondary}, kZero));
  EXPECT_NO_GL_ERROR(alpha1(GL_MOV_ATI, kReg0, {kSecondary, GL_BLUE}));
  EXPECT_NO_GL_ERROR(color2(GL_DOT4_ATI, kReg0, {kSecondary, GL_RED}, kZero));
  finish();
}

TEST_F(AtiErrors, ThreeConstants) {
  constexpr Arg a = {GL_CON_0_ATI};
  constexpr Arg b = {GL_CON_1_ATI};
  constexpr Arg c = {GL_CON_7_ATI};
  begin();
  EXPECT_INVALID_OPERATION(color3(GL_MAD_ATI, kReg0, a, b, c));
  EXPECT_INVALID_OPERATION(alpha3(GL_LERP_ATI, kReg0, a, b, c));
  EXPECT_NO_GL_ERROR(color3(GL_MAD_ATI, kReg0, a, b, a));
  EXPECT_NO_GL_ERROR(color3(GL_MAD_ATI, kReg0, a, a, b));
  EXPECT_NO_GL_ERROR(color3(GL_MAD_ATI, kReg0, a, b, kZero));
  finish();
}

TEST_F(AtiErrors, DotProductsPair) {
  begin();
  EXPECT_INVALID_OPERATION(alpha2(GL_DOT3_ATI, kReg0, kZero, kZero)); // no operation before it
  color2(GL_ADD_ATI, kReg0, kZero, kZero);
  EXPECT_INVALID_OPERATION(alpha2(GL_DOT4_ATI, kReg0, kZero, kZero)); // another operation before it
  EXPECT_INVALID_OPERATION(alpha3(GL_DOT2_ADD_ATI, kReg0, kZero, kZero, kZero));
  color2(GL_DOT4_ATI, kReg0, kZero, kZero);
  EXPECT_INVALID_OPERATION(alpha2(GL_MUL_ATI, kReg0, kZero, kZero)); // DOT4 needs both units
  EXPECT_NO_GL_ERROR(alpha2(GL_DOT4_ATI, kReg0, kZero, kZero));
  EXPECT_NO_GL_ERROR(alpha2(GL_MUL_ATI, kReg0, kZero, kZero)); // a separate pair
  color3(GL_DOT2_ADD_ATI, kReg0, kZero, kZero, kZero);
  EXPECT_NO_GL_ERROR(alpha3(GL_DOT2_ADD_ATI, kReg0, kZero, kZero, kZero));
  color2(GL_DOT3_ATI, kReg0, kZero, kZero);
  EXPECT_NO_GL_ERROR(alpha1(GL_MOV_ATI, kReg0, kZero)); // DOT3 leaves the alpha unit free
  color2(GL_DOT4_ATI, kReg0, kZero, kZero);
  // The second pass, in which nothing precedes
  pass(kReg0, GL_TEXTURE0);
  // The bare host finds no operation in a pass
  finish(layered() ? GL_NO_ERROR : GL_INVALID_OPERATION);
}

TEST_F(AtiErrors, AlphaDotHasItsColorDirectlyBefore) {
  BARE_HOST_DIFFERS("a second DOT3 of alpha joins nothing and is taken");
  begin();
  color2(GL_DOT3_ATI, kReg0, kZero, kZero);
  EXPECT_NO_GL_ERROR(alpha2(GL_DOT3_ATI, kReg0, kZero, kZero));
  EXPECT_INVALID_OPERATION(alpha2(GL_DOT3_ATI, kReg0, kZero, kZero));
  finish();
}

TEST_F(AtiErrors, ColorsAreOfTheLastPass) {
  for (const GLuint source : {GL_PRIMARY_COLOR, GL_SECONDARY_INTERPOLATOR_ATI}) {
    begin();
    color1(GL_MOV_ATI, kReg0, {source});
    pass(kReg0, kReg0);
    color1(GL_MOV_ATI, kReg0, {kReg0});
    finish(GL_INVALID_OPERATION);
    EXPECT_INVALID_OPERATION(glEndFragmentShaderATI()); // the pair is closed
    begin();
    color1(GL_MOV_ATI, kReg0, kZero);
    pass(kReg0, kReg0);
    color1(GL_MOV_ATI, kReg0, {source});
    finish();
  }
}

TEST_F(AtiErrors, ConstantNames) {
  const GLfloat value[4] = {};
  for (const GLuint dst : {GLuint(GL_CON_7_ATI + 1), GLuint(GL_REG_0_ATI), 0u})
    EXPECT_INVALID_ENUM(glSetFragmentShaderConstantATI(dst, value));
  EXPECT_NO_GL_ERROR(glSetFragmentShaderConstantATI(GL_CON_7_ATI, value));
}

TEST_F(AtiErrors, StateAndItsQueries) {
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
  EXPECT_EQ(integer(GL_FRAGMENT_SHADER_ATI), 0);
  glEnable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_TRUE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
  EXPECT_EQ(integer(GL_FRAGMENT_SHADER_ATI), 1);
  glDisable(GL_FRAGMENT_SHADER_ATI);
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
}

TEST_F(AtiErrors, TheEnableIsInItsGroup) {
  BARE_HOST_DIFFERS("PopAttrib leaves it as it is");
  glPushAttrib(GL_ENABLE_BIT);
  glEnable(GL_FRAGMENT_SHADER_ATI);
  glPushAttrib(GL_FOG_BIT);
  glDisable(GL_FRAGMENT_SHADER_ATI);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
  glEnable(GL_FRAGMENT_SHADER_ATI);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(GL_FRAGMENT_SHADER_ATI));
}

TEST_F(AtiErrors, DeprecatedQueries) {
  BARE_HOST_DIFFERS("INVALID_ENUM");
  EXPECT_EQ(integer(GL_NUM_FRAGMENT_REGISTERS_ATI), 6);
  EXPECT_EQ(integer(GL_NUM_FRAGMENT_CONSTANTS_ATI), 8);
  EXPECT_EQ(integer(GL_NUM_PASSES_ATI), 2);
  EXPECT_EQ(integer(GL_NUM_INSTRUCTIONS_PER_PASS_ATI), 8);
  EXPECT_EQ(integer(GL_NUM_INSTRUCTIONS_TOTAL_ATI), 16);
  EXPECT_EQ(integer(GL_NUM_INPUT_INTERPOLATOR_COMPONENTS_ATI), 3);
  EXPECT_EQ(integer(GL_NUM_LOOPBACK_COMPONENTS_ATI), 3);
  EXPECT_EQ(integer(GL_COLOR_ALPHA_PAIRING_ATI), 1);
}

} // namespace
} // namespace api
