#include "state/objects/display_list.h"

#include <algorithm>
#include <new>

#include "host/host_table.h"
#include "state/primitives/geometry.h"

namespace arbiter::state {

std::shared_ptr<const DisplayList> DisplayListTable::find(GLuint name) {
  if (empty())
    return nullptr;
  const std::lock_guard lock(m_mutex);
  const auto it = m_lists.find(name);
  return it == m_lists.end() ? nullptr : it->second;
}

void DisplayListTable::replace(const host::HostTable &host, GLuint name,
                               std::shared_ptr<const DisplayList> list) {
  std::shared_ptr<const DisplayList> old;
  {
    const std::lock_guard lock(m_mutex);
    const auto it = m_lists.find(name);
    if (it != m_lists.end())
      old = std::move(it->second);
    if (list)
      m_lists[name] = std::move(list);
    else if (it != m_lists.end())
      m_lists.erase(it);
    m_count.store(m_lists.size(), std::memory_order_release);
  }
  if (old)
    giveBackSegments(host, *old, name);
}

void DisplayListTable::noteEmpty(GLuint first, GLsizei count) {
  const auto empty = std::make_shared<const DisplayList>();
  const std::lock_guard lock(m_mutex);
  for (GLuint name = first; name - first < GLuint(count); ++name)
    m_lists.try_emplace(name, empty);
  m_count.store(m_lists.size(), std::memory_order_release);
}

void DisplayListTable::giveBackSegments(const host::HostTable &host, const DisplayList &list,
                                        GLuint name) {
  for (const DisplayList::Item &item : list.items) {
    if (item.hostList != 0 && item.hostList != name)
      giveBack(host, item.hostList);
    if (const GLuint made = item.geometry ? item.geometry->madeHostList() : 0)
      giveBack(host, made);
  }
}

std::shared_ptr<const DisplayList> DisplayListTable::findEarly(GLuint name) {
  if (!hasEarly())
    return nullptr;
  const std::lock_guard lock(m_mutex);
  const auto it = m_early.find(name);
  return it == m_early.end() ? nullptr : it->second.list;
}

void DisplayListTable::replaceEarly(const host::HostTable &host, GLuint name,
                                    std::shared_ptr<const DisplayList> list) {
  if (hasEarly())
    forgetEarly(host, name, 1);
  if (!list)
    return;
  constexpr std::size_t kMaxBytes = std::size_t(64) << 20;
  std::size_t bytes = 0;
  for (const DisplayList::Item &item : list->items)
    bytes += item.geometry ? item.geometry->data.size() * sizeof(float) : 0;
  const std::lock_guard lock(m_mutex);
  if (m_earlyBytes + bytes > kMaxBytes)
    return;
  m_early[name] = {std::move(list), bytes};
  m_earlyBytes += bytes;
  m_earlyCount.store(m_early.size(), std::memory_order_release);
}

void DisplayListTable::forgetEarly(const host::HostTable &host, GLuint first, GLuint count) {
  while (true) {
    std::shared_ptr<const DisplayList> old;
    GLuint name = 0;
    {
      const std::lock_guard lock(m_mutex);
      const auto isIn = [&](const auto &entry) { return entry.first - first < count; };
      const auto it =
          count == 1 ? m_early.find(first) : std::find_if(m_early.begin(), m_early.end(), isIn);
      if (it == m_early.end())
        return;
      name = it->first;
      old = std::move(it->second.list);
      m_earlyBytes -= it->second.bytes;
      m_early.erase(it);
      m_earlyCount.store(m_early.size(), std::memory_order_release);
    }
    giveBackSegments(host, *old, name);
  }
}

void DisplayListTable::giveBack(const host::HostTable &host, GLuint segment) {
  host.DeleteLists(segment, 1);
  const std::lock_guard lock(m_mutex);
  m_segments.erase(segment);
  try {
    m_free.push_back(segment);
  } catch (const std::bad_alloc &) { // one segment name less is no loss
  }
}

GLuint DisplayListTable::takeSegmentName(const host::HostTable &host) {
  const std::lock_guard lock(m_mutex);
  GLuint name = 0;
  // The application may use names up here itself; those are skipped.
  while (name == 0 || host.IsList(name) == GL_TRUE) {
    if (m_free.empty()) {
      name = m_next--;
    } else {
      name = m_free.back();
      m_free.pop_back();
    }
  }
  m_segments.insert(name); // without memory the name is lost, and nothing else
  m_used.store(true, std::memory_order_release);
  return name;
}

GLuint DisplayListTable::generate(const host::HostTable &host, GLsizei count) {
  const std::lock_guard lock(m_mutex);
  const auto wanted = GLuint(count);
  GLuint first = m_nextGenerated;
  GLuint found = 0;
  for (GLuint name = first; found < wanted; ++name) {
    if (name == 0 || name > m_next)
      return 0;
    if (host.IsList(name) == GL_TRUE) {
      first = name + 1;
      found = 0;
    } else {
      ++found;
    }
  }
  for (GLuint name = first; name != first + wanted; ++name) {
    host.NewList(name, GL_COMPILE);
    host.EndList();
  }
  m_nextGenerated = first + wanted;
  return first;
}

bool DisplayListTable::isSegment(GLuint name) {
  const std::lock_guard lock(m_mutex);
  return m_segments.count(name) != 0;
}

std::vector<GLuint> DisplayListTable::namesIn(GLuint first, GLsizei count) {
  std::vector<GLuint> names;
  if (empty() || count <= 0)
    return names;
  const std::lock_guard lock(m_mutex);
  for (const auto &[name, list] : m_lists)
    if (name - first < GLuint(count))
      names.push_back(name);
  return names;
}

std::vector<GLuint> DisplayListTable::segmentsIn(GLuint first, GLsizei count) {
  std::vector<GLuint> names;
  const std::lock_guard lock(m_mutex);
  for (const GLuint name : m_segments)
    if (name - first < GLuint(count))
      names.push_back(name);
  return names;
}

} // namespace arbiter::state
