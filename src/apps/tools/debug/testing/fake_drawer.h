#pragma once
#include <functional>
#include <string>

#include "apps/tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// A drawer without GL: the interpreter draws a quad over the whole picture.
class FakeDrawer : public Drawer {
public:
  FakeDrawer(std::string text, int width, int height)
      : m_text(std::move(text)), m_width(width), m_height(height) {}

  [[nodiscard]] std::string name() const override { return "fake"; }
  [[nodiscard]] std::array<int, 2> size() const override { return {m_width, m_height}; }
  [[nodiscard]] Result<std::vector<Vec4>, DebugError>
  draw(const std::string &text, std::size_t targets, const Region &region,
       const std::vector<Vec4> &locals = {}) override;
  [[nodiscard]] Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
  picture(const Region &region) override;
  [[nodiscard]] Result<std::array<int, 3>, DebugError> textureSize(unsigned,
                                                                   fp::ir::TexTarget) override {
    return std::array<int, 3>{64, 32, 1};
  }

  /// Returns (item, index, row, 0.5).
  [[nodiscard]] Result<Vec4, DebugError> vertexState(const fp::ir::StateRef &state) override {
    return Vec4{float(state.item), float(state.index), float(state.row), 0.5f};
  }

  /// Replaces the parameters' values, by default (N, 0.5, -1, 2) for program.local[N] and all
  /// others.
  std::function<Vec4(const fp::ir::Parameter &)> parameter;
  /// Changes results, to act as a faulty host.
  std::function<void(const fp::ir::Instruction &, Vec4 &)> wrong;
  std::function<bool(int x, int y)> covers;
  float limit = 2; ///< a depth test discards fragments that are not nearer
  int drawn = 0;   ///< number of draws so far

private:
  std::string m_text;
  int m_width, m_height;
};

/// Returns an attribute of the quad; texture coordinates and colors are (s, t, 0, 1).
[[nodiscard]] fp::ir::Vec4 attributeAt(const fp::ir::Attribute &attribute, int x, int y, int width,
                                       int height);
/// Samples a texture, which is a smooth function of the coordinates.
[[nodiscard]] fp::ir::Vec4 texelAt(const fp::ir::Sample &sample);
/// Compiles a program, which must be valid.
[[nodiscard]] fp::ir::Program checked(const std::string &text);

} // namespace arbiter::tools::debug
