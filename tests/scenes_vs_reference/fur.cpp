// Fur in shells and fins, with lit hairs: a two-dimensional table has the light that a strand
// scatters, by the cosines of its direction with the light and with the half vector. It is drawn as
// on a GeForce 4: an NVIDIA vertex program, two textures, two register combiners, and the alpha
// test for strands that end below a shell. It is also drawn by ARB programs.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "../gallery_vs_interpreter/raster.h"
#include "scenes.h"

namespace scenes {

namespace {

constexpr int kShells = 12, kHairs = 64, kTable = 64;
constexpr float kLength = 0.2f;
constexpr glm::vec4 kClear = {0.1f, 0.12f, 0.16f, 1};

struct Fur {
  Mesh skin, fins;
  glm::mat4 projection{1}, modelView{1};
  glm::vec4 light{0}, eye{0}; ///< in object space
  std::vector<glm::vec4> hairs, table;
} g_fur;

GLuint g_textures[2] = {};

/// Returns the height of a shell, relative to the length of a hair. No hair ends at a shell, as
/// lengths are multiples of 1/255.
float shellAt(int shell) { return (float(shell * 19) + 8.5f) / 255; }

/// Makes strips along the meridians that stand off the skin.
Mesh makeFins(const Mesh &skin, int columns, int rows) {
  Mesh fins;
  for (int column = 0; column < columns; ++column)
    for (int row = 2; row < rows - 2; ++row) {
      const auto base = std::uint32_t(fins.vertices.size());
      for (int corner = 0; corner < 4; ++corner) {
        const int below = corner == 1 || corner == 2 ? 1 : 0;
        MeshVertex vertex = skin.vertices[std::size_t((row + below) * (columns + 1) + column)];
        vertex.extra.x = corner >= 2 ? 0.93f : 0.02f;
        fins.vertices.push_back(vertex);
      }
      fins.quad(base, base + 1, base + 2, base + 3);
    }
  return fins;
}

/// Returns a repeatable number for a place, in [0, 1).
float noise(int x, int y) {
  auto n = std::uint32_t(x) * 374761393u + std::uint32_t(y) * 668265263u;
  n = (n ^ n >> 13) * 1274126177u;
  return float((n ^ n >> 16) & 0xFFFFu) / 65536;
}

void uploadImage(const std::vector<glm::vec4> &texels, int size) {
  Picture bytes;
  for (const glm::vec4 &texel : texels)
    for (int i = 0; i < 4; ++i)
      bytes.push_back(std::uint8_t(std::lround(texel[i] * 255)));
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
}

/// Rounds colors to bytes.
glm::vec4 inBytes(glm::vec4 color) {
  for (int i = 0; i < 4; ++i)
    color[i] = std::round(std::clamp(color[i], 0.0f, 1.0f) * 255) / 255;
  return color;
}

void makeImages() {
  g_fur.hairs.clear();
  g_fur.table.clear();
  for (int y = 0; y < kHairs; ++y)
    for (int x = 0; x < kHairs; ++x) {
      const float n = noise(x, y), tint = noise(x + 100, y);
      const float length = n < 0.45f ? 0.4f + noise(y, x + 7) * 0.6f : 0.02f;
      g_fur.hairs.push_back(
          inBytes({0.5f + 0.3f * tint, 0.38f + 0.2f * tint, 0.25f + 0.1f * tint, length}));
    }
  // Kajiya and Kay: the sine of the angle with the light, and that with the half vector.
  for (int y = 0; y < kTable; ++y)
    for (int x = 0; x < kTable; ++x) {
      const float lt = (float(x) + 0.5f) * 2 / kTable - 1, ht = (float(y) + 0.5f) * 2 / kTable - 1;
      const float diffuse = 0.25f + 0.75f * std::sqrt(std::max(0.0f, 1 - lt * lt));
      const float specular = 0.5f * std::pow(std::max(0.0f, 1 - ht * ht), 8.0f);
      g_fur.table.push_back(inBytes({diffuse, diffuse * 0.95f, diffuse * 0.85f, specular}));
    }
}

void prepare() {
  constexpr int kColumns = 32, kRows = 20;
  g_fur.skin = sphere(kColumns, kRows);
  g_fur.fins = makeFins(g_fur.skin, kColumns, kRows);
  g_fur.projection = glm::perspective(glm::radians(45.0f), 1.0f, 0.5f, 10.0f);
  const glm::vec3 eye = {0.9f, 1.2f, 3.0f};
  g_fur.modelView = glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0));
  g_fur.eye = glm::vec4(eye, 1);
  g_fur.light = glm::vec4(glm::normalize(glm::vec3(0.6f, 0.7f, 0.5f)), 0);
  g_fur.skin.upload();
  g_fur.fins.upload();
  makeImages();
  for (GLenum unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    g_textures[unit] =
        unit == 0 ? newTexture(GL_NEAREST, GL_REPEAT) : newTexture(GL_LINEAR, GL_CLAMP_TO_EDGE);
    uploadImage(unit == 0 ? g_fur.hairs : g_fur.table, unit == 0 ? kHairs : kTable);
  }
}

void beginState() {
  loadMatrices(g_fur.projection, g_fur.modelView);
  glClearColor(kClear.r, kClear.g, kClear.b, kClear.a);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_ALPHA_TEST);
  glAlphaFunc(GL_GREATER, 0);
  for (GLenum unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, g_textures[unit]);
    glEnable(GL_TEXTURE_2D);
  }
}

void draw() {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  for (int shell = 0; shell < kShells; ++shell) {
    glMultiTexCoord1f(GL_TEXTURE1, shellAt(shell));
    g_fur.skin.draw(false);
  }
  g_fur.fins.draw(true);
}

void end() {
  endPrograms();
  glDisable(GL_ALPHA_TEST);
  glDisable(GL_DEPTH_TEST);
  for (const GLenum unit : {GL_TEXTURE1, GL_TEXTURE0}) {
    glActiveTexture(unit);
    glDisable(GL_TEXTURE_2D);
  }
}

constexpr char kNvVertices[] =
    "!!VP1.0\n"
    // c[0..3]: to clip space; c[4]: length, 0.5, 1, 0; c[5]: light; c[6]: eye; c[7]: 0.35, 0.65
    "MUL R0.w, v[TEX1].x, c[4].x;\n"
    "MOV R1, v[OPOS];\n"
    "MAD R0.xyz, v[NRML], R0.w, R1;\n"
    "MOV R0.w, c[4].z;\n"
    "DP4 o[HPOS].x, c[0], R0;\n"
    "DP4 o[HPOS].y, c[1], R0;\n"
    "DP4 o[HPOS].z, c[2], R0;\n"
    "DP4 o[HPOS].w, c[3], R0;\n"
    "ADD R1, c[6], -R0;\n"
    "DP3 R1.w, R1, R1;\n"
    "RSQ R1.w, R1.w;\n"
    "MAD R1.xyz, R1, R1.w, c[5];\n"
    "DP3 R1.w, R1, R1;\n"
    "RSQ R1.w, R1.w;\n"
    "MUL R1.xyz, R1, R1.w;\n"
    "DP3 R2.x, v[TEX2], c[5];\n"
    "DP3 R2.y, v[TEX2], R1;\n"
    "MAD o[TEX1].xy, R2, c[4].y, c[4].y;\n"
    "MOV o[TEX0].xy, v[TEX0];\n"
    "MOV R3, c[7];\n"
    "MAD o[COL0].xyz, v[TEX1].x, R3.y, R3.x;\n"
    "MOV o[COL0].w, v[TEX1].x;\n"
    "END";

/// Sets stage 0 to hair times light, and the strand's remaining coverage. Stage 1 multiplies both
/// by the shade.
void combineFur() {
  glEnable(GL_REGISTER_COMBINERS_NV);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 2);
  combinerInput(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_A_NV, GL_TEXTURE0);
  combinerInput(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_B_NV, GL_TEXTURE1);
  combinerInput(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_C_NV, GL_ZERO);
  combinerInput(GL_COMBINER0_NV, GL_RGB, GL_VARIABLE_D_NV, GL_ZERO);
  combinerOutput(GL_COMBINER0_NV, GL_RGB, GL_SPARE0_NV, GL_DISCARD_NV);
  combinerInput(GL_COMBINER0_NV, GL_ALPHA, GL_VARIABLE_A_NV, GL_TEXTURE0, GL_SIGNED_IDENTITY_NV,
                GL_ALPHA);
  combinerInput(GL_COMBINER0_NV, GL_ALPHA, GL_VARIABLE_B_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV,
                GL_ALPHA);
  combinerInput(GL_COMBINER0_NV, GL_ALPHA, GL_VARIABLE_C_NV, GL_PRIMARY_COLOR_NV,
                GL_SIGNED_NEGATE_NV, GL_ALPHA);
  combinerInput(GL_COMBINER0_NV, GL_ALPHA, GL_VARIABLE_D_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV,
                GL_ALPHA);
  combinerOutput(GL_COMBINER0_NV, GL_ALPHA, GL_DISCARD_NV, GL_SPARE0_NV);
  combinerInput(GL_COMBINER1_NV, GL_RGB, GL_VARIABLE_A_NV, GL_SPARE0_NV);
  combinerInput(GL_COMBINER1_NV, GL_RGB, GL_VARIABLE_B_NV, GL_PRIMARY_COLOR_NV);
  combinerInput(GL_COMBINER1_NV, GL_RGB, GL_VARIABLE_C_NV, GL_TEXTURE1, GL_UNSIGNED_IDENTITY_NV,
                GL_ALPHA);
  combinerInput(GL_COMBINER1_NV, GL_RGB, GL_VARIABLE_D_NV, GL_PRIMARY_COLOR_NV);
  glCombinerOutputNV(GL_COMBINER1_NV, GL_RGB, GL_DISCARD_NV, GL_DISCARD_NV, GL_SPARE1_NV, GL_NONE,
                     GL_NONE, GL_FALSE, GL_FALSE, GL_FALSE);
  combinerOutput(GL_COMBINER1_NV, GL_ALPHA, GL_DISCARD_NV, GL_DISCARD_NV);
  finalInput(GL_VARIABLE_A_NV, GL_ZERO);
  finalInput(GL_VARIABLE_B_NV, GL_ZERO);
  finalInput(GL_VARIABLE_C_NV, GL_ZERO);
  finalInput(GL_VARIABLE_D_NV, GL_SPARE1_NV);
  finalInput(GL_VARIABLE_G_NV, GL_SPARE0_NV, GL_UNSIGNED_IDENTITY_NV, GL_ALPHA);
}

void beginAsThen() {
  beginState();
  useNvProgram(kNvVertices);
  glTrackMatrixNV(GL_VERTEX_PROGRAM_NV, 0, GL_MODELVIEW_PROJECTION_NV, GL_IDENTITY_NV);
  const glm::vec4 rows[] = {{kLength, 0.5f, 1, 0}, g_fur.light, g_fur.eye, {0.35f, 0.65f, 0, 0}};
  for (GLuint i = 0; i < 4; ++i)
    glProgramParameter4fvNV(GL_VERTEX_PROGRAM_NV, 4 + i, &rows[i].x);
  combineFur();
}

constexpr char kArbVertices[] =
    "!!ARBvp1.0\n"
    "PARAM toClip[4] = { state.matrix.mvp };\n"
    "PARAM numbers = program.env[4];\nPARAM light = program.env[5];\nPARAM eye = program.env[6];\n"
    "PARAM shade = program.env[7];\nTEMP place, half, cosines;\n"
    "MUL place.w, vertex.texcoord[1].x, numbers.x;\n"
    "MAD place.xyz, vertex.normal, place.w, vertex.position;\n"
    "MOV place.w, numbers.z;\n"
    "DP4 result.position.x, toClip[0], place;\nDP4 result.position.y, toClip[1], place;\n"
    "DP4 result.position.z, toClip[2], place;\nDP4 result.position.w, toClip[3], place;\n"
    "SUB half, eye, place;\n"
    "DP3 half.w, half, half;\nRSQ half.w, half.w;\n"
    "MAD half.xyz, half, half.w, light;\n"
    "DP3 half.w, half, half;\nRSQ half.w, half.w;\n"
    "MUL half.xyz, half, half.w;\n"
    "DP3 cosines.x, vertex.texcoord[2], light;\n"
    "DP3 cosines.y, vertex.texcoord[2], half;\n"
    "MAD result.texcoord[1].xy, cosines, numbers.y, numbers.y;\n"
    "MOV result.texcoord[1].zw, numbers.wwwz;\n" // combiners divide by q
    "MOV result.texcoord[0].xy, vertex.texcoord[0];\n"
    "MOV result.texcoord[0].zw, numbers.wwwz;\n"
    "MAD result.color.xyz, vertex.texcoord[1].x, shade.y, shade.x;\n"
    "MOV result.color.w, vertex.texcoord[1].x;\n"
    "END";

constexpr char kArbFragments[] = "!!ARBfp1.0\n"
                                 "TEMP hair, light, color;\n"
                                 "TXP hair, fragment.texcoord[0], texture[0], 2D;\n"
                                 "TXP light, fragment.texcoord[1], texture[1], 2D;\n"
                                 "MUL color.xyz, hair, light;\n"
                                 "MUL color.xyz, color, fragment.color;\n"
                                 "MAD result.color.xyz, light.w, fragment.color, color;\n"
                                 "SUB result.color.w, hair.w, fragment.color.w;\n"
                                 "END";

void beginByArb() {
  beginState();
  useArbProgram(GL_VERTEX_PROGRAM_ARB, kArbVertices);
  const glm::vec4 rows[] = {{kLength, 0.5f, 1, 0}, g_fur.light, g_fur.eye, {0.35f, 0.65f, 0, 0}};
  for (GLuint i = 0; i < 4; ++i)
    glProgramEnvParameter4fvARB(GL_VERTEX_PROGRAM_ARB, 4 + i, &rows[i].x);
  useArbProgram(GL_FRAGMENT_PROGRAM_ARB, kArbFragments);
}

/// Sets ARB vertices with combiners, which shows the cost of the combiners alone.
void beginByCombiners() {
  beginByArb();
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  combineFur();
}

// --- Plain C++ ---

gallery::Vertex shadeVertex(const MeshVertex &vertex, float height) {
  gallery::Vertex result;
  const glm::vec3 place = vertex.position + vertex.normal * (height * kLength);
  result.clip = glm::dvec4(g_fur.projection * (g_fur.modelView * glm::vec4(place, 1)));
  const glm::vec3 light = glm::vec3(g_fur.light);
  const glm::vec3 half = glm::normalize(light + glm::normalize(glm::vec3(g_fur.eye) - place));
  result.varyings[0] = glm::vec4(vertex.texture, 0, 1);
  result.varyings[1] = {glm::dot(vertex.tangent, light) * 0.5f + 0.5f,
                        glm::dot(vertex.tangent, half) * 0.5f + 0.5f, 0, 1};
  result.varyings[gallery::kColor] = glm::vec4(glm::vec3(height * 0.65f + 0.35f), height);
  return result;
}

glm::vec4 hairAt(const glm::vec4 &at) {
  const auto texel = [](float c) { return int(std::floor(c * kHairs)) & (kHairs - 1); };
  return g_fur.hairs[std::size_t(texel(at.y) * kHairs + texel(at.x))];
}

/// True if a sample is within the resolution of hosts' filters between two texels.
bool isBetweenHairs(const glm::vec4 &at) {
  const auto near = [](float c) {
    return std::abs(c * kHairs - std::round(c * kHairs)) < 1.0f / 200;
  };
  return near(at.x) || near(at.y);
}

glm::vec4 lightAt(const glm::vec4 &at) {
  const float u = at.x * kTable - 0.5f, v = at.y * kTable - 0.5f;
  const float left = std::floor(u), low = std::floor(v);
  const auto texel = [&](int dx, int dy) {
    const int x = std::clamp(int(left) + dx, 0, kTable - 1);
    const int y = std::clamp(int(low) + dy, 0, kTable - 1);
    return g_fur.table[std::size_t(y * kTable + x)];
  };
  return glm::mix(glm::mix(texel(0, 0), texel(1, 0), u - left),
                  glm::mix(texel(0, 1), texel(1, 1), u - left), v - low);
}

void drawMesh(Canvas &canvas, const Mesh &mesh, const float *height) {
  std::vector<gallery::Vertex> shaded;
  for (const MeshVertex &vertex : mesh.vertices)
    shaded.push_back(shadeVertex(vertex, height ? *height : vertex.extra.x));
  std::array<bool, gallery::kVaryings> used{};
  used[0] = used[1] = used[gallery::kColor] = true;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    gallery::rasterize(shaded[mesh.indices[i]], shaded[mesh.indices[i + 1]],
                       shaded[mesh.indices[i + 2]], canvas.size, canvas.size, used,
                       [&](const gallery::Fragment &fragment) {
                         const auto at = std::size_t(fragment.y * canvas.size + fragment.x);
                         const glm::vec4 &shade = fragment.varyings[gallery::kColor];
                         const glm::vec4 hair = hairAt(fragment.varyings[0]);
                         if (fragment.depth > canvas.depths[at])
                           return;
                         const bool between = isBetweenHairs(fragment.varyings[0]);
                         canvas.undecided[at] = canvas.undecided[at] || between;
                         if (hair.a - shade.a <= 0)
                           return;
                         canvas.undecided[at] = between; // it hides what lies below
                         const glm::vec4 light = lightAt(fragment.varyings[1]);
                         canvas.depths[at] = fragment.depth;
                         canvas.colors[at] =
                             glm::vec4(glm::vec3(hair * light * shade) + light.a * glm::vec3(shade),
                                       hair.a - shade.a);
                       });
}

Canvas reference(int size) {
  Canvas canvas(size, kClear);
  for (int shell = 0; shell < kShells; ++shell) {
    const float height = shellAt(shell);
    drawMesh(canvas, g_fur.skin, &height);
  }
  drawMesh(canvas, g_fur.fins, nullptr);
  return canvas;
}

} // namespace

Scene furScene() {
  return {"fur",
          prepare,
          {{"arb", "GL_ARB_vertex_program GL_ARB_fragment_program", beginByArb, draw, end},
           {"combiners", "GL_NV_register_combiners", beginByCombiners, draw, end},
           {"as-then", "GL_NV_register_combiners GL_NV_vertex_program", beginAsThen, draw, end}},
          reference,
          3,
          0.006}; // strands are single texels: a sample may fall to the next one
}

} // namespace scenes
