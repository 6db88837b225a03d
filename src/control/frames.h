#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "control/address.h"

/// Pictures in memory that two processes share: three slots of one size, each lent to the reader
/// until it gives it back.
namespace arbiter::control {

inline constexpr int kFrameSlots = 3;
inline constexpr int kMaxFrameSide = 16384;

/// How pictures lie in the memory: RGBA bytes, bottom row first.
struct FrameLayout {
  int width = 0, height = 0; ///< pixels
  std::size_t stride = 0;    ///< bytes from row to row
  std::size_t slotBytes = 0; ///< from slot to slot; a multiple of the page's size

  [[nodiscard]] std::size_t bytes() const { return slotBytes * kFrameSlots; }
};
/// Nothing for a size that no frame has.
[[nodiscard]] std::optional<FrameLayout> layoutOf(int width, int height);

/// The event that brings such memory.
[[nodiscard]] std::string bufferLine(const FrameLayout &layout, std::int64_t serial);

/// The writer's end. take() is the writer's thread's, giveBack() any thread's.
class FrameRing {
public:
  /// Null where there is no memory for it.
  [[nodiscard]] static std::shared_ptr<FrameRing> make(int width, int height);
  ~FrameRing();
  FrameRing(const FrameRing &) = delete;
  FrameRing &operator=(const FrameRing &) = delete;

  [[nodiscard]] const FrameLayout &layout() const { return m_layout; }
  /// The memory's descriptor, which may not be resized, nor be written to by who gets it.
  [[nodiscard]] int fd() const { return m_fd.get(); }
  /// The same, for the other process.
  [[nodiscard]] Descriptor share() const;
  /// A slot that is not lent, which it is from now on; -1: all are.
  [[nodiscard]] int take();
  /// All slots are lent.
  [[nodiscard]] bool isFull() const;
  /// False: it was not lent.
  bool giveBack(int slot);
  /// Bytes of a slot.
  [[nodiscard]] std::uint8_t *pixels(int slot) const;

private:
  FrameRing(const FrameLayout &layout, Descriptor fd, std::uint8_t *memory);
  FrameLayout m_layout;
  Descriptor m_fd;
  std::uint8_t *m_memory;
  std::array<std::atomic<bool>, kFrameSlots> m_lent{};
};

/// The reader's end.
class FrameView {
public:
  /// Null where the descriptor is not such memory: too small, or its size may change under the
  /// reader.
  [[nodiscard]] static std::unique_ptr<FrameView> map(Descriptor fd, const FrameLayout &layout);
  ~FrameView();
  FrameView(const FrameView &) = delete;
  FrameView &operator=(const FrameView &) = delete;

  [[nodiscard]] const FrameLayout &layout() const { return m_layout; }
  /// Null for a number that is no slot.
  [[nodiscard]] const std::uint8_t *pixels(int slot) const;

private:
  FrameView(const FrameLayout &layout, const std::uint8_t *memory)
      : m_layout(layout), m_memory(memory) {}
  FrameLayout m_layout;
  const std::uint8_t *m_memory;
};

} // namespace arbiter::control
