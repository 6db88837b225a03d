/// The EGL side of the vendor library: libglvnd's vendor interface around the host's own vendor.
// This include must precede Xlib's macros, which EGL's header includes.
#include "state/objects/drawable.h"

#include <cstring>
#include <iterator>

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <glvnd/libeglabi.h>

#include "interposer/host_choice.h"
#include "interposer/process.h"
#include "interposer/provider.h"
#include "interposer/registry.h"
#include "interposer/x_keys.h"
#include "state/raster_draw/neighbours.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

using state::Provider;

/// The host's functions of EGL.
struct EglHost {
  __EGLapiImports imports;
  HostFunction<decltype(eglCreateContext)> createContext;
  HostFunction<decltype(eglDestroyContext)> destroyContext;
  HostFunction<decltype(eglMakeCurrent)> makeCurrent;
  HostFunction<decltype(eglSwapBuffers)> swapBuffers;
  HostFunction<EGLBoolean(EGLDisplay, EGLSurface, const EGLint *, EGLint)> swapDamageKhr,
      swapDamageExt;
  HostFunction<decltype(eglTerminate)> terminate;
  HostFunction<decltype(eglReleaseThread)> releaseThread;
  HostFunction<void *(const char *)> getProcAddress;
  HostFunction<decltype(eglQuerySurface)> querySurface;
  HostFunction<EGLBoolean(EGLDisplay, EGLSurface, EGLint, EGLint, EGLint, EGLint)> postSubBuffer;
  HostFunction<EGLBoolean(EGLDisplay, EGLSurface, EGLint, const EGLint *)> swapRegion;
  HostFunction<decltype(eglWaitClient)> waitClient, waitGl;
  HostFunction<decltype(eglCopyBuffers)> copyBuffers;
  HostFunction<decltype(eglBindTexImage)> bindTexImage, releaseTexImage;
  HostFunction<decltype(eglCreateImage)> createImage;
  HostFunction<EGLImageKHR(EGLDisplay, EGLContext, EGLenum, EGLClientBuffer, const EGLint *)>
      createImageKhr;
};
constinit Sealed<EglHost> g_host;
constinit Sealed<host::HostTable> g_table;

void *hostLookup(const char *name) { return checked(name, g_host->imports.getProcAddress(name)); }

const host::HostTable &table() {
  static const host::HostTable &s_table = loadTable(g_table, hostLookup, "EGL");
  return s_table;
}

registry::Key key(EGLDisplay display, EGLContext context) {
  return {Provider::Egl, display, context};
}

EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext share,
                         const EGLint *attributes) {
  offerHudKey();
  const EGLContext context = g_host->createContext(display, config, share, attributes);
  if (context == EGL_NO_CONTEXT || registry::created(key(display, context), table(), share))
    return context;
  g_host->destroyContext(display, context);
  return EGL_NO_CONTEXT;
}

EGLBoolean destroyContext(EGLDisplay display, EGLContext context) {
  registry::destroyed(key(display, context));
  return g_host->destroyContext(display, context);
}

EGLint queried(EGLDisplay display, EGLSurface surface, EGLint attribute, EGLint otherwise) {
  EGLint value = otherwise;
  return g_host->querySurface(display, surface, attribute, &value) ? value : otherwise;
}

bool sizeOf(const state::Drawable &drawable, int &width, int &height, bool) {
  auto *const display = const_cast<void *>(drawable.display);
  auto *const surface = const_cast<void *>(drawable.draw);
  width = queried(display, surface, EGL_WIDTH, 0);
  height = queried(display, surface, EGL_HEIGHT, 0);
  return width > 0 && height > 0;
}

state::Drawable drawableOf(EGLDisplay display, EGLSurface draw, EGLSurface read) {
  using state::Drawable;
  Drawable drawable;
  if (draw == EGL_NO_SURFACE || !g_host->querySurface.function)
    return drawable;
  // Only a pbuffer has this attribute; for other surfaces the value stays unchanged (EGL 1.5,
  // 3.5.6).
  const bool isPbuffer = queried(display, draw, EGL_LARGEST_PBUFFER, -1) != -1;
  drawable.kind = isPbuffer ? Drawable::Kind::Pbuffer : Drawable::Kind::Window;
  drawable.display = display;
  drawable.draw = draw;
  drawable.sameRead = draw == read;
  drawable.size = sizeOf;
  return drawable;
}

/// The drawable of the thread's current context.
constinit thread_local EGLSurface t_surface __attribute__((tls_model("initial-exec"))) =
    EGL_NO_SURFACE;

EGLBoolean makeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  state::leaveCurrent();
  const EGLBoolean ok = g_host->makeCurrent(display, draw, read, context);
  if (!ok)
    return ok;
  const state::Drawable drawable = drawableOf(display, draw, read);
  t_surface = draw;
  if (registry::madeCurrent(key(display, context), table(), &drawable))
    return ok;
  g_host->makeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  t_surface = EGL_NO_SURFACE;
  return EGL_FALSE;
}

void exchanges(state::Exchange what, const char *name) {
  if (registry::isCurrent(Provider::Egl))
    state::exchange(what, name);
}

void frameEnds(EGLSurface surface) {
  if (!registry::isCurrent(Provider::Egl))
    return;
  if (state::Context *const context = state::currentContext())
    state::frameEnd(context);
  state::exchange(surface == t_surface ? state::Exchange::Present : state::Exchange::Read,
                  "eglSwapBuffers");
}

EGLBoolean swapBuffers(EGLDisplay display, EGLSurface surface) {
  frameEnds(surface);
  return g_host->swapBuffers(display, surface);
}

EGLBoolean swapDamageKhr(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds(surface);
  return g_host->swapDamageKhr(display, surface, rects, count);
}

EGLBoolean swapDamageExt(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds(surface);
  return g_host->swapDamageExt(display, surface, rects, count);
}

/// Terminates a display. A display that tracks references (EGL_KHR_display_reference) survives this
/// together with its contexts, and still answers queries.
EGLBoolean terminate(EGLDisplay display) {
  const EGLBoolean ok = g_host->terminate(display);
  auto *const query =
      reinterpret_cast<const char *(*)(EGLDisplay, EGLint)>(hostLookup("eglQueryString"));
  if (!ok)
    return ok;
  if (!query || !query(display, EGL_VERSION)) {
    registry::displayClosed(Provider::Egl, display);
    // The failed query left its error, but the application's call succeeded.
    if (auto *const getError = reinterpret_cast<EGLint (*)()>(hostLookup("eglGetError")))
      getError();
  }
  return ok;
}

EGLBoolean releaseThread() {
  state::leaveCurrent();
  const EGLBoolean ok = g_host->releaseThread();
  return ok && registry::madeCurrent(key(nullptr, nullptr), table()) ? ok : EGL_FALSE;
}

EGLBoolean postSubBuffer(EGLDisplay display, EGLSurface surface, EGLint x, EGLint y, EGLint width,
                         EGLint height) {
  exchanges(state::Exchange::Read, "eglPostSubBufferNV");
  return g_host->postSubBuffer(display, surface, x, y, width, height);
}

EGLBoolean swapRegion(EGLDisplay display, EGLSurface surface, EGLint count, const EGLint *rects) {
  exchanges(state::Exchange::Read, "eglSwapBuffersRegionNOK");
  return g_host->swapRegion(display, surface, count, rects);
}

EGLBoolean waitClient() {
  exchanges(state::Exchange::Flush, "eglWaitClient");
  return g_host->waitClient();
}

EGLBoolean waitGl() {
  exchanges(state::Exchange::Flush, "eglWaitGL");
  return g_host->waitGl();
}

EGLBoolean copyBuffers(EGLDisplay display, EGLSurface surface, EGLNativePixmapType target) {
  exchanges(state::Exchange::Read, "eglCopyBuffers");
  return g_host->copyBuffers(display, surface, target);
}

EGLBoolean bindTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
  exchanges(state::Exchange::Change, "eglBindTexImage");
  return g_host->bindTexImage(display, surface, buffer);
}

EGLBoolean releaseTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
  exchanges(state::Exchange::Change, "eglReleaseTexImage");
  return g_host->releaseTexImage(display, surface, buffer);
}

EGLImage createImage(EGLDisplay display, EGLContext context, EGLenum target, EGLClientBuffer buffer,
                     const EGLAttrib *attributes) {
  exchanges(state::Exchange::Change, "eglCreateImage");
  state::imagesEscape();
  return g_host->createImage(display, context, target, buffer, attributes);
}

EGLImageKHR createImageKhr(EGLDisplay display, EGLContext context, EGLenum target,
                           EGLClientBuffer buffer, const EGLint *attributes) {
  exchanges(state::Exchange::Change, "eglCreateImageKHR");
  state::imagesEscape();
  return g_host->createImageKhr(display, context, target, buffer, attributes);
}

void *getProcAddress(const char *name);

// The initializers are only casts: with a call the table would be filled at run time, in writable
// memory.
const Hook kHooks[] = {
    {"eglCreateContext", reinterpret_cast<void *>(registry::Guarded<createContext>::call),
     &g_host->createContext.function},
    {"eglDestroyContext", reinterpret_cast<void *>(registry::Guarded<destroyContext>::call),
     &g_host->destroyContext.function},
    {"eglMakeCurrent", reinterpret_cast<void *>(registry::Guarded<makeCurrent>::call),
     &g_host->makeCurrent.function},
    {"eglSwapBuffers", reinterpret_cast<void *>(registry::Guarded<swapBuffers>::call),
     &g_host->swapBuffers.function},
    {"eglSwapBuffersWithDamageKHR",
     reinterpret_cast<void *>(registry::Guarded<swapDamageKhr>::call),
     &g_host->swapDamageKhr.function},
    {"eglSwapBuffersWithDamageEXT",
     reinterpret_cast<void *>(registry::Guarded<swapDamageExt>::call),
     &g_host->swapDamageExt.function},
    {"eglPostSubBufferNV", reinterpret_cast<void *>(registry::Guarded<postSubBuffer>::call),
     &g_host->postSubBuffer.function},
    {"eglSwapBuffersRegionNOK", reinterpret_cast<void *>(registry::Guarded<swapRegion>::call),
     &g_host->swapRegion.function},
    {"eglWaitClient", reinterpret_cast<void *>(registry::Guarded<waitClient>::call),
     &g_host->waitClient.function},
    {"eglWaitGL", reinterpret_cast<void *>(registry::Guarded<waitGl>::call),
     &g_host->waitGl.function},
    {"eglCopyBuffers", reinterpret_cast<void *>(registry::Guarded<copyBuffers>::call),
     &g_host->copyBuffers.function},
    {"eglBindTexImage", reinterpret_cast<void *>(registry::Guarded<bindTexImage>::call),
     &g_host->bindTexImage.function},
    {"eglReleaseTexImage", reinterpret_cast<void *>(registry::Guarded<releaseTexImage>::call),
     &g_host->releaseTexImage.function},
    {"eglCreateImage", reinterpret_cast<void *>(registry::Guarded<createImage>::call),
     &g_host->createImage.function},
    {"eglCreateImageKHR", reinterpret_cast<void *>(registry::Guarded<createImageKhr>::call),
     &g_host->createImageKhr.function},
    {"eglTerminate", reinterpret_cast<void *>(registry::Guarded<terminate>::call),
     &g_host->terminate.function},
    {"eglReleaseThread", reinterpret_cast<void *>(registry::Guarded<releaseThread>::call),
     &g_host->releaseThread.function},
    {"eglGetProcAddress", reinterpret_cast<void *>(registry::Guarded<getProcAddress>::call),
     &g_host->getProcAddress.function},
};

void *getProcAddress(const char *name) {
  if (!name)
    return nullptr;
  if (std::strncmp(name, "egl", 3) != 0)
    return resolveGl(name, hostLookup);
  const Hook *const hook = findHook(std::begin(kHooks), std::end(kHooks), name);
  if (!hook)
    return hostLookup(name);
  return *hook->host ? hook->function : nullptr;
}

/// Loads the host. Returns false for a second vendor of this name in the process, as the layer
/// fronts only one host.
bool loadHost(std::uint32_t version, const __EGLapiExports *exports, __EGLvendorInfo *vendor) try {
  if (g_host->imports.getProcAddress)
    return false;
  const std::vector<std::string> candidates = eglCandidates();
  for (const std::string &library : candidates) {
    void *const main = openHostLibrary(library, __EGL_MAIN_PROTO_NAME);
    if (!main)
      continue;
    __EGLapiImports imports = {};
    if (reinterpret_cast<__PFNEGLMAINPROC>(main)(version, exports, vendor, &imports) &&
        imports.getProcAddress) {
      logInfo("layer", "EGL: in front of %s", library.c_str());
      keepLibraryOf(reinterpret_cast<void *>(exports->getCurrentVendor));
      g_host.fill([&](EglHost &host) {
        host.imports = imports; // hostLookup uses it
        loadHooks(std::begin(kHooks), std::end(kHooks), hostLookup);
        host.querySurface.function = hostLookup("eglQuerySurface");
      });
      return true;
    }
  }
  sayNoneLoads("EGL", candidates);
  return false;
} catch (const std::exception &) { // out of memory
  return false;
}

} // namespace

} // namespace arbiter::interposer

extern "C" __attribute__((visibility("default"))) EGLBoolean
__egl_Main(std::uint32_t version, const __EGLapiExports *exports, __EGLvendorInfo *vendor,
           __EGLapiImports *imports) {
  using namespace arbiter::interposer;
  if (!loadHost(version, exports, vendor))
    return EGL_FALSE;
  *imports = g_host->imports;
  if (!layerAllowed())
    return EGL_TRUE;
  imports->getProcAddress = registry::Guarded<getProcAddress>::call;
  // These would write the host's addresses into libglvnd's stubs, bypassing its dispatch table and
  // the layer.
  imports->isPatchSupported = nullptr;
  imports->initiatePatch = nullptr;
  imports->releasePatch = nullptr;
  return EGL_TRUE;
}
