#include "state/host_draw/draw.h"

#include <cstdlib>
#include <new>

#include <gtest/gtest.h>

#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"
#include "state/programs/program_bind.h"
#include "state/testing/current_context.h"

namespace {
std::size_t g_allocations = 0;
} // namespace

// Not inlined: if only one of new and delete is inlined, the compiler reports a mismatched pair.
[[gnu::noinline]] void *operator new(std::size_t size) {
  ++g_allocations;
  if (void *memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kThree[] = "!!ARBfp1.0\n"
                          "ADD result.color, program.env[0], program.env[1];\n"
                          "MUL result.color, program.env[5], program.local[2];\n"
                          "END";
/// All four values reach the result, so that none is optimized away.
constexpr char kFour[] = "!!ARBfp1.0\nTEMP t;\n"
                         "ADD t, program.env[0], program.env[1];\n"
                         "ADD t, t, program.env[5];\n"
                         "MUL result.color, t, program.local[2];\n"
                         "END";

TEST(Draw, ACleanDrawCallsNobodyAndAllocatesNothing) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kThree);
  ASSERT_TRUE(draw(*context));
  host.calls.clear();
  g_allocations = 0;
  for (int i = 0; i < 100; ++i)
    ASSERT_TRUE(draw(*context));
  EXPECT_EQ(g_allocations, 0u);
  EXPECT_TRUE(host.calls.empty()) << host.calls.front();
  EXPECT_EQ(context->attention, 0u);
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 101u);
}

TEST(Draw, ChangedParametersGoInRuns) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Uniform4fv"), 0) << "zero is what the host's uniforms begin with";
  host.calls.clear();
  for (GLuint i = 0; i < 8; ++i)
    handlers::ProgramEnvParameter4fARB(*context, kFragment, i, 1, 2, 3, GLfloat(i));
  g_allocations = 0;
  ASSERT_TRUE(draw(*context));
  EXPECT_LE(g_allocations, 8u) << "more than the fake keeps of one call";
  EXPECT_EQ(host.count("Uniform4fv"), 1) << "three neighbours are one run";
  host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 9, 9, 9, 9);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 1, 1, 2, 3, 1); // unchanged
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 7, 9, 9, 9, 9); // not read
  handlers::ProgramLocalParameter4fARB(*context, kFragment, 2, 5, 5, 5, 5);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Uniform4fv"), 2) << "two values apart are two runs";
  host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 9, 9, 9, 9);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.calls.empty()) << "the same value was sent again";
}

TEST(Draw, AParameterAloneIsSentAndNothingElseIsLookedAt) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  const std::uint64_t selections = context->effective.selections;
  for (int i = 1; i < 4; ++i) {
    handlers::ProgramEnvParameter4fARB(*context, kFragment, 5, GLfloat(i), 0, 0, 0);
    EXPECT_EQ(context->attention, attention::kFragmentParameters);
    host.calls.clear();
    ASSERT_TRUE(draw(*context));
    ASSERT_EQ(host.calls.size(), 1u) << host.calls.front();
    EXPECT_EQ(host.count("Uniform4fv"), 1);
    EXPECT_EQ(context->attention, 0u);
  }
  EXPECT_EQ(context->effective.selections, selections);
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 4u);
}

TEST(Draw, ALocalParameterOfVerticesIsTheHostsAtOnce) {
  constexpr char kMoved[] = "!!ARBvp1.0\nADD result.position, vertex.position, program.local[1];\n"
                            "MOV result.color, program.local[3];\nEND\n";
  const std::string call = "ProgramLocalParameter4fv " + std::to_string(kVertex);
  FakeHost host;
  const CurrentContext context(host);
  const auto local = [&](GLuint index, GLfloat x) {
    handlers::ProgramLocalParameter4fARB(*context, kVertex, index, x, 0, 0, 0);
  };
  const GLuint first = use(*context, kMoved, kVertex);
  ASSERT_TRUE(draw(*context));
  host.calls.clear();
  for (int i = 1; i < 4; ++i) {
    local(1, GLfloat(i));
    local(1, GLfloat(i)); // unchanged
    local(2, GLfloat(i)); // not read
    EXPECT_EQ(context->attention, 0u);
    EXPECT_EQ(host.calls, std::vector<std::string>{call + " 1 " + std::to_string(i)});
    ASSERT_TRUE(draw(*context));
    EXPECT_EQ(host.calls.size(), 1u);
    host.calls.clear();
  }
  local(1, 7);
  local(3, 8);
  EXPECT_EQ(host.calls.size(), 1u) << "more of one draw wait for it";
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count(call), 2);
  const GLuint second = use(*context, kMoved, kVertex);
  host.calls.clear();
  local(1, 7);
  EXPECT_TRUE(host.calls.empty()) << "it is not the host's yet";
  ASSERT_TRUE(validatePrograms(*context));
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count(call + " 1 7"), 1);
  local(1, 9);
  EXPECT_EQ(context->attention, 0u) << "though pixels chose it, not a draw";
  EXPECT_EQ(host.count(call + " 1 9"), 1);
  ASSERT_TRUE(draw(*context));
  handlers::BindProgramARB(*context, kVertex, first);
  handlers::DeleteProgramsARB(*context, 1, &second);
  ASSERT_TRUE(draw(*context));
  Context *const other = createContext(Provider::Egl, host.table(), &*context);
  local(1, 10);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->attention, attention::kShared) << "it hides no context that has joined";
  EXPECT_EQ(host.count(call + " 1 10"), 1);
  destroyContext(other);
}

TEST(Draw, AParameterIsNotSentBetweenBeginAndEnd) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 5, 1, 0, 0, 0);
  context->insideBeginEnd = true;
  host.calls.clear();
  EXPECT_TRUE(draw(*context)) << "the host's error to raise";
  EXPECT_TRUE(host.calls.empty()) << host.calls.front();
  context->insideBeginEnd = false;
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Uniform4fv"), 1) << "it waited";
}

TEST(Draw, AParameterHidesNoContextThatHasJoinedTheGroup) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  Context *const second = createContext(Provider::Egl, host.table(), &*context);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 5, 1, 0, 0, 0);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Uniform4fv"), 1);
  EXPECT_EQ(context->attention, attention::kShared) << "from now on each draw looks";
  destroyContext(second);
}

TEST(Draw, TheHostProgramIsHidden) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kThree);
  ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(context->hostProgramIsOurs);
  const GLuint linked = host.currentProgram;
  ASSERT_NE(linked, 0u);
  GLint current = -1;
  handlers::GetIntegerv(*context, GL_CURRENT_PROGRAM, &current);
  EXPECT_EQ(current, 0);
  EXPECT_NE(handlers::guardName(*context, linked), linked);
  EXPECT_EQ(handlers::guardName(*context, linked + 100), linked + 100);
  handlers::restoreApplicationProgram(*context);
  EXPECT_EQ(host.currentProgram, 0u);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.currentProgram, linked);
  EXPECT_EQ(host.count("LinkProgram"), 1) << "it was built again";
}

TEST(Draw, AProgramThatIsCurrentIsNotMadeSoAgain) {
  FakeHost host;
  const CurrentContext context(host);
  const GLuint first = use(*context, kThree);
  ASSERT_TRUE(draw(*context));
  handlers::Disable(*context, kFragment); // a program may do this after each of its draws
  handlers::Enable(*context, kFragment);
  host.calls.clear();
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("UseProgram"), 0);
  const GLuint linked = host.currentProgram;
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  EXPECT_NE(host.currentProgram, linked);
  handlers::BindProgramARB(*context, kFragment, first);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.currentProgram, linked);
  // Fixed function draws in between.
  handlers::Disable(*context, kFragment);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.currentProgram, 0u);
  handlers::Enable(*context, kFragment);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.currentProgram, linked);
}

TEST(Draw, WhatAHostsListMadeCurrentIsMadeSoNoLonger) {
  FakeHost host;
  const CurrentContext context(host);
  const GLuint first = use(*context, kThree);
  ASSERT_TRUE(draw(*context));
  const GLuint linked = host.currentProgram;
  use(*context, kFour);
  ASSERT_TRUE(draw(*context));
  const GLuint other = host.currentProgram;
  handlers::BindProgramARB(*context, kFragment, first);
  ASSERT_TRUE(draw(*context));
  context->group->hostListsChangeProgram = true;
  host.currentProgram = other; // the list made it current when it was executed
  host.integers[GL_CURRENT_PROGRAM] = GLint(other);
  afterHostList(*context);
  invalidateProgram(*context);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.currentProgram, linked);
}

TEST(Draw, AUseProgramThatFailsLeavesTheApplicationsProgram) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kThree);
  ASSERT_TRUE(draw(*context));
  handlers::UseProgram(*context, 4711); // the host has no such program
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_VALUE));
  GLint current = -1;
  handlers::GetIntegerv(*context, GL_CURRENT_PROGRAM, &current);
  EXPECT_EQ(current, 0);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.path, Path::HostGlsl);
}

TEST(Draw, PathsAreCountedWithTheirReason) {
  FakeHost host;
  const CurrentContext context(host);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::NoProgram), 1u);
  handlers::Enable(*context, kFragment);
  EXPECT_FALSE(draw(*context)) << "object 0 holds no program";
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(drawsBy(*context, Path::InvalidProgram), 1u);
  host.programs.insert(50);
  handlers::UseProgram(*context, 50);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::ApplicationGlsl), 1u);
  handlers::UseProgram(*context, 0);
  EXPECT_FALSE(draw(*context));
  EXPECT_EQ(host.count("Enable"), 0) << "the host has a fragment program target of its own";
}

TEST(Draw, AContextOfTheGroupSeesAReloadWhenItIsMadeCurrent) {
  FakeHost host;
  const CurrentContext first(host);
  const GLuint name = use(*first, kThree);
  ASSERT_TRUE(draw(*first));
  {
    const CurrentContext second(host, &*first);
    handlers::BindProgramARB(*second, kFragment, name);
    load(*second, kFour);
    makeCurrent(&*first);
    ASSERT_TRUE(draw(*first));
    EXPECT_EQ(first->effective.linkedProgram->fragment.compiled->text, kFour)
        << "it selects programs anew";
    handlers::BindProgramARB(*first, kFragment, name);
    ASSERT_TRUE(draw(*first));
    EXPECT_EQ(first->effective.linkedProgram->fragment.compiled->text, kFour);
    makeCurrent(&*second);
    load(*second, kThree);
    makeCurrent(&*first);
    ASSERT_TRUE(draw(*first));
    EXPECT_EQ(first->effective.linkedProgram->fragment.compiled->text, kThree)
        << "with two contexts each draw looks";
    makeCurrent(&*second);
  }
  makeCurrent(&*first);
}

TEST(Draw, HostProgramsOfADeadContextAreDeletedByTheGroup) {
  FakeHost host;
  const CurrentContext first(host);
  const GLuint name = use(*first, kThree);
  GLuint left = 0;
  {
    const CurrentContext second(host, &*first);
    handlers::BindProgramARB(*second, kFragment, name);
    handlers::Enable(*second, kFragment);
    ASSERT_TRUE(draw(*second));
    left = host.currentProgram;
  }
  EXPECT_EQ(host.programs.count(left), 1u) << "deleted with no context current";
  makeCurrent(&*first);
  EXPECT_EQ(host.programs.count(left), 0u);
  EXPECT_EQ(handlers::guardName(*first, left), left) << "the name is free again";
}

TEST(Draw, VariantsDoNotPileUp) {
  FakeHost host;
  const CurrentContext context(host);
  for (int i = 0; i < 500; ++i) {
    const GLuint name =
        use(*context, "!!ARBfp1.0\n#" + std::to_string(i) + "\nMOV result.color, 1;\nEND");
    ASSERT_TRUE(draw(*context));
    if (i % 2)
      load(*context, kThree); // replaces the text
    else
      handlers::DeleteProgramsARB(*context, 1, &name);
  }
  EXPECT_LE(context->hostSide.linkedPrograms->size(), 2u);
  EXPECT_LE(host.programs.size(), 2u);
  EXPECT_LE(host.shaders.size(), 2u) << "a shader goes with its program";
}

constexpr char kArrayText[] = "!!ARBvp1.0\n"
                              "ADD result.position, vertex.position, program.env[0];\n"
                              "ADD result.color, vertex.attrib[3], program.local[1];\n"
                              "END";

TEST(Draw, ShadersAreCompiledOnceAndLinkedAPair) {
  FakeHost host;
  host.offerNoAssembly();
  const CurrentContext context(host);
  const GLuint fragments[] = {use(*context, kThree), use(*context, kFour)};
  const GLuint vertices[] = {use(*context, kArrayText, kVertex),
                             use(*context, std::string(kArrayText) + " ", kVertex)};
  for (int round = 0; round < 2; ++round)
    for (const GLuint fragment : fragments)
      for (const GLuint vertex : vertices) {
        handlers::BindProgramARB(*context, kFragment, fragment);
        handlers::BindProgramARB(*context, kVertex, vertex);
        ASSERT_TRUE(draw(*context));
      }
  EXPECT_EQ(host.count("CreateShader"), 4);
  EXPECT_EQ(host.count("LinkProgram"), 4);
  EXPECT_EQ(host.count("BindAttribLocation 3"), 4) << "before each link";
  handlers::Disable(*context, kFragment);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.count("CreateShader"), 4) << "alone it is the same shader";
  EXPECT_EQ(host.count("LinkProgram"), 5);
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 9u);
  handlers::DeleteProgramsARB(*context, 2, vertices);
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 0u);
  EXPECT_EQ(host.shaders.size(), 2u);
}

TEST(Draw, AStageIsSentWhatItsTargetChanged) {
  FakeHost host;
  host.offerNoAssembly();
  const CurrentContext context(host);
  use(*context, kFour);
  use(*context, kArrayText, kVertex);
  ASSERT_TRUE(draw(*context));
  host.calls.clear();
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 0, 1, 2, 3, 4);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(host.calls, (std::vector<std::string>{"Uniform4fv 500 1"}));
  host.calls.clear();
  handlers::ProgramLocalParameter4fARB(*context, kVertex, 1, 1, 2, 3, 4);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 2, 3, 4);
  g_allocations = 0;
  ASSERT_TRUE(draw(*context));
  EXPECT_LE(g_allocations, 12u) << "more than the fake keeps of two calls";
  EXPECT_EQ(host.calls, (std::vector<std::string>{"Uniform4fv 501 1", "Uniform4fv 10 1"}));
  host.calls.clear();
  for (int i = 0; i < 10; ++i)
    ASSERT_TRUE(draw(*context));
  EXPECT_TRUE(host.calls.empty()) << host.calls.front();
}

TEST(Draw, AnInvalidProgramOfEitherTargetStopsDraws) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kThree);
  handlers::Enable(*context, kVertex);
  EXPECT_FALSE(draw(*context)) << "object 0 holds no vertex program";
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_OPERATION));
  load(*context, kArrayText, kVertex); // now object 0 holds a program
  EXPECT_TRUE(draw(*context));
  handlers::BindProgramARB(*context, kFragment, 0);
  EXPECT_FALSE(draw(*context));
  handlers::Disable(*context, kFragment);
  EXPECT_TRUE(draw(*context));
}

TEST(Draw, OneStageOfTheApplicationsGlslLeavesTheOtherToUs) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kThree);
  use(*context, kArrayText, kVertex);
  handlers::ProgramEnvParameter4fARB(*context, kVertex, 0, 1, 2, 3, 4);
  host.programs = {50, 51, 52};
  host.stages = {{50, {GL_VERTEX_SHADER}},
                 {51, {GL_FRAGMENT_SHADER}},
                 {52, {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER}}};
  host.calls.clear();
  handlers::UseProgram(*context, 50);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Enable " + std::to_string(kFragment)), 1);
  EXPECT_EQ(host.count("Enable " + std::to_string(kVertex)), 0);
  handlers::UseProgram(*context, 51);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(host.count("Disable " + std::to_string(kFragment)), 1);
  EXPECT_EQ(host.count("Enable " + std::to_string(kVertex)), 1);
  EXPECT_EQ(drawsBy(*context, Path::HostAssembly), 2u);
  handlers::UseProgram(*context, 52);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::ApplicationGlsl), 1u);
  EXPECT_EQ(host.count("Disable " + std::to_string(kVertex)), 1);
  handlers::UseProgram(*context, 0);
  EXPECT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
}

} // namespace
} // namespace arbiter::state
