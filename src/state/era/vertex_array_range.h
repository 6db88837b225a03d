#pragma once
#include <GL/gl.h>
#include <GL/glext.h>

namespace arbiter::state {

struct CoreContext;

/// The range of NV_vertex_array_range ("VAR"), its second version, and APPLE_vertex_array_range.
/// With it an application promises how it uses its arrays. A host that reads arrays at each draw
/// does not need the promise, so the layer only keeps and returns it, and flushing does nothing.
struct VertexArrayRange {
  bool enabled = false; ///< VERTEX_ARRAY_RANGE_NV, _APPLE and _WITHOUT_FLUSH_NV
  GLsizei length = 0;   ///< bytes
  const void *pointer = nullptr;
  GLenum storageHint = GL_STORAGE_CLIENT_APPLE;
  /// Tells what a query of VERTEX_ARRAY_RANGE_VALID_NV means: VERTEX_ARRAY_STORAGE_HINT_APPLE has
  /// the same value. It means Apple's once the application has called a command that only Apple's
  /// extension has.
  bool spoken = false;
};

/// The value of NVIDIA's chips since the GeForce 3 (VAR, "NV20 Implementation Details").
inline constexpr GLint kMaxVertexArrayRangeElement = 1048575;

[[nodiscard]] constexpr bool isVertexArrayRange(GLenum clientState) {
  return clientState == GL_VERTEX_ARRAY_RANGE_NV ||
         clientState == GL_VERTEX_ARRAY_RANGE_WITHOUT_FLUSH_NV;
}

/// True if the range is valid as VAR defines it: enabled with VERTEX_ARRAY, and a range given.
[[nodiscard]] bool isValid(const CoreContext &context, const VertexArrayRange &range);

/// glXAllocateMemoryNV: returns \p size bytes, aligned to a page, or null. Any thread may call it,
/// without a context.
[[nodiscard]] void *allocateArrayMemory(GLsizei size);
/// glXFreeMemoryNV: frees a block. Ignores pointers that are not allocated.
void freeArrayMemory(void *pointer);

} // namespace arbiter::state
