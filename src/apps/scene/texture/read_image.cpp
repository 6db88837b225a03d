#include "apps/scene/texture/read_image.h"

#include <algorithm>
#include <fstream>

#include "apps/scene/document.h"

namespace arbiter::scene {

namespace {

using ReadImages = Result<std::vector<Image>, PictureError>;

std::string firstBytes(const std::string &path) {
  char bytes[4] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(bytes, sizeof bytes);
  return {bytes, std::size_t(file.gcount())};
}

PictureError named(const std::string &path, const PictureError &error) {
  return {path + ": " + error.message};
}

void turnOver(Image &image) {
  const std::size_t row = std::size_t(4) * std::size_t(image.width);
  for (std::size_t low = 0, high = std::size_t(image.height); low + 1 < high--; ++low)
    std::swap_ranges(image.texels.begin() + std::ptrdiff_t(low * row),
                     image.texels.begin() + std::ptrdiff_t((low + 1) * row),
                     image.texels.begin() + std::ptrdiff_t(high * row));
  for (Image &smaller : image.smaller)
    turnOver(smaller);
}

ReadImages ordered(std::vector<Image> images, Rows are, Rows wanted) {
  if (are != wanted)
    for (Image &image : images)
      turnOver(image);
  return images;
}

} // namespace

ReadImages readImage(const std::string &path, Rows rows) {
  const std::string first = firstBytes(path);
  const bool dds = first == "DDS ", jpeg = first.starts_with("\xff\xd8");
  if (!dds && !jpeg) {
    const auto picture = readPng(path);
    if (!picture)
      return picture.error();
    return ordered({Image(picture.value())}, Rows::BottomFirst, rows);
  }
  const auto bytes = readText(path);
  if (!bytes)
    return PictureError{bytes.error().message};
  if (dds) {
    auto images = decodeDds(bytes.value());
    return images ? ordered(std::move(images).value(), Rows::TopFirst, rows)
                  : ReadImages(named(path, images.error()));
  }
  const auto picture = decodeJpeg(bytes.value());
  return picture ? ordered({Image(picture.value())}, Rows::TopFirst, rows)
                 : ReadImages(named(path, picture.error()));
}

} // namespace arbiter::scene
