// Checks program parameters of NV_vertex_program (2.14.1.2), matrix tracking (2.14.5), and named
// parameters (NV_fragment_program 3.11.1).
#include <array>
#include <string>

#include <gtest/gtest.h>

#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

GLenum set(Context &context, GLenum target, GLuint index) {
  handlers::ProgramParameter4fNV(context, target, index, 1, 2, 3, 4);
  return error(context);
}

GLenum track(Context &context, GLuint address, GLenum matrix, GLenum transform = GL_IDENTITY_NV) {
  handlers::TrackMatrixNV(context, kNvVertex, address, matrix, transform);
  return error(context);
}

TEST(NvParameters, AreTheEnvParameters) {
  NvHost host;
  const CurrentContext context(host);
  EXPECT_EQ(set(*context, kNvVertex, 255), kNoError);
  EXPECT_EQ(parameter(*context, 255), (Vec4{1, 2, 3, 4}));
  Vec4 env{};
  handlers::GetProgramEnvParameterfvARB(*context, kVertex, 255, env.data());
  EXPECT_EQ(env, (Vec4{1, 2, 3, 4}));
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 255, 5, 6, 7, 8);
  GLdouble wide[4] = {};
  handlers::GetProgramParameterdvNV(*context, kNvVertex, 255, GL_PROGRAM_PARAMETER_NV, wide);
  EXPECT_EQ(wide[3], 8.0);
  const GLdouble doubles[] = {1, 2, 3, 4, 5, 6, 7, 8};
  handlers::ProgramParameters4dvNV(*context, kNvVertex, 3, 2, doubles);
  EXPECT_EQ(parameter(*context, 4), (Vec4{5, 6, 7, 8}));
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvParameters, Errors) {
  NvHost host;
  const CurrentContext context(host);
  EXPECT_EQ(set(*context, kNvVertex, 256), kValue);
  EXPECT_EQ(set(*context, kFragment, 0), kEnum);
  EXPECT_EQ(set(*context, kNvFragment, 0), kEnum);
  const auto several = [&](GLuint index, GLsizei count) {
    const std::array<GLfloat, 32> values{};
    handlers::ProgramParameters4fvNV(*context, kNvVertex, index, count, values.data());
    return error(*context);
  };
  EXPECT_EQ(several(250, 8), kValue);
  EXPECT_EQ(several(0, -1), kValue);
  EXPECT_EQ(several(0, 0), kNoError);
  EXPECT_EQ(several(0, 1 << 30), kValue);
  Vec4 value{};
  const auto get = [&](GLenum target, GLuint index, GLenum pname) {
    handlers::GetProgramParameterfvNV(*context, target, index, pname, value.data());
    return error(*context);
  };
  EXPECT_EQ(get(kNvVertex, 256, GL_PROGRAM_PARAMETER_NV), kValue);
  EXPECT_EQ(get(kNvVertex, 0, 0x1234), kEnum);
  EXPECT_EQ(get(kFragment, 0, GL_PROGRAM_PARAMETER_NV), kEnum);
  EXPECT_EQ(
      errorInsideBegin(*context,
                       [&] { handlers::ProgramParameter4fNV(*context, kNvVertex, 0, 1, 1, 1, 1); }),
      kOperation);
}

TEST(NvTrack, Errors) {
  NvHost host;
  const CurrentContext context(host);
  EXPECT_EQ(track(*context, 88, GL_MODELVIEW), kNoError);
  EXPECT_EQ(track(*context, 96, GL_MODELVIEW), kNoError);
  EXPECT_EQ(track(*context, 252, GL_MODELVIEW), kNoError);
  EXPECT_EQ(track(*context, 1, GL_MODELVIEW), kValue);
  EXPECT_EQ(track(*context, 256, GL_MODELVIEW), kValue);
  EXPECT_EQ(track(*context, 4, 0x1234), kEnum);
  EXPECT_EQ(track(*context, 4, GL_MODELVIEW, 0x1234), kEnum);
  handlers::TrackMatrixNV(*context, kFragment, 4, GL_MODELVIEW, GL_IDENTITY_NV);
  EXPECT_EQ(error(*context), kEnum);
  for (const GLenum matrix : {GL_MATRIX0_NV, GL_MATRIX7_NV, GL_MATRIX0_ARB, GL_TEXTURE3,
                              GL_PROJECTION, GL_MODELVIEW_PROJECTION_NV})
    EXPECT_EQ(track(*context, 4, matrix), kNoError) << matrix;
  EXPECT_EQ(track(*context, 4, GL_COLOR), kEnum) << "of ARB_imaging, which the host lacks";
  EXPECT_EQ(errorInsideBegin(
                *context,
                [&] { handlers::TrackMatrixNV(*context, kNvVertex, 0, GL_NONE, GL_IDENTITY_NV); }),
            kOperation);
}

TEST(NvTrack, Queries) {
  NvHost host;
  host.integers[GL_ACTIVE_TEXTURE] = GL_TEXTURE0;
  const CurrentContext context(host);
  const auto get = [&](GLuint address, GLenum pname, GLenum target = kNvVertex) {
    GLint value = -1;
    handlers::GetTrackMatrixivNV(*context, target, address, pname, &value);
    return value;
  };
  EXPECT_EQ(get(8, GL_TRACK_MATRIX_NV), GL_NONE);
  EXPECT_EQ(get(8, GL_TRACK_MATRIX_TRANSFORM_NV), GL_IDENTITY_NV);
  track(*context, 8, GL_TEXTURE, GL_INVERSE_TRANSPOSE_NV);
  EXPECT_EQ(get(8, GL_TRACK_MATRIX_NV), GL_TEXTURE0) << "TEXTURE is the active unit's";
  EXPECT_EQ(get(8, GL_TRACK_MATRIX_TRANSFORM_NV), GL_INVERSE_TRANSPOSE_NV);
  EXPECT_EQ(error(*context), kNoError);
  get(2, GL_TRACK_MATRIX_NV);
  EXPECT_EQ(error(*context), kValue);
  get(256, GL_TRACK_MATRIX_NV);
  EXPECT_EQ(error(*context), kValue);
  get(4, 0x1234);
  EXPECT_EQ(error(*context), kEnum);
  get(4, GL_TRACK_MATRIX_NV, kFragment);
  EXPECT_EQ(error(*context), kEnum);
}

/// Sets the modelview matrix to a translation by (2, 3, 4), and the projection to a scale by 2.
/// Matrices are in GL's column order.
void setMatrices(NvHost &host) {
  host.floats[GL_MODELVIEW_MATRIX] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 3, 4, 1};
  host.floats[GL_PROJECTION_MATRIX] = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1};
}

TEST(NvTrack, RowsAreThoseOfTheTransformedMatrix) {
  NvHost host;
  setMatrices(host);
  const CurrentContext context(host);
  struct Case {
    GLenum transform;
    Vec4 first, last;
  };
  const Case cases[] = {{GL_IDENTITY_NV, {2, 0, 0, 4}, {0, 0, 0, 1}},
                        {GL_INVERSE_NV, {0.5f, 0, 0, -2}, {0, 0, 0, 1}},
                        {GL_TRANSPOSE_NV, {2, 0, 0, 0}, {4, 6, 8, 1}},
                        {GL_INVERSE_TRANSPOSE_NV, {0.5f, 0, 0, 0}, {-2, -3, -4, 1}}};
  for (const Case &c : cases) {
    track(*context, 40, GL_MODELVIEW_PROJECTION_NV, c.transform);
    EXPECT_EQ(parameter(*context, 40), c.first) << c.transform;
    EXPECT_EQ(parameter(*context, 43), c.last) << c.transform;
  }
}

TEST(NvTrack, OfTextureAndProgramMatrices) {
  NvHost host;
  host.floats[GL_TEXTURE_MATRIX] = {1, 5, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  host.floats[GL_CURRENT_MATRIX_ARB] = {1, 6, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const CurrentContext context(host);
  track(*context, 0, GL_TEXTURE1);
  EXPECT_EQ(parameter(*context, 1), (Vec4{5, 1, 0, 0}));
  EXPECT_GT(host.count("ActiveTexture " + std::to_string(GL_TEXTURE1)), 0);
  track(*context, 0, GL_MATRIX0_NV + 2);
  EXPECT_EQ(parameter(*context, 1), (Vec4{6, 1, 0, 0}));
  EXPECT_GT(host.count("MatrixMode " + std::to_string(GL_MATRIX0_ARB + 2)), 0);
}

TEST(NvTrack, NoCommandChangesATrackedParameter) {
  NvHost host;
  setMatrices(host);
  const CurrentContext context(host);
  track(*context, 88, GL_MODELVIEW);
  EXPECT_EQ(set(*context, kNvVertex, 88), kOperation);
  EXPECT_EQ(set(*context, kNvVertex, 91), kOperation);
  EXPECT_EQ(set(*context, kNvVertex, 92), kNoError);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 88, 7, 7, 7, 7);
  EXPECT_EQ(error(*context), kNoError);
  const std::array<GLfloat, 16> values = {1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4, 1, 2, 3, 4};
  handlers::ProgramParameters4fvNV(*context, kNvVertex, 86, 4, values.data());
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_EQ(parameter(*context, 86), Vec4{}) << "a command that is an error does nothing";
  EXPECT_EQ(parameter(*context, 88), (Vec4{1, 0, 0, 2}));
  handlers::ProgramEnvParameters4fvEXT(*context, kVertex, 86, 4, values.data());
  EXPECT_EQ(parameter(*context, 87), (Vec4{1, 2, 3, 4}));
  EXPECT_EQ(parameter(*context, 89), (Vec4{0, 1, 0, 3}));
}

TEST(NvTrack, ParametersKeepTheirLastValuesWhenItEnds) {
  NvHost host;
  setMatrices(host);
  const CurrentContext context(host);
  track(*context, 88, GL_MODELVIEW);
  host.floats[GL_MODELVIEW_MATRIX][12] = 9;
  track(*context, 88, GL_NONE);
  host.floats[GL_MODELVIEW_MATRIX][12] = 11;
  EXPECT_EQ(parameter(*context, 88), (Vec4{1, 0, 0, 9}));
  EXPECT_EQ(set(*context, kNvVertex, 88), kNoError);
  EXPECT_EQ(parameter(*context, 88), (Vec4{1, 2, 3, 4}));
}

TEST(NvTrack, ADrawSeesTheMatrixAsItIs) {
  NvHost host;
  setMatrices(host);
  const CurrentContext context(host);
  use(*context, "!!ARBvp1.0\nADD result.position, vertex.position, program.env[88];\nEND", kVertex);
  track(*context, 88, GL_MODELVIEW);
  const auto sent = [&](int x) {
    return host.count("ProgramEnvParameter4fv " + std::to_string(kVertex) + " 88 " +
                      std::to_string(x));
  };
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(1), 1);
  host.floats[GL_MODELVIEW_MATRIX][0] = 5; // by a command that the layer does not see
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(5), 1);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(sent(5), 1) << "sent once, as it did not change";
}

TEST(NvMatrixMode, ItsMatricesAreTheArbs) {
  NvHost host;
  const CurrentContext context(host);
  handlers::MatrixMode(*context, GL_MATRIX0_NV + 3);
  handlers::MatrixMode(*context, GL_PROJECTION);
  EXPECT_EQ(host.count("MatrixMode " + std::to_string(GL_MATRIX0_ARB + 3)), 1);
  EXPECT_EQ(host.count("MatrixMode " + std::to_string(GL_PROJECTION)), 1);
  handlers::MatrixMode(*context, GL_MATRIX0_NV + 8);
  EXPECT_EQ(host.count("MatrixMode " + std::to_string(GL_MATRIX0_NV + 8)), 1) << "no such matrix";
}

// --- Named parameters ---

GLenum name(Context &context, GLuint id, std::string_view text, GLfloat x) {
  handlers::ProgramNamedParameter4fNV(context, id, GLsizei(text.size()),
                                      reinterpret_cast<const GLubyte *>(text.data()), x, 6, 7, 8);
  return error(context);
}

Vec4 named(Context &context, GLuint id, std::string_view text) {
  Vec4 value = {-1, -1, -1, -1};
  handlers::GetProgramNamedParameterfvNV(context, id, GLsizei(text.size()),
                                         reinterpret_cast<const GLubyte *>(text.data()),
                                         value.data());
  return value;
}

TEST(NvNamed, AreOfTheirProgramWhetherItIsBoundOrNot) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 103, kFp);
  EXPECT_EQ(named(*context, 103, "blue"), (Vec4{1, 2, 3, 4})) << "what DECLARE gives";
  EXPECT_EQ(name(*context, 103, "blue", 5), kNoError);
  EXPECT_EQ(named(*context, 103, "blue"), (Vec4{5, 6, 7, 8}));
  const auto *const blue = reinterpret_cast<const GLubyte *>("blue of more");
  handlers::ProgramNamedParameter4fNV(*context, 103, 4, blue, 9, 10, 11, 12);
  GLdouble wide[4] = {};
  handlers::GetProgramNamedParameterdvNV(*context, 103, 4, blue, wide);
  EXPECT_EQ(wide[3], 12.0);
  for (const std::string &text : {std::string(kFp) + " ", std::string(kFp) + " "}) {
    loadNv(*context, kNvFragment, 103, text);
    EXPECT_EQ(named(*context, 103, "blue"), (Vec4{1, 2, 3, 4})) << "loaded anew";
    EXPECT_EQ(name(*context, 103, "blue", 5), kNoError);
  }
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvNamed, Errors) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvFragment, 103, kFp);
  EXPECT_EQ(name(*context, 103, "", 5), kValue);
  EXPECT_EQ(name(*context, 103, "red", 5), kValue);
  EXPECT_EQ(name(*context, 103, "blu", 5), kValue);
  EXPECT_EQ(name(*context, 103, std::string(1 << 20, 'b'), 5), kValue);
  EXPECT_EQ(name(*context, 4004, "blue", 5), kOperation);
  EXPECT_EQ(name(*context, 101, "blue", 5), kOperation);
  (void)named(*context, 103, "red");
  EXPECT_EQ(error(*context), kValue);
  (void)named(*context, 101, "red");
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_EQ(errorInsideBegin(*context,
                             [&] {
                               handlers::ProgramNamedParameter4fNV(
                                   *context, 103, 4, reinterpret_cast<const GLubyte *>("blue"), 1,
                                   1, 1, 1);
                             }),
            kOperation);
}

TEST(NvNamed, ADrawHasTheValue) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 103, kFp);
  handlers::BindProgramNV(*context, kNvFragment, 103);
  handlers::Enable(*context, kNvFragment);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.uniforms[10], (std::vector<GLfloat>{1, 2, 3, 4}));
  name(*context, 103, "blue", 5);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.uniforms[10], (std::vector<GLfloat>{5, 6, 7, 8}));
}

TEST(NvNamed, HaveNoNumber) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 103, kFp);
  handlers::BindProgramNV(*context, kNvFragment, 103);
  GLint count = 0;
  handlers::GetIntegerv(*context, GL_MAX_FRAGMENT_PROGRAM_LOCAL_PARAMETERS_NV, &count);
  EXPECT_EQ(GLuint(count), context->row(Target::Fragment).limits.localParameters);
  handlers::ProgramLocalParameter4fARB(*context, kNvFragment, GLuint(count) - 1, 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kNoError);
  handlers::ProgramLocalParameter4fARB(*context, kNvFragment, GLuint(count), 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kValue);
  Vec4 value{};
  handlers::GetProgramLocalParameterfvARB(*context, kNvFragment, GLuint(count), value.data());
  EXPECT_EQ(error(*context), kValue);
}

} // namespace
} // namespace arbiter::state
