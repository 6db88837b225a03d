#include "control/frames.h"

#include <algorithm>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

#include "control/message.h"

#ifndef F_SEAL_FUTURE_WRITE
#define F_SEAL_FUTURE_WRITE 0x0010 // Linux 5.1
#endif

namespace arbiter::control {

std::optional<FrameLayout> layoutOf(int width, int height) {
  if (width <= 0 || height <= 0 || width > kMaxFrameSide || height > kMaxFrameSide)
    return std::nullopt;
  const auto page = std::size_t(sysconf(_SC_PAGESIZE));
  FrameLayout layout = {width, height, std::size_t(width) * 4, 0};
  layout.slotBytes = (layout.stride * std::size_t(height) + page - 1) / page * page;
  return layout;
}

std::string bufferLine(const FrameLayout &layout, std::int64_t serial) {
  return eventLine("frame.buffer", Json::object({{"serial", serial},
                                                 {"width", layout.width},
                                                 {"height", layout.height},
                                                 {"stride", layout.stride},
                                                 {"slots", kFrameSlots},
                                                 {"slot_bytes", layout.slotBytes}}));
}

FrameRing::FrameRing(const FrameLayout &layout, Descriptor fd, std::uint8_t *memory)
    : m_layout(layout), m_fd(std::move(fd)), m_memory(memory) {}

std::shared_ptr<FrameRing> FrameRing::make(int width, int height) {
  const std::optional<FrameLayout> layout = layoutOf(width, height);
  if (!layout)
    return nullptr;
  Descriptor fd(memfd_create("arbiter-frames", MFD_CLOEXEC | MFD_ALLOW_SEALING));
  if (!fd || ftruncate(fd.get(), off_t(layout->bytes())) != 0)
    return nullptr;
  void *const memory =
      mmap(nullptr, layout->bytes(), PROT_READ | PROT_WRITE, MAP_SHARED, fd.get(), 0);
  if (memory == MAP_FAILED)
    return nullptr;
  // The writer's own mapping stays writable. An old kernel without F_SEAL_FUTURE_WRITE takes the
  // other seals; a reader could then only spoil its own pictures.
  constexpr int kSize = F_SEAL_SHRINK | F_SEAL_GROW;
  if (fcntl(fd.get(), F_ADD_SEALS, kSize | F_SEAL_FUTURE_WRITE | F_SEAL_SEAL) != 0 &&
      fcntl(fd.get(), F_ADD_SEALS, kSize | F_SEAL_SEAL) != 0) {
    munmap(memory, layout->bytes());
    return nullptr;
  }
  auto *const ring =
      new (std::nothrow) FrameRing(*layout, std::move(fd), static_cast<std::uint8_t *>(memory));
  if (!ring)
    munmap(memory, layout->bytes());
  return std::shared_ptr<FrameRing>(ring);
}

FrameRing::~FrameRing() { munmap(m_memory, m_layout.bytes()); }

Descriptor FrameRing::share() const { return Descriptor(fcntl(m_fd.get(), F_DUPFD_CLOEXEC, 3)); }

int FrameRing::take() {
  for (int slot = 0; slot < kFrameSlots; ++slot)
    if (!m_lent[std::size_t(slot)].exchange(true, std::memory_order_acquire))
      return slot;
  return -1;
}

bool FrameRing::isFull() const {
  return std::all_of(m_lent.begin(), m_lent.end(),
                     [](const auto &lent) { return lent.load(std::memory_order_relaxed); });
}

bool FrameRing::giveBack(int slot) {
  return slot >= 0 && slot < kFrameSlots &&
         m_lent[std::size_t(slot)].exchange(false, std::memory_order_release);
}

std::uint8_t *FrameRing::pixels(int slot) const {
  return m_memory + std::size_t(slot) * m_layout.slotBytes;
}

std::unique_ptr<FrameView> FrameView::map(Descriptor fd, const FrameLayout &layout) {
  const std::optional<FrameLayout> expected = layoutOf(layout.width, layout.height);
  if (!expected || expected->stride != layout.stride || expected->slotBytes != layout.slotBytes)
    return nullptr;
  struct stat state;
  const int seals = fcntl(fd.get(), F_GET_SEALS);
  if (seals < 0 || (seals & F_SEAL_SHRINK) == 0 || fstat(fd.get(), &state) != 0 ||
      state.st_size < off_t(layout.bytes()))
    return nullptr;
  void *const memory = mmap(nullptr, layout.bytes(), PROT_READ, MAP_SHARED, fd.get(), 0);
  if (memory == MAP_FAILED)
    return nullptr;
  return std::unique_ptr<FrameView>(
      new FrameView(layout, static_cast<const std::uint8_t *>(memory)));
}

FrameView::~FrameView() { munmap(const_cast<std::uint8_t *>(m_memory), m_layout.bytes()); }

const std::uint8_t *FrameView::pixels(int slot) const {
  return slot >= 0 && slot < kFrameSlots ? m_memory + std::size_t(slot) * m_layout.slotBytes
                                         : nullptr;
}

} // namespace arbiter::control
