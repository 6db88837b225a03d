// Commands on textures, renderbuffers and framebuffers, and reads of pixels.
#include <algorithm>

#include "world.h"

namespace sharing {

namespace {

constexpr int kSizes[] = {8, 16, 32, 33, 64, 7, 1};
constexpr GLenum kInternal[] = {GL_RGBA8,      GL_RGBA8,  GL_RGB8,         GL_SRGB8_ALPHA8,
                                GL_LUMINANCE8, GL_ALPHA8, GL_SRGB8_ALPHA8, GL_SRGB8};
constexpr GLenum kDepths[] = {GL_DEPTH24_STENCIL8, GL_DEPTH_COMPONENT32};

void redefine(World &world, Random &random, const std::string &) {
  Texture &texture = world.texture(random.below(kTextures));
  const bool same = random.once(3); // of the same size, with other texels
  const int width = random.pick(kSizes), height = random.pick(kSizes);
  const GLenum internal = random.pick(kInternal);
  world.define(texture, same ? texture.width : width, same ? texture.height : height,
               same ? texture.internal : internal, random);
}

void subImage(World &world, Random &random, const std::string &) {
  const Texture &texture = world.texture(random.below(kTextures));
  const int width = random.between(1, texture.width), height = random.between(1, texture.height);
  const int x = random.between(0, texture.width - width);
  const int y = random.between(0, texture.height - height);
  bindTexture(texture.name);
  if (random.once(4)) {
    const float texel[] = {1, 0.6f, 0.2f, 0};
    return glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, 1, 1, GL_RGBA, GL_FLOAT, texel);
  }
  std::vector<unsigned char> texels(std::size_t(width * height) * 4);
  for (unsigned char &texel : texels)
    texel = static_cast<unsigned char>(random.bits());
  glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, width, height, random.once(2) ? GL_RGBA : GL_BGRA,
                  GL_UNSIGNED_BYTE, texels.data());
}

void deleteTexture(World &world, Random &random, const std::string &) {
  Texture &texture = world.texture(random.once(2) ? kKept : random.below(kTextures));
  const int width = random.pick(kSizes), height = random.pick(kSizes);
  const GLenum internal = random.pick(kInternal);
  world.orphan(true, &texture);
  glDeleteTextures(1, &texture.name);
  glGenTextures(1, &texture.name);
  world.define(texture, width, height, internal, random);
  world.bindFramebuffer(world.context().bound);
}

void feedback(World &world, Random &random, const std::string &) {
  const int index = random.below(kTextures);
  Texture &texture = world.texture(index);
  int width = 0, height = 0;
  if (!world.ready(width, height) || world.isAttached(index))
    return;
  width = std::min(width, texture.width);
  height = std::min(height, texture.height);
  if (random.once(3)) {
    width = random.between(1, width);
    height = random.between(1, height);
  }
  bindTexture(texture.name);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, texture.width - width, texture.height - height, 0, 0, width,
                      height);
}

/// Changes TexParameter and restores it: with NEAREST_MIPMAP_NEAREST the texture is incomplete and
/// samples (0, 0, 0, 1).
void parameters(World &world, Random &random, const std::string &) {
  const Texture &texture = world.texture(random.below(kTextures));
  bindTexture(texture.name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S,
                  random.once(2) ? GL_REPEAT : GL_MIRRORED_REPEAT);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  random.once(3) ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
}

void getTexImage(World &world, Random &random, const std::string &what) {
  const Texture &texture = world.texture(random.below(kTextures));
  std::vector<unsigned char> bytes(std::size_t(texture.width * texture.height) * 4);
  bindTexture(texture.name);
  glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  record(what, bytes);
}

void readPixels(World &world, Random &random, const std::string &what) {
  int width = 0, height = 0;
  const bool part = random.once(3);
  if (world.ready(width, height))
    record(what, software::readRgba(0, 0, part ? (width + 1) / 2 : width, height));
}

void bindFramebuffer(World &world, Random &random, const std::string &) {
  world.bindFramebuffer(random.between(-1, kFramebuffers - 1));
}

/// Blits half of a window's or framebuffer's colors to another.
void blit(World &world, Random &random, const std::string &) {
  const int to = random.between(-1, kFramebuffers - 1);
  Context &context = world.context();
  const int before = context.bound;
  int width = 0, height = 0, toWidth = 0, toHeight = 0;
  if (to == before || !world.ready(width, height))
    return;
  world.bindFramebuffer(to);
  if (world.ready(toWidth, toHeight)) {
    // If both have the texture, it is a feedback loop.
    const Attachment from =
        before < 0 ? Attachment() : context.framebuffers[std::size_t(before)].color;
    const Attachment other = to < 0 ? Attachment() : context.framebuffers[std::size_t(to)].color;
    const bool loop =
        from.index >= 0 && from.index == other.index && from.isTexture == other.isTexture;
    if (!loop) {
      glBindFramebuffer(GL_READ_FRAMEBUFFER,
                        before < 0 ? 0 : context.framebuffers[std::size_t(before)].name);
      const int w = std::min(width, toWidth), h = std::min(height, toHeight);
      glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
  }
  world.bindFramebuffer(before);
}

void attach(World &world, Random &random, const std::string &) {
  Framebuffer &framebuffer = world.context().framebuffers[std::size_t(random.below(kFramebuffers))];
  const bool depth = random.once(4), isTexture = !depth && random.once(2);
  const int index = isTexture ? random.below(kTextures) : random.below(kRenderbuffers);
  world.attach(framebuffer, depth, isTexture, depth && random.once(3) ? -1 : index);
  world.bindFramebuffer(world.context().bound);
}

void renderbuffer(World &world, Random &random, const std::string &) {
  static constexpr int kEdges[] = {64, 32, 16};
  const bool depth = random.once(2), deleted = random.once(4);
  const int width = random.pick(kEdges), height = random.pick(kEdges);
  const GLenum internal = depth ? random.pick(kDepths) : GLenum(GL_RGBA8);
  Group &group = world.group();
  Renderbuffer &renderbuffer =
      (depth ? group.depths : group.colors)[std::size_t(random.below(kRenderbuffers))];
  if (deleted) {
    world.orphan(false, &renderbuffer);
    glDeleteRenderbuffers(1, &renderbuffer.name);
    glGenRenderbuffers(1, &renderbuffer.name);
  }
  world.defineRenderbuffer(renderbuffer, internal, width, height);
}

} // namespace

const std::vector<Command> kTextureCommands = {
    {"TexImage", 9, redefine},
    {"TexSubImage", 8, subImage},
    {"DeleteTextures", 5, deleteTexture},
    {"CopyTexSubImage", 8, feedback},
    {"TexParameter", 3, parameters},
    {"GetTexImage", 4, getTexImage},
    {"ReadPixels", 8, readPixels},
    {"BindFramebuffer", 8, bindFramebuffer},
    {"BlitFramebuffer", 2, blit},
    {"Framebuffer attachment", 5, attach},
    {"RenderbufferStorage", 3, renderbuffer},
};

} // namespace sharing
