#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

/// The interpreter's result for one value of one pixel.
struct Expected {
  float value = 0;
  float slack = 0;        ///< allowed difference
  bool comparable = true; ///< false: the tolerances are too large to judge
};

struct ExpectedPixel {
  bool killed = false;
  bool comparable = true; ///< false: the tolerances do not decide whether it is killed
  std::array<std::array<Expected, 4>, kColorBuffers> colors;
  std::optional<Expected> depth;
};

/// The attribute values at one pixel, one for each of Program::attributes, and the inputs of later
/// stages.
struct PixelInputs {
  std::vector<Vec4> attributes;
  float fogCoordinate = 0;
  Vec4 secondary = {};
  fp::Numerics numerics = fp::Numerics::Host;
};

/// Runs the interpreter on exact arithmetic, then \p trials times with every operand and result
/// moved randomly within its tolerance. The spread is the allowed difference of a host. A pixel
/// that seems wrong needs more trials: a tie (the faces of a cube map, a texel's edge) may need
/// many to show.
inline constexpr int kFewTrials = 5, kManyTrials = 500;
[[nodiscard]] ExpectedPixel expect(const fp::ir::Program &program, const PixelInputs &inputs,
                                   std::uint64_t seed, int trials);
/// Returns the expectations of 2x2 pixels: lower left, lower right, upper left, upper right.
[[nodiscard]] std::array<ExpectedPixel, 4> expect(const fp::ir::Program &program,
                                                  const std::array<PixelInputs, 4> &inputs,
                                                  std::uint64_t seed, int trials);
/// True if pixels of the program depend on their neighbors.
[[nodiscard]] bool needsQuads(const fp::ir::Program &program);

/// A pixel's worst error, relative to the allowed one; at most 1 passes. It is infinite if only one
/// of the two is killed, or only one is finite.
struct Verdict {
  float error = 0;
  int compared = 0; ///< values
  int skipped = 0;  ///< values that could not be compared
  std::string what; ///< a description of the worst: "color[0].x: 0.25, expected 0.5 +- 1e-6"
};
[[nodiscard]] Verdict judge(const fp::ir::Program &program, const ExpectedPixel &expected,
                            const std::array<Vec4, kColorBuffers> &colors, float depth);

} // namespace arbiter::differential
