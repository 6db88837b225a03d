#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include "host/host_table.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/raster_context.h"
#include "state/residency/residency.h"
#include "swrast/rect.h"

/// The fixture of residency's tests: an OSMesa context on the real host. Fills of the images from
/// acquireTargets() stand in for draws of the rasterizer.
namespace arbiter::state {
class Context;
}

namespace arbiter::state::residency_scene {

inline constexpr int kWidth = 64, kHeight = 48; ///< of the context's drawable, in pixels

using Bytes = std::vector<std::uint8_t>;

/// Returns a function of OSMesa's GL that the host's table does not have.
[[nodiscard]] void *hostFunction(const char *name);

class Residency : public ::testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;

  RasterContext &context();
  state::Residency &residency() { return context().software->residency; }
  const host::HostTable &gl() { return *context().host; }
  /// Marks state as changed by the application.
  void changed(std::uint32_t bits = dirty::kAll) { context().dirty |= bits; }

  GLuint texture(GLenum internalFormat, int width, int height, const void *rgba = nullptr);
  GLuint framebufferOf(GLuint name);
  /// Calls the host from another context of its share group.
  void inNeighbour(const std::function<void()> &calls);
  void bindFramebuffer(GLuint name);

  /// Fills `rect`, in place of a draw of the rasterizer.
  void draw(const swrast::Rect &rect, std::uint32_t rgba);
  void drawAll(std::uint32_t rgba) { draw({0, 0, kWidth, kHeight}, rgba); }

  /// Returns the host's pixel after a synchronisation.
  std::uint32_t hostPixel(int x, int y);
  /// Returns the host's pixel as it is now.
  std::uint32_t directPixel(int x, int y);
  std::uint32_t shadowPixel(int x, int y);
  std::uint32_t hostTexel(int x, int y, int width, int height);
  static std::uint32_t packed(const std::uint8_t *b) {
    return std::uint32_t(b[0]) << 24 | std::uint32_t(b[1]) << 16 | std::uint32_t(b[2]) << 8 | b[3];
  }
  /// Returns the texture that is bound to GL_TEXTURE_2D.
  GLuint boundTexture();
  bool copy(int destX, int destY, int x, int y, int width, int height);
  /// Returns a texel as a program samples it.
  std::uint32_t sampled(GLuint name, int x, int y);
  ResidencyStatistics statistics() { return residency().statistics(); }

  OSMesaContext m_osmesa = nullptr;
  Context *m_context = nullptr;
  Bytes m_memory;
};

} // namespace arbiter::state::residency_scene
