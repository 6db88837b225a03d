/// Is linked only with libOSMesa.
#include <vector>

#define GL_GLEXT_PROTOTYPES
#include "body.h"

#include <GL/osmesa.h>

using namespace clients;

int main() {
  std::vector<unsigned char> buffer(64 * 64 * 4);
  const OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 24, 0, 0, nullptr);
  if (!context || !OSMesaMakeCurrent(context, buffer.data(), GL_UNSIGNED_BYTE, 64, 64))
    die("no OSMesa context");
  Gl gl;
#define X(name, result, parameters) gl.name = ::gl##name;
  CLIENT_GL_FUNCTIONS(X)
#undef X
  loadArb(gl,
          [](const char *name) { return reinterpret_cast<void *>(OSMesaGetProcAddress(name)); });
  const bool right = drawAndReport(gl, "osmesa_direct");
  if (OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0) != GL_TRUE)
    die("OSMesaMakeCurrent(NULL) failed");
  OSMesaDestroyContext(context);
  return right ? 0 : 1;
}
