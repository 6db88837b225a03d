// texts: loads program texts one by one and draws those that are accepted, for run.py to compare.
//
// usage: texts FOLDER < LIST
// A line of LIST is "NAME STAGE SHOWN": FOLDER/NAME.txt is loaded as a program of STAGE (fragment,
// vertex). The answer is a line "NAME POSITION". POSITION is -1 for a text that is accepted;
// FOLDER/NAME.raw then has the floats of both color buffers and of the depth buffer. The first line
// is "version" and GL_VERSION. The name is written before a text is loaded, so that a crash can be
// attributed.
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <sstream>

#include "back_ends_vs_interpreter/gl_host.h"
#include "back_ends_vs_interpreter/scene.h"

namespace {
using namespace arbiter::differential;

/// How a vertex program's result is shown: by a fragment program that copies it, or by fixed
/// function.
struct Shown {
  const char *name;
  const char *attribute; ///< for the fragment program; null: fixed function
};
constexpr Shown kShown[] = {{"primary", "color"},     {"secondary", "color.secondary"},
                            {"back", "color"},        {"fogcoord", "fogcoord"},
                            {"texcoord", "texcoord"}, {"pointsize", "color"},
                            {"fixed", nullptr}};

std::string read(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Loads a text and returns GL_PROGRAM_ERROR_POSITION_ARB.
int load(GLenum target, const std::string &text) {
  static GLuint names[2] = {};
  GLuint &name = names[target == GL_VERTEX_PROGRAM_ARB];
  if (name)
    glDeleteProgramsARB(1, &name);
  glGenProgramsARB(1, &name);
  glBindProgramARB(target, name);
  glProgramStringARB(target, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()), text.data());
  const bool refused = glGetError() == GL_INVALID_OPERATION;
  GLint position = -1;
  glGetIntegerv(GL_PROGRAM_ERROR_POSITION_ARB, &position);
  if (refused != (position != -1))
    std::fprintf(stderr, "error and position %d disagree\n", position);
  return refused ? std::max(position, 0) : -1;
}

/// Draws vertices that have only a position; all other attributes are current values.
void drawPlainPoints() {
  glColor4f(0.2f, 0.4f, 0.6f, 0.8f);
  glBegin(GL_POINTS);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      glVertex4fv(vertexValue({arbiter::fp::ir::AttributeKind::Position, 0}, x, y).data());
  glEnd();
}

class Drawer {
public:
  bool open() {
    if (!m_target.create())
      return false;
    applyState(true);
    applyTextures();
    return takeErrors().empty();
  }

  int fragment(const std::string &text) {
    const int position = load(GL_FRAGMENT_PROGRAM_ARB, text);
    if (position != -1)
      return position;
    use(GL_FRAGMENT_PROGRAM_ARB);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    m_target.clear();
    drawQuad();
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    return -1;
  }

  int vertex(const std::string &text, const Shown &shown) {
    const int position = load(GL_VERTEX_PROGRAM_ARB, text);
    if (position != -1)
      return position;
    use(GL_VERTEX_PROGRAM_ARB);
    if (shown.attribute) {
      load(GL_FRAGMENT_PROGRAM_ARB,
           std::string("!!ARBfp1.0\nMOV result.color, fragment.") + shown.attribute + ";\nEND\n");
      glEnable(GL_FRAGMENT_PROGRAM_ARB);
    }
    glEnable(GL_VERTEX_PROGRAM_ARB);
    m_target.clear();
    if (!shown.attribute) {
      drawPlainPoints();
    } else if (!std::strcmp(shown.name, "back")) {
      glEnable(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
      glFrontFace(GL_CW);
      drawQuad();
      glFrontFace(GL_CCW);
      glDisable(GL_VERTEX_PROGRAM_TWO_SIDE_ARB);
    } else {
      const bool sized = !std::strcmp(shown.name, "pointsize");
      if (sized)
        glEnable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
      drawPoints();
      glDisable(GL_VERTEX_PROGRAM_POINT_SIZE_ARB);
    }
    glDisable(GL_VERTEX_PROGRAM_ARB);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
    return -1;
  }

  void write(const std::string &path) const {
    std::ofstream file(path, std::ios::binary);
    const auto put = [&](const std::vector<float> &values) {
      file.write(reinterpret_cast<const char *>(values.data()),
                 std::streamsize(values.size() * sizeof(float)));
    };
    for (int buffer = 0; buffer < kColorBuffers; ++buffer)
      put(m_target.read(buffer).rgba);
    put(m_target.read(0).depth);
  }

private:
  static void use(GLenum target) {
    applyLocalParameters(target);
    applyEnvParameters(target);
  }

  FloatTarget m_target;
};

const Shown *findShown(const std::string &name) {
  for (const Shown &row : kShown)
    if (name == row.name)
      return &row;
  return nullptr;
}
} // namespace

int main(int argc, char **argv) {
  if (argc != 2)
    return 2;
  const std::string folder = argv[1];
  std::string why;
  const auto host = GlHost::create(why);
  if (!host) {
    std::fprintf(stderr, "texts: no GL context: %s\n", why.c_str());
    return 77;
  }
  Drawer drawer;
  if (!drawer.open()) {
    std::fputs("texts: skipped: the host lacks it: float framebuffers\n", stderr);
    return 77;
  }
  std::printf("version %s\n", reinterpret_cast<const char *>(glGetString(GL_VERSION)));
  std::string name, stage, shown;
  while (std::cin >> name >> stage >> shown) {
    std::printf("%s ", name.c_str());
    std::fflush(stdout);
    const std::string text = read(folder + "/" + name + ".txt");
    const Shown *const row = findShown(shown);
    if (!row)
      return 2;
    const int position = stage == "vertex" ? drawer.vertex(text, *row) : drawer.fragment(text);
    if (position == -1)
      drawer.write(folder + "/" + name + ".raw");
    const std::string errors = takeErrors();
    std::printf("%d%s%s\n", position, errors.empty() ? "" : " ", errors.c_str());
    std::fflush(stdout);
  }
}
