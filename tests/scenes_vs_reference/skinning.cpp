// A tube that four bones bend: a vertex program's parameters have a palette of matrices, and two
// numbers of each vertex select two of them.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <string>

#include "../gallery_vs_interpreter/raster.h"
#include "scenes.h"

namespace scenes {

namespace {

constexpr int kBones = 4, kFirstRow = 8, kAround = 48, kAlong = 96;
constexpr glm::vec4 kClear = {0.2f, 0.2f, 0.25f, 1};
constexpr glm::vec3 kColor = {0.9f, 0.75f, 0.5f};

struct Tube {
  Mesh mesh;
  glm::mat4 projection{1}, modelView{1};
  std::array<glm::mat4, kBones> bones;
  glm::vec4 light{0};
} g_tube;

/// Makes the mesh. Its extra coordinates have the weights in x and y, the first rows of the bones
/// in z and w.
void prepare() {
  Mesh mesh;
  for (int along = 0; along <= kAlong; ++along)
    for (int around = 0; around <= kAround; ++around) {
      const float y = float(along) / kAlong * 4 - 2;
      const float angle = float(around) / kAround * glm::two_pi<float>();
      MeshVertex vertex;
      vertex.normal = {std::cos(angle), 0, std::sin(angle)};
      vertex.position = vertex.normal * 0.45f + glm::vec3(0, y, 0);
      const float bone = std::clamp((y + 2) * kBones / 4.0f - 0.5f, 0.0f, float(kBones - 1));
      const float first = std::min(std::floor(bone), float(kBones - 2)), second = bone - first;
      vertex.extra = {1 - second, second, first * 3, first * 3 + 3};
      mesh.vertices.push_back(vertex);
    }
  const auto at = [](int around, int along) {
    return std::uint32_t(along * (kAround + 1) + around);
  };
  for (int along = 0; along < kAlong; ++along)
    for (int around = 0; around < kAround; ++around)
      mesh.quad(at(around, along), at(around + 1, along), at(around + 1, along + 1),
                at(around, along + 1));
  g_tube.mesh = mesh;
  g_tube.mesh.upload();
  g_tube.projection = glm::perspective(glm::radians(50.0f), 1.0f, 1.0f, 12.0f);
  g_tube.modelView = glm::lookAt(glm::vec3(1, 1, 5.5f), glm::vec3(0), glm::vec3(0, 1, 0));
  g_tube.light = glm::vec4(glm::normalize(glm::vec3(0.5f, 0.6f, 0.7f)), 0);
  glm::mat4 bone(1);
  // Each rotates about its lower end, together with the bones above it
  for (int i = 0; i < kBones; ++i) {
    const glm::vec3 joint = {0, float(i) - 2, 0};
    bone = glm::translate(bone, joint);
    bone = glm::rotate(bone, glm::radians(i % 2 == 0 ? 14.0f : -38.0f),
                       glm::vec3(i == 3 ? 1 : 0, 0, i == 3 ? 0 : 1));
    bone = glm::translate(bone, -joint);
    g_tube.bones[std::size_t(i)] = bone;
  }
}

glm::vec4 rowOf(int bone, int row) {
  const glm::mat4 &m = g_tube.bones[std::size_t(bone)];
  return {m[0][row], m[1][row], m[2][row], m[3][row]};
}

void beginState() {
  loadMatrices(g_tube.projection, g_tube.modelView);
  glClearColor(kClear.r, kClear.g, kClear.b, kClear.a);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  g_tube.mesh.draw(true);
}

void end() {
  endPrograms();
  glDisable(GL_DEPTH_TEST);
}

/// Transforms by the two bones in turn: `place` and `normal` sum up `moved` and `turned`.
constexpr char kNvVertices[] =
    "!!VP1.1\n"
    // c[0..3]: to clip space; c[4]: light; c[5]: colour; c[6]: 0.3, 0.7, 0, 1; c[8..]: the palette
    "ARL A0.x, v[TEX1].z;\n"
    "DP4 R0.x, c[A0.x + 8], v[OPOS];\nDP4 R0.y, c[A0.x + 9], v[OPOS];\n"
    "DP4 R0.z, c[A0.x + 10], v[OPOS];\n"
    "DP3 R1.x, c[A0.x + 8], v[NRML];\nDP3 R1.y, c[A0.x + 9], v[NRML];\n"
    "DP3 R1.z, c[A0.x + 10], v[NRML];\n"
    "MUL R2.xyz, R0, v[TEX1].x;\nMUL R3.xyz, R1, v[TEX1].x;\n"
    "ARL A0.x, v[TEX1].w;\n"
    "DP4 R0.x, c[A0.x + 8], v[OPOS];\nDP4 R0.y, c[A0.x + 9], v[OPOS];\n"
    "DP4 R0.z, c[A0.x + 10], v[OPOS];\n"
    "DP3 R1.x, c[A0.x + 8], v[NRML];\nDP3 R1.y, c[A0.x + 9], v[NRML];\n"
    "DP3 R1.z, c[A0.x + 10], v[NRML];\n"
    "MAD R2.xyz, R0, v[TEX1].y, R2;\nMAD R3.xyz, R1, v[TEX1].y, R3;\n"
    "MOV R2.w, c[6].w;\n"
    "DP4 o[HPOS].x, c[0], R2;\nDP4 o[HPOS].y, c[1], R2;\n"
    "DP4 o[HPOS].z, c[2], R2;\nDP4 o[HPOS].w, c[3], R2;\n"
    "DP3 R3.w, R3, R3;\nRSQ R3.w, R3.w;\nDP3 R4.x, R3, c[4];\nMUL R4.x, R4.x, R3.w;\n"
    "MAX R4.x, R4.x, c[6].z;\nMOV R5, c[6];\nMAD R4.x, R4.x, R5.y, R5.x;\n"
    "MUL o[COL0].xyz, R4.x, c[5];\nMOV o[COL0].w, c[6].w;\n"
    "END";

void beginAsThen() {
  beginState();
  useNvProgram(kNvVertices);
  glTrackMatrixNV(GL_VERTEX_PROGRAM_NV, 0, GL_MODELVIEW_PROJECTION_NV, GL_IDENTITY_NV);
  const glm::vec4 color = glm::vec4(kColor, 1), levels = {0.3f, 0.7f, 0, 1};
  glProgramParameter4fvNV(GL_VERTEX_PROGRAM_NV, 4, &g_tube.light.x);
  glProgramParameter4fvNV(GL_VERTEX_PROGRAM_NV, 5, &color.x);
  glProgramParameter4fvNV(GL_VERTEX_PROGRAM_NV, 6, &levels.x);
  for (int i = 0; i < 3 * kBones; ++i) {
    const glm::vec4 row = rowOf(i / 3, i % 3);
    glProgramParameter4fvNV(GL_VERTEX_PROGRAM_NV, GLuint(kFirstRow + i), &row.x);
  }
}

std::string arbBone(const char *lane) {
  std::string text = std::string("ARL first.x, vertex.texcoord[1].") + lane + ";\n";
  for (int i = 0; i < 3; ++i) {
    const std::string component(1, "xyz"[i]), row = "palette[first.x + " + std::to_string(i) + "]";
    text += "DP4 moved." + component + ", " + row + ", vertex.position;\n";
    text += "DP3 turned." + component + ", " + row + ", vertex.normal;\n";
  }
  return text;
}

void beginByArb() {
  beginState();
  const std::string text =
      "!!ARBvp1.0\nPARAM toClip[4] = { state.matrix.mvp };\n"
      "PARAM light = program.env[4];\nPARAM color = program.env[5];\n"
      "PARAM levels = program.env[6];\nPARAM palette[12] = { program.env[8..19] };\n"
      "ADDRESS first;\nTEMP moved, turned, place, normal;\n" +
      arbBone("z") +
      "MUL place.xyz, moved, vertex.texcoord[1].x;\nMUL normal.xyz, turned, "
      "vertex.texcoord[1].x;\n" +
      arbBone("w") +
      "MAD place.xyz, moved, vertex.texcoord[1].y, place;\n"
      "MAD normal.xyz, turned, vertex.texcoord[1].y, normal;\n"
      "MOV place.w, levels.w;\n"
      "DP4 result.position.x, toClip[0], place;\nDP4 result.position.y, toClip[1], place;\n"
      "DP4 result.position.z, toClip[2], place;\nDP4 result.position.w, toClip[3], place;\n"
      "DP3 normal.w, normal, normal;\nRSQ normal.w, normal.w;\n"
      "DP3 moved.x, normal, light;\nMUL moved.x, moved.x, normal.w;\n"
      "MAX moved.x, moved.x, levels.z;\nMAD moved.x, moved.x, levels.y, levels.x;\n"
      "MUL result.color.xyz, moved.x, color;\nMOV result.color.w, levels.w;\nEND";
  useArbProgram(GL_VERTEX_PROGRAM_ARB, text.c_str());
  const glm::vec4 color = glm::vec4(kColor, 1), levels = {0.3f, 0.7f, 0, 1};
  glProgramEnvParameter4fvARB(GL_VERTEX_PROGRAM_ARB, 4, &g_tube.light.x);
  glProgramEnvParameter4fvARB(GL_VERTEX_PROGRAM_ARB, 5, &color.x);
  glProgramEnvParameter4fvARB(GL_VERTEX_PROGRAM_ARB, 6, &levels.x);
  for (int i = 0; i < 3 * kBones; ++i) {
    const glm::vec4 row = rowOf(i / 3, i % 3);
    glProgramEnvParameter4fvARB(GL_VERTEX_PROGRAM_ARB, GLuint(kFirstRow + i), &row.x);
  }
}

// --- Plain C++ ---

gallery::Vertex shadeVertex(const MeshVertex &vertex) {
  const glm::mat4 &first = g_tube.bones[std::size_t(vertex.extra.z) / 3];
  const glm::mat4 &second = g_tube.bones[std::size_t(vertex.extra.w) / 3];
  const glm::mat4 bone = first * vertex.extra.x + second * vertex.extra.y;
  const glm::vec4 place = {glm::vec3(bone * glm::vec4(vertex.position, 1)), 1};
  const glm::vec3 normal = glm::normalize(glm::mat3(bone) * vertex.normal);
  gallery::Vertex result;
  result.clip = glm::dvec4(g_tube.projection * (g_tube.modelView * place));
  const float lit = std::max(glm::dot(normal, glm::vec3(g_tube.light)), 0.0f) * 0.7f + 0.3f;
  result.varyings[gallery::kColor] = glm::vec4(kColor * lit, 1);
  return result;
}

Canvas reference(int size) {
  Canvas canvas(size, kClear);
  std::vector<gallery::Vertex> shaded;
  for (const MeshVertex &vertex : g_tube.mesh.vertices)
    shaded.push_back(shadeVertex(vertex));
  std::array<bool, gallery::kVaryings> used{};
  used[gallery::kColor] = true;
  const std::vector<std::uint32_t> &indices = g_tube.mesh.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    gallery::rasterize(shaded[indices[i]], shaded[indices[i + 1]], shaded[indices[i + 2]], size,
                       size, used, [&](const gallery::Fragment &fragment) {
                         const auto at = std::size_t(fragment.y * size + fragment.x);
                         if (fragment.depth >= canvas.depths[at])
                           return;
                         canvas.depths[at] = fragment.depth;
                         canvas.colors[at] = fragment.varyings[gallery::kColor];
                       });
  return canvas;
}

} // namespace

Scene skinningScene() {
  return {"skinning",
          prepare,
          {{"arb", "GL_ARB_vertex_program", beginByArb, draw, end},
           {"as-then", "GL_NV_vertex_program1_1", beginAsThen, draw, end}},
          reference,
          2,
          0.002};
}

} // namespace scenes
