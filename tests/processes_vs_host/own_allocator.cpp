// Defines operator new and delete for the program: each block has a header that marks it. It is
// linked to the matrix's client as a second program, and exported, as in any program that links a
// library.
#include <cstdio>
#include <cstdlib>
#include <new>

namespace {

constexpr unsigned long kMine = 0x4F574E20424C4F43ul;
struct alignas(64) Header {
  unsigned long mark;
  void *whole;
};

void *take(std::size_t bytes, std::size_t alignment) {
  if (alignment < alignof(Header))
    alignment = alignof(Header);
  char *const whole = static_cast<char *>(std::malloc(bytes + sizeof(Header) + alignment));
  if (!whole)
    throw std::bad_alloc();
  const auto at = (reinterpret_cast<unsigned long>(whole) + sizeof(Header) + alignment - 1) /
                  alignment * alignment;
  Header *const header = reinterpret_cast<Header *>(at) - 1;
  *header = {kMine, whole};
  return header + 1;
}
void give(void *block) {
  if (!block)
    return;
  Header *const header = static_cast<Header *>(block) - 1;
  if (header->mark != kMine) {
    std::fputs("foreign: a block that is not of this operator new\n", stderr);
    std::abort();
  }
  header->mark = 0;
  std::free(header->whole);
}

} // namespace

void *operator new(std::size_t n) { return take(n, 16); }
void *operator new[](std::size_t n) { return take(n, 16); }
void *operator new(std::size_t n, std::align_val_t a) { return take(n, std::size_t(a)); }
void *operator new[](std::size_t n, std::align_val_t a) { return take(n, std::size_t(a)); }
void operator delete(void *p) noexcept { give(p); }
void operator delete[](void *p) noexcept { give(p); }
void operator delete(void *p, std::size_t) noexcept { give(p); }
void operator delete[](void *p, std::size_t) noexcept { give(p); }
void operator delete(void *p, std::align_val_t) noexcept { give(p); }
void operator delete[](void *p, std::align_val_t) noexcept { give(p); }
void operator delete(void *p, std::size_t, std::align_val_t) noexcept { give(p); }
void operator delete[](void *p, std::size_t, std::align_val_t) noexcept { give(p); }
