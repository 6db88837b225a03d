// Checks texture shaders as draws see them: where they are offered, and which changes make another
// program.
#include "state/programs/texture_shaders/texture_shader_state.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "state/host_draw/linking/linked_program_cache.h"
#include "state/objects/linked_program.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

class ShaderHost : public FakeHost {
public:
  ShaderHost() {
    for (const char *name : {"GL_EXT_texture_snorm", "GL_ARB_texture_float", "GL_ARB_texture_rg",
                             "GL_ARB_texture_rectangle"})
      extensions.emplace_back(name);
    integers[GL_ACTIVE_TEXTURE] = GL_TEXTURE0;
    integers[GL_MAX_TEXTURE_UNITS] = 4;
  }
};

void operation(Context &context, GLenum name) {
  handlers::TexEnvi(context, GL_TEXTURE_SHADER_NV, GL_SHADER_OPERATION_NV, GLint(name));
}

TEST(TextureShaderState, NeedsTheHostsFormats) {
  FakeHost plain;
  {
    const CurrentContext context(plain);
    EXPECT_FALSE(context->textureShaders);
  }
  ShaderHost host;
  const CurrentContext context(host);
  ASSERT_TRUE(context->textureShaders);
  EXPECT_EQ(context->textureShaders->extensions(), 3);
}

// A host with texture shaders of its own has the formats of NV_texture_shader. Its shaders would
// run without the layer's combiners.
TEST(TextureShaderState, AHostWithTheSameExtensionKeepsItsFormats) {
  ShaderHost host;
  std::replace(host.extensions.begin(), host.extensions.end(), std::string("GL_EXT_texture_snorm"),
               std::string("GL_NV_texture_shader"));
  const CurrentContext context(host);
  ASSERT_TRUE(context->textureShaders);
  const auto storedAs = [&](GLenum name) {
    return hostFormat(*componentFormat(name), context->caps);
  };
  for (const GLenum name : {GL_SIGNED_LUMINANCE8_NV, GL_SIGNED_LUMINANCE8_ALPHA8_NV,
                            GL_SIGNED_ALPHA8_NV, GL_SIGNED_INTENSITY8_NV})
    EXPECT_EQ(storedAs(name), name);
  EXPECT_EQ(storedAs(GL_SIGNED_RGBA8_NV), GLenum(GL_RGBA8_SNORM));
  ShaderHost mesa;
  const CurrentContext another(mesa);
  EXPECT_EQ(hostFormat(*componentFormat(GL_SIGNED_ALPHA8_NV), another->caps),
            GLenum(GL_ALPHA8_SNORM));
}

TEST(TextureShaderState, ADrawHasTheirProgram) {
  ShaderHost host;
  const CurrentContext context(host);
  operation(*context, GL_PASS_THROUGH_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 0u) << "not enabled";
  handlers::Enable(*context, GL_TEXTURE_SHADER_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(drawsBy(*context, Path::HostGlsl), 1u);
  ASSERT_TRUE(context->effective.linkedProgram);
  EXPECT_EQ(context->effective.linkedProgram->fragment.compiled->target, Target::TextureShaders);
  const LinkedProgram *const linked = context->effective.linkedProgram;
  operation(*context, GL_CULL_FRAGMENT_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_NE(context->effective.linkedProgram, linked);
  operation(*context, GL_PASS_THROUGH_NV);
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.linkedProgram, linked) << "made once";
  EXPECT_EQ(context->hostSide.linkedPrograms->size(), 2u);
}

TEST(TextureShaderState, AParameterChoosesNothing) {
  ShaderHost host;
  const CurrentContext context(host);
  operation(*context, GL_PASS_THROUGH_NV);
  handlers::Enable(*context, GL_TEXTURE_SHADER_NV);
  ASSERT_TRUE(draw(*context));
  const std::uint64_t selections = context->effective.selections;
  handlers::TexEnvf(*context, GL_TEXTURE_SHADER_NV, GL_OFFSET_TEXTURE_SCALE_NV, 3);
  operation(*context, GL_PASS_THROUGH_NV); // unchanged
  ASSERT_TRUE(draw(*context));
  EXPECT_EQ(context->effective.selections, selections);
  const int row = fp::texture_shader::parameter(0, fp::texture_shader::Row::ScaleBias);
  EXPECT_EQ(context->row(Target::TextureShaders).env[std::size_t(row)][0], 3.0f);
}

TEST(TextureShaderState, ConstantsOfCombinersAreTheirsToo) {
  ShaderHost host;
  const CurrentContext context(host);
  const GLfloat color[] = {0.25f, 0, 0, 1};
  handlers::CombinerParameterfvNV(*context, GL_CONSTANT_COLOR1_NV, color);
  EXPECT_EQ(context->row(Target::TextureShaders).env[1][0], 0.25f);
}

TEST(TextureShaderState, AStackSharesTheSettings) {
  ShaderHost host;
  const CurrentContext context(host);
  const auto before = context->textureShaders->settings();
  operation(*context, GL_PASS_THROUGH_NV);
  EXPECT_EQ(before->stages[0].operation, fp::texture_shader::Operation::None);
  context->textureShaders->restore(*context, before);
  EXPECT_EQ(context->textureShaders->settings(), before);
}

} // namespace
} // namespace arbiter::state
