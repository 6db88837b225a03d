#pragma once
#include <array>
#include <vector>

#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

struct CoreContext;

/// A vertex array as its Pointer command set it.
struct ClientArray {
  bool enabled = false;
  GLint size = 4;
  GLint type = GL_FLOAT;
  GLint stride = 0;
  GLint buffer = 0;
  void *pointer = nullptr;

  bool operator==(const ClientArray &) const = default;
};

/// A generic array. Its binding point has the array's number, at offset 0, unless
/// ARB_vertex_attrib_binding was used.
struct GenericArray : ClientArray {
  bool normalized = false, integer = false, isLong = false;
  GLint divisor = 0;
  GLint point = 0;    ///< VERTEX_ATTRIB_BINDING
  GLint relative = 0; ///< VERTEX_ATTRIB_RELATIVE_OFFSET

  bool operator==(const GenericArray &) const = default;
};

/// A binding point of ARB_vertex_attrib_binding.
struct ArrayPoint {
  GLint buffer = 0;
  GLint64 offset = 0;
  GLint stride = 16;
  GLint divisor = 0;

  bool operator==(const ArrayPoint &) const = default;
};

/// All vertex arrays of client state. The constructor gives them GL's initial values.
struct ClientArrays {
  enum Conventional { Position, Normal, Color, Secondary, FogCoord, Index, EdgeFlag, kCount };

  explicit ClientArrays(const CoreContext &context);

  std::array<ClientArray, kCount> conventional;
  std::vector<ClientArray> texCoords; ///< one per coordinate set
  std::vector<GenericArray> generic;
  std::vector<ArrayPoint> points; ///< empty: the host has no binding points
  GLint elementBuffer = 0;
};

/// Returns the arrays of the host's current vertex array object.
[[nodiscard]] ClientArrays readArrays(const CoreContext &context);
/// Changes the host's arrays from `from`, their current values, to `to`. The arrays may be in the
/// application's memory, so the host's default vertex array object must be current.
void writeArrays(const CoreContext &context, const ClientArrays &from, const ClientArrays &to);

} // namespace arbiter::state
