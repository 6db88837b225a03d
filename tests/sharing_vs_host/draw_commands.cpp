// Clears and draws, with and without programs.
#include "world.h"

namespace sharing {

namespace {

bool chance(Random &random, int of) { return random.once(of); }

void clear(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  float rgba[4];
  for (float &component : rgba)
    component = float(random.below(256)) / 255.0f;
  const bool part = chance(random, 2), depth = chance(random, 2);
  if (!world.ready(width, height))
    return;
  if (part) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(random.below(8), random.below(8), random.between(1, width),
              random.between(1, height));
  }
  glClearColor(rgba[0], rgba[1], rgba[2], rgba[3]);
  glClear(GL_COLOR_BUFFER_BIT | (depth ? GLbitfield(GL_DEPTH_BUFFER_BIT) : 0u));
  glDisable(GL_SCISSOR_TEST);
}

/// Binds the programs of one draw again; returns the texture that it samples, or -1.
class Programs {
public:
  Programs(World &world, Random &random) {
    Group &group = world.group();
    const bool fragment = !random.once(8), vertex = random.once(3);
    Program &shades = group.fragments[std::size_t(random.below(kFragmentPrograms))];
    Program &places = group.vertices[std::size_t(random.below(kVertexPrograms))];
    const int texture = random.below(kTextures);
    const float env[] = {float(random.below(256)) / 255.0f, 0.2f, 0.6f, 1};
    m_possible = !world.isAttached(texture);
    if (!m_possible)
      return;
    bindTexture(world.texture(texture).name);
    if (fragment) {
      world.bind(GL_FRAGMENT_PROGRAM_ARB, shades);
      glProgramEnvParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, 1, env);
      glEnable(GL_FRAGMENT_PROGRAM_ARB);
    }
    if (vertex) {
      world.bind(GL_VERTEX_PROGRAM_ARB, places);
      glEnable(GL_VERTEX_PROGRAM_ARB);
    }
  }
  ~Programs() {
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    glDisable(GL_VERTEX_PROGRAM_ARB);
  }
  Programs(const Programs &) = delete;
  Programs &operator=(const Programs &) = delete;
  [[nodiscard]] bool possible() const { return m_possible; }

private:
  bool m_possible = false;
};

/// Sets a depth test. Depths are far apart, so that equal ones are never compared.
class Depth {
public:
  Depth(World &world, Random &random) {
    if (!random.once(3))
      return;
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(random.once(2) ? GL_LESS : GL_ALWAYS);
    static_cast<void>(world);
  }
  ~Depth() { glDisable(GL_DEPTH_TEST); }
  Depth(const Depth &) = delete;
  Depth &operator=(const Depth &) = delete;
};

void vertexAt(const Vertex &vertex) {
  glColor4ubv(vertex.rgba);
  glTexCoord2f(vertex.u, vertex.v);
  glVertex3f(vertex.x, vertex.y, vertex.z);
}

void drawImmediate(World &world, Random &random, const std::string &) {
  const std::vector<Vertex> quads = randomQuads(random.between(1, 3), random);
  int width = 0, height = 0;
  if (!world.readyToDraw(width, height))
    return;
  const Programs programs(world, random);
  if (!programs.possible())
    return;
  const Depth depth(world, random);
  glBegin(GL_QUADS);
  for (const Vertex &vertex : quads)
    vertexAt(vertex);
  glEnd();
}

/// Draws a quad over the whole target that shows the unit's whole texture, one texel for each
/// pixel.
void drawTexels(GLenum unit, int textureWidth, int textureHeight, int width, int height, float z) {
  // The offset is a quarter of a texel from its border.
  const float u0 = -0.25f / float(textureWidth), v0 = -0.25f / float(textureHeight);
  const float u1 = u0 + float(width) / float(textureWidth);
  const float v1 = v0 + float(height) / float(textureHeight);
  glColor4f(1, 0, 1, 1);
  glBegin(GL_QUADS);
  glMultiTexCoord2f(unit, u0, v0), glVertex3f(-1, -1, z);
  glMultiTexCoord2f(unit, u1, v0), glVertex3f(1, -1, z);
  glMultiTexCoord2f(unit, u1, v1), glVertex3f(1, 1, z);
  glMultiTexCoord2f(unit, u0, v1), glVertex3f(-1, 1, z);
  glEnd();
}

void drawTexture(World &world, Random &random, const std::string &) {
  const int index = random.below(kTextures);
  const Texture &texture = world.texture(index);
  const int sampling = random.below(kFragmentPrograms);
  int width = 0, height = 0;
  if (!world.readyToDraw(width, height) || world.isAttached(index))
    return;
  Program &program = world.group().fragments[std::size_t(sampling)];
  bindTexture(texture.name);
  world.bind(GL_FRAGMENT_PROGRAM_ARB, program);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  drawTexels(GL_TEXTURE0, texture.width, texture.height, width, height,
             float(random.between(-50, 50)) / 64.0f);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
}

/// Draws with the texture that unit 1 keeps, without a program, even if another context deleted it.
/// The unit stays active until a texture is bound.
void drawKept(World &world, Random &random, const std::string &) {
  Context &context = world.context();
  Kept &kept = context.kept;
  const bool renews = random.once(4);
  int width = 0, height = 0;
  if (!world.readyToDraw(width, height))
    return;
  glActiveTexture(GL_TEXTURE1);
  if (renews || !kept.orphan) {
    const Texture &texture = world.texture(kKept);
    kept = {true, false, texture.width, texture.height};
    glBindTexture(GL_TEXTURE_2D, texture.name);
  }
  const bool mayBeDrawnTo =
      kept.orphan
          ? context.bound >= 0 && context.framebuffers[std::size_t(context.bound)].color.orphan
          : world.isAttached(kKept);
  if (!mayBeDrawnTo) {
    glEnable(GL_TEXTURE_2D);
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
    drawTexels(GL_TEXTURE1, kept.width, kept.height, width, height, 0);
    glDisable(GL_TEXTURE_2D);
  }
}

void pointTo(const Vertex *base) {
  const auto *const at = reinterpret_cast<const char *>(base);
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), at + offsetof(Vertex, x));
  glTexCoordPointer(2, GL_FLOAT, sizeof(Vertex), at + offsetof(Vertex, u));
  glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), at + offsetof(Vertex, rgba));
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
    glEnableClientState(array);
}

void endArrays() {
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_COLOR_ARRAY})
    glDisableClientState(array);
}

void drawBuffer(World &world, Random &random, const std::string &) {
  const Buffer &buffer = world.group().buffers[std::size_t(random.below(kBuffers))];
  const int times = random.between(1, 3); // small buffers that are drawn from repeatedly are copied
  int width = 0, height = 0;
  if (buffer.mapped || !world.readyToDraw(width, height))
    return;
  const Programs programs(world, random);
  if (!programs.possible())
    return;
  const Depth depth(world, random);
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name);
  pointTo(nullptr);
  for (int i = 0; i < times; ++i)
    glDrawArrays(GL_QUADS, 0, 4 * buffer.quads);
  endArrays();
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void drawArrays(World &world, Random &random, const std::string &) {
  const std::vector<Vertex> quads = randomQuads(random.between(1, 3), random);
  int width = 0, height = 0;
  if (!world.readyToDraw(width, height))
    return;
  const Programs programs(world, random);
  if (!programs.possible())
    return;
  pointTo(quads.data());
  glDrawArrays(GL_QUADS, 0, GLsizei(quads.size()));
  endArrays();
}

void makeList(World &world, Random &random, const std::string &) {
  GLuint &list = world.group().lists[std::size_t(random.below(kLists))];
  const std::vector<Vertex> quads = randomQuads(random.between(1, 2), random);
  if (list != 0 && random.once(3)) {
    glDeleteLists(list, 1);
    list = 0;
  }
  if (list == 0)
    list = glGenLists(1);
  glNewList(list, GL_COMPILE);
  glBegin(GL_QUADS);
  for (const Vertex &vertex : quads)
    vertexAt(vertex);
  glEnd();
  glEndList();
}

void callList(World &world, Random &random, const std::string &) {
  const GLuint list = world.group().lists[std::size_t(random.below(kLists))];
  int width = 0, height = 0;
  if (list == 0 || !world.readyToDraw(width, height))
    return;
  const Programs programs(world, random);
  if (programs.possible())
    glCallList(list);
}

} // namespace

const std::vector<Command> kDrawCommands = {
    {"Clear", 7, clear},
    {"Begin and End", 10, drawImmediate},
    {"texture quad", 14, drawTexture},
    {"kept texture quad", 12, drawKept},
    {"draw from a buffer", 10, drawBuffer},
    {"draw from arrays", 3, drawArrays},
    {"NewList", 2, makeList},
    {"CallList", 3, callList},
};

} // namespace sharing
