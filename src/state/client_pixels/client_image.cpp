#include "state/client_pixels/client_image.h"

#include <GL/glext.h>

#include <algorithm>

#include "host/host_table.h"
#include "state/capabilities/host_integer.h"
#include "state/core/core_context.h"
#include "state/core/errors.h"

namespace arbiter::state {

std::size_t componentBytes(GLenum type) {
  switch (type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE:
    return 1;
  case GL_SHORT:
  case GL_UNSIGNED_SHORT:
  case GL_HALF_FLOAT:
    return 2;
  case GL_INT:
  case GL_UNSIGNED_INT:
  case GL_FLOAT:
    return 4;
  default:
    return 0;
  }
}

ImageLayout layoutOf(const CoreContext &context, PixelStore store, const ImageSize &size,
                     std::size_t element, std::size_t pixel) {
  const auto value = [&](GLenum pack, GLenum unpack) {
    const GLenum name = store == PixelStore::Pack ? pack : unpack;
    return std::size_t(std::max(hostInteger(*context.host, name), 0));
  };
  const std::size_t alignment = value(GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT);
  const std::size_t length = value(GL_PACK_ROW_LENGTH, GL_UNPACK_ROW_LENGTH);
  const bool deep = size.dimensions == 3;
  const std::size_t rows = deep ? value(GL_PACK_IMAGE_HEIGHT, GL_UNPACK_IMAGE_HEIGHT) : 0;
  const std::size_t images = deep ? value(GL_PACK_SKIP_IMAGES, GL_UNPACK_SKIP_IMAGES) : 0;
  ImageLayout layout;
  layout.row = pixel * (length != 0 ? length : size.width);
  if (element < alignment)
    layout.row = (layout.row + alignment - 1) / alignment * alignment;
  layout.image = layout.row * (rows != 0 ? rows : size.height);
  layout.first = images * layout.image +
                 value(GL_PACK_SKIP_ROWS, GL_UNPACK_SKIP_ROWS) * layout.row +
                 value(GL_PACK_SKIP_PIXELS, GL_UNPACK_SKIP_PIXELS) * pixel;
  layout.end = layout.first;
  if (size.width != 0 && size.height != 0 && size.depth != 0)
    layout.end +=
        (size.depth - 1) * layout.image + (size.height - 1) * layout.row + size.width * pixel;
  return layout;
}

bool hasPixelBuffer(const CoreContext &context, PixelStore store) {
  return context.caps.pixelBuffers &&
         hostInteger(*context.host, store == PixelStore::Pack
                                        ? GL_PIXEL_PACK_BUFFER_BINDING
                                        : GL_PIXEL_UNPACK_BUFFER_BINDING) != 0;
}

bool pixelBufferHolds(CoreContext &context, PixelStore store, std::size_t offset,
                      std::size_t bytes) {
  const GLenum target = store == PixelStore::Pack ? GL_PIXEL_PACK_BUFFER : GL_PIXEL_UNPACK_BUFFER;
  GLint size = 0, mapped = 0;
  context.host->GetBufferParameteriv(target, GL_BUFFER_SIZE, &size);
  context.host->GetBufferParameteriv(target, GL_BUFFER_MAPPED, &mapped);
  const auto held = std::size_t(std::max(size, 0));
  if (mapped == 0 && bytes <= held && offset <= held - bytes)
    return true;
  raise(context, GL_INVALID_OPERATION, "pixels reach out of the pixel buffer, or it is mapped");
  return false;
}

} // namespace arbiter::state
