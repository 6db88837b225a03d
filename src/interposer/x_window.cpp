#include "interposer/x_window.h"

namespace arbiter::interposer {

namespace {
constexpr std::size_t kMaxQuestions = 8; ///< the limit of pending queries
}

bool Window::size(int &width, int &height, bool sure, const std::function<void()> &takeOwn) {
  xcb_connection_t *const c = connection->xcb;
  if (!c)
    return false;
  connection->listen(takeOwn);
  const std::lock_guard lock(m_mutex);
  std::uint64_t changes = connection->changes();
  const unsigned question = xcb().xcb_get_geometry(c, window).sequence;
  // The reply also covers what others sent before this query.
  if (connection->sent(question))
    ++changes;
  m_questions.push_back(question);
  if (sure || !m_known || m_changes != changes || m_questions.size() > kMaxQuestions)
    while (!m_questions.empty() && take(c, true)) {
    }
  m_changes = changes;
  width = m_width;
  height = m_height;
  return m_known;
}

void Window::takeAnswers() {
  const std::unique_lock lock(m_mutex, std::try_to_lock);
  xcb_connection_t *const c = connection->xcb;
  if (lock.owns_lock() && c)
    while (!m_questions.empty() && take(c, false)) {
    }
}

void Window::forget() {
  const std::lock_guard lock(m_mutex);
  m_known = false;
  failed = false;
}

/// Takes the oldest query's answer. \return true if it was there
bool Window::take(xcb_connection_t *c, bool wait) {
  void *reply = nullptr;
  xcb_generic_error_t *error = nullptr;
  if (wait)
    reply = xcb().xcb_get_geometry_reply(c, {m_questions.front()}, &error);
  else if (!xcb().xcb_poll_for_reply(c, m_questions.front(), &reply, &error))
    return false;
  const auto *const geometry = static_cast<const xcb_get_geometry_reply_t *>(reply);
  m_questions.pop_front();
  m_known = geometry != nullptr;
  m_width = geometry ? geometry->width : 0;
  m_height = geometry ? geometry->height : 0;
  connection->taken();
  std::free(reply);
  std::free(error);
  return true;
}

} // namespace arbiter::interposer
