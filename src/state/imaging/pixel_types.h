#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

/// Types and formats of pixels in memory.
namespace arbiter::state {

class Context;

/// A packed type: how many bits each component has, the first ones those of the highest place, or
/// of the lowest where it is reversed.
struct PackedType {
  GLenum type;
  std::size_t bytes;
  bool reversed;
  std::array<int, 4> bits;
};
/// Null for what is no such type.
[[nodiscard]] const PackedType *packedType(GLenum type);

/// The components that a format of a query names, as numbers of red, green, blue and alpha: up to
/// four; none for what is no such format. Luminance is red's.
[[nodiscard]] std::vector<int> componentsOfQuery(GLenum format);

/// Whether the image fits into so many bytes; of a format or type that is none it does.
[[nodiscard]] bool fits(const Context &context, GLsizei bytes, GLsizei width, GLsizei height,
                        GLenum format, GLenum type);

} // namespace arbiter::state
