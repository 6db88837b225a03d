#pragma once
#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "control/address.h"

/// Pictures in memory that two processes share. There are three slots of one size, each lent to the
/// reader until it gives it back.
namespace arbiter::control {

inline constexpr int kFrameSlots = 3;
inline constexpr int kMaxFrameSide = 16384;

/// The layout of pictures in memory: RGBA bytes, bottom row first.
struct FrameLayout {
  int width = 0, height = 0; ///< pixels
  std::size_t stride = 0;    ///< bytes from row to row
  std::size_t slotBytes = 0; ///< from slot to slot; a multiple of the page size

  [[nodiscard]] std::size_t bytes() const { return slotBytes * kFrameSlots; }
};
/// Returns the layout of frames, or nothing for an invalid size.
[[nodiscard]] std::optional<FrameLayout> layoutOf(int width, int height);

/// Returns the event that announces such memory.
[[nodiscard]] std::string bufferLine(const FrameLayout &layout, std::int64_t serial);

/// The writer's end. Only the writer's thread may call take(); any thread may call giveBack().
class FrameRing {
public:
  /// Returns null if there is no memory.
  [[nodiscard]] static std::shared_ptr<FrameRing> make(int width, int height);
  ~FrameRing();
  FrameRing(const FrameRing &) = delete;
  FrameRing &operator=(const FrameRing &) = delete;

  [[nodiscard]] const FrameLayout &layout() const { return m_layout; }
  /// Returns the memory's descriptor. Whoever receives it can neither resize nor write the memory.
  [[nodiscard]] int fd() const { return m_fd.get(); }
  /// Returns a duplicate of the descriptor for the other process.
  [[nodiscard]] Descriptor share() const;
  /// Lends a free slot and returns its number; -1 if all are lent.
  [[nodiscard]] int take();
  /// True if all slots are lent.
  [[nodiscard]] bool isFull() const;
  /// Takes back a slot. Returns false if it was not lent.
  bool giveBack(int slot);
  /// Returns the bytes of a slot.
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
  /// Maps the memory. Returns null if the descriptor is unsuitable: it is too small, or its size
  /// may change under the reader.
  [[nodiscard]] static std::unique_ptr<FrameView> map(Descriptor fd, const FrameLayout &layout);
  ~FrameView();
  FrameView(const FrameView &) = delete;
  FrameView &operator=(const FrameView &) = delete;

  [[nodiscard]] const FrameLayout &layout() const { return m_layout; }
  /// Returns null if the number is not that of a slot.
  [[nodiscard]] const std::uint8_t *pixels(int slot) const;

private:
  FrameView(const FrameLayout &layout, const std::uint8_t *memory)
      : m_layout(layout), m_memory(memory) {}
  FrameLayout m_layout;
  const std::uint8_t *m_memory;
};

} // namespace arbiter::control
