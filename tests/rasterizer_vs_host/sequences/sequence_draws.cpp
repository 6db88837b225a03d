#include "world.h"

#include <bit>
#include <string>

namespace software {

namespace {

constexpr int kFragment = GL_FRAGMENT_PROGRAM_ARB;

/// A rectangle of whole pixels, mostly inside the target, at one of nine depths.
struct Place {
  float x0, y0, x1, y1, z;
};

Place randomPlace(int width, int height, Random &random) {
  const int x = random.between(-4, width - 2), y = random.between(-4, height - 2);
  const int w = random.once(4) ? width : random.between(1, width / 2 + 1);
  const int h = random.once(4) ? height : random.between(1, height / 2 + 1);
  if (random.once(3)) // all of it, as feedback's usual quad
    return {0, 0, float(width), float(height), 0};
  return {float(x), float(y), float(x + w), float(y + h), float(random.between(-4, 4)) / 4.0f};
}

/// Coordinates in texels that keep samples away from texel borders: a step of a half, one or two
/// texels a pixel, never nearer than an eighth.
struct Mapping {
  float u0, v0, u1, v1;
};

Mapping randomMapping(const Place &place, const Texture &image, bool normalised, Random &random) {
  static constexpr float kSteps[] = {1, 1, 1, 0.5f, 2};
  const float step = random.pick(kSteps);
  const float inside = step == 0.5f ? 0.125f : 0.25f;
  const float u = random.once(2) ? inside : float(random.between(-8, 40)) + inside;
  const float v = random.once(2) ? inside : float(random.between(-8, 40)) + inside;
  const float width = normalised ? float(image.width[0]) : 1.0f;
  const float height = normalised ? float(image.height[0]) : 1.0f;
  return {u / width, v / height, (u + step * (place.x1 - place.x0)) / width,
          (v + step * (place.y1 - place.y0)) / height};
}

/// True if a mapping's coordinates for `first` are equally far from texel borders of `second`: a
/// texel of `second` is half of one of `first`, or that times a power of two.
bool fitsToo(const Texture &first, const Texture &second) {
  const auto fits = [](int a, int b) {
    return 2 * a % b == 0 && std::has_single_bit(unsigned(2 * a / b));
  };
  return fits(first.width[0], second.width[0]) && fits(first.height[0], second.height[0]);
}

void randomColor(Random &random, bool extremes) {
  std::array<GLubyte, 4> color{};
  for (GLubyte &component : color)
    component = extremes ? GLubyte(random.once(2) ? 255 : 0) : GLubyte(random.bits());
  glColor4ubv(color.data());
}

/// Draws the four corners in one of GL's ways; both coordinate sets are equal.
void submit(World &world, const Place &p, const Mapping &m, int way) {
  const float corners[4][8] = {{p.x0, p.y0, p.z, 1, m.u0, m.v0, 0, 1},
                               {p.x1, p.y0, p.z, 1, m.u1, m.v0, 0, 1},
                               {p.x1, p.y1, p.z, 1, m.u1, m.v1, 0, 1},
                               {p.x0, p.y1, p.z, 1, m.u0, m.v1, 0, 1}};
  if (way < 3) {
    static constexpr GLenum kModes[] = {GL_QUADS, GL_TRIANGLE_FAN, GL_POLYGON};
    glBegin(kModes[way]);
    for (const auto &corner : corners) {
      glMultiTexCoord4fv(GL_TEXTURE1, corner + 4);
      glTexCoord4fv(corner + 4);
      glVertex4fv(corner);
    }
    glEnd();
    return;
  }
  const bool buffers = way >= 5, indexed = way == 4 || way == 6;
  const auto *base = reinterpret_cast<const GLubyte *>(corners);
  static constexpr GLushort kIndices[6] = {0, 1, 2, 0, 2, 3};
  if (buffers) {
    glBindBuffer(GL_ARRAY_BUFFER, world.context().vertexBuffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STREAM_DRAW);
    base = nullptr;
  }
  const auto at = [&](std::size_t offset) {
    return base ? static_cast<const void *>(base + offset) : reinterpret_cast<const void *>(offset);
  };
  glVertexPointer(4, GL_FLOAT, sizeof corners[0], at(0));
  glEnableClientState(GL_VERTEX_ARRAY);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glClientActiveTexture(unit);
    glTexCoordPointer(4, GL_FLOAT, sizeof corners[0], at(4 * sizeof(float)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  if (!indexed) {
    glDrawArrays(GL_QUADS, 0, 4);
  } else if (buffers) {
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, world.context().indexBuffer);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kIndices, kIndices, GL_STREAM_DRAW);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, nullptr);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  } else {
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, kIndices);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDisableClientState(GL_VERTEX_ARRAY);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glClientActiveTexture(unit);
    glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
}

void bind(World &world, GLenum unit, int texture) {
  glActiveTexture(unit);
  glBindTexture(World::targetOf(texture), world.texture(texture).name);
}

/// Sets a local parameter. Programs that use row numbers need it too: if Clear came between
/// BindFramebuffer and the draw, Mesa 22.3.6 counts rows from the previous end until it passes new
/// parameters to a program.
void setLocal(Random &random) {
  std::array<float, 4> value{};
  for (float &component : value)
    component = float(random.below(256)) / 255.0f;
  glProgramLocalParameter4fvARB(kFragment, 0, value.data());
}

/// Draws with one of the programs; `program` is its number.
void drawProgram(World &world, Random &random, int program, int way) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  int first = random.below(kRectangle), second = random.below(kRectangle);
  const bool rectangle = program == 6;
  if (rectangle)
    first = kRectangle;
  const bool samples = program != 0 && program != 5 && program != 8;
  if (program == 4 && !fitsToo(world.texture(first), world.texture(second)))
    second = first;
  if (samples && (world.attached(first) || (program == 4 && world.attached(second))))
    program = 0;
  bind(world, GL_TEXTURE1, second);
  bind(world, GL_TEXTURE0, first);
  glBindProgramARB(kFragment, world.group().programs[std::size_t(program)]);
  if (program == 0 || program == 8)
    setLocal(random);
  glEnable(kFragment);
  randomColor(random, false);
  const Place place = randomPlace(width, height, random);
  submit(world, place, randomMapping(place, world.texture(first), !rectangle, random), way);
}

void programQuad(World &world, Random &random, const std::string &) {
  const int program = random.below(kPrograms);
  drawProgram(world, random, program, random.below(7));
}

/// Draws a frame of Life: a quad of the whole target from a texture, and the copy back into it.
void feedback(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  const int texture = random.below(kRectangle);
  if (!world.size(width, height) || world.attached(texture))
    return;
  bind(world, GL_TEXTURE0, texture);
  glBindProgramARB(kFragment, world.group().programs[std::size_t(1 + random.below(3))]);
  glEnable(kFragment);
  const Texture &image = world.texture(texture);
  const Place place{0, 0, float(image.width[0]), float(image.height[0]), 0};
  submit(world, place, {0, 0, 1, 1}, random.below(2));
  if (image.width[0] <= width && image.height[0] <= height)
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, image.width[0], image.height[0]);
}

/// Draws without a fragment program, by the host.
void fixedQuad(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const int texture = random.below(kTextures);
  const bool textured = random.once(2) && !world.attached(texture);
  glDisable(kFragment);
  bind(world, GL_TEXTURE0, texture);
  if (textured) {
    glEnable(World::targetOf(texture));
    glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
  }
  randomColor(random, false);
  const Place place = randomPlace(width, height, random);
  const Mapping mapping =
      randomMapping(place, world.texture(texture), texture != kRectangle, random);
  submit(world, place, mapping, random.below(7));
  glDisable(World::targetOf(texture));
}

/// Draws a triangle of one color, with corners at eighths of a pixel: both rasterizers must agree
/// on which pixels are inside.
void triangle(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const bool withProgram = random.once(2);
  glBindProgramARB(kFragment, world.group().programs[random.once(2) ? 5 : 8]);
  setLocal(random);
  if (withProgram)
    glEnable(kFragment);
  else
    glDisable(kFragment);
  randomColor(random, true);
  const float z = float(random.between(-4, 4)) / 4.0f;
  glBegin(GL_TRIANGLES);
  for (int i = 0; i < 3; ++i) {
    const float x = float(random.between(-64, 8 * width + 64)) / 8.0f;
    glVertex3f(x, float(random.between(-64, 8 * height + 64)) / 8.0f, z);
  }
  glEnd();
}

void points(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  glBindProgramARB(kFragment, world.group().programs[5]);
  if (random.once(3))
    glDisable(kFragment);
  else
    glEnable(kFragment);
  glBegin(GL_POINTS);
  for (int i = 0; i < 6; ++i) {
    randomColor(random, false);
    const float x = float(random.below(width)) + 0.5f;
    glVertex2f(x, float(random.below(height)) + 0.5f);
  }
  glEnd();
}

void compileList(World &world, Random &random, const std::string &) {
  const int list = random.below(kLists);
  glNewList(world.context().firstList + GLuint(list),
            random.once(3) ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
  for (int i = random.between(1, 3); i > 0; --i)
    drawForList(world, random);
  glEndList();
  world.context().lists[std::size_t(list)] = true;
}

void callList(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  const int list = random.below(kLists);
  if (world.size(width, height) && world.context().lists[std::size_t(list)])
    glCallList(world.context().firstList + GLuint(list));
}

void countedQuad(World &world, Random &random, const std::string &what) {
  GLuint samples = 0;
  glBeginQuery(GL_SAMPLES_PASSED, world.context().query);
  programQuad(world, random, what);
  glEndQuery(GL_SAMPLES_PASSED);
  glGetQueryObjectuiv(world.context().query, GL_QUERY_RESULT, &samples);
  record(what + " samples " + std::to_string(samples), {});
}

} // namespace

void drawForList(World &world, Random &random) {
  static constexpr int kAlone[] = {0, 5, 6, 8};
  if (random.once(4)) {
    glDisable(kFragment);
    randomColor(random, false);
    return glRecti(random.below(32), random.below(32), random.below(64), random.below(64));
  }
  const int program = random.pick(kAlone);
  drawProgram(world, random, program, random.below(5));
}

const std::vector<Command> kDrawCommands = {
    {"program quad", 24, programQuad},
    {"feedback", 10, feedback},
    {"fixed quad", 8, fixedQuad},
    {"triangle", 8, triangle},
    {"points", 3, points},
    {"compile list", 3, compileList},
    {"call list", 5, callList},
    {"counted quad", 2, countedQuad},
};

} // namespace software
