#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <png.h>

#include "suite.h"

namespace arbiter::differential {

namespace {
constexpr int kZoom = 8;

std::uint8_t byteOf(float value) {
  return std::isnan(value) ? 255 : std::uint8_t(std::clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/// Writes the drawn pixels on the left and the expected ones on the right, magnified.
void writePicture(const std::string &path, const std::vector<float> &seen,
                  const std::vector<float> &expected) {
  constexpr int kWidth = 2 * kSide * kZoom, kHeight = kSide * kZoom;
  std::vector<std::uint8_t> bytes(std::size_t(kWidth) * kHeight * 3);
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const int column = x / kZoom % kSide, row = kSide - 1 - y / kZoom;
      const std::vector<float> &from = x / kZoom < kSide ? seen : expected;
      for (int i = 0; i < 3; ++i)
        bytes[std::size_t((y * kWidth + x) * 3 + i)] =
            byteOf(from[std::size_t((row * kSide + column) * 4 + i)]);
    }
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = kWidth;
  image.height = kHeight;
  image.format = PNG_FORMAT_RGB;
  png_image_write_to_file(&image, path.c_str(), 0, bytes.data(), 0, nullptr);
}
} // namespace

void writeFailure(const std::string &folder, std::uint64_t seed, const std::string &text,
                  const std::string &reason, const std::vector<float> &seen,
                  const std::vector<float> &expected) {
  if (folder.empty())
    return;
  std::filesystem::create_directories(folder);
  const std::string stem = folder + "/" + std::to_string(seed);
  std::ofstream(stem + ".fp") << text;
  std::ofstream(stem + ".txt") << reason << "\n";
  if (!seen.empty())
    writePicture(stem + ".png", seen, expected);
}

} // namespace arbiter::differential
