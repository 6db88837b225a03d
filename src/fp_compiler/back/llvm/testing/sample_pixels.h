#pragma once
#include <random>
#include <vector>

#include "fp_compiler/back/llvm/testing/sample_cases.h"

namespace arbiter::fp::llvm_back::testing {

inline constexpr std::uint32_t kChunks = 12;

/// The pixels of a call and their results.
struct Pixels {
  explicit Pixels(int lanes) : count(int(kChunks) * lanes) {
    for (auto &plane : coordinate)
      plane.resize(std::size_t(count));
    for (auto &plane : result)
      plane.resize(std::size_t(count));
    bias.resize(std::size_t(count));
    packed.resize(std::size_t(count));
  }
  SampleCall call(const abi::TextureView &view) {
    SampleCall call;
    call.view = &view;
    for (std::size_t i = 0; i < 3; ++i)
      call.coordinate[i] = coordinate[i].data();
    for (std::size_t i = 0; i < 4; ++i)
      call.result[i] = result[i].data();
    call.bias = bias.data();
    call.packed = packed.data();
    return call;
  }
  int count;
  std::array<std::vector<float>, 3> coordinate;
  std::array<std::vector<float>, 4> result;
  std::vector<float> bias;
  std::vector<std::uint32_t> packed;
};

[[nodiscard]] float uniform(std::mt19937 &random, float low, float high);

/// Fills chunks with lines of several slopes, exact texel centres or scattered points, and sets
/// derivatives of a random level of detail.
void fillCoordinates(const Case &test, int lanes, Pixels &pixels, std::mt19937 &random,
                     SampleCall &call);

} // namespace arbiter::fp::llvm_back::testing
