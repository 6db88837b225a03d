#pragma once
#include <map>
#include <string>

#include "apps/scene/picture.h"
#include "program.h"

/// Draws documents without GL: programs by the interpreter, everything else in plain C++.
namespace gallery {

/// The buffers that are drawn to.
struct Surface {
  Surface() = default;
  Surface(int columns, int rows);

  int width = 0, height = 0;
  std::vector<std::uint8_t> color;  ///< RGBA, row 0 at the bottom
  std::vector<std::uint32_t> depth; ///< 24 bits
  std::vector<std::uint8_t> stencil;
};

class Reference {
public:
  explicit Reference(const scene::Document &document);

  /// Draws a frame. Frames must come in order if each depends on the previous one.
  void draw(int frame);
  [[nodiscard]] scene::Picture picture() const;

private:
  void drawPass(std::size_t index, double seconds);
  Texture textureOf(const scene::TextureSpec &spec);
  Surface &targetOf(const scene::Pass &pass);

  const scene::Document &m_document;
  std::map<std::string, Surface> m_targets; ///< the picture's own surface has no name
  std::map<const scene::TextureSpec *, Texture> m_textures;
  bool m_fed = false;
};

} // namespace gallery
