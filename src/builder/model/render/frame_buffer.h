#pragma once
#include <QImage>
#include <QJsonObject>
#include <optional>

namespace arbiter::builder {

/// The shared memory that a renderer or the layer puts pictures into (docs/control.md): slots of
/// one size, rows of RGBA bytes, the bottom row first. What its sizes say is held against the
/// memory's own: nothing is read outside it, and memory that could shrink is refused.
class FrameBuffer {
public:
  FrameBuffer() = default;
  FrameBuffer(const FrameBuffer &) = delete;
  FrameBuffer &operator=(const FrameBuffer &) = delete;
  ~FrameBuffer() { unmap(); }

  /// Takes the memory of a `frame.buffer` event. \param descriptor closed in any case
  /// \returns false, and holds none, if it is not what the event says
  [[nodiscard]] bool map(int descriptor, const QJsonObject &params);
  /// A copy of the picture of a `frame` event, the top row first; nothing where the event does not
  /// fit the memory.
  [[nodiscard]] std::optional<QImage> picture(const QJsonObject &params) const;

private:
  void unmap();

  const uchar *m_memory = nullptr;
  std::size_t m_bytes = 0;
  qint64 m_serial = -1, m_width = 0, m_height = 0, m_stride = 0, m_slots = 0, m_slotBytes = 0;
};

} // namespace arbiter::builder
