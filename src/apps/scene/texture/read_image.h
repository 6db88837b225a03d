#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "apps/scene/texture/image.h"
#include "util/result.h"

/// Reads images from PNG, JPEG and DDS files, which it distinguishes by their first bytes. The
/// files are untrusted: their sizes are checked before memory is allocated.
namespace arbiter::scene {

/// The picture's row that becomes row 0 of the image: the bottom one for GL textures, the top one
/// for faces of cube maps.
enum class Rows { BottomFirst, TopFirst };

/// Reads one image, or the six faces of a DDS cube map in GL's order. Smaller levels of a DDS file
/// are in Image::smaller. Errors: "name: reason".
[[nodiscard]] Result<std::vector<Image>, PictureError> readImage(const std::string &path,
                                                                 Rows rows);

/// Decodes a JPEG file (grey or color, baseline or progressive), the top row first; alpha is 1. It
/// has at most 8192 pixels a side, and its camera orientation is ignored. Errors: the reason,
/// without a name.
[[nodiscard]] Result<Picture, PictureError> decodeJpeg(std::string_view bytes);

/// Decodes a DDS file, the top row first; a cube map yields six faces. It supports BC1 to BC3
/// (DXT1, DXT3, DXT5) and texels of 8 to 32 bits whose components have at most 8. It has at most
/// 8192 pixels a side and 2^26 texels in all. Errors: the reason, without a name.
[[nodiscard]] Result<std::vector<Image>, PictureError> decodeDds(std::string_view bytes);

} // namespace arbiter::scene
