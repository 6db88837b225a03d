// Draws a scene like those of the era's games: 100,000 triangles in indexed buffers, a depth
// buffer, partly blended, every pixel lit by an ARB fragment program. It takes one command for each
// line of input:
//   COUNT          -> milliseconds a frame, over COUNT frames
//   picture FILE   -> "ok"; writes the last frame, RGBA8, bottom row first
// usage: bench-scene [--form fixed|program] [--size SIDE]
#include "common/surface.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr int kRings = 50, kSegments = 50; ///< of a torus with 5,000 triangles
constexpr int kColumns = 5, kRows = 4;
constexpr int kTranslucent = 4; ///< the last of them
constexpr float kTurn = 6.2831853f;

/// The light is in the same coordinates as the texture coordinate sets: the object's, or the eye's.
constexpr std::string_view kFragments = R"(!!ARBfp1.0
PARAM light = program.local[0];     # w: shininess
PARAM eye = program.local[1];
PARAM colour = program.local[2];    # w: opacity
PARAM ambient = {0.12, 0.12, 0.15, 1.0};
TEMP normal, toLight, halfway, surface, term;
TEX surface, fragment.texcoord[0], texture[0], 2D;
DP3 normal.w, fragment.texcoord[1], fragment.texcoord[1];
RSQ normal.w, normal.w;
MUL normal.xyz, fragment.texcoord[1], normal.w;
SUB toLight.xyz, light, fragment.texcoord[2];
DP3 toLight.w, toLight, toLight;
RSQ toLight.w, toLight.w;
MUL toLight.xyz, toLight, toLight.w;
SUB halfway.xyz, eye, fragment.texcoord[2];
DP3 halfway.w, halfway, halfway;
RSQ halfway.w, halfway.w;
MAD halfway.xyz, halfway, halfway.w, toLight;
DP3 halfway.w, halfway, halfway;
RSQ halfway.w, halfway.w;
MUL halfway.xyz, halfway, halfway.w;
DP3 term.x, normal, toLight;
DP3 term.y, normal, halfway;
MOV term.w, light.w;
LIT term, term;
MAD surface.xyz, surface, term.y, ambient;
MAD result.color.xyz, surface, colour, term.z;
MOV result.color.w, colour.w;
END
)";

constexpr std::string_view kVertices = R"(!!ARBvp1.0
PARAM mvp[4] = { state.matrix.mvp };
PARAM view[4] = { state.matrix.modelview };
DP4 result.position.x, mvp[0], vertex.position;
DP4 result.position.y, mvp[1], vertex.position;
DP4 result.position.z, mvp[2], vertex.position;
DP4 result.position.w, mvp[3], vertex.position;
MOV result.texcoord[0], vertex.texcoord[0];
DP3 result.texcoord[1].x, view[0], vertex.normal;
DP3 result.texcoord[1].y, view[1], vertex.normal;
DP3 result.texcoord[1].z, view[2], vertex.normal;
MOV result.texcoord[1].w, 1.0;
DP4 result.texcoord[2].x, view[0], vertex.position;
DP4 result.texcoord[2].y, view[1], vertex.position;
DP4 result.texcoord[2].z, view[2], vertex.position;
MOV result.texcoord[2].w, 1.0;
END
)";

struct Vertex {
  float position[3], normal[3], coordinate[2];
};

class Scene {
public:
  [[nodiscard]] bool start(const demos::Surface &surface, bool vertexProgram);
  void draw(int frame) const;
  [[nodiscard]] static int triangles() { return 2 * kRings * kSegments * kColumns * kRows; }

private:
  void makeTorus();
  static void makeTexture();
  void drawTorus(int number, float angle) const;

  bool m_vertexProgram = false;
};

bool load(GLenum target, std::string_view text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  if (glGetError() == GL_NO_ERROR)
    return true;
  std::fprintf(stderr, "bench-scene: rejected: %s\n",
               reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)));
  return false;
}

void Scene::makeTorus() {
  std::vector<Vertex> vertices;
  std::vector<GLushort> indices;
  for (int ring = 0; ring < kRings; ++ring) {
    for (int segment = 0; segment < kSegments; ++segment) {
      const float a = kTurn * float(ring) / kRings, b = kTurn * float(segment) / kSegments;
      const float radius = 0.62f + 0.3f * std::cos(b);
      vertices.push_back({{radius * std::cos(a), radius * std::sin(a), 0.3f * std::sin(b)},
                          {std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b)},
                          {8.0f * float(ring) / kRings, 4.0f * float(segment) / kSegments}});
      const auto at = [](int r, int s) {
        return GLushort((r % kRings) * kSegments + s % kSegments);
      };
      for (const auto &[r, s] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}})
        indices.push_back(at(ring + r, segment + s));
    }
  }
  std::array<GLuint, 2> buffers{};
  glGenBuffers(2, buffers.data());
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(GLushort)),
               indices.data(), GL_STATIC_DRAW);
}

void Scene::makeTexture() {
  constexpr int kSide = 256;
  std::vector<unsigned char> texels;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool brick = (x / 32 + y / 16) % 2 != 0;
      for (const int value : {brick ? 220 : 150, brick ? 140 + x / 4 : 130, 90 + y / 4, 255})
        texels.push_back(static_cast<unsigned char>(value));
    }
  }
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
}

bool Scene::start(const demos::Surface &surface, bool vertexProgram) {
  m_vertexProgram = vertexProgram;
  if (!load(GL_FRAGMENT_PROGRAM_ARB, kFragments) ||
      (vertexProgram && !load(GL_VERTEX_PROGRAM_ARB, kVertices)))
    return false;
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  if (vertexProgram)
    glEnable(GL_VERTEX_PROGRAM_ARB);
  makeTorus();
  makeTexture();
  constexpr GLsizei kStride = sizeof(Vertex);
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void *>(offset); };
  glVertexPointer(3, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
  glEnableClientState(GL_VERTEX_ARRAY);
  glTexCoordPointer(2, GL_FLOAT, kStride, at(offsetof(Vertex, coordinate)));
  glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  if (vertexProgram) {
    glNormalPointer(GL_FLOAT, kStride, at(offsetof(Vertex, normal)));
    glEnableClientState(GL_NORMAL_ARRAY);
  } else {
    glClientActiveTexture(GL_TEXTURE1);
    glTexCoordPointer(3, GL_FLOAT, kStride, at(offsetof(Vertex, normal)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glClientActiveTexture(GL_TEXTURE2);
    glTexCoordPointer(3, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glViewport(0, 0, surface.width(), surface.height());
  glMatrixMode(GL_PROJECTION);
  glFrustum(-0.5, 0.5, -0.5, 0.5, 1.0, 20.0);
  glMatrixMode(GL_MODELVIEW);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glClearColor(0.1f, 0.12f, 0.2f, 1.0f);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  return glGetError() == GL_NO_ERROR;
}

void local(GLuint index, float x, float y, float z, float w) {
  glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, index, x, y, z, w);
}

void Scene::drawTorus(int number, float angle) const {
  const float x = 1.05f * (float(number % kColumns) - 0.5f * (kColumns - 1));
  const float y = 1.15f * (float(number / kColumns) - 0.5f * (kRows - 1));
  const float z = number >= kColumns * kRows - kTranslucent ? -4.4f : -5.2f;
  const float turn = angle + float(number), c = std::cos(turn), s = std::sin(turn);
  // The matrix is column by column: a rotation about y, then the position.
  const float matrix[16] = {c, 0, -s, 0, 0, 1, 0, 0, s, 0, c, 0, x, y, z, 1};
  glLoadMatrixf(matrix);
  // The light and the eye are in eye coordinates, or rotated back into the object's.
  const auto place = [&](GLuint index, float px, float py, float pz, float w) {
    if (m_vertexProgram)
      return local(index, px, py, pz, w);
    const float dx = px - x, dy = py - y, dz = pz - z;
    local(index, c * dx - s * dz, dy, s * dx + c * dz, w);
  };
  place(0, 2.0f, 3.0f, 0.0f, 24.0f);
  place(1, 0.0f, 0.0f, 0.0f, 1.0f);
  local(2, 0.6f + 0.08f * float(number % 6), 0.9f - 0.06f * float(number % 9), 0.85f, 0.55f);
  glDrawElements(GL_TRIANGLES, 6 * kRings * kSegments, GL_UNSIGNED_SHORT, nullptr);
}

void Scene::draw(int frame) const {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int i = 0; i < kColumns * kRows; ++i) {
    if (i == kColumns * kRows - kTranslucent) {
      glEnable(GL_BLEND);
      glDepthMask(GL_FALSE);
    }
    drawTorus(i, 0.02f * float(frame));
  }
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
}

bool writePicture(const demos::Surface &surface, const std::string &file) {
  const demos::Image image = surface.readPixels();
  std::FILE *const out = std::fopen(file.c_str(), "wb");
  const bool good =
      out && std::fwrite(image.bytes.data(), 1, image.bytes.size(), out) == image.bytes.size();
  return (!out || std::fclose(out) == 0) && good;
}

bool answer(const Scene &scene, const demos::Surface &surface, const std::string &order,
            int &frame) {
  if (order.starts_with("picture ")) {
    if (!writePicture(surface, order.substr(8)))
      return false;
    std::printf("\"ok\"\n");
    return true;
  }
  const int count = std::max(1, std::atoi(order.c_str()));
  const auto begin = Clock::now();
  for (int i = 0; i < count; ++i) {
    scene.draw(frame++);
    glFinish();
  }
  const std::chrono::duration<double, std::milli> time = Clock::now() - begin;
  std::printf("%.5f\n", time.count() / count);
  return true;
}

} // namespace

int main(int argc, char **argv) {
  int side = 1024;
  bool vertexProgram = false;
  for (int i = 1; i + 1 < argc; i += 2) {
    if (!std::strcmp(argv[i], "--size"))
      side = std::clamp(std::atoi(argv[i + 1]), 16, 8192);
    else if (!std::strcmp(argv[i], "--form"))
      vertexProgram = !std::strcmp(argv[i + 1], "program");
  }
  const auto surface = demos::makeHeadless(side, side, false);
  if (!surface || !epoxy_has_gl_extension("GL_ARB_fragment_program"))
    return 77;
  Scene scene;
  if (!scene.start(*surface, vertexProgram))
    return 1;
  int frame = 0;
  scene.draw(frame);
  glFinish();
  std::printf("{\"renderer\": \"%s\", \"triangles\": %d}\n",
              reinterpret_cast<const char *>(glGetString(GL_RENDERER)), Scene::triangles());
  std::fflush(stdout);
  for (std::string order; std::getline(std::cin, order);) {
    if (!answer(scene, *surface, order, frame))
      return 1;
    std::fflush(stdout);
  }
  return glGetError() == GL_NO_ERROR ? 0 : 1;
}
