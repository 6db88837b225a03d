// Draws frames that the rasterizer and the host draw together: rasterizer-mixed SEED COUNT [PAUSE].
// Each seed is a sequence of frames in two windows, in which draws that the host must make and
// draws with programs alternate at every position. Meanwhile windows are resized, mapped late,
// shown twice or never, programs are new in the middle of a frame, and passes over one shape meet
// at equal depths. Writes what is shown and read, which is compared between two sides. Every frame
// begins by covering the whole window, whose pixels are undefined after a resize. PAUSE is in
// milliseconds between frames, in which compiled code arrives.
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "glx_windows.h"
#include "surface.h"

namespace software {
namespace {

constexpr int kFrames = 14, kReadWide = 300, kReadHigh = 220;

[[noreturn]] void fail(const char *what) {
  std::fprintf(stderr, "mixed: %s\n", what);
  std::exit(2);
}

struct Place {
  Window window = 0;
  int width = 0, height = 0; ///< as last requested
  bool mapped = false;
};

class Sequence {
public:
  Sequence(Display *own, Display *other, int seed)
      : m_display(own), m_other(other), m_seed(seed), m_random(std::uint64_t(seed)) {
    m_config = chooseGlxConfig(m_display, GLX_WINDOW_BIT);
    if (!m_config)
      fail("no GLX configuration");
    m_context = glXCreateNewContext(m_display, m_config, GLX_RGBA_TYPE, nullptr, True);
    m_places[0] = make(0, true);
    // The windows are apart, and within the screen at any size, as parts outside cannot be read.
    m_places[1] = make(300, m_random.once(2));
    use(0);
    setUp();
  }
  ~Sequence() {
    glXMakeCurrent(m_display, None, nullptr);
    glXDestroyContext(m_display, m_context);
    for (const Place &place : m_places)
      XDestroyWindow(m_display, place.window);
    XSync(m_display, False);
  }
  Sequence(const Sequence &) = delete;
  Sequence &operator=(const Sequence &) = delete;

  void run(std::chrono::milliseconds pause) {
    for (m_frame = 0; m_frame < kFrames; ++m_frame) {
      change();
      cover();
      for (int i = m_random.below(6); i > 0; --i)
        step();
      show();
      std::this_thread::sleep_for(pause);
    }
  }

private:
  Place make(int x, bool mapped) {
    Place place{0, m_random.between(16, 200), m_random.between(16, 160), mapped};
    place.window = makeWindow(m_display, m_config, place.width, place.height,
                              {.x = x, .mapped = mapped, .cleared = true});
    return place;
  }
  void use(int place) {
    m_place = place;
    if (!glXMakeCurrent(m_display, m_places[m_place].window, m_context))
      fail("the context does not become current");
  }
  void setUp() {
    const unsigned char texels[] = {40, 90, 200, 255, 250, 10, 60, 255,
                                    0,  30, 90,  255, 70,  70, 7,  255};
    glGenTextures(2, m_textures);
    for (const GLuint texture : m_textures) {
      glBindTexture(GL_TEXTURE_2D, texture);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
      // The rasterizer leaves signed formats to the host.
      glTexImage2D(GL_TEXTURE_2D, 0, texture == m_textures[0] ? GL_RGBA8 : GL_RGBA8_SNORM, 2, 2, 0,
                   GL_RGBA, GL_UNSIGNED_BYTE, texels);
    }
    glGenTextures(1, &m_copy);
    glDisable(GL_DITHER);
    glDepthFunc(GL_LEQUAL);
    if (m_random.once(2))
      glEnable(GL_DEPTH_TEST);
    newProgram();
    m_vertexPrograms[0] = makeProgram(GL_VERTEX_PROGRAM_ARB, R"(!!ARBvp1.0
PARAM m[4] = { state.matrix.mvp };
DP4 result.position.x, m[0], vertex.position;
DP4 result.position.y, m[1], vertex.position;
DP4 result.position.z, m[2], vertex.position;
DP4 result.position.w, m[3], vertex.position;
MOV result.texcoord[0], vertex.texcoord[0];
MOV result.color, vertex.color;
END
)");
    m_vertexPrograms[1] = makeProgram(GL_VERTEX_PROGRAM_ARB, R"(!!ARBvp1.0
OPTION ARB_position_invariant;
MOV result.texcoord[0], vertex.texcoord[0];
MOV result.color, vertex.color;
END
)");
  }
  /// Makes a program with a new text, so that its machine code is made while a frame is drawn.
  void newProgram() {
    // llvmpipe does not compute with bytes if there are numbers above 1.
    char text[200];
    std::snprintf(text, sizeof text,
                  "!!ARBfp1.0\nTEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                  "MAD t, t, {%g}, program.local[0];\nMUL result.color, t, 0.5;\nEND\n",
                  double(m_seed % 64 * kFrames + m_frame) / 512);
    m_program = makeProgram(GL_FRAGMENT_PROGRAM_ARB, text);
  }
  [[nodiscard]] Place &place() { return m_places[m_place]; }

  /// Changes windows and state, between frames and within them.
  void change() {
    if (m_random.once(3))
      resize(m_random.once(2) ? m_display : m_other);
    if (m_random.once(4)) {
      use(1 - m_place);
      cover();
    }
    if (!place().mapped && m_random.once(3)) {
      XMapWindow(m_display, place().window);
      XSync(m_display, False);
      place().mapped = true;
    }
    if (m_random.once(3))
      glViewport(0, 0, place().width, place().height);
  }
  void resize(Display *by) {
    Place &what = m_places[m_random.once(4) ? 1 - m_place : m_place];
    what.width = m_random.between(16, 260);
    what.height = m_random.between(16, 200);
    XResizeWindow(by, what.window, unsigned(what.width), unsigned(what.height));
    XSync(by, False);
    XSync(m_display, False);
  }

  void quad(float left, float bottom, float right, float top) {
    const auto part = [&] { return 1 + float(m_random.below(64)) / 63; };
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, part(), part(), part(), 2);
    glBegin(GL_QUADS);
    glTexCoord2f(0.25F, 0.25F), glVertex3f(left, bottom, m_depth);
    glTexCoord2f(0.25F, 0.25F), glVertex3f(right, bottom, m_depth);
    glTexCoord2f(0.25F, 0.25F), glVertex3f(right, top, m_depth);
    glTexCoord2f(0.25F, 0.25F), glVertex3f(left, top, m_depth);
    glEnd();
  }
  /// Draws a quad. \param foreign the host draws it
  void draw(bool foreign, bool whole) {
    glBindTexture(GL_TEXTURE_2D, m_textures[foreign]);
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_program);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    const auto at = [&] { return float(m_random.below(16)) / 8 - 1; };
    const float left = at(), bottom = at();
    if (whole)
      quad(-1, -1, 1, 1);
    else
      quad(left, bottom, left + 0.75F, bottom + 0.75F);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  }
  /// Defines everything that was undefined.
  void cover() {
    glClearColor(float(m_random.below(16)) / 15, float(m_random.below(16)) / 15, 0.25F, 1);
    m_depth = 0;
    const int way = m_random.below(3);
    glClear(GL_DEPTH_BUFFER_BIT | (way == 0 ? GL_COLOR_BUFFER_BIT : 0));
    if (way != 0) {
      GLint viewport[4];
      glGetIntegerv(GL_VIEWPORT, viewport);
      glViewport(0, 0, 512, 512); // covers windows of every size
      draw(way == 1, true);
      glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    }
  }
  /// How a pass over a shape is drawn, with the fragment program.
  struct Pass {
    int vertex;   ///< index of m_vertexPrograms; -1: fixed function
    bool foreign; ///< the host draws it
  };
  void draw(const Pass &pass, const std::array<float, 9> &corners) {
    glBindTexture(GL_TEXTURE_2D, m_textures[pass.foreign]);
    if (pass.vertex >= 0) {
      glBindProgramARB(GL_VERTEX_PROGRAM_ARB, m_vertexPrograms[pass.vertex]);
      glEnable(GL_VERTEX_PROGRAM_ARB);
    }
    glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, m_program);
    glProgramLocalParameter4fARB(GL_FRAGMENT_PROGRAM_ARB, 0, 0.61F, 0.73F, 0.37F, 2);
    glEnable(GL_FRAGMENT_PROGRAM_ARB);
    glColor4f(0.25F, 0.5F, 0.125F, 1);
    glBegin(GL_TRIANGLES);
    for (std::size_t i = 0; i < corners.size(); i += 3)
      glTexCoord2f(0.25F, 0.25F), glVertex3fv(corners.data() + i);
    glEnd();
    glDisable(GL_VERTEX_PROGRAM_ARB);
    glDisable(GL_FRAGMENT_PROGRAM_ARB);
  }
  /// Draws a triangle, and again where its depths are met, by programs with equal positions. Either
  /// the rasterizer or the host makes all passes, as their depths are not equal to the bit. Before
  /// each pass there may be a new program without machine code.
  void passes() {
    std::array<float, 9> corners{};
    for (float &corner : corners)
      corner = float(m_random.between(-99, 99)) / 50;
    const bool foreign = m_random.once(4), explicitly = m_random.once(2);
    const auto angle = [&] { return float(m_random.below(3600)) / 10; };
    glPushAttrib(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT | GL_TRANSFORM_BIT);
    // No entry is a power of two, so that each sum is rounded.
    glMatrixMode(GL_PROJECTION);
    glPushMatrix();
    glFrustum(-0.31, 0.29, -0.33, 0.27, 0.9, 7.3);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glTranslatef(0.05F, 0.03F, -3.1F);
    glRotatef(angle(), 0.3F, 0.9F, 0.1F);
    glRotatef(angle(), 0.8F, -0.2F, 0.5F);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_DEPTH_BUFFER_BIT); // whether other draws' depths are met depends on the last bit
    for (int i = m_random.between(2, 3); i > 0; --i) {
      if (m_random.once(2))
        newProgram();
      draw({explicitly ? 0 : m_random.once(2) ? 1 : -1, foreign}, corners);
      glDepthFunc(GL_EQUAL);
      glEnable(GL_BLEND);
      glBlendFunc(GL_ONE, GL_ONE);
    }
    glClear(GL_DEPTH_BUFFER_BIT);
    glPopMatrix();
    glMatrixMode(GL_PROJECTION);
    glPopMatrix();
    glPopAttrib();
  }
  void step() {
    m_depth = float(m_random.between(-8, 8)) / 16;
    switch (m_random.below(12)) {
    case 10:
    case 11:
      return passes();
    case 0:
    case 1:
    case 2:
      return draw(false, false);
    case 3:
    case 4:
      return draw(true, false);
    case 5: {
      const std::vector<unsigned char> bytes(16 * 8 * 4, static_cast<unsigned char>(m_frame * 9));
      glWindowPos2i(m_random.below(40), m_random.below(40));
      return glDrawPixels(16, 8, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    }
    case 6:
      return newProgram();
    case 7:
      return change();
    case 8:
      glBindTexture(GL_TEXTURE_2D, m_copy);
      glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
      return glCopyTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, 0, 0, 8, 8, 0);
    default:
      return read();
    }
  }
  /// Reads more than the window's buffers contain; the rest of the memory must stay.
  void read() {
    std::vector<unsigned char> bytes(std::size_t(kReadWide) * kReadHigh * 4, 0x5A);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, kReadWide, kReadHigh, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    record(name("read"), bytes);
  }
  void show() {
    if (m_random.once(8))
      glFlush();
    if (m_random.once(3))
      read();
    for (int i = m_random.once(6) ? 2 : 1; i > 0; --i)
      glXSwapBuffers(m_display, place().window);
    if (place().mapped)
      grab();
  }
  void grab() {
    record(name("shown"), grabWindow(m_display, place().window, place().width, place().height));
  }
  [[nodiscard]] std::string name(const char *what) {
    return "seed " + std::to_string(m_seed) + " frame " + std::to_string(m_frame) + " " + what +
           " window " + std::to_string(m_place) + takeErrors();
  }

  Display *m_display, *m_other;
  int m_seed;
  Random m_random;
  GLXFBConfig m_config = nullptr;
  GLXContext m_context = nullptr;
  Place m_places[2];
  int m_place = 0, m_frame = 0;
  GLuint m_vertexPrograms[2] = {};
  GLuint m_textures[2] = {}, m_copy = 0, m_program = 0;
  float m_depth = 0;
};

} // namespace
} // namespace software

int main(int argc, char **argv) {
  if (argc != 3 && argc != 4)
    return 1;
  Display *const own = XOpenDisplay(nullptr), *const other = XOpenDisplay(nullptr);
  if (!own || !other)
    software::fail("no X display");
  for (int i = 0; i < std::atoi(argv[2]); ++i)
    software::Sequence(own, other, std::atoi(argv[1]) + i)
        .run(std::chrono::milliseconds(argc == 4 ? std::atoi(argv[3]) : 0));
  XCloseDisplay(other);
  XCloseDisplay(own);
  return 0;
}
