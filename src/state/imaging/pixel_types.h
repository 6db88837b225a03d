#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

/// Types of pixels in memory, and where an image of them lies.
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
/// Of one component; 0 for what is no such type.
[[nodiscard]] std::size_t componentBytes(GLenum type);

/// The components that a format of a query names, as numbers of red, green, blue and alpha: up to
/// four; none for what is no such format. Luminance is red's.
[[nodiscard]] std::vector<int> componentsOfQuery(GLenum format);

/// Where an image begins, how far its rows are apart, and where it ends, in bytes from its address,
/// by the pack state (OpenGL 2.1, 4.3.2).
struct PackedLayout {
  std::size_t first = 0, row = 0, end = 0;
};
/// \param element the bytes of a component, or of a pixel of a packed type
[[nodiscard]] PackedLayout packedLayout(const Context &context, std::size_t width,
                                        std::size_t height, std::size_t element, std::size_t pixel);
/// Whether the image fits into so many bytes; of a format or type that is none it does.
[[nodiscard]] bool fits(const Context &context, GLsizei bytes, GLsizei width, GLsizei height,
                        GLenum format, GLenum type);

} // namespace arbiter::state
