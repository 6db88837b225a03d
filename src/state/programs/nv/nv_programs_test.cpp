// Checks NV_vertex_program's commands for program objects: their answers, and every error of the
// specifications (NV_vertex_program and NV_fragment_program, Errors).
#include <string>

#include <gtest/gtest.h>

#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

GLint integer(Context &context, GLenum pname) {
  GLint value = -99;
  handlers::GetIntegerv(context, pname, &value);
  return value;
}

GLint query(Context &context, GLuint id, GLenum pname) {
  GLint value = -99;
  handlers::GetProgramivNV(context, id, pname, &value);
  return value;
}

TEST(NvLoad, EachTargetTakesItsLanguagesAndTheArbs) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvState, 102, kVsp);
  loadNv(*context, kNvFragment, 103, kFp);
  loadNv(*context, kNvVertex, 104, "!!VP2.0\nMOV o[HPOS], c[200];\nEND");
  loadNv(*context, kNvVertex, 105,
         "!!VP1.1\nOPTION NV_position_invariant;\nMOV o[COL0], c[0];\nEND");
  loadNv(*context, kNvVertex, 107, "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND");
  loadNv(*context, kNvFragment, 108, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND");
  EXPECT_EQ(error(*context), kNoError) << context->errors.text;
  EXPECT_EQ(context->errors.position, -1);
  EXPECT_EQ(query(*context, 101, GL_PROGRAM_TARGET_NV), GLint(kNvVertex));
  EXPECT_EQ(query(*context, 102, GL_PROGRAM_TARGET_NV), GLint(kNvState));
  EXPECT_EQ(query(*context, 103, GL_PROGRAM_TARGET_NV), GLint(kNvFragment));
  EXPECT_EQ(query(*context, 108, GL_PROGRAM_TARGET_NV), GLint(kFragment));
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvLoad, Errors) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 0, kVp);
  EXPECT_EQ(error(*context), kValue);
  loadNv(*context, 0x1234, 105, kVp);
  EXPECT_EQ(error(*context), kEnum);
  loadNv(*context, kFragment, 106, "!!ARBfp1.0\nMOV result.color, 1.0;\nEND");
  EXPECT_EQ(error(*context), kEnum) << "the ARB's target is none of the command's";
  handlers::LoadProgramNV(*context, kNvVertex, 105, -1,
                          reinterpret_cast<const GLubyte *>(kVp.data()));
  EXPECT_EQ(error(*context), kValue);
  loadNv(*context, kNvVertex, 105, "!!VP1.0\nBAD;\nEND");
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_EQ(integer(*context, GL_PROGRAM_ERROR_POSITION_NV), 8);
  EXPECT_FALSE(handlers::IsProgramARB(*context, 105));
  EXPECT_EQ(errorInsideBegin(*context, [&] { loadNv(*context, kNvVertex, 130, kVp); }), kOperation);
}

TEST(NvLoad, ATextOfAnotherTargetFails) {
  NvHost host;
  const CurrentContext context(host);
  const std::pair<GLenum, std::string_view> wrong[] = {
      {kNvVertex, kFp},
      {kNvVertex, kVsp},
      {kNvFragment, kVp},
      {kNvFragment, kVsp},
      {kNvState, kVp},
      {kNvState, kFp},
      {kNvState, "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND"}};
  for (const auto &[target, text] : wrong) {
    loadNv(*context, target, 108, text);
    EXPECT_EQ(error(*context), kOperation) << target << text;
    EXPECT_GE(context->errors.position, 0);
    EXPECT_FALSE(handlers::IsProgramARB(*context, 108));
  }
}

TEST(NvLoad, AProgramKeepsItsTarget) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvFragment, 101, kFp);
  EXPECT_EQ(error(*context), kOperation);
  loadNv(*context, kNvState, 101, kVsp);
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_EQ(query(*context, 101, GL_PROGRAM_TARGET_NV), GLint(kNvVertex));
  // A name has no target if no load has succeeded for it.
  loadNv(*context, kNvVertex, 109, "!!VP1.0\nBAD;\nEND");
  EXPECT_EQ(error(*context), kOperation);
  loadNv(*context, kNvFragment, 109, kFp);
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvLoad, AFailedOneKeepsTheProgram) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 140, kFp);
  loadNv(*context, kNvFragment, 140, "!!FP1.0\nBAD;\nEND");
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_EQ(query(*context, 140, GL_PROGRAM_LENGTH_NV), GLint(kFp.size()));
  std::string text(kFp.size(), '?');
  handlers::GetProgramStringNV(*context, 140, GL_PROGRAM_STRING_NV,
                               reinterpret_cast<GLubyte *>(text.data()));
  EXPECT_EQ(text, kFp);
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvBind, Errors) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvState, 102, kVsp);
  loadNv(*context, kNvFragment, 103, kFp);
  const auto bind = [&](GLenum target, GLuint id) {
    handlers::BindProgramNV(*context, target, id);
    return error(*context);
  };
  EXPECT_EQ(bind(kNvVertex, 101), kNoError);
  EXPECT_EQ(bind(kNvVertex, 102), kOperation);
  EXPECT_EQ(bind(kNvVertex, 103), kOperation);
  EXPECT_EQ(bind(kNvState, 102), kEnum) << "state programs are executed, not bound";
  EXPECT_EQ(bind(kNvFragment, 103), kNoError);
  EXPECT_EQ(bind(kNvFragment, 101), kOperation);
  EXPECT_EQ(bind(0x1234, 101), kEnum);
  EXPECT_EQ(bind(kFragment, 103), kEnum) << "the ARB's target is none of the command's";
  EXPECT_EQ(integer(*context, GL_VERTEX_PROGRAM_BINDING_NV), 101);
  EXPECT_EQ(integer(*context, GL_FRAGMENT_PROGRAM_BINDING_NV), 103);
  EXPECT_EQ(errorInsideBegin(*context, [&] { handlers::BindProgramNV(*context, kNvVertex, 0); }),
            kOperation);
}

TEST(NvBind, ANameThatWasNeverLoadedStaysFree) {
  NvHost host;
  const CurrentContext context(host);
  handlers::BindProgramNV(*context, kNvVertex, 4000);
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_FALSE(handlers::IsProgramARB(*context, 4000));
  EXPECT_EQ(query(*context, 4000, GL_PROGRAM_TARGET_NV), -99);
  EXPECT_EQ(error(*context), kOperation);
  loadNv(*context, kNvFragment, 4000, kFp);
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_EQ(query(*context, 4000, GL_PROGRAM_TARGET_NV), GLint(kNvFragment));
  // BindProgramARB creates an object at once for any kind of name.
  handlers::BindProgramNV(*context, kNvVertex, 4001);
  handlers::BindProgramARB(*context, kVertex, 4001);
  EXPECT_TRUE(handlers::IsProgramARB(*context, 4001));
  loadNv(*context, kNvFragment, 4001, kFp);
  EXPECT_EQ(error(*context), kOperation);
}

TEST(NvBind, ALoadForTheBoundNameIsTheBoundProgram) {
  NvHost host;
  const CurrentContext context(host);
  handlers::BindProgramNV(*context, kNvVertex, 7);
  handlers::Enable(*context, kNvVertex);
  EXPECT_FALSE(draw(*context));
  EXPECT_EQ(error(*context), kOperation) << "there is no program yet";
  loadNv(*context, kNvVertex, 7, kVp);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvBind, TheFragmentTargetIsTheArbs) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 103, kFp);
  handlers::BindProgramARB(*context, kFragment, 103);
  EXPECT_EQ(integer(*context, GL_FRAGMENT_PROGRAM_BINDING_NV), 103);
  handlers::Enable(*context, kNvFragment);
  EXPECT_TRUE(handlers::IsEnabled(*context, kFragment));
  EXPECT_TRUE(draw(*context));
  handlers::Disable(*context, kFragment);
  EXPECT_FALSE(handlers::IsEnabled(*context, kNvFragment));
  handlers::PushAttrib(*context, GL_ENABLE_BIT);
  handlers::Enable(*context, kNvFragment);
  handlers::PopAttrib(*context);
  EXPECT_FALSE(handlers::IsEnabled(*context, kNvFragment));
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvDraw, WithoutAProgramIsAnError) {
  NvHost host;
  const CurrentContext context(host);
  for (const GLenum target : {kNvVertex, kNvFragment}) {
    handlers::Enable(*context, target);
    EXPECT_FALSE(draw(*context));
    EXPECT_EQ(error(*context), kOperation);
    handlers::Disable(*context, target);
    EXPECT_TRUE(draw(*context));
  }
}

TEST(NvNames, AreTheArbs) {
  NvHost host;
  const CurrentContext context(host);
  GLuint name = 0;
  handlers::GenProgramsARB(*context, 1, &name);
  EXPECT_FALSE(handlers::IsProgramARB(*context, name));
  loadNv(*context, kNvVertex, name, kVp);
  EXPECT_TRUE(handlers::IsProgramARB(*context, name));
  handlers::BindProgramNV(*context, kNvVertex, name);
  const GLuint names[] = {name, 0, 4006};
  handlers::DeleteProgramsARB(*context, 3, names);
  EXPECT_EQ(integer(*context, GL_VERTEX_PROGRAM_BINDING_NV), 0);
  EXPECT_FALSE(handlers::IsProgramARB(*context, name));
  EXPECT_EQ(error(*context), kNoError);
}

TEST(NvNames, AreSharedWithOtherContexts) {
  NvHost host;
  const CurrentContext first(host);
  loadNv(*first, kNvVertex, 11, kVp);
  const CurrentContext second(host, &*first);
  EXPECT_TRUE(handlers::IsProgramARB(*second, 11));
  loadNv(*second, kNvFragment, 11, kFp);
  EXPECT_EQ(error(*second), kOperation);
}

TEST(NvResidence, EveryProgramIsResident) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvState, 102, kVsp);
  const GLuint names[] = {101, 102}, unknown[] = {101, 4005}, zero[] = {0};
  GLboolean residences[] = {7, 7};
  EXPECT_TRUE(handlers::AreProgramsResidentNV(*context, 2, names, residences));
  EXPECT_EQ(residences[0], 7) << "not changed where all are";
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_FALSE(handlers::AreProgramsResidentNV(*context, 2, unknown, residences));
  EXPECT_EQ(error(*context), kValue);
  EXPECT_FALSE(handlers::AreProgramsResidentNV(*context, 1, zero, residences));
  EXPECT_EQ(error(*context), kValue);
  EXPECT_FALSE(handlers::AreProgramsResidentNV(*context, -1, names, residences));
  EXPECT_EQ(error(*context), kValue);
  handlers::RequestResidentProgramsNV(*context, 2, unknown);
  EXPECT_EQ(error(*context), kNoError);
  handlers::RequestResidentProgramsNV(*context, -1, names);
  EXPECT_EQ(error(*context), kValue);
  EXPECT_EQ(query(*context, 101, GL_PROGRAM_RESIDENT_NV), GL_TRUE);
}

TEST(NvQueries, Errors) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  EXPECT_EQ(query(*context, 101, GL_PROGRAM_LENGTH_NV), GLint(kVp.size()));
  EXPECT_EQ(error(*context), kNoError);
  query(*context, 4002, GL_PROGRAM_TARGET_NV);
  EXPECT_EQ(error(*context), kOperation);
  query(*context, 101, 0x1234);
  EXPECT_EQ(error(*context), kEnum);
  GLubyte text[64];
  handlers::GetProgramStringNV(*context, 4003, GL_PROGRAM_STRING_NV, text);
  EXPECT_EQ(error(*context), kOperation);
  handlers::GetProgramStringNV(*context, 101, 0x1234, text);
  EXPECT_EQ(error(*context), kEnum);
}

TEST(NvExecute, WritesTheParameters) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvState, 102, kVsp);
  const GLfloat input[] = {1, 2, 3, 4};
  handlers::ExecuteProgramNV(*context, kNvState, 102, input);
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_EQ(parameter(*context, 90), (Vec4{1, 2, 3, 4}));
  Vec4 env{};
  handlers::GetProgramEnvParameterfvARB(*context, kVertex, 90, env.data());
  EXPECT_EQ(env, (Vec4{1, 2, 3, 4}));
}

TEST(NvExecute, AnInstructionReadsWhatOneBeforeItWrote) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(
      *context, kNvState, 102,
      "!!VSP1.0\nMOV c[90].x, v[0];\nADD c[90].x, c[90], v[0];\nMUL c[91], c[90], v[0].wwww;\nEND");
  EXPECT_EQ(error(*context), kNoError) << context->errors.text;
  handlers::ProgramParameter4fNV(*context, kNvVertex, 90, 7, 7, 7, 7);
  const GLfloat input[] = {1, 2, 3, 4};
  handlers::ExecuteProgramNV(*context, kNvState, 102, input);
  EXPECT_EQ(parameter(*context, 90), (Vec4{2, 7, 7, 7})) << "what the mask leaves out stays";
  EXPECT_EQ(parameter(*context, 91), (Vec4{8, 28, 28, 28}));
}

TEST(NvExecute, Errors) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 101, kVp);
  loadNv(*context, kNvState, 102, kVsp);
  const GLfloat input[] = {1, 2, 3, 4};
  const auto execute = [&](GLenum target, GLuint id) {
    handlers::ExecuteProgramNV(*context, target, id, input);
    return error(*context);
  };
  EXPECT_EQ(execute(kNvVertex, 102), kEnum);
  EXPECT_EQ(execute(kNvState, 101), kOperation);
  EXPECT_EQ(execute(kNvState, 4001), kOperation);
  EXPECT_EQ(errorInsideBegin(*context,
                             [&] { handlers::ExecuteProgramNV(*context, kNvState, 102, input); }),
            kOperation);
  handlers::TrackMatrixNV(*context, kNvVertex, 88, GL_MODELVIEW, GL_IDENTITY_NV);
  EXPECT_EQ(execute(kNvState, 102), kOperation) << "c[90] follows a matrix";
  handlers::TrackMatrixNV(*context, kNvVertex, 88, GL_NONE, GL_IDENTITY_NV);
  EXPECT_EQ(execute(kNvState, 102), kNoError);
}

TEST(NvAbsent, BindProgramIsTheArbsByAnotherName) {
  FakeHost host;
  const CurrentContext context(host);
  ASSERT_FALSE(context->nv);
  handlers::BindProgramNV(*context, kFragment, 7);
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_EQ(context->row(Target::Fragment).bound->name, 7u);
}

} // namespace
} // namespace arbiter::state
