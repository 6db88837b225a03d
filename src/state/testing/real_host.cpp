#include "state/testing/real_host.h"

#include <GL/osmesa.h>

#include "state/context/context.h"
#include "state/lifecycle/lifecycle.h"

namespace arbiter::state::testing {

namespace {

const host::HostTable &table() {
  static const host::HostTable s_table = [] {
    host::HostTable made;
    host::loadHostTable(made, [](const char *name) {
      return reinterpret_cast<void *>(OSMesaGetProcAddress(name));
    });
    return made;
  }();
  return s_table;
}

} // namespace

void *address(const char *name) { return reinterpret_cast<void *>(OSMesaGetProcAddress(name)); }

RealHost::RealHost(int width, int height) : m_pixels(std::size_t(width) * std::size_t(height) * 4) {
  const int attributes[] = {
      OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_STENCIL_BITS, 8, 0};
  m_osmesa = OSMesaCreateContextAttribs(attributes, nullptr);
  if (!m_osmesa ||
      !OSMesaMakeCurrent(OSMesaContext(m_osmesa), m_pixels.data(), GL_UNSIGNED_BYTE, width, height))
    return;
  m_context = createContext(Provider::OsMesa, &table(), nullptr);
  makeCurrent(m_context);
}

RealHost::~RealHost() {
  if (m_context) {
    destroyContext(m_context);
    makeCurrent(nullptr);
  }
  if (m_osmesa) {
    OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0);
    OSMesaDestroyContext(OSMesaContext(m_osmesa));
  }
}

RasterContext &RealHost::context() const { return *m_context; }

} // namespace arbiter::state::testing
