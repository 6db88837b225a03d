#include "apps/scene/animate.h"

#include <gmock/gmock.h>

namespace arbiter::scene {
namespace {

using testing::ElementsAre;
using testing::FloatNear;

Parameter parameterOf(const std::string &line) {
  const Panel panel = parsePanel("#@ " + line + "\n");
  EXPECT_TRUE(panel.diagnostics.empty()) << line;
  return panel.parameters.at(0);
}

TEST(Animate, BeginsWithTheTextsValueAndStaysInRange) {
  for (const char *kind : {"sine", "saw", "triangle"}) {
    const Parameter parameter =
        parameterOf("local[0].x = 0.25 in -1..3 animate " + std::string(kind) + " 2s");
    EXPECT_NEAR(animated(0.25, parameter, 0), 0.25, 1e-12) << kind;
    double least = 9, most = -9;
    for (int i = 0; i < 400; ++i) {
      const double value = animated(0.25, parameter, i * 0.01);
      least = std::min(least, value);
      most = std::max(most, value);
      EXPECT_NEAR(value, animated(0.25, parameter, i * 0.01 + 2), 1e-9) << kind << ": its period";
    }
    EXPECT_NEAR(least, -1, 0.05) << kind;
    EXPECT_NEAR(most, 3, 0.05) << kind;
  }
}

TEST(Animate, TimeGoesOn) {
  const Parameter parameter = parameterOf("local[0].x = 3 animate time 2s");
  EXPECT_DOUBLE_EQ(animated(3, parameter, 5), 5.5);
}

TEST(Animate, RowsJoinComponentsAndFillWithZero) {
  const Panel panel = parsePanel("#@ local[1].y = 5, local[1].w = 7\n#@ env[1] = 1 2\n");
  const auto rows = rowsAt(panel, 0, {});
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_THAT(rows[0].value, ElementsAre(0, 5, 0, 7));
  EXPECT_THAT(rows[1].value, ElementsAre(1, 2, 0, 0));
  EXPECT_EQ(rows[1].space, Setting::Env);
}

TEST(Animate, TurnsAboutY) {
  const Panel panel = parsePanel("#@ local[0].xyz = 1 2 0 animate turn 4s\n");
  EXPECT_THAT(rowsAt(panel, 1, {})[0].value,
              ElementsAre(FloatNear(0, 1e-6f), 2, FloatNear(-1, 1e-6f), 0));
}

TEST(Animate, ARotationLeavesItsPlaceAlone) {
  const Panel panel = parsePanel("#@ env[4..6] = rotate 90 z 1 px 1 py 2\n");
  const auto rows = rowsAt(panel, 0, {});
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[2].index, 6u);
  const auto times = [&](std::array<float, 4> point, std::size_t row) {
    float sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
      sum += rows[row].value[i] * point[i];
    return sum;
  };
  EXPECT_NEAR(times({1, 2, 0, 1}, 0), 1, 1e-6);
  EXPECT_NEAR(times({1, 2, 0, 1}, 1), 2, 1e-6);
  EXPECT_NEAR(times({2, 2, 0, 1}, 1), 3, 1e-6) << "one to the right is one above";
}

TEST(Camera, TheEyeIsWhereTheMatrixSaysItIs) {
  const Panel panel = parsePanel("#@ camera orbit yaw 40 pitch 25 distance 3 x 1 y 2 z -1\n");
  const View view = viewOf(panel.camera, 4, 3);
  const glm::vec4 eye = view.modelView * glm::vec4(view.eye, 1.0f);
  EXPECT_NEAR(eye.x, 0, 1e-5);
  EXPECT_NEAR(eye.y, 0, 1e-5);
  EXPECT_NEAR(eye.z, 0, 1e-5);
  const glm::vec4 middle = toTexture(view) * glm::vec4(1, 2, -1, 1);
  EXPECT_NEAR(middle.x / middle.w, 0.5, 1e-6);
  EXPECT_NEAR(middle.y / middle.w, 0.5, 1e-6);
}

TEST(Camera, PitchLooksFromAbove) {
  const Panel panel = parsePanel("#@ camera orbit pitch 90 distance 2\n");
  EXPECT_NEAR(viewOf(panel.camera, 1, 1).eye.y, 2, 1e-6);
}

} // namespace
} // namespace arbiter::scene
