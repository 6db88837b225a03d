#pragma once
#include <epoxy/gl.h>
#include <string>
#include <vector>

#include "tools/debug/pixel/drawer.h"

namespace arbiter::tools::debug {

/// A framebuffer object of up to kMostTargets colours, with depth and stencil. All that the
/// debugger draws goes to such ones, the document's own picture too: a window's rows may lie the
/// other way up in memory, and a depth of the same place has another last bit then.
class DrawTarget {
public:
  /// \param format of the colours
  explicit DrawTarget(GLenum format = GL_RGBA32F) : m_format(format) {}
  DrawTarget(const DrawTarget &) = delete;
  DrawTarget &operator=(const DrawTarget &) = delete;

  /// Binds a framebuffer of at least that size, which draws to so many colours. One object serves
  /// all numbers: what has been drawn to before costs less to clear.
  /// \returns an empty string, or why there is none
  [[nodiscard]] std::string bind(int width, int height, std::size_t targets);
  /// As what is read from. Requires: bind() was successful.
  void bindToRead() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer); }
  /// Every pixel becomes uncovered(), as no scissor test is enabled. The clear colour is as it was.
  void clear() const;
  /// Of the bound framebuffer: targets * height * width values. The format is one of floats.
  [[nodiscard]] std::vector<fp::ir::Vec4> read(const Region &region) const;

private:
  void release();

  const GLenum m_format;
  GLuint m_framebuffer = 0, m_depth = 0;
  std::vector<GLuint> m_colors;
  std::size_t m_drawn = 0; ///< colours that are drawn to, of m_colors
  int m_width = 0, m_height = 0;
};

} // namespace arbiter::tools::debug
