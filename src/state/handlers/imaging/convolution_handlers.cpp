// Convolution filters (ARB_imaging), for hosts without them.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/imaging/formats.h"
#include "state/imaging/imaging_state.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/pixel_commands/imaging_queries.h"
#include "state/pixel_commands/transfer.h"

namespace arbiter::state {

namespace {

using Kind = ImagingCommand::Kind;

bool convolutionAllowed(Context &context) {
  return outsideBeginEnd(context, "a convolution's command between Begin and End");
}

bool isInRange(GLsizei size) { return size > 0 && size <= ImagingState::kMaxFilter; }

/// Appends an image in memory to the colours. Returns false after an error. Reads nothing if the
/// size is an error.
bool read(Context &context, const ImageInMemory &image, const void *pixels,
          std::vector<imaging::Rgba> &colors) {
  if (!isColorFormat(image.format) || image.format == GL_COLOR_INDEX) {
    raise(context, GL_INVALID_ENUM, "ConvolutionFilter: format");
    return false;
  }
  if (!isInRange(image.width) || !isInRange(image.height))
    return arePixels(context, image.format, image.type);
  const auto read = unpackPixels(context, image, pixels);
  if (read)
    colors.insert(colors.end(), read->texels.begin(), read->texels.end());
  return read.has_value();
}

/// True for the command's own target. Otherwise raises an error: each command has just one.
bool isTarget(Context &context, GLenum target, GLenum only) {
  if (target == only)
    return true;
  raise(context, GL_INVALID_ENUM, "ConvolutionFilter: target");
  return false;
}

void issueFilter(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                 GLsizei height, const std::vector<imaging::Rgba> &colors) {
  issueImaging(context,
               {.kind = Kind::Filter,
                .target = target,
                .pname = internalformat,
                .width = width,
                .height = height},
               colors);
}

void copyFilter(Context &context, GLenum target, GLenum only, const ImagingCommand &command) {
  if (!convolutionAllowed(context) || !isTarget(context, target, only))
    return;
  if (command.width > ImagingState::kMaxFilter || command.height > ImagingState::kMaxFilter)
    return raise(context, GL_INVALID_VALUE, "CopyConvolutionFilter: a size");
  issueImaging(context, command);
}

/// Converts a colour component: integers stand for -1 to 1 (OpenGL 2.1, table 2.9).
template <typename T> float colorValue(T value) {
  if constexpr (std::is_integral_v<T>)
    return float((2.0 * double(value) + 1.0) / 4294967295.0);
  else
    return value;
}

template <typename T>
void setParameter(Context &context, GLenum target, GLenum pname, const T *params, bool scalar) {
  if (!convolutionAllowed(context))
    return;
  ImagingCommand command{
      .kind = Kind::FilterParameter, .flag = scalar, .target = target, .pname = pname};
  const bool color = pname == GL_CONVOLUTION_BORDER_COLOR;
  const bool four =
      color || pname == GL_CONVOLUTION_FILTER_SCALE || pname == GL_CONVOLUTION_FILTER_BIAS;
  if (pname == GL_CONVOLUTION_BORDER_MODE)
    command.values[0] = float(params[0]);
  for (std::size_t c = 0; four && !scalar && c < 4; ++c)
    command.values[c] = color ? colorValue(params[c]) : float(params[c]);
  issueImaging(context, command);
}

template <typename T> void giveBorderColor(const imaging::Rgba &color, T *to) {
  for (std::size_t c = 0; c < 4; ++c)
    if constexpr (std::is_integral_v<T>)
      to[c] = wholeNumber<T>((4294967295.0 * double(color[c]) - 1.0) / 2.0);
    else
      to[c] = color[c];
}

template <typename T>
void getConvolutionValue(Context &context, GLenum target, GLenum pname, T *params) {
  if (!convolutionAllowed(context))
    return;
  const int number = filterTargetOf(target);
  if (number < 0)
    return raise(context, GL_INVALID_ENUM, "GetConvolutionParameter: target");
  const imaging::Settings &settings = context.imaging->settings;
  const imaging::Contents &contents = context.imaging->contents;
  const auto at = std::size_t(number);
  const imaging::Filter &filter = number == 2 ? contents.row : contents.filters[at];
  switch (pname) {
  case GL_CONVOLUTION_BORDER_MODE:
    *params = T(GLint(settings.borders[at].mode));
    return;
  case GL_CONVOLUTION_BORDER_COLOR:
    return giveBorderColor(settings.borders[at].color, params);
  case GL_CONVOLUTION_FILTER_SCALE:
    return giveColor(settings.filters[at].scale, params);
  case GL_CONVOLUTION_FILTER_BIAS:
    return giveColor(settings.filters[at].bias, params);
  case GL_CONVOLUTION_FORMAT:
    *params = T(GLint(filter.format));
    return;
  case GL_CONVOLUTION_WIDTH:
    *params = T(filter.image.width);
    return;
  case GL_CONVOLUTION_HEIGHT:
    *params = T(number == 2      ? contents.column.image.width
                : filter.empty() ? 0
                                 : filter.image.height);
    return;
  case GL_MAX_CONVOLUTION_WIDTH:
    *params = T(ImagingState::kMaxFilter);
    return;
  case GL_MAX_CONVOLUTION_HEIGHT:
    *params = T(number == 0 ? 1 : ImagingState::kMaxFilter);
    return;
  default:
    raise(context, GL_INVALID_ENUM, "GetConvolutionParameter: pname");
  }
}

} // namespace

namespace handlers {

void ConvolutionFilter1D(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                         GLenum format, GLenum type, const void *image) {
  std::vector<imaging::Rgba> colors;
  if (convolutionAllowed(context) && isTarget(context, target, GL_CONVOLUTION_1D) &&
      read(context, {.dimensions = 1, .width = width, .format = format, .type = type}, image,
           colors))
    issueFilter(context, target, internalformat, width, ImagingCommand{}.height, colors);
}

void ConvolutionFilter2D(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                         GLsizei height, GLenum format, GLenum type, const void *image) {
  std::vector<imaging::Rgba> colors;
  if (convolutionAllowed(context) && isTarget(context, target, GL_CONVOLUTION_2D) &&
      read(context, {.width = width, .height = height, .format = format, .type = type}, image,
           colors))
    issueFilter(context, target, internalformat, width, height, colors);
}

void SeparableFilter2D(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                       GLsizei height, GLenum format, GLenum type, const void *row,
                       const void *column) {
  std::vector<imaging::Rgba> colors;
  const bool inRange = isInRange(width) && isInRange(height); // else nothing is read
  if (convolutionAllowed(context) && isTarget(context, target, GL_SEPARABLE_2D) &&
      read(context, {.dimensions = 1, .width = inRange ? width : 0, .format = format, .type = type},
           row, colors) &&
      read(context,
           {.dimensions = 1, .width = inRange ? height : 0, .format = format, .type = type}, column,
           colors))
    issueFilter(context, target, internalformat, width, height, colors);
}

void CopyConvolutionFilter1D(Context &context, GLenum target, GLenum internalformat, GLint x,
                             GLint y, GLsizei width) {
  copyFilter(context, target, GL_CONVOLUTION_1D,
             {.kind = Kind::CopyFilter,
              .target = target,
              .pname = internalformat,
              .x = x,
              .y = y,
              .width = width});
}

void CopyConvolutionFilter2D(Context &context, GLenum target, GLenum internalformat, GLint x,
                             GLint y, GLsizei width, GLsizei height) {
  copyFilter(context, target, GL_CONVOLUTION_2D,
             {.kind = Kind::CopyFilter,
              .target = target,
              .pname = internalformat,
              .x = x,
              .y = y,
              .width = width,
              .height = height});
}

#define SET_PARAMETER(name, Value, pointer, scalar)                                                \
  void name(Context &context, GLenum target, GLenum pname, Value params) {                         \
    setParameter(context, target, pname, pointer, scalar);                                         \
  }
SET_PARAMETER(ConvolutionParameterf, GLfloat, &params, true)
SET_PARAMETER(ConvolutionParameteri, GLint, &params, true)
SET_PARAMETER(ConvolutionParameterfv, const GLfloat *, params, false)
SET_PARAMETER(ConvolutionParameteriv, const GLint *, params, false)
#undef SET_PARAMETER

void GetConvolutionFilter(Context &context, GLenum target, GLenum format, GLenum type,
                          void *image) {
  if (!convolutionAllowed(context))
    return;
  const int number = filterTargetOf(target);
  if (number < 0 || number == 2)
    return raise(context, GL_INVALID_ENUM, "GetConvolutionFilter: target");
  const imaging::Filter &filter = context.imaging->contents.filters[std::size_t(number)];
  returnImage(context, filter.format, filter.image, format, type, image);
}

void GetSeparableFilter(Context &context, GLenum target, GLenum format, GLenum type, void *row,
                        void *column, void * /*span*/) {
  if (!convolutionAllowed(context))
    return;
  if (target != GL_SEPARABLE_2D)
    return raise(context, GL_INVALID_ENUM, "GetSeparableFilter: target");
  const imaging::Contents &contents = context.imaging->contents;
  if (returnImage(context, contents.row.format, contents.row.image, format, type, row))
    returnImage(context, contents.column.format, contents.column.image, format, type, column);
}

void GetConvolutionParameterfv(Context &context, GLenum target, GLenum pname, GLfloat *params) {
  getConvolutionValue(context, target, pname, params);
}

void GetConvolutionParameteriv(Context &context, GLenum target, GLenum pname, GLint *params) {
  getConvolutionValue(context, target, pname, params);
}

} // namespace handlers
} // namespace arbiter::state
