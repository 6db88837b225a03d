#include "model.h"

#include <algorithm>
#include <cmath>

namespace api::imaging {

namespace {

double clamp(double value) { return std::clamp(value, 0.0, 1.0); }

/// Returns the operand for a pixel's component in an entry of this format; false: there is none.
bool operand(GLenum format, const Color &entry, int component, double &value) {
  switch (format) {
  case GL_ALPHA:
    value = entry[3];
    return component == 3;
  case GL_LUMINANCE:
    value = entry[0];
    return component < 3;
  case GL_LUMINANCE_ALPHA:
    value = component < 3 ? entry[0] : entry[3];
    return true;
  case GL_INTENSITY:
    value = entry[0];
    return true;
  case GL_RGB:
    value = entry[std::size_t(component)];
    return component < 3;
  default:
    value = entry[std::size_t(component)];
    return true;
  }
}

void scale(const ScaleBias &by, Image &image) {
  for (Color &color : image.colors)
    for (std::size_t c = 0; c < 4; ++c)
      color[c] = color[c] * by.scale[c] + by.bias[c];
}

/// True if a place is half-way between two entries, within the precision of floats.
bool isBetween(double place) { return std::abs(place - std::floor(place) - 0.5) < 1e-4; }

void look(const Table &table, Image &image) {
  for (Color &color : image.colors)
    for (int c = 0; c < 4; ++c) {
      const double place = clamp(color[std::size_t(c)]) * double(table.entries.size() - 1);
      double ignored = 0;
      if (!operand(table.format, {}, c, ignored))
        continue;
      if (isBetween(place) || std::isnan(place)) {
        color[std::size_t(c)] = std::nan("");
        continue;
      }
      double value = 0;
      (void)operand(table.format, table.entries[std::size_t(std::floor(place + 0.5))], c, value);
      color[std::size_t(c)] = value;
    }
}

Color sourceColor(const Image &image, const Border &border, int x, int y) {
  const bool outside = x < 0 || y < 0 || x >= image.width || y >= image.height;
  if (outside && border.mode == GL_CONSTANT_BORDER)
    return border.color;
  const int column = std::min(std::max(x, 0), image.width - 1);
  const int line = std::min(std::max(y, 0), image.height - 1);
  return image.colors[std::size_t(line * image.width + column)];
}

Image convolve(const Filter &filter, const Border &border, const Image &image) {
  const bool reduces = border.mode == GL_REDUCE;
  const int halfX = filter.width / 2, halfY = filter.height / 2;
  Image result;
  result.width = reduces ? std::max(image.width - filter.width + 1, 0) : image.width;
  result.height = reduces ? std::max(image.height - filter.height + 1, 0) : image.height;
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const int left = reduces ? x : x - halfX, bottom = reduces ? y : y - halfY;
      Color sum = sourceColor(image, border, left + halfX, bottom + halfY);
      for (int c = 0; c < 4; ++c) {
        double value = 0, total = 0, ignored = 0;
        if (!operand(filter.format, filter.weights[0], c, ignored))
          continue;
        for (int m = 0; m < filter.height; ++m)
          for (int n = 0; n < filter.width; ++n) {
            (void)operand(filter.format, filter.weights[std::size_t(m * filter.width + n)], c,
                          value);
            total += value * sourceColor(image, border, left + n, bottom + m)[std::size_t(c)];
          }
        sum[std::size_t(c)] = total;
      }
      result.colors.push_back(sum);
    }
  return result;
}

Filter productOf(const Filter &row, const Filter &column) {
  Filter result{row.format, row.width, column.width, {}};
  for (const Color &y : column.weights)
    for (const Color &x : row.weights)
      result.weights.push_back({x[0] * y[0], x[1] * y[1], x[2] * y[2], x[3] * y[3]});
  return result;
}

void transform(const std::array<double, 16> &m, Image &image) {
  for (Color &color : image.colors) {
    Color result{};
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = 0; j < 4; ++j)
        result[i] += m[j * 4 + i] * color[j];
    color = result;
  }
}

bool isCounted(GLenum format, int component) {
  double ignored = 0;
  const bool luminance = format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;
  return operand(format, {}, component, ignored) &&
         !(luminance && (component == 1 || component == 2));
}

} // namespace

Image Model::transfer(const Image &source, int dimensions) {
  Image image = source;
  scale(first, image);
  if (tableOn[0])
    look(tables[0], image);
  const bool line = dimensions == 1 && convolution1D;
  const bool plane = dimensions == 2 && (convolution2D || separable);
  if (line)
    image = convolve(filter1D, borders[0], image);
  else if (plane && convolution2D)
    image = convolve(filter2D, borders[1], image);
  else if (plane)
    image = convolve(productOf(row, column), borders[2], image);
  if (line || plane)
    scale(postConvolution, image);
  if (tableOn[1])
    look(tables[1], image);
  transform(matrix, image);
  scale(postColorMatrix, image);
  if (tableOn[2])
    look(tables[2], image);
  for (const Color &color : image.colors)
    for (int c = 0; c < 4; ++c) {
      const double value = color[std::size_t(c)];
      if (histogramOn && isCounted(histogramFormat, c))
        ++histogram[std::size_t(std::floor(clamp(value) * double(histogram.size() - 1) + 0.5))]
                   [std::size_t(c)];
      if (minmaxOn) {
        least[std::size_t(c)] = std::min(least[std::size_t(c)], value);
        most[std::size_t(c)] = std::max(most[std::size_t(c)], value);
      }
    }
  return image;
}

Image imageOf(const std::vector<GLubyte> &bytes, int width, int height) {
  Image image{width, height, {}};
  for (std::size_t i = 0; i + 3 < bytes.size(); i += 4)
    image.colors.push_back(
        {bytes[i] / 255.0, bytes[i + 1] / 255.0, bytes[i + 2] / 255.0, bytes[i + 3] / 255.0});
  return image;
}

std::vector<GLubyte> randomBytes(std::mt19937 &random, int count) {
  std::vector<GLubyte> bytes(std::size_t(count), 0);
  for (GLubyte &byte : bytes)
    byte = GLubyte(random() & 255u);
  return bytes;
}

int differences(const Image &image, const GLubyte *bytes) {
  constexpr double kHalfWay = 1e-3; // in steps: floats on the way have 24 bits
  int count = 0;
  for (const Color &color : image.colors)
    for (const double component : color) {
      if (std::isnan(component)) {
        ++bytes;
        continue;
      }
      const double steps = clamp(component) * 255.0;
      const double fraction = steps - std::floor(steps);
      const int low = int(std::floor(steps)), byte = *bytes++;
      if (std::abs(fraction - 0.5) < kHalfWay ? byte != low && byte != low + 1
                                              : byte != int(std::floor(steps + 0.5)))
        ++count;
    }
  return count;
}

} // namespace api::imaging
