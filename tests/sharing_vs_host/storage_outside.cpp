// Scenes of storage that is shared outside of GL: memory of another interface, an X pixmap.
#include <unistd.h>

#include <epoxy/glx.h>
#include <sys/mman.h>

#include "storage.h"

namespace storage {

namespace {

/// The header of memory that llvmpipe exports: sizes in bytes, and the first 16 bytes of the SHA-1
/// of the driver's name.
struct ExportedMemory {
  std::size_t size = 0, offset = 0;
  unsigned char driver[16] = {0x6c, 0xb9, 0xee, 0x07, 0x4a, 0x0b, 0xad, 0x7b,
                              0x01, 0x2e, 0x1b, 0xe9, 0x69, 0x7e, 0x53, 0x0f};
};

struct Screen {
  Display *display = nullptr;
  GLXFBConfig config = nullptr;
};
Screen g_screen;

GLXFBConfig bindable(Display *display) {
  const int wanted[] = {GLX_DRAWABLE_TYPE,
                        GLX_PIXMAP_BIT | GLX_WINDOW_BIT,
                        GLX_BIND_TO_TEXTURE_RGB_EXT,
                        True,
                        GLX_BIND_TO_TEXTURE_TARGETS_EXT,
                        GLX_TEXTURE_2D_BIT_EXT,
                        GLX_DEPTH_SIZE,
                        0,
                        None};
  int count = 0;
  GLXFBConfig *const all = glXChooseFBConfig(display, DefaultScreen(display), wanted, &count);
  for (int i = 0; i < count; ++i) {
    XVisualInfo *const visual = glXGetVisualFromFBConfig(display, all[i]);
    if (visual && visual->depth == DefaultDepth(display, DefaultScreen(display)))
      return all[i];
  }
  return nullptr;
}

} // namespace

void importedMemory() {
  constexpr std::size_t kSize = 1 << 20, kBegin = 4096;
  if (!epoxy_has_gl_extension("GL_EXT_memory_object_fd"))
    skip("no memory objects");
  const ExportedMemory header = {kSize + kBegin, kBegin};
  const int file = memfd_create("memory", 0);
  if (ftruncate(file, kSize + kBegin) != 0 ||
      write(file, &header, sizeof header) != ssize_t(sizeof header))
    skip("no memory");
  const GLuint before = makeTexture(true);
  fill(before, 200); // the rasterizer has been used by now
  show(before, "before");
  GLuint memory = 0, names[2];
  glCreateMemoryObjectsEXT(1, &memory);
  glImportMemoryFdEXT(memory, kSize, GL_HANDLE_TYPE_OPAQUE_FD_EXT, file);
  glGenTextures(2, names);
  for (const GLuint name : names) {
    unfiltered(name);
    glTexStorageMem2DEXT(GL_TEXTURE_2D, 1, GL_RGBA8, kEdge, kEdge, memory, 0);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebufferOf(names[0]));
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    skip("the host takes no memory that looks like its own");
  for (int i = 0; i < 3; ++i) {
    fill(names[0], 40 + 10 * i);
    show(names[1], "the second, after the first was drawn to");
    fill(names[1], 140 + 10 * i);
    show(names[0], "the first, after the second was drawn to");
  }
}

void openScreen() {
  g_screen.display = XOpenDisplay(nullptr);
  if (!g_screen.display)
    skip("no X display");
  g_screen.config = bindable(g_screen.display);
  if (!g_screen.config ||
      !epoxy_has_glx_extension(g_screen.display, DefaultScreen(g_screen.display),
                               "GLX_EXT_texture_from_pixmap"))
    skip("no pixmaps as textures");
  const GLXContext context =
      glXCreateNewContext(g_screen.display, g_screen.config, GLX_RGBA_TYPE, nullptr, True);
  const Window window = XCreateSimpleWindow(g_screen.display, DefaultRootWindow(g_screen.display),
                                            0, 0, kEdge, kEdge, 0, 0, 0);
  if (!glXMakeContextCurrent(g_screen.display, window, window, context))
    skip("no context");
  makeObjects();
}

void boundPixmap() {
  Display *const display = g_screen.display;
  const Pixmap pixmap = XCreatePixmap(display, DefaultRootWindow(display), kEdge, kEdge,
                                      unsigned(DefaultDepth(display, DefaultScreen(display))));
  const int attributes[] = {GLX_TEXTURE_TARGET_EXT, GLX_TEXTURE_2D_EXT, GLX_TEXTURE_FORMAT_EXT,
                            GLX_TEXTURE_FORMAT_RGB_EXT, None};
  const GLXPixmap drawable = glXCreatePixmap(display, g_screen.config, pixmap, attributes);
  const GC context = XCreateGC(display, pixmap, 0, nullptr);
  const GLuint texture = makeTexture(false);
  fill(texture, 30);
  show(texture, "as it was");
  for (const unsigned long color : {0xFF8040ul, 0x204060ul, 0x90F010ul}) {
    XSetForeground(display, context, color);
    XFillRectangle(display, pixmap, context, 0, 0, kEdge, kEdge);
    XSetForeground(display, context, 0x102030);
    XFillRectangle(display, pixmap, context, 2, 3, 5, 6);
    XSync(display, False);
    unfiltered(texture);
    glXBindTexImageEXT(display, drawable, GLX_FRONT_LEFT_EXT, nullptr);
    show(texture, "bound");
    glBindTexture(GL_TEXTURE_2D, texture);
    glXReleaseTexImageEXT(display, drawable, GLX_FRONT_LEFT_EXT);
  }
}

} // namespace storage
