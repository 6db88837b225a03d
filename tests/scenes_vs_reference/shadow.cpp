// A sphere over a floor, with its shadow by a depth map. It is drawn by SGI's extensions for depth
// textures and their comparison, by ARB's, by register combiners after the comparison, and by ARB
// programs.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "../gallery_vs_interpreter/raster.h"
#include "scenes.h"

namespace scenes {

namespace {

constexpr glm::vec4 kClear = {0.5f, 0.6f, 0.7f, 1};
constexpr float kAmbient = 0.25f, kDiffuse = 0.7f;

struct World {
  Mesh mesh; ///< sphere and floor, with colors of one
  glm::mat4 projection{1}, modelView{1}, lightProjection{1}, lightView{1};
  glm::vec3 light{0}; ///< its direction
} g_world;

GLuint g_map = 0;

void append(Mesh &to, const Mesh &from, const glm::mat4 &place) {
  const auto base = std::uint32_t(to.vertices.size());
  for (MeshVertex vertex : from.vertices) {
    vertex.position = glm::vec3(place * glm::vec4(vertex.position, 1));
    to.vertices.push_back(vertex);
  }
  for (const std::uint32_t index : from.indices)
    to.indices.push_back(base + index);
}

Mesh floorMesh() {
  constexpr int kSide = 16;
  Mesh mesh;
  for (int z = 0; z <= kSide; ++z)
    for (int x = 0; x <= kSide; ++x)
      mesh.vertices.push_back(
          {{float(x) * 6 / kSide - 3, -1, float(z) * 6 / kSide - 3}, {0, 1, 0}});
  for (int z = 0; z < kSide; ++z)
    for (int x = 0; x < kSide; ++x) {
      const auto at = std::uint32_t(z * (kSide + 1) + x);
      mesh.quad(at, at + kSide + 1, at + kSide + 2, at + 1);
    }
  return mesh;
}

void prepare() {
  g_world.mesh = {};
  append(g_world.mesh, floorMesh(), glm::mat4(1));
  append(g_world.mesh, sphere(64, 32), glm::scale(glm::mat4(1), glm::vec3(0.7f)));
  g_world.mesh.upload();
  g_world.projection = glm::perspective(glm::radians(45.0f), 1.0f, 1.0f, 12.0f);
  g_world.modelView =
      glm::lookAt(glm::vec3(-2, 2.6f, 4), glm::vec3(0, -0.4f, 0), glm::vec3(0, 1, 0));
  g_world.light = glm::normalize(glm::vec3(0.5f, 0.9f, 0.3f));
  g_world.lightProjection = glm::ortho(-3.2f, 3.2f, -3.2f, 3.2f, 1.0f, 12.0f);
  g_world.lightView = glm::lookAt(g_world.light * 6.0f, glm::vec3(0), glm::vec3(0, 1, 0));
  glActiveTexture(GL_TEXTURE0);
  g_map = newTexture(GL_NEAREST, GL_CLAMP_TO_EDGE);
  const GLint internal = GL_DEPTH_COMPONENT24; // SGIX's enumerant has the same value
  glTexImage2D(GL_TEXTURE_2D, 0, internal, pictureSize(), pictureSize(), 0, GL_DEPTH_COMPONENT,
               GL_UNSIGNED_INT, nullptr);
}

/// Returns the matrix from object space to the map's, [0,1] in each coordinate.
glm::mat4 toMap() {
  glm::mat4 half(0.5f);
  half[3] = {0.5f, 0.5f, 0.5f, 1};
  return half * g_world.lightProjection * g_world.lightView;
}

void beginState() {
  glEnable(GL_DEPTH_TEST);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, g_map);
}

/// Draws the depths as the light sees them, and copies them into the map.
void drawMap() {
  loadMatrices(g_world.lightProjection, g_world.lightView);
  glDepthFunc(GL_LESS);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(4, 64);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glClear(GL_DEPTH_BUFFER_BIT);
  g_world.mesh.draw(false);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, pictureSize(), pictureSize());
}

void clearPicture() {
  loadMatrices(g_world.projection, g_world.modelView);
  glClearColor(kClear.r, kClear.g, kClear.b, kClear.a);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void end() {
  endPrograms();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_LIGHTING);
  glDisable(GL_BLEND);
  for (const GLenum coordinate :
       {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R, GL_TEXTURE_GEN_Q})
    glDisable(coordinate);
  glDisable(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
}

// --- Fixed function: the lit part by the comparison, then what is everywhere, added ---

void useLight() {
  const glm::vec4 direction(g_world.light, 0), black(0, 0, 0, 1),
      diffuse(kDiffuse, kDiffuse, kDiffuse, 1), white(1);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, &black.x);
  glLightfv(GL_LIGHT0, GL_AMBIENT, &black.x);
  glLightfv(GL_LIGHT0, GL_DIFFUSE, &diffuse.x);
  glLightfv(GL_LIGHT0, GL_SPECULAR, &black.x);
  glLightfv(GL_LIGHT0, GL_POSITION, &direction.x); // transformed by the view's matrix
  glMaterialfv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &white.x);
  glEnable(GL_LIGHT0);
}

void generateCoordinates() {
  const glm::mat4 matrix = toMap();
  constexpr GLenum kNames[] = {GL_S, GL_T, GL_R, GL_Q};
  constexpr GLenum kEnables[] = {GL_TEXTURE_GEN_S, GL_TEXTURE_GEN_T, GL_TEXTURE_GEN_R,
                                 GL_TEXTURE_GEN_Q};
  for (int i = 0; i < 4; ++i) {
    const glm::vec4 row = {matrix[0][i], matrix[1][i], matrix[2][i], matrix[3][i]};
    glTexGeni(kNames[i], GL_TEXTURE_GEN_MODE, GL_OBJECT_LINEAR);
    glTexGenfv(kNames[i], GL_OBJECT_PLANE, &row.x);
    glEnable(kEnables[i]);
  }
}

void drawFixed() {
  drawMap();
  clearPicture();
  useLight();
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_LIGHTING);
  g_world.mesh.draw(false);
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  // The offset moves the second pass slightly towards the eye: two rasterizers may share the work,
  // and their depths differ.
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -8);
  glColor4f(kAmbient, kAmbient, kAmbient, 0);
  g_world.mesh.draw(false);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_BLEND);
}

void beginFixed() {
  beginState();
  generateCoordinates();
  glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
}

void beginBySgi() {
  beginFixed();
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, GL_TRUE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_OPERATOR_SGIX, GL_TEXTURE_LEQUAL_R_SGIX);
}

void endBySgi() {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_SGIX, GL_FALSE);
  end();
}

void compareByArb() {
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE_ARB, GL_COMPARE_R_TO_TEXTURE_ARB);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC_ARB, GL_LEQUAL);
}

void beginByArb() {
  beginFixed();
  compareByArb();
}

// --- Register combiners: both parts at once ---

void beginByCombiners() {
  beginFixed();
  compareByArb();
  const GLfloat ambient[] = {kAmbient, kAmbient, kAmbient, 1};
  glCombinerParameterfvNV(GL_CONSTANT_COLOR0_NV, ambient);
  glCombinerParameteriNV(GL_NUM_GENERAL_COMBINERS_NV, 1);
  for (const GLenum portion : {GL_RGB, GL_ALPHA})
    combinerOutput(GL_COMBINER0_NV, portion, GL_DISCARD_NV, GL_DISCARD_NV);
  finalInput(GL_VARIABLE_A_NV, GL_TEXTURE0);
  finalInput(GL_VARIABLE_B_NV, GL_PRIMARY_COLOR_NV);
  finalInput(GL_VARIABLE_C_NV, GL_ZERO);
  finalInput(GL_VARIABLE_D_NV, GL_CONSTANT_COLOR0_NV);
  finalInput(GL_VARIABLE_G_NV, GL_ZERO, GL_UNSIGNED_INVERT_NV, GL_ALPHA);
}

void drawByCombiners() {
  glDisable(GL_REGISTER_COMBINERS_NV);
  drawMap();
  clearPicture();
  useLight();
  glEnable(GL_REGISTER_COMBINERS_NV);
  glEnable(GL_TEXTURE_2D);
  glEnable(GL_LIGHTING);
  g_world.mesh.draw(false);
  glDisable(GL_LIGHTING);
  glDisable(GL_TEXTURE_2D);
}

// --- ARB's programs ---

constexpr char kVertices[] =
    "!!ARBvp1.0\nPARAM toClip[4] = { state.matrix.mvp };\nPARAM toMap[4] = { program.env[0..3] };\n"
    "TEMP lit;\n"
    "DP4 result.position.x, toClip[0], vertex.position;\n"
    "DP4 result.position.y, toClip[1], vertex.position;\n"
    "DP4 result.position.z, toClip[2], vertex.position;\n"
    "DP4 result.position.w, toClip[3], vertex.position;\n"
    "DP4 result.texcoord[0].x, toMap[0], vertex.position;\n"
    "DP4 result.texcoord[0].y, toMap[1], vertex.position;\n"
    "DP4 result.texcoord[0].z, toMap[2], vertex.position;\n"
    "DP4 result.texcoord[0].w, toMap[3], vertex.position;\n"
    "DP3 lit.x, vertex.normal, program.env[4];\n"
    "MAX lit.x, lit.x, 0.0;\nMUL result.color, lit.x, program.env[5];\nEND";
constexpr char kFragments[] = "!!ARBfp1.0\nOPTION ARB_fragment_program_shadow;\nTEMP lit;\n"
                              "TXP lit, fragment.texcoord[0], texture[0], SHADOW2D;\n"
                              "MAD result.color.xyz, lit.x, fragment.color, program.env[0];\n"
                              "MOV result.color.w, 1.0;\nEND";

GLuint g_vertices = 0, g_fragments = 0;

void beginByPrograms() {
  beginState();
  compareByArb();
  g_vertices = useArbProgram(GL_VERTEX_PROGRAM_ARB, kVertices);
  const glm::mat4 matrix = toMap();
  for (int i = 0; i < 4; ++i)
    glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, GLuint(i), matrix[0][i], matrix[1][i],
                               matrix[2][i], matrix[3][i]);
  glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 4, g_world.light.x, g_world.light.y,
                             g_world.light.z, 0);
  glProgramEnvParameter4fARB(GL_VERTEX_PROGRAM_ARB, 5, kDiffuse, kDiffuse, kDiffuse, 1);
  g_fragments = useArbProgram(GL_FRAGMENT_PROGRAM_ARB, kFragments);
  glProgramEnvParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, kAmbient, kAmbient, kAmbient, 0);
}

void drawByPrograms() {
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  drawMap();
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  clearPicture();
  glDepthFunc(GL_LESS);
  g_world.mesh.draw(false);
}

// --- Plain C++ ---

using Shaded = std::vector<gallery::Vertex>;

Shaded shade(const glm::mat4 &toClip) {
  Shaded shaded;
  const glm::mat4 matrix = toMap();
  for (const MeshVertex &vertex : g_world.mesh.vertices) {
    gallery::Vertex result;
    const glm::vec4 place(vertex.position, 1);
    result.clip = glm::dvec4(toClip * place);
    result.varyings[0] = matrix * place;
    const float lit = std::max(glm::dot(vertex.normal, g_world.light), 0.0f) * kDiffuse;
    result.varyings[gallery::kColor] = glm::vec4(lit, lit, lit, 1);
    shaded.push_back(result);
  }
  return shaded;
}

template <typename Use> void each(const Shaded &shaded, int size, const Use &use) {
  std::array<bool, gallery::kVaryings> used{};
  used[0] = used[gallery::kColor] = true;
  const std::vector<std::uint32_t> &indices = g_world.mesh.indices;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
    gallery::rasterize(shaded[indices[i]], shaded[indices[i + 1]], shaded[indices[i + 2]], size,
                       size, used, use);
}

Canvas reference(int size) {
  Canvas map(size, glm::vec4(0)), canvas(size, kClear);
  each(shade(g_world.lightProjection * g_world.lightView), size,
       [&](const gallery::Fragment &fragment) {
         double &depth = map.depths[std::size_t(fragment.y * size + fragment.x)];
         depth = std::min(depth, fragment.depth);
       });
  each(shade(g_world.projection * g_world.modelView), size, [&](const gallery::Fragment &fragment) {
    const auto at = std::size_t(fragment.y * size + fragment.x);
    if (fragment.depth >= canvas.depths[at])
      return;
    canvas.depths[at] = fragment.depth;
    const glm::vec4 place = fragment.varyings[0] / fragment.varyings[0].w;
    const auto texel = [&](float c) {
      return std::clamp(int(std::floor(c * float(size))), 0, size - 1);
    };
    const double nearest = map.depths[std::size_t(texel(place.y) * size + texel(place.x))];
    const bool lit = double(place.z) <= nearest + 0.02; // stands for the offset of the map
    const glm::vec3 color = lit ? glm::vec3(fragment.varyings[gallery::kColor]) : glm::vec3(0);
    canvas.colors[at] = glm::vec4(color + kAmbient, 1);
  });
  return canvas;
}

} // namespace

Scene shadowScene() {
  const char *const depths = "GL_ARB_shadow GL_ARB_depth_texture";
  return {"shadow",
          prepare,
          {{"arb", depths, beginByArb, drawFixed, end},
           {"programs", "GL_ARB_fragment_program GL_ARB_fragment_program_shadow", beginByPrograms,
            drawByPrograms, end},
           {"combiners", "GL_NV_register_combiners GL_ARB_shadow", beginByCombiners,
            drawByCombiners, end},
           {"as-then", "GL_SGIX_depth_texture GL_SGIX_shadow", beginBySgi, drawFixed, endBySgi}},
          reference,
          3,
          0.01}; // the edges of shadows, and the floor's edge in the map
}

} // namespace scenes
