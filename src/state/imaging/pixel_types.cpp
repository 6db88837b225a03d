#include "state/imaging/pixel_types.h"

#include <algorithm>
#include <iterator>

#include "host/host_table.h"
#include "state/client_pixels/client_image.h"
#include "state/core/core_context.h"

namespace arbiter::state {

namespace {

constexpr PackedType kPacked[] = {
    {GL_UNSIGNED_BYTE_3_3_2, 1, false, {3, 3, 2, 0}},
    {GL_UNSIGNED_BYTE_2_3_3_REV, 1, true, {3, 3, 2, 0}},
    {GL_UNSIGNED_SHORT_5_6_5, 2, false, {5, 6, 5, 0}},
    {GL_UNSIGNED_SHORT_5_6_5_REV, 2, true, {5, 6, 5, 0}},
    {GL_UNSIGNED_SHORT_4_4_4_4, 2, false, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_4_4_4_4_REV, 2, true, {4, 4, 4, 4}},
    {GL_UNSIGNED_SHORT_5_5_5_1, 2, false, {5, 5, 5, 1}},
    {GL_UNSIGNED_SHORT_1_5_5_5_REV, 2, true, {5, 5, 5, 1}},
    {GL_UNSIGNED_INT_8_8_8_8, 4, false, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_8_8_8_8_REV, 4, true, {8, 8, 8, 8}},
    {GL_UNSIGNED_INT_10_10_10_2, 4, false, {10, 10, 10, 2}},
    {GL_UNSIGNED_INT_2_10_10_10_REV, 4, true, {10, 10, 10, 2}},
};

} // namespace

const PackedType *packedType(GLenum type) {
  const auto *const found = std::find_if(std::begin(kPacked), std::end(kPacked),
                                         [&](const PackedType &p) { return p.type == type; });
  return found == std::end(kPacked) ? nullptr : found;
}

std::vector<int> componentsOfQuery(GLenum format) {
  switch (format) {
  case GL_RED:
  case GL_LUMINANCE:
    return {0};
  case GL_GREEN:
    return {1};
  case GL_BLUE:
    return {2};
  case GL_ALPHA:
    return {3};
  case GL_LUMINANCE_ALPHA:
    return {0, 3};
  case GL_RGB:
    return {0, 1, 2};
  case GL_BGR:
    return {2, 1, 0};
  case GL_RGBA:
    return {0, 1, 2, 3};
  case GL_BGRA:
    return {2, 1, 0, 3};
  case GL_ABGR_EXT:
    return {3, 2, 1, 0};
  default:
    return {};
  }
}

bool fits(const CoreContext &context, GLsizei bytes, GLsizei width, GLsizei height, GLenum format,
          GLenum type) {
  const std::size_t components = componentsOfQuery(format).size();
  const PackedType *const packed = packedType(type);
  const std::size_t element = packed ? packed->bytes : componentBytes(type);
  if (components == 0 || element == 0 || width <= 0 || height <= 0)
    return true;
  const std::size_t pixel = packed ? element : element * components;
  const ImageSize size{.width = std::size_t(width), .height = std::size_t(height)};
  return layoutOf(context, PixelStore::Pack, size, element, pixel).end <=
         std::size_t(std::max(bytes, 0));
}

} // namespace arbiter::state
