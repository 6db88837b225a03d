// Hosts that do not compile, do not link, or lack functions: the layer reports a clean error,
// counts it with its reason, and does not crash.
#include <cstring>

#include <gtest/gtest.h>

#include "state/capabilities/host_caps.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr char kText[] = "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND";

void expectRefused(FakeHost &host, Context &context) {
  const GLuint name = use(context, kText);
  EXPECT_EQ(handlers::GetError(context), GLenum(GL_NO_ERROR)) << "the load is not at fault";
  EXPECT_FALSE(draw(context));
  EXPECT_EQ(handlers::GetError(context), GLenum(GL_INVALID_OPERATION));
  EXPECT_EQ(handlers::GetError(context), GLenum(GL_NO_ERROR));
  EXPECT_FALSE(draw(context));
  EXPECT_EQ(drawsBy(context, Path::HostRefused), 2u);
  EXPECT_LE(host.count("LinkProgram"), 1) << "each draw tried again";
  EXPECT_TRUE(host.programs.empty()) << "objects were left behind";
  EXPECT_EQ(host.currentProgram, 0u);
  handlers::Disable(context, kFragment);
  EXPECT_TRUE(draw(context)) << "fixed function goes on";
  // A compiled shader is kept for other pairs, as long as its program exists.
  handlers::DeleteProgramsARB(context, 1, &name);
  EXPECT_TRUE(host.shaders.empty()) << "objects were left behind";
}

TEST(HostFaults, CompilingFails) {
  FakeHost host;
  host.compileFails = true;
  const CurrentContext context(host);
  expectRefused(host, *context);
}

TEST(HostFaults, LinkingFails) {
  FakeHost host;
  host.linkFails = true;
  const CurrentContext context(host);
  expectRefused(host, *context);
}

TEST(HostFaults, NoObjectsToBeHad) {
  FakeHost host;
  host.createFails = true;
  const CurrentContext context(host);
  expectRefused(host, *context);
}

TEST(HostFaults, AHostWithoutAnyFunction) {
  host::HostTable table;
  EXPECT_EQ(host::loadHostTable(table, [](const char *) -> void * { return nullptr; }), 0u);
  Context *context = createContext(Provider::Egl, &table, nullptr);
  makeCurrent(context);
  EXPECT_TRUE(context->passThrough) << "a context that says nothing of itself is let be";
  EXPECT_TRUE(draw(*context));
  makeCurrent(nullptr);
  destroyContext(context);
}

TEST(HostFaults, ContextsThatTheLayerDoesNotKnow) {
  for (const char *version : {"OpenGL ES 3.2 Fake", "", "junk"}) {
    FakeHost host;
    host.version = version;
    const CurrentContext context(host);
    EXPECT_TRUE(context->passThrough) << version;
  }
  FakeHost core;
  core.version = "4.5 (Core Profile) Fake";
  core.integers[GL_CONTEXT_PROFILE_MASK] = GL_CONTEXT_CORE_PROFILE_BIT;
  const CurrentContext context(core);
  EXPECT_TRUE(context->passThrough);
}

TEST(HostFaults, AHostWithoutGlslOffersNothing) {
  FakeHost host;
  host.version = "1.5 Fake";
  host.shadingLanguage = "";
  const CurrentContext context(host);
  EXPECT_FALSE(context->passThrough) << "its own parser must not be reached";
  const auto *extensions =
      reinterpret_cast<const char *>(handlers::GetString(*context, GL_EXTENSIONS));
  EXPECT_EQ(std::strstr(extensions, "GL_ARB_fragment_program"), nullptr);
  EXPECT_EQ(std::strstr(extensions, "GL_ARB_vertex_program"), nullptr);
  use(*context, kText);
  EXPECT_EQ(host.count("ProgramString"), 0);
}

TEST(HostFaults, AHostWithoutProgramsOfItsOwn) {
  FakeHost host;
  host.extensions.clear();
  const CurrentContext context(host);
  const GLuint name = use(*context, kText);
  EXPECT_NE(name, 0u);
  EXPECT_TRUE(handlers::IsProgramARB(*context, name));
  EXPECT_TRUE(draw(*context));
  const auto *extensions =
      reinterpret_cast<const char *>(handlers::GetString(*context, GL_EXTENSIONS));
  EXPECT_NE(std::strstr(extensions, "GL_ARB_fragment_program"), nullptr) << "the layer offers it";
}

TEST(HostFaults, LanguagesThatWeRefuseAreNotOffered) {
  FakeHost host;
  const CurrentContext context(host);
  const auto *extensions =
      reinterpret_cast<const char *>(handlers::GetString(*context, GL_EXTENSIONS));
  EXPECT_EQ(std::strstr(extensions, "GL_NV_fragment_program2"), nullptr);
  GLint count = 0;
  handlers::GetIntegerv(*context, GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i)
    EXPECT_STRNE(
        reinterpret_cast<const char *>(handlers::GetStringi(*context, GL_EXTENSIONS, GLuint(i))),
        "GL_NV_fragment_program2");
}

TEST(HostFaults, ALostContextDoesNotHang) {
  FakeHost host;
  const CurrentContext context(host);
  const host::HostTable *const working = context->host;
  host::HostTable lost = *working;
  lost.GetError = [] { return GLenum(GL_CONTEXT_LOST); };
  context->host = &lost;
  use(*context, "!!ARBfp1.0 junk");
  (void)draw(*context);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_CONTEXT_LOST));
  context->host = working;
}

TEST(HostFaults, FewUnitsInTheHostLimitTheProfile) {
  FakeHost host;
  host.integers[GL_MAX_TEXTURE_IMAGE_UNITS] = 4;
  const CurrentContext context(host);
  GLint units = 0;
  handlers::GetIntegerv(*context, GL_MAX_TEXTURE_IMAGE_UNITS, &units);
  EXPECT_EQ(units, 4) << "more was promised than the host can sample";
}

/// After a reset (ARB_robustness) commands have no effect and GetError may return CONTEXT_LOST
/// forever: the layer must neither wait for the errors to end nor trust an answer.
TEST(HostFaults, AContextThatIsLost) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kText);
  EXPECT_TRUE(draw(*context));
  handlers::NewList(*context, 1, GL_COMPILE);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 0, 0, 1);
  handlers::EndList(*context);

  host.lost = true;
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_CONTEXT_LOST)) << "passed on";
  use(*context, kText);
  (void)draw(*context);
  // Another text, so that it is compiled again
  load(*context, "!!ARBfp1.0\nMOV result.color, 1;\nEND");
  (void)draw(*context);
  handlers::CallList(*context, 1);
  handlers::NewList(*context, 2, GL_COMPILE_AND_EXECUTE);
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 2, 0, 0, 1);
  (void)draw(*context);
  handlers::EndList(*context);
  handlers::PushAttrib(*context, GL_ALL_ATTRIB_BITS);
  handlers::PopAttrib(*context);
  handlers::UseProgram(*context, 5);
  (void)draw(*context);
  handlers::LinkProgram(*context, 5);
  handlers::BindProgramPipeline(*context, 5);
  (void)draw(*context);
  handlers::DeleteLists(*context, 1, 2);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_CONTEXT_LOST));
}

} // namespace
} // namespace arbiter::state
