#include "common/image.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/common.hpp>
#include <png.h>

namespace demos {

glm::vec4 Image::at(int x, int y) const {
  const std::uint8_t *p = &bytes[4ull * (std::size_t(y) * width + x)];
  return glm::vec4(p[0], p[1], p[2], p[3]) / 255.0f;
}

void Image::set(int x, int y, const glm::vec4 &color) {
  std::uint8_t *p = &bytes[4ull * (std::size_t(y) * width + x)];
  for (int i = 0; i < 4; ++i)
    p[i] = std::uint8_t(std::lround(std::clamp(color[i], 0.0f, 1.0f) * 255.0f));
}

glm::vec4 Image::sampleLinear(glm::vec2 coordinate) const {
  const glm::vec2 texel = coordinate * glm::vec2(width, height) - 0.5f;
  const glm::vec2 base = glm::floor(texel);
  const glm::vec2 part = texel - base;
  const auto column = [&](int x) { return std::clamp(x, 0, width - 1); };
  const auto row = [&](int y) { return std::clamp(y, 0, height - 1); };
  const int x = int(base.x), y = int(base.y);
  const glm::vec4 low = glm::mix(at(column(x), row(y)), at(column(x + 1), row(y)), part.x);
  const glm::vec4 high = glm::mix(at(column(x), row(y + 1)), at(column(x + 1), row(y + 1)), part.x);
  return glm::mix(low, high, part.y);
}

Difference compare(const Image &picture, const Image &reference, Tolerance tolerance) {
  Difference result;
  if (picture.width != reference.width || picture.height != reference.height) {
    result.maxError = 255;
    result.beyond = picture.bytes.size() / 4;
    return result;
  }
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const std::size_t at = 4ull * (std::size_t(y) * picture.width + x);
      int error = 0;
      for (int i = 0; i < 3; ++i)
        error = std::max(error, std::abs(picture.bytes[at + i] - reference.bytes[at + i]));
      if (error > result.maxError) {
        result.maxError = error;
        result.worst = {x, y};
      }
      result.beyond += error > tolerance.levels;
    }
  }
  const std::size_t pixels = picture.bytes.size() / 4;
  result.ok = double(result.beyond) <= tolerance.outliers * double(pixels);
  return result;
}

bool writePng(const Image &image, const std::string &file) {
  png_image header;
  std::memset(&header, 0, sizeof header);
  header.version = PNG_IMAGE_VERSION;
  header.width = png_uint_32(image.width);
  header.height = png_uint_32(image.height);
  header.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rows(3ull * image.width * image.height);
  for (std::size_t i = 0; i < rows.size() / 3; ++i)
    std::memcpy(&rows[3 * i], &image.bytes[4 * i], 3);
  // The stride is negative because PNG's first row is the top one.
  if (png_image_write_to_file(&header, file.c_str(), 0, rows.data(), -3 * image.width, nullptr))
    return true;
  std::fprintf(stderr, "%s: %s\n", file.c_str(), header.message);
  return false;
}

} // namespace demos
