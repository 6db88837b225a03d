#include "state/imaging/imaging_state.h"

#include <algorithm>

#include "state/core/core_context.h"

namespace arbiter::state {

bool ImagingState::isActive(CoreContext &context) {
  return settings.enabled != 0 || !(settings.postColorMatrix == imaging::ScaleBias{}) ||
         colorMatrix.top(context) != imaging::kIdentity;
}

int tableOf(GLenum target, bool &proxy) {
  proxy = target >= GL_PROXY_COLOR_TABLE && target <= GL_PROXY_POST_COLOR_MATRIX_COLOR_TABLE;
  const GLenum first = proxy ? GLenum(GL_PROXY_COLOR_TABLE) : GLenum(GL_COLOR_TABLE);
  return target - first < 3u ? int(target - first) : -1;
}

int filterTargetOf(GLenum target) {
  return target - GL_CONVOLUTION_1D < 3u ? int(target - GL_CONVOLUTION_1D) : -1;
}

unsigned imagingBitOf(GLenum cap) {
  using imaging::Stage;
  switch (cap) {
  case GL_COLOR_TABLE:
    return bitOf(Stage::ColorTable);
  case GL_POST_CONVOLUTION_COLOR_TABLE:
    return bitOf(Stage::PostConvolutionTable);
  case GL_POST_COLOR_MATRIX_COLOR_TABLE:
    return bitOf(Stage::PostColorMatrixTable);
  case GL_CONVOLUTION_1D:
    return bitOf(Stage::Convolution1D);
  case GL_CONVOLUTION_2D:
    return bitOf(Stage::Convolution2D);
  case GL_SEPARABLE_2D:
    return bitOf(Stage::Separable2D);
  case GL_HISTOGRAM:
    return bitOf(Stage::Histogram);
  case GL_MINMAX:
    return bitOf(Stage::Minmax);
  default:
    return 0;
  }
}

float *imagingTransfer(imaging::Settings &settings, GLenum pname) {
  const auto find = [&](GLenum first, imaging::ScaleBias &values) -> float * {
    const GLenum at = pname - first; // four scales, then four biases
    if (at >= 8u)
      return nullptr;
    return at < 4 ? &values.scale[at] : &values.bias[at - 4];
  };
  if (float *const value = find(GL_POST_CONVOLUTION_RED_SCALE, settings.postConvolution))
    return value;
  return find(GL_POST_COLOR_MATRIX_RED_SCALE, settings.postColorMatrix);
}

namespace {
imaging::Matrix transposed(const imaging::Matrix &matrix) {
  imaging::Matrix result;
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t column = 0; column < 4; ++column)
      result[row * 4 + column] = matrix[column * 4 + row];
  return result;
}
} // namespace

int imagingValues(CoreContext &context, GLenum pname, std::array<GLfloat, 16> &values) {
  ImagingState &state = *context.imaging;
  if (const unsigned bit = imagingBitOf(pname)) {
    values[0] = (state.settings.enabled & bit) != 0 ? 1.0f : 0.0f;
    return 1;
  }
  if (const float *const value = imagingTransfer(state.settings, pname)) {
    values[0] = *value;
    return 1;
  }
  switch (pname) {
  case GL_COLOR_MATRIX:
    values = state.colorMatrix.top(context);
    return 16;
  case GL_TRANSPOSE_COLOR_MATRIX:
    values = transposed(state.colorMatrix.top(context));
    return 16;
  case GL_COLOR_MATRIX_STACK_DEPTH:
    values[0] = GLfloat(state.colorMatrix.depth(context));
    return 1;
  case GL_MAX_COLOR_MATRIX_STACK_DEPTH:
    values[0] = GLfloat(ColorMatrix::maxDepth(context));
    return 1;
  case GL_MATRIX_MODE:
    values[0] = GL_COLOR;
    return context.imagesPixels && state.colorMatrix.isCurrent(context) ? 1 : 0;
  default:
    return 0;
  }
}

} // namespace arbiter::state
