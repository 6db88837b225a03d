#include "interposer/x_segment.h"

#include <sys/ipc.h>
#include <sys/shm.h>

#include "util/log.h"

namespace arbiter::interposer {

namespace {

xcb_extension_t g_shm = {"MIT-SHM", 0};
constexpr std::uint8_t kAttach = 1, kDetach = 2, kPutImage = 3;

struct AttachRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t segment, id;
  std::uint8_t readOnly, pad[3];
};
struct DetachRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t segment;
};
struct PutImageRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t drawable, gc;
  std::uint16_t totalWidth, totalHeight, sourceX, sourceY, sourceWidth, sourceHeight;
  std::int16_t destX, destY;
  std::uint8_t depth, format, sendEvent, pad;
  std::uint32_t segment, offset;
};

} // namespace

bool hasSharedMemory(xcb_connection_t *connection) {
  const xcb_query_extension_reply_t *const shm = xcb().xcb_get_extension_data(connection, &g_shm);
  return shm && shm->present;
}

std::unique_ptr<Segment> Segment::make(std::shared_ptr<Connection> connection, std::size_t bytes) {
  xcb_connection_t *const c = connection->xcb;
  if (!c)
    return nullptr;
  const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  if (id < 0)
    return nullptr;
  void *const memory = shmat(id, nullptr, 0);
  bool attached = memory != reinterpret_cast<void *>(-1);
  std::unique_ptr<Segment> made;
  if (attached) {
    made.reset(new Segment);
    made->m_name = xcb().xcb_generate_id(c);
    made->m_memory = static_cast<std::uint8_t *>(memory);
    made->m_bytes = bytes;
    const AttachRequest request{.segment = made->m_name, .id = std::uint32_t(id), .readOnly = 1};
    const auto error = answer(xcb().xcb_request_check(c, send(c, g_shm, kAttach, request, true)));
    attached = !error && !xcb().xcb_connection_has_error(c);
    if (attached)
      made->m_connection = std::move(connection);
    else if (!connection->refused.exchange(true))
      logInfo("layer", "X: the server cannot share memory with us; frames go by the host");
  }
  // The memory lives until both sides have detached it.
  shmctl(id, IPC_RMID, nullptr);
  return attached ? std::move(made) : nullptr;
}

Segment::~Segment() {
  if (xcb_connection_t *const c = m_connection ? m_connection->xcb.load() : nullptr) {
    if (m_underWay) {
      xcb().xcb_discard_reply(c, m_behind.sequence);
      xcb().xcb_discard_reply(c, m_put.sequence);
    }
    // The server detaches it after it has handled the earlier pictures.
    const auto cookie = send(c, g_shm, kDetach, DetachRequest{.segment = m_name}, true);
    xcb().xcb_discard_reply(c, cookie.sequence);
  }
  shmdt(m_memory);
}

bool Segment::show(const Picture &picture, std::atomic<bool> &failed) {
  const std::lock_guard lock(m_mutex);
  xcb_connection_t *const c = m_connection->xcb;
  if (!c || !takeAnswers(c, true))
    return false;
  PutImageRequest request{};
  request.drawable = picture.drawable;
  request.gc = picture.gc;
  request.totalWidth = picture.rowPixels;
  request.totalHeight = picture.height;
  request.sourceWidth = picture.width;
  request.sourceHeight = picture.height;
  request.depth = picture.depth;
  request.format = XCB_IMAGE_FORMAT_Z_PIXMAP;
  request.segment = m_name;
  request.offset = std::uint32_t(picture.offset);
  m_put = send(c, g_shm, kPutImage, request, true);
  m_connection->sent(m_put.sequence);
  m_behind = xcb().xcb_get_input_focus(c);
  m_connection->sent(m_behind.sequence);
  m_failed = &failed;
  m_underWay = true;
  return xcb().xcb_flush(c) > 0;
}

bool Segment::isRead(bool wait) {
  if (!m_underWay)
    return false;
  std::unique_lock lock(m_mutex, std::defer_lock);
  if (wait)
    lock.lock();
  else if (!lock.try_lock())
    return true;
  xcb_connection_t *const c = m_connection->xcb;
  return c && !takeAnswers(c, wait);
}

/// Takes the answers that have arrived. \return true if no picture is under way
bool Segment::takeAnswers(xcb_connection_t *connection, bool wait) {
  if (!m_underWay)
    return true;
  xcb_generic_error_t *error = nullptr;
  void *reply = nullptr;
  if (wait)
    reply = xcb().xcb_get_input_focus_reply(connection, m_behind, &error);
  else if (!xcb().xcb_poll_for_reply(connection, m_behind.sequence, &reply, &error))
    return false;
  std::free(reply);
  std::free(error);
  m_connection->taken();
  // The answer behind it has arrived, so that this does not wait.
  if (answer(xcb().xcb_request_check(connection, m_put))) {
    m_connection->taken();
    *m_failed = true;
  }
  m_underWay = false;
  return true;
}

} // namespace arbiter::interposer
