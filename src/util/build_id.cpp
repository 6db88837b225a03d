#include "util/build_id.h"

#include <cstdint>
#include <cstring>
#include <link.h>

namespace arbiter {

namespace {
struct BuildId {
  std::uintptr_t inside; ///< an address in the object that is asked about
  std::string bytes;
};

/// Returns the note of type NT_GNU_BUILD_ID named "GNU" if the segment holds it.
std::string findNote(const char *at, std::size_t size) {
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note;
    std::memcpy(&note, at, sizeof note);
    const std::size_t name = (note.n_namesz + 3u) & ~std::size_t(3);
    const std::size_t whole = sizeof note + name + ((note.n_descsz + 3u) & ~std::size_t(3));
    if (whole > size)
      break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 &&
        std::memcmp(at + sizeof note, "GNU", 4) == 0)
      return {at + sizeof note + name, note.n_descsz};
    at += whole;
    size -= whole;
  }
  return {};
}

int lookInObject(dl_phdr_info *object, std::size_t, void *data) {
  auto &id = *static_cast<BuildId *>(data);
  bool here = false;
  for (int i = 0; i < object->dlpi_phnum; ++i) {
    const ElfW(Phdr) &segment = object->dlpi_phdr[i];
    here |= segment.p_type == PT_LOAD &&
            id.inside - object->dlpi_addr - segment.p_vaddr < segment.p_memsz;
  }
  if (!here)
    return 0;
  for (int i = 0; i < object->dlpi_phnum && id.bytes.empty(); ++i)
    if (object->dlpi_phdr[i].p_type == PT_NOTE)
      id.bytes =
          findNote(reinterpret_cast<const char *>(object->dlpi_addr + object->dlpi_phdr[i].p_vaddr),
                   object->dlpi_phdr[i].p_memsz);
  return 1;
}
} // namespace

std::string buildIdAt(const void *address) {
  BuildId id{reinterpret_cast<std::uintptr_t>(address), {}};
  dl_iterate_phdr(lookInObject, &id);
  return id.bytes;
}

std::string buildId() { return buildIdAt(reinterpret_cast<const void *>(&lookInObject)); }

} // namespace arbiter
