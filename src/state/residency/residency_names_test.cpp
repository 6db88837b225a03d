// Tests residency where another context of the share group deleted objects that are bound here.
// They live on, without their names.
#include "state/capabilities/host_integer.h"
#include "state/core/texture_binding.h"
#include "state/residency/residency.h"
#include "state/residency/testing/residency_scene.h"
#include "state/share/share_group.h"

namespace arbiter::state::residency_scene {
namespace {

using Kind = DeletedNames::Kind;

class ResidencyOfNames : public Residency {
protected:
  /// Deletes the object in another context.
  void takeAway(Kind kind, GLuint name) {
    context().group->deletedNames.add(kind, 1, &name, context().serial + 1);
    inNeighbour([&] {
      if (kind == Kind::Texture)
        gl().DeleteTextures(1, &name);
      else
        reinterpret_cast<PFNGLDELETERENDERBUFFERSPROC>(hostFunction("glDeleteRenderbuffers"))(
            1, &name);
    });
  }
  GLint boundWidth() {
    GLint width = 0;
    gl().GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    return width;
  }
  GLint boundRenderbufferWidth() {
    GLint width = 0;
    gl().GetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_WIDTH, &width);
    return width;
  }
  GLuint renderbuffer(int width, int height) {
    GLuint name = 0;
    reinterpret_cast<PFNGLGENRENDERBUFFERSPROC>(hostFunction("glGenRenderbuffers"))(1, &name);
    gl().BindRenderbuffer(GL_RENDERBUFFER, name);
    reinterpret_cast<PFNGLRENDERBUFFERSTORAGEPROC>(hostFunction("glRenderbufferStorage"))(
        GL_RENDERBUFFER, GL_RGBA8, width, height);
    return name;
  }
};

TEST_F(ResidencyOfNames, ATextureWithoutANameStaysBound) {
  const GLuint feedback = texture(GL_RGBA8, kWidth, kHeight);
  drawAll(0x10203040);
  ASSERT_TRUE(copy(0, 0, 0, 0, kWidth, kHeight));
  const GLuint bound = texture(GL_RGBA8, 8, 8);
  takeAway(Kind::Texture, bound);
  ASSERT_EQ(boundTexture(), bound) << "the host names it still";
  residency().synchronise("the test"); // moves the texels of `feedback`
  EXPECT_EQ(boundWidth(), 8) << "bound by its name it is another texture, without an image";
  EXPECT_EQ(sampled(feedback, 2, 2), 0x10203040u);
  EXPECT_EQ(boundWidth(), 8);
  GLint unit = 0;
  gl().GetIntegerv(GL_ACTIVE_TEXTURE, &unit);
  EXPECT_EQ(unit, GL_TEXTURE0);
  gl().BindTexture(GL_TEXTURE_2D, feedback);
  EXPECT_EQ(hostTexel(3, 3, kWidth, kHeight), 0x10203040u);
}

TEST_F(ResidencyOfNames, ANameTakenAwayWhileTheLayerBindsAnotherIsNotBoundAnew) {
  const GLuint another = texture(GL_RGBA8, 4, 4);
  const GLuint bound = texture(GL_RGBA8, 8, 8);
  context().group->contexts.fetch_add(1);
  {
    const TextureBinding binding(gl(), GL_TEXTURE_2D, another, sharingOf(context()));
    EXPECT_EQ(boundWidth(), 4);
    takeAway(Kind::Texture, bound);
  }
  EXPECT_EQ(boundTexture(), bound);
  EXPECT_EQ(boundWidth(), 8);
  EXPECT_EQ(hostInteger(gl(), GL_ACTIVE_TEXTURE), GL_TEXTURE0);
  context().group->contexts.fetch_sub(1);
}

TEST_F(ResidencyOfNames, ANameTakenAwayWhileTheLayerBindsItIsStillTheObject) {
  const GLuint drawn = texture(GL_RGBA8, 8, 8);
  gl().ActiveTexture(GL_TEXTURE1);
  (void)texture(GL_RGBA8, 4, 4);
  context().group->contexts.fetch_add(1);
  {
    const TextureBinding binding(gl(), GL_TEXTURE_2D, drawn, sharingOf(context()));
    EXPECT_EQ(hostInteger(gl(), GL_ACTIVE_TEXTURE), GL_TEXTURE0) << "where it is bound already";
    takeAway(Kind::Texture, drawn);
    EXPECT_EQ(boundWidth(), 8);
  }
  EXPECT_EQ(hostInteger(gl(), GL_ACTIVE_TEXTURE), GL_TEXTURE1);
  EXPECT_EQ(boundWidth(), 4);
  context().group->contexts.fetch_sub(1);
}

TEST_F(ResidencyOfNames, TexelsOfANameThatWasTakenAwayBeforeAreNotLost) {
  const GLuint name = texture(GL_RGBA8, kWidth, kHeight);
  (void)framebufferOf(name);
  drawAll(0x10203040);
  // An earlier object had the name, and either may be bound under it.
  context().group->deletedNames.add(Kind::Texture, 1, &name, context().serial + 1);
  const std::uint8_t texel[] = {1, 2, 3, 4};
  residency().texSubImage(GL_TEXTURE_2D, 0, 3, 5, 0, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  gl().TexSubImage2D(GL_TEXTURE_2D, 0, 3, 5, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel);
  EXPECT_EQ(hostTexel(3, 5, kWidth, kHeight), 0x01020304u);
  EXPECT_EQ(hostTexel(4, 5, kWidth, kHeight), 0x10203040u);
}

TEST_F(ResidencyOfNames, ARenderbufferWithoutANameStaysBound) {
  const GLuint target = renderbuffer(kWidth, kHeight);
  GLuint framebuffer = 0;
  gl().GenFramebuffers(1, &framebuffer);
  bindFramebuffer(framebuffer);
  gl().FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, target);
  takeAway(Kind::Renderbuffer, renderbuffer(8, 8));
  ASSERT_EQ(boundRenderbufferWidth(), 8);
  const char *reason = nullptr;
  EXPECT_EQ(residency().describeTargets(reason), nullptr) << "what is attached was never asked";
  EXPECT_EQ(boundRenderbufferWidth(), 8);
  // A name that exists can be bound again.
  gl().BindRenderbuffer(GL_RENDERBUFFER, 0);
  changed();
  drawAll(0x0A0B0C0D);
  EXPECT_EQ(hostPixel(2, 2), 0x0A0B0C0Du);
}

} // namespace
} // namespace arbiter::state::residency_scene
