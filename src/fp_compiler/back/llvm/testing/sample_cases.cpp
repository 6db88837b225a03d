#include "fp_compiler/back/llvm/testing/sample_cases.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace arbiter::fp::llvm_back::testing {
namespace {

using abi::Compare;
using abi::Dimension;
using abi::Filter;
using abi::From;
using abi::Layout;
using abi::MipFilter;

/// The sampler properties, each with a small number of values.
enum Property {
  Dim,
  Lay,
  Swi,
  WrapS,
  WrapT,
  WrapR,
  Mag,
  Min,
  Mip,
  Shadow,
  Sizes,
  Lane,
  Bias,
  Needed,
  Srgb,
  Aniso,
  kProperties
};
constexpr int kValues[kProperties] = {5, 21, 6, 8, 8, 8, 2, 2, 3, 9, 6, 2, 4, 3, 2, 2};
using Choice = std::array<int, kProperties>;

constexpr abi::Swizzle kSwizzles[] = {abi::kRgba,
                                      {From::C2, From::C1, From::C0, From::C3},
                                      {From::C0, From::C0, From::C0, From::One},
                                      {From::Zero, From::Zero, From::Zero, From::C0},
                                      {From::C0, From::C0, From::C0, From::C1},
                                      {From::C0, From::C1, From::C2, From::One}};
constexpr int kSizes[][3] = {{1, 1, 1},   {16, 8, 4}, {64, 64, 8},
                             {37, 21, 5}, {3, 40, 2}, {1, 32, 1}};

/// True if GL allows the combination; other pairs are not tested.
bool possible(const Choice &c) {
  const auto layout = Layout(c[Lay]);
  const auto dimension = Dimension(c[Dim]);
  for (const From from : kSwizzles[c[Swi]])
    if (from <= From::C3 && layout != Layout::None &&
        int(from) >= std::max(abi::componentsOf(layout), 1))
      return false;
  if (c[Shadow] &&
      (!abi::isDepth(layout) || dimension == Dimension::Tex3D || dimension == Dimension::Cube))
    return false;
  if (c[Aniso] && c[Mip] == 0)
    return false;
  if (c[Srgb] && (layout < Layout::U8x1 || layout > Layout::U8x4))
    return false;
  if (dimension == Dimension::Rect &&
      (c[Mip] != 0 || (c[WrapS] != 2 && c[WrapS] != 3 && c[WrapS] != 4) ||
       (c[WrapT] != 2 && c[WrapT] != 3 && c[WrapT] != 4)))
    return false;
  return true;
}

Case caseOf(const Choice &c) {
  Case test;
  abi::SamplerKey &key = test.key;
  key.dimension = Dimension(c[Dim]);
  key.format = {Layout(c[Lay]), kSwizzles[c[Swi]]};
  if (c[Srgb])
    for (std::size_t i = 0; i < 3; ++i)
      if (key.format.swizzle[i] <= From::C3)
        key.format.srgb |= std::uint8_t(1u << int(key.format.swizzle[i]));
  key.wrap = {abi::Wrap(c[WrapS]), abi::Wrap(c[WrapT]), abi::Wrap(c[WrapR])};
  key.magnify = Filter(c[Mag]);
  key.minify = Filter(c[Min]);
  key.mip = MipFilter(c[Mip]);
  key.anisotropic = std::uint8_t(c[Aniso]);
  key.shadow = c[Shadow] > 0;
  key.compare = c[Shadow] ? Compare(c[Shadow] - 1) : Compare::LessEqual;
  key.hasBias = c[Bias] & 1;
  for (std::size_t i = 0; i < 3; ++i)
    test.size[i] = kSizes[c[Sizes]][i];
  if (key.dimension == Dimension::Cube)
    test.size[1] = test.size[0];
  if (key.dimension == Dimension::Tex1D)
    test.size[1] = 1;
  if (key.dimension != Dimension::Tex3D)
    test.size[2] = 1;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if ((test.size[axis] & (test.size[axis] - 1)) == 0)
      key.powerOfTwo |= std::uint8_t(1u << axis);
  test.options.lanes = abi::Lanes(c[Lane]);
  test.options.derivatives = c[Lane] == int(abi::Lanes::Row);
  test.options.bias = c[Bias] & 2;
  constexpr unsigned kNeeded[] = {0xF, 0x5, 0x8};
  test.options.needed = kNeeded[c[Needed]];
  return test;
}

using Pair = std::array<int, 4>; ///< property, value, property, value

int countNew(const Choice &c, const std::set<Pair> &missing) {
  int found = 0;
  for (int a = 0; a < kProperties; ++a)
    for (int b = a + 1; b < kProperties; ++b)
      found += int(missing.count({a, c[std::size_t(a)], b, c[std::size_t(b)]}));
  return found;
}

Choice randomChoice(std::mt19937 &random) {
  for (;;) {
    Choice c;
    for (std::size_t i = 0; i < kProperties; ++i)
      c[i] = int(random() % unsigned(kValues[i]));
    if (random() % 3) // `possible` would reject most comparisons
      c[Shadow] = 0;
    if (random() % 3)
      c[Srgb] = 0;
    if (possible(c))
      return c;
  }
}

} // namespace

std::vector<Case> pairwiseCases(std::mt19937 &random) {
  std::set<Pair> missing;
  for (int a = 0; a < kProperties; ++a)
    for (int b = a + 1; b < kProperties; ++b)
      for (int i = 0; i < kValues[a]; ++i)
        for (int j = 0; j < kValues[b]; ++j)
          missing.insert({a, i, b, j});
  std::vector<Case> cases;
  // Impossible pairs stay missing, so the loop ends when many tries find nothing new.
  for (;;) {
    Choice best = {};
    int most = 0;
    for (int i = 0; i < 60; ++i) {
      const Choice c = randomChoice(random);
      const int found = countNew(c, missing);
      if (found > most) {
        most = found;
        best = c;
      }
    }
    if (most == 0)
      return cases;
    for (int a = 0; a < kProperties; ++a)
      for (int b = a + 1; b < kProperties; ++b)
        missing.erase({a, best[std::size_t(a)], b, best[std::size_t(b)]});
    cases.push_back(caseOf(best));
  }
}

std::string describe(const Case &test) {
  const abi::SamplerKey &key = test.key;
  return fmt::format(
      "dimension {} layout {} swizzle {}{}{}{} wrap {} {} {} magnify {} minify {} mip {} shadow {} "
      "compare {} powerOfTwo {} hasBias {} size {}x{}x{} lanes {} bias {} needed {:x} srgb {:x} "
      "anisotropic {}",
      int(key.dimension), int(key.format.layout), int(key.format.swizzle[0]),
      int(key.format.swizzle[1]), int(key.format.swizzle[2]), int(key.format.swizzle[3]),
      int(key.wrap[0]), int(key.wrap[1]), int(key.wrap[2]), int(key.magnify), int(key.minify),
      int(key.mip), key.shadow, int(key.compare), key.powerOfTwo, key.hasBias, test.size[0],
      test.size[1], test.size[2], int(test.options.lanes), test.options.bias, test.options.needed,
      key.format.srgb, key.anisotropic);
}

} // namespace arbiter::fp::llvm_back::testing
