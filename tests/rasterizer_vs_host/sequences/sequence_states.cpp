#include "world.h"

namespace software {

namespace {

void enable(GLenum what, bool on) {
  if (on)
    glEnable(what);
  else
    glDisable(what);
}

void scissor(World &, Random &random, const std::string &) {
  enable(GL_SCISSOR_TEST, random.once(3));
  const int x = random.below(24), y = random.below(24);
  glScissor(x, y, random.between(8, 40), random.between(8, 40));
}

void colorMask(World &, Random &random, const std::string &) {
  const bool all = !random.once(3);
  const auto any = [&] { return GLboolean(all || random.once(2) ? GL_TRUE : GL_FALSE); };
  const GLboolean r = any(), g = any(), b = any(), a = any();
  glColorMask(r, g, b, a);
}

/// Sets only exact blending: saturating sums, and bits.
void blend(World &, Random &random, const std::string &) {
  enable(GL_BLEND, random.once(3));
  enable(GL_COLOR_LOGIC_OP, random.once(6));
  glLogicOp(random.once(2) ? GL_XOR : GL_COPY_INVERTED);
  static constexpr GLenum kEquations[] = {GL_FUNC_ADD, GL_FUNC_REVERSE_SUBTRACT, GL_MIN, GL_MAX};
  glBlendEquation(random.pick(kEquations));
  glBlendFunc(GL_ONE, random.once(4) ? GL_ZERO : GL_ONE);
}

void depth(World &, Random &random, const std::string &) {
  static constexpr GLenum kFunctions[] = {GL_LESS,   GL_LEQUAL, GL_GREATER,
                                          GL_GEQUAL, GL_ALWAYS, GL_NOTEQUAL};
  enable(GL_DEPTH_TEST, random.once(2));
  glDepthFunc(random.pick(kFunctions));
  glDepthMask(random.once(4) ? GL_FALSE : GL_TRUE);
}

void stencil(World &, Random &random, const std::string &) {
  static constexpr GLenum kFunctions[] = {GL_ALWAYS, GL_EQUAL, GL_NOTEQUAL, GL_LESS};
  static constexpr GLenum kOperations[] = {GL_KEEP, GL_REPLACE, GL_INCR, GL_INVERT, GL_DECR_WRAP};
  enable(GL_STENCIL_TEST, random.once(3));
  glStencilFunc(random.pick(kFunctions), random.below(4), random.once(2) ? 3u : ~0u);
  const GLenum fail = random.pick(kOperations), depthFail = random.pick(kOperations);
  glStencilOp(fail, depthFail, random.pick(kOperations));
  glStencilMask(random.once(3) ? 1u : ~0u);
}

void bindFramebuffer(World &world, Random &random, const std::string &) {
  world.bindFramebuffer(random.between(-1, 1));
}

void attach(World &world, Random &random, const std::string &) {
  const int framebuffer = random.below(2), texture = random.between(-1, kRectangle - 1);
  const int level = random.once(5) ? 1 : 0;
  if (texture < 0 || world.texture(texture).width[std::size_t(level)] > 0)
    world.attach(framebuffer, texture, level);
}

void switchContext(World &world, Random &random, const std::string &) {
  const int context = random.below(3);
  world.switchTo(context, random.once(4) ? 1 : 0);
}

void swap(World &world, Random &, const std::string &what) { world.swap(what); }

void flush(World &, Random &random, const std::string &) {
  if (random.once(2))
    glFlush();
  else
    glFinish();
}

void push(World &, Random &random, const std::string &) {
  glPushAttrib(random.once(2) ? GL_ALL_ATTRIB_BITS : GL_COLOR_BUFFER_BIT | GL_TEXTURE_BIT);
}

void pop(World &world, Random &, const std::string &) {
  glPopAttrib();
  world.fit();
}

void textureParameters(World &world, Random &random, const std::string &) {
  const int texture = random.below(kRectangle);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, world.texture(texture).name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  random.once(3) ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
  static constexpr GLenum kWraps[] = {GL_REPEAT, GL_CLAMP_TO_EDGE, GL_MIRRORED_REPEAT, GL_CLAMP};
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GLint(random.pick(kWraps)));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GLint(random.pick(kWraps)));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, random.once(6) ? 1 : 0);
}

} // namespace

const std::vector<Command> kStateCommands = {
    {"scissor", 2, scissor},
    {"color mask", 2, colorMask},
    {"blend", 2, blend},
    {"depth", 3, depth},
    {"stencil", 2, stencil},
    {"BindFramebuffer", 8, bindFramebuffer},
    {"FramebufferTexture", 4, attach},
    {"MakeCurrent", 3, switchContext},
    {"SwapBuffers", 4, swap},
    {"Flush", 2, flush},
    {"PushAttrib", 1, push},
    {"PopAttrib", 1, pop},
    {"TexParameter", 2, textureParameters},
};

} // namespace software
