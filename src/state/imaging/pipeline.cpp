#include "state/imaging/pipeline.h"

namespace arbiter::state::imaging {

namespace {

void look(const Settings &settings, const Contents &contents, Stage table, Pixels &pixels) {
  if (settings.has(table))
    contents.tables[std::size_t(table)].apply(pixels);
}

Filter filterNumber(const Contents &contents, int number) {
  return number == 2 ? product(contents.row, contents.column)
                     : contents.filters[std::size_t(number)];
}

} // namespace

int filterOf(const Settings &settings, const Contents &contents, ImageKind kind) {
  if (kind == ImageKind::One)
    return settings.has(Stage::Convolution1D) && !contents.filters[0].empty() ? 0 : -1;
  if (kind != ImageKind::Two)
    return -1;
  if (settings.has(Stage::Convolution2D)) // comes before the separable one
    return contents.filters[1].empty() ? -1 : 1;
  const bool separable = settings.has(Stage::Separable2D);
  return separable && !contents.row.empty() && !contents.column.empty() ? 2 : -1;
}

void convolveSize(const Settings &settings, const Contents &contents, ImageKind kind, int &width,
                  int &height) {
  const int number = filterOf(settings, contents, kind);
  if (number < 0)
    return;
  const Border &border = settings.borders[std::size_t(number)];
  const bool separable = number == 2;
  const Pixels &image =
      separable ? contents.row.image : contents.filters[std::size_t(number)].image;
  width = convolvedSize(width, image.width, border);
  if (kind == ImageKind::Two)
    height = convolvedSize(height, separable ? contents.column.image.width : image.height, border);
}

bool run(const Settings &settings, Contents &contents, const Matrix &colorMatrix, ImageKind kind,
         Pixels &pixels) {
  look(settings, contents, Stage::ColorTable, pixels);
  if (const int number = filterOf(settings, contents, kind); number >= 0) {
    pixels =
        convolve(pixels, filterNumber(contents, number), settings.borders[std::size_t(number)]);
    settings.postConvolution.apply(pixels);
  }
  look(settings, contents, Stage::PostConvolutionTable, pixels);
  transform(pixels, colorMatrix);
  settings.postColorMatrix.apply(pixels);
  look(settings, contents, Stage::PostColorMatrixTable, pixels);
  if (settings.has(Stage::Histogram)) {
    contents.histogram.count(pixels);
    if (contents.histogram.sink)
      return false;
  }
  if (settings.has(Stage::Minmax)) {
    contents.minmax.count(pixels);
    if (contents.minmax.sink)
      return false;
  }
  return true;
}

} // namespace arbiter::state::imaging
