#include "apps/scene/texture/generate.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <gmock/gmock.h>

namespace arbiter::scene {
namespace {

std::vector<Image> imagesOf(const std::string &words) {
  const Panel panel = parsePanel("#@ texture 0 = " + words + "\n");
  EXPECT_TRUE(panel.diagnostics.empty()) << words;
  auto images = generate(panel.textures.at(0).source, "", 24, 16);
  EXPECT_TRUE(images) << words;
  return images ? std::move(images).value() : std::vector<Image>(1, Image(1, 1));
}

Image imageOf(const std::string &words) { return imagesOf(words).front(); }

TEST(Texture, EveryGeneratorMakesItsSizeAndTheSameTwice) {
  for (const char *words : {"constant", "checker", "noise", "clouds", "gradient", "spot", "bricks",
                            "bumps", "landscape", "cells", "hairs", "twirl", "ripple"}) {
    const Image image = imageOf(std::string(words) + " 20 12");
    EXPECT_EQ(image.width, 20) << words;
    EXPECT_EQ(image.height, 12) << words;
    EXPECT_EQ(image.texels, imageOf(std::string(words) + " 20 12").texels) << words;
    if (std::string(words) != "constant") {
      EXPECT_THAT(image.texels, testing::Contains(testing::Ne(image.texels[0]))) << words;
    }
  }
}

TEST(Texture, AnArgumentMatters) {
  for (const char *words :
       {"constant r 0.5",    "checker cells 4",  "checker dark 0",    "clouds scale 8",
        "clouds octaves 1",  "clouds seed 2",    "gradient low 0.5",  "gradient steps 3",
        "gradient power 2",  "spot radius 0.2",  "spot soft 0",       "spot ambient 0.5",
        "bricks rows 3",     "bricks columns 2", "bricks mortar 0.3", "bricks gray 1",
        "bumps count 2",     "bumps radius 0.2", "cells density 0.6", "cells seed 4",
        "hairs density 0.1", "hairs seed 3",     "twirl radius 0.2",  "twirl turn 1",
        "ripple rings 2",    "ripple depth 0.1"}) {
    const std::string plain = std::string(words).substr(0, std::string(words).find(' '));
    EXPECT_NE(imageOf(words).texels, imageOf(plain).texels) << words;
  }
}

TEST(Texture, ACheckerBeginsDark) {
  const Image image = imageOf("checker 16 16 cells 2");
  EXPECT_EQ(image.texels[0], 32);
  EXPECT_EQ(image.at(8, 0).r, 1);
  EXPECT_EQ(image.at(8, 8).g, image.at(0, 0).g);
}

TEST(Texture, CloudsMeetAtTheirBorders) {
  const Image image = imageOf("clouds 64 64 scale 4 octaves 3");
  float inside = 0, across = 0;
  for (int y = 0; y < 64; ++y) {
    inside = std::max(inside, std::abs(image.at(31, y).r - image.at(32, y).r));
    across = std::max(across, std::abs(image.at(63, y).r - image.at(0, y).r));
  }
  EXPECT_LT(across, 2 * inside + 0.02f);
}

TEST(Texture, NormalsAreOfUnitLengthAndLeanFromTheBumps) {
  const Image image = imageOf("normals strength 4 of bumps 64 64 count 1");
  for (int i = 0; i < 64; ++i)
    EXPECT_NEAR(glm::length(glm::vec3(image.at(i, i)) * 2.0f - 1.0f), 1, 0.02f);
  EXPECT_LT(image.at(14, 32).r, 0.4f) << "left of the bump they look left";
  EXPECT_GT(image.at(50, 32).r, 0.6f);
  EXPECT_LT(image.at(32, 14).g, 0.4f) << "below it down";
}

TEST(Texture, ATwirlMovesNothingInTheMiddleOrOutside) {
  const Image image = imageOf("twirl 65 65 radius 0.3");
  EXPECT_EQ(image.bits, 16);
  EXPECT_EQ(image.texels[4 * (32 * 65 + 32)], 32768);
  EXPECT_EQ(image.texels[0], 32768);
  EXPECT_NE(image.texels[4 * (32 * 65 + 38) + 1], 32768);
}

TEST(Texture, TheRuleIsLifes) {
  const Image rule = imageOf("rule");
  for (int self = 0; self < 2; ++self)
    for (int around = 0; around < 16; ++around) {
      const int neighbours = around - self;
      EXPECT_EQ(rule.at(self, around).r == 1.0f, neighbours == 3 || (self == 1 && neighbours == 2))
          << self << " of " << around;
    }
}

TEST(Texture, ACubeMapPointsWhereItIs) {
  const std::vector<Image> faces = imagesOf("normalize 33");
  ASSERT_EQ(faces.size(), 6u);
  const glm::vec3 axes[6] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LT(glm::distance(glm::vec3(faces[i].at(16, 16)) * 2.0f - 1.0f, axes[i]), 0.01f) << i;
  EXPECT_EQ(imagesOf("sky 8").size(), 6u);
}

TEST(Texture, FeedbackBeginsAtThePicturesSize) {
  const Image image = imageOf("feedback of cells 64 64");
  EXPECT_EQ(image.width, 24);
  EXPECT_EQ(image.height, 16);
  EXPECT_THAT(imageOf("feedback").texels, testing::Each(0));
}

TEST(Texture, AFileThatCannotBeReadIsAnErrorAtItsName) {
  const std::string text = "#@ texture 0 = none.png\n";
  const Panel panel = parsePanel(text);
  const auto images = generate(panel.textures.at(0).source, "/nowhere/", 1, 1);
  ASSERT_FALSE(images);
  EXPECT_EQ(images.error().span, panel.textures[0].source.files[0].span);
  EXPECT_THAT(images.error().message, testing::HasSubstr("/nowhere/none.png"));
}

} // namespace
} // namespace arbiter::scene
