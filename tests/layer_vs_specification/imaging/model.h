#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <epoxy/gl.h>

/// Pixel transfer with ARB_imaging by OpenGL 2.1's section 3.6.5, in plain C++ and double
/// precision. It shares nothing with the layer.
namespace api::imaging {

using Color = std::array<double, 4>;

struct Image {
  int width = 0, height = 1;
  std::vector<Color> colors; ///< row by row
};

struct Table {
  GLenum format = GL_RGBA;
  std::vector<Color> entries; ///< 8-bit values, as given
};

struct Filter {
  GLenum format = GL_RGBA;
  int width = 0, height = 1;
  std::vector<Color> weights;
};

struct Border {
  GLenum mode = GL_REDUCE;
  Color color{};
};

struct ScaleBias {
  Color scale = {1, 1, 1, 1};
  Color bias{};
};

/// All state of a transfer of colors, except the maps.
struct Model {
  ScaleBias first, postConvolution, postColorMatrix;
  std::array<bool, 3> tableOn{};
  std::array<Table, 3> tables;
  bool convolution1D = false, convolution2D = false, separable = false;
  Filter filter1D, filter2D, row, column;
  std::array<Border, 3> borders; ///< of the 1D, the 2D and the separable filter
  std::array<double, 16> matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool histogramOn = false, minmaxOn = false;
  GLenum histogramFormat = GL_RGBA;
  std::vector<std::array<std::uint32_t, 4>> histogram;
  Color least = {1e30, 1e30, 1e30, 1e30}, most = {-1e30, -1e30, -1e30, -1e30};

  /// Transfers an image. A component is NaN if two table entries are equally near, and so is what
  /// follows from it.
  /// \param dimensions of the image: a filter with as many applies
  [[nodiscard]] Image transfer(const Image &image, int dimensions);
};

/// Returns random state with weights and matrices of few bits, so that results are exact.
[[nodiscard]] Model randomModel(std::mt19937 &random);
/// Sets the state in GL, which must be in its initial state.
void apply(const Model &model);
/// Restores the initial state.
void reset();

/// Makes an image of bytes, four for each pixel.
[[nodiscard]] Image imageOf(const std::vector<GLubyte> &bytes, int width, int height);
[[nodiscard]] std::vector<GLubyte> randomBytes(std::mt19937 &random, int count);

/// Returns how many bytes differ from the image's colors, clamped, scaled by 255 and rounded. A
/// value half-way between two may be either; NaN may be anything.
[[nodiscard]] int differences(const Image &image, const GLubyte *bytes);

} // namespace api::imaging
