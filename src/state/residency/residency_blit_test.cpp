// Compares BlitFramebuffer in memory with the host's.
#include <random>

#include "state/raster_draw/context_state.h"
#include "state/residency/residency.h"
#include "state/residency/testing/residency_scene.h"

namespace arbiter::state::residency_scene {
namespace {

class Blit : public Residency {
protected:
  void SetUp() override {
    Residency::SetUp();
    make(GL_RGBA8);
  }
  void make(GLenum sourceFormat) {
    m_source = texture(sourceFormat, kWidth, kHeight);
    m_target = texture(GL_RGBA8, kWidth, kHeight);
    m_reference = texture(GL_RGBA8, kWidth, kHeight);
    m_from = framebufferOf(m_source);
    m_to = framebufferOf(m_target);
    m_host = framebufferOf(m_reference);
  }
  /// Gives the source a colour per pixel and the targets a single colour. Source and target are
  /// pending.
  void draw() {
    bindFramebuffer(m_host);
    drawAll(0x55667788);
    residency().synchronise("test");
    bindFramebuffer(m_from);
    for (int y = 0; y < kHeight; y += 3)
      for (int x = 0; x < kWidth; x += 5)
        Residency::draw({x, y, 5, 3}, std::uint32_t(x) << 24 | std::uint32_t(y) << 16 | 0x99);
    bindFramebuffer(m_to);
    drawAll(0x55667788);
  }
  void bind(GLuint read, GLuint target) {
    gl().BindFramebufferEXT(GL_READ_FRAMEBUFFER, read);
    gl().BindFramebufferEXT(GL_DRAW_FRAMEBUFFER, target);
    changed();
  }
  bool blit(const FramebufferBlit &command) {
    bind(m_from, m_to);
    return residency().blit(command);
  }
  Bytes texels(GLuint name) {
    residency().synchronise("test");
    Bytes bytes(std::size_t(kWidth) * kHeight * 4);
    gl().BindTexture(GL_TEXTURE_2D, name);
    gl().GetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
  }
  /// Blits to the reference on the host, which then has the source.
  Bytes byHost(const FramebufferBlit &command) {
    residency().synchronise("test");
    bind(m_from, m_host);
    gl().BlitFramebuffer(command.from.x0, command.from.y0, command.from.x1, command.from.y1,
                         command.to.x0, command.to.y0, command.to.x1, command.to.y1, command.mask,
                         command.filter);
    return texels(m_reference);
  }

  GLuint m_source = 0, m_target = 0, m_reference = 0, m_from = 0, m_to = 0, m_host = 0;
};

constexpr FramebufferBlit kWhole = {
    {0, 0, kWidth, kHeight}, {0, kHeight, kWidth, 0}, GL_COLOR_BUFFER_BIT, GL_NEAREST};

TEST_F(Blit, GivesThePixelsOfTheHosts) {
  std::mt19937 random(3);
  const auto below = [&](int end) { return int(random() % unsigned(end)); };
  int done = 0; // the other blits copy no pixel
  for (int i = 0; i < 60; ++i) {
    draw();
    const int width = 1 + below(kWidth), height = 1 + below(kHeight);
    const int x = below(kWidth) - 8, y = below(kHeight) - 8;
    const int toX = below(kWidth) - 8, toY = below(kHeight) - 8;
    FramebufferBlit command = {{x, y, x + width, y + height},
                               {toX, toY, toX + width, toY + height},
                               GL_COLOR_BUFFER_BIT,
                               below(2) == 0 ? GLenum(GL_NEAREST) : GLenum(GL_LINEAR)};
    if (below(2) == 0)
      std::swap(command.from.y0, command.from.y1);
    if (below(3) == 0)
      std::swap(command.to.y0, command.to.y1);
    if (i % 4 == 0) {
      gl().Enable(GL_SCISSOR_TEST);
      gl().Scissor(5, 7, 40, 30);
    }
    const std::uint64_t uploads = statistics().uploads;
    if (blit(command)) {
      EXPECT_EQ(statistics().uploads, uploads) << "pixels went to the host";
      gl().Disable(GL_SCISSOR_TEST);
      const Bytes mine = texels(m_target);
      if (i % 4 == 0)
        gl().Enable(GL_SCISSOR_TEST);
      EXPECT_EQ(mine, byHost(command)) << "blit " << i;
      ++done;
    }
    gl().Disable(GL_SCISSOR_TEST);
  }
  EXPECT_GT(done, 45);
  draw();
  ASSERT_TRUE(blit(kWhole));
  const Bytes mine = texels(m_target);
  EXPECT_EQ(mine, byHost(kWhole));
}

TEST_F(Blit, ASourceWithoutAlphaGivesOne) {
  make(GL_RGB8);
  draw();
  ASSERT_TRUE(blit(kWhole));
  const Bytes mine = texels(m_target);
  EXPECT_EQ(mine[3], 255);
  EXPECT_EQ(mine, byHost(kWhole));
}

TEST_F(Blit, LeavesToTheHostWhatIsNoPlainMove) {
  draw();
  FramebufferBlit command = kWhole;
  command.from.x1 = kWidth / 2;
  EXPECT_FALSE(blit(command)) << "stretched";
  command = kWhole;
  std::swap(command.to.x0, command.to.x1);
  EXPECT_FALSE(blit(command)) << "mirrored";
  command = kWhole;
  command.mask |= GL_DEPTH_BUFFER_BIT;
  EXPECT_FALSE(blit(command)) << "depth too";
  command = kWhole;
  command.filter = GL_LINEAR_MIPMAP_LINEAR;
  EXPECT_FALSE(blit(command)) << "an error that is the host's to raise";
  bind(m_from, m_from);
  EXPECT_FALSE(residency().blit(kWhole)) << "to itself";
}

} // namespace
} // namespace arbiter::state::residency_scene
