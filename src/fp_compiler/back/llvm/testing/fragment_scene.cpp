#include "fp_compiler/back/llvm/testing/fragment_scene.h"

#include <cmath>
#include <random>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::testing {

namespace {
constexpr std::size_t kPad = 64;

std::vector<std::uint8_t> noise(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t &byte : bytes)
    byte = std::uint8_t(random() >> 13);
  return bytes;
}
} // namespace

std::unique_ptr<SceneTexture> makeTexture(const abi::SamplerKey &key, int width, int height,
                                          std::uint32_t seed) {
  auto texture = std::make_unique<SceneTexture>();
  texture->key = key;
  texture->width = width;
  texture->height = height;
  const std::size_t stride = std::size_t(width) * std::size_t(abi::bytesOf(key.format.layout));
  texture->bytes = noise(2 * kPad + stride * std::size_t(height), seed);
  texture->level.base = texture->bytes.data() + kPad;
  texture->level.rowStride = std::int64_t(stride);
  texture->level.width = width;
  texture->level.height = height;
  texture->level.depth = 1;
  texture->view.levels = &texture->level;
  texture->view.levelCount = 1;
  return texture;
}

SceneTarget makeTarget(const abi::Format &format, int width, int height, std::uint32_t seed) {
  SceneTarget target;
  target.format = format;
  target.width = width;
  target.height = height;
  target.rowStride =
      std::ptrdiff_t((std::size_t(width * abi::bytesOf(format.layout)) + kPad) / kPad * kPad);
  target.first = 2 * target.rowStride;
  target.bytes = noise(std::size_t(target.rowStride) * std::size_t(height + 4), seed);
  return target;
}

void setQuadInput(abi::Primitive &primitive, int input, const QuadInput &corners, int width,
                  int height) {
  const float dx = (corners.s1 - corners.s0) / float(width);
  const float dy = (corners.t1 - corners.t0) / float(height);
  primitive.inputs[input][0] = {corners.s0 + 0.5f * dx, dx, 0};
  primitive.inputs[input][1] = {corners.t0 + 0.5f * dy, 0, dy};
  primitive.inputs[input][2] = {};
  primitive.inputs[input][3] = {1, 0, 0};
}

float valueAt(const jit::Engine &engine, const abi::Plane &plane, int x, int y) {
#if defined(__x86_64__) || defined(__i386__)
  if (engine.lanes() == 4) { // SSE4.1 has no fused multiply-add
    volatile const float along = plane.dx * float(x), up = plane.dy * float(y);
    volatile const float row = plane.c + along;
    return row + up;
  }
#endif
  return std::fma(plane.dy, float(y), std::fma(plane.dx, float(x), plane.c));
}

std::vector<std::array<float, 4>> parameterRows(const ir::Program &program,
                                                const std::vector<std::array<float, 4>> &locals) {
  std::vector<std::array<float, 4>> rows;
  for (const ir::Parameter &parameter : program.parameters) {
    std::array<float, 4> row = {};
    if (parameter.kind == ir::ParameterKind::Constant)
      row = parameter.constant;
    else if (parameter.kind == ir::ParameterKind::Local && parameter.index < locals.size())
      row = locals[parameter.index];
    rows.push_back(row);
  }
  return rows;
}

} // namespace arbiter::fp::testing
