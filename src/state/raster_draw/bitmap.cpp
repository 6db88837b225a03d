#include "state/raster_draw/bitmap.h"

#include <vector>

#include "host/host_table.h"
#include "state/raster_draw/commands.h"
#include "state/raster_draw/context_state.h"
#include "state/raster_draw/decision.h"
#include "state/raster_draw/pipeline.h"

namespace arbiter::state {

namespace {

/// Returns the bytes from one row to the next (3.6.4, with the elements of 3.7).
std::int64_t strideOf(const BitUnpacking &unpack, GLsizei width) {
  const std::int64_t pixels = unpack.rowLength > 0 ? unpack.rowLength : width;
  const std::int64_t unit = 8 * std::int64_t(unpack.alignment);
  return (pixels + unit - 1) / unit * unpack.alignment;
}

/// Describes the bitmap, without the address of its rows.
swrast::BitImage imageOf(const BitUnpacking &unpack, const BitmapCommand &command) {
  swrast::BitImage image;
  image.stride = strideOf(unpack, command.width);
  image.skip = unpack.skipPixels;
  image.lowestFirst = unpack.lowestFirst;
  image.width = command.width;
  image.height = command.height;
  return image;
}

/// Reads the bits from a buffer object, `at` bytes from its start. Returns false if the arguments
/// are invalid, so that the host must report it.
bool fetchFromBuffer(RasterContext &context, const BitUnpacking &unpack, std::intptr_t at,
                     swrast::BitImage &image, std::vector<std::uint8_t> &memory) {
  const host::HostTable &host = *context.host;
  const std::int64_t first = at + unpack.skipRows * image.stride;
  const std::int64_t rowBytes = (std::int64_t(image.skip) + image.width + 7) / 8;
  const std::int64_t bytes = (image.height - 1) * image.stride + rowBytes;
  const auto ask = [&](GLenum pname) {
    GLint value = 0;
    host.GetBufferParameteriv(GL_PIXEL_UNPACK_BUFFER, pname, &value);
    return value;
  };
  // A host checks whole rows, so it must decide if a part of the last row is missing.
  if (at < 0 || first < 0 || first + image.height * image.stride > ask(GL_BUFFER_SIZE) ||
      first + bytes > ask(GL_BUFFER_SIZE) || ask(GL_BUFFER_MAPPED) != 0)
    return false;
  memory.resize(std::size_t(bytes));
  host.GetBufferSubData(GL_PIXEL_UNPACK_BUFFER, first, bytes, memory.data());
  image.rows = memory.data();
  return true;
}

/// Moves the raster position, in the host and in the mirror.
void move(RasterContext &context, const BitmapCommand &command) {
  Mirror &mirror = context.software->mirror;
  context.host->Bitmap(0, 0, 0, 0, command.xMove, command.yMove, nullptr);
  if (mirror.rasterPosition.valid)
    mirror.noteRasterMove(command.xMove, command.yMove);
}

bool drawBits(RasterContext &context, const PlacedBits &bits) {
  return conclude(context, outcomeOf(context, [&] {
                    const Outcome outcome = decideFragments(context);
                    return outcome.ok() ? pipelineOf(context).shadeBits(context, bits) : outcome;
                  }));
}

/// Draws the bits. Returns false if the host must draw them.
bool drawAtRasterPosition(RasterContext &context, const BitmapCommand &command) {
  const BitUnpacking unpack = context.software->residency.bitUnpacking();
  PlacedBits bits = {imageOf(unpack, command), command.xOrigin, command.yOrigin};
  std::vector<std::uint8_t> memory;
  if (unpack.buffer != 0) {
    if (!fetchFromBuffer(context, unpack, reinterpret_cast<std::intptr_t>(command.bits), bits.image,
                         memory)) {
      hostWrites(context, "glBitmap");
      return false;
    }
  } else if (!command.bits) {
    return true; // no bits, so nothing to draw
  } else {
    bits.image.rows = command.bits + unpack.skipRows * bits.image.stride;
  }
  return drawBits(context, bits);
}

} // namespace

bool tryBitmap(RasterContext &context, const BitmapCommand &command) {
  if (!context.software || !isCandidate(context)) {
    hostWrites(context, "glBitmap"); // also notes it in an open list
    return false;
  }
  if (command.width < 0 || command.height < 0)
    return false; // the host raises the error
  Mirror &mirror = context.software->mirror;
  mirror.refreshRasterPosition(context.dirty, 0);
  const bool draws = command.width > 0 && command.height > 0 && mirror.rasterPosition.valid;
  if (draws && !drawAtRasterPosition(context, command))
    return false;
  move(context, command);
  return true;
}

} // namespace arbiter::state
