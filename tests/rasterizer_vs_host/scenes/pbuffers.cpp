// Draws to a pbuffer of each kind that the display has, by color format, and writes the results as
// records, which run_formats.py compares.
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstdio>
#include <set>
#include <string>
#include <vector>

namespace {

constexpr int kEdge = 48;

constexpr const char *kProgram = "!!ARBfp1.0\n"
                                 "MAD result.color, fragment.color, {1.5, 1.25, 1, 0.75}, "
                                 "{-0.25, 0.125, 0, 0.25};\nEND\n";

/// Draws two quads, the second one blended.
void draw() {
  GLuint program = 0;
  glGenProgramsARB(1, &program);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  const std::string text = kProgram;
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB, GLsizei(text.size()),
                     text.data());
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  glDisable(GL_DITHER);
  glViewport(0, 0, kEdge, kEdge);
  glClearColor(0.25f, 0.5f, 0.75f, 0.5f);
  glClear(GL_COLOR_BUFFER_BIT);
  for (int pass = 0; pass < 2; ++pass) {
    if (pass == 1) {
      glEnable(GL_BLEND);
      glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    }
    const float x = pass == 0 ? -1.0f : -0.5f, y = pass == 0 ? 0.75f : 1.0f;
    const float positions[] = {x, x, 0.75f, x, 0.75f, y, x, y};
    const float colors[] = {0,     0.25f, 1, 0.5f, 1,    0.5f, 0.125f, 0,
                            0.75f, 1,     0, 1,    0.5f, 0,    0.5f,   1};
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
    glVertexPointer(2, GL_FLOAT, 0, positions);
    glColorPointer(4, GL_FLOAT, 0, colors);
    glDrawArrays(GL_QUADS, 0, 4);
  }
}

void record(const std::string &name) {
  std::vector<float> pixels(std::size_t(kEdge) * kEdge * 4);
  glReadPixels(0, 0, kEdge, kEdge, GL_RGBA, GL_FLOAT, pixels.data());
  std::printf("%s\t%zu\n", name.c_str(), pixels.size() * sizeof(float));
  std::fwrite(pixels.data(), sizeof(float), pixels.size(), stdout);
}

} // namespace

int main() {
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    std::fprintf(stderr, "rasterizer-pbuffers: no surfaceless display\n");
    return 1;
  }
  eglBindAPI(EGL_OPENGL_API);
  EGLConfig configs[400];
  EGLint count = 0;
  eglGetConfigs(display, configs, 400, &count);
  std::set<std::string> seen;
  for (EGLint i = 0; i < count; ++i) {
    const auto get = [&](EGLint name) {
      EGLint value = 0;
      eglGetConfigAttrib(display, configs[i], name, &value);
      return value;
    };
    const bool isFloat = get(EGL_COLOR_COMPONENT_TYPE_EXT) == EGL_COLOR_COMPONENT_TYPE_FLOAT_EXT;
    std::string name = isFloat ? "f" : "u";
    for (const EGLint size : {EGL_RED_SIZE, EGL_GREEN_SIZE, EGL_BLUE_SIZE, EGL_ALPHA_SIZE})
      name += std::to_string(get(size)) + "-";
    if ((get(EGL_SURFACE_TYPE) & EGL_PBUFFER_BIT) == 0 || get(EGL_SAMPLES) != 0 ||
        (get(EGL_RENDERABLE_TYPE) & EGL_OPENGL_BIT) == 0 || !seen.insert(name).second)
      continue;
    const EGLint size[] = {EGL_WIDTH, kEdge, EGL_HEIGHT, kEdge, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, configs[i], size);
    const EGLContext context = eglCreateContext(display, configs[i], EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display, surface, surface, context)) {
      std::fprintf(stderr, "rasterizer-pbuffers: %s cannot be current\n", name.c_str());
      return 1;
    }
    draw();
    record(name + (glGetError() == GL_NO_ERROR ? "" : " error"));
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display, context);
    eglDestroySurface(display, surface);
  }
  return 0;
}
