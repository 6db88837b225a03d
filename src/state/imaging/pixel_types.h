#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

/// Types and formats of pixels in memory.
namespace arbiter::state {

struct CoreContext;

/// A packed type, with the bits of each component. The first component is in the highest bits, or
/// in the lowest if reversed.
struct PackedType {
  GLenum type;
  std::size_t bytes;
  bool reversed;
  std::array<int, 4> bits;
};
/// Returns the packed type; null if it is none.
[[nodiscard]] const PackedType *packedType(GLenum type);

/// Returns the components of a query's format, as indices of red, green, blue and alpha. Up to
/// four; none if it is no such format. Luminance is red.
[[nodiscard]] std::vector<int> componentsOfQuery(GLenum format);

/// True if the image fits into `bytes`. Also true for an invalid format or type.
[[nodiscard]] bool fits(const CoreContext &context, GLsizei bytes, GLsizei width, GLsizei height,
                        GLenum format, GLenum type);

} // namespace arbiter::state
