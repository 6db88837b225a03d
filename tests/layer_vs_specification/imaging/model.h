#pragma once
#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <epoxy/gl.h>

/// Pixel transfer with ARB_imaging as OpenGL 2.1's section 3.6.5 has it, in plain C++ and in double
/// precision. It shares nothing with the layer.
namespace api::imaging {

using Color = std::array<double, 4>;

struct Image {
  int width = 0, height = 1;
  std::vector<Color> colors; ///< row after row
};

struct Table {
  GLenum format = GL_RGBA;
  std::vector<Color> entries; ///< of 8 bits each, as they were given
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

/// All state of a transfer of colours, but the maps.
struct Model {
  ScaleBias first, postConvolution, postColorMatrix;
  std::array<bool, 3> tableOn{};
  std::array<Table, 3> tables;
  bool convolution1D = false, convolution2D = false, separable = false;
  Filter filter1D, filter2D, row, column;
  std::array<Border, 3> borders; ///< of one dimension, of two, of the separable one
  std::array<double, 16> matrix = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  bool histogramOn = false, minmaxOn = false;
  GLenum histogramFormat = GL_RGBA;
  std::vector<std::array<std::uint32_t, 4>> histogram;
  Color least = {1e30, 1e30, 1e30, 1e30}, most = {-1e30, -1e30, -1e30, -1e30};

  /// A component for which two entries of a table were equally near becomes no number, and so what
  /// is made of it.
  /// \param dimensions of the image: a filter of as many applies
  [[nodiscard]] Image transfer(const Image &image, int dimensions);
};

/// State that is chosen at random: weights and matrices of few bits, so that results are exact.
[[nodiscard]] Model randomModel(std::mt19937 &random);
/// Gives it to GL, whose state is as at first.
void apply(const Model &model);
/// All of it as at first again.
void reset();

/// The image of bytes, four a pixel.
[[nodiscard]] Image imageOf(const std::vector<GLubyte> &bytes, int width, int height);
[[nodiscard]] std::vector<GLubyte> randomBytes(std::mt19937 &random, int count);

/// How many bytes differ from the image's colours, clamped, scaled by 255 and rounded. A value that
/// is half-way between two may be either of them; one that is no number may be anything.
[[nodiscard]] int differences(const Image &image, const GLubyte *bytes);

} // namespace api::imaging
