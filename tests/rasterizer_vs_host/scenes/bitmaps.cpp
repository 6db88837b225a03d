// Draws bitmaps under random state: rasterizer-bitmaps [shared] SEED COUNT [COMMANDS], or
// rasterizer-bitmaps rules, frames, fonts or letters CHANGE DRAW.
//   SEED COUNT  scenes of that many commands, each in a context of its own; records the picture,
// the
//               depths, the final raster position, and GL's errors
//   shared      two contexts of a share group draw each scene in turns; they share programs, lists,
//               buffers of bits, and the window
//   rules       draws what the specification defines but not all hosts implement; bitmaps.py
//               knows the colors
//   frames      draws the fog of the rules in frames that are the host's
//   fonts       draws texts by glXUseXFont
//   letters     draws bitmaps whose fragments sample, a change, and a draw, by number
// Programs of the scenes read no texture coordinates, fog coordinate or secondary color: a host
// that draws bitmaps as textured rectangles has other values.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <utility>

#include "bitmap_rules.h"
#include "surface.h"

namespace software {
namespace {

constexpr const char *kFragmentTexts[] = {
    "!!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n",
    "!!ARBfp1.0\nMUL result.color, fragment.color, {0.5, 0.75, 1.0, 0.5};\nEND\n",
    "!!ARBfp1.0\nTEMP t;\nMUL t.xy, fragment.position, {0.015625, 0.015625, 0, 0};\n"
    "MOV t.zw, fragment.color;\nMOV result.color, t;\nEND\n",
    "!!ARBfp1.0\nTEMP t;\nMUL t.x, fragment.position.x, 0.25;\nFRC t.x, t.x;\nSUB t.x, t.x, 0.3;\n"
    "KIL t.x;\nMOV result.color, program.local[0];\nEND\n",
    "!!ARBfp1.0\nMOV result.color, fragment.color;\nMOV result.depth.z, {0.375}.x;\nEND\n",
};
constexpr const char *kVertexText =
    "!!ARBvp1.0\nPARAM mvp[4] = { state.matrix.mvp };\nTEMP p;\n"
    "ADD p, vertex.position, program.local[0];\nDP4 result.position.x, mvp[0], p;\n"
    "DP4 result.position.y, mvp[1], p;\nDP4 result.position.z, mvp[2], p;\n"
    "DP4 result.position.w, mvp[3], p;\nMUL result.color, vertex.color, {1, 0.5, 0.75, 1};\nEND\n";

/// A random scene, drawn by one context, or by two.
class Scene {
public:
  /// \param turn makes the other context current, and returns true the first time; none: there is
  /// no other
  explicit Scene(std::uint64_t seed, std::function<bool()> turn = {})
      : m_random(seed), m_turn(std::move(turn)) {
    m_random.bits();
  }

  void draw(int commands) {
    prepare();
    glClearColor(0.2f, 0.3f, 0.1f, 0.5f);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    programs();
    triangle(); // the rasterizer has the target, with depths
    for (int i = 0; i < commands; ++i) {
      if (m_turn && m_random.once(3))
        takeTurns();
      command();
    }
    glDisable(GL_SCISSOR_TEST);
  }

private:
  static void prepare() {
    glViewport(0, 0, kEdge, kEdge);
    glDisable(GL_DITHER);
  }

  void takeTurns() {
    if (m_turn()) {
      prepare();
      // RasterPos and Begin are errors if vertex programs are enabled and the current one has no
      // text (ARB_vertex_program, 2.14.4). Mesa 22.3.6 checks only Begin.
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, m_vertices);
    }
    // Mesa 22.3.6 draws with old parameters until one is set in this context.
    chooseProgram(true);
    if (!m_lists.empty() && m_random.once(3)) {
      glCallList(m_random.pick(m_lists));
      drawGathered();
    }
  }

  float unit() { return float(m_random.below(17)) / 16.0f; }
  /// Returns eighths of a pixel, so that no host rounds to another pixel.
  float clip() { return float(m_random.between(-kEdge * 5, kEdge * 5)) / float(kEdge * 4); }

  void programs() {
    for (std::size_t i = 0; i < 5; ++i)
      m_fragments[i] = makeProgram(GL_FRAGMENT_PROGRAM_ARB, kFragmentTexts[i]);
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.9f, 0.5f, 0.1f, 0.75f);
    m_vertices = makeProgram(GL_VERTEX_PROGRAM_ARB, kVertexText);
    chooseProgram(true);
  }

  void chooseProgram(bool fragment) {
    const GLuint name = m_fragments[std::size_t(m_random.below(5))];
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, name);
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, unit(), unit(), unit(), unit());
    (fragment ? glEnable : glDisable)(GL_FRAGMENT_PROGRAM_ARB);
    (m_random.once(3) ? glEnable : glDisable)(GL_VERTEX_PROGRAM_ARB);
    glProgramLocalParameter4fARB(GL_VERTEX_PROGRAM_ARB, 0, 0.125f * unit(), 0.125f * unit(), 0, 0);
  }

  void triangle() {
    glColor4f(unit(), unit(), unit(), 1);
    glBegin(GL_TRIANGLES);
    glVertex3f(-1, -1, -0.5f);
    glVertex3f(1, -1, 0.25f);
    glVertex3f(0, 1, 0.5f);
    glEnd();
  }

  void unpacking() {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1 << m_random.below(4));
    glPixelStorei(GL_UNPACK_LSB_FIRST, m_random.below(2));
    glPixelStorei(GL_UNPACK_ROW_LENGTH, m_random.once(2) ? 0 : m_random.between(1, 90));
    glPixelStorei(GL_UNPACK_SKIP_PIXELS, m_random.once(2) ? 0 : m_random.between(0, 20));
    glPixelStorei(GL_UNPACK_SKIP_ROWS, m_random.once(2) ? 0 : m_random.between(0, 3));
    glPixelStorei(GL_UNPACK_SWAP_BYTES, m_random.once(5));
    if (m_random.once(6))
      glPixelStorei(GL_UNPACK_ALIGNMENT, 3); // an error without other effect
    if (m_random.once(6))
      glPixelStoref(GL_UNPACK_SKIP_PIXELS, float(m_random.below(5)));
  }

  void pixelState() {
    const auto turn = [&](GLenum cap) { (m_random.once(3) ? glEnable : glDisable)(cap); };
    for (const GLenum cap :
         {GL_BLEND, GL_DEPTH_TEST, GL_STENCIL_TEST, GL_ALPHA_TEST, GL_SCISSOR_TEST,
          GL_POLYGON_STIPPLE, GL_CULL_FACE, GL_POLYGON_OFFSET_FILL})
      turn(cap);
    (m_random.once(8) ? glEnable : glDisable)(GL_COLOR_LOGIC_OP);
    glLogicOp(GLenum(GL_CLEAR + m_random.below(16)));
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GLenum(GL_NEVER + m_random.below(8)));
    glDepthMask(GLboolean(m_random.below(2)));
    glAlphaFunc(GL_GREATER, 0.375f);
    glStencilFunc(GLenum(GL_NEVER + m_random.below(8)), m_random.below(4), 3);
    glStencilOp(GL_INCR, GL_INVERT, GL_REPLACE);
    glScissor(m_random.below(30), m_random.below(30), 20, 30);
    glColorMask(GLboolean(!m_random.once(4)), GL_TRUE, GL_TRUE, GL_TRUE);
    glCullFace(m_random.once(2) ? GL_FRONT_AND_BACK : GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, m_random.once(4) ? GL_LINE : GL_FILL);
    glPixelZoom(m_random.once(2) ? 1.0f : 2.0f, 1.0f);
  }

  void position() {
    glColor4f(unit(), unit(), unit(), unit());
    switch (m_random.below(4)) {
    case 0:
      return glWindowPos3f(float(m_random.between(-20, kEdge)) + 0.25f,
                           float(m_random.between(-20, kEdge)) + 0.5f, unit());
    case 1:
      return glRasterPos4f(clip() * 2, clip() * 2, clip() * 0.5f, 2);
    default:
      return glRasterPos3f(clip(), clip(), clip() * 0.5f); // it may be outside, and is then invalid
    }
  }

  /// Mesa collects bitmaps, one over the other, and draws them by the state at the end.
  void drawGathered() const {
    if (!m_listing)
      glFlush();
  }

  void bitmap(bool fromBuffer = false) {
    unsigned char bits[4096];
    for (unsigned char &byte : bits)
      byte = m_random.once(3) ? 0xFF : static_cast<unsigned char>(m_random.bits());
    // Mesa 22.3.6 fails if a list contains an invalid size.
    const bool wrong = !m_listing && m_random.once(12);
    const int width = wrong ? -1 : m_random.below(m_random.once(5) ? 60 : 14);
    const int height = m_random.below(m_random.once(5) ? 40 : 16);
    const void *from = bits;
    if (fromBuffer) {
      if (!m_turn || m_buffer == 0 || m_random.once(3))
        glGenBuffers(1, &m_buffer);
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, m_buffer);
      glBufferData(GL_PIXEL_UNPACK_BUFFER, m_random.once(4) ? 16 : 4096, bits, GL_STATIC_DRAW);
      from = reinterpret_cast<const void *>(std::size_t(m_random.below(9)));
    }
    glBitmap(width, height, float(m_random.between(-8, 8)) * 0.5f, float(m_random.below(4)),
             float(m_random.between(-3, 12)), float(m_random.between(-2, 2)) * 0.75f,
             static_cast<const GLubyte *>(from));
    drawGathered();
    if (fromBuffer)
      glBindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  }

  void listed() {
    const GLuint list = glGenLists(1);
    m_lists.push_back(list);
    glNewList(list, m_random.once(3) ? GL_COMPILE_AND_EXECUTE : GL_COMPILE);
    m_listing = true;
    if (m_random.once(2))
      position();
    if (!m_random.once(3))
      bitmap();
    glEndList();
    m_listing = false;
    bitmap();
    glCallList(list);
    drawGathered();
    if (m_random.once(2))
      glCallLists(1, GL_UNSIGNED_INT, &list);
    drawGathered();
  }

  void command() {
    switch (m_random.below(16)) {
    case 0:
    case 1:
      return pixelState();
    case 2:
    case 3:
    case 4:
      return position();
    case 5:
      return unpacking();
    case 6:
      return chooseProgram(m_random.once(2));
    case 7:
      return listed();
    case 8:
      glPushAttrib(GL_CURRENT_BIT);
      position();
      bitmap();
      return glPopAttrib();
    case 9:
      return bitmap(true);
    case 10:
      if (m_random.once(4)) {
        glBegin(GL_POINTS); // an error inside
        bitmap();
        glEnd();
      } else if (m_random.once(3)) {
        glRenderMode(GL_SELECT);
        bitmap();
        glRenderMode(GL_RENDER);
      } else {
        triangle();
      }
      return;
    default:
      return bitmap();
    }
  }

  Random m_random;
  const std::function<bool()> m_turn;
  bool m_listing = false;
  GLuint m_fragments[5] = {}, m_vertices = 0;
  GLuint m_buffer = 0; ///< the last source of bits
  std::vector<GLuint> m_lists;
};

std::string rasterText() {
  float position[4] = {};
  GLint valid = 0;
  glGetFloatv(GL_CURRENT_RASTER_POSITION, position);
  glGetIntegerv(GL_CURRENT_RASTER_POSITION_VALID, &valid);
  char text[96];
  std::snprintf(text, sizeof text, " at %.4f %.4f %.5f, valid %d", double(position[0]),
                double(position[1]), double(position[2]), valid);
  return text;
}

void writeAll(const std::string &name) {
  record(name + " color" + rasterText(), readRgba(0, 0, kEdge, kEdge));
  std::vector<unsigned char> bytes(std::size_t(kEdge) * kEdge * 4);
  glReadPixels(0, 0, kEdge, kEdge, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, bytes.data());
  record(name + " depth and stencil", bytes);
  record(name + " errors" + takeErrors(), {});
}

/// Draws texts by glXUseXFont, whose lists the host compiles without GL commands: in names of
/// GenLists, over an existing list, in names that were never generated, and in two contexts of a
/// share group.
void fonts(Screen &screen, GLXDrawable window) {
  const GLXContext context = screen.makeContext(), other = screen.makeContext(context);
  screen.makeCurrent(window, context);
  const XFontStruct *const font = XLoadQueryFont(glXGetCurrentDisplay(), "fixed");
  if (!font)
    return record("fonts: none", {});
  glViewport(0, 0, kEdge, kEdge);
  const GLuint base = glGenLists(256);
  const auto write = [](const std::string &name, GLuint first) {
    glClear(GL_COLOR_BUFFER_BIT);
    glColor3f(1, 1, 0.25f);
    glRasterPos2f(-0.9f, -0.2f);
    glListBase(first);
    glCallLists(3, GL_UNSIGNED_BYTE, "aHx");
    glCallList(first + '!');
    glListBase(0);
    record("font " + name, readRgba(0, 0, kEdge, kEdge));
  };
  glNewList(base + 'H', GL_COMPILE);
  glRectf(-1, -1, 1, 1);
  glEndList();
  write("before", base);
  glXUseXFont(font->fid, 0, 256, int(base));
  write("in names of GenLists", base);
  glXUseXFont(font->fid, 0, 256, 5000);
  write("in other names", 5000);
  screen.makeCurrent(window, other);
  glViewport(0, 0, kEdge, kEdge);
  write("in another context", base);
  const GLuint others = glGenLists(256);
  glXUseXFont(font->fid, 0, 256, int(others));
  screen.makeCurrent(window, context);
  write("of another context", others);
  glNewList(base + 'x', GL_COMPILE);
  glRectf(0.5f, 0.5f, 1, 1);
  glEndList();
  write("and a list of the application's", base);
  glDeleteLists(base, 256);
  write("deleted", base);
  record("font errors" + takeErrors(), {});
}

void drawScene(Screen &screen, GLXDrawable window, int seed, int commands) {
  const GLXContext context = screen.makeContext();
  screen.makeCurrent(window, context);
  Scene(std::uint64_t(seed)).draw(commands);
  writeAll("scene " + std::to_string(seed));
  screen.destroy(context);
}

void drawShared(Screen &screen, GLXDrawable window, int seed, int commands) {
  GLXContext contexts[2] = {screen.makeContext(), nullptr};
  contexts[1] = screen.makeContext(contexts[0]);
  screen.makeCurrent(window, contexts[0]);
  int now = 0;
  bool known = false; // whether the second one was current before
  Scene(std::uint64_t(seed), [&] {
    now = 1 - now;
    screen.makeCurrent(window, contexts[now]);
    return !std::exchange(known, true);
  }).draw(commands);
  for (const int which : {now, 1 - now}) {
    screen.makeCurrent(window, contexts[which]);
    writeAll("shared scene " + std::to_string(seed) + ", context " + std::to_string(which));
  }
  for (const GLXContext each : contexts)
    screen.destroy(each);
}

} // namespace
} // namespace software

int main(int argc, char **argv) {
  using namespace software;
  const bool shared = argc > 1 && std::strcmp(argv[1], "shared") == 0;
  if (shared)
    --argc, ++argv;
  software::Screen screen; // Xlib has a Screen too
  if (!screen.open())
    return 1;
  const GLXDrawable window = screen.makeWindow(kEdge, kEdge);
  const bool onlyRules = argc > 1 && std::strcmp(argv[1], "rules") == 0;
  const bool onlyFonts = argc > 1 && std::strcmp(argv[1], "fonts") == 0;
  const int first = argc < 2 ? 1 : std::atoi(argv[1]);
  const int count = argc > 2 ? std::atoi(argv[2]) : 1;
  const int commands = argc > 3 ? std::atoi(argv[3]) : 24;
  if (argc == 4 && std::strcmp(argv[1], "letters") == 0) {
    screen.makeCurrent(window, screen.makeContext());
    letters(std::atoi(argv[2]), std::atoi(argv[3]));
    return 0;
  }
  if (onlyFonts) {
    fonts(screen, window);
    return 0;
  }
  if (argc == 2 && std::strcmp(argv[1], "frames") == 0) {
    screen.makeCurrent(window, screen.makeContext());
    frames([&] { screen.swap(window); });
    return 0;
  }
  if (onlyRules) {
    screen.makeCurrent(window, screen.makeContext());
    rules();
    return 0;
  }
  for (int seed = first; seed < first + count; ++seed)
    (shared ? drawShared : drawScene)(screen, window, seed, commands);
  return 0;
}
