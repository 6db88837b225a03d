#include "state/era/vertex_array_range.h"

#include <map>
#include <mutex>
#include <new>
#include <sys/mman.h>

#include "host/host_table.h"
#include "state/core/core_context.h"

namespace arbiter::state {

bool isValid(const CoreContext &context, const VertexArrayRange &range) {
  return range.enabled && range.pointer && range.length > 0 &&
         context.host->IsEnabled(GL_VERTEX_ARRAY) == GL_TRUE;
}

namespace {
/// The blocks that applications allocated. They are whole pages from the system, as an
/// application's malloc may be of any kind.
struct ArrayMemory {
  std::mutex mutex;
  std::map<void *, std::size_t> blocks;
};
/// Returns the blocks. They are never freed: destructors of other libraries may free memory.
ArrayMemory &arrayMemory() {
  static auto *const s_memory = new ArrayMemory;
  return *s_memory;
}
} // namespace

void *allocateArrayMemory(GLsizei size) try {
  if (size <= 0)
    return nullptr;
  void *const block = ::mmap(nullptr, std::size_t(size), PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (block == MAP_FAILED)
    return nullptr;
  ArrayMemory &memory = arrayMemory();
  const std::lock_guard lock(memory.mutex);
  try {
    memory.blocks.emplace(block, std::size_t(size));
  } catch (const std::bad_alloc &) {
    ::munmap(block, std::size_t(size));
    return nullptr;
  }
  return block;
} catch (const std::bad_alloc &) { // the table found no memory
  return nullptr;
}

void freeArrayMemory(void *pointer) try {
  ArrayMemory &memory = arrayMemory();
  const std::lock_guard lock(memory.mutex);
  const auto found = memory.blocks.find(pointer);
  if (found == memory.blocks.end())
    return;
  ::munmap(pointer, found->second);
  memory.blocks.erase(found);
} catch (const std::bad_alloc &) {
}

} // namespace arbiter::state
