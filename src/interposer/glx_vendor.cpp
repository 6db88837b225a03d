/// The GLX side of the vendor library: libglvnd's vendor interface around the host's own vendor.
/// Context calls update the registry; GetProcAddress returns the layer's entry points.
// This include must precede Xlib's macros.
#include "state/objects/drawable.h"
#include "state/residency/window_frames.h"

#include <cstring>
#include <exception>
#include <mutex>
#include <vector>

#include <dlfcn.h>

// The layer finds its functions by name in tables and needs no prototypes from headers.
#include <glvnd/libglxabi.h>

#include <X11/Xlibint.h>
#undef min
#undef max
#undef None

#include "dispatch/entry_points.h"
#include "interposer/glx_array_memory.h"
#include "interposer/glx_extensions.h"
#include "interposer/host_choice.h"
#include "interposer/process.h"
#include "interposer/provider.h"
#include "interposer/registry.h"
#include "interposer/x_display.h"
#include "interposer/x_keys.h"
#include "interposer/x_present.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

using state::Provider;

/// The host's functions of GLX.
struct GlxHost {
  __GLXapiImports imports;
  __PFNGLXMAINPROC main;                           ///< of its vendor library
  decltype(__GLXapiExports::getDynDispatch) front; ///< of the libGLX that loaded the layer
  HostFunction<decltype(glXCreateContext)> createContext;
  HostFunction<decltype(glXCreateNewContext)> createNewContext;
  HostFunction<GLXContext(Display *, GLXFBConfig, GLXContext, Bool, const int *)>
      createContextAttribs;
  HostFunction<GLXContext(Display *, GLXFBConfig, int, GLXContext, Bool)> createContextWithConfig;
  HostFunction<GLXContext(Display *, GLXContextID)> importContext;
  HostFunction<void(Display *, GLXContext)> freeContext;
  HostFunction<decltype(glXDestroyContext)> destroyContext;
  HostFunction<decltype(glXCopyContext)> copyContext;
  HostFunction<decltype(glXMakeCurrent)> makeCurrent;
  HostFunction<decltype(glXMakeContextCurrent)> makeContextCurrent;
  HostFunction<Bool(Display *, GLXDrawable, GLXDrawable, GLXContext)> makeCurrentRead;
  HostFunction<decltype(glXSwapBuffers)> swapBuffers;
  HostFunction<std::int64_t(Display *, GLXDrawable, std::int64_t, std::int64_t, std::int64_t)>
      swapBuffersMsc;
  HostFunction<void *(const GLubyte *)> getProcAddress, getProcAddressArb;
  HostFunction<decltype(glXQueryDrawable)> queryDrawable;
  HostFunction<decltype(glXQueryExtensionsString)> queryExtensionsString;
  HostFunction<decltype(glXCreateWindow)> createWindow;
  HostFunction<decltype(glXDestroyWindow)> destroyWindow;
  HostFunction<void(Display *, GLXDrawable, int, int, int, int)> copySubBuffer;
  HostFunction<decltype(glXWaitGL)> waitGl;
  HostFunction<decltype(glXUseXFont)> useXFont;
  HostFunction<void(Display *, GLXDrawable, int, const int *)> bindTexImage;
  HostFunction<void(Display *, GLXDrawable, int)> releaseTexImage;
};
constinit Sealed<GlxHost> g_host;
constinit Sealed<host::HostTable> g_table;

void *hostLookup(const char *name) {
  return checked(name, g_host->imports.getProcAddress(reinterpret_cast<const GLubyte *>(name)));
}

const host::HostTable &table() {
  static const host::HostTable &s_table = loadTable(g_table, hostLookup, "GLX");
  return s_table;
}

registry::Key key(Display *display, GLXContext context) {
  return {Provider::Glx, display, context};
}

GLXContext remember(Display *display, GLXContext context, GLXContext share) {
  if (!context)
    return nullptr;
  watchDisplay(display);
  offerHudKey();
  const HostFunction<decltype(glXIsDirect)> isDirect{hostLookup("glXIsDirect")};
  const bool indirect = isDirect.function && !isDirect(display, context);
  if (registry::created(key(display, context), table(), share, indirect))
    return context;
  g_host->destroyContext(display, context);
  return nullptr;
}

GLXContext createContext(Display *display, XVisualInfo *visual, GLXContext share, Bool direct) {
  return remember(display, g_host->createContext(display, visual, share, direct), share);
}

GLXContext createNewContext(Display *display, GLXFBConfig config, int type, GLXContext share,
                            Bool direct) {
  return remember(display, g_host->createNewContext(display, config, type, share, direct), share);
}

GLXContext createContextAttribs(Display *display, GLXFBConfig config, GLXContext share, Bool direct,
                                const int *attributes) {
  return remember(display, g_host->createContextAttribs(display, config, share, direct, attributes),
                  share);
}

GLXContext createContextWithConfig(Display *display, GLXFBConfig config, int type, GLXContext share,
                                   Bool direct) {
  return remember(display, g_host->createContextWithConfig(display, config, type, share, direct),
                  share);
}

GLXContext importContext(Display *display, GLXContextID id) {
  return remember(display, g_host->importContext(display, id), nullptr);
}

void freeContext(Display *display, GLXContext context) {
  registry::destroyed(key(display, context));
  g_host->freeContext(display, context);
}

void destroyContext(Display *display, GLXContext context) {
  registry::destroyed(key(display, context));
  g_host->destroyContext(display, context);
}

void copyContext(Display *display, GLXContext from, GLXContext to, unsigned long mask) {
  g_host->copyContext(display, from, to, mask);
  registry::copied(key(display, from), key(display, to), mask);
}

/// Asks the server for the size of a GLX window, X window or pixmap.
bool sizeOf(const state::Drawable &drawable, int &width, int &height, bool) {
  auto *const display = const_cast<Display *>(static_cast<const Display *>(drawable.display));
  const auto name = GLXDrawable(reinterpret_cast<std::uintptr_t>(drawable.draw));
  unsigned int w = 0, h = 0;
  g_host->queryDrawable(display, name, GLX_WIDTH, &w);
  g_host->queryDrawable(display, name, GLX_HEIGHT, &h);
  width = int(w);
  height = int(h);
  return w != 0 && h != 0;
}

void swapHost(const state::Drawable &drawable) {
  g_host->swapBuffers(const_cast<Display *>(static_cast<const Display *>(drawable.display)),
                      GLXDrawable(reinterpret_cast<std::uintptr_t>(drawable.draw)));
}

/// The drawable of the thread's current context.
constinit thread_local GLXDrawable t_drawable __attribute__((tls_model("initial-exec"))) = 0;

/// Maps GLX windows, which have names of their own, to their X windows.
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

/// Returns the X window of a drawable. A drawable that is no GLX window may be an X window.
XID windowOf(GLXDrawable drawable) {
  WindowNames &n = windowNames();
  const std::lock_guard lock(n.mutex);
  for (const WindowNames::Name &name : n.names)
    if (name.glx == drawable)
      return name.x;
  return drawable;
}

GLXWindow createWindow(Display *display, GLXFBConfig config, Window window, const int *attributes) {
  const GLXWindow made = g_host->createWindow(display, config, window, attributes);
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
  g_host->destroyWindow(display, window);
}

Bool madeCurrent(Bool ok, Display *display, GLXDrawable draw, GLXDrawable read,
                 GLXContext context) {
  if (!ok)
    return ok;
  using state::Drawable;
  Drawable drawable = {.kind = draw && g_host->queryDrawable.function ? Drawable::Kind::Window
                                                                      : Drawable::Kind::None,
                       .display = display,
                       .draw = reinterpret_cast<const void *>(std::uintptr_t(draw)),
                       .sameRead = draw == read,
                       .size = sizeOf};
  if (drawable.kind == Drawable::Kind::Window && context)
    try {
      offerPresenting(display, std::uint32_t(windowOf(draw)), drawable);
    } catch (const std::exception &) { // out of memory: the host shows the frames
    }
  t_drawable = context ? draw : 0;
  if (registry::madeCurrent(key(display, context), table(), &drawable))
    return ok;
  g_host->makeContextCurrent(display, 0, 0, nullptr);
  t_drawable = 0;
  return False;
}

Bool makeCurrent(Display *display, GLXDrawable drawable, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_host->makeCurrent(display, drawable, context), display, drawable, drawable,
                     context);
}

Bool makeContextCurrent(Display *display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_host->makeContextCurrent(display, draw, read, context), display, draw, read,
                     context);
}

Bool makeCurrentRead(Display *display, GLXDrawable draw, GLXDrawable read, GLXContext context) {
  state::leaveCurrent();
  return madeCurrent(g_host->makeCurrentRead(display, draw, read, context), display, draw, read,
                     context);
}

/// Called when a frame ends. The shown drawable may not be the current context's. Then no pixels
/// are pending for its back buffer, but the host must be up to date with its own.
/// \return true if the frame has been shown, so that the host has nothing to swap
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
    g_host->swapBuffers(display, drawable);
}

std::int64_t swapBuffersMsc(Display *display, GLXDrawable drawable, std::int64_t target,
                            std::int64_t divisor, std::int64_t remainder) {
  // The host counts its frames, and answers by that count, so that it must swap.
  if (registry::isCurrent(Provider::Glx))
    if (state::Context *const context = state::currentContext())
      state::frameEnd(context);
  exchanges(state::Exchange::Read, "glXSwapBuffersMscOML");
  if (registry::isCurrent(Provider::Glx))
    state::hostSwaps();
  return g_host->swapBuffersMsc(display, drawable, target, divisor, remainder);
}

void copySubBuffer(Display *display, GLXDrawable drawable, int x, int y, int width, int height) {
  exchanges(state::Exchange::Read, "glXCopySubBufferMESA");
  g_host->copySubBuffer(display, drawable, x, y, width, height);
}

/// Handles glXUseXFont. Hosts compile the characters' lists by internal calls, which the layer does
/// not see.
void useXFont(Font font, int first, int count, int listBase) {
  if (registry::isCurrent(Provider::Glx))
    state::hostDefinesLists(std::uint32_t(listBase), count);
  g_host->useXFont(font, first, count, listBase);
}

void waitGl() {
  exchanges(state::Exchange::Flush, "glXWaitGL");
  g_host->waitGl();
}

void bindTexImage(Display *display, GLXDrawable drawable, int buffer, const int *attributes) {
  exchanges(state::Exchange::Change, "glXBindTexImageEXT");
  g_host->bindTexImage(display, drawable, buffer, attributes);
}

void releaseTexImage(Display *display, GLXDrawable drawable, int buffer) {
  exchanges(state::Exchange::Change, "glXReleaseTexImageEXT");
  g_host->releaseTexImage(display, drawable, buffer);
}

const char *queryExtensionsString(Display *display, int screen) {
  return switchedExtensions(g_host->queryExtensionsString(display, screen));
}

void *getProcAddress(const GLubyte *name);

// The initializers are only casts: a call would fill the table at run time, in writable memory.
const Hook kHooks[] = {
    {"glXCreateContext", reinterpret_cast<void *>(registry::Guarded<createContext>::call),
     &g_host->createContext.function},
    {"glXCreateNewContext", reinterpret_cast<void *>(registry::Guarded<createNewContext>::call),
     &g_host->createNewContext.function},
    {"glXCreateContextAttribsARB",
     reinterpret_cast<void *>(registry::Guarded<createContextAttribs>::call),
     &g_host->createContextAttribs.function},
    {"glXCreateContextWithConfigSGIX",
     reinterpret_cast<void *>(registry::Guarded<createContextWithConfig>::call),
     &g_host->createContextWithConfig.function},
    {"glXImportContextEXT", reinterpret_cast<void *>(registry::Guarded<importContext>::call),
     &g_host->importContext.function},
    {"glXFreeContextEXT", reinterpret_cast<void *>(registry::Guarded<freeContext>::call),
     &g_host->freeContext.function},
    {"glXDestroyContext", reinterpret_cast<void *>(registry::Guarded<destroyContext>::call),
     &g_host->destroyContext.function},
    {"glXCopyContext", reinterpret_cast<void *>(registry::Guarded<copyContext>::call),
     &g_host->copyContext.function},
    {"glXMakeCurrent", reinterpret_cast<void *>(registry::Guarded<makeCurrent>::call),
     &g_host->makeCurrent.function},
    {"glXMakeContextCurrent", reinterpret_cast<void *>(registry::Guarded<makeContextCurrent>::call),
     &g_host->makeContextCurrent.function},
    {"glXMakeCurrentReadSGI", reinterpret_cast<void *>(registry::Guarded<makeCurrentRead>::call),
     &g_host->makeCurrentRead.function},
    {"glXCreateWindow", reinterpret_cast<void *>(registry::Guarded<createWindow>::call),
     &g_host->createWindow.function},
    {"glXDestroyWindow", reinterpret_cast<void *>(registry::Guarded<destroyWindow>::call),
     &g_host->destroyWindow.function},
    {"glXSwapBuffers", reinterpret_cast<void *>(registry::Guarded<swapBuffers>::call),
     &g_host->swapBuffers.function},
    {"glXSwapBuffersMscOML", reinterpret_cast<void *>(registry::Guarded<swapBuffersMsc>::call),
     &g_host->swapBuffersMsc.function},
    {"glXCopySubBufferMESA", reinterpret_cast<void *>(registry::Guarded<copySubBuffer>::call),
     &g_host->copySubBuffer.function},
    {"glXWaitGL", reinterpret_cast<void *>(registry::Guarded<waitGl>::call),
     &g_host->waitGl.function},
    {"glXUseXFont", reinterpret_cast<void *>(registry::Guarded<useXFont>::call),
     &g_host->useXFont.function},
    {"glXBindTexImageEXT", reinterpret_cast<void *>(registry::Guarded<bindTexImage>::call),
     &g_host->bindTexImage.function},
    {"glXReleaseTexImageEXT", reinterpret_cast<void *>(registry::Guarded<releaseTexImage>::call),
     &g_host->releaseTexImage.function},
    {"glXQueryExtensionsString",
     reinterpret_cast<void *>(registry::Guarded<queryExtensionsString>::call),
     &g_host->queryExtensionsString.function},
    {"glXGetProcAddress", reinterpret_cast<void *>(registry::Guarded<getProcAddress>::call),
     &g_host->getProcAddress.function},
    {"glXGetProcAddressARB", reinterpret_cast<void *>(registry::Guarded<getProcAddress>::call),
     &g_host->getProcAddressArb.function},
};

void *getProcAddress(const GLubyte *name) {
  const char *const text = reinterpret_cast<const char *>(name);
  if (!text)
    return nullptr;
  if (std::strncmp(text, "glX", 3) != 0)
    return resolveGl(text, hostLookup);
  const Hook *const hook = findHook(std::begin(kHooks), std::end(kHooks), text);
  if (!hook) {
    void *const own = arrayMemoryFunction(text);
    return own ? own : hostLookup(text);
  }
  return *hook->host ? hook->function : nullptr;
}

/// Returns functions for GLX names that libGLX does not know. Such a function normally finds its
/// vendor by its arguments; the layer's need none.
void *getDispatchAddress(const GLubyte *name) {
  void *const own = name ? arrayMemoryFunction(reinterpret_cast<const char *>(name)) : nullptr;
  return own ? own : g_host->imports.getDispatchAddress(name);
}

/// Answers a libGLX that asks for its vendors again. Its destructor forgets them, but another
/// thread may still call GLX while one is in exit(). The host answers, as it does without the
/// layer. A second libGLX in the process is refused, as the layer fronts only one host.
bool askHostAgain(std::uint32_t version, const __GLXapiExports *exports, __GLXvendorInfo *vendor) {
  if (exports->getDynDispatch != g_host->front)
    return false;
  __GLXapiImports imports = g_host->imports; // Mesa fills them only the first time
  return g_host->main(version, exports, vendor, &imports) &&
         imports.getProcAddress == g_host->imports.getProcAddress;
}

/// Loads a host and stores its functions in g_host.
/// \return false if there is none
bool loadHost(std::uint32_t version, const __GLXapiExports *exports, __GLXvendorInfo *vendor) try {
  if (g_host->imports.getProcAddress)
    return askHostAgain(version, exports, vendor);
  const std::vector<std::string> candidates = glxCandidates();
  for (const std::string &library : candidates) {
    const auto main =
        reinterpret_cast<__PFNGLXMAINPROC>(openHostLibrary(library, __GLX_MAIN_PROTO_NAME));
    if (!main)
      continue;
    __GLXapiImports imports = {};
    if (main(version, exports, vendor, &imports) && imports.getProcAddress) {
      logInfo("layer", "GLX: in front of %s", library.c_str());
      keepLibraryOf(reinterpret_cast<void *>(exports->getDynDispatch));
      g_host.fill([&](GlxHost &host) {
        host.imports = imports; // hostLookup uses it
        host.main = main;
        host.front = exports->getDynDispatch;
        loadHooks(std::begin(kHooks), std::end(kHooks), hostLookup);
        host.queryDrawable.function = hostLookup("glXQueryDrawable");
      });
      state::setWindowFrames({hostMissedFrames, swapHost});
      return true;
    }
  }
  sayNoneLoads("GLX", candidates);
  return false;
} catch (const std::exception &) { // out of memory
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
  *imports = g_host->imports;
  if (!layerAllowed())
    return True;
  imports->getProcAddress = registry::Guarded<getProcAddress>::call;
  imports->getDispatchAddress = registry::Guarded<getDispatchAddress>::call;
  // These would write the host's addresses into libglvnd's stubs, past the layer.
  imports->isPatchSupported = nullptr;
  imports->initiatePatch = nullptr;
  imports->releasePatch = nullptr;
  return True;
}
