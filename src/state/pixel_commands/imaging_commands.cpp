#include "state/pixel_commands/imaging_commands.h"

#include <cstring>
#include <type_traits>
#include <utility>

#include "host/host_table.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/pixel_commands/imaging_state_commands.h"
#include "state/pixel_commands/pixel_commands.h"
#include "state/pixel_commands/transfer.h"
#include "state/programs/program_bind.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state {

namespace {

static_assert(std::is_trivially_copyable_v<ImagingCommand>);

template <typename T> void append(std::string &bytes, const T *from, std::size_t count) {
  bytes.append(reinterpret_cast<const char *>(from), count * sizeof(T));
}

void enable(RasterContext &context, const ImagingCommand &command) {
  unsigned &enabled = context.imaging->settings.enabled;
  const unsigned bit = imagingBitOf(command.pname);
  enabled = command.flag ? enabled | bit : enabled & ~bit;
}

/// Sets a table or a filter from the framebuffer's colours.
void copy(RasterContext &context, ImagingCommand command) {
  using Kind = ImagingCommand::Kind;
  const GLenum error = command.kind == Kind::CopyTable      ? tableError(command)
                       : command.kind == Kind::CopySubTable ? subTableError(context, command)
                                                            : GLenum(GL_NO_ERROR);
  if (error != GL_NO_ERROR)
    return raise(context, error, "a copy into a colour table: target, internal format or size");
  const auto pixels = readFramebuffer(context, command.x, command.y, command.width, command.height);
  if (!pixels)
    return;
  if (command.kind == Kind::CopyTable)
    setColorTable(context, command, pixels->texels);
  else if (command.kind == Kind::CopySubTable)
    setColorSubTable(context, command, pixels->texels);
  else
    setFilter(context, command, pixels->texels);
}

void setMatrixMode(RasterContext &context, GLenum mode) {
  ColorMatrix &matrix = context.imaging->colorMatrix;
  if (mode == GL_COLOR)
    return matrix.enter(context);
  matrix.leave(context);
  context.host->MatrixMode(mode);
}

} // namespace

void noteImagingUse(RasterContext &context) {
  context.imagesPixels = true;
  noteProgramApiUse(context);
}

void recordImaging(RasterContext &context, const ImagingCommand &command, const std::string &more,
                   const std::vector<imaging::Rgba> &colors) {
  Command entry{.kind = Command::Kind::Imaging};
  append(entry.bytes, &command, 1);
  entry.bytes += more;
  append(entry.bytes, colors.data(), colors.size());
  context.list->record(context, std::move(entry));
}

void issueImaging(RasterContext &context, const ImagingCommand &command,
                  const std::vector<imaging::Rgba> &colors) {
  noteImagingUse(context);
  if (context.listMode != 0)
    recordImaging(context, command, {}, colors);
  else
    executeImaging(context, command, colors);
}

void executeImaging(RasterContext &context, const ImagingCommand &command,
                    const std::vector<imaging::Rgba> &colors) {
  using Kind = ImagingCommand::Kind;
  switch (command.kind) {
  case Kind::Enable:
    return enable(context, command);
  case Kind::Table:
    return setColorTable(context, command, colors);
  case Kind::SubTable:
    return setColorSubTable(context, command, colors);
  case Kind::CopyTable:
  case Kind::CopySubTable:
  case Kind::CopyFilter:
    return copy(context, command);
  case Kind::TableParameter:
    return setTableParameter(context, command);
  case Kind::Filter:
    return setFilter(context, command, colors);
  case Kind::FilterParameter:
    return setFilterParameter(context, command);
  case Kind::Histogram:
    return setHistogram(context, command);
  case Kind::Minmax:
    return setMinmax(context, command);
  case Kind::Reset:
    return resetStatistics(context, command.target);
  case Kind::Transfer:
    if (float *const value = imagingTransfer(context.imaging->settings, command.pname))
      *value = command.values[0];
    return;
  case Kind::MatrixMode:
    return setMatrixMode(context, command.pname);
  case Kind::DrawPixels:
    return drawImage(context, command, colors);
  case Kind::CopyPixels:
    return copyImage(context, command);
  case Kind::TexImage:
    return;
  }
}

void executeImaging(RasterContext &context, const Command &recorded) {
  if (!context.imaging)
    return raise(context, GL_INVALID_OPERATION, "a list's command of ARB_imaging");
  noteImagingUse(context);
  const std::string &bytes = recorded.bytes;
  ImagingCommand command;
  std::memcpy(&command, bytes.data(), sizeof command);
  std::size_t at = sizeof command;
  ImageUpload upload;
  if (command.kind == ImagingCommand::Kind::TexImage) {
    std::memcpy(&upload, bytes.data() + at, sizeof upload);
    at += sizeof upload;
  }
  std::vector<imaging::Rgba> colors((bytes.size() - at) / sizeof(imaging::Rgba));
  if (!colors.empty()) // commands without an image have none, and an empty vector has no pointer
    std::memcpy(colors.data(), bytes.data() + at, colors.size() * sizeof(imaging::Rgba));
  if (command.kind == ImagingCommand::Kind::TexImage)
    uploadImage(context, upload, std::move(colors));
  else
    executeImaging(context, command, colors);
}

} // namespace arbiter::state
