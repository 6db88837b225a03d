#include <algorithm>

#include "fp_compiler/hw/r300/lower/emitter.h"

/// Decides which operations share a virtual register. The order of the list must stay valid for it.
namespace arbiter::fp::hw::r300 {

bool Emitter::readable(const Ref &ref) {
  return ref.kind != Ref::Kind::Item || isCurrent(ref) ||
         m_flow.versions[m_flow.web(ref.index)][ref.component] == 1;
}

bool Emitter::isCurrent(const Ref &ref) const {
  const Variable variable = m_flow.items[ref.index].variables[ref.component];
  if (variable >= m_current.size())
    return true;
  const Ref &now = m_current[variable].direct[ref.component];
  return now.kind == Ref::Kind::Item && now.index == ref.index && now.component == ref.component;
}

/// Renames the destination if an operation reads what an earlier operation of the same instruction
/// overwrites. Fresh variables then take its new components.
void Emitter::avoidHazard(const Item &item) {
  if (m_written == 0 || m_renamed)
    return;
  forEachRead(item, [&](ItemId read, std::uint8_t component) {
    m_renamed |=
        m_flow.items[read].variables[component] == m_destination && (m_written >> component & 1);
  });
  if (!m_renamed)
    return;
  for (const ItemId piece : m_pieces)
    for (std::size_t c = 0; c < 4; ++c)
      if (m_flow.items[piece].variables[c] == m_destination) {
        m_flow.items[piece].variables[c] = m_nextVariable++;
        m_flow.variables[piece][c] = m_flow.items[piece].variables[c];
      }
}

ItemId Emitter::add(Item item, std::uint8_t mask, bool toDestination) {
  item.mask = mask;
  avoidHazard(item);
  const ItemId id = ItemId(m_flow.items.size());
  std::array<Variable, 4> variables;
  std::array<std::uint8_t, 4> versions;
  for (std::size_t c = 0; c < 4; ++c) {
    const bool written = mask >> c & 1;
    if (written && toDestination && !m_renamed)
      item.variables[c] = m_destination;
    else if (written || item.replicated)
      item.variables[c] = m_nextVariable++;
    variables[c] = written ? item.variables[c] : kNoVariable;
    versions[c] = written ? 1 : 0;
  }
  if (toDestination) {
    m_written |= mask;
    m_pieces.push_back(id);
  }
  m_flow.items.push_back(item);
  m_flow.parent.push_back(id);
  m_flow.variables.push_back(variables);
  m_flow.versions.push_back(versions);
  return id;
}

/// Lets an old version of a component live beside the new one, as a version of a fresh variable. It
/// must be the only version in its web.
bool Emitter::splitOff(std::span<const Ref> refs, const Ref &ref, bool commit) {
  const ItemId root = m_flow.web(ref.index);
  if (m_flow.versions[root][ref.component] != 1)
    return false;
  for (const Ref &other : refs) {
    const ItemId web = m_flow.web(other.index);
    if (web != root && m_flow.variables[web][ref.component] != kNoVariable)
      return false;
  }
  if (commit)
    m_flow.items[ref.index].variables[ref.component] = m_flow.variables[root][ref.component] =
        m_nextVariable++;
  return true;
}

/// Returns whether the items may share one register, and if \p commit is set joins them.
bool Emitter::join(std::span<const Ref> refs, bool commit) {
  for (const Ref &ref : refs)
    if (!isCurrent(ref) && !splitOff(refs, ref, commit))
      return false;
  const ItemId root = m_flow.web(refs[0].index);
  std::array<Variable, 4> merged = m_flow.variables[root];
  for (std::size_t i = 1; i < refs.size(); ++i) {
    if (refs[i].index == refs[i - 1].index)
      continue;
    const std::array<Variable, 4> &other = m_flow.variables[m_flow.web(refs[i].index)];
    for (std::size_t c = 0; c < 4; ++c) {
      if (other[c] == kNoVariable)
        continue;
      if (merged[c] != kNoVariable && merged[c] != other[c])
        return false;
      merged[c] = other[c];
    }
  }
  for (const Ref &ref : refs) {
    const Variable variable = m_flow.items[ref.index].variables[ref.component];
    if (merged[ref.component] != kNoVariable && merged[ref.component] != variable)
      return false;
    merged[ref.component] = variable;
  }
  if (commit)
    merge(refs, root, merged);
  return true;
}

void Emitter::merge(std::span<const Ref> refs, ItemId root,
                    const std::array<Variable, 4> &variables) {
  std::array<std::uint8_t, 4> &versions = m_flow.versions[root];
  const auto more = [&](std::size_t c, std::uint8_t by) {
    versions[c] = std::uint8_t(std::min(255, versions[c] + by));
  };
  for (const Ref &ref : refs) {
    const ItemId web = m_flow.web(ref.index);
    if (web != root) {
      for (std::size_t c = 0; c < 4; ++c)
        more(c, m_flow.versions[web][c]);
      m_flow.parent[web] = root;
    }
    std::uint8_t &mask = m_flow.items[ref.index].mask;
    if (!(mask >> ref.component & 1))
      more(ref.component, 1);
    mask |= std::uint8_t(1 << ref.component);
  }
  m_flow.variables[root] = variables;
}

} // namespace arbiter::fp::hw::r300
