#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <gtest/gtest.h>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/mirror/dirty_bits.h"
#include "state/raster_draw/context_state.h"
#include "state/residency/residency.h"
#include "swrast/rect.h"

/// What residency's tests have in common: a context of OSMesa, the host that there is, and draws of
/// the rasterizer, which are stood in for by fills of what acquireTargets() gives.
namespace arbiter::state::software::residency_scene {

inline constexpr int kWidth = 64, kHeight = 48; ///< of what the context draws to, in pixels

using Bytes = std::vector<std::uint8_t>;

/// A function of OSMesa's GL that is none of the host's table.
[[nodiscard]] void *hostFunction(const char *name);

class Residency : public ::testing::Test {
protected:
  void SetUp() override;
  void TearDown() override;

  Context &context() { return *m_context; }
  software::Residency &residency() { return m_context->software->residency; }
  const host::HostTable &gl() { return *m_context->host; }
  /// The application changed state.
  void changed(std::uint32_t bits = dirty::kAll) { m_context->dirty |= bits; }

  GLuint texture(GLenum internalFormat, int width, int height, const void *rgba = nullptr);
  GLuint framebufferOf(GLuint name);
  /// Calls the host from another context of its share group.
  void inNeighbour(const std::function<void()> &calls);
  void bindFramebuffer(GLuint name);

  /// A draw of the rasterizer's over `rect`.
  void draw(const swrast::Rect &rect, std::uint32_t rgba);
  void drawAll(std::uint32_t rgba) { draw({0, 0, kWidth, kHeight}, rgba); }

  /// What the host has, after it was brought up to date.
  std::uint32_t hostPixel(int x, int y);
  /// What the host has now.
  std::uint32_t directPixel(int x, int y);
  std::uint32_t shadowPixel(int x, int y);
  std::uint32_t hostTexel(int x, int y, int width, int height);
  static std::uint32_t packed(const std::uint8_t *b) {
    return std::uint32_t(b[0]) << 24 | std::uint32_t(b[1]) << 16 | std::uint32_t(b[2]) << 8 | b[3];
  }
  /// What is bound to GL_TEXTURE_2D.
  GLuint boundTexture();
  bool copy(int destX, int destY, int x, int y, int width, int height);
  /// A texel as a program samples it.
  std::uint32_t sampled(GLuint name, int x, int y);
  ResidencyStatistics statistics() { return residency().statistics(); }

  OSMesaContext m_osmesa = nullptr;
  Context *m_context = nullptr;
  Bytes m_memory;
};

} // namespace arbiter::state::software::residency_scene
