#pragma once
#include <algorithm>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace arbiter::state {

struct CompiledProgram;

/// What one program becomes under different state, by that state. Each form is made once; contexts
/// of a share group use the same ones, and any thread may ask. Few: they are looked for one by one.
template <typename Key> class Forms {
public:
  using Form = std::shared_ptr<const CompiledProgram>;

  /// The form under `key`; `make()`, which returns one, is called if there is none yet.
  template <typename Make> [[nodiscard]] Form of(const Key &key, Make make) const {
    const std::lock_guard lock(m_mutex);
    const auto it = std::find_if(m_forms.begin(), m_forms.end(),
                                 [&](const auto &form) { return form.first == key; });
    if (it != m_forms.end())
      return it->second;
    return m_forms.emplace_back(key, make()).second;
  }
  /// The forms that were asked for.
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
