#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "util/result.h"

namespace arbiter::scene {

inline constexpr int kMaxSide = 8192; ///< of a picture, in pixels

/// An 8-bit RGBA picture. Row 0 is the bottom one, as in GL.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

struct PictureError {
  std::string message; ///< "name: reason"
};

/// Reads any PNG, converted to 8-bit RGBA, of at most kMaxSide a side.
[[nodiscard]] Result<Picture, PictureError> readPng(const std::string &path);

/// Writes a PNG. Refuses a name that promises another kind of image, and "-".
/// \returns an empty string, or "name: reason".
[[nodiscard]] std::string writePng(const std::string &path, const Picture &picture);

} // namespace arbiter::scene
