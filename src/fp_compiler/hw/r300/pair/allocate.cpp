#include "fp_compiler/hw/r300/pair/allocate.h"

#include <algorithm>

namespace arbiter::fp::hw::r300 {

namespace {
/// When each component holds a value. Reads happen at even times, writes at the odd time after.
struct Lifetime {
  std::uint32_t first = 0xFFFFFFFF;
  std::array<std::uint32_t, 4> from = {0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF};
  std::array<std::uint32_t, 4> to = {0, 0, 0, 0};
};

class Lifetimes {
public:
  Lifetimes(const Flow &flow, const Plan &plan) : m_flow(flow), m_lifetimes(flow.items.size()) {
    for (ItemId id = 0; id < flow.items.size(); ++id)
      if (flow.items[id].live && flow.items[id].kind == Item::Kind::Interpolant)
        writes(id);
    for (const Node &node : plan.nodes) {
      // Samples run one after the other, so that none overwrites what a later one reads.
      for (std::uint32_t i = 0; i < node.textures; ++i)
        step(plan.textures[node.firstTexture + i], kNoItem);
      for (std::uint32_t i = 0; i < node.pairs; ++i)
        step(plan.slots[node.firstPair + i].rgb, plan.slots[node.firstPair + i].alpha);
    }
  }
  [[nodiscard]] const std::vector<Lifetime> &all() const { return m_lifetimes; }

private:
  void step(ItemId one, ItemId other) {
    m_now += 2;
    for (const ItemId id : {one, other})
      if (id != kNoItem)
        forEachRead(m_flow.items[id], [&](ItemId read, std::uint8_t component) {
          m_lifetimes[m_flow.parent[read]].to[component] = m_now;
        });
    for (const ItemId id : {one, other})
      if (id != kNoItem)
        writes(id);
  }

  void writes(ItemId id) {
    Lifetime &life = m_lifetimes[m_flow.parent[id]];
    const Item &item = m_flow.items[id];
    if (item.mask == 0)
      return;
    life.first = std::min(life.first, m_now + 1);
    for (std::size_t c = 0; c < 4; ++c)
      if (item.mask >> c & 1) {
        life.from[c] = std::min(life.from[c], m_now + 1);
        life.to[c] = std::max(life.to[c], m_now + 1);
      }
  }

  const Flow &m_flow;
  std::vector<Lifetime> m_lifetimes;
  std::uint32_t m_now = 0;
};
} // namespace

std::vector<std::uint16_t> allocate(const Flow &flow, const Plan &plan) {
  const Lifetimes lifetimes(flow, plan);
  std::vector<std::pair<std::uint32_t, ItemId>> order;
  for (ItemId id = 0; id < flow.items.size(); ++id)
    if (lifetimes.all()[id].first != 0xFFFFFFFF)
      order.emplace_back(lifetimes.all()[id].first, id);
  std::sort(order.begin(), order.end());
  std::vector<std::uint16_t> registers(flow.items.size(), kNone);
  std::vector<std::array<std::uint32_t, 4>> taken; // until when each component is taken
  for (const auto &[first, web] : order) {
    const Lifetime &life = lifetimes.all()[web];
    std::size_t at = 0;
    for (; at < taken.size(); ++at) {
      bool fits = true;
      for (std::size_t c = 0; c < 4; ++c)
        fits &= life.from[c] == 0xFFFFFFFF || taken[at][c] < life.from[c];
      if (fits)
        break;
    }
    if (at == taken.size())
      taken.push_back({});
    for (std::size_t c = 0; c < 4; ++c)
      if (life.from[c] != 0xFFFFFFFF)
        taken[at][c] = life.to[c];
    registers[web] = std::uint16_t(at);
  }
  return registers;
}

} // namespace arbiter::fp::hw::r300
