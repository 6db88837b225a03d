#include "builder/model/render/frame_buffer.h"

#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace arbiter::builder {

namespace {
constexpr qint64 kMaxSide = 16384;
constexpr qint64 kMaxSlots = 16;
} // namespace

void FrameBuffer::unmap() {
  if (m_memory)
    ::munmap(const_cast<uchar *>(std::exchange(m_memory, nullptr)), m_bytes);
}

bool FrameBuffer::map(int descriptor, const QJsonObject &params) {
  unmap();
  m_serial = params[u"serial"].toInteger(-1);
  m_width = params[u"width"].toInteger();
  m_height = params[u"height"].toInteger();
  m_stride = params[u"stride"].toInteger();
  m_slots = params[u"slots"].toInteger();
  m_slotBytes = params[u"slot_bytes"].toInteger();
  const bool sane = m_width > 0 && m_width <= kMaxSide && m_height > 0 && m_height <= kMaxSide &&
                    m_stride >= m_width * 4 && m_stride <= kMaxSide * 8 && m_slots > 0 &&
                    m_slots <= kMaxSlots && m_slotBytes >= m_stride * m_height &&
                    m_slotBytes <= kMaxSide * kMaxSide * 8;
  struct stat file = {};
  const int seals = descriptor < 0 ? -1 : ::fcntl(descriptor, F_GET_SEALS);
  if (sane && seals >= 0 && (seals & F_SEAL_SHRINK) && ::fstat(descriptor, &file) == 0 &&
      file.st_size >= m_slots * m_slotBytes) {
    m_bytes = std::size_t(m_slots * m_slotBytes);
    void *memory = ::mmap(nullptr, m_bytes, PROT_READ, MAP_SHARED, descriptor, 0);
    if (memory != MAP_FAILED)
      m_memory = static_cast<const uchar *>(memory);
  }
  if (descriptor >= 0)
    ::close(descriptor);
  return m_memory != nullptr;
}

std::optional<QImage> FrameBuffer::picture(const QJsonObject &params) const {
  const qint64 slot = params[u"slot"].toInteger(-1);
  const qint64 width = params[u"width"].toInteger(m_width);
  const qint64 height = params[u"height"].toInteger(m_height);
  if (!m_memory || params[u"serial"].toInteger(-1) != m_serial || slot < 0 || slot >= m_slots ||
      width <= 0 || width > m_width || height <= 0 || height > m_height)
    return std::nullopt;
  QImage image(int(width), int(height), QImage::Format_RGBA8888);
  const uchar *rows = m_memory + slot * m_slotBytes;
  for (int y = 0; y < image.height(); ++y)
    std::memcpy(image.scanLine(y), rows + (height - 1 - y) * m_stride, std::size_t(width) * 4);
  return image;
}

} // namespace arbiter::builder
