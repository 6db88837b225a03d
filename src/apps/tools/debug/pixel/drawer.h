#pragma once
#include <array>
#include <string>
#include <vector>

#include "apps/tools/debug/trace/condition.h"

namespace arbiter::tools::debug {

/// A rectangle of window pixels, y up.
struct Region {
  int x = 0, y = 0, width = 1, height = 1;
};

/// Draws a document's frame with another fragment program in place of its own. Each implementation
/// has a drawer: the rasterizer, the host with the layer, the bare host.
class Drawer {
public:
  using Vec4 = fp::ir::Vec4;

  virtual ~Drawer() = default;
  /// Returns "swrast", "host" or "bare host".
  [[nodiscard]] virtual std::string name() const = 0;
  /// Returns the picture's size in pixels.
  [[nodiscard]] virtual std::array<int, 2> size() const = 0;
  /// Draws to floats without blending, with the document's depth test.
  /// \param text a fragment program that writes `targets` colors
  /// \param locals finite values that replace the document's first local parameters
  /// \returns targets * height * width values, the lowest row first; uncovered() where the document
  /// draws nothing
  [[nodiscard]] virtual Result<std::vector<Vec4>, DebugError>
  draw(const std::string &text, std::size_t targets, const Region &region,
       const std::vector<Vec4> &locals = {}) = 0;
  /// Returns pixels of the document's own picture as 8-bit RGBA.
  [[nodiscard]] virtual Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
  picture(const Region &region) = 0;
  /// Returns width, height and depth of the first level of the texture that a program would sample;
  /// zeros if there is none.
  [[nodiscard]] virtual Result<std::array<int, 3>, DebugError>
  textureSize(unsigned unit, fp::ir::TexTarget target) = 0;
  /// Returns a row of GL's state that only vertex programs can read: state.texgen, state.clip,
  /// state.point.
  [[nodiscard]] virtual Result<Vec4, DebugError> vertexState(const fp::ir::StateRef &state) = 0;
};

/// Returns the clear value of float targets, which no program writes.
[[nodiscard]] constexpr fp::ir::Vec4 uncovered() {
  return {-0x1.6a09e6p99f, 0x1.bb67aep98f, -0x1.3c6ef4p97f, 0x1.a54ff6p96f};
}

} // namespace arbiter::tools::debug
