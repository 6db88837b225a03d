#include <bit>
#include <cmath>
#include <gtest/gtest.h>

#include "fp_compiler/ir/semantics.h"
#include "fp_compiler/testing/specials.h"

/// Tests Numerics::Legacy: the result of 0 * infinity and 0 * NaN in every opcode that multiplies.
namespace arbiter::fp::ir {
namespace {

using testing::kInf;
using testing::kNan;
using testing::sameBits;

/// The two factors of one product: components of operand 0 and operand 1.
struct Place {
  Opcode op;
  int first, second;
};

constexpr Place kPlaces[] = {
    {Opcode::Mul, 0, 0}, {Opcode::Mul, 3, 3}, {Opcode::Mad, 0, 0}, {Opcode::Mad, 2, 2},
    {Opcode::Dp3, 0, 0}, {Opcode::Dp3, 1, 1}, {Opcode::Dp3, 2, 2}, {Opcode::Dp4, 0, 0},
    {Opcode::Dp4, 1, 1}, {Opcode::Dp4, 2, 2}, {Opcode::Dp4, 3, 3}, {Opcode::Dph, 0, 0},
    {Opcode::Dph, 1, 1}, {Opcode::Dph, 2, 2}, {Opcode::Dst, 1, 1}, {Opcode::Lrp, 0, 0},
    {Opcode::Lrp, 3, 3},
};

/// Expects a zero product: the result must be the one that a finite factor gives, which is +0.
void expectZero(Opcode op, const Operands &operands, const Operands &finite) {
  const Vec4 legacy = apply(op, operands, Numerics::Legacy);
  const Vec4 wanted = apply(op, finite, Numerics::Host);
  EXPECT_TRUE(sameBits(legacy, wanted)) << info(op).mnemonic << " " << legacy[0] << " " << legacy[1]
                                        << " " << legacy[2] << " " << legacy[3];
  const Vec4 fp24 = apply(op, operands, Numerics::Fp24);
  EXPECT_TRUE(sameBits(fp24, wanted)) << info(op).mnemonic << " in fp24";
}

TEST(Legacy, ZeroTimesAnythingIsZeroInEachPlace) {
  for (const Place &place : kPlaces)
    for (const float other : {kInf, -kInf, kNan})
      for (const float zero : {0.0f, -0.0f, 1e-40f})
        for (const bool swapped : {false, true}) {
          Operands operands = {Vec4{0.5f, 2, 3, 4}, Vec4{5, 6, 7, 8}, Vec4{9, 10, 11, 12}};
          const auto put = [&](float a, float b) {
            Operands result = operands;
            result[0][std::size_t(place.first)] = swapped ? b : a;
            result[1][std::size_t(place.second)] = swapped ? a : b;
            return result;
          };
          // LRP reads its first operand in both products: if it is 1, (1-a)*c is 0.
          if (place.op == Opcode::Lrp && swapped)
            continue;
          EXPECT_TRUE(std::isnan(
              apply(place.op, put(zero, other), Numerics::Host)[std::size_t(place.first)]));
          expectZero(place.op, put(zero, other), put(0, 1));
        }
}

TEST(Legacy, BothProductsOfLrp) {
  for (const float other : {kInf, -kInf, kNan}) {
    const Vec4 any = {other, other, other, other}, two = {2, 2, 2, 2}, one = {1, 1, 1, 1};
    expectZero(Opcode::Lrp, {one, two, any}, {one, two, one});             // (1-1) * c
    expectZero(Opcode::Lrp, {Vec4{}, any, two}, {Vec4{}, one, two});       // 0 * b
    expectZero(Opcode::Lrp, {any, Vec4{}, Vec4{}}, {one, Vec4{}, Vec4{}}); // a * 0 + (1-a) * 0
  }
}

TEST(Legacy, AllSixProductsOfXpd) {
  for (const float other : {kInf, -kInf, kNan})
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        if (i == j)
          continue;
        // a[i] is multiplied by b[j] and by the third component of b. Both are zero.
        Operands operands = {Vec4{2, 3, 4, 5}, Vec4{}};
        operands[1][i] = 7;
        Operands finite = operands;
        operands[0][i] = other;
        finite[0][i] = 1;
        expectZero(Opcode::Xpd, operands, finite);
        std::swap(operands[0], operands[1]);
        std::swap(finite[0], finite[1]);
        expectZero(Opcode::Xpd, operands, finite);
      }
}

TEST(Legacy, PowOfOneIsOne) {
  for (const float other : {kInf, -kInf, kNan}) {
    EXPECT_EQ(apply(Opcode::Pow, {Vec4{1}, Vec4{other}}, Numerics::Legacy)[0], 1.0f);
    EXPECT_EQ(apply(Opcode::Pow, {Vec4{1}, Vec4{other}}, Numerics::Fp24)[0], 1.0f);
    EXPECT_EQ(apply(Opcode::Lit, {Vec4{1, 1, 0, other}}, Numerics::Legacy)[2], 1.0f);
  }
  EXPECT_TRUE(std::isnan(apply(Opcode::Pow, {Vec4{1}, Vec4{kNan}}, Numerics::Host)[0]));
}

/// Programs of the time normalised a vector by DP3, RSQ and MUL. A null vector must stay null.
TEST(Legacy, NormalizesTheNullVectorToItself) {
  const float length = apply(Opcode::Dp3, {}, Numerics::Legacy)[0];
  const float scale = apply(Opcode::Rsq, {Vec4{length}}, Numerics::Legacy)[0];
  EXPECT_EQ(scale, kInf);
  EXPECT_EQ(apply(Opcode::Mul, {Vec4{}, Vec4{scale, scale, scale, scale}}, Numerics::Legacy),
            Vec4{});
}

/// Runs every opcode on every combination of special values, in components 0 and 1. Where Host
/// gives a number, Legacy gives the same. Outside of products it also gives the same NaN.
TEST(Legacy, DiffersFromHostInNansAlone) {
  int healed = 0;
  for (int o = 0; o < kOpcodeCount; ++o) {
    const auto op = Opcode(o);
    if (info(op).has(Texture) || info(op).has(Kills))
      continue;
    for (const float x : testing::kSpecials)
      for (const float y : testing::kSpecials)
        for (const float z : testing::kSpecials) {
          const Operands operands = {Vec4{x, y, z, y}, Vec4{y, z, x, x}, Vec4{z, x, y, z}};
          const Vec4 host = apply(op, operands, Numerics::Host);
          const Vec4 legacy = apply(op, operands, Numerics::Legacy);
          for (std::size_t i = 0; i < 4; ++i) {
            healed += std::isnan(host[i]) && !std::isnan(legacy[i]);
            ASSERT_TRUE(std::isnan(host[i]) || sameBits(host[i], legacy[i]))
                << info(op).mnemonic << "." << i << " " << x << " " << y << " " << z << ": "
                << host[i] << " " << legacy[i];
          }
        }
  }
  EXPECT_GT(healed, 1000);
}

TEST(Legacy, KeepsTheNansThatNoProductMakes) {
  EXPECT_TRUE(std::isnan(apply(Opcode::Mul, {Vec4{kNan}, Vec4{2}}, Numerics::Legacy)[0]));
  EXPECT_TRUE(std::isnan(apply(Opcode::Add, {Vec4{kInf}, Vec4{-kInf}}, Numerics::Legacy)[0]));
  EXPECT_TRUE(
      std::isnan(apply(Opcode::Mad, {Vec4{0}, Vec4{kInf}, Vec4{kNan}}, Numerics::Legacy)[0]));
  EXPECT_TRUE(std::isnan(apply(Opcode::Lg2, {Vec4{-1}}, Numerics::Legacy)[0]));
}

TEST(Legacy, IsWhatAVertexProgramTakesForFp24) {
  EXPECT_EQ(numericsOf(Language::ArbVertex, Numerics::Fp24), Numerics::Legacy);
  EXPECT_EQ(numericsOf(Language::ArbVertex, Numerics::Host), Numerics::Host);
  EXPECT_EQ(numericsOf(Language::ArbFragment, Numerics::Fp24), Numerics::Fp24);
  EXPECT_EQ(numericsOf(Language::AtiFragment, Numerics::Fp24), Numerics::Fp24);
}

} // namespace
} // namespace arbiter::fp::ir
