#pragma once
#include <memory>
#include <unordered_map>

#include "fp_compiler/ir/interface.h"

namespace arbiter::state {

/// A context's data for each program that it drew with. An entry begins as `Entry{source}`, and its
/// address is stable. When there are too many, all but the effective one are dropped.
template <typename Entry> class ProgramTable {
public:
  /// Finds or adds an entry.
  /// \param effective the last draw's entry, or null; it is found without a search and never
  /// dropped
  [[nodiscard]] Entry &find(const std::shared_ptr<const fp::ir::Program> &source,
                            Entry *effective) {
    if (effective && effective->source == source)
      return *effective;
    if (m_entries.size() >= kMax)
      std::erase_if(m_entries, [&](const auto &item) { return &item.second != effective; });
    Entry &entry = m_entries[source.get()];
    if (!entry.source)
      entry.source = source; // keeps the program alive, so that its address stays unique
    return entry;
  }

private:
  static constexpr std::size_t kMax = 512;
  std::unordered_map<const fp::ir::Program *, Entry> m_entries;
};

} // namespace arbiter::state
