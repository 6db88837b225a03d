// Tests vertex arrays and primitives in display lists: rasterizer-list-arrays programs-first |
// lists-first | no-programs. Each list is compiled, its arrays are overwritten, and it is called
// with a fragment program that was made before the lists, after them, or with none. Writes pixels
// and errors, which are compared between two sides.
#include <cstring>
#include <utility>

#include "list_scene.h"

namespace software::list_scene {
namespace {

constexpr GLenum kModes[] = {GL_POINTS,         GL_LINES,        GL_LINE_STRIP, GL_LINE_LOOP,
                             GL_TRIANGLES,      GL_TRIANGLE_FAN, GL_QUADS,      GL_QUAD_STRIP,
                             GL_TRIANGLE_STRIP, GL_POLYGON};
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
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 8);
    glTranslatef(0.9f, 0, 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 8, 8);
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

/// Calls lists together, with a base.
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

void compileAll(Scene &scene) {
  compileModes(scene);
  compileTypes(scene);
  compileCommands(scene);
  compilePrimitives(scene);
}

enum class Order { ProgramsFirst, ListsFirst, NoPrograms };

void setState(Order order) {
  if (order != Order::NoPrograms)
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_DITHER);
  glClearColor(0.1f, 0.2f, 0.3f, 1);
}

int run(Order order, Executed executed) {
  Screen screen;
  if (!screen.open())
    return 2;
  const GLXDrawable window = screen.makeWindow(kSize, kSize);
  screen.makeCurrent(window, screen.makeContext());
  if (order == Order::ProgramsFirst)
    makeTheProgram();
  Scene first, scene;
  compileAll(first); // libepoxy queries the host at a function's first call, even in a list
  scene.executed = executed;
  if (executed != Executed::No)
    setState(order);
  compileAll(scene);
  compileAgain(scene);
  compileParts(scene);
  compileWatched(scene);
  compileOpen(scene);
  deleteLists(scene);
  if (order == Order::ListsFirst)
    makeTheProgram();
  setState(order);
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
} // namespace software::list_scene

int main(int argc, char **argv) {
  using software::list_scene::Executed;
  using software::list_scene::Order;
  const std::pair<const char *, Order> orders[] = {{"programs-first", Order::ProgramsFirst},
                                                   {"lists-first", Order::ListsFirst},
                                                   {"no-programs", Order::NoPrograms}};
  const std::pair<const char *, Executed> modes[] = {
      {"compiled", Executed::No}, {"executed", Executed::AtOnce}, {"called", Executed::After}};
  for (const auto &[name, order] : orders)
    for (const auto &[modeName, mode] : modes)
      if (argc == 3 && !std::strcmp(argv[1], name) && !std::strcmp(argv[2], modeName))
        return software::list_scene::run(order, mode);
  return 1;
}
