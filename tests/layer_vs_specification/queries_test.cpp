// The program API's queries: objects, counts, limits, error position and string, enables.
#include <cstring>

#include "fixture.h"

namespace api {
namespace {

using Queries = ApiTest;

TEST_F(Queries, NamesAndObjects) {
  GLuint names[2] = {};
  glGenProgramsARB(2, names);
  EXPECT_NE(names[0], names[1]);
  EXPECT_FALSE(glIsProgramARB(names[0])) << "generated, never bound";
  EXPECT_FALSE(glIsProgramARB(0));
  glBindProgramARB(kFragment, names[0]);
  EXPECT_TRUE(glIsProgramARB(names[0]));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(names[0]));
  glDeleteProgramsARB(2, names);
  EXPECT_FALSE(glIsProgramARB(names[0]));
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), 0) << "deleting the bound object binds 0";
}

TEST_F(Queries, NamesAreOneSpaceForBothTargets) {
  glBindProgramARB(kFragment, 1000); // never generated
  GLuint names[64] = {};
  for (int i = 0; i < 40; ++i) {
    glGenProgramsARB(64, names);
    for (const GLuint name : names)
      ASSERT_NE(name, 1000u) << "Gen gave a name that is in use";
  }
}

TEST_F(Queries, ObjectZeroIsEmpty) {
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB), 0);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), 0);
  EXPECT_EQ(programiv(GL_PROGRAM_FORMAT_ARB), GL_PROGRAM_FORMAT_ASCII_ARB);
  EXPECT_EQ(programiv(GL_PROGRAM_TEX_INDIRECTIONS_ARB), 0);
  EXPECT_EQ(programiv(GL_PROGRAM_INSTRUCTIONS_ARB), 0);
}

TEST_F(Queries, ObjectZeroIsNotUnderNativeLimits) {
  BARE_HOST_DIFFERS("always true");
  EXPECT_EQ(programiv(GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB), 0);
}

TEST_F(Queries, CountsAreComputed) {
  BARE_HOST_DIFFERS("END is counted, indirections are 0, ALU and native ALU change places");
  makeProgram("!!ARBfp1.0\n"
              "TEMP a, b, unused;\n"
              "PARAM c = {1, 2, 3, 4};\n"
              "PARAM d = program.local[3];\n"
              "TEX a, fragment.texcoord[0], texture[0], 2D;\n"
              "MAD b, a, c, d;\n"
              "TEX b, b, texture[1], 2D;\n"
              "MUL result.color, b, fragment.color;\n"
              "END");
  EXPECT_EQ(programiv(GL_PROGRAM_INSTRUCTIONS_ARB), 4);
  EXPECT_EQ(programiv(GL_PROGRAM_ALU_INSTRUCTIONS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_TEX_INSTRUCTIONS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_TEX_INDIRECTIONS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_TEMPORARIES_ARB), 3);
  EXPECT_EQ(programiv(GL_PROGRAM_PARAMETERS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_ATTRIBS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB), 1);
}

// The chip's counts differ from the text's: a SIN is a polynomial with constants of its own, and a
// read that depends on nothing needs no node of its own.
TEST_F(Queries, NativeCountsAreTheChips) {
  BARE_HOST_DIFFERS("counts the text");
  makeProgram("!!ARBfp1.0\n"
              "TEMP a, b;\n"
              "TEX a, fragment.texcoord[0], texture[0], 2D;\n"
              "SIN b, a.x;\n"
              "TEX a, fragment.texcoord[1], texture[1], 2D;\n"
              "MAD result.color, a, b, fragment.color;\n"
              "END");
  EXPECT_EQ(programiv(GL_PROGRAM_ALU_INSTRUCTIONS_ARB), 2);
  EXPECT_GT(programiv(GL_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB), 4);
  EXPECT_EQ(programiv(GL_PROGRAM_PARAMETERS_ARB), 0);
  EXPECT_GT(programiv(GL_PROGRAM_NATIVE_PARAMETERS_ARB), 0);
  EXPECT_EQ(programiv(GL_PROGRAM_TEX_INDIRECTIONS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB), 1);
  EXPECT_EQ(programiv(GL_PROGRAM_NATIVE_TEX_INSTRUCTIONS_ARB), 2);
  EXPECT_EQ(programiv(GL_PROGRAM_NATIVE_ATTRIBS_ARB), 3);
  EXPECT_EQ(programiv(GL_PROGRAM_NATIVE_INSTRUCTIONS_ARB),
            programiv(GL_PROGRAM_NATIVE_ALU_INSTRUCTIONS_ARB) + 2);
  EXPECT_EQ(programiv(GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB), 1);
}

TEST_F(Queries, LimitsAreTheProfiles) {
  BARE_HOST_DIFFERS("has its own");
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB), 64);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_TEX_INSTRUCTIONS_ARB), 32);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_TEX_INDIRECTIONS_ARB), 4);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB), 4);
  EXPECT_EQ(integer(GL_MAX_TEXTURE_IMAGE_UNITS), 16);
  EXPECT_EQ(integer(GL_MAX_TEXTURE_COORDS), 8);
  GLfloat units = 0;
  glGetFloatv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  EXPECT_EQ(units, 16.0f);
}

TEST_F(Queries, AChainOfReadsOverTheLimitLoadsAndIsNotNative) {
  BARE_HOST_DIFFERS("has no limit, and counts no indirections");
  std::string text = "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n";
  for (int i = 0; i < 4; ++i)
    text += "TEX t, t, texture[0], 2D;\n";
  makeProgram(text + "MOV result.color, t;\nEND");
  EXPECT_EQ(programiv(GL_PROGRAM_TEX_INDIRECTIONS_ARB), 5);
  EXPECT_EQ(programiv(GL_PROGRAM_UNDER_NATIVE_LIMITS_ARB), 0);
}

TEST_F(Queries, LimitsAreAtLeastTheSpecifications) {
  EXPECT_GE(programiv(GL_MAX_PROGRAM_INSTRUCTIONS_ARB), 72);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ALU_INSTRUCTIONS_ARB), 48);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_TEX_INSTRUCTIONS_ARB), 24);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_TEX_INDIRECTIONS_ARB), 4);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_TEMPORARIES_ARB), 16);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_PARAMETERS_ARB), 24);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ATTRIBS_ARB), 10);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB), 24);
  EXPECT_GE(programiv(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB), 24);
}

TEST_F(Queries, FragmentCountsOfAVertexProgramAreZero) {
  BARE_HOST_DIFFERS("raises INVALID_ENUM");
  EXPECT_EQ(programiv(GL_PROGRAM_ALU_INSTRUCTIONS_ARB, kVertex), 0);
  EXPECT_EQ(programiv(GL_MAX_PROGRAM_NATIVE_TEX_INDIRECTIONS_ARB, kVertex), 0);
}

TEST_F(Queries, TheStringComesBackWithoutTerminator) {
  makeProgram(kRed);
  EXPECT_EQ(programiv(GL_PROGRAM_LENGTH_ARB), GLint(std::strlen(kRed)));
  char text[sizeof kRed + 8];
  std::memset(text, '~', sizeof text);
  glGetProgramStringARB(kFragment, GL_PROGRAM_STRING_ARB, text);
  EXPECT_EQ(std::string(text, std::strlen(kRed)), kRed);
  if (layered()) {
    EXPECT_EQ(text[std::strlen(kRed)], '~') << "a byte past the length was written";
  }
}

TEST_F(Queries, ErrorPositionAndString) {
  makeProgram(kRed);
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), -1);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load("!!ARBfp1.0 MOV result.color, nothing; END"));
  if (layered()) { // the bare host says 27
    EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), 29);
  }
  const auto *text = reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
  ASSERT_NE(text, nullptr);
  EXPECT_NE(std::strlen(text), 0u);
  load(kRed);
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), -1);
}

TEST_F(Queries, ErrorPositionAfterANewline) {
  BARE_HOST_DIFFERS("counts from the wrong byte after a newline");
  makeProgram(kRed);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load("!!ARBfp1.0\n# a\r\nMOV result.color, nothing;\nEND"));
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), 34);
  GLfloat position = 0;
  glGetFloatv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
  EXPECT_EQ(position, 34.0f);
}

TEST_F(Queries, ErrorPositionIsSharedWithVertexPrograms) {
  makeProgram(kRed);
  glBindProgramARB(kVertex, 77);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load("!!ARBvp1.0 junk", kVertex));
  EXPECT_GE(integer(GL_PROGRAM_ERROR_POSITION_ARB), 0);
  load(kRed);
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), -1);
}

TEST_F(Queries, UnsafeVertexProgramsDoNotReachTheHost) {
  BARE_HOST_DIFFERS("its parser reads freed memory");
  std::string text = "!!ARBvp1.0\nPARAM p[] = {";
  for (int i = 0; i < 6000; ++i)
    text += (i ? ", {" : "{") + std::to_string(i) + ",2,3,4}";
  text += "};\nMOV result.position, p[0];\nEND";
  glBindProgramARB(kVertex, 78);
  EXPECT_GL_ERROR(GL_INVALID_OPERATION, load(text, kVertex));
  EXPECT_GL_ERROR(GL_INVALID_OPERATION,
                  load(std::string("!!ARBvp1.0\n\0MOV result.position, 0;\nEND", 38), kVertex));
  EXPECT_EQ(integer(GL_PROGRAM_ERROR_POSITION_ARB), 11);
}

TEST_F(Queries, ParametersComeBack) {
  makeProgram(kRed);
  const GLfloat f[8] = {1, -2, 0.5f, 4, 5, 6, 7, 8};
  glProgramEnvParameter4fvARB(kFragment, 3, f);
  glProgramEnvParameter4dARB(kFragment, 4, 0.25, 1, 2, 3);
  glProgramLocalParameters4fvEXT(kFragment, 1, 2, f);
  GLfloat fOut[4] = {};
  GLdouble dOut[4] = {};
  glGetProgramEnvParameterfvARB(kFragment, 3, fOut);
  EXPECT_EQ(fOut[1], -2.0f);
  glGetProgramEnvParameterdvARB(kFragment, 4, dOut);
  EXPECT_EQ(dOut[0], 0.25);
  glGetProgramLocalParameterfvARB(kFragment, 2, fOut);
  EXPECT_EQ(fOut[3], 8.0f);
  glGetProgramEnvParameterfvARB(kVertex, 3, fOut);
  EXPECT_EQ(fOut[1], 0.0f) << "the targets have parameters of their own";
  makeProgram(kGreen);
  glGetProgramLocalParameterfvARB(kFragment, 2, fOut);
  EXPECT_EQ(fOut[3], 0.0f) << "local parameters are the object's";
}

TEST_F(Queries, EnableAndAttributeStack) {
  EXPECT_FALSE(glIsEnabled(kFragment));
  glEnable(kFragment);
  EXPECT_TRUE(glIsEnabled(kFragment));
  EXPECT_EQ(integer(kFragment), 1);
  GLboolean enabled = GL_FALSE;
  glGetBooleanv(kFragment, &enabled);
  EXPECT_TRUE(enabled);
  const GLuint first = makeProgram(kRed);
  glPushAttrib(GL_ENABLE_BIT);
  glDisable(kFragment);
  const GLuint second = makeProgram(kGreen);
  glProgramEnvParameter4fARB(kFragment, 0, 9, 9, 9, 9);
  glPopAttrib();
  EXPECT_TRUE(glIsEnabled(kFragment)) << "the enable is in the group";
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), GLint(second)) << "the binding is in none";
  GLfloat value[4] = {};
  glGetProgramEnvParameterfvARB(kFragment, 0, value);
  EXPECT_EQ(value[0], 9.0f);
  glPushAttrib(GL_DEPTH_BUFFER_BIT);
  glDisable(kFragment);
  glPopAttrib();
  EXPECT_FALSE(glIsEnabled(kFragment)) << "another group restored the enable";
  glDeleteProgramsARB(1, &first);
}

TEST_F(Queries, AttributeStackOverflow) {
  const GLint depth = integer(GL_MAX_ATTRIB_STACK_DEPTH);
  glEnable(kFragment);
  for (GLint i = 0; i < depth; ++i)
    glPushAttrib(GL_ENABLE_BIT);
  EXPECT_GL_ERROR(GL_STACK_OVERFLOW, glPushAttrib(GL_ENABLE_BIT));
  glDisable(kFragment);
  for (GLint i = 0; i < depth; ++i)
    glPopAttrib();
  EXPECT_TRUE(glIsEnabled(kFragment));
  glDisable(kFragment);
  EXPECT_GL_ERROR(GL_STACK_UNDERFLOW, glPopAttrib());
  EXPECT_FALSE(glIsEnabled(kFragment));
}

TEST_F(Queries, ExtensionsNameWhatIsOffered) {
  const std::string all = std::string(reinterpret_cast<const char *>(glGetString(GL_EXTENSIONS)));
  EXPECT_NE(all.find("GL_ARB_fragment_program "), std::string::npos);
  EXPECT_NE(all.find("GL_ARB_fragment_program_shadow"), std::string::npos);
  EXPECT_EQ(all.find("GL_NV_fragment_program"), std::string::npos);
  if (epoxy_gl_version() >= 30) {
    bool found = false;
    const GLint count = integer(GL_NUM_EXTENSIONS);
    for (GLint i = 0; i < count; ++i)
      found |= std::strcmp(reinterpret_cast<const char *>(glGetStringi(GL_EXTENSIONS, GLuint(i))),
                           "GL_ARB_fragment_program") == 0;
    EXPECT_TRUE(found);
    EXPECT_GL_ERROR(GL_INVALID_VALUE, glGetStringi(GL_EXTENSIONS, GLuint(count)));
  }
}

TEST_F(Queries, ByName) {
  NEEDS("GL_EXT_direct_state_access");
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glNamedProgramStringEXT(name, kFragment, GL_PROGRAM_FORMAT_ASCII_ARB,
                          GLsizei(std::strlen(kLocal0)), kLocal0);
  glNamedProgramLocalParameter4fEXT(name, kFragment, 0, 0, 1, 0, 1);
  EXPECT_EQ(programiv(GL_PROGRAM_BINDING_ARB), 0) << "nothing was bound";
  glBindProgramARB(kFragment, name);
  glEnable(kFragment);
  EXPECT_EQ(drawn(), kGreenPixel);
}

} // namespace
} // namespace api
