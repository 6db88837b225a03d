#include "tools/picture.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <png.h>

namespace arbiter::tools {

namespace {

constexpr png_uint_32 kMaxSide = 8192;

} // namespace

Result<Picture, PictureError> readPng(const std::string &path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
    return PictureError{path + ": " + image.message};
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
    return PictureError{path + ": " + image.message};
  return picture;
}

std::string writePng(const std::string &path, const Picture &picture) {
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

Picture checker(int size) {
  Picture picture{size, size, {}};
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool light = ((x * 8 / size) + (y * 8 / size)) % 2 != 0;
      const std::uint8_t level = light ? 255 : 32;
      picture.bytes.insert(picture.bytes.end(), {level, level, level, 255});
    }
  }
  return picture;
}

Picture noise(int width, int height) {
  Picture picture{width, height, std::vector<std::uint8_t>(std::size_t(4) * width * height)};
  std::uint32_t state = 2463534242u; // xorshift32: the sequence is part of the picture's meaning
  for (std::uint8_t &byte : picture.bytes) {
    state ^= state << 13;
    state ^= state >> 17;
    state ^= state << 5;
    byte = std::uint8_t(state >> 24);
  }
  return picture;
}

} // namespace arbiter::tools
