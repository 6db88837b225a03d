#include "interposer/registry.h"

#include <cstdint>
#include <exception>
#include <mutex>
#include <vector>

#include <pthread.h>

namespace arbiter::interposer::registry {

namespace {

struct Entry {
  Key key;
  state::Context *context;
};

struct Registry {
  std::mutex mutex;
  std::vector<Entry> entries;
  /// Holds the mark of the thread's current provider. Its destructor unbinds the context when the
  /// thread ends.
  pthread_key_t current{};
};

void threadEnds(void *) { state::makeCurrent(nullptr, nullptr); }

/// Returns the registry. It is never destroyed: threads of the application may outlive the
/// library's destructors.
Registry &registry() {
  static Registry *const s_registry = [] {
    auto *made = new Registry;
    pthread_key_create(&made->current, threadEnds);
    return made;
  }();
  return *s_registry;
}

/// True if the keys name the same context. GLX handles are unique across displays, and one may be
/// used over another connection to the same server. The display only decides which contexts are
/// destroyed when it is closed.
bool same(const Key &a, const Key &b) {
  return a.provider == b.provider && a.handle == b.handle &&
         (a.provider == Provider::Glx || a.display == b.display);
}

Entry *find(Registry &r, const Key &key) {
  for (Entry &entry : r.entries)
    if (same(entry.key, key))
      return &entry;
  return nullptr;
}

/// The thread-specific value for each provider; only its address matters.
constexpr Provider kMarks[] = {Provider::Glx, Provider::Egl, Provider::OsMesa};

const void *mark(Provider provider) { return &kMarks[std::size_t(provider)]; }

void setCurrent(const void *value) { pthread_setspecific(registry().current, value); }

} // namespace

bool created(const Key &key, const host::HostTable &table, const void *shareHandle,
             bool indirect) try {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  state::Context *share = nullptr;
  if (shareHandle)
    if (const Entry *entry = find(r, {key.provider, key.display, shareHandle}))
      share = entry->context;
  r.entries.reserve(r.entries.size() + 1); // a context that was created must be found
  state::Context *const context = state::createContext(key.provider, &table, share, indirect);
  if (Entry *replaced = find(r, key)) {
    state::destroyContext(replaced->context);
    *replaced = {key, context};
  } else {
    r.entries.push_back({key, context});
  }
  return true;
} catch (const std::exception &) {
  return false;
}

void destroyed(const Key &key) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  Entry *const entry = find(r, key);
  if (!entry)
    return;
  state::destroyContext(entry->context);
  *entry = r.entries.back();
  r.entries.pop_back();
}

bool madeCurrent(const Key &key, const host::HostTable &table,
                 const state::Drawable *drawable) try {
  if (!key.handle) {
    if (isCurrent(key.provider)) {
      state::makeCurrent(nullptr, nullptr);
      setCurrent(nullptr);
    }
    return true;
  }
  state::Context *context = nullptr;
  {
    Registry &r = registry();
    const std::lock_guard lock(r.mutex);
    Entry *entry = find(r, key);
    if (!entry) {
      r.entries.reserve(r.entries.size() + 1);
      r.entries.push_back({key, state::createContext(key.provider, &table, nullptr)});
      entry = &r.entries.back();
    }
    context = entry->context;
  }
  state::makeCurrent(context, drawable);
  setCurrent(mark(key.provider));
  return true;
} catch (const std::exception &) {
  state::makeCurrent(nullptr, nullptr); // this allocates nothing
  setCurrent(nullptr);
  return false;
}

void copied(const Key &from, const Key &to, unsigned long mask) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  const Entry *const source = find(r, from);
  const Entry *const target = find(r, to);
  if (source && target)
    state::copyContext(*source->context, *target->context, std::uint32_t(mask));
}

void displayClosed(Provider provider, const void *display) {
  Registry &r = registry();
  const std::lock_guard lock(r.mutex);
  for (std::size_t i = r.entries.size(); i-- > 0;) {
    if (r.entries[i].key.provider != provider || r.entries[i].key.display != display)
      continue;
    state::destroyContext(r.entries[i].context);
    r.entries[i] = r.entries.back();
    r.entries.pop_back();
  }
}

bool isCurrent(Provider provider) {
  return pthread_getspecific(registry().current) == mark(provider);
}

} // namespace arbiter::interposer::registry
