#include "world.h"

#include <algorithm>

namespace software {

namespace {

struct Rectangle {
  int x, y, width, height;
};

/// Returns a rectangle inside width x height, sometimes all of it.
Rectangle randomRectangle(int width, int height, Random &random) {
  if (random.once(3))
    return {0, 0, width, height};
  const int x = random.below(width), y = random.below(height);
  return {x, y, random.between(1, width - x), random.between(1, height - y)};
}

std::vector<unsigned char> randomBytes(std::size_t count, Random &random) {
  std::vector<unsigned char> bytes(count);
  for (unsigned char &byte : bytes)
    byte = static_cast<unsigned char>(random.bits());
  return bytes;
}

void bind(World &world, int texture) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(World::targetOf(texture), world.texture(texture).name);
}

/// Copies to level 0 or 1, whole or in part; the source may start anywhere.
void copySubImage(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  const int texture = random.below(kTextures);
  const auto level = std::size_t(random.once(5) ? 1 : 0);
  const Texture &image = world.texture(texture);
  if (!world.size(width, height) || world.attached(texture) || image.width[level] == 0)
    return;
  bind(world, texture);
  Rectangle to = randomRectangle(image.width[level], image.height[level], random);
  to.width = std::min(to.width, width);
  to.height = std::min(to.height, height);
  const int x = random.once(2) ? 0 : random.between(0, width - to.width);
  const int y = random.once(2) ? 0 : random.between(0, height - to.height);
  glCopyTexSubImage2D(World::targetOf(texture), GLint(level), to.x, to.y, x, y, to.width,
                      to.height);
}

void copyImage(World &world, Random &random, const std::string &) {
  static constexpr GLenum kInternal[] = {GL_RGBA8, GL_RGBA, GL_RGB8, GL_LUMINANCE8, GL_ALPHA8};
  int width = 0, height = 0;
  const int texture = random.below(kTextures);
  if (!world.size(width, height) || world.attached(texture))
    return;
  bind(world, texture);
  const Rectangle from = randomRectangle(width, height, random);
  const GLenum internal = random.pick(kInternal);
  glCopyTexImage2D(World::targetOf(texture), 0, internal, from.x, from.y, from.width, from.height,
                   0);
  world.texture(texture).internal = internal;
  world.texture(texture).width[0] = from.width;
  world.texture(texture).height[0] = from.height;
  world.dropLevel1(texture);
  world.fit(); // another framebuffer may have it
}

/// A format of an application's pixels, and the bytes of one pixel.
struct PixelKind {
  GLenum format, type;
  int bytes;
};
constexpr PixelKind kPixelKinds[] = {
    {GL_RGBA, GL_UNSIGNED_BYTE, 4},
    {GL_BGRA, GL_UNSIGNED_BYTE, 4},
    {GL_RGB, GL_UNSIGNED_BYTE, 3},
    {GL_BGR, GL_UNSIGNED_BYTE, 3},
    {GL_RED, GL_UNSIGNED_BYTE, 1},
    {GL_GREEN, GL_UNSIGNED_BYTE, 1},
    {GL_BLUE, GL_UNSIGNED_BYTE, 1},
    {GL_ALPHA, GL_UNSIGNED_BYTE, 1},
    {GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
    {GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
    {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8, 4},
    {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8, 4},
    {GL_RGBA, GL_UNSIGNED_INT_8_8_8_8_REV, 4},
    {GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, 4},
    {GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
    {GL_RGBA, GL_UNSIGNED_SHORT, 8},
};

/// Uploads with random unpack state: rows longer than the image, skipped parts, scales, a buffer.
void subImageAnyhow(World &world, Random &random, const std::string &) {
  const int texture = random.below(kTextures);
  const auto level = std::size_t(random.once(5) ? 1 : 0);
  const Texture &image = world.texture(texture);
  if (image.width[level] == 0)
    return;
  bind(world, texture);
  const Rectangle to = randomRectangle(image.width[level], image.height[level], random);
  const PixelKind kind = random.pick(kPixelKinds);
  const int rowLength = random.once(2) ? 0 : to.width + random.below(5);
  const int skipRows = random.below(3), skipPixels = random.below(3);
  const int row = std::max(rowLength, to.width) + skipPixels;
  const auto bytes = randomBytes(
      std::size_t(row * kind.bytes + 8) * std::size_t(to.height + skipRows + 1), random);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, rowLength);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, skipRows);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, skipPixels);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1 << random.below(4));
  // Mesa 22.3.6 swaps as many bytes as it would read if nothing were skipped.
  const bool swaps = random.once(4) && rowLength == 0 && skipRows == 0 && skipPixels == 0;
  glPixelStorei(GL_UNPACK_SWAP_BYTES, swaps ? GL_TRUE : GL_FALSE);
  const bool scaled = random.once(10), fromBuffer = random.once(8);
  if (scaled)
    glPixelTransferf(GL_RED_SCALE, 0);
  const void *from = bytes.data();
  if (fromBuffer) {
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, world.context().vertexBuffer);
    glBufferData(GL_PIXEL_UNPACK_BUFFER, GLsizeiptr(bytes.size()), from, GL_STREAM_DRAW);
    from = nullptr;
  }
  // Sometimes it is outside: an error that changes nothing.
  const int x = random.once(10) ? to.x + 40 : to.x;
  glTexSubImage2D(World::targetOf(texture), GLint(level), x, to.y, to.width, to.height, kind.format,
                  kind.type, from);
  if (fromBuffer)
    glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glPixelTransferf(GL_RED_SCALE, 1);
  for (const GLenum name :
       {GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SWAP_BYTES})
    glPixelStorei(name, 0);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
}

void subImage(World &world, Random &random, const std::string &) {
  static constexpr GLenum kFormats[] = {GL_RGBA, GL_RGBA, GL_BGRA, GL_RGB, GL_LUMINANCE, GL_ALPHA};
  const int texture = random.below(kTextures);
  const auto level = std::size_t(random.once(5) ? 1 : 0);
  const Texture &image = world.texture(texture);
  if (image.width[level] == 0)
    return;
  bind(world, texture);
  const Rectangle to = randomRectangle(image.width[level], image.height[level], random);
  const auto bytes = randomBytes(std::size_t(to.width * to.height) * 4, random);
  glTexSubImage2D(World::targetOf(texture), GLint(level), to.x, to.y, to.width, to.height,
                  random.pick(kFormats), GL_UNSIGNED_BYTE, bytes.data());
}

void texImage(World &world, Random &random, const std::string &) {
  const int texture = random.below(kTextures);
  glActiveTexture(GL_TEXTURE0);
  if (!random.once(4) || texture == kRectangle || !world.defineLevel1(texture, random))
    world.redefine(texture, random);
  world.fit();
}

void deleteTexture(World &world, Random &random, const std::string &) {
  glActiveTexture(GL_TEXTURE0);
  world.deleteTexture(random.below(kTextures), random);
}

void generateMipmap(World &world, Random &random, const std::string &) {
  const int texture = random.below(kRectangle);
  Texture &image = world.texture(texture);
  bind(world, texture);
  glGenerateMipmap(GL_TEXTURE_2D);
  // Mesa 22.3.6 gives it new storage and keeps drawing to the old one until it is attached again.
  world.orphan(texture);
  const bool smallest = image.width[0] == 1 && image.height[0] == 1;
  image.width[1] = smallest ? 0 : std::max(1, image.width[0] / 2);
  image.height[1] = smallest ? 0 : std::max(1, image.height[0] / 2);
  world.fit();
}

void readPixels(World &world, Random &random, const std::string &what) {
  static constexpr GLenum kFormats[] = {GL_RGBA, GL_RGBA, GL_BGRA,
                                        GL_RGB,  GL_RED,  GL_STENCIL_INDEX};
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const Rectangle from = randomRectangle(width, height, random);
  std::vector<unsigned char> bytes(std::size_t(from.width * from.height) * 4 +
                                   std::size_t(from.height) * 8);
  glPixelStorei(GL_PACK_ALIGNMENT, 1 << random.below(4));
  glReadPixels(from.x, from.y, from.width, from.height, random.pick(kFormats), GL_UNSIGNED_BYTE,
               bytes.data());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  record(what, bytes);
}

/// Reads sixteen bits of the depth, as the last of 24 are subject to rounding.
void readDepth(World &world, Random &random, const std::string &what) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const Rectangle from = randomRectangle(width, height, random);
  std::vector<GLuint> depths(std::size_t(from.width) * std::size_t(from.height));
  glReadPixels(from.x, from.y, from.width, from.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
               depths.data());
  std::vector<unsigned char> bytes;
  for (const GLuint depth : depths)
    bytes.push_back(static_cast<unsigned char>((std::uint64_t(depth) + (1u << 23)) >> 24));
  record(what, bytes);
}

void getTexImage(World &world, Random &random, const std::string &what) {
  const int texture = random.below(kTextures);
  const auto level = std::size_t(random.once(4) ? 1 : 0);
  const Texture &image = world.texture(texture);
  if (image.width[level] == 0)
    return;
  bind(world, texture);
  std::vector<unsigned char> bytes(std::size_t(image.width[level] * image.height[level]) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(World::targetOf(texture), GLint(level), random.once(2) ? GL_RGBA : GL_BGRA,
                GL_UNSIGNED_BYTE, bytes.data());
  record(what, bytes);
}

void clear(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  glClearColor(float(random.below(256)) / 255.0f, float(random.below(256)) / 255.0f,
               float(random.below(256)) / 255.0f, float(random.below(256)) / 255.0f);
  glClearDepth(float(random.below(9)) / 8.0f);
  glClearStencil(random.below(4));
  static constexpr GLbitfield kMasks[] = {GL_COLOR_BUFFER_BIT,
                                          GL_COLOR_BUFFER_BIT,
                                          GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                                          GL_DEPTH_BUFFER_BIT,
                                          GL_STENCIL_BUFFER_BIT,
                                          GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
                                              GL_STENCIL_BUFFER_BIT};
  glClear(random.pick(kMasks));
}

void drawPixels(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  const Rectangle to = randomRectangle(width, height, random);
  const auto bytes = randomBytes(std::size_t(to.width * to.height) * 4, random);
  glColor4f(1, 0, 1, 1);
  glWindowPos2i(to.x, to.y);
  switch (random.below(3)) {
  case 0:
    return glDrawPixels(to.width, to.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  case 1:
    return glBitmap(to.width, to.height, 0, 0, 0, 0, bytes.data());
  default: // the left half to the right
    glWindowPos2i(width / 2, 0);
    return glCopyPixels(0, 0, width / 2, height, GL_COLOR);
  }
}

void blit(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  const int bound = world.context().bound, other = bound == 0 ? 1 : 0;
  if (!world.size(width, height))
    return;
  world.bindFramebuffer(other);
  int otherWidth = 0, otherHeight = 0;
  const bool usable = world.size(otherWidth, otherHeight);
  world.bindFramebuffer(bound);
  const int shared = bound < 0 ? -2 : world.context().framebuffers[std::size_t(bound)].texture;
  if (!usable ||
      (shared >= 0 && shared == world.context().framebuffers[std::size_t(other)].texture))
    return;
  const Rectangle area =
      randomRectangle(std::min(width, otherWidth), std::min(height, otherHeight), random);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, world.context().framebuffers[std::size_t(other)].name);
  glBlitFramebuffer(area.x, area.y, area.x + area.width, area.y + area.height, area.x, area.y,
                    area.x + area.width, area.y + area.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  world.bindFramebuffer(bound);
}

} // namespace

const std::vector<Command> kPixelCommands = {
    {"CopyTexSubImage", 14, copySubImage},
    {"CopyTexImage", 5, copyImage},
    {"TexSubImage", 6, subImage},
    {"TexSubImage anyhow", 6, subImageAnyhow},
    {"TexImage", 4, texImage},
    {"DeleteTextures", 2, deleteTexture},
    {"GenerateMipmap", 2, generateMipmap},
    {"ReadPixels", 6, readPixels},
    {"ReadPixels depth", 2, readDepth},
    {"GetTexImage", 5, getTexImage},
    {"Clear", 7, clear},
    {"DrawPixels", 4, drawPixels},
    {"BlitFramebuffer", 3, blit},
};

} // namespace software
