// Generates a model's random state, and sets it in GL.
#include <algorithm>

#include "model.h"

namespace api::imaging {

namespace {

constexpr GLenum kInternalFormats[] = {GL_ALPHA,     GL_LUMINANCE, GL_LUMINANCE_ALPHA,
                                       GL_INTENSITY, GL_RGB,       GL_RGBA};
constexpr GLenum kTables[] = {GL_COLOR_TABLE, GL_POST_CONVOLUTION_COLOR_TABLE,
                              GL_POST_COLOR_MATRIX_COLOR_TABLE};
constexpr GLenum kFilters[] = {GL_CONVOLUTION_1D, GL_CONVOLUTION_2D, GL_SEPARABLE_2D};
constexpr GLenum kModes[] = {GL_REDUCE, GL_CONSTANT_BORDER, GL_REPLICATE_BORDER};

bool one(std::mt19937 &random, unsigned of) { return random() % of == 0; }

/// Returns a random multiple of 1/16 in the range.
double few(std::mt19937 &random, double low, double high) {
  const auto steps = unsigned((high - low) * 16) + 1;
  return low + double(random() % steps) / 16.0;
}
Color fewColor(std::mt19937 &random, double low, double high) {
  Color color;
  for (double &component : color)
    component = few(random, low, high);
  return color;
}

ScaleBias scaleBias(std::mt19937 &random) {
  return one(random, 2) ? ScaleBias{}
                        : ScaleBias{fewColor(random, 0.5, 1.5), fewColor(random, -0.25, 0.25)};
}

Filter randomFilter(std::mt19937 &random, GLenum format, int width, int height) {
  Filter result{format, width, height, {}};
  for (int i = 0; i < width * height; ++i)
    result.weights.push_back(fewColor(random, -0.25, 0.5));
  return result;
}

Table randomTable(std::mt19937 &random) {
  Table result{kInternalFormats[random() % 6], std::vector<Color>(1u << (random() % 9))};
  for (Color &entry : result.entries)
    for (double &component : entry)
      component = double(random() & 255u) / 255.0;
  return result;
}

using Floats = std::vector<GLfloat>;
Floats floatsOf(const std::vector<Color> &colors) {
  Floats floats;
  for (const Color &color : colors)
    for (const double component : color)
      floats.push_back(GLfloat(component));
  return floats;
}

void transferScale(GLenum red, const ScaleBias &values) {
  for (GLenum c = 0; c < 4; ++c) {
    glPixelTransferf(red + c, GLfloat(values.scale[c]));
    glPixelTransferf(red + 4 + c, GLfloat(values.bias[c]));
  }
}

void firstScale(const ScaleBias &values) {
  constexpr GLenum kScales[] = {GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
  constexpr GLenum kBiases[] = {GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
  for (std::size_t c = 0; c < 4; ++c) {
    glPixelTransferf(kScales[c], GLfloat(values.scale[c]));
    glPixelTransferf(kBiases[c], GLfloat(values.bias[c]));
  }
}

void enable(GLenum cap, bool on) { (on ? glEnable : glDisable)(cap); }

void applyTables(const Model &model) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Table &table = model.tables[i];
    if (!table.entries.empty())
      glColorTable(kTables[i], table.format, GLsizei(table.entries.size()), GL_RGBA, GL_FLOAT,
                   floatsOf(table.entries).data());
    enable(kTables[i], model.tableOn[i]);
  }
}

void applyFilters(const Model &model) {
  if (model.filter1D.width != 0)
    glConvolutionFilter1D(GL_CONVOLUTION_1D, model.filter1D.format, model.filter1D.width, GL_RGBA,
                          GL_FLOAT, floatsOf(model.filter1D.weights).data());
  if (model.filter2D.width != 0)
    glConvolutionFilter2D(GL_CONVOLUTION_2D, model.filter2D.format, model.filter2D.width,
                          model.filter2D.height, GL_RGBA, GL_FLOAT,
                          floatsOf(model.filter2D.weights).data());
  if (model.row.width != 0)
    glSeparableFilter2D(GL_SEPARABLE_2D, model.row.format, model.row.width, model.column.width,
                        GL_RGBA, GL_FLOAT, floatsOf(model.row.weights).data(),
                        floatsOf(model.column.weights).data());
  for (std::size_t i = 0; i < 3; ++i) {
    const Border &border = model.borders[i];
    glConvolutionParameteri(kFilters[i], GL_CONVOLUTION_BORDER_MODE, GLint(border.mode));
    glConvolutionParameterfv(kFilters[i], GL_CONVOLUTION_BORDER_COLOR,
                             floatsOf({border.color}).data());
  }
  enable(GL_CONVOLUTION_1D, model.convolution1D);
  enable(GL_CONVOLUTION_2D, model.convolution2D);
  enable(GL_SEPARABLE_2D, model.separable);
}

} // namespace

Model randomModel(std::mt19937 &random) {
  Model model;
  model.first = scaleBias(random);
  model.postConvolution = scaleBias(random);
  model.postColorMatrix = scaleBias(random);
  for (std::size_t i = 0; i < 3; ++i) {
    model.tables[i] = randomTable(random);
    model.tableOn[i] = one(random, 3);
    model.borders[i] = {kModes[random() % 3], fewColor(random, 0, 1)};
  }
  const auto size = [&] { return 1 + int(random() % 5); };
  model.filter1D = randomFilter(random, kInternalFormats[random() % 6], size(), 1);
  model.filter2D = randomFilter(random, kInternalFormats[random() % 6], size(), size());
  model.row = randomFilter(random, kInternalFormats[random() % 6], size(), 1);
  model.column = randomFilter(random, model.row.format, size(), 1);
  model.convolution1D = one(random, 2);
  model.convolution2D = one(random, 3);
  model.separable = one(random, 2);
  if (one(random, 2))
    for (double &element : model.matrix)
      element = few(random, -0.5, 0.75);
  return model;
}

void apply(const Model &model) {
  firstScale(model.first);
  transferScale(GL_POST_CONVOLUTION_RED_SCALE, model.postConvolution);
  transferScale(GL_POST_COLOR_MATRIX_RED_SCALE, model.postColorMatrix);
  applyTables(model);
  applyFilters(model);
  glMatrixMode(GL_COLOR);
  glLoadMatrixd(model.matrix.data());
  glMatrixMode(GL_MODELVIEW);
  if (!model.histogram.empty())
    glHistogram(GL_HISTOGRAM, GLsizei(model.histogram.size()), model.histogramFormat, GL_FALSE);
  enable(GL_HISTOGRAM, model.histogramOn);
  enable(GL_MINMAX, model.minmaxOn);
}

void reset() { apply({}); }

} // namespace api::imaging
