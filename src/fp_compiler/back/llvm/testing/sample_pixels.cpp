#include "fp_compiler/back/llvm/testing/sample_pixels.h"

#include <cmath>

namespace arbiter::fp::llvm_back::testing {

float uniform(std::mt19937 &random, float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(random);
}

void fillCoordinates(const Case &test, int lanes, Pixels &pixels, std::mt19937 &random,
                     SampleCall &call) {
  const bool rect = test.key.dimension == abi::Dimension::Rect;
  const auto &size = test.size;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float texel = rect ? 1.0f : 1.0f / float(size[axis]);
    for (std::uint32_t chunk = 0; chunk < kChunks; ++chunk) {
      const float start = uniform(random, -1.5f, 2.5f) / (texel * float(size[axis]));
      const float slopes[] = {0, 1, -1, 0.37f, -2.7f, 1};
      float slope = slopes[(chunk + axis * (1 + chunk / 6)) % 6] * texel;
      if (axis > 0 && chunk % 2 == 0)
        slope = 0;
      for (int lane = 0; lane < lanes; ++lane) {
        const std::size_t at = chunk * std::uint32_t(lanes) + std::uint32_t(lane);
        float &value = pixels.coordinate[axis][at];
        if (chunk % 4 == 3)
          value = uniform(random, -1.5f, 2.5f) / (texel * float(size[axis]));
        else if (chunk % 4 == 2) // texel centres
          value = (std::floor(start / texel) + 0.5f) * texel + slope * float(lane);
        else
          value = start + slope * float(lane);
      }
    }
  }
  if (test.key.shadow)
    for (float &r : pixels.coordinate[2])
      r = random() % 4 == 0 ? float(random() % 2) : uniform(random, -0.2f, 1.2f);
  for (float &bias : pixels.bias)
    bias = uniform(random, -2, 3);
  // All pixels of a row share one random level of detail.
  const float scale = std::exp2(uniform(random, -1.5f, 4.0f));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float texel = rect ? 1.0f : 1.0f / float(size[axis]);
    call.dx[axis] = scale * texel * uniform(random, -1, 1);
    call.dy[axis] = scale * texel * uniform(random, -1, 1);
  }
}

} // namespace arbiter::fp::llvm_back::testing
