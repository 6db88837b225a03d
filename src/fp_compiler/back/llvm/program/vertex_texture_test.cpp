// Compares samples of vertex functions with the interpreter and the reference sampler.

#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/back/llvm/testing/guarded_texture.h"
#include "fp_compiler/back/llvm/testing/machine.h"
#include "fp_compiler/back/llvm/testing/reference_sampler.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/ir/evaluate.h"

namespace arbiter::fp::llvm_back {
namespace {

using ir::Vec4;

constexpr std::size_t kTexturedVertices = 45; ///< the last vector is not full
constexpr std::size_t kRoom = 48;

/// Returns a vertex program under NV_vertex_program3. c is the coordinate.
ir::Program vertexProgram(const std::string &statements) {
  CompileOptions options;
  options.policy = LimitPolicy::Report;
  options.limits.textureImageUnits = 16;
  options.limits.textureCoords = 8;
  options.limits.nvOptions = 2;
  const std::string text = "!!ARBvp1.0\nOPTION NV_vertex_program3;\nOPTION "
                           "ARB_fragment_program_shadow;\nTEMP r, s, n;\n"
                           "ATTRIB c = vertex.attrib[1];\nMOV result.position, c;\n" +
                           statements + "\nEND\n";
  CheckResult result = checkProgram(ir::Language::ArbVertex, text, options);
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  return result.ok() ? std::move(*result.program) : ir::Program{};
}

struct Texture {
  Texture(int inUnit, const abi::SamplerKey &with, std::array<int, 3> size, std::mt19937 &random)
      : unit(inUnit), key(with), memory(key, size, random) {}
  int unit;
  abi::SamplerKey key;
  testing::GuardedTexture memory;
};

/// Samples as the specification says: the given level, or the base level.
Vec4 reference(const Texture &texture, const ir::Sample &sample) {
  testing::ReferenceQuery query;
  for (std::size_t i = 0; i < 3; ++i)
    query.coordinate[i] = double(sample.coordinate[i]);
  EXPECT_TRUE(sample.lod) << "a vertex has no derivatives";
  query.scale = std::exp2(double(sample.lod.value_or(0)));
  const testing::Color color = referenceSample(texture.key, texture.memory.view, query);
  return {float(color[0]), float(color[1]), float(color[2]), float(color[3])};
}

class VertexTextureTest : public ::testing::TestWithParam<std::string> {
protected:
  void expectAsInterpreted(const std::string &statements, float scale = 1) {
    SCOPED_TRACE(statements);
    const ir::Program program = vertexProgram(statements);
    std::string reason;
    const auto engine = makeEngine({GetParam()});
    ASSERT_NE(engine, nullptr);
    const auto prepared = engine->prepareVertex(program, Numerics::Host);
    ASSERT_NE(prepared, nullptr);
    abi::VertexKey key{};
    std::array<const abi::TextureView *, abi::kMaxUnits> views = {};
    for (const auto &texture : m_textures) {
      key.samplers[std::size_t(texture->unit)] = texture->key;
      views[std::size_t(texture->unit)] = &texture->memory.view;
    }
    for (const jit::Sampler &sampler : prepared->shape().samplers)
      ASSERT_NE(views[sampler.unit], nullptr) << "unit " << int(sampler.unit);
    const auto code = engine->compile(*prepared, key, reason);
    ASSERT_NE(code, nullptr) << reason;
    fill(scale);
    run(*prepared, *code, views.data());
    compare(*prepared);
  }

  void clear() { m_textures.clear(); }
  void add(int unit, const abi::SamplerKey &key, std::array<int, 3> size) {
    m_textures.push_back(std::make_unique<Texture>(unit, key, size, m_random));
  }

private:
  /// Fills in coordinates inside and outside the image. w, a level or a divisor, is not near a step
  /// between two levels.
  void fill(float scale) {
    std::uniform_real_distribution<float> place(-0.7f, 1.7f);
    constexpr float kLevels[] = {-1.25f, 0.25f, 0.75f, 1.25f, 1.75f, 2.25f, 9.0f};
    for (std::size_t i = 0; i < kRoom; ++i)
      for (std::size_t c = 0; c < 4; ++c)
        m_in[c][i] = c == 3 ? kLevels[i % std::size(kLevels)] : place(m_random) * scale;
  }

  void run(const jit::VertexProgram &program, const jit::VertexCode &code,
           const abi::TextureView *const *views) {
    ASSERT_EQ(program.shape().inputs.size(), 1u);
    const std::size_t outputs = program.shape().outputs.size();
    ASSERT_LE(outputs, kMax);
    const float *in[4];
    float *out[4 * kMax];
    for (std::size_t c = 0; c < 4; ++c)
      in[c] = m_in[c];
    for (std::size_t i = 0; i < 4 * outputs; ++i)
      out[i] = m_out[i];
    abi::VertexData data;
    data.inputs = in;
    data.outputs = out;
    data.textures = views;
    code.function(&data, kTexturedVertices);
  }

  void compare(const jit::VertexProgram &prepared) {
    const ir::Program &program = prepared.program();
    for (std::size_t i = 0; i < kTexturedVertices; ++i) {
      ir::Inputs inputs;
      const std::array<Vec4, 1> attributes = {Vec4{m_in[0][i], m_in[1][i], m_in[2][i], m_in[3][i]}};
      inputs.attributes = attributes;
      inputs.texture = [&](const ir::Sample &sample) {
        for (const auto &texture : m_textures)
          if (texture->unit == sample.unit)
            return reference(*texture, sample);
        return Vec4{};
      };
      const auto expected = ir::evaluate(program, inputs).outputs;
      const auto &results = prepared.shape().outputs;
      for (std::size_t o = 0; o < results.size(); ++o) {
        const auto found = std::find(program.outputs.begin(), program.outputs.end(), results[o]);
        for (std::size_t c = 0; c < 4; ++c)
          EXPECT_NEAR(m_out[4 * o + c][i],
                      expected[std::size_t(found - program.outputs.begin())][c], 5e-3f)
              << "vertex " << i << " at (" << attributes[0][0] << ", " << attributes[0][1] << ", "
              << attributes[0][2] << ", " << attributes[0][3] << "), result " << o << " component "
              << c;
      }
    }
  }

  static constexpr std::size_t kMax = 4;
  std::mt19937 m_random{7};
  std::vector<std::unique_ptr<Texture>> m_textures;
  alignas(64) float m_in[4][kRoom] = {};
  alignas(64) float m_out[4 * kMax][kRoom] = {};
};

abi::SamplerKey keyOf(abi::Dimension dimension, abi::MipFilter mip, abi::Filter filter,
                      abi::Layout layout = abi::Layout::U8x4) {
  abi::SamplerKey key{};
  key.dimension = dimension;
  key.format.layout = layout;
  const bool ends = dimension == abi::Dimension::Rect || dimension == abi::Dimension::Cube;
  key.wrap.fill(ends ? abi::Wrap::ClampToEdge : abi::Wrap::Repeat);
  key.magnify = key.minify = filter;
  key.mip = mip;
  return key;
}

constexpr struct {
  abi::Dimension dimension;
  const char *word;
  std::array<int, 3> size;
} kTargets[] = {{abi::Dimension::Tex1D, "1D", {16, 1, 1}},
                {abi::Dimension::Tex2D, "2D", {16, 8, 1}},
                {abi::Dimension::Tex3D, "3D", {8, 8, 4}},
                {abi::Dimension::Cube, "CUBE", {8, 8, 1}},
                {abi::Dimension::Rect, "RECT", {13, 7, 1}}};

TEST_P(VertexTextureTest, EveryTargetAtTheLevelThatIsAsked) {
  for (const auto &target : kTargets)
    for (const abi::Filter filter : {abi::Filter::Nearest, abi::Filter::Linear}) {
      const bool rectangle = target.dimension == abi::Dimension::Rect;
      clear();
      add(3,
          keyOf(target.dimension, rectangle ? abi::MipFilter::None : abi::MipFilter::Linear, filter,
                filter == abi::Filter::Linear ? abi::Layout::F32x4 : abi::Layout::U8x4),
          target.size);
      for (const char *const opcode : {"TEX", "TXP", "TXL", "TXB"})
        expectAsInterpreted(std::string(opcode) + " result.texcoord[0], c, texture[3], " +
                                target.word + ";",
                            rectangle ? 8 : 1);
    }
}

/// Sampled values are read like all others: swizzles, masks, samples of samples.
TEST_P(VertexTextureTest, SamplesLeadToOthers) {
  add(0, keyOf(abi::Dimension::Tex2D, abi::MipFilter::None, abi::Filter::Linear), {16, 16, 1});
  add(15, keyOf(abi::Dimension::Tex1D, abi::MipFilter::None, abi::Filter::Linear), {8, 1, 1});
  expectAsInterpreted("TEX r, c.yxzw, texture[0], 2D; TEX s.xz, r.y, texture[15], 1D; "
                      "MAD result.color, s, 0.5, r; MOV result.texcoord[0], r.wzyx;");
}

/// Lanes that have left a loop do not sample any more.
TEST_P(VertexTextureTest, SamplesInLoops) {
  add(1, keyOf(abi::Dimension::Tex2D, abi::MipFilter::Nearest, abi::Filter::Nearest), {16, 16, 1});
  expectAsInterpreted("MOV n, c; MOV r, 0; again: TXL s, n, texture[1], 2D; MAD r, s, 0.25, r; "
                      "ADDC n.x, n, -0.25; ADD n.y, n, 0.1875; BRA again (GT.x); "
                      "MOV result.texcoord[1], r;");
}

TEST_P(VertexTextureTest, ShadowComparisons) {
  abi::SamplerKey key = keyOf(abi::Dimension::Tex2D, abi::MipFilter::None, abi::Filter::Nearest,
                              abi::Layout::Depth32F);
  key.shadow = 1;
  key.format.swizzle = {abi::From::C0, abi::From::C0, abi::From::C0, abi::From::One};
  add(2, key, {16, 16, 1});
  expectAsInterpreted("TEX result.color, c, texture[2], SHADOW2D;");
}

TEST_P(VertexTextureTest, WhatIsIncompleteIsBlack) {
  abi::SamplerKey key{};
  key.format.layout = abi::Layout::None;
  add(4, key, {1, 1, 1});
  expectAsInterpreted("TEX result.color, c, texture[4], 2D;");
}

TEST_P(VertexTextureTest, ShapeListsUnits) {
  const ir::Program program = vertexProgram(
      "TEX r, c, texture[9], CUBE; TEX s, c, texture[9], CUBE; ADD result.color, r, s; "
      "TEX r, c, texture[2], 3D;");
  const auto engine = makeEngine({GetParam()});
  ASSERT_NE(engine, nullptr);
  const auto prepared = engine->prepareVertex(program, Numerics::Host);
  ASSERT_NE(prepared, nullptr);
  ASSERT_EQ(prepared->shape().samplers.size(), 1u) << "what nothing reads is not sampled";
  EXPECT_EQ(prepared->shape().samplers[0].unit, 9);
  EXPECT_EQ(prepared->shape().samplers[0].target, ir::TexTarget::Cube);
}

INSTANTIATE_TEST_SUITE_P(All, VertexTextureTest, ::testing::ValuesIn(testedCpus()),
                         [](const auto &param) { return nameInTests(param.param); });

} // namespace
} // namespace arbiter::fp::llvm_back
