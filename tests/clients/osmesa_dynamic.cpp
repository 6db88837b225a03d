/// Loads OSMesa by dlopen. argv[1]: "dlsym" finds GL by dlsym, "gpa" by OSMesaGetProcAddress.
#include <cstring>
#include <vector>

#include <dlfcn.h>

#include "body.h"

#include <GL/osmesa.h>

using namespace clients;

namespace {

void *g_library = nullptr;
decltype(&::OSMesaGetProcAddress) g_getProc = nullptr;

void *bySymbol(const char *name) { return dlsym(g_library, name); }
void *byProc(const char *name) { return reinterpret_cast<void *>(g_getProc(name)); }

template <typename Function> void get(Function &function, const char *name) {
  function = reinterpret_cast<Function>(dlsym(g_library, name));
  if (!function)
    die("no function", name);
}

} // namespace

int main(int argc, char **argv) {
  g_library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (!g_library)
    die("dlopen:", dlerror());
  decltype(&::OSMesaCreateContext) create;
  decltype(&::OSMesaMakeCurrent) makeCurrent;
  decltype(&::OSMesaDestroyContext) destroy;
  get(create, "OSMesaCreateContext");
  get(makeCurrent, "OSMesaMakeCurrent");
  get(destroy, "OSMesaDestroyContext");
  get(g_getProc, "OSMesaGetProcAddress");
  std::vector<unsigned char> buffer(64 * 64 * 4);
  const OSMesaContext context = create(OSMESA_RGBA, nullptr);
  if (!context || !makeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 64, 64))
    die("no OSMesa context");
  const bool symbols = argc > 1 && !std::strcmp(argv[1], "dlsym");
  const bool right = drawAndReport(load(symbols ? bySymbol : byProc), argc > 1 ? argv[1] : "gpa");
  destroy(context);
  return right ? 0 : 1;
}
