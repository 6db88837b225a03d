#include "fp_compiler/hw/r300/pair/schedule.h"

#include <algorithm>
#include <cassert>
#include <functional>

#include "fp_compiler/hw/r300/lower/move.h"

namespace arbiter::fp::hw::r300 {

namespace {
class Scheduler {
public:
  explicit Scheduler(Flow &flow)
      : m_flow(flow), m_states(flow.items.size()), m_movable(movableItems(flow)) {}

  Plan run() {
    dependencies();
    levels();
    for (std::uint32_t node = 0; node <= m_last; ++node)
      fill(node);
    return std::move(m_plan);
  }

private:
  static constexpr std::size_t kWindow = 64;
  static constexpr std::uint64_t kIdMask = 0xFFFFFFF;

  struct Edge {
    ItemId from, to;
    bool reads; ///< false: `to` overwrites what `from` reads, so both may be TEX of one node
  };
  struct State {
    std::uint32_t level = 0, deadline = 0, height = 0;
    std::uint32_t waiting = 0; ///< how many items it waits for
    std::uint32_t first = 0;   ///< its first edge in m_edges, which are sorted by `from`
  };

  [[nodiscard]] bool isTexture(ItemId id) const {
    return m_flow.items[id].kind == Item::Kind::Texture;
  }

  void dependencies() {
    std::vector<Edge> edges;
    edges.reserve(m_flow.items.size() * 4);
    std::vector<std::array<ItemId, 4>> writer(m_flow.items.size(),
                                              {kNoItem, kNoItem, kNoItem, kNoItem});
    for (ItemId id = 0; id < m_flow.items.size(); ++id) {
      const Item &item = m_flow.items[id];
      if (!item.live || item.kind == Item::Kind::Interpolant)
        continue;
      const std::size_t before = edges.size();
      forEachRead(item, [&](ItemId read, std::uint8_t) {
        if (m_flow.items[read].kind == Item::Kind::Interpolant)
          return;
        for (std::size_t i = before; i < edges.size(); ++i)
          if (edges[i].from == read)
            return;
        edges.push_back({read, id, true});
      });
      for (std::uint8_t c = 0; c < 4; ++c)
        if (item.mask >> c & 1) {
          ItemId &last = writer[m_flow.parent[id]][c];
          if (last != kNoItem)
            overwrites(last, id, c, edges);
          last = id;
        }
    }
    // Counting sort: count the edges of each item, then put them in place.
    for (const Edge &edge : edges) {
      ++m_states[edge.from].first;
      ++m_states[edge.to].waiting;
    }
    std::uint32_t sum = 0;
    for (State &state : m_states) {
      sum += state.first;
      state.first = sum;
    }
    m_edges.resize(edges.size());
    for (std::size_t i = edges.size(); i-- > 0;)
      m_edges[--m_states[edges[i].from].first] = edges[i];
  }

  void overwrites(ItemId last, ItemId id, std::uint8_t component, std::vector<Edge> &edges) {
    edges.push_back({last, id, true});
    for (ItemId between = last + 1; between < id; ++between)
      if (m_flow.items[between].live)
        forEachRead(m_flow.items[between], [&](ItemId read, std::uint8_t c) {
          if (read == last && c == component)
            edges.push_back({between, id, false});
        });
  }

  template <typename Visit> void forEachEdge(ItemId id, Visit visit) const {
    const std::size_t end = id + 1 < m_states.size() ? m_states[id + 1].first : m_edges.size();
    for (std::size_t i = m_states[id].first; i < end; ++i)
      visit(m_edges[i]);
  }

  /// Finds for each item the first and the last node it can be in, and its longest path to the end
  /// of the last one.
  void levels() {
    for (ItemId id = 0; id < m_flow.items.size(); ++id) {
      if (!m_flow.items[id].live)
        continue;
      const bool texture = isTexture(id);
      m_last = std::max(m_last, m_states[id].level);
      forEachEdge(id, [&](const Edge &edge) {
        const std::uint32_t step = isTexture(edge.to) && (edge.reads || !texture) ? 1 : 0;
        m_states[edge.to].level = std::max(m_states[edge.to].level, m_states[id].level + step);
      });
    }
    for (ItemId id = ItemId(m_flow.items.size()); id-- > 0;) {
      State &state = m_states[id];
      state.deadline = m_last;
      if (!m_flow.items[id].isAlu() || !m_flow.items[id].live)
        continue;
      forEachEdge(id, [&](const Edge &edge) {
        const State &to = m_states[edge.to];
        const bool texture = isTexture(edge.to);
        state.deadline = std::min(state.deadline, texture ? to.level - 1 : to.deadline);
        state.height = std::max(state.height, texture ? 1 : to.height + 1);
      });
      m_waitingFor.resize(m_last + 1);
      ++m_waitingFor[state.deadline];
    }
    m_waitingFor.resize(m_last + 1);
    for (ItemId id = 0; id < m_flow.items.size(); ++id) {
      const Item &item = m_flow.items[id];
      if (item.live && item.isAlu() && m_states[id].waiting == 0)
        queue(id);
      else if (item.live && isTexture(id))
        m_textures.push_back(id);
    }
    std::stable_sort(m_textures.begin(), m_textures.end(),
                     [this](ItemId a, ItemId b) { return m_states[a].level < m_states[b].level; });
  }

  void release(ItemId id) {
    forEachEdge(id, [&](const Edge &edge) {
      if (--m_states[edge.to].waiting == 0 && !isTexture(edge.to))
        queue(edge.to);
    });
  }

  void queue(ItemId id) {
    m_queue.push_back(key(id));
    std::push_heap(m_queue.begin(), m_queue.end(), std::greater<>());
  }
  /// Fills the list of candidates. The limit keeps long programs from taking quadratic time.
  void refill() {
    for (; !m_queue.empty() && m_ready.size() < kWindow; m_queue.pop_back()) {
      std::pop_heap(m_queue.begin(), m_queue.end(), std::greater<>());
      m_ready.push_back(ItemId(m_queue.back() & kIdMask));
    }
  }

  void fill(std::uint32_t index) {
    Node node;
    node.firstTexture = std::uint32_t(m_plan.textures.size());
    node.firstPair = std::uint32_t(m_plan.slots.size());
    for (; m_nextTexture < m_textures.size() && m_states[m_textures[m_nextTexture]].level == index;
         ++m_nextTexture) {
      m_plan.textures.push_back(m_textures[m_nextTexture]);
      release(m_textures[m_nextTexture]);
    }
    refill();
    while (m_waitingFor[index] > 0)
      slot();
    // All operations of the last node may be overdue. A node without a slot takes whatever is
    // ready.
    if (m_plan.slots.size() == node.firstPair)
      slot();
    node.textures = std::uint32_t(m_plan.textures.size()) - node.firstTexture;
    node.pairs = std::uint32_t(m_plan.slots.size()) - node.firstPair;
    m_plan.nodes.push_back(node);
  }

  /// Returns the priority; the lowest goes first. It orders by deadline, longest path and program
  /// order.
  [[nodiscard]] std::uint64_t key(ItemId id) const {
    const State &state = m_states[id];
    return std::uint64_t(std::min(state.deadline, 0xFFFFu)) << 48 |
           std::uint64_t(0xFFFFF - std::min(state.height, 0xFFFFFu)) << 28 | (id & kIdMask);
  }

  void take(std::size_t at) {
    const ItemId id = m_ready[at];
    m_ready[at] = m_ready.back();
    m_ready.pop_back();
    --m_waitingFor[m_states[id].deadline];
    release(id);
  }

  void slot() {
    Plan::Slot slot;
    if (m_ready.empty()) {
      m_plan.slots.push_back(slot);
      return;
    }
    std::size_t best = 0;
    for (std::size_t i = 1; i < m_ready.size(); ++i)
      if (key(m_ready[i]) < key(m_ready[best]))
        best = i;
    const ItemId id = m_ready[best];
    if (m_flow.items[id].kind == Item::Kind::Both) {
      slot.rgb = slot.alpha = id;
      [[maybe_unused]] const bool fits =
          pack(m_flow, &m_flow.items[id], &m_flow.items[id], slot.packed);
      assert(fits);
      take(best);
    } else {
      take(best);
      partner(id, slot);
    }
    m_plan.slots.push_back(slot);
    refill();
  }

  /// Moves an operation that has not been placed to the other unit.
  void move(ItemId id) {
    m_flow.items[id] = moved(m_flow.items[id]);
    const std::uint8_t component = m_flow.items[id].kind == Item::Kind::Alpha ? 3 : 0;
    forEachEdge(id, [&](const Edge &edge) { readMoved(m_flow.items[edge.to], id, component); });
  }

  /// True if the readers of \p id still fit into a pair after it changes its unit. Three arguments
  /// always fit, but a Dp4 has four, and a presubtract needs addresses of its own.
  [[nodiscard]] bool mayMove(ItemId id) const {
    if (!m_movable[id])
      return false;
    bool fits = true;
    forEachEdge(id, [&](const Edge &edge) {
      const Item &reader = m_flow.items[edge.to];
      if (!fits || (reader.rgb != RgbOp::Dp4 && reader.presubtract == Presubtract::None))
        return;
      Item changed = reader;
      readMoved(changed, id, m_flow.items[id].kind == Item::Kind::Rgb ? 3 : 0);
      fits = packsAlone(m_flow, changed);
    });
    return fits;
  }

  [[nodiscard]] bool packs(const Item &one, const Item &other, Packed &packed) const {
    return one.kind == Item::Kind::Rgb ? pack(m_flow, &one, &other, packed)
                                       : pack(m_flow, &other, &one, packed);
  }

  /// Pairs \p id with the best operation of the other half. Either may change its unit for that.
  void partner(ItemId id, Plan::Slot &slot) {
    const Item::Kind kind = m_flow.items[id].kind;
    std::size_t best = m_ready.size();
    ItemId mover = kNoItem;
    Packed packed;
    for (std::size_t i = 0; i < m_ready.size(); ++i) {
      const ItemId other = m_ready[i];
      const Item &one = m_flow.items[id], &item = m_flow.items[other];
      if (item.kind == Item::Kind::Both ||
          (best != m_ready.size() && key(other) > key(m_ready[best])))
        continue;
      ItemId moves = kNoItem;
      if (item.kind != kind) {
        if (!packs(one, item, packed))
          continue;
      } else if (mayMove(other) && packs(one, moved(item), packed)) {
        moves = other;
      } else if (mayMove(id) && packs(moved(one), item, packed)) {
        moves = id;
      } else {
        continue;
      }
      best = i;
      mover = moves;
      slot.packed = packed;
    }
    if (mover != kNoItem)
      move(mover);
    place(id, slot);
    if (best == m_ready.size()) {
      [[maybe_unused]] const bool fits =
          pack(m_flow, slot.rgb == id ? &m_flow.items[id] : nullptr,
               slot.alpha == id ? &m_flow.items[id] : nullptr, slot.packed);
      assert(fits);
      return;
    }
    place(m_ready[best], slot);
    take(best);
  }

  void place(ItemId id, Plan::Slot &slot) {
    (m_flow.items[id].kind == Item::Kind::Rgb ? slot.rgb : slot.alpha) = id;
  }

  Flow &m_flow;
  std::vector<State> m_states;
  std::vector<std::uint8_t> m_movable;
  std::vector<Edge> m_edges;
  std::vector<std::uint32_t> m_waitingFor; ///< operations left to place, by deadline
  std::vector<ItemId> m_ready;             ///< the best of the items that wait for nothing
  std::vector<std::uint64_t>
      m_queue; ///< the other items that wait for nothing: a heap of keys, lowest first
  std::vector<ItemId> m_textures; ///< ordered by level
  std::size_t m_nextTexture = 0;
  std::uint32_t m_last = 0;
  Plan m_plan;
};
} // namespace

Plan schedule(Flow &flow) { return Scheduler(flow).run(); }

} // namespace arbiter::fp::hw::r300
