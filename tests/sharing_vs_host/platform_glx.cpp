#include "platform.h"

#include "../rasterizer_vs_host/glx_windows.h"

namespace sharing {

namespace {

/// Uses GLX. X errors end the process with their text, which is what a test wants.
class GlxPlatform final : public Platform {
public:
  GlxPlatform() {
    XInitThreads();
    m_display = XOpenDisplay(nullptr);
    if (!m_display)
      die("no X display");
    m_config = software::chooseGlxConfig(m_display, GLX_WINDOW_BIT);
    if (!m_config)
      die("no GLX configuration of RGBA8 with depth and stencil");
  }

  void *makeContext(void *share) override {
    const GLXContext context = glXCreateNewContext(m_display, m_config, GLX_RGBA_TYPE,
                                                   static_cast<GLXContext>(share), True);
    if (!context)
      die("no GLX context");
    return context;
  }
  void destroyContext(void *context) override {
    glXDestroyContext(m_display, static_cast<GLXContext>(context));
  }
  /// Places the window beside the others, so that none covers another.
  void *makeDrawable(Size size) override {
    const Window window = software::makeWindow(m_display, m_config, size.width, size.height,
                                               {.x = 130 * (m_windows++ % 4)});
    return reinterpret_cast<void *>(window);
  }
  void destroyDrawable(void *drawable) override {
    XDestroyWindow(m_display, Window(drawable));
    XSync(m_display, False);
  }
  void makeCurrent(void *drawable, void *context) override {
    if (!glXMakeContextCurrent(m_display, GLXDrawable(drawable), GLXDrawable(drawable),
                               static_cast<GLXContext>(context)))
      die("a GLX context does not become current");
  }
  bool hasWindows() const override { return true; }
  void swap(void *drawable) override { glXSwapBuffers(m_display, GLXDrawable(drawable)); }
  void resize(void *drawable, Size size) override {
    XResizeWindow(m_display, Window(drawable), unsigned(size.width), unsigned(size.height));
    XSync(m_display, False);
  }
  std::vector<unsigned char> grab(void *drawable, Size size) override {
    glXWaitGL();
    XSync(m_display, False);
    return software::grabWindow(m_display, Window(drawable), size.width, size.height);
  }

private:
  Display *m_display = nullptr;
  GLXFBConfig m_config = nullptr;
  int m_windows = 0;
};

} // namespace

std::unique_ptr<Platform> makeGlxPlatform() { return std::make_unique<GlxPlatform>(); }

} // namespace sharing
