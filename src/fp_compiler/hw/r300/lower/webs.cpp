#include <algorithm>

#include "fp_compiler/hw/r300/lower/emitter.h"

/// Which operations share a virtual register, so that the order of the list stays right for it.
namespace arbiter::fp::hw::r300 {

bool Emitter::readable(const Ref &ref) {
  return ref.kind != Ref::Kind::Item || isCurrent(ref) ||
         m_flow.versions[m_flow.web(ref.index)][ref.component] == 1;
}

bool Emitter::isCurrent(const Ref &ref) const {
  const Home home = m_flow.items[ref.index].home[ref.component];
  if (home >= m_current.size())
    return true;
  const Ref &now = m_current[home].direct[ref.component];
  return now.kind == Ref::Kind::Item && now.index == ref.index && now.component == ref.component;
}

/// An operation that reads what an earlier one of the same instruction overwrites: the destination
/// becomes something of its own.
void Emitter::avoidHazard(const Item &item) {
  if (m_written == 0 || m_ownHome)
    return;
  forEachRead(item, [&](ItemId read, std::uint8_t component) {
    m_ownHome |= m_flow.items[read].home[component] == m_home && (m_written >> component & 1);
  });
  if (!m_ownHome)
    return;
  for (const ItemId piece : m_pieces)
    for (std::size_t c = 0; c < 4; ++c)
      if (m_flow.items[piece].home[c] == m_home) {
        m_flow.items[piece].home[c] = m_nextHome++;
        m_flow.homes[piece][c] = m_flow.items[piece].home[c];
      }
}

ItemId Emitter::add(Item item, std::uint8_t mask, bool home) {
  item.mask = mask;
  avoidHazard(item);
  const ItemId id = ItemId(m_flow.items.size());
  std::array<Home, 4> homes;
  std::array<std::uint8_t, 4> versions;
  for (std::size_t c = 0; c < 4; ++c) {
    const bool written = mask >> c & 1;
    if (written && home && !m_ownHome)
      item.home[c] = m_home;
    else if (written || item.replicated)
      item.home[c] = m_nextHome++;
    homes[c] = written ? item.home[c] : kNoHome;
    versions[c] = written ? 1 : 0;
  }
  if (home) {
    m_written |= mask;
    m_pieces.push_back(id);
  }
  m_flow.items.push_back(item);
  m_flow.parent.push_back(id);
  m_flow.homes.push_back(homes);
  m_flow.versions.push_back(versions);
  return id;
}

/// An old version of a register's component that is alone in its web may go on beside the new one:
/// it becomes something of its own.
bool Emitter::rehome(std::span<const Ref> refs, const Ref &ref, bool commit) {
  const ItemId root = m_flow.web(ref.index);
  if (m_flow.versions[root][ref.component] != 1)
    return false;
  for (const Ref &other : refs) {
    const ItemId web = m_flow.web(other.index);
    if (web != root && m_flow.homes[web][ref.component] != kNoHome)
      return false;
  }
  if (commit)
    m_flow.items[ref.index].home[ref.component] = m_flow.homes[root][ref.component] = m_nextHome++;
  return true;
}

/// Whether the items may be one register, and makes them so.
bool Emitter::join(std::span<const Ref> refs, bool commit) {
  for (const Ref &ref : refs)
    if (!isCurrent(ref) && !rehome(refs, ref, commit))
      return false;
  const ItemId root = m_flow.web(refs[0].index);
  std::array<Home, 4> merged = m_flow.homes[root];
  for (std::size_t i = 1; i < refs.size(); ++i) {
    if (refs[i].index == refs[i - 1].index)
      continue;
    const std::array<Home, 4> &other = m_flow.homes[m_flow.web(refs[i].index)];
    for (std::size_t c = 0; c < 4; ++c) {
      if (other[c] == kNoHome)
        continue;
      if (merged[c] != kNoHome && merged[c] != other[c])
        return false;
      merged[c] = other[c];
    }
  }
  for (const Ref &ref : refs) {
    const Home home = m_flow.items[ref.index].home[ref.component];
    if (merged[ref.component] != kNoHome && merged[ref.component] != home)
      return false;
    merged[ref.component] = home;
  }
  if (commit)
    merge(refs, root, merged);
  return true;
}

void Emitter::merge(std::span<const Ref> refs, ItemId root, const std::array<Home, 4> &homes) {
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
  m_flow.homes[root] = homes;
}

} // namespace arbiter::fp::hw::r300
