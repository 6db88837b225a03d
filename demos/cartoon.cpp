#include "common/demo.h"
#include "common/program.h"
#include "common/rasterize.h"
#include "common/texture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <optional>

namespace demos {
namespace {

struct Vertex {
  glm::vec3 position;
  glm::vec3 normal;
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<GLuint> indices; ///< three for each triangle
};

/// Returns a point of the (2,3) torus knot's core at \p t in [0, 2 pi).
glm::vec3 knotCore(float t) {
  const float radius = 1.0f + 0.42f * std::cos(3.0f * t);
  return {radius * std::cos(2.0f * t), radius * std::sin(2.0f * t), 0.36f * std::sin(3.0f * t)};
}

Mesh makeKnot() {
  constexpr int kAlong = 320, kAround = 32;
  constexpr float kTube = 0.245f, kTurn = 6.2831853f;
  Mesh mesh;
  for (int i = 0; i < kAlong; ++i) {
    const float t = kTurn * float(i) / float(kAlong);
    const glm::vec3 core = knotCore(t);
    const glm::vec3 tangent = glm::normalize(knotCore(t + 0.001f) - knotCore(t - 0.001f));
    // This direction points away from the torus that the knot winds around, which is never along
    // the knot.
    const glm::vec3 away(std::cos(3.0f * t) * std::cos(2.0f * t),
                         std::cos(3.0f * t) * std::sin(2.0f * t), std::sin(3.0f * t));
    const glm::vec3 side = glm::normalize(glm::cross(tangent, away));
    const glm::vec3 up = glm::cross(side, tangent);
    for (int j = 0; j < kAround; ++j) {
      const float angle = kTurn * float(j) / float(kAround);
      const glm::vec3 normal = std::cos(angle) * side + std::sin(angle) * up;
      mesh.vertices.push_back({core + kTube * normal, normal});
      const auto index = [](int along, int around) {
        return GLuint((along % kAlong) * kAround + around % kAround);
      };
      const GLuint a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1),
                   d = index(i, j + 1);
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  return mesh;
}

/// Makes four paints by the angle to the light; each edge is one texel wide.
Image makePaints() {
  Image row(128, 1);
  for (int x = 0; x < row.width; ++x) {
    const float s = (float(x) + 0.5f) / float(row.width);
    glm::vec3 paint(0.36f, 0.07f, 0.16f);
    if (s > 0.38f)
      paint = {0.72f, 0.13f, 0.20f};
    if (s > 0.66f)
      paint = {0.95f, 0.31f, 0.24f};
    if (s > 0.955f)
      paint = {1.0f, 0.86f, 0.74f};
    row.set(x, 0, glm::vec4(paint, 1.0f));
  }
  return row;
}

/// Makes the ink for surfaces that are seen edge on.
Image makeInk() {
  Image row(128, 1);
  for (int x = 0; x < row.width; ++x)
    row.set(x, 0,
            glm::vec4(glm::vec3((float(x) + 0.5f) / float(row.width) > 0.3f ? 1.0f : 0.05f), 1));
  return row;
}

/// Samples a 1D texture with GL_LINEAR and GL_CLAMP_TO_EDGE.
glm::vec3 sample1d(const Image &row, float s) { return glm::vec3(row.sampleLinear({s, 0.5f})); }

constexpr glm::vec3 kBottom(0.93f, 0.88f, 0.74f), kTop(0.55f, 0.75f, 0.83f);

/// The transformations of one frame.
struct View {
  glm::mat4 projection;
  glm::mat4 modelView;
  glm::mat4 rotation;
};

/// Shades a knot by 1D textures, with a depth buffer and fixed-function vertices. The normal and
/// the eye-space position are passed as texture coordinates, through the texture matrices.
class Cartoon final : public Demo {
public:
  [[nodiscard]] std::string name() const override { return "cartoon"; }
  [[nodiscard]] std::string summary() const override {
    return "Shades a torus knot like a cartoon, through 1D textures.";
  }
  [[nodiscard]] std::string controls() const override { return "  Mouse drag  turns the light\n"; }
  [[nodiscard]] std::vector<Slider *> sliders() override { return {&m_lightX, &m_lightY, &m_turn}; }
  // A few pixels may fall on the other side of a silhouette or of a paint's edge.
  [[nodiscard]] Tolerance tolerance() const override { return {8, 0.002}; }
  [[nodiscard]] int verifyFrames() const override { return 2; }

  [[nodiscard]] bool start(const Surface &surface, const Options &options) override;
  void draw(const Surface &surface, int frame) override;
  [[nodiscard]] Image reference(int width, int height, int frame) override;
  void stop() override {
    if (m_buffers[0])
      glDeleteBuffers(2, m_buffers);
    m_gl.reset();
  }
  [[nodiscard]] std::vector<std::string> programCounts() const override {
    return {m_gl->program.countsAsJson()};
  }
  void pointer(glm::vec2 at) override {
    m_lightX.value = 2.0f * at.x - 1.0f;
    m_lightY.value = 2.0f * at.y - 1.0f;
  }

private:
  struct Objects {
    Texture paints;
    Texture ink;
    Program program;
  };

  [[nodiscard]] View view(int width, int height, int frame) const;
  [[nodiscard]] glm::vec3 light() const {
    return glm::normalize(glm::vec3(m_lightX.value, m_lightY.value, 0.8f));
  }
  void drawKnot(const View &view) const;

  Slider m_lightX{"light-x", "where the light comes from: -1 left, 1 right", -0.45f, -1, 1, 0.05f};
  Slider m_lightY{"light-y", "where the light comes from: -1 below, 1 above", 0.65f, -1, 1, 0.05f};
  Slider m_turn{"turn", "of the knot, in radians", 0.0f, -6.3f, 6.3f, 0.05f};
  Mesh m_mesh;
  Image m_paints;
  Image m_ink;
  GLuint m_buffers[2] = {0, 0};
  std::optional<Objects> m_gl;
};

bool Cartoon::start(const Surface &, const Options &options) {
  m_mesh = makeKnot();
  m_paints = makePaints();
  m_ink = makeInk();
  m_gl.emplace();
  m_gl->paints.create1d(m_paints, Filter::Linear);
  m_gl->ink.create1d(m_ink, Filter::Linear);
  glGenBuffers(2, m_buffers);
  glBindBuffer(GL_ARRAY_BUFFER, m_buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(m_mesh.vertices.size() * sizeof(Vertex)),
               m_mesh.vertices.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(m_mesh.indices.size() * sizeof(GLuint)),
               m_mesh.indices.data(), GL_STATIC_DRAW);
  return m_gl->program.load("cartoon.fp", options.program);
}

View Cartoon::view(int width, int height, int frame) const {
  const float aspect = float(width) / float(height);
  const float angle = m_turn.value + float(frame) * 0.015f;
  View view;
  // The knot fits the narrower side.
  const float slope = std::tan(0.30f) * std::max(1.0f, 1.0f / aspect);
  view.projection = glm::frustum(-slope * aspect, slope * aspect, -slope, slope, 1.0f, 20.0f);
  view.rotation = glm::rotate(glm::rotate(glm::mat4(1.0f), -0.2f, glm::vec3(1, 0, 0)), angle,
                              glm::normalize(glm::vec3(0.15f, 0.2f, 1.0f)));
  view.modelView = glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, -6.2f)) * view.rotation;
  return view;
}

void Cartoon::drawKnot(const View &view) const {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(glm::value_ptr(view.projection));
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(view.modelView));
  const glm::mat4 textureMatrices[2] = {view.rotation, view.modelView};
  const std::size_t offsets[2] = {offsetof(Vertex, normal), offsetof(Vertex, position)};
  glMatrixMode(GL_TEXTURE);
  for (GLenum unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glLoadMatrixf(glm::value_ptr(textureMatrices[unit]));
    glClientActiveTexture(GL_TEXTURE0 + unit);
    // NOLINTNEXTLINE(performance-no-int-to-ptr): with a buffer bound, GL takes an offset here.
    glTexCoordPointer(3, GL_FLOAT, sizeof(Vertex), reinterpret_cast<const void *>(offsets[unit]));
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glVertexPointer(3, GL_FLOAT, sizeof(Vertex), nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  glDrawElements(GL_TRIANGLES, GLsizei(m_mesh.indices.size()), GL_UNSIGNED_INT, nullptr);
  for (GLenum unit = 0; unit < 2; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glLoadIdentity();
  }
}

void Cartoon::draw(const Surface &surface, int frame) {
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  for (GLenum mode : {GL_PROJECTION, GL_MODELVIEW}) {
    glMatrixMode(mode);
    glLoadIdentity();
  }
  glBegin(GL_QUADS);
  glColor3fv(&kBottom.x);
  glVertex2f(-1, -1);
  glVertex2f(1, -1);
  glColor3fv(&kTop.x);
  glVertex2f(1, 1);
  glVertex2f(-1, 1);
  glEnd();
  glEnable(GL_DEPTH_TEST);
  m_gl->paints.bind(0);
  m_gl->ink.bind(1);
  m_gl->program.use();
  m_gl->program.local(0, glm::vec4(light(), 0.0f));
  drawKnot(view(surface.width(), surface.height(), frame));
  Program::disable();
}

Image Cartoon::reference(int width, int height, int frame) {
  const View now = view(width, height, frame);
  const glm::vec3 towards = light();
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      image.set(x, y, glm::vec4(glm::mix(kBottom, kTop, image.coordinate(x, y).y), 1.0f));
  std::vector<RasterVertex> vertices;
  for (const Vertex &vertex : m_mesh.vertices) {
    const glm::vec4 eye = now.modelView * glm::vec4(vertex.position, 1.0f);
    vertices.push_back(
        {now.projection * eye, {glm::mat3(now.rotation) * vertex.normal, glm::vec3(eye)}});
  }
  Rasterizer rasterizer(width, height);
  const auto shade = [&](int x, int y, const glm::vec3(&varyings)[2]) {
    const glm::vec3 normal = glm::normalize(varyings[0]);
    const float edge = glm::clamp(glm::dot(normal, glm::normalize(-varyings[1])), 0.0f, 1.0f);
    const float angle = glm::dot(normal, towards) * 0.5f + 0.5f;
    image.set(x, y, glm::vec4(sample1d(m_paints, angle) * sample1d(m_ink, edge), 1.0f));
  };
  for (std::size_t i = 0; i < m_mesh.indices.size(); i += 3)
    rasterizer.triangle(vertices[m_mesh.indices[i]], vertices[m_mesh.indices[i + 1]],
                        vertices[m_mesh.indices[i + 2]], shade);
  return image;
}

} // namespace
} // namespace demos

int main(int argc, char **argv) {
  demos::Cartoon demo;
  return demos::run(demo, argc, argv);
}
