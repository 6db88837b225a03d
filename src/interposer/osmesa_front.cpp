/// OSMesa's context calls. libOSMesa is not a libglvnd vendor, so that clients reach these
/// functions by symbol lookup. Linked clients do so through LD_PRELOAD. Clients that dlopen
/// libOSMesa.so.8 use the front library, which has no symbols of its own and depends on this
/// library and the real one.
#include <cstring>
#include <iterator>
#include <string>

#include <dlfcn.h>

#include <GL/osmesa.h>

#include "interposer/process.h"
#include "interposer/provider.h"
#include "interposer/registry.h"
#include "state/objects/drawable.h"
#include "util/flags.h"
#include "util/log.h"

#define ARBITER_EXPORT extern "C" __attribute__((visibility("default")))

namespace arbiter::interposer {

namespace {

using state::Provider;

struct RealOsMesa {
  void *library = nullptr;
  decltype(&OSMesaCreateContext) createContext = nullptr;
  decltype(&OSMesaCreateContextExt) createContextExt = nullptr;
  decltype(&OSMesaCreateContextAttribs) createContextAttribs = nullptr;
  decltype(&OSMesaDestroyContext) destroyContext = nullptr;
  decltype(&OSMesaMakeCurrent) makeCurrent = nullptr;
  decltype(&OSMesaGetProcAddress) getProcAddress = nullptr;
  decltype(&OSMesaGetIntegerv) getInteger = nullptr;
};

bool isThisLibrary(const void *function) {
  Dl_info found, own;
  return !dladdr(function, &found) ||
         !dladdr(reinterpret_cast<const void *>(&isThisLibrary), &own) ||
         found.dli_fbase == own.dli_fbase;
}

/// Returns the library that defines the next OSMesaMakeCurrent after this one, which is the one
/// that the client is linked with.
void *libraryAfterUs() {
  void *const next = dlsym(RTLD_NEXT, "OSMesaMakeCurrent");
  Dl_info info;
  if (!next || isThisLibrary(next) || !dladdr(next, &info)) {
    (void)dlerror();
    return nullptr;
  }
  return dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
}

void *openLibrary(const char *path) {
  void *const handle = path && *path ? dlopen(path, RTLD_LAZY | RTLD_LOCAL) : nullptr;
  void *const probe = handle ? dlsym(handle, "OSMesaMakeCurrent") : nullptr;
  if (probe && !isThisLibrary(probe))
    return handle;
  (void)dlerror();
  if (handle)
    dlclose(handle);
  return nullptr;
}

constinit Sealed<RealOsMesa> g_real;
constinit Sealed<host::HostTable> g_table;

const RealOsMesa &real() {
  static const RealOsMesa &s_real = g_real.fill([](RealOsMesa &r) {
    r.library = libraryAfterUs();
    // The front library was built for this file. It is an absolute path, as the bare name may be
    // this library's.
    if (!r.library && !settings().hostOsmesa.empty())
      r.library = openLibrary(settings().hostOsmesa.c_str());
    if (!r.library)
      r.library = openLibrary(ARBITER_OSMESA_LIBRARY);
    if (!r.library) {
      logError("layer", "OSMesa: no real libOSMesa found (ARBITER_HOST_OSMESA names one)");
      return;
    }
    const auto get = [&](auto &function, const char *name) {
      function =
          reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(r.library, name));
    };
    get(r.createContext, "OSMesaCreateContext");
    get(r.createContextExt, "OSMesaCreateContextExt");
    get(r.createContextAttribs, "OSMesaCreateContextAttribs");
    get(r.destroyContext, "OSMesaDestroyContext");
    get(r.makeCurrent, "OSMesaMakeCurrent");
    get(r.getProcAddress, "OSMesaGetProcAddress");
    get(r.getInteger, "OSMesaGetIntegerv");
  });
  return s_real;
}

void *hostLookup(const char *name) {
  if (!real().getProcAddress)
    return nullptr;
  return checked(name, reinterpret_cast<void *>(real().getProcAddress(name)));
}

const host::HostTable &table() {
  static const host::HostTable &s_table = loadTable(g_table, hostLookup, "OSMesa");
  return s_table;
}

registry::Key key(OSMesaContext context) { return {Provider::OsMesa, nullptr, context}; }

/// Reads the memory layout while the context is current, as OSMesaPixelStore may be called at any
/// time.
void layoutOf(const state::Drawable &drawable, int &rowLength, bool &topRowFirst) {
  GLint length = 0, upwards = 1;
  real().getInteger(OSMESA_ROW_LENGTH, &length);
  real().getInteger(OSMESA_Y_UP, &upwards);
  rowLength = length > 0 ? length : drawable.width;
  topRowFirst = upwards == 0;
}

/// Describes the application's memory at the time when the context becomes current.
state::Drawable memoryOf(void *buffer, GLenum type, int width, int height) {
  state::Drawable drawable;
  if (!buffer || !real().getInteger)
    return drawable;
  GLint format = 0;
  real().getInteger(OSMESA_FORMAT, &format);
  drawable.kind = state::Drawable::Kind::Memory;
  drawable.width = width;
  drawable.height = height;
  drawable.memory = buffer;
  drawable.memoryFormat = GLenum(format);
  drawable.memoryType = type;
  drawable.memoryLayout = layoutOf;
  return drawable;
}

/// True while the thread is inside a create call. The real library's simpler create functions call
/// the fuller ones by their exported names, which are this library's functions.
constinit thread_local bool t_creating __attribute__((tls_model("initial-exec"))) = false;

template <typename Create> OSMesaContext remembered(OSMesaContext share, Create create) {
  if (t_creating || !layerAllowed())
    return create();
  t_creating = true;
  const OSMesaContext context = create();
  t_creating = false;
  if (!context || registry::created(key(context), table(), share))
    return context;
  real().destroyContext(context);
  return nullptr;
}

} // namespace

} // namespace arbiter::interposer

using namespace arbiter::interposer;

ARBITER_EXPORT OSMesaContext OSMesaCreateContext(GLenum format, OSMesaContext share) {
  if (!real().createContext)
    return nullptr;
  return remembered(share, [&] { return real().createContext(format, share); });
}

ARBITER_EXPORT OSMesaContext OSMesaCreateContextExt(GLenum format, GLint depthBits,
                                                    GLint stencilBits, GLint accumBits,
                                                    OSMesaContext share) {
  if (!real().createContextExt)
    return nullptr;
  return remembered(share, [&] {
    return real().createContextExt(format, depthBits, stencilBits, accumBits, share);
  });
}

ARBITER_EXPORT OSMesaContext OSMesaCreateContextAttribs(const int *attributes,
                                                        OSMesaContext share) {
  if (!real().createContextAttribs)
    return nullptr;
  return remembered(share, [&] { return real().createContextAttribs(attributes, share); });
}

ARBITER_EXPORT void OSMesaDestroyContext(OSMesaContext context) {
  if (!real().destroyContext)
    return;
  // OSMesa unbinds a current context that it destroys.
  auto *const current =
      reinterpret_cast<OSMesaContext (*)()>(dlsym(real().library, "OSMesaGetCurrentContext"));
  const bool unbinds = context && current && current() == context;
  if (unbinds)
    arbiter::state::leaveCurrent();
  registry::destroyed(key(context));
  real().destroyContext(context);
  if (unbinds)
    (void)registry::madeCurrent(key(nullptr), table());
}

ARBITER_EXPORT GLboolean OSMesaMakeCurrent(OSMesaContext context, void *buffer, GLenum type,
                                           GLsizei width, GLsizei height) {
  if (!real().makeCurrent)
    return GL_FALSE;
  if (!layerAllowed())
    return real().makeCurrent(context, buffer, type, width, height);
  arbiter::state::leaveCurrent();
  const GLboolean ok = real().makeCurrent(context, buffer, type, width, height);
  if (!ok)
    return ok;
  const arbiter::state::Drawable drawable = memoryOf(buffer, type, width, height);
  if (registry::madeCurrent(key(context), table(), &drawable))
    return ok;
  real().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
  return GL_FALSE;
}

ARBITER_EXPORT OSMESAproc OSMesaGetProcAddress(const char *name) {
  if (!name || !real().getProcAddress)
    return nullptr;
  const struct {
    const char *name;
    void *function;
  } hooks[] = {
      {"OSMesaCreateContext", reinterpret_cast<void *>(OSMesaCreateContext)},
      {"OSMesaCreateContextExt", reinterpret_cast<void *>(OSMesaCreateContextExt)},
      {"OSMesaCreateContextAttribs", reinterpret_cast<void *>(OSMesaCreateContextAttribs)},
      {"OSMesaDestroyContext", reinterpret_cast<void *>(OSMesaDestroyContext)},
      {"OSMesaMakeCurrent", reinterpret_cast<void *>(OSMesaMakeCurrent)},
      {"OSMesaGetProcAddress", reinterpret_cast<void *>(OSMesaGetProcAddress)},
  };
  for (const auto &hook : hooks)
    if (std::strcmp(hook.name, name) == 0)
      return reinterpret_cast<OSMESAproc>(hook.function);
  return reinterpret_cast<OSMESAproc>(resolveGl(name, hostLookup));
}
