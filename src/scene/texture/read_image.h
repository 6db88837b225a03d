#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/texture/image.h"
#include "util/result.h"

/// Images from files: PNG, JPEG and DDS, told apart by their first bytes. Files are not trusted:
/// what they say of their size is checked before memory is asked for.
namespace arbiter::scene {

/// Which row of the picture is row 0 of the image: the lowest one as GL's textures have it, or the
/// topmost one as the faces of cube maps do.
enum class Rows { BottomFirst, TopFirst };

/// One image, or, of a DDS file that is a cube map, six faces in GL's order. A DDS file with
/// smaller levels has them in Image::smaller. Errors: "name: reason".
[[nodiscard]] Result<std::vector<Image>, PictureError> readImage(const std::string &path,
                                                                 Rows rows);

/// A JPEG file's bytes (grey or colour, baseline or progressive), the topmost row first; alpha
/// is 1. At most 8192 pixels a side. What is said of the camera's orientation is not read. Errors:
/// the reason, without a name.
[[nodiscard]] Result<Picture, PictureError> decodeJpeg(std::string_view bytes);

/// A DDS file's bytes: BC1 to BC3 (DXT1, DXT3, DXT5) and texels of 8 to 32 bits whose components
/// have at most 8, the topmost row first; of a cube map six faces. At most 8192 pixels a side and
/// 2^26 texels in all. Errors: the reason, without a name.
[[nodiscard]] Result<std::vector<Image>, PictureError> decodeDds(std::string_view bytes);

} // namespace arbiter::scene
