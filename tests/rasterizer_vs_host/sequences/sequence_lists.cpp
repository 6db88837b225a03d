// Display lists of all possible content: primitives with state between them, attributes set late,
// nested calls, redefinition, commands that are not compiled.
#include "world.h"

namespace software {

namespace {

GLuint nameOf(World &world, int list) { return world.context().firstList + GLuint(list); }

void color(Random &random) {
  glColor4ub(GLubyte(random.bits()), GLubyte(random.bits()), GLubyte(random.bits()), 255);
}

float coordinate(Random &random) { return float(random.between(-2, 60)); }

/// Draws a rectangle of one color by one of GL's primitives; values between corners are exact. The
/// color may be set within it, after its first vertex, or before it.
void primitive(Random &random) {
  static constexpr GLenum kModes[] = {GL_QUADS,          GL_QUADS,   GL_TRIANGLES,  GL_TRIANGLE_FAN,
                                      GL_TRIANGLE_STRIP, GL_POLYGON, GL_QUAD_STRIP, GL_POINTS};
  const GLenum mode = random.pick(kModes);
  const float x0 = coordinate(random), y0 = coordinate(random);
  const float x1 = x0 + float(random.between(1, 30)), y1 = y0 + float(random.between(1, 30));
  const float z = float(random.between(-4, 4)) / 4.0f;
  const bool strip = mode == GL_TRIANGLE_STRIP || mode == GL_QUAD_STRIP;
  const int when = random.below(4);
  if (when == 0)
    color(random);
  glBegin(mode);
  if (when == 1)
    color(random);
  if (mode == GL_POINTS) {
    glVertex3f(x0 + 0.5f, y0 + 0.5f, z);
    if (when == 2)
      color(random);
    glVertex3f(x1 + 0.5f, y0 + 0.5f, z);
  } else {
    glTexCoord2f(0.25f, 0.25f);
    glVertex3f(x0, y0, z);
    glVertex3f(x1, y0, z);
    if (when == 2 && mode == GL_TRIANGLES)
      glTexCoord2f(0.25f, 0.25f);
    if (strip) {
      glVertex3f(x0, y1, z);
      glVertex3f(x1, y1, z);
    } else {
      glVertex3f(x1, y1, z);
      if (mode == GL_TRIANGLES) {
        glVertex3f(x0, y0, z);
        glVertex3f(x1, y1, z);
      }
      glVertex3f(x0, y1, z);
    }
  }
  glEnd();
  // Mesa 22.3.6 gives the first vertex of a list's next primitive the earlier color, unless it sets
  // its own.
  if (when == 1)
    color(random);
}

void state(World &world, Random &random) {
  switch (random.below(9)) {
  case 0:
    return glTranslatef(float(random.between(-3, 3)), float(random.between(-3, 3)), 0);
  case 1:
    if (random.once(2))
      return glEnable(GL_SCISSOR_TEST);
    return glDisable(GL_SCISSOR_TEST);
  case 2:
    glScissor(random.below(24), random.below(24), random.between(8, 40), random.between(8, 40));
    return;
  case 3:
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, world.group().programs[random.once(2) ? 5 : 8]);
    return;
  case 4:
    if (random.once(3))
      return glDisable(GL_FRAGMENT_PROGRAM_ARB);
    return glEnable(GL_FRAGMENT_PROGRAM_ARB);
  case 5:
    return color(random);
  case 6:
    glColorMask(GL_TRUE, GLboolean(random.once(4) ? GL_FALSE : GL_TRUE), GL_TRUE, GL_TRUE);
    return;
  case 7:
    glClearColor(float(random.below(256)) / 255.0f, 0, 1, 1);
    return glClear(random.once(2) ? GL_COLOR_BUFFER_BIT : GL_DEPTH_BUFFER_BIT);
  default:
    glBlendFunc(GL_ONE, random.once(3) ? GL_ONE : GL_ZERO);
    return glBlendEquation(random.once(2) ? GL_MAX : GL_FUNC_ADD);
  }
}

/// Emits a list's content. Draws do not bind a texture by name, as the lists are called at any
/// time.
void content(World &world, Random &random, int depth) {
  for (int i = random.between(1, 6); i > 0; --i) {
    switch (random.below(8)) {
    case 0:
      state(world, random);
      break;
    case 1:
      glPushAttrib(random.once(2) ? GL_ALL_ATTRIB_BITS : GL_ENABLE_BIT | GL_CURRENT_BIT);
      glPushMatrix();
      state(world, random);
      primitive(random);
      glPopMatrix();
      glPopAttrib();
      // Mesa 22.3.6 gives the next primitive the color from before PopAttrib, unless it is set.
      color(random);
      break;
    case 2:
      if (depth == 0)
        glCallList(nameOf(world, random.below(kLists - 1)));
      break;
    case 3:
      if (depth == 0) {
        const GLubyte lists[2] = {GLubyte(random.below(kLists - 1)),
                                  GLubyte(random.below(kLists - 1))};
        glListBase(world.context().firstList);
        glCallLists(2, GL_UNSIGNED_BYTE, lists);
      }
      break;
    default:
      primitive(random);
    }
  }
}

/// Compiles a list without endless recursion: it calls others only if no other does.
void compile(World &world, Random &random, const std::string &) {
  Context &context = world.context();
  const int list = random.below(kLists);
  const bool nests = list == kLists - 1;
  const bool executes = random.once(4);
  glNewList(nameOf(world, list), executes ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
  glPushAttrib(GL_ENABLE_BIT | GL_SCISSOR_BIT | GL_COLOR_BUFFER_BIT);
  glPushMatrix();
  content(world, random, nests ? 0 : 1);
  glPopMatrix();
  glPopAttrib();
  glEndList();
  // Mesa 22.3.6 raises errors for legal commands behind primitives of a list that it also executes,
  // as it believes to be inside Begin/End.
  while (executes && glGetError() != GL_NO_ERROR) {
  }
  context.lists[std::size_t(list)] = true;
  world.fit();
}

void call(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const int list = random.below(kLists);
  glCallList(nameOf(world, list));
  world.fit();
}

/// Calls a list of only vertices and attributes, as part of a primitive.
void callInPrimitive(World &world, Random &random, const std::string &) {
  int width = 0, height = 0;
  if (!world.size(width, height))
    return;
  const GLuint list = glGenLists(1);
  const float x = coordinate(random), y = coordinate(random);
  glNewList(list, GL_COMPILE);
  color(random);
  glVertex2f(x, y);
  glVertex2f(x + 9, y);
  glEndList();
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, world.group().programs[5]);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glBegin(GL_QUADS);
  glCallList(list);
  glVertex2f(x + 9, y + 7);
  glVertex2f(x, y + 7);
  glEnd();
  glDeleteLists(list, 1);
}

} // namespace

const std::vector<Command> kListCommands = {
    {"compile any list", 6, compile},
    {"call any list", 10, call},
    {"call in a primitive", 2, callInPrimitive},
};

} // namespace software
