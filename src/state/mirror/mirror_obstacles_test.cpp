// Draws under a driver's own shading extensions must stay with the host.
#include <gtest/gtest.h>

#include "state/mirror/mirror.h"
#include "state/mirror/mirror_groups.h"
#include "state/testing/fake_host.h"

namespace arbiter::state {
namespace {

class DriversExtensions : public ::testing::Test {
protected:
  DriversExtensions() { m_host.integers[GL_RENDER_MODE] = GL_RENDER; }
  [[nodiscard]] const char *obstacle() {
    Mirror mirror(*m_host.table(), m_caps);
    queryObstacles(m_caps, {*m_host.table()}, mirror);
    return mirror.obstacle;
  }
  testing::FakeHost m_host;
  HostCaps m_caps;
};

TEST_F(DriversExtensions, KeepDrawsWithTheHostWhileTheyAreEnabled) {
  const std::pair<const char *, GLenum> rows[] = {
      {"GL_NV_register_combiners", GL_REGISTER_COMBINERS_NV},
      {"GL_NV_texture_shader", GL_TEXTURE_SHADER_NV},
      {"GL_NV_fragment_program", GL_FRAGMENT_PROGRAM_NV}};
  for (const auto &[extension, cap] : rows) {
    m_caps.extensions = {extension};
    EXPECT_EQ(obstacle(), nullptr) << extension;
    m_host.enabled.insert(cap);
    EXPECT_STREQ(obstacle(), "state") << extension;
    m_caps.extensions = {};
    EXPECT_EQ(obstacle(), nullptr) << "the host has no " << extension;
    m_host.enabled.clear();
  }
}

TEST_F(DriversExtensions, SoDoesTheThirdCoordinateOfPoints) {
  m_caps.extensions = {"GL_NV_point_sprite"};
  m_host.integers[GL_POINT_SPRITE_R_MODE_NV] = GL_S;
  EXPECT_EQ(obstacle(), nullptr) << "points are none";
  m_host.enabled.insert(GL_POINT_SPRITE);
  EXPECT_STREQ(obstacle(), "state");
  m_host.integers[GL_POINT_SPRITE_R_MODE_NV] = GL_ZERO;
  EXPECT_EQ(obstacle(), nullptr);
}

TEST_F(DriversExtensions, AHostOnTheProcessorIsNotAsked) {
  m_caps.extensions = {"GL_NV_register_combiners", "GL_NV_point_sprite"};
  m_caps.onProcessor = true;
  EXPECT_EQ(obstacle(), nullptr);
  EXPECT_EQ(m_host.count("IsEnabled"), 0);
}

} // namespace
} // namespace arbiter::state
