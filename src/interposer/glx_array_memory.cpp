#include "interposer/glx_array_memory.h"

#include <cstring>

#include <GL/gl.h>

#include "state/era/vertex_array_range.h"

namespace arbiter::interposer {

namespace {

void *allocateMemory(GLsizei size, GLfloat, GLfloat, GLfloat) {
  return state::allocateArrayMemory(size);
}
void freeMemory(void *pointer) { state::freeArrayMemory(pointer); }

} // namespace

void *arrayMemoryFunction(const char *name) {
  if (std::strcmp(name, "glXAllocateMemoryNV") == 0)
    return reinterpret_cast<void *>(allocateMemory);
  if (std::strcmp(name, "glXFreeMemoryNV") == 0)
    return reinterpret_cast<void *>(freeMemory);
  return nullptr;
}

} // namespace arbiter::interposer
