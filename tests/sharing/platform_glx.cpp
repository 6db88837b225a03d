#include "platform.h"

#include <epoxy/gl.h>
#include <epoxy/glx.h>

#include <X11/Xutil.h>

namespace sharing {

namespace {

/// X errors end the process with their text, which is what a test wants.
class GlxPlatform final : public Platform {
public:
  GlxPlatform() {
    XInitThreads();
    m_display = XOpenDisplay(nullptr);
    if (!m_display)
      die("no X display");
    const int wanted[] = {GLX_DRAWABLE_TYPE,
                          GLX_WINDOW_BIT,
                          GLX_RENDER_TYPE,
                          GLX_RGBA_BIT,
                          GLX_RED_SIZE,
                          8,
                          GLX_GREEN_SIZE,
                          8,
                          GLX_BLUE_SIZE,
                          8,
                          GLX_ALPHA_SIZE,
                          8,
                          GLX_DEPTH_SIZE,
                          24,
                          GLX_STENCIL_SIZE,
                          8,
                          GLX_DOUBLEBUFFER,
                          True,
                          None};
    int count = 0;
    GLXFBConfig *const configs =
        glXChooseFBConfig(m_display, DefaultScreen(m_display), wanted, &count);
    if (!configs || count == 0)
      die("no GLX configuration of RGBA8 with depth and stencil");
    m_config = configs[0];
    XFree(configs);
    m_visual = glXGetVisualFromFBConfig(m_display, m_config);
    m_colormap =
        XCreateColormap(m_display, DefaultRootWindow(m_display), m_visual->visual, AllocNone);
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
  /// Beside the others, so that none hides another.
  void *makeDrawable(Size size) override {
    XSetWindowAttributes attributes = {};
    attributes.colormap = m_colormap;
    attributes.override_redirect = True;
    const int at = 130 * (m_windows++ % 4);
    const Window window =
        XCreateWindow(m_display, DefaultRootWindow(m_display), at, 0, unsigned(size.width),
                      unsigned(size.height), 0, m_visual->depth, InputOutput, m_visual->visual,
                      CWColormap | CWBorderPixel | CWOverrideRedirect, &attributes);
    XMapWindow(m_display, window);
    XSync(m_display, False);
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
    std::vector<unsigned char> bytes;
    XImage *const image = XGetImage(m_display, Window(drawable), 0, 0, unsigned(size.width),
                                    unsigned(size.height), AllPlanes, ZPixmap);
    for (int y = size.height - 1; image && y >= 0; --y)
      for (int x = 0; x < size.width; ++x) {
        const unsigned long pixel = XGetPixel(image, x, y);
        for (const int shift : {16, 8, 0})
          bytes.push_back(static_cast<unsigned char>(pixel >> shift));
        bytes.push_back(255);
      }
    if (image)
      XDestroyImage(image);
    return bytes;
  }

private:
  Display *m_display = nullptr;
  GLXFBConfig m_config = nullptr;
  XVisualInfo *m_visual = nullptr;
  Colormap m_colormap = 0;
  int m_windows = 0;
};

} // namespace

std::unique_ptr<Platform> makeGlxPlatform() { return std::make_unique<GlxPlatform>(); }

} // namespace sharing
