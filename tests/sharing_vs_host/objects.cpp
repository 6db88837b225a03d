// Defines the storage of objects from random numbers.
#include <algorithm>

#include "world.h"

namespace sharing {

void World::define(Texture &texture, int width, int height, GLenum internal, Random &random) {
  std::vector<unsigned char> texels(std::size_t(width * height) * 4);
  for (unsigned char &texel : texels)
    texel = static_cast<unsigned char>(random.bits());
  bindTexture(texture.name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  // Decoded sRGB values differ in the last bits; run_formats.py of ../rasterizer_vs_host tests
  // them.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_SRGB_DECODE_EXT, GL_SKIP_DECODE_EXT);
  glTexImage2D(GL_TEXTURE_2D, 0, GLint(internal), width, height, 0,
               random.once(2) ? GL_RGBA : GL_BGRA, GL_UNSIGNED_BYTE, texels.data());
  texture.width = width;
  texture.height = height;
  texture.internal = internal;
  texture.version = ++m_version;
}

void World::defineRenderbuffer(Renderbuffer &renderbuffer, GLenum internal, int width, int height) {
  const bool depth = internal != GL_RGBA8;
  glBindRenderbuffer(GL_RENDERBUFFER, renderbuffer.name);
  glRenderbufferStorage(GL_RENDERBUFFER, internal, width, height);
  renderbuffer.internal = internal;
  renderbuffer.width = width;
  renderbuffer.height = height;
  renderbuffer.version = ++m_version;
  // The new storage is undefined.
  glBindFramebuffer(GL_FRAMEBUFFER, context().scratch);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, renderbuffer.point(), GL_RENDERBUFFER,
                            renderbuffer.name);
  glDrawBuffer(depth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  glReadBuffer(depth ? GL_NONE : GL_COLOR_ATTACHMENT0);
  clearAll();
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, renderbuffer.point(), GL_RENDERBUFFER, 0);
  bindFramebuffer(context().bound);
}

std::vector<Vertex> randomQuads(int quads, Random &random) {
  std::vector<Vertex> vertices;
  for (int i = 0; i < quads; ++i) {
    // Edges are at multiples of a sixteenth, so that they meet pixel borders in every target.
    const int x = random.between(-8, 6), y = random.between(-8, 6);
    const int w = random.between(1, 8), h = random.between(1, 8);
    unsigned char rgba[4];
    for (unsigned char &component : rgba)
      component = static_cast<unsigned char>(random.bits());
    for (int corner = 0; corner < 4; ++corner) {
      const int right = corner == 1 || corner == 2, top = corner >= 2;
      // The whole quad samples one texel: no sample is near a texel's border in any size of
      // texture.
      vertices.push_back({float(x + right * w) / 8.0f,
                          float(y + top * h) / 8.0f,
                          float(random.between(-50, 50)) / 64.0f,
                          0.3f,
                          0.3f,
                          {rgba[0], rgba[1], rgba[2], rgba[3]}});
      vertices.back().z = vertices[std::size_t(4 * i)].z;
    }
  }
  return vertices;
}

void World::defineBuffer(int index, int quads, Random &random) {
  Buffer &buffer = group().buffers[std::size_t(index)];
  const std::vector<Vertex> vertices = randomQuads(quads, random);
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
               random.once(2) ? GL_STATIC_DRAW : GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  buffer.quads = quads;
  buffer.mapped = false;
  buffer.version = ++m_version;
}

void World::bind(GLenum target, Program &program) {
  program.users |= 1u << m_current;
  glBindProgramARB(target, 0);
  glBindProgramARB(target, program.name);
}

void World::load(Program &program, GLenum target, int text, Random &random) {
  if (program.name == 0)
    glGenProgramsARB(1, &program.name);
  const std::string source =
      target == GL_FRAGMENT_PROGRAM_ARB ? fragmentText(text) : vertexText(text);
  bind(target, program);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(source.size()), source.data());
  glProgramLocalParameter4fARB(target, 0, float(random.below(256)) / 255.0f,
                               float(random.below(256)) / 255.0f, float(random.below(256)) / 255.0f,
                               1);
  program.text = text;
  program.version = ++m_version;
}

} // namespace sharing
