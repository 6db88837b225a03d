#include "state/hud/hud_text.h"

#include <algorithm>
#include <cstdio>

#include "state/hud/font.h"

namespace arbiter::state::hud {

namespace {

constexpr int kAdvance = kGlyphWidth + 1, kLine = kGlyphHeight + 2, kBorder = 2;

std::string formatted(const char *format, double a, double b = 0, double c = 0) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

void fill(remote::Picture &picture, int x, int y, int size, std::uint8_t value) {
  for (int v = y; v < std::min(y + size, picture.height); ++v)
    for (int u = x; u < std::min(x + size, picture.width); ++u) {
      std::uint8_t *const pixel =
          picture.bytes.data() + (std::size_t(v) * std::size_t(picture.width) + std::size_t(u)) * 4;
      pixel[0] = pixel[1] = pixel[2] = value;
    }
}

} // namespace

std::vector<std::string> linesOf(const Figures &figures) {
  std::vector<std::string> lines;
  lines.push_back(
      formatted("%.1f ms  mean %.1f  worst %.1f", figures.last, figures.mean, figures.worst));
  std::string draws;
  for (const Figures::Draws &row : figures.draws)
    draws += (draws.empty() ? "" : "  ") + std::string(row.path) + " " + std::to_string(row.count);
  lines.push_back(draws.empty() ? "no draws" : draws);
  lines.push_back("programs " + std::to_string(figures.programs) + "  over native " +
                  std::to_string(figures.overNative) +
                  (figures.refused == 0 ? "" : "  refused " + std::to_string(figures.refused)));
  return lines;
}

remote::Picture pictureOf(const std::vector<std::string> &lines, int scale) {
  std::size_t longest = 0;
  for (const std::string &line : lines)
    longest = std::max(longest, line.size());
  remote::Picture picture;
  picture.width = (int(longest) * kAdvance + 2 * kBorder) * scale;
  picture.height = (int(lines.size()) * kLine + 2 * kBorder) * scale;
  constexpr std::uint8_t kPaper = 24, kInk = 236;
  picture.bytes.assign(std::size_t(picture.width) * std::size_t(picture.height) * 4, 255);
  for (std::size_t i = 0; i < picture.bytes.size(); ++i)
    if (i % 4 != 3)
      picture.bytes[i] = kPaper;
  for (std::size_t line = 0; line < lines.size(); ++line)
    for (std::size_t at = 0; at < lines[line].size(); ++at)
      for (int row = 0; row < kGlyphHeight; ++row)
        for (int column = 0; column < kGlyphWidth; ++column)
          if ((glyphRow(lines[line][at], row) >> (kGlyphWidth - 1 - column) & 1) != 0)
            fill(picture, (kBorder + int(at) * kAdvance + column) * scale,
                 picture.height - (kBorder + int(line) * kLine + row + 1) * scale, scale, kInk);
  return picture;
}

} // namespace arbiter::state::hud
