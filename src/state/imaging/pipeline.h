#pragma once
#include <array>
#include <cstdint>

#include "state/imaging/arithmetic.h"
#include "state/imaging/color_table.h"
#include "state/imaging/convolution.h"
#include "state/imaging/statistics.h"

/// The operations of ARB_imaging, in the order in which pixels go through them.
namespace arbiter::state::imaging {

/// What Enable names, in bits.
enum class Stage : std::uint8_t {
  ColorTable,
  PostConvolutionTable,
  PostColorMatrixTable, ///< the three tables are also numbered so
  Convolution1D,
  Convolution2D,
  Separable2D,
  Histogram,
  Minmax,
};
constexpr unsigned bitOf(Stage stage) { return 1u << unsigned(stage); }

/// State of GL_PIXEL_MODE_BIT, and of the enables.
struct Settings {
  unsigned enabled = 0;
  std::array<ScaleBias, 3> tables;  ///< of colours that a table is given
  std::array<ScaleBias, 3> filters; ///< of a filter's, by Convolution1D, 2D and Separable2D
  std::array<Border, 3> borders;
  ScaleBias postConvolution, postColorMatrix;

  [[nodiscard]] bool has(Stage stage) const { return (enabled & bitOf(stage)) != 0; }
};

/// What is in no attribute group.
struct Contents {
  std::array<ColorTable, 3> tables;
  std::array<Filter, 2> filters; ///< of one dimension, of two
  Filter row, column;            ///< of the separable one
  Histogram histogram;
  Minmax minmax;
};

/// Which convolution an image takes part in: that of its dimensions; none of three.
enum class ImageKind : std::uint8_t { One, Two, Three };

/// The number of the filter that an image goes through, 0 to 2 as the borders are; -1: none.
[[nodiscard]] int filterOf(const Settings &settings, const Contents &contents, ImageKind kind);
/// The size that an image has behind its convolution.
void convolveSize(const Settings &settings, const Contents &contents, ImageKind kind, int &width,
                  int &height);

/// All from the first table on. False: a sink has taken the pixels.
[[nodiscard]] bool run(const Settings &settings, Contents &contents, const Matrix &colorMatrix,
                       ImageKind kind, Pixels &pixels);

} // namespace arbiter::state::imaging
