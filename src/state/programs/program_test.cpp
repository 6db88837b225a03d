// Checks program objects as the handlers keep them: names, binding, parameters, attribute stacks.
#include <gtest/gtest.h>

#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kEnvironmentText[] = "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND";

TEST(Programs, FragmentProgramsNeverReachTheHost) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kEnvironmentText);
  load(*context, "!!ARBfp1.0 junk");
  EXPECT_EQ(host.count("ProgramString"), 0);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(context->errors.position, 11);
}

TEST(Programs, GenSkipsNamesThatWereBoundWithoutIt) {
  FakeHost host;
  const CurrentContext context(host);
  const GLuint taken = 2;
  handlers::BindProgramARB(*context, kFragment, taken);
  GLuint names[3] = {};
  handlers::GenProgramsARB(*context, 3, names);
  for (const GLuint name : names)
    EXPECT_NE(name, taken);
}

TEST(Programs, TheSameTextKeepsWhatWasCompiled) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kEnvironmentText);
  const CompiledProgram *before = context->row(Target::Fragment).bound->compiled.get();
  load(*context, kEnvironmentText);
  EXPECT_EQ(context->row(Target::Fragment).bound->compiled.get(), before);
  load(*context, std::string(kEnvironmentText) + " ");
  EXPECT_NE(context->row(Target::Fragment).bound->compiled.get(), before);
}

TEST(Programs, NeitherTargetsTextReachesTheHost) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, "!!ARBvp1.0 # mine\nMOV result.position, vertex.position;\nEND", kVertex);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_NO_ERROR));
  ASSERT_TRUE(draw(*context));
  load(*context, "!!ARBvp1.0 junk", kVertex);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(context->errors.position, 11);
  ASSERT_EQ(host.assembly.size(), 1u);
  EXPECT_EQ(host.assembly.begin()->second,
            "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n")
      << "written anew from what was checked";
  EXPECT_EQ(host.count("ProgramString"), 1);
}

TEST(Programs, ANameBelongsToOneTarget) {
  FakeHost host;
  const CurrentContext context(host);
  handlers::BindProgramARB(*context, kVertex, 7);
  handlers::BindProgramARB(*context, kFragment, 7);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(context->row(Target::Fragment).bound->name, 0u);
  EXPECT_EQ(context->row(Target::Vertex).bound->name, 7u);
  handlers::BindProgramARB(*context, kFragment, 0);
  handlers::BindProgramARB(*context, kVertex, 0);
  EXPECT_NE(context->row(Target::Fragment).bound, context->row(Target::Vertex).bound)
      << "object 0 is one a target";
}

TEST(Programs, ATargetThatIsNotOfferedIsTheHosts) {
  FakeHost host;
  const CurrentContext context(host);
  load(*context, "!!ATIfs1.0", GL_TEXT_FRAGMENT_SHADER_ATI);
  EXPECT_EQ(host.count("ProgramString"), context->row(Target::AtiText).offered ? 0 : 1);
}

TEST(Programs, TheAttributeStackIsMirrored) {
  FakeHost host;
  const CurrentContext context(host);
  handlers::Enable(*context, kFragment);
  for (int i = 0; i < 16; ++i)
    handlers::PushAttrib(*context, GL_ENABLE_BIT);
  handlers::PushAttrib(*context, GL_ENABLE_BIT);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_STACK_OVERFLOW));
  EXPECT_EQ(context->attribStack.depth(), 16u) << "the host refused, and so must the layer";
  handlers::Disable(*context, kFragment);
  handlers::PopAttrib(*context);
  EXPECT_TRUE(handlers::IsEnabled(*context, kFragment));
}

TEST(Programs, ADestroyedContextStaysUsableWhileCurrent) {
  FakeHost host;
  Context *context = createContext(Provider::Glx, host.table(), nullptr);
  makeCurrent(context);
  destroyContext(context);
  use(*context, kEnvironmentText);
  EXPECT_TRUE(draw(*context));
  makeCurrent(nullptr); // frees the context
  EXPECT_EQ(currentContext(), nullptr);
}

TEST(Programs, TheNullContextPassesThrough) {
  EXPECT_EQ(currentContext(), nullptr);
  EXPECT_TRUE(nullContext().passThrough);
  EXPECT_NE(nullContext().drawCounter, nullptr);
}

} // namespace
} // namespace arbiter::state
