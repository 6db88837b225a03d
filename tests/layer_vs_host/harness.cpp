#include "harness.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <sys/wait.h>
#include <unistd.h>

#include "../rasterizer_vs_host/glx_windows.h"

namespace paths {

namespace {

[[noreturn]] void die(const char *why) {
  std::fprintf(stderr, "paths: %s\n", why);
  std::exit(2);
}

std::string quoted(const std::string &text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += '\\';
    out += c;
  }
  return out + "\"";
}

template <typename Range, typename Print>
std::string joined(const Range &range, const char *open, const char *close, Print print) {
  std::string out = open;
  for (const auto &element : range)
    out += (out.size() > 1 ? ", " : "") + print(element);
  return out + close;
}

} // namespace

void Recorder::picture(const std::string &what) {
  Picture picture{what, std::vector<unsigned char>(std::size_t(kSize) * kSize * 4)};
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
  m_pictures.push_back(std::move(picture));
}

void Recorder::value(const std::string &what, double number) {
  m_values.emplace_back(what, number);
}

void Recorder::errors(const std::string &what) {
  constexpr int kMax = 8;
  for (int i = 0; i < kMax; ++i) {
    const GLenum error = glGetError();
    value(what + ": error", error);
    if (error == GL_NO_ERROR)
      return;
  }
}

void Recorder::check(bool holds, const std::string &what) {
  if (!holds)
    m_failed.push_back(what);
}

void Recorder::pixel(const std::string &what, int x, int y, Pixel wanted) {
  const Pixel got = readPixel(x, y);
  bool same = true;
  for (std::size_t i = 0; i < got.size(); ++i)
    same = same && std::abs(got[i] - wanted[i]) <= 2;
  char text[160];
  std::snprintf(text, sizeof text, "%s: (%d %d) is %d %d %d %d, not %d %d %d %d", what.c_str(), x,
                y, got[0], got[1], got[2], got[3], wanted[0], wanted[1], wanted[2], wanted[3]);
  check(same, text);
}

void Recorder::write(const std::string &name, const std::string &folder) const {
  for (std::size_t i = 0; i < m_pictures.size(); ++i) {
    const std::string path = folder + "/" + name + "." + std::to_string(i) + ".rgba";
    const std::unique_ptr<FILE, int (*)(FILE *)> file(std::fopen(path.c_str(), "wb"), std::fclose);
    if (!file || std::fwrite(m_pictures[i].rgba.data(), 1, m_pictures[i].rgba.size(), file.get()) !=
                     m_pictures[i].rgba.size())
      die("a picture cannot be written");
  }
  const auto text = [](const std::string &s) { return quoted(s); };
  std::printf("{\"case\": %s, \"skipped\": %s, \"failed\": %s, \"pictures\": %s, \"values\": %s}\n",
              quoted(name).c_str(), quoted(m_skipped).c_str(),
              joined(m_failed, "[", "]", text).c_str(),
              joined(m_pictures, "[", "]", [](const Picture &p) { return quoted(p.what); }).c_str(),
              joined(m_values, "[", "]", [](const auto &v) {
                char number[40];
                std::snprintf(number, sizeof number, "%.9g", v.second);
                return "[" + quoted(v.first) + ", " + quoted(number) + "]";
              }).c_str());
  std::fflush(stdout);
}

namespace {

/// The case's drawable on the X server.
struct Surface {
  Display *display = nullptr;
  GLXFBConfig config = nullptr;
  GLXDrawable drawable = 0;
  GLXContext context = nullptr;
};
Surface g_surface;

GLXDrawable makeDrawable(const std::string &kind) {
  Display *const display = g_surface.display;
  if (kind == "pbuffer") {
    const int size[] = {GLX_PBUFFER_WIDTH, kSize, GLX_PBUFFER_HEIGHT, kSize, None};
    return glXCreatePbuffer(display, g_surface.config, size);
  }
  if (kind == "pixmap") {
    XVisualInfo *const visual = glXGetVisualFromFBConfig(display, g_surface.config);
    if (!visual)
      die("the configuration has no visual");
    const Pixmap pixmap =
        XCreatePixmap(display, DefaultRootWindow(display), kSize, kSize, unsigned(visual->depth));
    return glXCreatePixmap(display, g_surface.config, pixmap, nullptr);
  }
  return glXCreateWindow(display, g_surface.config,
                         software::makeWindow(display, g_surface.config, kSize, kSize), nullptr);
}

void openSurface(const std::string &kind) {
  g_surface.display = XOpenDisplay(nullptr);
  if (!g_surface.display)
    die("no X display");
  g_surface.config = software::chooseGlxConfig(
      g_surface.display, GLX_PBUFFER_BIT | GLX_WINDOW_BIT | GLX_PIXMAP_BIT,
      {GLX_ACCUM_RED_SIZE, 8, GLX_ACCUM_ALPHA_SIZE, 8, GLX_DOUBLEBUFFER, False});
  if (!g_surface.config)
    die("no GLX configuration with an accumulation buffer");
  g_surface.drawable = makeDrawable(kind);
  g_surface.context = createContext();
  makeCurrent(g_surface.context);
  glViewport(0, 0, kSize, kSize);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

std::vector<Case> allCases() {
  std::vector<Case> all;
  for (const auto *table :
       {&kListCases, &kListStateCases, &kNestedListCases, &kSharedCases, &kFramebufferCases,
        &kDrawCases, &kGlslCases, &kQueryCases, &kPixelCases, &kCompareCases})
    all.insert(all.end(), table->begin(), table->end());
  return all;
}

/// Runs a case in a process of its own, as it may crash the host.
bool runApart(const Case &row, const std::string &folder, const std::string &surface) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) {
    XInitThreads();
    openSurface(surface);
    Recorder recorder;
    row.run(recorder);
    recorder.errors("at the end");
    recorder.write(row.name, folder);
    std::exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0)
    return true;
  std::printf("{\"case\": %s, \"died\": %d}\n", quoted(row.name).c_str(),
              WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status));
  return false;
}

int run(int argc, char **argv) {
  const std::vector<Case> all = allCases();
  std::string folder = ".";
  std::string surface = "window";
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--list")) {
      for (const Case &row : all)
        std::printf("%s\t%s\n", row.name, row.bareHost ? row.bareHost : "");
      return 0;
    }
    if (!std::strcmp(argv[i], "--out") && i + 1 < argc)
      folder = argv[++i];
    else if (!std::strcmp(argv[i], "--surface") && i + 1 < argc)
      surface = argv[++i];
    else
      names.emplace_back(argv[i]);
  }
  bool good = true;
  for (const Case &row : all) {
    bool wanted = names.empty();
    for (const std::string &name : names)
      wanted = wanted || name == row.name;
    if (wanted)
      good = runApart(row, folder, surface) && good;
  }
  return good ? 0 : 1;
}

} // namespace

GLXContext createContext(GLXContext share) {
  return glXCreateNewContext(g_surface.display, g_surface.config, GLX_RGBA_TYPE, share, True);
}
GLXContext mainContext() { return g_surface.context; }
Display *display() { return g_surface.display; }
void makeCurrent(GLXContext context) {
  const GLXDrawable drawable = context ? g_surface.drawable : None;
  if (!glXMakeContextCurrent(g_surface.display, drawable, drawable, context))
    die("a context cannot be made current");
}
void destroyContext(GLXContext context) { glXDestroyContext(g_surface.display, context); }

// --- Scenes ---

const char kMoveVertices[] = "!!ARBvp1.0\n"
                             "ADD result.position, vertex.position, program.env[0];\n"
                             "MOV result.color, vertex.color;\n"
                             "MOV result.texcoord[0], vertex.texcoord[0];\n"
                             "END";
const char kTintFragments[] = "!!ARBfp1.0\n"
                              "MAD result.color, fragment.color, program.local[0], "
                              "program.env[0];\n"
                              "END";

Programs usePrograms() {
  Programs programs;
  programs.vertex = makeProgram(kMoveVertices, kVertex);
  programs.fragment = makeProgram(kTintFragments);
  glEnable(kVertex);
  glEnable(kFragment);
  tint(1, 1, 1);
  return programs;
}

void gradient(float x0, float y0, float x1, float y1) {
  glBegin(GL_QUADS);
  glColor4f(1, 0, 0, 1), glTexCoord2f(0, 0), glVertex2f(x0, y0);
  glColor4f(0, 1, 0, 1), glTexCoord2f(1, 0), glVertex2f(x1, y0);
  glColor4f(0, 0, 1, 1), glTexCoord2f(1, 1), glVertex2f(x1, y1);
  glColor4f(1, 1, 1, 1), glTexCoord2f(0, 1), glVertex2f(x0, y1);
  glEnd();
}

GLuint checkered(int size) {
  std::vector<GLubyte> texels;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      for (const int c : {255 * x / size, 255 * y / size, (x + y) % 2 * 200, 255})
        texels.push_back(GLubyte(c));
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return name;
}

void tint(float r, float g, float b, float a) {
  glProgramLocalParameter4fARB(kFragment, 0, r, g, b, a);
}

} // namespace paths

int main(int argc, char **argv) { return paths::run(argc, argv); }
