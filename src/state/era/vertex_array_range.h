#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

class Context;

/// The range of NV_vertex_array_range ("VAR"), its second version, and APPLE_vertex_array_range: a
/// promise of the application's about its arrays, which a host that reads them at each draw needs
/// not. It is kept and answered for; flushing has nothing to do.
struct VertexArrayRange {
  bool enabled = false; ///< VERTEX_ARRAY_RANGE_NV, _APPLE and _WITHOUT_FLUSH_NV
  GLsizei length = 0;   ///< bytes
  const void *pointer = nullptr;
  GLenum storageHint = GL_STORAGE_CLIENT_APPLE;
  /// VERTEX_ARRAY_RANGE_VALID_NV and VERTEX_ARRAY_STORAGE_HINT_APPLE are one number: it is Apple's
  /// once the application has called a command that Apple's extension alone has.
  bool spoken = false;
};

/// That of NVIDIA's chips from the GeForce 3 on (VAR, "NV20 Implementation Details").
inline constexpr GLint kMaxVertexArrayRangeElement = 1048575;

[[nodiscard]] constexpr bool isVertexArrayRange(GLenum clientState) {
  return clientState == GL_VERTEX_ARRAY_RANGE_NV ||
         clientState == GL_VERTEX_ARRAY_RANGE_WITHOUT_FLUSH_NV;
}

/// VAR's validity: enabled with VERTEX_ARRAY, and a range given.
[[nodiscard]] bool isValid(const Context &context, const VertexArrayRange &range);

/// glXAllocateMemoryNV: \p size bytes, aligned to a page, or null. Any thread may call it, without
/// a context.
[[nodiscard]] void *allocateArrayMemory(GLsizei size);
/// glXFreeMemoryNV: what was not allocated so, or is freed already, is ignored.
void freeArrayMemory(void *pointer);

} // namespace arbiter::state
