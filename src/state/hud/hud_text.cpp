#include "state/hud/hud_text.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "state/hud/font.h"

namespace arbiter::state::hud {

namespace {

constexpr int kAdvance = kGlyphWidth + 1, kLine = kGlyphHeight + 2, kBorder = 2;
constexpr int kGraphHeight = 24, kGraphBar = 2; ///< in pixels of a letter
constexpr int kLarge = 480; ///< rows of a frame from which on letters are twice as high
constexpr std::uint8_t kPaper = 24, kInk = 236, kBar = 120, kSlowBar = 200;

std::string formatted(const char *format, double a, double b, double c) {
  char text[96];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

void fill(control::Picture &picture, int x, int y, int width, int height, std::uint8_t value) {
  for (int v = y; v < std::min(y + height, picture.height); ++v)
    for (int u = x; u < std::min(x + width, picture.width); ++u) {
      std::uint8_t *const pixel =
          picture.bytes.data() + (std::size_t(v) * std::size_t(picture.width) + std::size_t(u)) * 4;
      pixel[0] = pixel[1] = pixel[2] = value;
    }
}

void drawLetter(control::Picture &picture, int x, int top, char letter, int scale) {
  for (int row = 0; row < kGlyphHeight; ++row)
    for (int column = 0; column < kGlyphWidth; ++column)
      if ((glyphRow(letter, row) >> (kGlyphWidth - 1 - column) & 1) != 0)
        fill(picture, x + column * scale, top - (row + 1) * scale, scale, scale, kInk);
}

/// Draws one bar per frame. The full height is the worst frame's time, but at least 1/30 s. Frames
/// slower than 1/30 s are lighter.
void drawGraph(control::Picture &picture, const std::vector<float> &times, int scale) {
  constexpr float kSlow = 1000.f / 30;
  const float most = std::max(kSlow, *std::max_element(times.begin(), times.end()));
  for (std::size_t i = 0; i < times.size(); ++i) {
    const int height = std::max(1, int(times[i] / most * float(kGraphHeight * scale)));
    fill(picture, (kBorder + int(i) * kGraphBar) * scale, kBorder * scale, kGraphBar * scale,
         height, times[i] > kSlow ? kSlowBar : kBar);
  }
}

std::string speedOf(const std::vector<float> &times) {
  if (times.empty())
    return "no frames yet";
  const float mean = std::accumulate(times.begin(), times.end(), 0.f) / float(times.size());
  const float worst = *std::max_element(times.begin(), times.end());
  return formatted("%.1f fps  %.1f ms  worst %.1f", mean > 0 ? 1000 / mean : 0, mean, worst);
}

std::string drawsOf(const Figures &figures) {
  std::string draws;
  for (const Figures::Draws &row : figures.draws)
    draws += (draws.empty() ? "" : "  ") + std::string(row.path) + " " + std::to_string(row.count);
  return draws.empty() ? "no draws" : draws;
}

std::string programsOf(const Figures &figures) {
  return "programs " + std::to_string(figures.programs) + "  over native " +
         std::to_string(figures.overNative) +
         (figures.refused == 0 ? "" : "  refused " + std::to_string(figures.refused));
}

} // namespace

std::string versionLine(std::string_view profile, std::string_view description) {
  const std::size_t card = description.find(" (");
  return "Arbiter " ARBITER_VERSION_TEXT "  profile " + std::string(profile) +
         (card == std::string_view::npos ? "" : ", " + std::string(description.substr(0, card)));
}

std::vector<std::string> linesOf(const Figures &figures, const HudOptions &options) {
  std::vector<std::string> lines;
  if (options.has(HudPart::Version))
    lines.push_back(figures.version);
  if (options.has(HudPart::Host))
    lines.push_back(figures.host);
  if (options.has(HudPart::Fps))
    lines.push_back(speedOf(figures.times));
  if (options.has(HudPart::Draws))
    lines.push_back(drawsOf(figures));
  if (options.has(HudPart::Programs))
    lines.push_back(programsOf(figures));
  return lines;
}

int scaleOf(const HudOptions &options, int frameWidth, int frameHeight) {
  constexpr int kUsual = 48 * kAdvance + 2 * kBorder; // a line of 48 letters
  if (options.scale != 0)
    return options.scale;
  const int byHeight = frameHeight < kLarge ? 1 : std::max(2, frameHeight / kLarge);
  return std::clamp(frameWidth / kUsual, 1, byHeight);
}

HudOptions fitted(HudOptions options, int frameHeight) {
  // The part that goes first comes first.
  constexpr HudPart kLeast[] = {HudPart::Graph, HudPart::Host, HudPart::Version, HudPart::Programs,
                                HudPart::Draws};
  if (options.parts != HudOptions{}.parts || options.scale != 0 || frameHeight >= kLarge)
    return options;
  for (const HudPart part : kLeast) {
    int height = 2 * kBorder + (options.has(HudPart::Graph) ? kGraphHeight + 2 : 0);
    for (unsigned i = 0; i < kHudParts; ++i)
      height += options.has(HudPart(i)) && HudPart(i) != HudPart::Graph ? kLine : 0;
    if (height <= frameHeight / 8)
      break;
    options.parts &= std::uint8_t(~(1u << unsigned(part)));
  }
  return options;
}

control::Picture pictureOf(const std::vector<std::string> &lines, const std::vector<float> &times,
                           int scale) {
  std::size_t longest = 0;
  for (const std::string &line : lines)
    longest = std::max(longest, line.size());
  const int inside = std::max(int(longest) * kAdvance, int(times.size()) * kGraphBar);
  const int graph = times.empty() ? 0 : kGraphHeight + 2;
  control::Picture picture;
  picture.width = (inside + 2 * kBorder) * scale;
  picture.height = (int(lines.size()) * kLine + graph + 2 * kBorder) * scale;
  picture.bytes.assign(std::size_t(picture.width) * std::size_t(picture.height) * 4, 255);
  fill(picture, 0, 0, picture.width, picture.height, kPaper);
  for (std::size_t line = 0; line < lines.size(); ++line)
    for (std::size_t at = 0; at < lines[line].size(); ++at)
      drawLetter(picture, (kBorder + int(at) * kAdvance) * scale,
                 picture.height - (kBorder + int(line) * kLine) * scale, lines[line][at], scale);
  if (!times.empty())
    drawGraph(picture, times, scale);
  return picture;
}

} // namespace arbiter::state::hud
