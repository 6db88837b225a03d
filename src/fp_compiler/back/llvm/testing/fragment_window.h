#pragma once
#include <cmath>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "fp_compiler/back/llvm/engine/engine.h"
#include "fp_compiler/back/llvm/testing/fragment_scene.h"
#include "fp_compiler/ir/builder.h"
#include "fp_compiler/ir/evaluate.h"

/// Shared parts of the tests of fragment functions: a small window, and a program drawn into it.
namespace arbiter::fp::testing {

using abi::Layout;
using abi::Wrap;

inline constexpr int kWidth = 75, kHeight = 9;

inline std::vector<std::string> cpus() {
  std::vector<std::string> names;
  for (const char *name : {"", "avx512", "avx2", "sse4.1", "neon"})
    if (llvm_back::makeEngine({name}))
      names.emplace_back(name);
  return names;
}

/// A program over a window. Its first input is a texture coordinate.
struct Scene {
  explicit Scene(const std::string &cpu) : engine(llvm_back::makeEngine({cpu})) {
    key.targets[0].format.layout = Layout::U8x4;
  }

  void addTexture(int width, int height, Wrap wrap, abi::Filter filter = abi::Filter::Nearest,
                  Layout layout = Layout::U8x4) {
    abi::SamplerKey sampler{};
    sampler.format.layout = layout;
    sampler.wrap = {wrap, wrap, wrap};
    sampler.magnify = sampler.minify = filter;
    key.samplers[textures.size()] = sampler;
    textures.push_back(makeTexture(sampler, width, height, 5));
    data.textures[textures.size() - 1] = &textures.back()->view;
  }

  /// Shades the spans and returns the target's bytes.
  std::vector<std::uint8_t> draw(const ir::Program &program, const std::vector<QuadInput> &corners,
                                 const std::vector<abi::Span> &spans,
                                 const std::vector<std::array<float, 4>> &locals = {}) {
    key.lanes = abi::Lanes::Row;
    return shade(program, corners, spans.data(), spans.size(), locals);
  }

  /// Shades the whole window in blocks.
  std::vector<std::uint8_t> drawBlocks(const ir::Program &program,
                                       const std::vector<QuadInput> &corners,
                                       const std::vector<std::array<float, 4>> &locals = {}) {
    key.lanes = abi::Lanes::Quad;
    std::vector<abi::Block> blocks;
    for (int y = 0; y < kHeight; y += engine->blockHeight())
      for (int x = 0; x < kWidth; x += engine->blockWidth()) {
        unsigned mask = 0;
        for (int i = 0; i < engine->lanes(); ++i)
          if (x + i % engine->blockWidth() < kWidth && y + i / engine->blockWidth() < kHeight)
            mask |= 1u << i;
        blocks.push_back({std::int16_t(x), std::int16_t(y), std::uint16_t(mask), 0});
      }
    return shade(program, corners, blocks.data(), blocks.size(), locals);
  }

  std::vector<std::uint8_t> shade(const ir::Program &program, const std::vector<QuadInput> &corners,
                                  const void *items, std::size_t count,
                                  const std::vector<std::array<float, 4>> &locals) {
    if (const auto code = begin(program, corners, locals))
      code->function(&data, &primitive, items, std::uint32_t(count));
    return target.bytes;
  }

  /// Compiles the program for the key, and prepares a target and a primitive.
  std::unique_ptr<jit::FragmentCode> begin(const ir::Program &program,
                                           const std::vector<QuadInput> &corners,
                                           const std::vector<std::array<float, 4>> &locals = {}) {
    prepared = engine->prepareFragment(program, Numerics::Host);
    EXPECT_NE(prepared, nullptr);
    for (std::size_t i = 0; i < prepared->shape().inputs.size(); ++i) {
      key.inputs[i] = interpolation;
      setQuadInput(primitive, int(i), corners[prepared->shape().inputs[i].attribute.index], kWidth,
                   kHeight);
    }
    rows = parameterRows(prepared->program(), locals);
    for (std::size_t i = 0; i < rows.size(); ++i)
      if (const ir::Parameter &row = prepared->program().parameters[i];
          row.kind == ir::ParameterKind::State && state)
        rows[i] = state(row.state);
    data.parameters = reinterpret_cast<const float(*)[4]>(rows.data());
    target = makeTarget(key.targets[0].format, kWidth, kHeight, 1);
    data.targets[0] = {target.pixel(0, 0), target.rowStride};
    std::string reason;
    std::unique_ptr<jit::FragmentCode> code = engine->compile(*prepared, key, reason);
    EXPECT_NE(code, nullptr) << reason;
    return code;
  }

  /// Returns an input's value as the function computes it.
  float at(int input, int component, int x, int y) const {
    return valueAt(*engine, primitive.inputs[input][component], x, y - data.originY);
  }

  std::unique_ptr<jit::Engine> engine;
  std::unique_ptr<jit::FragmentProgram> prepared;
  std::function<ir::Vec4(const ir::StateRef &)> state; ///< values of state rows
  abi::FragmentKey key{};
  abi::Interpolation interpolation = abi::Interpolation::Linear; ///< of all inputs
  abi::FragmentData data{};
  abi::Primitive primitive{};
  std::vector<std::array<float, 4>> rows;
  std::vector<std::unique_ptr<SceneTexture>> textures;
  SceneTarget target;
};

inline std::vector<abi::Span> wholeRows() {
  std::vector<abi::Span> spans;
  for (int y = 0; y < kHeight; ++y)
    spans.push_back({0, std::int16_t(y), kWidth, 0});
  return spans;
}

inline ir::Program passThrough() {
  ir::Builder b;
  b.tex(ir::Opcode::Tex, b.color(), b.attribute(ir::AttributeKind::TexCoord), 0,
        ir::TexTarget::Tex2D);
  return b.take();
}

class FragmentTest : public ::testing::TestWithParam<std::string> {};

} // namespace arbiter::fp::testing
