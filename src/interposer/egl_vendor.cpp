/// The EGL side of the vendor library: libglvnd's vendor interface around the host's own vendor.
// Before Xlib's macros, which EGL's header includes.
#include "state/software/residency.h"

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
#include "util/log.h"

namespace arbiter::interposer {

namespace {

using state::Provider;

__EGLapiImports g_host;

void *hostLookup(const char *name) { return checked(name, g_host.getProcAddress(name)); }

const host::HostTable &table() {
  static const host::HostTable *const s_table = [] {
    auto *made = new host::HostTable;
    const std::size_t found = host::loadHostTable(*made, hostLookup);
    logDebug("layer", "EGL: the host has %zu of the functions asked for", found);
    return made;
  }();
  return *s_table;
}

template <typename Function> struct Host {
  void *function = nullptr;
  template <typename... Arguments> auto operator()(Arguments... arguments) const {
    return reinterpret_cast<Function *>(function)(arguments...);
  }
};

Host<decltype(eglCreateContext)> g_createContext;
Host<decltype(eglDestroyContext)> g_destroyContext;
Host<decltype(eglMakeCurrent)> g_makeCurrent;
Host<decltype(eglSwapBuffers)> g_swapBuffers;
Host<EGLBoolean(EGLDisplay, EGLSurface, const EGLint *, EGLint)> g_swapDamageKhr, g_swapDamageExt;
Host<decltype(eglTerminate)> g_terminate;
Host<decltype(eglReleaseThread)> g_releaseThread;
Host<void *(const char *)> g_getProcAddress;

registry::Key key(EGLDisplay display, EGLContext context) {
  return {Provider::Egl, display, context};
}

EGLContext createContext(EGLDisplay display, EGLConfig config, EGLContext share,
                         const EGLint *attributes) {
  const EGLContext context = g_createContext(display, config, share, attributes);
  if (context != EGL_NO_CONTEXT)
    registry::created(key(display, context), table(), share);
  return context;
}

EGLBoolean destroyContext(EGLDisplay display, EGLContext context) {
  registry::destroyed(key(display, context));
  return g_destroyContext(display, context);
}

Host<decltype(eglQuerySurface)> g_querySurface;

EGLint queried(EGLDisplay display, EGLSurface surface, EGLint attribute, EGLint otherwise) {
  EGLint value = otherwise;
  return g_querySurface(display, surface, attribute, &value) ? value : otherwise;
}

bool sizeOf(const state::software::Drawable &drawable, int &width, int &height, bool) {
  auto *const display = const_cast<void *>(drawable.display);
  auto *const surface = const_cast<void *>(drawable.draw);
  width = queried(display, surface, EGL_WIDTH, 0);
  height = queried(display, surface, EGL_HEIGHT, 0);
  return width > 0 && height > 0;
}

state::software::Drawable drawableOf(EGLDisplay display, EGLSurface draw, EGLSurface read) {
  using state::software::Drawable;
  Drawable drawable;
  if (draw == EGL_NO_SURFACE || !g_querySurface.function)
    return drawable;
  // Only a pbuffer has an answer to this; for others the value stays as it was (EGL 1.5, 3.5.6).
  const bool isPbuffer = queried(display, draw, EGL_LARGEST_PBUFFER, -1) != -1;
  drawable.kind = isPbuffer ? Drawable::Kind::Pbuffer : Drawable::Kind::Window;
  drawable.display = display;
  drawable.draw = draw;
  drawable.sameRead = draw == read;
  drawable.size = sizeOf;
  return drawable;
}

/// What the context that is current on the thread draws to.
constinit thread_local EGLSurface t_surface __attribute__((tls_model("initial-exec"))) =
    EGL_NO_SURFACE;

EGLBoolean makeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  state::leaveCurrent();
  const EGLBoolean ok = g_makeCurrent(display, draw, read, context);
  if (!ok)
    return ok;
  const state::software::Drawable drawable = drawableOf(display, draw, read);
  t_surface = draw;
  registry::madeCurrent(key(display, context), table(), &drawable);
  return ok;
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
  return g_swapBuffers(display, surface);
}

EGLBoolean swapDamageKhr(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds(surface);
  return g_swapDamageKhr(display, surface, rects, count);
}

EGLBoolean swapDamageExt(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds(surface);
  return g_swapDamageExt(display, surface, rects, count);
}

/// A display that tracks references (EGL_KHR_display_reference) lives on after this, and so do its
/// contexts: it then still answers queries.
EGLBoolean terminate(EGLDisplay display) {
  const EGLBoolean ok = g_terminate(display);
  auto *const query =
      reinterpret_cast<const char *(*)(EGLDisplay, EGLint)>(hostLookup("eglQueryString"));
  if (!ok)
    return ok;
  if (!query || !query(display, EGL_VERSION)) {
    registry::displayClosed(Provider::Egl, display);
    // The failed query left its error; the call that the application made succeeded.
    if (auto *const getError = reinterpret_cast<EGLint (*)()>(hostLookup("eglGetError")))
      getError();
  }
  return ok;
}

EGLBoolean releaseThread() {
  state::leaveCurrent();
  const EGLBoolean ok = g_releaseThread();
  if (ok)
    registry::madeCurrent(key(nullptr, nullptr), table());
  return ok;
}

Host<EGLBoolean(EGLDisplay, EGLSurface, EGLint, EGLint, EGLint, EGLint)> g_postSubBuffer;
Host<EGLBoolean(EGLDisplay, EGLSurface, EGLint, const EGLint *)> g_swapRegion;
Host<decltype(eglWaitClient)> g_waitClient, g_waitGl;
Host<decltype(eglCopyBuffers)> g_copyBuffers;
Host<decltype(eglBindTexImage)> g_bindTexImage, g_releaseTexImage;
Host<decltype(eglCreateImage)> g_createImage;
Host<EGLImageKHR(EGLDisplay, EGLContext, EGLenum, EGLClientBuffer, const EGLint *)>
    g_createImageKhr;

EGLBoolean postSubBuffer(EGLDisplay display, EGLSurface surface, EGLint x, EGLint y, EGLint width,
                         EGLint height) {
  exchanges(state::Exchange::Read, "eglPostSubBufferNV");
  return g_postSubBuffer(display, surface, x, y, width, height);
}

EGLBoolean swapRegion(EGLDisplay display, EGLSurface surface, EGLint count, const EGLint *rects) {
  exchanges(state::Exchange::Read, "eglSwapBuffersRegionNOK");
  return g_swapRegion(display, surface, count, rects);
}

EGLBoolean waitClient() {
  exchanges(state::Exchange::Flush, "eglWaitClient");
  return g_waitClient();
}

EGLBoolean waitGl() {
  exchanges(state::Exchange::Flush, "eglWaitGL");
  return g_waitGl();
}

EGLBoolean copyBuffers(EGLDisplay display, EGLSurface surface, EGLNativePixmapType target) {
  exchanges(state::Exchange::Read, "eglCopyBuffers");
  return g_copyBuffers(display, surface, target);
}

EGLBoolean bindTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
  exchanges(state::Exchange::Change, "eglBindTexImage");
  return g_bindTexImage(display, surface, buffer);
}

EGLBoolean releaseTexImage(EGLDisplay display, EGLSurface surface, EGLint buffer) {
  exchanges(state::Exchange::Change, "eglReleaseTexImage");
  return g_releaseTexImage(display, surface, buffer);
}

EGLImage createImage(EGLDisplay display, EGLContext context, EGLenum target, EGLClientBuffer buffer,
                     const EGLAttrib *attributes) {
  exchanges(state::Exchange::Change, "eglCreateImage");
  return g_createImage(display, context, target, buffer, attributes);
}

EGLImageKHR createImageKhr(EGLDisplay display, EGLContext context, EGLenum target,
                           EGLClientBuffer buffer, const EGLint *attributes) {
  exchanges(state::Exchange::Change, "eglCreateImageKHR");
  return g_createImageKhr(display, context, target, buffer, attributes);
}

void *getProcAddress(const char *name);

template <typename Function> void *address(Function *function) {
  return reinterpret_cast<void *>(function);
}

const Hook kHooks[] = {
    {"eglCreateContext", address(createContext), &g_createContext.function},
    {"eglDestroyContext", address(destroyContext), &g_destroyContext.function},
    {"eglMakeCurrent", address(makeCurrent), &g_makeCurrent.function},
    {"eglSwapBuffers", address(swapBuffers), &g_swapBuffers.function},
    {"eglSwapBuffersWithDamageKHR", address(swapDamageKhr), &g_swapDamageKhr.function},
    {"eglSwapBuffersWithDamageEXT", address(swapDamageExt), &g_swapDamageExt.function},
    {"eglPostSubBufferNV", address(postSubBuffer), &g_postSubBuffer.function},
    {"eglSwapBuffersRegionNOK", address(swapRegion), &g_swapRegion.function},
    {"eglWaitClient", address(waitClient), &g_waitClient.function},
    {"eglWaitGL", address(waitGl), &g_waitGl.function},
    {"eglCopyBuffers", address(copyBuffers), &g_copyBuffers.function},
    {"eglBindTexImage", address(bindTexImage), &g_bindTexImage.function},
    {"eglReleaseTexImage", address(releaseTexImage), &g_releaseTexImage.function},
    {"eglCreateImage", address(createImage), &g_createImage.function},
    {"eglCreateImageKHR", address(createImageKhr), &g_createImageKhr.function},
    {"eglTerminate", address(terminate), &g_terminate.function},
    {"eglReleaseThread", address(releaseThread), &g_releaseThread.function},
    {"eglGetProcAddress", address(getProcAddress), &g_getProcAddress.function},
};

void *getProcAddress(const char *name) {
  if (!name)
    return nullptr;
  if (std::strncmp(name, "egl", 3) != 0)
    return resolveGl(name, hostLookup);
  const Hook *const hook = findHook(std::begin(kHooks), std::end(kHooks), name);
  if (!hook)
    return hostLookup(name);
  return *hook->host ? hook->ours : nullptr;
}

/// False for a second vendor of this name in the process: there is one host to stand in front of.
bool loadHost(std::uint32_t version, const __EGLapiExports *exports, __EGLvendorInfo *vendor) {
  if (g_host.getProcAddress)
    return false;
  for (const std::string &library : eglCandidates()) {
    void *const main = openHostLibrary(library, __EGL_MAIN_PROTO_NAME);
    if (!main)
      continue;
    g_host = {};
    if (reinterpret_cast<__PFNEGLMAINPROC>(main)(version, exports, vendor, &g_host) &&
        g_host.getProcAddress) {
      logInfo("layer", "EGL: in front of %s", library.c_str());
      loadHooks(std::begin(kHooks), std::end(kHooks), hostLookup);
      g_querySurface.function = hostLookup("eglQuerySurface");
      return true;
    }
  }
  logError("layer", "EGL: no host vendor loads");
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
  *imports = g_host;
  if (!layerAllowed())
    return EGL_TRUE;
  imports->getProcAddress = getProcAddress;
  // They would write the host's addresses into libglvnd's stubs, past its dispatch table and us.
  imports->isPatchSupported = nullptr;
  imports->initiatePatch = nullptr;
  imports->releasePatch = nullptr;
  return EGL_TRUE;
}
