#include "tools/renderer.h"

#include <chrono>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace arbiter::tools {

namespace {

RenderError noGl(const std::string &what) {
  return {RenderError::Kind::NoGl, what + " (EGL error " + std::to_string(eglGetError()) + ")", -1};
}

/// A compatibility context that is current on a pbuffer for as long as the object lives.
class Surface {
public:
  Surface() = default;
  Surface(const Surface &) = delete;
  Surface &operator=(const Surface &) = delete;
  ~Surface() {
    if (m_display == EGL_NO_DISPLAY)
      return;
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(m_display);
  }

  /// \returns the step that failed, or nullptr.
  const char *open(int width, int height) {
    m_display = findDisplay();
    if (m_display == EGL_NO_DISPLAY)
      return "no EGL display without a window system";
    static constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE,
                                         EGL_PBUFFER_BIT,
                                         EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_BIT,
                                         EGL_RED_SIZE,
                                         8,
                                         EGL_GREEN_SIZE,
                                         8,
                                         EGL_BLUE_SIZE,
                                         8,
                                         EGL_ALPHA_SIZE,
                                         8,
                                         EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API) || !eglChooseConfig(m_display, kConfig, &config, 1, &count) ||
        count == 0)
      return "no EGL configuration with desktop GL and a pbuffer";
    const EGLint size[] = {EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(m_display, config, size);
    const EGLContext context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, nullptr);
    if (surface == EGL_NO_SURFACE || context == EGL_NO_CONTEXT)
      return "no pbuffer of this size, or no GL context";
    return eglMakeCurrent(m_display, surface, surface, context) ? nullptr : "eglMakeCurrent failed";
  }

private:
  static EGLDisplay initialised(EGLenum platform, void *native) {
    const EGLDisplay display = eglGetPlatformDisplayEXT(platform, native, nullptr);
    return display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr) ? display
                                                                                 : EGL_NO_DISPLAY;
  }

  /// Mesa's surfaceless platform, or the first device that will do (NVIDIA).
  static EGLDisplay findDisplay() {
    if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base"))
      return EGL_NO_DISPLAY;
    EGLDisplay display = EGL_NO_DISPLAY;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
      display = initialised(EGL_PLATFORM_SURFACELESS_MESA, nullptr);
    if (display != EGL_NO_DISPLAY ||
        !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device"))
      return display;
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    if (!eglQueryDevicesEXT(16, devices, &count))
      return EGL_NO_DISPLAY;
    for (EGLint i = 0; i < count && display == EGL_NO_DISPLAY; ++i)
      display = initialised(EGL_PLATFORM_DEVICE_EXT, devices[i]);
    return display;
  }

  EGLDisplay m_display = EGL_NO_DISPLAY;
};

int query(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

int programLimit(GLenum name) {
  GLint value = 0;
  glGetProgramivARB(GL_FRAGMENT_PROGRAM_ARB, name, &value);
  return value;
}

RenderError sceneError(const std::string &message) {
  return {RenderError::Kind::Scene, message, -1};
}

/// Anything out of the limits is named here, before GL gives it a nameless error.
std::string beyondLimits(const Scene &scene) {
  const int units = query(GL_MAX_TEXTURE_IMAGE_UNITS_ARB);
  for (const Scene::Texture &texture : scene.textures)
    if (int(texture.unit) >= units)
      return "--texture " + std::to_string(texture.unit) + ": there are " + std::to_string(units) +
             " texture image units";
  if (scene.feedback >= units)
    return "--feedback " + std::to_string(scene.feedback) + ": there are " + std::to_string(units) +
           " texture image units";
  const int locals = programLimit(GL_MAX_PROGRAM_LOCAL_PARAMETERS_ARB);
  for (const Scene::Parameter &parameter : scene.locals)
    if (int(parameter.index) >= locals)
      return "--local " + std::to_string(parameter.index) + ": there are " +
             std::to_string(locals) + " local parameters";
  const int envs = programLimit(GL_MAX_PROGRAM_ENV_PARAMETERS_ARB);
  for (const Scene::Parameter &parameter : scene.envs)
    if (int(parameter.index) >= envs)
      return "--env " + std::to_string(parameter.index) + ": there are " + std::to_string(envs) +
             " environment parameters";
  return {};
}

void upload(unsigned unit, const Picture &picture, bool nearest) {
  GLuint name = 0;
  glActiveTexture(GL_TEXTURE0 + unit);
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  const GLint filter = nearest ? GL_NEAREST : GL_LINEAR;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA,
               GL_UNSIGNED_BYTE, picture.bytes.data());
}

void quad(int coordinateSets) {
  static constexpr float kCorners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  glBegin(GL_QUADS);
  for (const auto &[s, t] : kCorners) {
    glColor4f(s, t, 0, 1);
    for (int set = 0; set < coordinateSets; ++set)
      glMultiTexCoord4f(GL_TEXTURE0 + GLenum(set), s, t, 0, 1);
    glVertex2f(2 * s - 1, 2 * t - 1);
  }
  glEnd();
}

/// Loads the program, textures and parameters. \returns false with `error` filled.
bool prepare(const Scene &scene, RenderError &error) {
  if (!epoxy_has_gl_extension("GL_ARB_fragment_program")) {
    error = {RenderError::Kind::NoGl, "this GL has no GL_ARB_fragment_program", -1};
    return false;
  }
  if (const std::string fault = beyondLimits(scene); !fault.empty()) {
    error = sceneError(fault);
    return false;
  }
  GLuint program = 0;
  glGenProgramsARB(1, &program);
  glBindProgramARB(GL_FRAGMENT_PROGRAM_ARB, program);
  glProgramStringARB(GL_FRAGMENT_PROGRAM_ARB, GL_PROGRAM_FORMAT_ASCII_ARB,
                     GLsizei(scene.program.size()), scene.program.data());
  if (glGetError() != GL_NO_ERROR) {
    const auto *text = reinterpret_cast<const char *>(glGetString(GL_PROGRAM_ERROR_STRING_ARB));
    error = {RenderError::Kind::Program, text == nullptr ? "" : text,
             query(GL_PROGRAM_ERROR_POSITION_ARB)};
    return false;
  }
  for (const Scene::Parameter &parameter : scene.locals)
    glProgramLocalParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, parameter.index, parameter.value.data());
  for (const Scene::Parameter &parameter : scene.envs)
    glProgramEnvParameter4fvARB(GL_FRAGMENT_PROGRAM_ARB, parameter.index, parameter.value.data());
  for (const Scene::Texture &texture : scene.textures)
    upload(texture.unit, texture.picture, int(texture.unit) == scene.feedback);
  return true;
}

void drawFrame(const Scene &scene, int coordinateSets) {
  glClear(GL_COLOR_BUFFER_BIT);
  quad(coordinateSets);
  if (scene.feedback >= 0) {
    glActiveTexture(GL_TEXTURE0 + GLenum(scene.feedback));
    glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, scene.width, scene.height);
  }
}

} // namespace

Result<Rendering, RenderError> render(const Scene &scene) {
  Surface surface;
  if (const char *step = surface.open(scene.width, scene.height))
    return noGl(step);
  RenderError error;
  if (!prepare(scene, error))
    return error;

  Rendering rendering;
  rendering.renderer = reinterpret_cast<const char *>(glGetString(GL_RENDERER));
  glViewport(0, 0, scene.width, scene.height);
  glEnable(GL_FRAGMENT_PROGRAM_ARB);
  const int coordinateSets = query(GL_MAX_TEXTURE_COORDS_ARB);
  using Clock = std::chrono::steady_clock;
  Clock::time_point begin = Clock::now();
  for (int frame = 0; frame < scene.frames; ++frame) {
    drawFrame(scene, coordinateSets);
    if (frame == 0 && scene.frames > 1) {
      glFinish();
      begin = Clock::now();
    }
  }
  glFinish();
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  rendering.millisecondsPerFrame = took.count() / std::max(1, scene.frames - 1);

  rendering.picture.width = scene.width;
  rendering.picture.height = scene.height;
  rendering.picture.bytes.resize(std::size_t(4) * scene.width * scene.height);
  glReadPixels(0, 0, scene.width, scene.height, GL_RGBA, GL_UNSIGNED_BYTE,
               rendering.picture.bytes.data());
  if (const GLenum code = glGetError(); code != GL_NO_ERROR)
    return RenderError{RenderError::Kind::NoGl, "GL error " + std::to_string(code), -1};
  return rendering;
}

} // namespace arbiter::tools
