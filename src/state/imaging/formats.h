#pragma once
#include <array>

#include <GL/gl.h>

#include "state/imaging/pixels.h"

/// Internal formats of colour tables, convolution filters, histograms and minmax tables.
namespace arbiter::state::imaging {

enum class Base { Alpha, Luminance, LuminanceAlpha, Intensity, Rgb, RgbAlpha };

struct Format {
  GLenum name;
  Base base;
  /// Bits of red, green, blue, alpha, luminance and intensity.
  std::array<int, 6> bits;
};
/// Null for what is no such format.
[[nodiscard]] const Format *findFormat(GLenum name);
[[nodiscard]] inline Base baseOf(GLenum name) {
  const Format *const format = findFormat(name);
  return format ? format->base : Base::RgbAlpha;
}

/// The components of `color` that the format has, each where it acts: luminance is that of red,
/// green and blue, intensity that of all four.
[[nodiscard]] Rgba select(Base base, const Rgba &color);
/// Whether it acts on the component; what it does not act on is unchanged.
[[nodiscard]] bool acts(Base base, int component);
/// What a query returns of a selected colour: luminance and intensity as red, 0 for what the format
/// lacks.
[[nodiscard]] Rgba returned(Base base, const Rgba &selected);
/// `selected`, of the range 0 to 1, at the format's precision.
[[nodiscard]] Rgba rounded(const Format &format, const Rgba &selected);

} // namespace arbiter::state::imaging
