#pragma once
#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace arbiter::state {

struct CompiledProgram;

/// The variants of one program by the state that they are for. Each is made once. Contexts of a
/// share group use the same ones, and any thread may ask. There are few, so the search is linear.
template <typename Key> class Forms {
public:
  using Form = std::shared_ptr<const CompiledProgram>;

  /// Returns the variant for `key`; calls `make()` if there is none yet.
  template <typename Make> [[nodiscard]] Form of(const Key &key, Make make) const {
    const std::lock_guard lock(m_mutex);
    const auto it = std::find_if(m_forms.begin(), m_forms.end(),
                                 [&](const auto &form) { return form.first == key; });
    if (it != m_forms.end())
      return it->second;
    return m_forms.emplace_back(key, make()).second;
  }
  /// Returns all variants made so far.
  [[nodiscard]] std::vector<Form> all() const {
    const std::lock_guard lock(m_mutex);
    std::vector<Form> forms;
    for (const auto &form : m_forms)
      forms.push_back(form.second);
    return forms;
  }

private:
  mutable std::mutex m_mutex;
  mutable std::vector<std::pair<Key, Form>> m_forms;
};

} // namespace arbiter::state
