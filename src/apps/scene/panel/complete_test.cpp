#include "apps/scene/panel/complete.h"

#include <gmock/gmock.h>

namespace arbiter::scene {
namespace {

using testing::Contains;
using testing::Not;

/// Returns the words that may stand at the mark '^', which is not part of the text.
std::vector<std::string> at(std::string text) {
  const std::size_t mark = text.find('^');
  text.erase(mark, 1);
  std::vector<std::string> words;
  if (const auto place = completePanel(text, std::uint32_t(mark)))
    for (const Candidate &candidate : place->candidates)
      words.emplace_back(candidate.word);
  return words;
}

TEST(Complete, WhatMayStandThere) {
  EXPECT_THAT(at("#@ ^"), Contains("texture"));
  EXPECT_THAT(at("#@ ^"), Not(Contains("nearest")));
  EXPECT_THAT(at("#@ texture 0 = noise, ^"), Contains("nearest"));
  EXPECT_THAT(at("#@ texture 0 = noise, linear, ^"), Contains("edge"));
  EXPECT_THAT(at("#@ texture 0 = noise, linear, size 8 8, ^"), Not(Contains("edge")));
  EXPECT_THAT(at("#@ texture 0 = tw^"), Contains("twirl"));
  EXPECT_THAT(at("#@ texture 0 = twirl 8 8 ^"), Contains("radius"));
  EXPECT_THAT(at("#@ texture 0 = normals of ^"), Contains("bumps"));
  EXPECT_THAT(at("#@ mesh shells of ^"), Contains("sphere"));
  EXPECT_THAT(at("#@ mesh sphere ^"), Contains("parts"));
  EXPECT_THAT(at("#@ camera orbit ^"), Contains("yaw"));
  EXPECT_THAT(at("#@ local[0] = 1 animate ^"), Contains("sine"));
  EXPECT_THAT(at("#@ local[0] = ^"), Contains("eye"));
  EXPECT_THAT(at("#@ depth less write ^"), Contains("off"));
  EXPECT_THAT(at("#@ texcoord 1 = ^"), Contains("tangent"));
  EXPECT_TRUE(at("# size ^\n#@ size 1 1").empty()) << "a comment is no panel";
}

TEST(Complete, AWordIsReplacedAsAWhole) {
  const auto place = completePanel("#@ blend alp", 10);
  ASSERT_TRUE(place);
  EXPECT_EQ(place->replaced, (fp::Span{9, 12}));
}

TEST(Complete, AWordIsExplainedInItsPlace) {
  const std::string_view text = "#@ cull none, camera none\n";
  const auto faces = explainPanel(text, 8), camera = explainPanel(text, 22);
  ASSERT_TRUE(faces && camera);
  EXPECT_NE(faces->candidates[0].meaning, camera->candidates[0].meaning);
  EXPECT_FALSE(explainPanel(text, 2));
  EXPECT_FALSE(explainPanel(text, 25));
}

} // namespace
} // namespace arbiter::scene
