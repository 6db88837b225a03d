#include "util/hud/hud_options.h"

#include <gtest/gtest.h>

namespace arbiter {
namespace {

HudOptions parsed(std::string_view value) {
  std::string wrong;
  const std::optional<HudOptions> options = parseHudOptions(value, wrong);
  EXPECT_TRUE(options.has_value()) << value << ": " << wrong;
  return options.value_or(HudOptions{});
}

std::string wrongOf(std::string_view value) {
  std::string wrong;
  EXPECT_FALSE(parseHudOptions(value, wrong).has_value()) << value;
  return wrong;
}

TEST(HudOptions, AreOffUnlessAskedFor) {
  EXPECT_FALSE(parsed("").on);
  EXPECT_FALSE(parsed("0").on);
  EXPECT_TRUE(parsed("1").on);
}

TEST(HudOptions, OneHasAllPartsInTheUpperLeftCorner) {
  const HudOptions options = parsed("1");
  for (unsigned i = 0; i < kHudParts; ++i)
    EXPECT_TRUE(options.has(HudPart(i))) << i;
  EXPECT_FALSE(options.right);
  EXPECT_FALSE(options.bottom);
  EXPECT_FALSE(options.hidden);
  EXPECT_EQ(options.scale, 0);
  EXPECT_EQ(options.key, (HudKey{.keysym = 0xFFC6, .shift = true}));
}

TEST(HudOptions, NamedPartsAreTheOnlyOnes) {
  const HudOptions options = parsed("fps,draws,bottom-right");
  EXPECT_TRUE(options.on);
  EXPECT_TRUE(options.has(HudPart::Fps));
  EXPECT_TRUE(options.has(HudPart::Draws));
  EXPECT_FALSE(options.has(HudPart::Version));
  EXPECT_FALSE(options.has(HudPart::Graph));
  EXPECT_TRUE(options.right);
  EXPECT_TRUE(options.bottom);
}

TEST(HudOptions, ACornerAloneKeepsAllParts) {
  const HudOptions options = parsed("top-right,scale=3,hidden");
  EXPECT_EQ(options.parts, HudOptions{}.parts);
  EXPECT_TRUE(options.right);
  EXPECT_FALSE(options.bottom);
  EXPECT_EQ(options.scale, 3);
  EXPECT_TRUE(options.hidden);
}

TEST(HudOptions, HaveAKeyWithModifiers) {
  EXPECT_EQ(parsed("key=F1").key, (HudKey{.keysym = 0xFFBE}));
  EXPECT_EQ(parsed("key=ctrl+alt+F12").key,
            (HudKey{.keysym = 0xFFC9, .control = true, .alt = true}));
  EXPECT_EQ(parsed("key=none").key, HudKey{});
}

TEST(HudOptions, WhatIsWrongIsSaid) {
  EXPECT_NE(wrongOf("fsp").find("did you mean fps?"), std::string::npos);
  EXPECT_NE(wrongOf("fps,,draws").find("words of version"), std::string::npos);
  EXPECT_NE(wrongOf("scale=0").find("scale=1 to scale=16"), std::string::npos);
  EXPECT_NE(wrongOf("scale=2x").find("2x"), std::string::npos);
  EXPECT_NE(wrongOf("key=F13").find("key=F1 to key=F12"), std::string::npos);
  EXPECT_NE(wrongOf("key=shift+").find("key=F1"), std::string::npos);
}

} // namespace
} // namespace arbiter
