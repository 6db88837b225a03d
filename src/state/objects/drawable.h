#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>

#include <GL/gl.h>

#include "swrast/image/image.h"

namespace arbiter::state {

/// A context's default framebuffer as the window system describes it. The interposer fills it in
/// before the context becomes current.
struct Drawable {
  enum class Kind : std::uint8_t {
    None,    ///< surfaceless or unknown: the rasterizer never draws to it
    Window,  ///< visible to others: a window, a pixmap
    Pbuffer, ///< visible to GL alone
    Memory,  ///< the application's own memory (OSMesa)
  };
  Kind kind = Kind::None;
  const void *display = nullptr, *draw = nullptr; ///< handles for `size`
  bool sameRead = true;                           ///< read and draw drawable are the same
  /// Queries the size from the window system; returns false if it is unknown. Null if width and
  /// height never change.
  /// \param sure do not answer with the last frame's size, even if the window system reported no
  /// change since
  bool (*size)(const Drawable &drawable, int &width, int &height, bool sure) = nullptr;
  int width = 0, height = 0;
  /// Returns memory that the window system can present directly; null if it cannot.
  std::shared_ptr<swrast::Storage> (*sharedMemory)(const Drawable &drawable,
                                                   std::size_t bytes) = nullptr;
  /// Presents an image of the window's size. The window system reads it while the caller goes on,
  /// until swrast::Storage::isRead says otherwise. Returns false if it cannot, or if the storage is
  /// not from sharedMemory().
  bool (*show)(const Drawable &drawable, const swrast::Image &image) = nullptr;
  void *presenter = nullptr;               ///< context of `sharedMemory` and `show`
  void *memory = nullptr;                  ///< lowest address of Kind::Memory's pixels
  GLenum memoryFormat = 0, memoryType = 0; ///< GL_RGBA .., GL_UNSIGNED_BYTE ..
  /// Queries the layout of rows in `memory`; null: rows of `width` pixels, bottom row first.
  void (*memoryLayout)(const Drawable &drawable, int &rowLength, bool &topRowFirst) = nullptr;
};

/// True if both are the same drawable, so that drawing to one changes the other. False for None.
[[nodiscard]] inline bool isSameDrawable(const Drawable &a, const Drawable &b) {
  if (a.kind == Drawable::Kind::None || a.kind != b.kind)
    return false;
  return a.kind == Drawable::Kind::Memory ? a.memory == b.memory
                                          : a.draw == b.draw && a.display == b.display;
}

} // namespace arbiter::state
