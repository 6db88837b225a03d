// Display lists of primitives, of parts of them, and lists that others replace.
#include "list_scene.h"

namespace software::list_scene {

void compilePrimitives(Scene &scene) {
  // With `whole` the commands also set the components that otherwise have defaults.
  const auto triangle = [](float x, float y, bool whole) {
    whole ? glTexCoord4f(0.2f, 0.9f, 0, 1) : glTexCoord2f(0.2f, 0.9f);
    whole ? glVertex4f(x, y, 0, 1) : glVertex2f(x, y);
    whole ? glTexCoord4f(0.9f, 0.1f, 0.5f, 1) : glTexCoord3f(0.9f, 0.1f, 0.5f);
    whole ? glVertex4f(x + 0.6f, y, 0.2f, 1) : glVertex3f(x + 0.6f, y, 0.2f);
    glVertex4f(x, y + 0.6f, 0, 0.9f);
  };
  scene.compileDrawn("primitives", [triangle](bool whole) {
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f, whole);
    triangle(0, 0, whole);
    glEnd();
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, 0.1f, whole);
    glEnd();
    glRectf(0.1f, -0.8f, 0.5f, -0.4f);
  });
  scene.compileDrawn("attributes outside", [triangle](bool whole) {
    glColor3ub(250, 20, 90);
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f, whole);
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
  scene.compileDrawn("state after a primitive", [triangle](bool whole) {
    glBegin(GL_TRIANGLES);
    triangle(-0.9f, -0.9f, whole);
    glEnd();
    glColor3f(0, 1, 1);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBegin(GL_TRIANGLES);
    triangle(-0.7f, -0.7f, whole);
    glEnd();
    glDisable(GL_BLEND);
  });
  scene.compileDrawn("a command within a primitive", [triangle](bool whole) {
    glBegin(GL_TRIANGLES);
    glColor3f(1, 0, 1);
    triangle(-0.9f, -0.9f, whole);
    glMaterialf(GL_FRONT, GL_SHININESS, 3);
    triangle(0, 0, whole);
    glEnd();
    glBegin(GL_LINES);
    triangle(-0.5f, -0.8f, whole);
    glVertex2f(0.9f, 0.9f);
    glEnd();
  });
}

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
}

void deleteLists(const Scene &scene) {
  for (const Scene::List &each : scene.lists)
    if (each.name == "deleted")
      glDeleteLists(each.list, 1);
}

void compileParts(Scene &scene) {
  glNewList(scene.part, GL_COMPILE);
  glColor3f(0.9f, 0.4f, 0);
  glVertex2f(-0.5f, -0.8f);
  glColor3f(0.1f, 0.4f, 0.9f);
  glVertex2f(0.7f, 0.1f);
  glEndList();
}

void compileOpen(Scene &scene) {
  glNewList(scene.part + 1, GL_COMPILE);
  glColor3f(0, 0.4f, 0);
  glBegin(GL_TRIANGLES);
  glVertex2f(0.5f, -0.8f);
  glColor3f(0.6f, 0, 0.9f);
  glVertex2f(0.7f, 0.7f);
  glEndList();
}

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

} // namespace software::list_scene
