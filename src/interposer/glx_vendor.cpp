/// The GLX side of the vendor library: libglvnd's vendor interface around the host's own vendor.
/// Context calls keep the registry, GetProcAddress answers give the entry points, all else is the
/// host's.
// Before Xlib's macros.
#include "state/software/residency.h"

#include <cstring>
#include <iterator>
#include <mutex>
#include <vector>

#include <dlfcn.h>

// Our names stand in tables, not in prototypes of the library's headers.
#include <glvnd/libglxabi.h>

#include <X11/Xlibint.h>
#undef min
#undef max
#undef None

#include "dispatch/entry_points.h"
#include "interposer/host_choice.h"
#include "interposer/process.h"
#include "interposer/provider.h"
#include "interposer/registry.h"
#include "interposer/x_present.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

using state::Provider;

__GLXapiImports g_host;

void *hostLookup(const char *name) {
  return checked(name, g_host.getProcAddress(reinterpret_cast<const GLubyte *>(name)));
}

const host::HostTable &table() {
  static const host::HostTable *const s_table = [] {
    auto *made = new host::HostTable;
    const std::size_t found = host::loadHostTable(*made, hostLookup);
    logDebug("layer", "GLX: the host has %zu of the functions asked for", found);
    return made;
  }();
  return *s_table;
}

registry::Key key(Display *display, GLXContext context) {
  return {Provider::Glx, display, context};
}

int displayCloses(Display *display, XExtCodes *) {
  registry::displayClosed(Provider::Glx, display);
  presentingDisplayCloses(display);
  return 0;
}

/// Asks Xlib to say when the display is closed. Xlib is the application's; it is not linked.
void watch(Display *display) {
  static std::mutex *const s_mutex = new std::mutex;
  static auto *const s_addExtension =
      reinterpret_cast<decltype(&XAddExtension)>(dlsym(RTLD_DEFAULT, "XAddExtension"));
  static auto *const s_setCloseDisplay =
      reinterpret_cast<decltype(&XESetCloseDisplay)>(dlsym(RTLD_DEFAULT, "XESetCloseDisplay"));
  if (!display || !s_addExtension || !s_setCloseDisplay)
    return;
  const std::lock_guard lock(*s_mutex);
  // Found again in the display's own list of extensions, which dies with it.
  for (const _XExtension *e = display->ext_procs; e; e = e->next)
    if (e->close_display == displayCloses)
      return;
  if (const XExtCodes *codes = s_addExtension(display))
    s_setCloseDisplay(display, codes->extension, displayCloses);
}

GLXContext remember(Display *display, GLXContext context, GLXContext share) {
  if (context) {
    watch(display);
    registry::created(key(display, context), table(), share);
  }
  return context;
}

template <typename Function> struct Host {
  void *function = nullptr;
  template <typename... Arguments> auto operator()(Arguments... arguments) const {
    return reinterpret_cast<Function *>(function)(arguments...);
  }
};

Host<decltype(glXCreateContext)> g_createContext;
Host<decltype(glXCreateNewContext)> g_createNewContext;
Host<GLXContext(Display *, GLXFBConfig, GLXContext, Bool, const int *)> g_createContextAttribs;
Host<GLXContext(Display *, GLXFBConfig, int, GLXContext, Bool)> g_createContextWithConfig;
Host<GLXContext(Display *, GLXContextID)> g_importContext;
Host<void(Display *, GLXContext)> g_freeContext;
Host<decltype(glXDestroyContext)> g_destroyContext;
Host<decltype(glXCopyContext)> g_copyContext;
Host<decltype(glXMakeCurrent)> g_makeCurrent;
Host<decltype(glXMakeContextCurrent)> g_makeContextCurrent;
Host<Bool(Display *, GLXDrawable, GLXDrawable, GLXContext)> g_makeCurrentRead;
Host<decltype(glXSwapBuffers)> g_swapBuffers;
Host<std::int64_t(Display *, GLXDrawable, std::int64_t, std::int64_t, std::int64_t)>
    g_swapBuffersMsc;
Host<void *(const GLubyte *)> g_getProcAddress, g_getProcAddressArb;

GLXContext createContext(Display *display, XVisualInfo *visual, GLXContext share, Bool direct) {
  return remember(display, g_createContext(display, visual, share, direct), share);
}

GLXContext createNewContext(Display *display, GLXFBConfig config, int type, GLXContext share,
                            Bool direct) {
  return remember(display, g_createNewContext(display, config, type, share, direct), share);
}

GLXContext createContextAttribs(Display *display, GLXFBConfig config, GLXContext share, Bool direct,
                                const int *attributes) {
  return remember(display, g_createContextAttribs(display, config, share, direct, attributes),
                  share);
}

GLXContext createContextWithConfig(Display *display, GLXFBConfig config, int type, GLXContext share,
                                   Bool direct) {
  return remember(display, g_createContextWithConfig(display, config, type, share, direct), share);
}

GLXContext importContext(Display *display, GLXContextID id) {
  return remember(display, g_importContext(display, id), nullptr);
}

void freeContext(Display *display, GLXContext context) {
  registry::destroyed(key(display, context));
  g_freeContext(display, context);
}

void destroyContext(Display *display, GLXContext context) {
  registry::destroyed(key(display, context));
  g_destroyContext(display, context);
}

void copyContext(Display *display, GLXContext from, GLXContext to, unsigned long mask) {
  g_copyContext(display, from, to, mask);
  registry::copied(key(display, from), key(display, to), mask);
}

Host<decltype(glXQueryDrawable)> g_queryDrawable;

/// The server's answer for windows of GLX, windows of X and pixmaps alike.
bool sizeOf(const state::software::Drawable &drawable, int &width, int &height, bool) {
  auto *const display = const_cast<Display *>(static_cast<const Display *>(drawable.display));
  const auto name = GLXDrawable(reinterpret_cast<std::uintptr_t>(drawable.draw));
  unsigned int w = 0, h = 0;
  g_queryDrawable(display, name, GLX_WIDTH, &w);
  g_queryDrawable(display, name, GLX_HEIGHT, &h);
  width = int(w);
  height = int(h);
  return w != 0 && h != 0;
}

/// What the context that is current on the thread draws to.
constinit thread_local GLXDrawable t_drawable __attribute__((tls_model("initial-exec"))) = 0;

/// The X windows of GLX windows, which have names of their own.
struct WindowNames {
  struct Name {
    GLXWindow glx;
    Window x;
  };
  std::mutex mutex;
  std::vector<Name> names;
};
WindowNames &windowNames() {
  static auto *const s_names = new WindowNames;
  return *s_names;
}

/// A drawable that is no GLX window may be a window of X.
XID windowOf(GLXDrawable drawable) {
  WindowNames &n = windowNames();
  const std::lock_guard lock(n.mutex);
  for (const WindowNames::Name &name : n.names)
    if (name.glx == drawable)
      return name.x;
  return drawable;
}

Host<decltype(glXCreateWindow)> g_createWindow;
Host<decltype(glXDestroyWindow)> g_destroyWindow;

GLXWindow createWindow(Display *display, GLXFBConfig config, Window window, const int *attributes) {
  const GLXWindow made = g_createWindow(display, config, window, attributes);
  if (made && made != window) {
    WindowNames &n = windowNames();
    const std::lock_guard lock(n.mutex);
    n.names.push_back({made, window});
  }
  return made;
}

void destroyWindow(Display *display, GLXWindow window) {
  {
    WindowNames &n = windowNames();
    const std::lock_guard lock(n.mutex);
    std::erase_if(n.names, [window](const WindowNames::Name &name) { return name.glx == window; });
  }
  g_destroyWindow(display, window);
}

Bool madeCurrent(Bool ok, Display *display, GLXDrawable draw, GLXDrawable read,
                 GLXContext context) {
  if (!ok)
    return ok;
  using state::software::Drawable;
  Drawable drawable = {.kind = draw && g_queryDrawable.function ? Drawable::Kind::Window
                                                                : Drawable::Kind::None,
                       .display = display,
                       .draw = reinterpret_cast<const void *>(std::uintptr_t(draw)),
                       .sameRead = draw == read,
                       .size = sizeOf};
  if (drawable.kind == Drawable::Kind::Window && context)
    offerPresenting(display, std::uint32_t(windowOf(draw)), drawable);
  t_drawable = context ? draw : 0;
  registry::madeCurrent(key(display, context), table(), &drawable);
  return ok;
}

Bool makeCurrent(Display *display, GLXDrawable drawable, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_makeCurrent(display, drawable, context), display, drawable, drawable,
                     context);
}

Bool makeContextCurrent(Display *display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_makeContextCurrent(display, draw, read, context), display, draw, read,
                     context);
}

Bool makeCurrentRead(Display *display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_makeCurrentRead(display, draw, read, context), display, draw, read, context);
}

/// The drawable that is shown may be another one than the current context's: nothing of ours is in
/// its back buffer then, but the host must be up to date with its own.
/// \return the frame is shown: the host has nothing to swap
bool frameEnds(GLXDrawable drawable) {
  if (!registry::isCurrent(Provider::Glx))
    return false;
  if (state::Context *const context = state::currentContext())
    state::frameEnd(context);
  return state::exchange(drawable == t_drawable ? state::Exchange::Present : state::Exchange::Read,
                         "glXSwapBuffers");
}

void exchanges(state::Exchange what, const char *name) {
  if (registry::isCurrent(Provider::Glx))
    state::exchange(what, name);
}

void swapBuffers(Display *display, GLXDrawable drawable) {
  if (!frameEnds(drawable))
    g_swapBuffers(display, drawable);
}

std::int64_t swapBuffersMsc(Display *display, GLXDrawable drawable, std::int64_t target,
                            std::int64_t divisor, std::int64_t remainder) {
  // The host counts its frames, and answers by that count.
  if (registry::isCurrent(Provider::Glx))
    if (state::Context *const context = state::currentContext())
      state::frameEnd(context);
  exchanges(state::Exchange::Read, "glXSwapBuffersMscOML");
  return g_swapBuffersMsc(display, drawable, target, divisor, remainder);
}

Host<void(Display *, GLXDrawable, int, int, int, int)> g_copySubBuffer;
Host<decltype(glXWaitGL)> g_waitGl;
Host<void(Display *, GLXDrawable, int, const int *)> g_bindTexImage;
Host<void(Display *, GLXDrawable, int)> g_releaseTexImage;

void copySubBuffer(Display *display, GLXDrawable drawable, int x, int y, int width, int height) {
  exchanges(state::Exchange::Read, "glXCopySubBufferMESA");
  g_copySubBuffer(display, drawable, x, y, width, height);
}

void waitGl() {
  exchanges(state::Exchange::Flush, "glXWaitGL");
  g_waitGl();
}

void bindTexImage(Display *display, GLXDrawable drawable, int buffer, const int *attributes) {
  exchanges(state::Exchange::Change, "glXBindTexImageEXT");
  g_bindTexImage(display, drawable, buffer, attributes);
}

void releaseTexImage(Display *display, GLXDrawable drawable, int buffer) {
  exchanges(state::Exchange::Change, "glXReleaseTexImageEXT");
  g_releaseTexImage(display, drawable, buffer);
}

void *getProcAddress(const GLubyte *name);

template <typename Function> void *address(Function *function) {
  return reinterpret_cast<void *>(function);
}

const Hook kHooks[] = {
    {"glXCreateContext", address(createContext), &g_createContext.function},
    {"glXCreateNewContext", address(createNewContext), &g_createNewContext.function},
    {"glXCreateContextAttribsARB", address(createContextAttribs), &g_createContextAttribs.function},
    {"glXCreateContextWithConfigSGIX", address(createContextWithConfig),
     &g_createContextWithConfig.function},
    {"glXImportContextEXT", address(importContext), &g_importContext.function},
    {"glXFreeContextEXT", address(freeContext), &g_freeContext.function},
    {"glXDestroyContext", address(destroyContext), &g_destroyContext.function},
    {"glXCopyContext", address(copyContext), &g_copyContext.function},
    {"glXMakeCurrent", address(makeCurrent), &g_makeCurrent.function},
    {"glXMakeContextCurrent", address(makeContextCurrent), &g_makeContextCurrent.function},
    {"glXMakeCurrentReadSGI", address(makeCurrentRead), &g_makeCurrentRead.function},
    {"glXCreateWindow", address(createWindow), &g_createWindow.function},
    {"glXDestroyWindow", address(destroyWindow), &g_destroyWindow.function},
    {"glXSwapBuffers", address(swapBuffers), &g_swapBuffers.function},
    {"glXSwapBuffersMscOML", address(swapBuffersMsc), &g_swapBuffersMsc.function},
    {"glXCopySubBufferMESA", address(copySubBuffer), &g_copySubBuffer.function},
    {"glXWaitGL", address(waitGl), &g_waitGl.function},
    {"glXBindTexImageEXT", address(bindTexImage), &g_bindTexImage.function},
    {"glXReleaseTexImageEXT", address(releaseTexImage), &g_releaseTexImage.function},
    {"glXGetProcAddress", address(getProcAddress), &g_getProcAddress.function},
    {"glXGetProcAddressARB", address(getProcAddress), &g_getProcAddressArb.function},
};

void *getProcAddress(const GLubyte *name) {
  const char *const text = reinterpret_cast<const char *>(name);
  if (!text)
    return nullptr;
  if (std::strncmp(text, "glX", 3) != 0)
    return resolveGl(text, hostLookup);
  const Hook *const hook = findHook(std::begin(kHooks), std::end(kHooks), text);
  if (!hook)
    return hostLookup(text);
  return *hook->host ? hook->ours : nullptr;
}

/// False for a second vendor of this name in the process: there is one host to stand in front of.
bool loadHost(std::uint32_t version, const __GLXapiExports *exports, __GLXvendorInfo *vendor) {
  if (g_host.getProcAddress)
    return false;
  for (const std::string &library : glxCandidates()) {
    void *const main = openHostLibrary(library, __GLX_MAIN_PROTO_NAME);
    if (!main)
      continue;
    g_host = {};
    if (reinterpret_cast<__PFNGLXMAINPROC>(main)(version, exports, vendor, &g_host) &&
        g_host.getProcAddress) {
      logInfo("layer", "GLX: in front of %s", library.c_str());
      loadHooks(std::begin(kHooks), std::end(kHooks), hostLookup);
      g_queryDrawable.function = hostLookup("glXQueryDrawable");
      return true;
    }
  }
  logError("layer", "GLX: no host vendor loads");
  return false;
}

} // namespace

} // namespace arbiter::interposer

extern "C" __attribute__((visibility("default"))) Bool __glx_Main(std::uint32_t version,
                                                                  const __GLXapiExports *exports,
                                                                  __GLXvendorInfo *vendor,
                                                                  __GLXapiImports *imports) {
  using namespace arbiter::interposer;
  if (!loadHost(version, exports, vendor))
    return False;
  *imports = g_host;
  if (!layerAllowed())
    return True;
  imports->getProcAddress = getProcAddress;
  // They would write the host's addresses into libglvnd's stubs, past its dispatch table and us.
  imports->isPatchSupported = nullptr;
  imports->initiatePatch = nullptr;
  imports->releasePatch = nullptr;
  return True;
}
