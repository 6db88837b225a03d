#pragma once
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "surface.h"

/// Shared parts of the scenes of rasterizer-list-arrays.
namespace software::list_scene {

inline constexpr int kSize = 64; ///< of the window, in pixels

inline constexpr int kVertices = 24;

/// A vertex in all types.
struct Vertex {
  GLfloat position[3];
  GLshort shorts[2];
  GLdouble doubles[4];
  GLubyte color[4];
  GLbyte normal[3];
  GLbyte bytes[4];
  GLfloat coords[4];
  GLubyte edge;
};

inline std::vector<Vertex> makeVertices(Random &random) {
  std::vector<Vertex> vertices(kVertices);
  const auto unit = [&] { return float(random.below(1001)) / 1000; };
  for (Vertex &v : vertices) {
    v.position[0] = 2 * unit() - 1, v.position[1] = 2 * unit() - 1, v.position[2] = unit() - 0.5f;
    v.shorts[0] = GLshort(random.between(-1, 1)), v.shorts[1] = GLshort(random.between(-1, 1));
    for (int i = 0; i < 4; ++i) {
      v.doubles[i] = i == 3 ? 1 : 2.0 * unit() - 1;
      v.color[i] = GLubyte(random.below(256));
      v.bytes[i] = GLbyte(random.between(-128, 127));
      v.coords[i] = i == 3 ? 1 : unit();
    }
    for (GLbyte &n : v.normal)
      n = GLbyte(random.between(-128, 127));
    v.edge = GLubyte(random.below(2));
  }
  return vertices;
}

/// How lists are executed in addition to being compiled.
enum class Executed {
  No,
  AtOnce, ///< GL_COMPILE_AND_EXECUTE
  /// Called when they are compiled, which draws what AtOnce should. Mesa 22.3.6 believes to be
  /// inside Begin/End behind a primitive of a list that it also executes, and refuses the rest.
  After,
};

/// Display lists, and the arrays that they are compiled from.
struct Scene {
  Executed executed = Executed::No;
  Random random{7};
  std::vector<Vertex> vertices = makeVertices(random);
  std::vector<GLushort> indices;
  GLuint buffers[2] = {};
  GLuint part = 0; ///< for callParts()

  Scene() {
    for (int i = 0; i < kVertices; ++i)
      indices.push_back(GLushort(random.below(kVertices)));
    glGenBuffers(2, buffers);
    part = glGenLists(2);
  }
  /// The arrays' data: client memory, or the buffer.
  const Vertex *source = nullptr;
  void place(bool inBuffer) {
    glBindBuffer(GL_ARRAY_BUFFER, inBuffer ? buffers[0] : 0);
    if (inBuffer)
      glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(sizeof(Vertex)) * kVertices, vertices.data(),
                   GL_STATIC_DRAW);
    source = inBuffer ? nullptr : vertices.data();
  }
  template <std::size_t N, typename T> const void *at(T (Vertex::*member)[N]) const {
    return source ? static_cast<const void *>((source->*member))
                  : reinterpret_cast<const void *>(
                        reinterpret_cast<const char *>(vertices[0].*member) -
                        reinterpret_cast<const char *>(vertices.data()));
  }
  void positions() {
    glEnableClientState(GL_VERTEX_ARRAY);
    glVertexPointer(3, GL_FLOAT, sizeof(Vertex), at(&Vertex::position));
  }
  void colors() {
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), at(&Vertex::color));
  }
  void coords() {
    glEnableClientState(GL_TEXTURE_COORD_ARRAY);
    glTexCoordPointer(4, GL_FLOAT, sizeof(Vertex), at(&Vertex::coords));
  }
  static void none() {
    for (const GLenum array : {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
                               GL_NORMAL_ARRAY, GL_EDGE_FLAG_ARRAY, GL_SECONDARY_COLOR_ARRAY})
      glDisableClientState(array);
    for (GLuint i = 0; i < 8; ++i)
      glDisableVertexAttribArray(i);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
  }

  struct List {
    std::string name;
    GLuint list;
    /// Draws what the list must draw, if that is also drawn directly
    std::function<void()> commands;
  };
  std::vector<List> lists;
  /// Compiles the commands of `commands`; client memory changes afterwards.
  void compile(const std::string &name, const std::function<void()> &commands) {
    const std::vector<Vertex> before = vertices;
    const GLuint list = glGenLists(1);
    if (executed != Executed::No)
      begin();
    glNewList(list, executed == Executed::AtOnce ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    commands();
    glEndList();
    if (executed == Executed::After)
      glCallList(list);
    const std::string errors = takeErrors();
    if (executed != Executed::No)
      look(name + " while compiled" + errors);
    std::memset(static_cast<void *>(vertices.data()), 0, sizeof(Vertex) * kVertices);
    vertices = before;
    none();
    lists.push_back({name + errors, list, {}});
  }
  /// Compiles commands that only depend on the state of begin(). They set all components, or as few
  /// as the defaults allow, of which the list gets the few. After a call all are drawn at once too,
  /// and must look equal (OpenGL 2.1, 2.7 and 5.4).
  void compileDrawn(const std::string &name, const std::function<void(bool whole)> &commands) {
    compile(name, [&] { commands(false); });
    lists.back().commands = [commands] { commands(true); };
  }
  void call(const List &list) {
    begin();
    glCallList(list.list);
    look(list.name + takeErrors());
    if (!list.commands)
      return;
    begin();
    list.commands();
    look(list.name + " directly" + takeErrors());
  }
  /// Sets the state for lists that set no attributes.
  static void begin() {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor4f(0.3f, 0.9f, 0.5f, 1);
    glSecondaryColor3f(0.1f, 0.2f, 0);
    glTexCoord4f(0.7f, 0.1f, 0.4f, 1);
    glNormal3f(0, 0, 1);
    glEdgeFlag(GL_TRUE);
  }
  /// Records what a list drew, and its effect on later draws.
  static void look(const std::string &name) {
    record(name, readRgba(0, 0, kSize, kSize));
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(-1, 1);
    glEnd();
    record(name + " after" + takeErrors(), readRgba(0, 0, kSize, kSize));
  }
};

// These are in list_primitives.cpp.

/// Compiles Begin and End, and attributes outside of them.
void compilePrimitives(Scene &scene);
/// Compiles a list under the name of another: it has few commands, and nothing of the first may be
/// left.
void compileAgain(Scene &scene);
/// Deletes lists that are called afterwards; called after the last compilation, which could get
/// their names.
void deleteLists(const Scene &scene);
/// Compiles vertices without Begin and End.
void compileParts(Scene &scene);
/// Compiles commands that make the layer watch a list, and all lists that call others from then on.
void compileWatched(Scene &scene);
/// Compiles the last list: Mesa 22.3.6 loses vertices of lists after it.
void compileOpen(Scene &scene);
/// Calls lists that each have a part of a primitive, with parts from the application.
void callParts(Scene &scene);

} // namespace software::list_scene
