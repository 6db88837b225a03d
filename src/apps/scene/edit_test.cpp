#include "apps/scene/edit.h"

#include <cmath>
#include <gtest/gtest.h>

namespace arbiter::scene {
namespace {

TEST(Edit, OneNumberChangesAndNoOtherByte) {
  const std::string text = "!!ARBfp1.0\r\n#@  local[0].x  \"a\"=1.50 in -1..2\t# kept\nEND";
  const Panel panel = parsePanel(text);
  const Number &value = panel.parameters.at(0).values[0];
  EXPECT_EQ(withNumber(text, value, 0.25),
            "!!ARBfp1.0\r\n#@  local[0].x  \"a\"=0.25 in -1..2\t# kept\nEND");
  EXPECT_EQ(withNumber(text, panel.parameters[0].low, -3),
            "!!ARBfp1.0\r\n#@  local[0].x  \"a\"=1.50 in -3..2\t# kept\nEND");
}

TEST(Edit, WhatIsWrittenReadsBackTheSame) {
  const std::string text = "#@ local[0] = 1 2 3 4 animate sine 5s\n";
  for (const double value : {0.0, -0.0, 0.1, 1e-20, -123456.789, 3.4e30, 1.0 / 3}) {
    const std::string changed = withNumber(text, parsePanel(text).parameters[0].values[2], value);
    const Panel panel = parsePanel(changed);
    ASSERT_TRUE(panel.diagnostics.empty() || std::abs(value) > 1e30) << changed;
    if (panel.ok()) {
      EXPECT_EQ(float(panel.parameters[0].values[2].value), float(value)) << changed;
    }
  }
  const std::string slower =
      withNumber(text, parsePanel(text).parameters[0].animation->period, 2.5);
  EXPECT_EQ(slower, "#@ local[0] = 1 2 3 4 animate sine 2.5s\n");
}

TEST(Edit, ArgumentsWordsAndLinesAreAdded) {
  const std::string text = "!!ARBfp1.0\r\n#@ texture 0 = twirl turn 2, linear\r\nEND\r\n";
  const TextureSpec texture = parsePanel(text).textures.at(0);
  ASSERT_FALSE(texture.source.arguments.numbers[0].written());
  EXPECT_EQ(applied(text, addArgument(texture.source.generator.span, "radius", 0.5)),
            "!!ARBfp1.0\r\n#@ texture 0 = twirl radius 0.5 turn 2, linear\r\nEND\r\n");
  EXPECT_EQ(applied(text, setWord(texture.filter.span, "nearest")),
            "!!ARBfp1.0\r\n#@ texture 0 = twirl turn 2, nearest\r\nEND\r\n");
  EXPECT_EQ(applied(text, addLine(text, "size 8 8")),
            "!!ARBfp1.0\r\n#@ texture 0 = twirl turn 2, linear\r\n#@ size 8 8\r\nEND\r\n");
  EXPECT_EQ(applied("!!ARBfp1.0\nEND", addLine("!!ARBfp1.0\nEND", "keep")),
            "!!ARBfp1.0\n#@ keep\nEND");
  EXPECT_EQ(applied("!!ARBfp1.0", addLine("!!ARBfp1.0", "keep")), "!!ARBfp1.0\n#@ keep");
}

} // namespace
} // namespace arbiter::scene
