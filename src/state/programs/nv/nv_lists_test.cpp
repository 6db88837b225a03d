// Checks NVIDIA's program commands in display lists: which are compiled, and that errors are raised
// when the list is called (NV_vertex_program 5.4, NV_fragment_program 5.4).
#include <gtest/gtest.h>

#include "state/lists/list_compiler.h"
#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

class NvLists : public ::testing::Test {
protected:
  void SetUp() override {
    loadNv(*m_context, kNvState, 102, kVsp);
    loadNv(*m_context, kNvFragment, 103, kFp);
    ASSERT_EQ(error(*m_context), kNoError) << m_context->errors.text;
  }
  template <typename Function> void compile(GLuint list, Function &&commands) {
    handlers::NewList(*m_context, list, GL_COMPILE);
    commands();
    handlers::EndList(*m_context);
  }
  GLenum call(GLuint list) {
    handlers::CallList(*m_context, list);
    return error(*m_context);
  }

  NvHost m_host;
  CurrentContext m_context{m_host};
};

TEST_F(NvLists, HoldWhatTheSpecificationSays) {
  const GLfloat input[] = {0.25f, 0, 0, 0};
  const GLuint names[] = {102, 4000};
  compile(1, [&] {
    loadNv(*m_context, kNvVertex, 120, kVp);
    handlers::TrackMatrixNV(*m_context, kNvVertex, 12, GL_MODELVIEW, GL_INVERSE_NV);
    handlers::ProgramParameter4fNV(*m_context, kNvVertex, 70, 4, 3, 2, 1);
    handlers::ExecuteProgramNV(*m_context, kNvState, 102, input);
    handlers::ProgramNamedParameter4fNV(*m_context, 103, 4,
                                        reinterpret_cast<const GLubyte *>("blue"), 8, 8, 8, 8);
    handlers::BindProgramNV(*m_context, kNvVertex, 120);
    handlers::RequestResidentProgramsNV(*m_context, 2, names);
  });
  EXPECT_EQ(error(*m_context), kNoError);
  const auto blue = [&] {
    Vec4 value{};
    handlers::GetProgramNamedParameterfvNV(*m_context, 103, 4,
                                           reinterpret_cast<const GLubyte *>("blue"), value.data());
    return value[0];
  };
  const auto tracked = [&] {
    GLint matrix = -1;
    handlers::GetTrackMatrixivNV(*m_context, kNvVertex, 12, GL_TRACK_MATRIX_NV, &matrix);
    return matrix;
  };
  EXPECT_FALSE(handlers::IsProgramARB(*m_context, 120));
  EXPECT_EQ(tracked(), GL_NONE);
  EXPECT_EQ(parameter(*m_context, 70), Vec4{});
  EXPECT_EQ(parameter(*m_context, 90), Vec4{});
  EXPECT_EQ(blue(), 1.0f);
  EXPECT_EQ(m_context->row(Target::Vertex).bound->name, 0u);

  EXPECT_EQ(call(1), kNoError);
  EXPECT_TRUE(handlers::IsProgramARB(*m_context, 120));
  EXPECT_EQ(tracked(), GL_MODELVIEW);
  EXPECT_EQ(parameter(*m_context, 70), (Vec4{4, 3, 2, 1}));
  EXPECT_EQ(parameter(*m_context, 90), (Vec4{0.25f, 0, 0, 0}));
  EXPECT_EQ(blue(), 8.0f);
  EXPECT_EQ(m_context->row(Target::Vertex).bound->name, 120u);
}

TEST_F(NvLists, DoNotHoldTheOthers) {
  GLuint name = 0;
  GLboolean resident = GL_FALSE;
  compile(2, [&] {
    handlers::GenProgramsARB(*m_context, 1, &name);
    EXPECT_TRUE(handlers::IsProgramARB(*m_context, 103));
    const GLuint known = 103;
    EXPECT_TRUE(handlers::AreProgramsResidentNV(*m_context, 1, &known, &resident));
    GLint length = 0;
    handlers::GetProgramivNV(*m_context, 103, GL_PROGRAM_LENGTH_NV, &length);
    EXPECT_EQ(length, GLint(kFp.size()));
    const GLuint gone = 102;
    handlers::DeleteProgramsARB(*m_context, 1, &gone);
    EXPECT_FALSE(handlers::IsProgramARB(*m_context, 102));
    handlers::VertexAttribPointerNV(*m_context, 1, 4, GL_FLOAT, 0, nullptr);
    EXPECT_EQ(m_host.count("VertexAttribPointer"), 1);
  });
  EXPECT_NE(name, 0u);
  loadNv(*m_context, kNvState, 102, kVsp);
  EXPECT_EQ(call(2), kNoError);
  EXPECT_TRUE(handlers::IsProgramARB(*m_context, 102)) << "the list deletes nothing";
}

TEST_F(NvLists, RaiseErrorsWhenTheyAreCalled) {
  struct Case {
    GLenum error;
    void (*command)(Context &);
  };
  const Case cases[] = {
      {kOperation, [](Context &c) { loadNv(c, kNvVertex, 120, "!!VP1.0\nBAD;\nEND"); }},
      {kValue, [](Context &c) { loadNv(c, kNvVertex, 0, kVp); }},
      {kOperation, [](Context &c) { handlers::BindProgramNV(c, kNvVertex, 103); }},
      {kEnum, [](Context &c) { handlers::BindProgramNV(c, kNvState, 102); }},
      {kValue, [](Context &c) { handlers::ProgramParameter4fNV(c, kNvVertex, 256, 1, 1, 1, 1); }},
      {kValue, [](Context &c) { handlers::ProgramParameters4fvNV(c, kNvVertex, 0, -1, nullptr); }},
      {kValue,
       [](Context &c) { handlers::TrackMatrixNV(c, kNvVertex, 1, GL_MODELVIEW, GL_IDENTITY_NV); }},
      {kOperation, [](Context &c) { handlers::ExecuteProgramNV(c, kNvState, 103, nullptr); }},
      {kValue, [](Context &c) { handlers::RequestResidentProgramsNV(c, -1, nullptr); }},
      {kValue,
       [](Context &c) {
         handlers::ProgramNamedParameter4fNV(c, 103, 3, reinterpret_cast<const GLubyte *>("red"), 1,
                                             1, 1, 1);
       }},
  };
  GLuint list = 10;
  for (const Case &c : cases) {
    compile(++list, [&] { c.command(*m_context); });
    EXPECT_EQ(error(*m_context), kNoError) << list;
    EXPECT_EQ(call(list), c.error) << list;
  }
}

TEST_F(NvLists, CompileAndExecuteDoesBoth) {
  handlers::NewList(*m_context, 3, GL_COMPILE_AND_EXECUTE);
  handlers::ProgramParameter4fNV(*m_context, kNvVertex, 70, 4, 3, 2, 1);
  handlers::EndList(*m_context);
  EXPECT_EQ(parameter(*m_context, 70), (Vec4{4, 3, 2, 1}));
  handlers::ProgramParameter4fNV(*m_context, kNvVertex, 70, 0, 0, 0, 0);
  EXPECT_EQ(call(3), kNoError);
  EXPECT_EQ(parameter(*m_context, 70), (Vec4{4, 3, 2, 1}));
}

} // namespace
} // namespace arbiter::state
