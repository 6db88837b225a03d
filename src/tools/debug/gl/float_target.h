#pragma once
#include <epoxy/gl.h>
#include <string>
#include <vector>

#include "tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// A framebuffer of up to kMostTargets RGBA32F colours, with depth and stencil.
class FloatTarget {
public:
  FloatTarget() = default;
  FloatTarget(const FloatTarget &) = delete;
  FloatTarget &operator=(const FloatTarget &) = delete;

  /// Binds a framebuffer of at least that size and number of colours, made anew if need be.
  /// \returns an empty string, or why there is none
  [[nodiscard]] std::string bind(int width, int height, std::size_t targets);
  /// As what is read from. Requires: bind() was successful.
  void bindToRead() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer); }
  /// Every pixel of the scissor box becomes uncovered(). The clear colour is as it was.
  void clear() const;
  /// Of the bound framebuffer: targets * height * width values.
  [[nodiscard]] std::vector<fp::ir::Vec4> read(const Region &region) const;

private:
  void release();

  GLuint m_framebuffer = 0, m_depth = 0;
  std::vector<GLuint> m_colors;
  int m_width = 0, m_height = 0;
};

} // namespace arbiter::tools::debug
