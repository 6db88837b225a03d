#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include <GL/gl.h>

#include "swrast/image/image.h"

namespace arbiter::state::software {

/// What the context draws to where no framebuffer object is bound, as the window system tells it.
/// The interposer says it before the context becomes current.
struct Drawable {
  enum class Kind : std::uint8_t {
    None,    ///< surfaceless, or unknown: never the rasterizer's
    Window,  ///< seen by others: a window, a pixmap
    Pbuffer, ///< seen by GL alone
    Memory,  ///< the application's own memory (OSMesa)
  };
  Kind kind = Kind::None;
  const void *display = nullptr, *draw = nullptr; ///< handles for `size`
  bool sameRead = true;                           ///< the read drawable is the same
  /// Asks the window system; null where width and height are fixed. False: it is not known.
  /// \param sure an answer as old as the last frame will not do, though the window system told the
  ///             application of no change since
  bool (*size)(const Drawable &drawable, int &width, int &height, bool sure) = nullptr;
  int width = 0, height = 0;
  /// Memory that the window system shows pixels from by itself; null: it does not.
  std::shared_ptr<swrast::Storage> (*sharedMemory)(const Drawable &drawable,
                                                   std::size_t bytes) = nullptr;
  /// Shows an image of the window's size: it is read while the caller goes on, until its storage
  /// says that it is not read any more (swrast::Storage::isRead). False: it could not, or the
  /// storage is not of sharedMemory().
  bool (*show)(const Drawable &drawable, const swrast::Image &image) = nullptr;
  void *presenter = nullptr; ///< for the two
  void *memory = nullptr;    ///< of Kind::Memory: its lowest address, and what it holds
  GLenum memoryFormat = 0, memoryType = 0; ///< GL_RGBA .., GL_UNSIGNED_BYTE ..
  /// How rows lie in `memory` now; null: as many pixels as are wide, bottom row first.
  void (*memoryLayout)(const Drawable &drawable, int &rowLength, bool &topRowFirst) = nullptr;
};

/// What is drawn to the one is in the other. No drawable is the same as none.
[[nodiscard]] inline bool isSameDrawable(const Drawable &a, const Drawable &b) {
  if (a.kind == Drawable::Kind::None || a.kind != b.kind)
    return false;
  return a.kind == Drawable::Kind::Memory ? a.memory == b.memory
                                          : a.draw == b.draw && a.display == b.display;
}

} // namespace arbiter::state::software
