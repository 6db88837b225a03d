// Vertex arrays and primitives in display lists: software-list-arrays programs-first | lists-first
// | no-programs. Each list is compiled, its arrays are overwritten, and it is called under a
// fragment program that was made before the lists, after them, or under none; pixels and errors are
// written out, to be compared between two sides.
#include <cstdio>
#include <cstring>
#include <functional>
#include <utility>

#include "surface.h"

namespace software {
namespace {

constexpr int kSize = 64;

constexpr GLenum kModes[] = {GL_POINTS,         GL_LINES,        GL_LINE_STRIP, GL_LINE_LOOP,
                             GL_TRIANGLES,      GL_TRIANGLE_FAN, GL_QUADS,      GL_QUAD_STRIP,
                             GL_TRIANGLE_STRIP, GL_POLYGON};
constexpr int kVertices = 24;

/// One vertex in all types.
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

std::vector<Vertex> makeVertices(Random &random) {
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

struct Scene {
  Random random{7};
  std::vector<Vertex> vertices = makeVertices(random);
  std::vector<GLushort> indices;
  GLuint buffers[2] = {};
  GLuint part = 0; ///< of callParts()

  Scene() {
    for (int i = 0; i < kVertices; ++i)
      indices.push_back(GLushort(random.below(kVertices)));
    glGenBuffers(2, buffers);
    part = glGenLists(2);
  }
  /// What arrays are pointed at: client memory, or the buffer.
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
  };
  std::vector<List> lists;
  /// Compiles what `commands` do; client memory is another after.
  void compile(const std::string &name, const std::function<void()> &commands) {
    const std::vector<Vertex> before = vertices;
    const GLuint list = glGenLists(1);
    glNewList(list, GL_COMPILE);
    commands();
    glEndList();
    const std::string errors = takeErrors();
    std::memset(static_cast<void *>(vertices.data()), 0, sizeof(Vertex) * kVertices);
    vertices = before;
    none();
    lists.push_back({name + errors, list});
  }
  void call(const List &list) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glColor4f(0.3f, 0.9f, 0.5f, 1);
    glSecondaryColor3f(0.1f, 0.2f, 0);
    glTexCoord4f(0.7f, 0.1f, 0.4f, 1);
    glNormal3f(0, 0, 1);
    glEdgeFlag(GL_TRUE);
    glCallList(list.list);
    record(list.name + takeErrors(), readRgba(0, 0, kSize, kSize));
    // What the list leaves behind.
    glBegin(GL_TRIANGLES);
    glVertex2f(-1, -1), glVertex2f(1, -1), glVertex2f(-1, 1);
    glEnd();
    record(list.name + " after" + takeErrors(), readRgba(0, 0, kSize, kSize));
  }
};

void compileModes(Scene &scene) {
  for (const bool inBuffer : {false, true})
    for (const GLenum mode : kModes) {
      const std::string name =
          std::string(inBuffer ? "buffer" : "client") + " mode " + std::to_string(mode);
      scene.place(inBuffer);
      scene.positions(), scene.colors(), scene.coords();
      scene.compile(name + " arrays", [&] { glDrawArrays(mode, 3, 13); });
      scene.place(inBuffer);
      scene.positions(), scene.coords();
      scene.compile(name + " elements",
                    [&] { glDrawElements(mode, 17, GL_UNSIGNED_SHORT, scene.indices.data()); });
      scene.place(inBuffer);
      scene.positions(), scene.colors();
      glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, scene.buffers[1]);
      glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(2 * scene.indices.size()),
                   scene.indices.data(), GL_STATIC_DRAW);
      scene.compile(name + " range", [&] {
        glDrawRangeElements(mode, 0, kVertices - 1, 12, GL_UNSIGNED_SHORT,
                            reinterpret_cast<const void *>(4));
      });
    }
}

void compileTypes(Scene &scene) {
  scene.place(false);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(4, GL_DOUBLE, sizeof(Vertex), scene.at(&Vertex::doubles));
  glEnableClientState(GL_COLOR_ARRAY);
  glColorPointer(4, GL_BYTE, sizeof(Vertex), scene.at(&Vertex::bytes));
  scene.compile("doubles and signed bytes", [] { glDrawArrays(GL_TRIANGLES, 0, 9); });
  scene.place(false);
  glEnableClientState(GL_VERTEX_ARRAY);
  glVertexPointer(2, GL_SHORT, sizeof(Vertex), scene.at(&Vertex::shorts));
  glEnableClientState(GL_SECONDARY_COLOR_ARRAY);
  glSecondaryColorPointer(3, GL_UNSIGNED_BYTE, sizeof(Vertex), scene.at(&Vertex::color));
  scene.compile("shorts and secondary colours", [] { glDrawArrays(GL_TRIANGLES, 0, 24); });
  scene.place(false);
  scene.positions();
  glEnableClientState(GL_EDGE_FLAG_ARRAY);
  glEdgeFlagPointer(sizeof(Vertex), &scene.vertices[0].edge);
  scene.compile("edge flags", [] {
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    glDrawArrays(GL_TRIANGLES, 0, 12);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  });
  scene.place(false);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), scene.at(&Vertex::position));
  scene.colors();
  scene.compile("generic attributes", [] { glDrawArrays(GL_TRIANGLE_STRIP, 1, 9); });
  scene.place(false);
  scene.positions();
  glEnableClientState(GL_NORMAL_ARRAY);
  glNormalPointer(GL_BYTE, sizeof(Vertex), scene.at(&Vertex::normal));
  scene.compile("lit", [] {
    glEnable(GL_LIGHTING);
    glEnable(GL_LIGHT0);
    glEnable(GL_COLOR_MATERIAL);
    glDrawArrays(GL_TRIANGLES, 3, 12);
    glDisable(GL_COLOR_MATERIAL);
    glDisable(GL_LIGHTING);
  });
}

void compileCommands(Scene &scene) {
  static const GLint kFirst[] = {0, 6, 15};
  static const GLsizei kCount[] = {3, 0, 6};
  scene.place(true);
  scene.positions(), scene.colors();
  scene.compile("several arrays", [] { glMultiDrawArrays(GL_TRIANGLES, kFirst, kCount, 3); });
  scene.place(true);
  scene.positions(), scene.colors();
  const void *const parts[] = {scene.indices.data(), nullptr, scene.indices.data() + 9};
  scene.compile("several elements",
                [&] { glMultiDrawElements(GL_TRIANGLES, kCount, GL_UNSIGNED_SHORT, parts, 3); });
  scene.place(true);
  scene.positions(), scene.colors();
  scene.compile("base vertex", [] {
    static const GLubyte kIndices[] = {0, 2, 4, 1, 3, 5};
    glDrawElementsBaseVertex(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, kIndices, 11);
  });
  scene.place(false);
  scene.positions(), scene.colors(), scene.coords();
  scene.compile("elements of a primitive", [] {
    glBegin(GL_TRIANGLES);
    for (int i = 0; i < 6; ++i)
      glArrayElement(2 * i);
    glColor3f(1, 0, 0);
    glVertex2f(-0.5f, -0.5f), glVertex2f(0.5f, -0.5f), glVertex2f(0, 0.5f);
    glArrayElement(1), glArrayElement(7), glArrayElement(3);
    glEnd();
  });
  scene.place(false);
  scene.positions(), scene.colors();
  scene.compile("arrays that change", [&] {
    glDrawArrays(GL_TRIANGLES, 0, 6);
    glDisableClientState(GL_COLOR_ARRAY);
    glColor3f(0, 1, 1);
    glDrawArrays(GL_TRIANGLES, 6, 6);
    scene.coords();
    glVertexPointer(2, GL_FLOAT, sizeof(Vertex), &scene.vertices[5].position);
    glDrawArrays(GL_TRIANGLES, 6, 9);
    scene.vertices[2].position[0] = -1;
    glDrawArrays(GL_LINES, 0, 6);
  });
  scene.place(false);
  scene.colors();
  scene.compile("no positions", [] { glDrawArrays(GL_TRIANGLES, 0, 6); });
  scene.place(false);
  scene.positions(), scene.colors();
  scene.compile("restarts", [] {
    static const GLuint kIndices[] = {0, 1, 2, 3, 9, 5, 6, 7, 8};
    glEnable(GL_PRIMITIVE_RESTART);
    glPrimitiveRestartIndex(9);
    glDrawElements(GL_TRIANGLE_STRIP, 9, GL_UNSIGNED_INT, kIndices);
    glDisable(GL_PRIMITIVE_RESTART);
  });
  scene.place(true);
  scene.positions(), scene.colors();
  scene.compile("mistakes", [] {
    glDrawArrays(GL_TRIANGLES, 0, -1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDrawElements(GL_TRIANGLES, 3, GL_FLOAT, nullptr);
    glDrawArrays(0x4242, 0, 3);
  });
  scene.place(true);
  scene.positions(), scene.colors();
  scene.compile("state between", [] {
    glPushMatrix();
    glScalef(0.5f, 0.5f, 1);
    glDrawArrays(GL_QUADS, 0, 8);
    glTranslatef(0.9f, 0, 0);
    glDrawArrays(GL_QUADS, 8, 8);
    glPopMatrix();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glDrawArrays(GL_TRIANGLES, 3, 9);
    glDisable(GL_BLEND);
  });
  scene.place(true);
  scene.positions(), scene.colors();
  const GLuint inner = scene.lists.back().list;
  scene.compile("a list within", [inner] {
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glCallList(inner);
    glDrawArrays(GL_TRIANGLES, 9, 6);
  });
}

/// Begin and End, and attributes outside of them.
void compilePrimitives(Scene &scene) {
  const auto triangle = [](float x, float y) {
    glTexCoord2f(0.2f, 0.9f), glVertex2f(x, y);
    glTexCoord3f(0.9f, 0.1f, 0.5f), glVertex3f(x + 0.6f, y, 0.2f);
    glVertex4f(x, y + 0.6f, 0, 0.9f);
  };
  scene.compile("primitives", [&] {
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f);
    triangle(0, 0);
    glEnd();
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, 0.1f);
    glEnd();
    glRectf(0.1f, -0.8f, 0.5f, -0.4f);
  });
  scene.compile("attributes outside", [&] {
    glColor3ub(250, 20, 90);
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f);
    glEnd();
    glSecondaryColor3f(0.3f, 0, 0.2f);
    glColor4f(0, 1, 0, 0.5f);
    glTexCoord1f(0.8f);
    glBegin(GL_QUADS);
    glVertex2f(0, 0), glVertex2f(0.9f, 0), glVertex2f(0.9f, 0.9f), glVertex2f(0, 0.9f);
    glEnd();
    glColor3f(0.1f, 0.2f, 0.9f);
  });
  scene.compile("attributes alone",
                [] { glColor3f(0.9f, 0.2f, 0.1f), glTexCoord4f(0.5f, 0, 0, 1); });
  scene.compile("nothing", [] {});
  scene.place(true);
  scene.positions();
  scene.compile("attributes and arrays", [] {
    glColor3f(1, 0.5f, 0);
    glDrawArrays(GL_TRIANGLES, 0, 6);
    glColor3f(0, 0.5f, 1);
    glDrawArrays(GL_TRIANGLES, 6, 6);
  });
  scene.compile("state after a primitive", [&] {
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f);
    glEnd();
    glColor3f(0, 1, 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBegin(GL_TRIANGLES);
    triangle(-0.7f, -0.7f);
    glEnd();
    glDisable(GL_BLEND);
  });
  scene.compile("a command within a primitive", [&] {
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 1);
    triangle(-0.9f, -0.9f);
    glMaterialf(GL_FRONT, GL_SHININESS, 3);
    triangle(0, 0);
    glEnd();
    glBegin(GL_LINES);
    triangle(-0.5f, -0.8f);
    glVertex2f(0.9f, 0.9f);
    glEnd();
  });
}

/// The name of a list is another's: of a few commands, none of which may be left of the first.
void compileAgain(Scene &scene) {
  const auto quad = [](float x, float size) { glRectf(x, x, x + size, x + size); };
  scene.compile("replaced by primitives", [&] { quad(-0.9f, 1.2f); });
  const GLuint first = scene.lists.back().list;
  glNewList(first, GL_COMPILE);
  quad(0.1f, 0.3f);
  glEndList();
  scene.compile("replaced by state", [&] { quad(-0.9f, 1.2f); });
  const GLuint second = scene.lists.back().list;
  glNewList(second, GL_COMPILE);
  glTranslatef(0.2f, 0, 0);
  quad(0.1f, 0.3f);
  glLoadIdentity();
  glEndList();
  scene.compile("replaced and executed", [&] { quad(-0.9f, 1.2f); });
  const GLuint third = scene.lists.back().list;
  glNewList(third, GL_COMPILE_AND_EXECUTE);
  quad(-0.4f, 0.3f);
  glEndList();
  scene.compile("deleted", [&] { quad(-0.9f, 1.2f); });
  glDeleteLists(scene.lists.back().list, 1);
}

/// Parts of primitives that several lists make, or lists and the application.
void callParts(Scene &scene) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glBegin(GL_TRIANGLES);
  glCallList(scene.part);
  glVertex2f(-0.9f, 0.3f);
  glCallList(scene.part);
  glVertex2f(0.1f, 0.9f);
  glEnd();
  glCallList(scene.part + 1);
  glVertex2f(0.9f, -0.9f);
  glEnd();
  record("parts" + takeErrors(), readRgba(0, 0, kSize, kSize));
}

/// Vertices without Begin and End.
void compileParts(Scene &scene) {
  glNewList(scene.part, GL_COMPILE);
  glColor3f(0.9f, 0.4f, 0);
  glVertex2f(-0.5f, -0.8f);
  glColor3f(0.1f, 0.4f, 0.9f);
  glVertex2f(0.7f, 0.1f);
  glEndList();
}

/// The last one that is compiled: Mesa 22.3.6 loses vertices of lists after it.
void compileOpen(Scene &scene) {
  glNewList(scene.part + 1, GL_COMPILE);
  glColor3f(0, 0.4f, 0);
  glBegin(GL_TRIANGLES);
  glVertex2f(0.5f, -0.8f);
  glColor3f(0.6f, 0, 0.9f);
  glVertex2f(0.7f, 0.7f);
  glEndList();
}

/// Called together, with a base.
void callTogether(const Scene &scene) {
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  std::vector<GLushort> names;
  for (std::size_t i = 0; i < scene.lists.size(); i += 7)
    names.push_back(GLushort(scene.lists[i].list - 1));
  glListBase(1);
  glCallLists(GLsizei(names.size()), GL_UNSIGNED_SHORT, names.data());
  glListBase(0);
  record("together" + takeErrors(), readRgba(0, 0, kSize, kSize));
}

void makeTheProgram() {
  (void)makeProgram(GL_FRAGMENT_PROGRAM_ARB,
                    "!!ARBfp1.0\nTEMP t;\nMUL t, fragment.texcoord[0], 0.5;\n"
                    "ADD t, t, fragment.color.secondary;\n"
                    "MAD result.color, fragment.color, 0.7, t;\nEND\n");
}

/// What has a list watched by the layer, and all that call others from then on.
void compileWatched(Scene &scene) {
  scene.compile("End alone", [] { glEnd(); });
  const GLuint inner = scene.lists.front().list;
  scene.compile("a list of primitives within", [inner] {
    glCallList(inner);
    glBegin(GL_TRIANGLES);
    glVertex2f(0.2f, 0.2f), glVertex2f(0.8f, 0.2f), glVertex2f(0.2f, 0.8f);
    glEnd();
  });
}

void compileAll(Scene &scene) {
  compileModes(scene);
  compileTypes(scene);
  compileCommands(scene);
  compilePrimitives(scene);
}

enum class Order { ProgramsFirst, ListsFirst, NoPrograms };

int run(Order order) {
  Screen screen;
  if (!screen.open())
    return 2;
  const GLXDrawable window = screen.makeWindow(kSize, kSize);
  screen.makeCurrent(window, screen.makeContext());
  if (order == Order::ProgramsFirst)
    makeTheProgram();
  Scene first, scene;
  compileAll(first); // libepoxy asks about the host where a function is first called, in a list too
  compileAll(scene);
  compileAgain(scene);
  compileParts(scene);
  compileWatched(scene);
  compileOpen(scene);
  if (order == Order::ListsFirst)
    makeTheProgram();
  if (order != Order::NoPrograms)
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_DITHER);
  glClearColor(0.1f, 0.2f, 0.3f, 1);
  for (std::size_t i = 0; i < scene.lists.size(); ++i) {
    scene.call(scene.lists[i]);
    if (i % 4 == 3)
      screen.swap(window);
  }
  callTogether(scene);
  callParts(scene);
  return 0;
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using software::Order;
  const std::pair<const char *, Order> orders[] = {{"programs-first", Order::ProgramsFirst},
                                                   {"lists-first", Order::ListsFirst},
                                                   {"no-programs", Order::NoPrograms}};
  for (const auto &[name, order] : orders)
    if (argc == 2 && !std::strcmp(argv[1], name))
      return software::run(order);
  return 1;
}
