// The fast paths of entry points do what the handlers would have done.
#include "state/handlers/entry/straight.h"

#include <gtest/gtest.h>

#include "state/core/errors.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr GLenum kMaxNames = 0x10000;

TEST(Straight, AnEnableOfTheHostsIsWhatTheHandlerMakesOfIt) {
  FakeHost host;
  const CurrentContext context(host);
  int asked = 0;
  for (GLenum cap = 0; cap < kMaxNames; ++cap) {
    context->dirty = 0;
    if (!straight::Enable(*context, cap)) {
      ASSERT_EQ(context->dirty, 0u) << "left to the handler: " << cap;
      continue;
    }
    const std::uint32_t noted = std::exchange(context->dirty, 0);
    const std::uint32_t attention = context->attention;
    host.calls.clear();
    handlers::Enable(*context, cap);
    ASSERT_EQ(context->dirty, noted) << cap;
    ASSERT_EQ(context->attention, attention) << cap;
    ASSERT_EQ(host.calls.size(), 1u) << "the host's Enable alone: " << cap;
    ++asked;
  }
  EXPECT_GT(asked, 60000);
  for (const GLenum cap : {GLenum(GL_FRAGMENT_PROGRAM_ARB), GLenum(GL_VERTEX_PROGRAM_ARB),
                           GLenum(GL_FOG), GLenum(GL_TEXTURE_2D), GLenum(GL_CLIP_PLANE0)}) {
    EXPECT_FALSE(straight::Enable(*context, cap)) << cap;
    EXPECT_FALSE(straight::Disable(*context, cap)) << cap;
  }
}

TEST(Straight, APrimitiveOfTheHostsIsWhatTheHandlersMakeOfIt) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND");
  EXPECT_FALSE(straight::Begin(*context, GL_POINTS)) << "the program is not the host's yet";
  ASSERT_TRUE(draw(*context));
  ASSERT_EQ(context->attention, 0u);
  // Modes above POLYGON begin no primitive.
  for (GLenum mode = 0; mode < 20; ++mode) {
    const std::uint64_t before = drawsBy(*context, Path::HostGlsl);
    ASSERT_TRUE(straight::Begin(*context, mode)) << mode;
    const bool inside = context->insideBeginEnd;
    ASSERT_TRUE(straight::End(*context));
    ASSERT_FALSE(context->insideBeginEnd);
    ASSERT_EQ(drawsBy(*context, Path::HostGlsl), before + 1);
    handlers::Begin(*context, mode);
    ASSERT_EQ(context->insideBeginEnd, inside) << mode;
    handlers::End(*context);
    ASSERT_EQ(drawsBy(*context, Path::HostGlsl), before + 2);
  }
  handlers::ProgramEnvParameter4fARB(*context, kFragment, 0, 1, 0, 0, 0);
  EXPECT_FALSE(straight::Begin(*context, GL_POINTS)) << "a parameter waits";
  ASSERT_TRUE(draw(*context));
  context->mapsNamed = true;
  EXPECT_FALSE(straight::Begin(*context, GL_POINTS)) << "it may evaluate";
  context->mapsNamed = false;
  context->softwarePossible = true;
  EXPECT_FALSE(straight::Begin(*context, GL_POINTS) || straight::End(*context));
  context->softwarePossible = false;
  handlers::NewList(*context, 1, GL_COMPILE);
  EXPECT_FALSE(straight::Begin(*context, GL_POINTS) || straight::End(*context));
  handlers::EndList(*context);
}

TEST(Straight, WhatIsDirtyAlreadyStaysSo) {
  FakeHost host;
  const CurrentContext context(host);
  context->dirty = dirty::kArrays;
  EXPECT_TRUE(straight::Disable(*context, GL_CULL_FACE));
  EXPECT_EQ(context->dirty, dirty::kArrays | dirty::kRaster);
}

TEST(Straight, AnErrorOfTheLayersIsNotTheHosts) {
  FakeHost host;
  const CurrentContext context(host);
  EXPECT_TRUE(straight::GetError(*context));
  raise(*context, GL_INVALID_VALUE, "test");
  EXPECT_FALSE(straight::GetError(*context));
}

TEST(Straight, TheLayerSeesWhichTexturesCompare) {
  FakeHost host;
  const CurrentContext context(host);
  EXPECT_TRUE(straight::TexParameteri(*context, GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR));
  EXPECT_FALSE(straight::TexParameteri(*context, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                                       GL_COMPARE_R_TO_TEXTURE));
  EXPECT_FALSE(straight::TexParameterf(*context, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE,
                                       GLfloat(GL_COMPARE_R_TO_TEXTURE)));
  EXPECT_FALSE(straight::TexParameteri(*context, GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, GL_TRUE));
}

TEST(Straight, TexturesAreTheHostsWhereNoTextureShaderIs) {
  FakeHost host; // it lacks the formats that texture shaders need
  const CurrentContext context(host);
  ASSERT_FALSE(context->textureShaders);
  EXPECT_TRUE(straight::BindTexture(*context, GL_TEXTURE_2D, 1));
}

TEST(Straight, NvidiasMatricesArraysAndRangesAndTheColorMatrixAreTheLayers) {
  FakeHost host;
  const CurrentContext context(host);
  int handled = 0;
  for (GLenum name = 0; name < kMaxNames; ++name) {
    const bool matrix = (name >= GL_MATRIX0_NV && name <= GL_MATRIX7_NV) || name == GL_COLOR;
    const bool array =
        (name >= GL_VERTEX_ATTRIB_ARRAY0_NV && name <= GL_VERTEX_ATTRIB_ARRAY15_NV) ||
        name == GL_VERTEX_ARRAY_RANGE_NV || name == GL_VERTEX_ARRAY_RANGE_WITHOUT_FLUSH_NV;
    ASSERT_EQ(straight::MatrixMode(*context, name), !matrix) << name;
    ASSERT_EQ(straight::EnableClientState(*context, name), !array) << name;
    ASSERT_EQ(straight::DisableClientState(*context, name), !array) << name;
    handled += matrix || array ? 1 : 0;
  }
  EXPECT_EQ(handled, 27);
  EXPECT_TRUE(straight::BindVertexArray(*context, 1)) << "no object is of Apple's extension";
  context->imagesPixels = true;
  EXPECT_FALSE(straight::MatrixMode(*context, GL_MODELVIEW)) << "it may end the mode COLOR";
}

} // namespace
} // namespace arbiter::state
