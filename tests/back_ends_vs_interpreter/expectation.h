#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

/// What the interpreter says of one value of one pixel.
struct Expected {
  float value = 0;
  float slack = 0;        ///< allowed distance
  bool comparable = true; ///< false: the tolerances allow too much to say anything
};

struct ExpectedPixel {
  bool killed = false;
  bool comparable = true; ///< false: the tolerances do not say whether it is killed
  std::array<std::array<Expected, 4>, kColorBuffers> colors;
  std::optional<Expected> depth;
};

/// Attribute values at one pixel, one for each of Program::attributes, and what the stages after
/// the program read.
struct PixelInputs {
  std::vector<Vec4> attributes;
  float fogCoordinate = 0;
  Vec4 secondary = {};
  fp::Numerics numerics = fp::Numerics::Host;
};

/// Runs the interpreter on exact arithmetic, then \p trials times with every operand and result
/// moved within its tolerance, at random: the spread is what a host may differ by. A pixel that
/// seems wrong deserves more trials: a tie (the faces of a cube map, a texel's edge) may need many
/// to show.
inline constexpr int kFewTrials = 5, kManyTrials = 500;
[[nodiscard]] ExpectedPixel expect(const fp::ir::Program &program, const PixelInputs &inputs,
                                   std::uint64_t seed, int trials);
/// The same of 2x2 pixels: lower left, lower right, upper left, upper right.
[[nodiscard]] std::array<ExpectedPixel, 4> expect(const fp::ir::Program &program,
                                                  const std::array<PixelInputs, 4> &inputs,
                                                  std::uint64_t seed, int trials);
/// True if pixels of the program depend on their neighbours.
[[nodiscard]] bool needsQuads(const fp::ir::Program &program);

/// A pixel's worst error, in units of what is allowed; below or at 1 passes. Infinite where one
/// is killed and the other not, or one is finite and the other not.
struct Verdict {
  float error = 0;
  int compared = 0; ///< values
  int skipped = 0;  ///< values that could not be compared
  std::string what; ///< the worst: "color[0].x: 0.25, expected 0.5 +- 1e-6"
};
[[nodiscard]] Verdict judge(const fp::ir::Program &program, const ExpectedPixel &expected,
                            const std::array<Vec4, kColorBuffers> &colors, float depth);

} // namespace arbiter::differential
