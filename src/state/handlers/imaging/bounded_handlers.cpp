// The commands of ARB_robustness and OpenGL 4.5 that read pixels into memory of a given size, for
// the layer's ARB_imaging.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/imaging/pixel_types.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/raster_draw/commands.h"

namespace arbiter::state {

namespace {

/// True if the pixels fit. Otherwise raises INVALID_OPERATION.
bool hasRoom(Context &context, GLsizei bytes, int width, int height, GLenum format, GLenum type) {
  if (fits(context, bytes, width, height, format, type))
    return true;
  raise(context, GL_INVALID_OPERATION, "a query of pixels: bufSize is too small");
  return false;
}

bool hasRoom(Context &context, GLsizei bytes, const imaging::Pixels &image, GLenum format,
             GLenum type) {
  return hasRoom(context, bytes, image.width, image.height, format, type);
}

/// True if the table fits. For an invalid target the size is 0, and the command itself raises the
/// error.
bool hasRoomForTable(Context &context, GLenum target, GLenum format, GLenum type, GLsizei bytes) {
  bool proxy = false;
  const int table = tableOf(target, proxy);
  const bool known = table >= 0 && !proxy;
  const auto &tables = context.imaging->contents.tables;
  return hasRoom(context, bytes, known ? int(tables[std::size_t(table)].entries.size()) : 0, 1,
                 format, type);
}

bool hasRoomForFilter(Context &context, GLenum target, GLenum format, GLenum type, GLsizei bytes) {
  const int filter = filterTargetOf(target);
  const auto &filters = context.imaging->contents.filters;
  return filter < 0 || filter == 2 ||
         hasRoom(context, bytes, filters[std::size_t(filter)].image, format, type);
}

} // namespace

namespace handlers {

#define BOUNDED(Suffix)                                                                            \
  void GetnColorTable##Suffix(Context &context, GLenum target, GLenum format, GLenum type,         \
                              GLsizei bufSize, void *table) {                                      \
    if (hasRoomForTable(context, target, format, type, bufSize))                                   \
      GetColorTable(context, target, format, type, table);                                         \
  }                                                                                                \
  void GetnConvolutionFilter##Suffix(Context &context, GLenum target, GLenum format, GLenum type,  \
                                     GLsizei bufSize, void *image) {                               \
    if (hasRoomForFilter(context, target, format, type, bufSize))                                  \
      GetConvolutionFilter(context, target, format, type, image);                                  \
  }                                                                                                \
  void GetnSeparableFilter##Suffix(Context &context, GLenum target, GLenum format, GLenum type,    \
                                   GLsizei rowBufSize, void *row, GLsizei columnBufSize,           \
                                   void *column, void *span) {                                     \
    const imaging::Contents &contents = context.imaging->contents;                                 \
    if (hasRoom(context, rowBufSize, contents.row.image, format, type) &&                          \
        hasRoom(context, columnBufSize, contents.column.image, format, type))                      \
      GetSeparableFilter(context, target, format, type, row, column, span);                        \
  }                                                                                                \
  void GetnHistogram##Suffix(Context &context, GLenum target, GLboolean reset, GLenum format,      \
                             GLenum type, GLsizei bufSize, void *values) {                         \
    if (hasRoom(context, bufSize, int(context.imaging->contents.histogram.bins.size()), 1, format, \
                type))                                                                             \
      GetHistogram(context, target, reset, format, type, values);                                  \
  }                                                                                                \
  void GetnMinmax##Suffix(Context &context, GLenum target, GLboolean reset, GLenum format,         \
                          GLenum type, GLsizei bufSize, void *values) {                            \
    if (hasRoom(context, bufSize, 2, 1, format, type))                                             \
      GetMinmax(context, target, reset, format, type, values);                                     \
  }
BOUNDED()
BOUNDED(ARB)
#undef BOUNDED

void ReadnPixels(Context &context, GLint x, GLint y, GLsizei width, GLsizei height, GLenum format,
                 GLenum type, GLsizei bufSize, void *data) {
  if (context.imagesPixels && !context.insideBeginEnd && context.imaging->isActive(context)) {
    if (!hasRoom(context, bufSize, width, height, format, type) ||
        imagedReadPixels(context, x, y, width, height, format, type, data))
      return;
  }
  if (context.softwareListens)
    hostReads(context, "glReadnPixels");
  context.host->ReadnPixels(x, y, width, height, format, type, bufSize, data);
}

} // namespace handlers
} // namespace arbiter::state
