#include "state/pixel_commands/imaging_state_commands.h"

#include <algorithm>

#include "state/core/errors.h"
#include "state/imaging/formats.h"
#include "state/imaging/imaging_state.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

/// True for a valid table size: a power of two, or 0.
bool isPower(GLsizei width) { return width >= 0 && (width & (width - 1)) == 0; }

std::vector<imaging::Rgba> scaled(const imaging::ScaleBias &by,
                                  const std::vector<imaging::Rgba> &colors) {
  std::vector<imaging::Rgba> result(colors.size());
  std::transform(colors.begin(), colors.end(), result.begin(),
                 [&](const imaging::Rgba &color) { return by.apply(color); });
  return result;
}

/// Makes a filter of the components that its format has, unclamped.
imaging::Filter filterFrom(GLenum format, GLsizei width, GLsizei height,
                           const std::vector<imaging::Rgba> &colors) {
  imaging::Filter filter{format, {width, height, 1, {}}};
  for (const imaging::Rgba &color : colors)
    filter.image.texels.push_back(select(imaging::baseOf(format), color));
  return filter;
}

} // namespace

GLenum tableError(const ImagingCommand &command) {
  bool proxy = false;
  const int number = tableOf(command.target, proxy);
  const bool copies = command.kind == ImagingCommand::Kind::CopyTable;
  if (number < 0 || (proxy && copies) || !imaging::findFormat(command.pname))
    return GL_INVALID_ENUM;
  if (!isPower(command.width))
    return GL_INVALID_VALUE;
  return !proxy && command.width > ImagingState::kMaxEntries ? GLenum(GL_TABLE_TOO_LARGE)
                                                             : GLenum(GL_NO_ERROR);
}

void setColorTable(RasterContext &context, const ImagingCommand &command,
                   const std::vector<imaging::Rgba> &colors) {
  ImagingState &state = *context.imaging;
  if (const GLenum error = tableError(command); error != GL_NO_ERROR)
    return raise(context, error, "ColorTable: target, internal format or width");
  bool proxy = false;
  const int number = tableOf(command.target, proxy);
  if (proxy) {
    state.proxyTables[std::size_t(number)] = command.width > ImagingState::kMaxEntries
                                                 ? ProxyTable{0}
                                                 : ProxyTable{command.pname, command.width};
    return;
  }
  imaging::ColorTable &table = state.contents.tables[std::size_t(number)];
  table = {command.pname, std::vector<imaging::Rgba>(std::size_t(command.width))};
  table.set(0, scaled(state.settings.tables[std::size_t(number)], colors));
}

GLenum subTableError(const RasterContext &context, const ImagingCommand &command) {
  bool proxy = false;
  const int number = tableOf(command.target, proxy);
  if (number < 0 || proxy)
    return GL_INVALID_ENUM;
  const auto &entries = context.imaging->contents.tables[std::size_t(number)].entries;
  const bool inside = command.start >= 0 && command.width >= 0 &&
                      std::size_t(command.start) + std::size_t(command.width) <= entries.size();
  return inside ? GLenum(GL_NO_ERROR) : GLenum(GL_INVALID_VALUE);
}

void setColorSubTable(RasterContext &context, const ImagingCommand &command,
                      const std::vector<imaging::Rgba> &colors) {
  ImagingState &state = *context.imaging;
  if (const GLenum error = subTableError(context, command); error != GL_NO_ERROR)
    return raise(context, error, "ColorSubTable: target, start or count");
  bool proxy = false;
  const int number = tableOf(command.target, proxy);
  imaging::ColorTable &table = state.contents.tables[std::size_t(number)];
  table.set(std::size_t(command.start), scaled(state.settings.tables[std::size_t(number)], colors));
}

void setTableParameter(RasterContext &context, const ImagingCommand &command) {
  bool proxy = false;
  const int number = tableOf(command.target, proxy);
  if (number < 0 || proxy ||
      (command.pname != GL_COLOR_TABLE_SCALE && command.pname != GL_COLOR_TABLE_BIAS))
    return raise(context, GL_INVALID_ENUM, "ColorTableParameter: target or pname");
  imaging::ScaleBias &to = context.imaging->settings.tables[std::size_t(number)];
  (command.pname == GL_COLOR_TABLE_SCALE ? to.scale : to.bias) = command.values;
}

void setFilter(RasterContext &context, const ImagingCommand &command,
               const std::vector<imaging::Rgba> &colors) {
  ImagingState &state = *context.imaging;
  const int number = filterTargetOf(command.target);
  if (number < 0 || !imaging::findFormat(command.pname))
    return raise(context, GL_INVALID_ENUM, "ConvolutionFilter: target or internal format");
  if (command.width < 0 || command.height < 0 || command.width > ImagingState::kMaxFilter ||
      command.height > ImagingState::kMaxFilter)
    return raise(context, GL_INVALID_VALUE, "ConvolutionFilter: a size");
  const std::vector<imaging::Rgba> values =
      scaled(state.settings.filters[std::size_t(number)], colors);
  if (number != 2) {
    state.contents.filters[std::size_t(number)] =
        filterFrom(command.pname, command.width, command.height, values);
    return;
  }
  if (values.size() != std::size_t(command.width) + std::size_t(command.height)) {
    state.contents.row = state.contents.column = {command.pname, {}}; // one of them has no weights
    return;
  }
  const auto middle = values.begin() + command.width; // the column follows the row
  state.contents.row = filterFrom(command.pname, command.width, 1, {values.begin(), middle});
  state.contents.column = filterFrom(command.pname, command.height, 1, {middle, values.end()});
}

void setFilterParameter(RasterContext &context, const ImagingCommand &command) {
  const int number = filterTargetOf(command.target);
  if (number < 0)
    return raise(context, GL_INVALID_ENUM, "ConvolutionParameter: target");
  imaging::Settings &settings = context.imaging->settings;
  imaging::Border &border = settings.borders[std::size_t(number)];
  const GLenum mode = imaging::nameOf(command.values[0]);
  if (command.pname == GL_CONVOLUTION_BORDER_MODE) {
    if (mode != GL_REDUCE && mode != GL_CONSTANT_BORDER && mode != GL_REPLICATE_BORDER)
      return raise(context, GL_INVALID_ENUM, "ConvolutionParameter: border mode");
    border.mode = mode;
    return;
  }
  imaging::ScaleBias &filter = settings.filters[std::size_t(number)];
  // A command with one value cannot set a parameter of four.
  imaging::Rgba *const to = command.flag                                   ? nullptr
                            : command.pname == GL_CONVOLUTION_BORDER_COLOR ? &border.color
                            : command.pname == GL_CONVOLUTION_FILTER_SCALE ? &filter.scale
                            : command.pname == GL_CONVOLUTION_FILTER_BIAS  ? &filter.bias
                                                                           : nullptr;
  if (!to)
    return raise(context, GL_INVALID_ENUM, "ConvolutionParameter: pname");
  *to = command.values;
}

namespace {
/// True for formats of histograms and minmax tables, which have no intensity.
bool counts(GLenum format) {
  const imaging::Format *const found = imaging::findFormat(format);
  return found && found->base != imaging::Base::Intensity;
}
} // namespace

void setHistogram(RasterContext &context, const ImagingCommand &command) {
  ImagingState &state = *context.imaging;
  const bool proxy = command.target == GL_PROXY_HISTOGRAM;
  if ((!proxy && command.target != GL_HISTOGRAM) || !counts(command.pname))
    return raise(context, GL_INVALID_ENUM, "Histogram: target or internal format");
  if (!isPower(command.width))
    return raise(context, GL_INVALID_VALUE, "Histogram: width is no power of two");
  const bool tooLarge = command.width > ImagingState::kMaxEntries;
  if (proxy) {
    state.proxyHistogram =
        tooLarge ? ProxyTable{0} : ProxyTable{command.pname, command.width, command.flag};
    return;
  }
  if (tooLarge)
    return raise(context, GL_TABLE_TOO_LARGE, "Histogram: width");
  state.contents.histogram = {command.pname, command.flag,
                              std::vector<imaging::Counts>(std::size_t(command.width))};
}

void setMinmax(RasterContext &context, const ImagingCommand &command) {
  if (command.target != GL_MINMAX || !counts(command.pname))
    return raise(context, GL_INVALID_ENUM, "Minmax: target or internal format");
  context.imaging->contents.minmax = {};
  context.imaging->contents.minmax.format = command.pname;
  context.imaging->contents.minmax.sink = command.flag;
}

void resetStatistics(RasterContext &context, GLenum target) {
  imaging::Contents &contents = context.imaging->contents;
  if (target == GL_HISTOGRAM) {
    std::fill(contents.histogram.bins.begin(), contents.histogram.bins.end(), imaging::Counts{});
  } else if (target == GL_MINMAX) {
    contents.minmax.least = imaging::Minmax{}.least;
    contents.minmax.most = imaging::Minmax{}.most;
  } else {
    raise(context, GL_INVALID_ENUM, "ResetHistogram or ResetMinmax: target");
  }
}

} // namespace arbiter::state
