/// The EGL side of the vendor library: libglvnd's vendor interface around the host's own vendor.
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

EGLBoolean makeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
  const EGLBoolean ok = g_makeCurrent(display, draw, read, context);
  if (ok)
    registry::madeCurrent(key(display, context), table());
  return ok;
}

void frameEnds() {
  if (registry::isCurrent(Provider::Egl))
    if (state::Context *const context = state::currentContext())
      state::frameEnd(context);
}

EGLBoolean swapBuffers(EGLDisplay display, EGLSurface surface) {
  frameEnds();
  return g_swapBuffers(display, surface);
}

EGLBoolean swapDamageKhr(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds();
  return g_swapDamageKhr(display, surface, rects, count);
}

EGLBoolean swapDamageExt(EGLDisplay display, EGLSurface surface, const EGLint *rects,
                         EGLint count) {
  frameEnds();
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
  const EGLBoolean ok = g_releaseThread();
  if (ok)
    registry::madeCurrent(key(nullptr, nullptr), table());
  return ok;
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
