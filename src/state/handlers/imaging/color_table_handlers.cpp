// Colour tables (ARB_imaging), for hosts without them.
#include <cmath>
#include <type_traits>

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

bool colorTableAllowed(Context &context) {
  return outsideBeginEnd(context, "a colour table's command between Begin and End");
}

/// Issues a command with colours in memory. Reads none if the command's sizes are an error.
void give(Context &context, const ImagingCommand &command, GLenum format, GLenum type,
          const void *data) {
  if (!isColorFormat(format) || format == GL_COLOR_INDEX)
    return raise(context, GL_INVALID_ENUM, "ColorTable: format");
  std::vector<imaging::Rgba> colors;
  if (command.width <= 0 || command.width > ImagingState::kMaxEntries) {
    if (!arePixels(context, format, type))
      return;
  } else {
    const auto image = unpackPixels(
        context, {.dimensions = 1, .width = command.width, .format = format, .type = type}, data);
    if (!image)
      return;
    colors = image->texels;
  }
  issueImaging(context, command, colors);
}

template <typename T>
void setParameter(Context &context, GLenum target, GLenum pname, const T *params) {
  ImagingCommand command{.kind = Kind::TableParameter, .target = target, .pname = pname};
  if (!colorTableAllowed(context))
    return;
  if (pname == GL_COLOR_TABLE_SCALE || pname == GL_COLOR_TABLE_BIAS)
    for (std::size_t c = 0; c < 4; ++c)
      command.values[c] = float(params[c]);
  issueImaging(context, command);
}

/// Returns the row of Format::bits for the name of a size; -1 for other names.
int sizeRow(GLenum pname) {
  const GLenum at = pname - GL_COLOR_TABLE_RED_SIZE;
  return at < 6 ? int(at) : -1;
}

template <typename T>
void getColorTableValue(Context &context, GLenum target, GLenum pname, T *params) {
  if (!colorTableAllowed(context))
    return;
  const ImagingState &state = *context.imaging;
  bool proxy = false;
  const int number = tableOf(target, proxy);
  if (number < 0)
    return raise(context, GL_INVALID_ENUM, "GetColorTableParameter: target");
  const auto table = std::size_t(number);
  const ProxyTable about = proxy ? state.proxyTables[table]
                                 : ProxyTable{state.contents.tables[table].format,
                                              GLsizei(state.contents.tables[table].entries.size())};
  if (!proxy && pname == GL_COLOR_TABLE_SCALE)
    return giveColor(state.settings.tables[table].scale, params);
  if (!proxy && pname == GL_COLOR_TABLE_BIAS)
    return giveColor(state.settings.tables[table].bias, params);
  const int row = sizeRow(pname);
  const imaging::Format *const format = imaging::findFormat(about.format);
  if (pname == GL_COLOR_TABLE_FORMAT)
    *params = T(GLint(about.format));
  else if (pname == GL_COLOR_TABLE_WIDTH)
    *params = T(about.width);
  else if (row >= 0)
    *params = T(format && about.width != 0 ? format->bits[std::size_t(row)] : 0);
  else
    raise(context, GL_INVALID_ENUM, "GetColorTableParameter: pname");
}

} // namespace

namespace handlers {

void ColorTable(Context &context, GLenum target, GLenum internalformat, GLsizei width,
                GLenum format, GLenum type, const void *table) {
  if (!colorTableAllowed(context))
    return;
  const ImagingCommand command{
      .kind = Kind::Table, .target = target, .pname = internalformat, .width = width};
  bool proxy = false;
  if (tableOf(target, proxy) >= 0 && proxy) { // executed at once, without reading memory
    if (!isColorFormat(format) || format == GL_COLOR_INDEX)
      return raise(context, GL_INVALID_ENUM, "ColorTable: format");
    if (arePixels(context, format, type))
      executeImaging(context, command, {});
    return;
  }
  give(context, command, format, type, table);
}

void ColorSubTable(Context &context, GLenum target, GLsizei start, GLsizei count, GLenum format,
                   GLenum type, const void *data) {
  if (colorTableAllowed(context))
    give(context, {.kind = Kind::SubTable, .target = target, .start = start, .width = count},
         format, type, data);
}

void CopyColorTable(Context &context, GLenum target, GLenum internalformat, GLint x, GLint y,
                    GLsizei width) {
  if (colorTableAllowed(context))
    issueImaging(context, {.kind = Kind::CopyTable,
                           .target = target,
                           .pname = internalformat,
                           .x = x,
                           .y = y,
                           .width = width});
}

void CopyColorSubTable(Context &context, GLenum target, GLsizei start, GLint x, GLint y,
                       GLsizei width) {
  if (colorTableAllowed(context))
    issueImaging(context, {.kind = Kind::CopySubTable,
                           .target = target,
                           .start = start,
                           .x = x,
                           .y = y,
                           .width = width});
}

void ColorTableParameterfv(Context &context, GLenum target, GLenum pname, const GLfloat *params) {
  setParameter(context, target, pname, params);
}

void ColorTableParameteriv(Context &context, GLenum target, GLenum pname, const GLint *params) {
  setParameter(context, target, pname, params);
}

void GetColorTable(Context &context, GLenum target, GLenum format, GLenum type, void *table) {
  if (!colorTableAllowed(context))
    return;
  bool proxy = false;
  const int number = tableOf(target, proxy);
  if (number < 0 || proxy)
    return raise(context, GL_INVALID_ENUM, "GetColorTable: target");
  const imaging::ColorTable &from = context.imaging->contents.tables[std::size_t(number)];
  returnImage(context, from.format, {int(from.entries.size()), 1, 1, from.entries}, format, type,
              table);
}

void GetColorTableParameterfv(Context &context, GLenum target, GLenum pname, GLfloat *params) {
  getColorTableValue(context, target, pname, params);
}

void GetColorTableParameteriv(Context &context, GLenum target, GLenum pname, GLint *params) {
  getColorTableValue(context, target, pname, params);
}

} // namespace handlers
} // namespace arbiter::state
