#include "states.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace software {

namespace {

struct Vertex {
  float position[3];
  float normal[3];
  float color[4];
  GLubyte bytes[4];
  float secondary[3];
  float fog;
  float coordinate[4];
};

using Points = std::vector<std::array<float, 2>>;

/// Returns places: some of each kind face one way and some the other; some leave the view.
Points placesOf(GLenum primitive) {
  switch (primitive) {
  case GL_POINTS:
    return {{-0.91f, -0.83f}, {-0.42f, 0.57f}, {0.13f, 0.21f}, {0.64f, -0.35f},
            {0.31f, 0.77f},   {-0.65f, 0.11f}, {0.82f, 0.43f}, {0.03f, -0.61f}};
  case GL_LINES:
  case GL_LINE_STRIP:
  case GL_LINE_LOOP:
    return {{-0.9f, -0.7f}, {0.8f, -0.4f}, {-0.6f, 0.85f}, {-0.2f, -0.8f},
            {0.1f, 0.3f},   {0.7f, 0.9f},  {0.85f, 0.1f},  {-0.8f, 0.2f}};
  case GL_TRIANGLES:
    return {{-0.95f, -0.9f}, {0.3f, -0.75f}, {-0.4f, 0.6f}, {0.1f, 0.9f},   {1.3f, 0.7f},
            {0.45f, -0.2f},  {-0.7f, 0.95f}, {0.6f, 0.5f},  {-0.2f, -0.55f}};
  case GL_TRIANGLE_STRIP:
  case GL_QUAD_STRIP:
    return {{-0.9f, -0.8f}, {-0.85f, 0.7f}, {-0.3f, -0.6f}, {-0.2f, 0.9f},
            {0.3f, -0.9f},  {0.35f, 0.6f},  {1.2f, -0.5f},  {0.9f, 0.8f}};
  case GL_QUADS:
    return {{-0.95f, -0.9f}, {0.2f, -0.8f}, {0.3f, 0.35f}, {-0.8f, 0.5f},
            {-0.3f, -0.2f},  {-0.2f, 0.9f}, {0.95f, 0.8f}, {0.8f, -0.6f}};
  default: // convex and in order
    return {{0.9f, 0.1f},    {0.4f, 0.85f},    {-0.4f, 0.8f},
            {-0.9f, -0.05f}, {-0.45f, -0.85f}, {0.55f, -0.75f}};
  }
}

/// Returns the number of a vertex's separate primitive. If two of them overlapped in one sloped
/// plane, the last bit of an interpolation would decide the depth test.
int primitiveOf(GLenum mode, int vertex) {
  return mode == GL_TRIANGLES ? vertex / 3 : mode == GL_QUADS ? vertex / 4 : 0;
}

void place(const Scene &scene, float x, float y, float (&coordinate)[4]) {
  // The range is slightly less than the whole: 48 pixels of 32 texels would have every third sample
  // on a border.
  float s = 0.49f * x + 0.507f, t = 0.49f * y + 0.504f;
  switch (scene.choice("coordinates")) {
  case 1:
    s *= 5.3f, t *= 4.1f;
    break;
  case 2:
    s = 0.3f + 0.17f * s, t = 0.4f + 0.13f * t;
    break;
  case 3: {
    const float turned = 0.87f * s - 0.5f * t;
    t = 1.3f * (0.5f * s + 0.87f * t), s = 1.2f * turned;
    break;
  }
  case 4:
    s = 4.3f * s - 1.6f, t = 3.7f * t - 1.4f;
    break;
  default:
    break;
  }
  const GLenum target = scene.token("texture");
  coordinate[0] = s, coordinate[1] = t, coordinate[2] = 0.5f + 0.3f * x - 0.1f * y;
  coordinate[3] = scene.choice("program") == 4 ? 1.4f + 0.5f * x : 1.0f;
  if (target == GL_TEXTURE_CUBE_MAP) {
    coordinate[0] = 2 * s - 0.9f, coordinate[1] = 1.1f - 2 * t, coordinate[2] = 0.7f - 0.5f * x;
  } else if (target == GL_TEXTURE_RECTANGLE_ARB) {
    coordinate[0] *= 32, coordinate[1] *= 28;
  }
}

std::vector<Vertex> makeVertices(const Scene &scene, int pass) {
  std::vector<Vertex> vertices;
  for (const auto &[x, y] : placesOf(scene.token("primitive"))) {
    const auto i = float(vertices.size());
    Vertex vertex{};
    const int depths = scene.choice("depths");
    const float apart = -0.08f * float(primitiveOf(scene.token("primitive"), int(vertices.size())));
    const float z = depths == 0   ? 0.05f - 0.2f * float(pass)
                    : depths == 1 ? 0.45f * x - 0.3f * y + apart
                                  : 0.9f * x + 0.3f * y + apart;
    const float wide = depths == 2 ? 0.95f : 1.0f;
    const float position[3] = {wide * x, wide * y, z};
    const float normal[3] = {0.6f * x, 0.6f * y, 0.8f - 0.02f * i};
    const float shade[4] = {
        0.5f + 0.45f * std::sin(1.3f * i + float(pass)), 0.5f + 0.45f * std::cos(0.9f * i),
        0.5f + 0.4f * std::sin(2.1f * i + 1.0f), 0.55f + 0.4f * std::cos(1.7f * i + 0.5f)};
    for (int c = 0; c < 3; ++c) {
      vertex.position[c] = position[c];
      vertex.normal[c] = normal[c];
      vertex.secondary[c] = 0.3f * shade[2 - c];
    }
    for (int c = 0; c < 4; ++c) {
      vertex.color[c] = shade[c];
      vertex.bytes[c] = static_cast<GLubyte>(255.0f * shade[c]);
    }
    vertex.fog = 0.2f + 0.12f * i;
    place(scene, x, y, vertex.coordinate);
    vertices.push_back(vertex);
  }
  return vertices;
}

void immediately(const Scene &scene, const std::vector<Vertex> &vertices) {
  const bool bytes = scene.choice("colors") != 0;
  glBegin(scene.token("primitive"));
  for (const Vertex &vertex : vertices) {
    glNormal3fv(vertex.normal);
    if (bytes)
      glColor4ubv(vertex.bytes);
    else
      glColor4fv(vertex.color);
    glSecondaryColor3fv(vertex.secondary);
    glFogCoordf(vertex.fog);
    glTexCoord4fv(vertex.coordinate);
    glVertex3fv(vertex.position);
  }
  glEnd();
}

void pointTo(const Scene &scene, const GLubyte *base) {
  constexpr GLsizei kStride = sizeof(Vertex);
  const auto at = [&](std::size_t offset) {
    return base ? static_cast<const void *>(base + offset) : reinterpret_cast<const void *>(offset);
  };
  glVertexPointer(3, GL_FLOAT, kStride, at(offsetof(Vertex, position)));
  glNormalPointer(GL_FLOAT, kStride, at(offsetof(Vertex, normal)));
  if (scene.choice("colors") != 0)
    glColorPointer(4, GL_UNSIGNED_BYTE, kStride, at(offsetof(Vertex, bytes)));
  else
    glColorPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, color)));
  glSecondaryColorPointer(3, GL_FLOAT, kStride, at(offsetof(Vertex, secondary)));
  glFogCoordPointer(GL_FLOAT, kStride, at(offsetof(Vertex, fog)));
  glTexCoordPointer(4, GL_FLOAT, kStride, at(offsetof(Vertex, coordinate)));
  for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
                             GL_SECONDARY_COLOR_ARRAY, GL_FOG_COORD_ARRAY, GL_TEXTURE_COORD_ARRAY})
    glEnableClientState(array);
}

} // namespace

void drawPrimitives(const Scene &scene, int pass) {
  static constexpr GLushort kOrder[] = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<Vertex> vertices = makeVertices(scene, pass);
  const auto count = GLsizei(vertices.size());
  const GLenum mode = scene.token("primitive");
  static constexpr float kConstant[4] = {0.8f, 0.4f, 0.2f, 0.6f};
  glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, 0, kConstant);
  const int submit = scene.choice("submit");
  if (submit == 0)
    return immediately(scene, vertices);
  if (submit == 5) {
    glNewList(1, GL_COMPILE);
    immediately(scene, vertices);
    glEndList();
    return glCallList(1);
  }
  GLuint buffers[2] = {};
  const bool inBuffer = submit == 3 || submit == 4;
  if (inBuffer) {
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(Vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof kOrder, kOrder, GL_STATIC_DRAW);
  }
  pointTo(scene, inBuffer ? nullptr : reinterpret_cast<const GLubyte *>(vertices.data()));
  if (submit == 2 || submit == 4) {
    glDrawElements(mode, count, GL_UNSIGNED_SHORT, inBuffer ? nullptr : kOrder);
  } else if (submit == 7) {
    glDrawRangeElements(mode, 0, GLuint(count - 1), count, GL_UNSIGNED_SHORT, kOrder);
  } else if (submit == 6) {
    glNewList(1, GL_COMPILE);
    glDrawArrays(mode, 0, count);
    glEndList();
    glCallList(1);
  } else {
    glDrawArrays(mode, 0, count);
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
}

} // namespace software
