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
/// Returns the format; null if the name is none.
[[nodiscard]] const Format *findFormat(GLenum name);
[[nodiscard]] inline Base baseOf(GLenum name) {
  const Format *const format = findFormat(name);
  return format ? format->base : Base::RgbAlpha;
}

/// Keeps the components of `color` that the format has, each at the places where it acts: luminance
/// on red, green and blue, intensity on all four.
[[nodiscard]] Rgba select(Base base, const Rgba &color);
/// True if the format acts on the component. Others stay unchanged.
[[nodiscard]] bool acts(Base base, int component);
/// Returns a colour as queries return it: luminance and intensity in red, 0 for missing components.
[[nodiscard]] Rgba returned(Base base, const Rgba &selected);
/// Rounds components from 0 to 1 to the format's precision.
[[nodiscard]] Rgba rounded(const Format &format, const Rgba &selected);

} // namespace arbiter::state::imaging
