// Checks when vertex programs that are GLSL on the host are drawn with the variant that writes
// gl_ClipVertex, and what is queried to find out.
#include "state/host_draw/clip_planes.h"

#include <gtest/gtest.h>

#include "state/host_draw/linking/linked_program_cache.h"
#include "state/lifecycle/lifecycle.h"
#include "state/objects/linked_program.h"
#include "state/programs/variants/clipped_variant.h"
#include "state/share/share_group.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

/// A host that draws vertex programs as GLSL.
struct GlslHost : FakeHost {
  GlslHost() { offerNoAssembly(); }
};

/// Draws, and returns whether the effective vertex program is clipped.
bool clips(Context &context) {
  EXPECT_TRUE(draw(context));
  if (!context.effective.linkedProgram || !context.effective.linkedProgram->vertex.compiled) {
    ADD_FAILURE() << "no vertex program of the layer's is effective";
    return false;
  }
  return context.effective.linkedProgram->vertex.compiled->glsl.text.find("gl_ClipVertex") !=
         std::string::npos;
}

TEST(ClipPlanes, NobodyAsksBeforeOneIsEnabled) {
  GlslHost host;
  const CurrentContext context(host);
  use(*context, kPlacingText, kVertex);
  EXPECT_FALSE(clips(*context));
  handlers::Enable(*context, GL_BLEND);
  handlers::Disable(*context, GL_CLIP_PLANE0);
  EXPECT_EQ(context->attention, 0u);
  handlers::PopAttrib(*context);
  EXPECT_FALSE(clips(*context));
  EXPECT_EQ(host.count("IsEnabled"), 0);
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 1u);
}

TEST(ClipPlanes, EachPlaneChoosesTheForm) {
  GlslHost host;
  const CurrentContext context(host);
  context->caps.maxClipPlanes = 8;
  use(*context, kPlacingText, kVertex);
  for (GLenum plane = GL_CLIP_PLANE0; plane < GL_CLIP_PLANE0 + 8; ++plane) {
    host.enabled = {plane};
    handlers::Enable(*context, plane);
    EXPECT_TRUE(clips(*context)) << plane;
    host.calls.clear();
    EXPECT_TRUE(clips(*context)) << plane;
    EXPECT_EQ(host.count("IsEnabled"), 0) << "asked once";
    host.enabled = {};
    handlers::Disable(*context, plane);
    EXPECT_FALSE(clips(*context)) << plane;
  }
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 2u) << "a form is made once";
}

TEST(ClipPlanes, OneEnabledBeforeTheProgramIsKnown) {
  GlslHost host;
  const CurrentContext context(host);
  host.enabled = {GL_CLIP_PLANE2};
  handlers::Enable(*context, GL_CLIP_PLANE2);
  use(*context, kPlacingText, kVertex);
  EXPECT_TRUE(clips(*context));
}

TEST(ClipPlanes, PopAttribBringsThemBack) {
  GlslHost host;
  const CurrentContext context(host);
  use(*context, kPlacingText, kVertex);
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Enable(*context, GL_CLIP_PLANE0);
  handlers::PushAttrib(*context, GL_TRANSFORM_BIT);
  host.enabled = {};
  handlers::Disable(*context, GL_CLIP_PLANE0);
  EXPECT_FALSE(clips(*context));
  host.enabled = {GL_CLIP_PLANE0};
  handlers::PopAttrib(*context);
  EXPECT_TRUE(clips(*context));
}

TEST(ClipPlanes, AListThatEnablesOneClipsInEachContextOfTheGroup) {
  GlslHost host;
  const CurrentContext other(host);
  use(*other, kPlacingText, kVertex);
  EXPECT_FALSE(clips(*other));
  const CurrentContext context(host, &*other);
  handlers::NewList(*context, 7, GL_COMPILE);
  handlers::Enable(*context, GL_CLIP_PLANE0);
  handlers::EndList(*context);
  makeCurrent(&*other);
  handlers::CallList(*other, 7); // the host makes this list's draws
  EXPECT_NE(other->effective.linkedProgram->vertex.compiled->glsl.text.find("gl_ClipVertex"),
            std::string::npos);
  EXPECT_TRUE(clips(*other));
}

TEST(ClipPlanes, AListThatIsExecutedFollowsAtOnce) {
  GlslHost host;
  const CurrentContext context(host);
  use(*context, kPlacingText, kVertex);
  EXPECT_FALSE(clips(*context));
  handlers::NewList(*context, 7, GL_COMPILE_AND_EXECUTE);
  handlers::Enable(*context, GL_CLIP_PLANE0);
  EXPECT_TRUE(clips(*context));
  handlers::EndList(*context);
  EXPECT_EQ(host.recorded, std::vector<std::string>{"Enable 12288"})
      << "nothing of the layer's goes into the list";
}

TEST(ClipPlanes, CopyContextCopiesThem) {
  GlslHost host;
  const CurrentContext from(host);
  handlers::Enable(*from, GL_CLIP_PLANE0);
  const CurrentContext to(host);
  use(*to, kPlacingText, kVertex);
  EXPECT_FALSE(clips(*to));
  host.enabled = {GL_CLIP_PLANE0};
  copyContext(*from, *to, GL_LIGHTING_BIT);
  EXPECT_FALSE(clips(*to));
  copyContext(*from, *to, GL_ALL_ATTRIB_BITS);
  EXPECT_EQ(to->row(Target::Vertex).enabled, false) << "as in the other context";
  handlers::Enable(*to, kVertex);
  EXPECT_TRUE(clips(*to));
}

TEST(ClipPlanes, BothFormsGoWithTheirProgram) {
  GlslHost host;
  const CurrentContext context(host);
  const GLuint name = use(*context, kPlacingText, kVertex);
  EXPECT_FALSE(clips(*context));
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Enable(*context, GL_CLIP_PLANE0);
  EXPECT_TRUE(clips(*context));
  handlers::DeleteProgramsARB(*context, 1, &name);
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 0u);
  EXPECT_TRUE(host.shaders.empty());
}

TEST(ClipPlanes, TheFormThatClipsIsGlslBesideAssemblyToo) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, kPlacingText, kVertex);
  ASSERT_TRUE(draw(*context));
  ASSERT_TRUE(context->effective.linkedProgram->vertexAssembly);
  const auto whole = context->group->compiledOf(*context->row(Target::Vertex).bound);
  const LinkedProgram *const clipped =
      context->hostSide.linkedPrograms->get(*context, {whole->clipped->of(*whole, 0), nullptr});
  EXPECT_FALSE(clipped->vertexAssembly);
  EXPECT_NE(clipped->hostProgram, 0u);
  EXPECT_FALSE(clipped->refused);
}

TEST(ClipPlanes, ShadersThatEscapeThemAsAssemblyAreClippedAsGlsl) {
  FakeHost host;
  const CurrentContext context(host);
  CompiledProgram shader;
  shader.target = Target::VertexShader;
  EXPECT_FALSE(assemblyClipsOtherwise(*context, shader));
  context->caps.planesClipPrograms = false;
  EXPECT_TRUE(assemblyClipsOtherwise(*context, shader));
  shader.target = Target::Vertex;
  EXPECT_FALSE(assemblyClipsOtherwise(*context, shader)) << "as the bare host has them";
}

TEST(ClipPlanes, AProgramOfNvidiasOptionsIsClippedByWhatItWrites) {
  GlslHost host;
  const CurrentContext context(host);
  context->caps.glslVersion = 130;
  context->row(Target::Vertex).limits.nvOptions = 2;
  use(*context,
      "!!ARBvp1.0\nOPTION NV_vertex_program2;\nMOV result.position, vertex.position;\n"
      "MOV result.clip[1].x, vertex.color.x;\nEND",
      kVertex);
  const auto writes = [&](const char *statement) {
    EXPECT_FALSE(clips(*context)) << "gl_ClipVertex";
    return context->effective.linkedProgram->vertex.compiled->glsl.text.find(statement) !=
           std::string::npos;
  };
  EXPECT_FALSE(writes("gl_ClipDistance"));
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Enable(*context, GL_CLIP_PLANE0);
  EXPECT_TRUE(writes("gl_ClipDistance[0] = 0.0;")) << "it writes none, which passes";
  EXPECT_FALSE(writes("gl_ClipDistance[1]"));
  host.enabled = {GL_CLIP_PLANE0, GL_CLIP_PLANE1};
  handlers::Enable(*context, GL_CLIP_PLANE1);
  EXPECT_TRUE(writes("gl_ClipDistance[1] = arb_clip1;"));
  EXPECT_TRUE(writes("#version 130"));
  host.enabled = {GL_CLIP_PLANE0};
  handlers::Disable(*context, GL_CLIP_PLANE1);
  EXPECT_FALSE(writes("gl_ClipDistance[1]"));
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 3u)
      << "a form for each set of planes, made once";
}

} // namespace
} // namespace arbiter::state
