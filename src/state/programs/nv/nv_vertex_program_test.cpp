/// Checks NV_vertex_program and 1_1 on cards without fragment programs: the profile nv25.
#include <string>

#include <gtest/gtest.h>

#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

TEST(NvVertexProgram, TheCardTakesItsOwnLanguages) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 1, kVp);
  loadNv(*context, kNvVertex, 2,
         "!!VP1.1\nOPTION NV_position_invariant;\nMOV o[COL0], c[95];\nEND");
  loadNv(*context, kNvState, 3, kVsp);
  EXPECT_EQ(error(*context), kNoError) << context->errors.text;
  handlers::BindProgramNV(*context, kNvVertex, 1);
  handlers::Enable(*context, kNvVertex);
  handlers::ProgramParameter4fNV(*context, kNvVertex, 95, 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_EQ(parameter(*context, 95), (Vec4{1, 2, 3, 4}));
  handlers::ProgramParameter4fNV(*context, kNvVertex, 96, 1, 2, 3, 4);
  EXPECT_EQ(error(*context), kValue) << "c[96] is NV_vertex_program2's";
}

TEST(NvVertexProgram, LaterLanguagesAreRefusedAndTheirProfilesNamed) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvVertex, 1, "!!VP2.0\nMOV o[HPOS], v[OPOS];\nEND");
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_NE(context->errors.text.find("nv30 to nv40"), std::string::npos) << context->errors.text;
  loadNv(*context, kNvVertex, 1,
         "!!ARBvp1.0\nOPTION NV_vertex_program2;\nMOV result.position, vertex.position;\nEND");
  EXPECT_EQ(error(*context), kOperation);
  testing::load(*context, kFp, kFragment);
  EXPECT_EQ(error(*context), kOperation);
  EXPECT_NE(context->errors.text.find("nv30 to nv40"), std::string::npos) << context->errors.text;
}

// The enumerants belong to NV_fragment_program.
TEST(NvVertexProgram, NothingIsAFragmentProgramOfNvidias) {
  NvHost host;
  const CurrentContext context(host);
  loadNv(*context, kNvFragment, 1, kFp);
  EXPECT_EQ(error(*context), kEnum);
  handlers::BindProgramNV(*context, kNvFragment, 1);
  EXPECT_EQ(error(*context), kEnum);
  GLint value = -1;
  handlers::GetIntegerv(*context, GL_VERTEX_PROGRAM_BINDING_NV, &value);
  EXPECT_EQ(value, 0);
  const auto asked = host.queries;
  handlers::GetIntegerv(*context, GL_FRAGMENT_PROGRAM_BINDING_NV, &value);
  EXPECT_GT(host.queries, asked) << "the host is to answer, which does not know it";
}

TEST(NvVertexProgram, ItsNamesAreAnnouncedAndNoLaterOnes) {
  NvHost host;
  const CurrentContext context(host);
  const std::string names =
      reinterpret_cast<const char *>(handlers::GetString(*context, GL_EXTENSIONS));
  EXPECT_NE(names.find("GL_NV_vertex_program "), std::string::npos) << names;
  EXPECT_NE(names.find("GL_NV_vertex_program1_1 "), std::string::npos);
  EXPECT_EQ(names.find("GL_NV_vertex_program2"), std::string::npos);
  EXPECT_EQ(names.find("GL_NV_fragment_program"), std::string::npos);
}

} // namespace
} // namespace arbiter::state
