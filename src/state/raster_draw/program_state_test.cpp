// Checks the values of a program's parameters: constants, env, local, and rows of state against the
// host's.
#define GL_GLEXT_PROTOTYPES // before any header of GL
#include "state/raster_draw/program_state.h"

#include <array>
#include <bit>
#include <string>

#include <gtest/gtest.h>

#include "fp_compiler/ir/builder.h"
#include "state/context/context.h"
#include "state/core/host_state.h"
#include "state/testing/real_host.h"

namespace arbiter::state {
namespace {

using fp::ir::Builder;
using fp::ir::MatrixModifier;
using fp::ir::StateItem;
using fp::ir::StateRef;
using testing::RealHost;

StateRef ref(StateItem item, int index = 0, int row = 0,
             MatrixModifier modifier = MatrixModifier::Plain, bool back = false) {
  return {item, back, std::uint8_t(index), modifier, std::uint8_t(row)};
}

Vec4 valueOf(const ProgramValues &values, const fp::ir::Source &row) {
  const float *const value = values.data()[row.index];
  return {value[0], value[1], value[2], value[3]};
}

TEST(ProgramValues, FollowEnvAndLocalParameters) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Builder b(fp::ir::Language::ArbVertex);
  const auto constant = b.constant(1, 2, 3, 4), env = b.env(3), local = b.local(5);
  const auto beyond = b.env(60000);
  ProgramValues values(b.program());
  ProgramTarget &row = context.row(Target::Vertex);
  row.bound = std::make_shared<ProgramObject>(77, Target::Vertex);
  row.bound->locals.resize(8);
  GenerationCounter clock;
  clock.take(context.dirty);
  EXPECT_FALSE(values.update(context, clock, &row)) << "zeros as they were";
  row.env[3] = {5, 6, 7, 8};
  ++row.envVersion;
  row.bound->locals[5].store({9, 10, 11, 12});
  row.bound->changed();
  EXPECT_TRUE(values.update(context, clock, &row));
  EXPECT_EQ(valueOf(values, constant), (Vec4{1, 2, 3, 4}));
  EXPECT_EQ(valueOf(values, env), (Vec4{5, 6, 7, 8}));
  EXPECT_EQ(valueOf(values, local), (Vec4{9, 10, 11, 12}));
  EXPECT_EQ(valueOf(values, beyond), Vec4{});
  EXPECT_FALSE(values.update(context, clock, &row));
  row.env[3][0] = -0.0f;
  ++row.envVersion;
  EXPECT_TRUE(values.update(context, clock, &row));
  row.env[3][0] = 0.0f;
  ++row.envVersion;
  EXPECT_TRUE(values.update(context, clock, &row)) << "zeros of two signs are two values";
  ++row.envVersion;
  EXPECT_FALSE(values.update(context, clock, &row)) << "the value that it was";
  // Another object whose version happens to be the same.
  const std::uint32_t version = row.bound->version;
  row.bound = std::make_shared<ProgramObject>(78, Target::Vertex);
  row.bound->locals.resize(8);
  row.bound->version = version;
  ++context.effective.selections;
  EXPECT_TRUE(values.update(context, clock, &row));
  EXPECT_EQ(valueOf(values, local), Vec4{});
}

TEST(ProgramValues, AskForStateOnlyWhereItIsStale) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Builder b(fp::ir::Language::ArbVertex);
  const auto fog = b.state(ref(StateItem::FogColor));
  const auto row = b.state(ref(StateItem::MatrixModelview, 0, 0));
  ProgramValues values(b.program());
  GenerationCounter clock;
  clock.take(context.dirty);
  EXPECT_TRUE(values.update(context, clock, nullptr));
  EXPECT_EQ(valueOf(values, row), (Vec4{1, 0, 0, 0}));
  const GLfloat color[4] = {0.25f, 0.5f, 0.75f, 1};
  glFogfv(GL_FOG_COLOR, color);
  glMatrixMode(GL_MODELVIEW);
  glScalef(2, 1, 1);
  EXPECT_FALSE(values.update(context, clock, nullptr)) << "nobody said that anything changed";
  context.dirty |= dirty::kFog;
  clock.take(context.dirty);
  EXPECT_TRUE(values.update(context, clock, nullptr));
  EXPECT_EQ(valueOf(values, fog), (Vec4{0.25f, 0.5f, 0.75f, 1}));
  EXPECT_EQ(valueOf(values, row), (Vec4{1, 0, 0, 0}));
  context.dirty |= dirty::kTransform;
  clock.take(context.dirty);
  EXPECT_TRUE(values.update(context, clock, nullptr));
  EXPECT_EQ(valueOf(values, row), (Vec4{2, 0, 0, 0}));
}

TEST(ProgramValues, HaveFogsFactorsForTheOptions) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Builder b(fp::ir::Language::ArbFragment);
  const auto row = b.state(ref(StateItem::FogFactors));
  ProgramValues values(b.program());
  GenerationCounter clock;
  clock.take(context.dirty);
  const auto factors = [&](float density, float start, float end) {
    glFogf(GL_FOG_DENSITY, density);
    glFogf(GL_FOG_START, start);
    glFogf(GL_FOG_END, end);
    context.dirty |= dirty::kFog;
    clock.take(context.dirty);
    EXPECT_TRUE(values.update(context, clock, nullptr));
    return valueOf(values, row);
  };
  EXPECT_EQ(factors(2, -1, 3), (Vec4{-0.25f, 0.75f, 2 * -1.442695041f, 2 * 1.201122409f}));
  EXPECT_EQ(factors(0, 2, 2), (Vec4{-0x1p40f, 0x1p41f, -0.0f, 0})) << "a step";
}

/// Returns every kind of row that a program can name.
std::vector<StateRef> allRows() {
  std::vector<StateRef> rows;
  for (int item = int(StateItem::MaterialAmbient); item <= int(StateItem::PointAttenuation);
       ++item) {
    const auto kind = StateItem(item);
    const bool matrix = kind >= StateItem::MatrixModelview && kind <= StateItem::MatrixProgram;
    const bool texGen = kind == StateItem::TexGenEye || kind == StateItem::TexGenObject;
    for (int row = 0; row < (matrix || texGen ? 4 : 1); ++row)
      for (int modifier = 0; modifier < (matrix ? 4 : 1); ++modifier)
        for (const bool back : {false, true})
          rows.push_back(ref(kind, 1, row, MatrixModifier(modifier), back));
  }
  return rows;
}

TEST(ProgramValues, EveryRowOfStateIsTheHostsAfterItsGroupChanged) {
  const RealHost host;
  ASSERT_TRUE(host.valid()) << "no context of OSMesa";
  RasterContext &context = host.context();
  Builder b(fp::ir::Language::ArbVertex);
  const std::vector<StateRef> rows = allRows();
  std::vector<fp::ir::Source> sources;
  for (const StateRef &row : rows)
    sources.push_back(b.state(row));
  ProgramValues values(b.program());
  testing::Numbers n(7);
  GenerationCounter clock;
  for (int round = 0; round < 36; ++round) {
    const GLfloat any[4] = {n.real(0, 1), n.real(0, 1), n.real(0, 1), 1};
    switch (round % 9) {
    case 7:
      glMatrixMode(GL_MODELVIEW);
      glRotatef(20, any[0], any[1], any[2]);
      context.dirty |= dirty::kModelview;
      break;
    case 8:
      glMaterialfv(GL_FRONT_AND_BACK, n.chance(50) ? GL_DIFFUSE : GL_EMISSION, any);
      glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, 40 * any[0]);
      context.dirty |= dirty::kMaterial;
      break;
    case 0:
      glMatrixMode(n.chance(50) ? GL_MODELVIEW : GL_PROJECTION);
      glRotatef(20, any[0], any[1], any[2]);
      glTranslatef(any[0], any[1], 3);
      context.dirty |= dirty::kTransform;
      break;
    case 1:
      glMaterialfv(GL_FRONT_AND_BACK, n.chance(50) ? GL_AMBIENT : GL_SPECULAR, any);
      glLightfv(GL_LIGHT1, n.chance(50) ? GL_DIFFUSE : GL_POSITION, any);
      context.dirty |= dirty::kLighting;
      break;
    case 2:
      glFogfv(GL_FOG_COLOR, any);
      glFogf(GL_FOG_END, 3 + any[0]);
      context.dirty |= dirty::kFog;
      break;
    case 3:
      glActiveTexture(GL_TEXTURE1);
      glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, any);
      glTexGenfv(GL_T, GL_OBJECT_PLANE, any);
      context.dirty |= dirty::kTexGen | dirty::kTextureParameters;
      break;
    case 4:
      glDepthRange(double(any[0]), double(any[1]));
      context.dirty |= dirty::kViewport;
      break;
    case 5:
      glPointSize(1 + any[0]);
      context.dirty |= dirty::kRaster;
      break;
    case 6:
      glEnable(GL_COLOR_MATERIAL);
      glColor4fv(any);
      context.dirty |= dirty::kCurrent | dirty::kLighting;
      break;
    }
    clock.take(context.dirty);
    (void)values.update(context, clock, nullptr);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Vec4 wanted{};
      fetchState(context, rows[i], wanted.data());
      using Bits = std::array<std::uint32_t, 4>;
      ASSERT_EQ(std::bit_cast<Bits>(valueOf(values, sources[i])), std::bit_cast<Bits>(wanted))
          << "item " << int(rows[i].item) << " row " << int(rows[i].row) << " modifier "
          << int(rows[i].modifier) << " in round " << round;
    }
  }
  EXPECT_EQ(glGetError(), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace arbiter::state
