#include "nv_rows.h"
#include "quad.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <utility>

namespace bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kSide = 160; ///< quads along an edge of the grid
constexpr GLsizei kIndices = kSide * kSide * 6;

/// The direction that all triangles of the grid face: away from the viewer or towards him.
enum class Facing { Away, Towards };

struct Vertex {
  float position[4], color[4], coordinate[2], normal[3], matrix;
};

void makeGrid() {
  static bool s_done = false;
  if (s_done)
    return;
  s_done = true;
  std::vector<Vertex> vertices;
  std::vector<GLuint> indices;
  constexpr int kRow = kSide + 1;
  for (int y = 0; y < kRow; ++y) {
    for (int x = 0; x < kRow; ++x) {
      const float u = float(x) / kSide, v = float(y) / kSide;
      vertices.push_back({{2 * u - 1, 2 * v - 1, 0.1f * u * v, 1},
                          {u, v, 1 - u, 1},
                          {u, v},
                          {u - 0.5f, v - 0.5f, 0.75f},
                          float(3 * ((x + y) % 2))});
      if (x == kSide || y == kSide)
        continue;
      for (const int corner : {0, 1, kRow + 1, 0, kRow + 1, kRow})
        indices.push_back(GLuint(y * kRow + x + corner));
    }
  }
  std::array<GLuint, 2> buffers{};
  glGenBuffers(2, buffers.data());
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(GLuint)), indices.data(),
               GL_STATIC_DRAW);
  constexpr GLsizei kStride = sizeof(Vertex);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void *>(offset); };
  glVertexPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
  glColorPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, color)));
  const std::pair<GLint, std::size_t> kSets[] = {{2, offsetof(Vertex, coordinate)},
                                                 {3, offsetof(Vertex, normal)},
                                                 {1, offsetof(Vertex, matrix)}};
  for (GLenum set = 0; set < 3; ++set) {
    glClientActiveTexture(GL_TEXTURE0 + set);
    glTexCoordPointer(kSets[set].first, GL_FLOAT, kStride, at(kSets[set].second));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void enableArrays(bool on) {
  const auto set = on ? glEnableClientState : glDisableClientState;
  set(GL_VERTEX_ARRAY);
  set(GL_COLOR_ARRAY);
  for (GLenum i = 0; i < 3; ++i) {
    glClientActiveTexture(GL_TEXTURE0 + i);
    set(GL_TEXTURE_COORD_ARRAY);
  }
}

/// Sets the environment parameters of the vertex programs, which NVIDIA's languages read as c[].
void setParameters() {
  static constexpr float kMatrix[4][4] = {
      {0.9f, 0.1f, 0, 0}, {-0.1f, 0.9f, 0, 0}, {0, 0, 0.5f, 0}, {0, 0, 0, 1}};
  static constexpr float kOthers[4][4] = {
      {0.4f, 0.7f, 0.6f, 1}, {-0.5f, 0.3f, 0.2f, 8}, {0.2f, 0.3f, 0.5f, 1}, {0.8f, 0.5f, 0.1f, 1}};
  static constexpr float kLights[4][3] = {
      {1.5f, 0.5f, 1}, {-1.5f, 0.5f, 1}, {0.5f, 1.5f, 1}, {0.5f, -1.5f, 1}};
  const auto set = [](GLuint index, float x, float y, float z, float w) {
    glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, index, x, y, z, w);
  };
  for (GLuint i = 0; i < 4; ++i) {
    set(i, kMatrix[i][0], kMatrix[i][1], kMatrix[i][2], kMatrix[i][3]);
    set(4 + i, kOthers[i][0], kOthers[i][1], kOthers[i][2], kOthers[i][3]);
    set(16 + i, kLights[i][0], kLights[i][1], kLights[i][2], 1);
  }
  for (GLuint i = 0; i < 6; ++i) // two matrices of three rows
    set(8 + i, i % 3 == 0, i % 3 == 1, i % 3 == 2, 0.002f * float(i));
}

/// Returns a new program object with this text, bound; 0 if GL rejects it.
GLuint makeProgram(GLenum target, const std::string &text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  if (glGetError() == GL_NO_ERROR)
    return name;
  std::fprintf(stderr, "rejected: %s\n%s",
               reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)),
               text.c_str());
  glDeleteProgramsARB(1, &name);
  return 0;
}

/// Enables the program's target and prepares textures and arrays; leave() undoes it.
void enter(GLenum target) {
  bindTextures();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  if (target == GL_FRAGMENT_PROGRAM_ARB)
    return;
  static const GLuint s_color =
      makeProgram(GL_FRAGMENT_PROGRAM_ARB, "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n");
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, s_color);
  glEnable(GL_VERTEX_PROGRAM_ARB);
  glEnable(GL_CULL_FACE);
  makeGrid();
  setParameters();
}

void leave() {
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glDisable(GL_CULL_FACE);
}

void draw(GLenum target, Facing facing) {
  if (target == GL_FRAGMENT_PROGRAM_ARB)
    return drawQuad();
  glFrontFace(facing == Facing::Away ? GL_CW : GL_CCW);
  glDrawElements(GL_TRIANGLES, kIndices, GL_UNSIGNED_INT, nullptr);
  glFrontFace(GL_CCW);
}

/// Binds the program of one side, which the first call loads; false if GL rejects it.
bool bind(const NvPair &pair, bool nv) {
  static std::map<std::pair<const NvPair *, bool>, GLuint> s_programs;
  GLuint &name = s_programs[{&pair, nv}];
  if (!name)
    name = makeProgram(pair.target, nvText(pair, nv, 0));
  glBindProgramARB(pair.target, name);
  return name != 0;
}

/// Runs the body with the grid's arrays enabled only meanwhile, as other rows have arrays of their
/// own.
template <typename Body> auto withState(const NvPair &pair, Body body) {
  enter(pair.target);
  const bool arrays = pair.target == GL_VERTEX_PROGRAM_ARB;
  if (arrays)
    enableArrays(true);
  const auto result = body();
  if (arrays)
    enableArrays(false);
  leave();
  return result;
}

std::vector<double> frames(const NvPair &pair, bool nv, int count) {
  return withState(pair, [&]() -> std::vector<double> {
    if (!bind(pair, nv))
      return {-1.0};
    draw(pair.target, Facing::Away);
    glFinish();
    const auto begin = Clock::now();
    for (int i = 0; i < count; ++i)
      draw(pair.target, Facing::Away);
    glFinish();
    const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
    return {time.count() / count};
  });
}

/// Draws a triangle of a few pixels.
void drawSmall() {
  static constexpr float kCorners[3][2] = {{0, 0}, {0.05f, 0}, {0.05f, 0.05f}};
  glBegin(GL_TRIANGLES);
  for (const auto &[x, y] : kCorners) {
    glColor4f(0.5f, x, y, 1);
    glMultiTexCoord3f(GL_TEXTURE1, x, y, 1);
    glMultiTexCoord2f(GL_TEXTURE0, x, y);
    glVertex2f(x, y);
  }
  glEnd();
}

/// Returns the times from the program's name to its first pixels, for each of \p count texts.
std::vector<double> loads(const NvPair &pair, bool nv, int count, unsigned seed) {
  return withState(pair, [&] {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) {
      const std::string text = nvText(pair, nv, seed++);
      const auto begin = Clock::now();
      const GLuint name = makeProgram(pair.target, text);
      drawSmall();
      glFinish();
      const std::chrono::duration<double, std::nano> time = Clock::now() - begin;
      glDeleteProgramsARB(1, &name);
      times.push_back(name ? time.count() : -1.0);
    }
    return times;
  });
}

std::vector<unsigned char> picture(const NvPair &pair, bool nv) {
  return withState(pair, [&] {
    std::array<GLint, 4> box{};
    glGetIntegerv(GL_VIEWPORT, box.data());
    std::vector<unsigned char> pixels(std::size_t(box[2]) * std::size_t(box[3]) * 4);
    glClear(GL_COLOR_BUFFER_BIT);
    if (bind(pair, nv))
      draw(pair.target, Facing::Towards);
    glReadPixels(0, 0, box[2], box[3], GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    return pixels;
  });
}

bool offered() {
  GLint count = 0;
  const char *const words = reinterpret_cast<const char *>(glGetString(GL_EXTENSIONS));
  const std::string_view all = words ? words : "";
  for (const std::string_view name :
       {"GL_NV_fragment_program2", "GL_NV_vertex_program3", "GL_NV_vertex_program2"})
    count += all.find(name) != std::string_view::npos;
  return count == 3;
}

} // namespace

const std::vector<Row> &nvRows() {
  static const std::vector<Row> rows = [] {
    std::vector<Row> all;
    if (!offered())
      return all;
    for (const std::span<const NvPair> pairs : {nvFragmentPairs(), nvVertexPairs()})
      for (const NvPair &pair : pairs)
        for (const bool nv : {false, true}) {
          const std::string name = std::string(pair.name) + (nv ? ", NV" : ", ARB");
          all.push_back({"nv-frame/" + name,
                         [&pair, nv](int count, unsigned) { return frames(pair, nv, count); }});
          all.push_back({"nv-load/" + name, [&pair, nv](int count, unsigned seed) {
                           return loads(pair, nv, count, seed);
                         }});
        }
    return all;
  }();
  return rows;
}

double nvDifference(std::string_view name) {
  const NvPair *found = nullptr;
  for (const std::span<const NvPair> pairs : {nvFragmentPairs(), nvVertexPairs()})
    for (const NvPair &pair : pairs)
      if (pair.name == name)
        found = &pair;
  if (!found)
    return -1.0;
  const std::vector<unsigned char> arb = picture(*found, false), nv = picture(*found, true);
  const bool uniform = std::all_of(arb.begin(), arb.end(),
                                   [&](unsigned char value) { return value == arb.front(); });
  if (uniform) // nothing was drawn
    return 1.0;
  std::size_t apart = 0;
  for (std::size_t i = 0; i < arb.size(); ++i)
    apart += std::abs(int(arb[i]) - int(nv[i])) > 2;
  return double(apart) / double(arb.size());
}

} // namespace bench
