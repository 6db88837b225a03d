// Commands on buffers that several contexts draw from, map and pack pixels to; and on program
// objects.
#include <algorithm>
#include <cstring>

#include "world.h"

namespace sharing {

namespace {

Buffer &anyBuffer(World &world, Random &random) {
  return world.group().buffers[std::size_t(random.below(kBuffers))];
}
GLsizeiptr bytesOf(const Buffer &buffer) {
  return GLsizeiptr(buffer.quads * 4 * int(sizeof(Vertex)));
}

void bufferData(World &world, Random &random, const std::string &) {
  const int index = random.below(kBuffers);
  const int quads = random.between(1, 6);
  if (!world.group().buffers[std::size_t(index)].mapped)
    world.defineBuffer(index, quads, random);
}

void bufferSubData(World &world, Random &random, const std::string &) {
  const Buffer &buffer = anyBuffer(world, random);
  const std::vector<Vertex> quad = randomQuads(1, random);
  if (buffer.mapped)
    return;
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name);
  glBufferSubData(GL_ARRAY_BUFFER,
                  GLintptr(std::size_t(4 * random.below(buffer.quads)) * sizeof(Vertex)),
                  GLsizeiptr(4 * sizeof(Vertex)), quad.data());
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void copyBuffer(World &world, Random &random, const std::string &) {
  const Buffer &from = anyBuffer(world, random), &to = anyBuffer(world, random);
  if (&from == &to || from.mapped || to.mapped)
    return;
  glBindBuffer(GL_COPY_READ_BUFFER, from.name);
  glBindBuffer(GL_COPY_WRITE_BUFFER, to.name);
  glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                      std::min(bytesOf(from), bytesOf(to)));
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
}

/// Maps a buffer in one context, and possibly unmaps it in another.
void mapBuffer(World &world, Random &random, const std::string &) {
  Buffer &buffer = anyBuffer(world, random);
  const std::vector<Vertex> quads = randomQuads(buffer.quads, random);
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name);
  if (!buffer.mapped) {
    buffer.pointer = glMapBuffer(GL_ARRAY_BUFFER, GL_READ_WRITE);
    buffer.mapped = buffer.pointer != nullptr;
  }
  if (buffer.mapped) {
    std::memcpy(buffer.pointer, quads.data(), quads.size() * sizeof(Vertex));
    if (!random.once(3)) {
      glUnmapBuffer(GL_ARRAY_BUFFER);
      buffer.mapped = false;
    }
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void deleteBuffer(World &world, Random &random, const std::string &) {
  const int index = random.below(kBuffers), quads = random.between(1, 4);
  Buffer &buffer = world.group().buffers[std::size_t(index)];
  glDeleteBuffers(1, &buffer.name);
  glGenBuffers(1, &buffer.name);
  world.defineBuffer(index, quads, random);
}

/// Packs pixels into a buffer, and unpacks them as texels of another shape.
void packAndUnpack(World &world, Random &random, const std::string &) {
  const int index = random.below(kTextures);
  const Texture &texture = world.texture(index);
  int width = 0, height = 0;
  if (!world.ready(width, height) || world.isAttached(index))
    return;
  width = std::min(width, texture.width);
  height = std::min(height, texture.height);
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
  glBufferData(GL_PIXEL_PACK_BUFFER, GLsizeiptr(width * height) * 4, nullptr, GL_STREAM_COPY);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  bindTexture(texture.name);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  glDeleteBuffers(1, &buffer);
}

/// Replaces a program, which contexts may have bound, by one with another text. It makes a new
/// object: Mesa 22.3.6 crashes in the next draw if an object with a text gets another. It also
/// crashes in a context that drew with a program that another context deleted.
void loadProgram(World &world, Random &random, const std::string &) {
  const bool fragment = !random.once(3);
  Group &group = world.group();
  const int text = random.below(fragment ? kFragmentTexts : kVertexTexts);
  Program &program = fragment ? group.fragments[std::size_t(random.below(kFragmentPrograms))]
                              : group.vertices[std::size_t(random.below(kVertexPrograms))];
  if (!world.isUsedElsewhere(program))
    glDeleteProgramsARB(1, &program.name);
  program = {};
  world.load(program, fragment ? GL_FRAGMENT_PROGRAM_ARB : GL_VERTEX_PROGRAM_ARB, text, random);
}

void localParameter(World &world, Random &random, const std::string &) {
  Program &program = world.group().fragments[std::size_t(random.below(kFragmentPrograms))];
  world.bind(GL_FRAGMENT_PROGRAM_ARB, program);
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, float(random.below(256)) / 255.0f, 0.4f,
                               0.8f, 1);
}

} // namespace

const std::vector<Command> kBufferCommands = {
    {"BufferData", 4, bufferData},        {"BufferSubData", 4, bufferSubData},
    {"CopyBufferSubData", 2, copyBuffer}, {"MapBuffer", 4, mapBuffer},
    {"DeleteBuffers", 2, deleteBuffer},   {"pixel buffer", 2, packAndUnpack},
};

const std::vector<Command> kProgramCommands = {
    {"ProgramString", 5, loadProgram},
    {"ProgramLocalParameter", 3, localParameter},
};

} // namespace sharing
