#include "control/attached.h"

#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "util/file.h"

namespace arbiter::control {

Descriptor memoryOf(std::span<const std::uint8_t> bytes) {
  Descriptor memory(memfd_create("arbiter-bytes", MFD_CLOEXEC));
  const std::string_view text(reinterpret_cast<const char *>(bytes.data()), bytes.size());
  const bool good = memory && writeAll(memory.get(), text) && lseek(memory.get(), 0, SEEK_SET) == 0;
  return good ? std::move(memory) : Descriptor();
}

bool readMemory(const Descriptor &memory, std::span<std::uint8_t> bytes) {
  struct stat state = {};
  if (fstat(memory.get(), &state) != 0 || std::size_t(state.st_size) != bytes.size())
    return false;
  for (std::size_t at = 0; at < bytes.size();) {
    const ssize_t count = pread(memory.get(), bytes.data() + at, bytes.size() - at, off_t(at));
    if (count <= 0)
      return false;
    at += std::size_t(count);
  }
  return true;
}

} // namespace arbiter::control
