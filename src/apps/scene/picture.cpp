#include "apps/scene/picture.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <png.h>

namespace arbiter::scene {

namespace {

/// Says why an image cannot be read. libpng's words for a text or a part of a file say too little.
std::string whyNotRead(const char *libpng) {
  const std::string_view message = libpng;
  if (message == "Not a PNG file")
    return "is no PNG, JPEG or DDS file";
  return message == "Read Error" || message == "Read error" ? "is no whole PNG file" : libpng;
}

/// True for a name that promises another kind of image, or standard output.
bool isOfAnotherKind(std::string_view path) {
  for (const std::string_view ending : {".jpg", ".jpeg", ".bmp", ".gif", ".tga", ".webp", ".ppm"})
    if (path.ends_with(ending))
      return true;
  return path == "-";
}

} // namespace

Result<Picture, PictureError> readPng(const std::string &path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
    return PictureError{path + ": " + whyNotRead(image.message)};
  Picture picture;
  if (image.width > kMaxSide || image.height > kMaxSide) {
    png_image_free(&image);
    return PictureError{path + ": more than 8192 pixels a side"};
  }
  image.format = PNG_FORMAT_RGBA;
  picture.width = int(image.width);
  picture.height = int(image.height);
  picture.bytes.resize(std::size_t(PNG_IMAGE_SIZE(image)));
  const png_int_32 upwards = -png_int_32(PNG_IMAGE_ROW_STRIDE(image));
  if (png_image_finish_read(&image, nullptr, picture.bytes.data(), upwards, nullptr) == 0)
    return PictureError{path + ": " + whyNotRead(image.message)};
  return picture;
}

std::string writePng(const std::string &path, const Picture &picture) {
  if (isOfAnotherKind(path))
    return path + ": a picture is a PNG, in a file with the ending .png";
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = png_uint_32(picture.width);
  image.height = png_uint_32(picture.height);
  image.format = PNG_FORMAT_RGBA;
  const png_int_32 upwards = -png_int_32(PNG_IMAGE_ROW_STRIDE(image));
  if (png_image_write_to_file(&image, path.c_str(), 0, picture.bytes.data(), upwards, nullptr) == 0)
    return path + ": " + image.message;
  return {};
}

} // namespace arbiter::scene
