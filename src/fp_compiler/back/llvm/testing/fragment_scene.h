#pragma once
#include <memory>
#include <string>
#include <vector>

#include "fp_compiler/jit.h"

/// The scene that tests and the micro-benchmark of fragment functions draw: textures, targets and a
/// screen-sized primitive, together with the data that point into them.
namespace arbiter::fp::testing {

/// A texture of one level with 64 bytes of padding on both sides.
struct SceneTexture {
  abi::SamplerKey key;
  int width = 1, height = 1;
  std::vector<std::uint8_t> bytes;
  abi::TextureLevel level;
  abi::TextureView view;
};

/// A buffer with rows of guard bytes around its pixels, which must not change.
struct SceneTarget {
  abi::Format format;
  int width = 1, height = 1;
  std::vector<std::uint8_t> bytes;
  std::ptrdiff_t first = 0, rowStride = 0;
  [[nodiscard]] std::uint8_t *pixel(int x, int y) {
    return bytes.data() + first + y * rowStride + x * abi::bytesOf(format.layout);
  }
};

[[nodiscard]] std::unique_ptr<SceneTexture> makeTexture(const abi::SamplerKey &key, int width,
                                                        int height, std::uint32_t seed);
[[nodiscard]] SceneTarget makeTarget(const abi::Format &format, int width, int height,
                                     std::uint32_t seed);

/// The corners of input i of a quad over the window. The input is (s, t, 0, 1), from (s0, t0) to
/// (s1, t1).
struct QuadInput {
  float s0 = 0, t0 = 0, s1 = 1, t1 = 1;
};
void setQuadInput(abi::Primitive &primitive, int input, const QuadInput &corners, int width,
                  int height);

/// Returns a plane's value at the centre of pixel (x, originY + y), as the engine's machine code
/// computes it.
[[nodiscard]] float valueAt(const jit::Engine &engine, const abi::Plane &plane, int x, int y);

/// Returns the rows of Program::parameters: constants, and program.local[i] from \p locals.
[[nodiscard]] std::vector<std::array<float, 4>>
parameterRows(const ir::Program &program, const std::vector<std::array<float, 4>> &locals);

} // namespace arbiter::fp::testing
