#include "state/imaging/formats.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace arbiter::state::imaging {

namespace {

// OpenGL 2.1, tables 3.15 and 3.16. Formats without sizes have eight bits.
constexpr Format kFormats[] = {
    {GL_ALPHA, Base::Alpha, {0, 0, 0, 8, 0, 0}},
    {GL_ALPHA4, Base::Alpha, {0, 0, 0, 4, 0, 0}},
    {GL_ALPHA8, Base::Alpha, {0, 0, 0, 8, 0, 0}},
    {GL_ALPHA12, Base::Alpha, {0, 0, 0, 12, 0, 0}},
    {GL_ALPHA16, Base::Alpha, {0, 0, 0, 16, 0, 0}},
    {GL_LUMINANCE, Base::Luminance, {0, 0, 0, 0, 8, 0}},
    {GL_LUMINANCE4, Base::Luminance, {0, 0, 0, 0, 4, 0}},
    {GL_LUMINANCE8, Base::Luminance, {0, 0, 0, 0, 8, 0}},
    {GL_LUMINANCE12, Base::Luminance, {0, 0, 0, 0, 12, 0}},
    {GL_LUMINANCE16, Base::Luminance, {0, 0, 0, 0, 16, 0}},
    {GL_LUMINANCE_ALPHA, Base::LuminanceAlpha, {0, 0, 0, 8, 8, 0}},
    {GL_LUMINANCE4_ALPHA4, Base::LuminanceAlpha, {0, 0, 0, 4, 4, 0}},
    {GL_LUMINANCE6_ALPHA2, Base::LuminanceAlpha, {0, 0, 0, 2, 6, 0}},
    {GL_LUMINANCE8_ALPHA8, Base::LuminanceAlpha, {0, 0, 0, 8, 8, 0}},
    {GL_LUMINANCE12_ALPHA4, Base::LuminanceAlpha, {0, 0, 0, 4, 12, 0}},
    {GL_LUMINANCE12_ALPHA12, Base::LuminanceAlpha, {0, 0, 0, 12, 12, 0}},
    {GL_LUMINANCE16_ALPHA16, Base::LuminanceAlpha, {0, 0, 0, 16, 16, 0}},
    {GL_INTENSITY, Base::Intensity, {0, 0, 0, 0, 0, 8}},
    {GL_INTENSITY4, Base::Intensity, {0, 0, 0, 0, 0, 4}},
    {GL_INTENSITY8, Base::Intensity, {0, 0, 0, 0, 0, 8}},
    {GL_INTENSITY12, Base::Intensity, {0, 0, 0, 0, 0, 12}},
    {GL_INTENSITY16, Base::Intensity, {0, 0, 0, 0, 0, 16}},
    {GL_R3_G3_B2, Base::Rgb, {3, 3, 2, 0, 0, 0}},
    {GL_RGB, Base::Rgb, {8, 8, 8, 0, 0, 0}},
    {GL_RGB4, Base::Rgb, {4, 4, 4, 0, 0, 0}},
    {GL_RGB5, Base::Rgb, {5, 5, 5, 0, 0, 0}},
    {GL_RGB8, Base::Rgb, {8, 8, 8, 0, 0, 0}},
    {GL_RGB10, Base::Rgb, {10, 10, 10, 0, 0, 0}},
    {GL_RGB12, Base::Rgb, {12, 12, 12, 0, 0, 0}},
    {GL_RGB16, Base::Rgb, {16, 16, 16, 0, 0, 0}},
    {GL_RGBA, Base::RgbAlpha, {8, 8, 8, 8, 0, 0}},
    {GL_RGBA2, Base::RgbAlpha, {2, 2, 2, 2, 0, 0}},
    {GL_RGBA4, Base::RgbAlpha, {4, 4, 4, 4, 0, 0}},
    {GL_RGB5_A1, Base::RgbAlpha, {5, 5, 5, 1, 0, 0}},
    {GL_RGBA8, Base::RgbAlpha, {8, 8, 8, 8, 0, 0}},
    {GL_RGB10_A2, Base::RgbAlpha, {10, 10, 10, 2, 0, 0}},
    {GL_RGBA12, Base::RgbAlpha, {12, 12, 12, 12, 0, 0}},
    {GL_RGBA16, Base::RgbAlpha, {16, 16, 16, 16, 0, 0}},
};

/// Returns the row of Format::bits for a component.
int rowOf(Base base, int component) {
  if (base == Base::Intensity)
    return 5;
  const bool luminance = base == Base::Luminance || base == Base::LuminanceAlpha;
  return luminance && component < 3 ? 4 : component;
}

} // namespace

const Format *findFormat(GLenum name) {
  const Format *const found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                           [&](const Format &f) { return f.name == name; });
  return found == std::end(kFormats) ? nullptr : found;
}

Rgba select(Base base, const Rgba &color) {
  const float red = color[0];
  switch (base) {
  case Base::Alpha:
    return {0, 0, 0, color[3]};
  case Base::Luminance:
    return {red, red, red, 0};
  case Base::LuminanceAlpha:
    return {red, red, red, color[3]};
  case Base::Intensity:
    return {red, red, red, red};
  case Base::Rgb:
    return {red, color[1], color[2], 0};
  default:
    return color;
  }
}

bool acts(Base base, int component) {
  switch (base) {
  case Base::Alpha:
    return component == 3;
  case Base::Luminance:
  case Base::Rgb:
    return component != 3;
  default:
    return true;
  }
}

Rgba returned(Base base, const Rgba &selected) {
  switch (base) {
  case Base::Luminance:
  case Base::Intensity:
    return {selected[0], 0, 0, 0};
  case Base::LuminanceAlpha:
    return {selected[0], 0, 0, selected[3]};
  default:
    return selected;
  }
}

Rgba rounded(const Format &format, const Rgba &selected) {
  Rgba result{};
  for (int c = 0; c < 4; ++c) {
    if (!acts(format.base, c))
      continue;
    const int bits = format.bits[std::size_t(rowOf(format.base, c))];
    const double steps = double((1 << bits) - 1);
    result[std::size_t(c)] =
        float(std::floor(double(selected[std::size_t(c)]) * steps + 0.5) / steps);
  }
  return result;
}

} // namespace arbiter::state::imaging
