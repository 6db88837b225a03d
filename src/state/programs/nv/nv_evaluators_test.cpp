// Checks how NV_vertex_program's evaluator maps (5.1) are defined, their errors, queries and
// enables. Tests in tests/layer_vs_specification check what they draw.
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "state/programs/nv/evaluator_maps.h"
#include "state/testing/nv_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

constexpr GLenum kCurve = GL_MAP1_VERTEX_ATTRIB3_4_NV, kSurface = GL_MAP2_VERTEX_ATTRIB3_4_NV;
constexpr GLfloat kPoints[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16};

/// A host whose maximal order is 8.
class MapHost : public NvHost {
public:
  MapHost() {
    integers[GL_MAX_EVAL_ORDER] = 8;
    integers[GL_ACTIVE_TEXTURE] = GL_TEXTURE0;
  }
};

TEST(NvEvaluators, PointsAndSlopesOfACurve) {
  EvaluatorMap map;
  map.order = {3, 1};
  map.domain = {2, 4, 0, 1};
  map.points = {{0, 0, 0, 1}, {1, 2, 0, 1}, {4, 0, 0, 1}};
  // The curve is (2t(1-t) + 4t^2, 4t(1-t)) with t = (u - 2) / 2.
  for (const GLfloat u : {2.0f, 2.5f, 3.0f, 4.0f}) {
    const GLfloat t = (u - 2) / 2;
    const MapPoint point = evaluate(map, u, 0);
    EXPECT_NEAR(point.value[0], 2 * t * (1 - t) + 4 * t * t, 1e-6f);
    EXPECT_NEAR(point.value[1], 4 * t * (1 - t), 1e-6f);
    EXPECT_NEAR(point.value[3], 1, 1e-6f);
    EXPECT_NEAR(point.alongU[0], (2 + 4 * t) / 2, 1e-5f);
    EXPECT_NEAR(point.alongU[1], (4 - 8 * t) / 2, 1e-5f);
    EXPECT_NEAR(point.alongU[3], 0, 1e-6f);
  }
}

TEST(NvEvaluators, PointsAndSlopesOfASurface) {
  EvaluatorMap map;
  map.order = {2, 2};
  map.domain = {0, 1, 0, 2};
  map.points = {{0, 0, 0, 1}, {0, 2, 0, 1}, {1, 0, 0, 1}, {1, 2, 4, 1}}; // row by row along u
  const MapPoint point = evaluate(map, 0.5f, 0.5f);
  EXPECT_EQ(point.value, (Vec4{0.5f, 0.5f, 0.5f, 1}));
  EXPECT_EQ(point.alongU, (Vec4{1, 0, 1, 0}));
  EXPECT_EQ(point.alongV, (Vec4{0, 1, 1, 0}));
  EXPECT_EQ(evaluate(map, 1, 2).value, (Vec4{1, 2, 4, 1}));
}

TEST(NvEvaluators, MapErrors) {
  MapHost host;
  const CurrentContext context(host);
  const auto curve = [&](GLenum target, GLfloat u1, GLfloat u2, GLint stride, GLint order) {
    handlers::Map1f(*context, target, u1, u2, stride, order, kPoints);
    return error(*context);
  };
  EXPECT_EQ(curve(kCurve, 0, 1, 4, 4), kNoError);
  EXPECT_EQ(curve(kSurface, 0, 1, 4, 2), kEnum);
  EXPECT_EQ(curve(kCurve, 1, 1, 4, 2), kValue);
  EXPECT_EQ(curve(kCurve, 0, 1, 3, 2), kValue);
  EXPECT_EQ(curve(kCurve, 0, 1, 4, 0), kValue);
  EXPECT_EQ(curve(kCurve, 0, 1, 4, 9), kValue);
  const auto surface = [&](GLenum target, GLfloat v1, GLint vstride, GLint vorder) {
    handlers::Map2f(*context, target, 0, 1, 8, 2, v1, 1, vstride, vorder, kPoints);
    return error(*context);
  };
  EXPECT_EQ(surface(kSurface, 0, 4, 2), kNoError);
  EXPECT_EQ(surface(kCurve, 0, 4, 2), kEnum);
  EXPECT_EQ(surface(kSurface, 1, 4, 2), kValue);
  EXPECT_EQ(surface(kSurface, 0, 3, 2), kValue);
  EXPECT_EQ(surface(kSurface, 0, 4, 9), kValue);
  host.integers[GL_ACTIVE_TEXTURE] = GL_TEXTURE1;
  EXPECT_EQ(curve(kCurve, 0, 1, 4, 4), kOperation);
  EXPECT_EQ(
      errorInsideBegin(*context, [&] { handlers::Map1f(*context, kCurve, 0, 1, 4, 4, kPoints); }),
      kOperation);
  EXPECT_EQ(host.count("Map1f"), 0);
}

TEST(NvEvaluators, Queries) {
  MapHost host;
  const CurrentContext context(host);
  std::array<GLint, 16> integers{};
  std::array<GLfloat, 16> floats{};
  std::array<GLdouble, 16> doubles{};
  handlers::GetMapiv(*context, kSurface, GL_ORDER, integers.data());
  EXPECT_EQ(integers[0] + 2 * integers[1], 3) << "before it is defined";
  handlers::GetMapfv(*context, kSurface, GL_COEFF, floats.data());
  EXPECT_EQ(floats[2] + 2 * floats[3], 2);
  const GLdouble points[] = {1, 2, 3, 4, 0, 5, 6, 7, 8.5, 0};
  handlers::Map1d(*context, kCurve, 2, 4, 5, 2, points);
  handlers::GetMapiv(*context, kCurve, GL_ORDER, integers.data());
  EXPECT_EQ(integers[0], 2);
  EXPECT_EQ(integers[1], 1) << "a curve has one order: the rest is left alone";
  handlers::GetMapdv(*context, kCurve, GL_DOMAIN, doubles.data());
  EXPECT_EQ(doubles[0], 2);
  EXPECT_EQ(doubles[1], 4);
  handlers::GetMapdv(*context, kCurve, GL_COEFF, doubles.data());
  EXPECT_EQ(doubles[4], 5) << "the stride leaves numbers out";
  EXPECT_EQ(doubles[7], 8.5);
  handlers::GetMapiv(*context, kCurve, GL_COEFF, integers.data());
  EXPECT_EQ(integers[7], 9) << "rounded";
  handlers::Map2f(*context, kSurface, 0, 1, 4, 2, 5, 6, 8, 2, kPoints);
  handlers::GetMapfv(*context, kSurface, GL_DOMAIN, floats.data());
  EXPECT_EQ(floats[3], 6);
  handlers::GetMapfv(*context, kSurface, GL_COEFF, floats.data());
  EXPECT_EQ(floats[4], 9) << "v is the inner one, by its stride";
  EXPECT_EQ(floats[8], 5);
  EXPECT_EQ(error(*context), kNoError);
  handlers::GetMapfv(*context, kCurve, GL_COLOR, floats.data());
  EXPECT_EQ(error(*context), kEnum);
}

TEST(NvEvaluators, Enables) {
  MapHost host;
  const CurrentContext context(host);
  for (GLenum map = kCurve - 3; map < kCurve - 3 + kEvaluatorMaps; ++map) {
    EXPECT_FALSE(handlers::IsEnabled(*context, map));
    handlers::Enable(*context, map);
    EXPECT_TRUE(handlers::IsEnabled(*context, map));
    GLboolean enabled = GL_FALSE;
    handlers::GetBooleanv(*context, map, &enabled);
    EXPECT_TRUE(enabled);
    handlers::Disable(*context, map);
    EXPECT_FALSE(handlers::IsEnabled(*context, map));
  }
  for (const GLbitfield group : {GL_ENABLE_BIT, GL_EVAL_BIT, GL_CURRENT_BIT}) {
    handlers::PushAttrib(*context, group);
    handlers::Enable(*context, kCurve);
    handlers::PopAttrib(*context);
    EXPECT_EQ(handlers::IsEnabled(*context, kCurve), group == GL_CURRENT_BIT) << group;
  }
  EXPECT_EQ(error(*context), kNoError);
  EXPECT_EQ(errorInsideBegin(*context, [&] { handlers::Enable(*context, kCurve); }), kOperation);
  EXPECT_EQ(host.count("Enable"), 0);
}

TEST(NvEvaluators, WithoutTheLanguagesTheyAreTheHosts) {
  FakeHost host; // its GLSL lacks features that NVIDIA's languages need
  const CurrentContext context(host);
  ASSERT_FALSE(context->nv);
  handlers::Enable(*context, kCurve);
  EXPECT_EQ(host.count("Enable"), 1);
}

} // namespace
} // namespace arbiter::state
