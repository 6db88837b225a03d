#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

namespace scenes {

Mesh sphere(int columns, int rows) {
  Mesh mesh;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      const float u = float(column) / float(columns), v = float(row) / float(rows);
      const float around = u * glm::two_pi<float>(), down = v * glm::pi<float>();
      const glm::vec3 at = {std::sin(down) * std::cos(around), std::cos(down),
                            std::sin(down) * std::sin(around)};
      MeshVertex vertex{at, at};
      vertex.tangent = {std::cos(down) * std::cos(around), -std::sin(down),
                        std::cos(down) * std::sin(around)};
      // Avoids vertices between two of 64 texels
      vertex.texture = {u * 4 + 0.5f / 64, v * 2 + 0.5f / 64};
      mesh.vertices.push_back(vertex);
    }
  const auto at = [&](int column, int row) { return std::uint32_t(row * (columns + 1) + column); };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      mesh.quad(at(column, row), at(column + 1, row), at(column + 1, row + 1), at(column, row + 1));
  return mesh;
}

void Mesh::upload() {
  glGenBuffers(2, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(vertices.size() * sizeof(MeshVertex)), vertices.data(),
               GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(indices.size() * sizeof(std::uint32_t)),
               indices.data(), GL_STATIC_DRAW);
}

void Mesh::draw(bool extra) const {
  const auto at = [](std::size_t offset) { return reinterpret_cast<const void *>(offset); };
  constexpr GLsizei kStride = sizeof(MeshVertex);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
  glVertexPointer(3, GL_FLOAT, kStride, at(offsetof(MeshVertex, position)));
  glNormalPointer(GL_FLOAT, kStride, at(offsetof(MeshVertex, normal)));
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  const struct {
    GLint components;
    std::size_t offset;
    bool used;
  } sets[] = {{2, offsetof(MeshVertex, texture), true},
              {4, offsetof(MeshVertex, extra), extra},
              {3, offsetof(MeshVertex, tangent), true}};
  for (GLenum set = 0; set < 3; ++set) {
    glClientActiveTexture(GL_TEXTURE0 + set);
    glTexCoordPointer(sets[set].components, GL_FLOAT, kStride, at(sets[set].offset));
    if (sets[set].used)
      glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    else
      glDisableClientState(GL_TEXTURE_COORD_ARRAY);
  }
  glDrawElements(GL_TRIANGLES, GLsizei(indices.size()), GL_UNSIGNED_INT, nullptr);
}

void loadMatrices(const glm::mat4 &projection, const glm::mat4 &modelView) {
  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(glm::value_ptr(projection));
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(glm::value_ptr(modelView));
}

GLuint newTexture(GLint filter, GLint wrap) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  return name;
}

GLuint useArbProgram(GLenum target, const char *text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(std::strlen(text)), text);
  GLint at = -1;
  glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &at);
  if (at >= 0)
    std::fprintf(stderr, "a program of ARB's: %s\n",
                 reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB)));
  glEnable(target);
  return name;
}

GLuint useNvProgram(const char *text) {
  GLuint name = 0;
  glGenProgramsARB(1, &name);
  glLoadProgramNV(GL_VERTEX_PROGRAM_NV, name, GLsizei(std::strlen(text)),
                  reinterpret_cast<const GLubyte *>(text));
  GLint at = -1;
  glGetIntegerv(GL_PROGRAM_ERROR_POSITION_NV, &at);
  if (at >= 0)
    std::fprintf(stderr, "a program of NVIDIA's: a mistake at byte %d\n", at);
  glBindProgramNV(GL_VERTEX_PROGRAM_NV, name);
  glEnable(GL_VERTEX_PROGRAM_NV);
  return name;
}

void endPrograms() {
  glDisable(GL_VERTEX_PROGRAM_ARB);
  glDisable(GL_FRAGMENT_PROGRAM_ARB);
  if (epoxy_has_gl_extension("GL_NV_register_combiners"))
    glDisable(GL_REGISTER_COMBINERS_NV);
  if (epoxy_has_gl_extension("GL_NV_vertex_program")) // they are the same as ARB's env parameters
    glTrackMatrixNV(GL_VERTEX_PROGRAM_NV, 0, GL_NONE, GL_IDENTITY_NV);
}

void combinerInput(GLenum stage, GLenum portion, GLenum variable, GLenum source, GLenum mapping,
                   GLenum usage) {
  glCombinerInputNV(stage, portion, variable, source, mapping, usage);
}

void combinerOutput(GLenum stage, GLenum portion, GLenum product, GLenum sum) {
  glCombinerOutputNV(stage, portion, product, GL_DISCARD_NV, sum, GL_NONE, GL_NONE, GL_FALSE,
                     GL_FALSE, GL_FALSE);
}

void finalInput(GLenum variable, GLenum source, GLenum mapping, GLenum usage) {
  glFinalCombinerInputNV(variable, source, mapping, usage);
}

Canvas::Canvas(int side, const glm::vec4 &clear)
    : size(side), colors(std::size_t(side) * std::size_t(side), clear), depths(colors.size(), 1.0),
      undecided(colors.size(), false) {}

Picture Canvas::bytes() const {
  Picture picture;
  picture.reserve(colors.size() * 4);
  for (const glm::vec4 &color : colors)
    for (int i = 0; i < 4; ++i)
      picture.push_back(std::uint8_t(std::lround(std::clamp(color[i], 0.0f, 1.0f) * 255)));
  return picture;
}

} // namespace scenes
