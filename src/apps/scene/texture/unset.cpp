#include "apps/scene/texture/unset.h"

#include <array>
#include <string>

namespace arbiter::scene {

namespace {

constexpr int kTile = 64;  ///< texels
constexpr int kSquare = 8; ///< texels
constexpr int kDot = 5;    ///< texels for each dot of a digit
constexpr int kColumns = 5, kRows = 7;
constexpr int kGap = 1; ///< dots between digits

/// A digit's rows from the top, with the leftmost dot in the highest of five bits.
using Digit = std::array<std::uint8_t, kRows>;
constexpr std::array<Digit, 10> kDigits = {{
    {0x0E, 0x11, 0x13, 0x15, 0x19, 0x11, 0x0E},
    {0x04, 0x0C, 0x04, 0x04, 0x04, 0x04, 0x0E},
    {0x0E, 0x11, 0x01, 0x02, 0x04, 0x08, 0x1F},
    {0x1F, 0x02, 0x04, 0x02, 0x01, 0x11, 0x0E},
    {0x02, 0x06, 0x0A, 0x12, 0x1F, 0x02, 0x02},
    {0x1F, 0x10, 0x1E, 0x01, 0x01, 0x11, 0x0E},
    {0x06, 0x08, 0x10, 0x1E, 0x11, 0x11, 0x0E},
    {0x1F, 0x01, 0x02, 0x04, 0x08, 0x08, 0x08},
    {0x0E, 0x11, 0x11, 0x0E, 0x11, 0x11, 0x0E},
    {0x0E, 0x11, 0x11, 0x0F, 0x01, 0x02, 0x0C},
}};

int widthOf(const std::string &number) {
  return kDot * (int(number.size()) * (kColumns + kGap) - kGap);
}

/// True if the texel belongs to the number, which is centered in the tile.
bool isLit(const std::string &number, int x, int y) {
  const int left = (kTile - widthOf(number)) / 2, bottom = (kTile - kDot * kRows) / 2;
  if (x < left || y < bottom || x >= left + widthOf(number) || y >= bottom + kDot * kRows)
    return false;
  const int column = (x - left) / kDot, row = kRows - 1 - (y - bottom) / kDot;
  const std::size_t digit = std::size_t(column / (kColumns + kGap));
  const int within = column % (kColumns + kGap);
  return within < kColumns &&
         (kDigits[std::size_t(number[digit] - '0')][std::size_t(row)] >> (kColumns - 1 - within) &
          1) != 0;
}

} // namespace

Image makeUnset(unsigned unit, int width, int height) {
  constexpr glm::vec4 kNumber{1, 1, 1, 1}, kLight{0.5f, 0.1f, 0.5f, 1}, kDark{0.2f, 0.2f, 0.2f, 1};
  const std::string number = height > 1 ? std::to_string(unit % 100) : std::string();
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const bool light = (x / kSquare + y / kSquare) % 2 != 0;
      const bool lit = !number.empty() && isLit(number, x % kTile, y % kTile);
      image.set(x, y, lit ? kNumber : light ? kLight : kDark);
    }
  return image;
}

} // namespace arbiter::scene
