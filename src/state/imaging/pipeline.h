#pragma once
#include <array>
#include <cstdint>

#include "state/imaging/arithmetic.h"
#include "state/imaging/color_table.h"
#include "state/imaging/convolution.h"
#include "state/imaging/statistics.h"

/// The operations of ARB_imaging, in the order of the pixel pipeline.
namespace arbiter::state::imaging {

/// Numbers the capabilities of Enable, as bits.
enum class Stage : std::uint8_t {
  ColorTable,
  PostConvolutionTable,
  PostColorMatrixTable, ///< the three tables use these as indices
  Convolution1D,
  Convolution2D,
  Separable2D,
  Histogram,
  Minmax,
};
constexpr unsigned bitOf(Stage stage) { return 1u << unsigned(stage); }

/// The state of GL_PIXEL_MODE_BIT, and the enables.
struct Settings {
  unsigned enabled = 0;
  std::array<ScaleBias, 3> tables;  ///< applied to the colours that set a table
  std::array<ScaleBias, 3> filters; ///< applied to a filter's colours, by Convolution1D, 2D and
                                    ///< Separable2D
  std::array<Border, 3> borders;
  ScaleBias postConvolution, postColorMatrix;

  [[nodiscard]] bool has(Stage stage) const { return (enabled & bitOf(stage)) != 0; }
};

/// State that no attribute group has.
struct Contents {
  std::array<ColorTable, 3> tables;
  std::array<Filter, 2> filters; ///< one-dimensional, two-dimensional
  Filter row, column;            ///< of the separable filter
  Histogram histogram;
  Minmax minmax;
};

/// Selects the convolution of an image, by its dimensions; images of three have none.
enum class ImageKind : std::uint8_t { One, Two, Three };

/// Returns the index of an image's filter, 0 to 2 as for the borders; -1 if it has none.
[[nodiscard]] int filterOf(const Settings &settings, const Contents &contents, ImageKind kind);
/// Updates the size of an image to that after its convolution.
void convolveSize(const Settings &settings, const Contents &contents, ImageKind kind, int &width,
                  int &height);

/// Runs all operations, from the first table on. Returns false if a sink has taken the pixels.
[[nodiscard]] bool run(const Settings &settings, Contents &contents, const Matrix &colorMatrix,
                       ImageKind kind, Pixels &pixels);

} // namespace arbiter::state::imaging
