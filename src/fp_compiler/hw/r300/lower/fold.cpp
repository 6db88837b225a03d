#include "fp_compiler/hw/r300/lower/fold.h"

#include <algorithm>

#include "fp_compiler/hw/r300/lower/pack.h"

namespace arbiter::fp::hw::r300 {

namespace {
using Bank = FlowArgument::Bank;

/// A constant that a select gives; its value is the select's distance from the first constant.
enum : std::uint8_t { kZero, kOne };

class Folder {
public:
  explicit Folder(Flow &flow) : m_flow(flow), m_uses(flow.items.size()) {}

  void run() {
    for (ItemId id = 0; id < m_flow.items.size(); ++id)
      if (m_flow.items[id].live)
        count(id);
    for (ItemId id = 0; id < m_flow.items.size(); ++id) {
      const Item &item = m_flow.items[id];
      if (item.live && (item.kind == Item::Kind::Rgb || item.kind == Item::Kind::Alpha ||
                        item.rgb == RgbOp::Dp3))
        // An operation that was folded in may have an argument that can be folded too.
        for (int i = 0; i < 4 && one(id); ++i)
          ;
    }
  }

private:
  struct Uses {
    ItemId reader = kNoItem; ///< the last reader
    bool many = false;       ///< read by more than one argument
  };

  /// Returns the arguments of an operation of one half.
  static auto &arguments(Item &item) {
    return item.kind == Item::Kind::Alpha ? item.alphaArguments : item.rgbArguments;
  }
  static const auto &arguments(const Item &item) {
    return item.kind == Item::Kind::Alpha ? item.alphaArguments : item.rgbArguments;
  }
  /// Returns the half that has the arguments. A Dp3's alpha half has none.
  static Item::Kind halfOf(const Item &item) {
    return item.kind == Item::Kind::Alpha ? Item::Kind::Alpha : Item::Kind::Rgb;
  }
  static bool isMad(const Item &item) {
    return item.kind == Item::Kind::Alpha ? item.alpha == AlphaOp::Mad : item.rgb == RgbOp::Mad;
  }
  static int argumentCount(const Item &item) {
    return item.kind == Item::Kind::Alpha ? argumentsOf(item.alpha, RgbOp::None)
                                          : argumentsOf(item.rgb);
  }

  void read(const FlowArgument &argument, std::uint8_t components, ItemId by) {
    if (argument.bank != Bank::Item)
      return;
    ItemId last = kNoItem;
    for (std::size_t c = 0; c < 3; ++c)
      if ((components >> c & 1) && argument.source[c] != last) {
        last = argument.source[c];
        Uses &uses = m_uses[last];
        uses.many |= uses.reader != kNoItem;
        uses.reader = by;
      }
  }

  void count(ItemId id) {
    const Item &item = m_flow.items[id];
    if (item.kind == Item::Kind::Interpolant)
      return;
    if (item.kind == Item::Kind::Texture) {
      forEachRead(item, [&](ItemId read, std::uint8_t) { m_uses[read].many = true; });
      return;
    }
    const std::uint8_t components = rgbComponents(item);
    for (int i = 0; i < argumentsOf(item.rgb); ++i)
      read(item.rgbArguments[std::size_t(i)], components, id);
    for (int i = 0; i < argumentsOf(item.alpha, item.rgb); ++i)
      read(item.alphaArguments[std::size_t(i)], 1, id);
    if (item.presubtract != Presubtract::None)
      for (const FlowArgument &argument : item.presubtracted)
        read(argument, item.kind == Item::Kind::Alpha ? 1 : components, id);
  }

  /// Folds one argument. Returns false if there is none to fold.
  bool one(ItemId id) {
    const Item &item = m_flow.items[id];
    for (int i = 0; i < argumentCount(item); ++i) {
      const ItemId inner = soleSource(item, arguments(item)[std::size_t(i)]);
      if (inner == kNoItem)
        continue;
      Item folded = item;
      if ((copied(folded, std::size_t(i), inner) || product(folded, std::size_t(i), inner) ||
           presubtracted(folded, std::size_t(i), inner) ||
           expanded(folded, std::size_t(i), inner)) &&
          packsAlone(m_flow, folded)) {
        m_flow.items[id] = folded;
        m_flow.items[inner].live = false;
        return true;
      }
    }
    return false;
  }

  /// Returns the operation of the same half that only this argument reads.
  ItemId soleSource(const Item &item, const FlowArgument &argument) const {
    if (argument.bank != Bank::Item)
      return kNoItem;
    const std::uint8_t components = componentsOf(item);
    ItemId source = kNoItem;
    for (std::size_t c = 0; c < 3; ++c)
      if (components >> c & 1) {
        if (source != kNoItem && argument.source[c] != source)
          return kNoItem;
        source = argument.source[c];
      }
    const Item &inner = m_flow.items[source];
    if (m_uses[source].many || inner.kind != halfOf(item) || inner.outputMask || inner.depth ||
        inner.clamp || inner.replicated || !stable(inner))
      return kNoItem;
    return source;
  }

  static std::uint8_t componentsOf(const Item &item) {
    return item.kind == Item::Kind::Alpha ? std::uint8_t(1) : rgbComponents(item);
  }

  /// True if the sources of the operation still hold their values later.
  bool stable(const Item &item) const {
    bool result = true;
    forEachRead(item, [&](ItemId read, std::uint8_t component) {
      result &= m_flow.versions[m_flow.parent[read]][component] == 1;
    });
    return result;
  }

  /// Combines an argument of the inner operation with the argument through which the outer one
  /// reads it.
  static bool composed(const Item &item, const FlowArgument &outer, const FlowArgument &argument,
                       FlowArgument &result) {
    result = argument;
    if (argument.bank == Bank::None && !argument.presubtracted)
      return true;
    if (item.kind == Item::Kind::Alpha)
      return outer.select == std::uint8_t(AlphaSelect::W);
    const std::uint8_t components = rgbComponents(item);
    for (std::size_t c = 0; c < 3; ++c)
      if ((components >> c & 1) && kTaps[outer.select][c] > 2)
        return false;
    for (std::uint8_t select = 0; select < std::uint8_t(RgbSelect::Zero); ++select) {
      bool fits = true;
      for (std::size_t c = 0; c < 3; ++c)
        if (components >> c & 1) {
          const std::size_t at = kTaps[outer.select][c];
          fits &= kTaps[select][c] == kTaps[argument.select][at];
          if (argument.bank == Bank::Item)
            result.source[c] = argument.source[at];
        }
      if (fits) {
        result.select = select;
        return !argument.presubtracted || select <= std::uint8_t(RgbSelect::Zzz);
      }
    }
    return false;
  }

  static bool isConstant(const Item &item, const FlowArgument &argument, std::uint8_t which) {
    const std::uint8_t base = item.kind == Item::Kind::Alpha ? std::uint8_t(AlphaSelect::Zero)
                                                             : std::uint8_t(RgbSelect::Zero);
    return argument.bank == Bank::None && !argument.presubtracted &&
           argument.select == base + which;
  }

  /// Returns the index of the factor that is not 1 in `factor*1`; 3 if there is none.
  static std::size_t soleFactor(const Item &item) {
    const auto &list = arguments(item);
    for (const std::size_t i : {0, 1})
      if (isConstant(item, list[1 - i], kOne))
        return i;
    return 3;
  }

  /// Moves the presubtract of \p inner to the outer operation. Returns false if that has its own.
  static bool takesPresubtract(Item &item, const FlowArgument &outer, const Item &inner) {
    if (inner.presubtract == Presubtract::None)
      return true;
    if (item.presubtract != Presubtract::None)
      return false;
    item.presubtract = inner.presubtract;
    for (std::size_t i = 0; i < 2; ++i)
      if (inner.presubtracted[i].bank != Bank::None &&
          !composed(item, outer, inner.presubtracted[i], item.presubtracted[i]))
        return false;
    return true;
  }

  /// Folds a copy of \p inner that clamps or scales: the copy does inner's operation instead.
  bool copied(Item &item, std::size_t index, ItemId id) const {
    const Item &inner = m_flow.items[id];
    const FlowArgument outer = arguments(item)[index];
    if (!isMad(item) || soleFactor(item) != index || outer.absolute || outer.negate ||
        !isConstant(item, arguments(item)[2], kZero) || inner.modifier != Modifier::One ||
        arguments(item)[1 - index].negate || isDot(inner.rgb))
      return false;
    if (!takesPresubtract(item, outer, inner))
      return false;
    item.rgb = inner.rgb;
    item.alpha = inner.alpha;
    item.cause = inner.cause;
    item.origin = inner.origin;
    for (int i = 0; i < argumentCount(inner); ++i)
      if (!composed(item, outer, arguments(inner)[std::size_t(i)], arguments(item)[std::size_t(i)]))
        return false;
    return true;
  }

  /// Folds a product a*b into a sum.
  bool product(Item &item, std::size_t index, ItemId id) const {
    const Item &inner = m_flow.items[id];
    if (!isMad(item) || !isMad(inner) || inner.modifier != Modifier::One ||
        !isConstant(inner, arguments(inner)[2], kZero))
      return false;
    const std::size_t factor = soleFactor(item);
    if (factor == 3 || (index != 2 && index != factor))
      return false;
    auto &list = arguments(item);
    const FlowArgument outer = list[index];
    if (outer.absolute)
      return false;
    // The other summand gets the sign of the 1 that it may be multiplied by.
    FlowArgument rest = list[index == 2 ? factor : 2];
    bool negate = outer.negate;
    (index == 2 ? rest.negate : negate) ^= list[1 - factor].negate;
    // |x|*(-1) is -|x|, because the sign applies after the magnitude.
    if (!takesPresubtract(item, outer, inner))
      return false;
    FlowArgument a, b;
    if (!composed(item, outer, arguments(inner)[0], a) ||
        !composed(item, outer, arguments(inner)[1], b))
      return false;
    a.negate ^= negate;
    list = {a, b, rest};
    return true;
  }

  /// True if everything that the item reads through \p argument is 2 in constant memory.
  bool isTwo(const Item &item, const FlowArgument &argument) const {
    if (argument.bank != Bank::Row || !m_flow.rows[argument.source[0]].known)
      return false;
    const ir::Vec4 &row = m_flow.rows[argument.source[0]].constant.value;
    if (item.kind == Item::Kind::Alpha)
      return row[argument.select] == 2.0f;
    const std::uint8_t components = rgbComponents(item);
    for (std::size_t c = 0; c < 3; ++c)
      if ((components >> c & 1) && row[kTaps[argument.select][c]] != 2.0f)
        return false;
    return true;
  }

  /// Folds x*2 - 1, which restores the sign of a texture's numbers. The sign of a zero may change.
  bool expanded(Item &item, std::size_t index, ItemId id) const {
    const Item &inner = m_flow.items[id];
    const auto &list = arguments(inner);
    if (!isMad(inner) || inner.modifier != Modifier::One ||
        inner.presubtract != Presubtract::None || item.presubtract != Presubtract::None ||
        !isConstant(inner, list[2], kOne))
      return false;
    const std::size_t two = isTwo(inner, list[0]) ? 0 : 1;
    if (!isTwo(inner, list[two]))
      return false;
    FlowArgument &outer = arguments(item)[index];
    FlowArgument x;
    if (!composed(item, outer, list[1 - two], x))
      return false;
    x.negate ^= list[two].negate;
    if (!isPlain(item, x) || x.negate == list[2].negate)
      return false;
    item.presubtract = Presubtract::OneMinusTwoS0;
    item.presubtracted[0] = x;
    takeResult(outer, x.select, list[2].negate);
    return true;
  }

  /// True if a presubtract can take the source: plain colours or one component, without magnitudes.
  static bool isPlain(const Item &item, const FlowArgument &source) {
    if (source.bank == Bank::None || source.absolute)
      return false;
    return item.kind == Item::Kind::Alpha ? source.select == std::uint8_t(AlphaSelect::W)
                                          : source.select <= std::uint8_t(RgbSelect::Zzz);
  }

  /// Makes the argument read the presubtract result, and applies the sign under its own.
  static void takeResult(FlowArgument &argument, std::uint8_t select, bool negate) {
    FlowArgument result;
    result.presubtracted = true;
    result.select = select;
    result.absolute = argument.absolute;
    result.negate = argument.negate ^ (negate && !argument.absolute);
    argument = result;
  }

  /// Folds a + b or a - b into a presubtract.
  bool presubtracted(Item &item, std::size_t index, ItemId id) const {
    const Item &inner = m_flow.items[id];
    if (!isMad(inner) || inner.modifier != Modifier::One ||
        inner.presubtract != Presubtract::None || item.presubtract != Presubtract::None)
      return false;
    const std::size_t factor = soleFactor(inner);
    if (factor == 3)
      return false;
    FlowArgument &outer = arguments(item)[index];
    FlowArgument x, y;
    if (!composed(item, outer, arguments(inner)[factor], x) ||
        !composed(item, outer, arguments(inner)[2], y))
      return false;
    x.negate ^= arguments(inner)[1 - factor].negate;
    if (isConstant(item, x, kOne))
      std::swap(x, y);
    bool negate = false;
    if (isConstant(item, y, kOne)) {
      if (!isPlain(item, x) || x.negate == y.negate)
        return false;
      item.presubtract = Presubtract::OneMinusS0;
      negate = y.negate;
    } else {
      if (!isPlain(item, x) || !isPlain(item, y) || x.select != y.select)
        return false;
      item.presubtract = x.negate == y.negate ? Presubtract::S1PlusS0 : Presubtract::S1MinusS0;
      // Source 1 is the one without a sign.
      negate = x.negate && y.negate;
      if (item.presubtract == Presubtract::S1MinusS0 && !x.negate)
        std::swap(x, y);
      item.presubtracted[1] = y;
    }
    item.presubtracted[0] = x;
    takeResult(outer, x.select, negate);
    return true;
  }

  Flow &m_flow;
  std::vector<Uses> m_uses;
};
} // namespace

void fold(Flow &flow) { Folder(flow).run(); }

} // namespace arbiter::fp::hw::r300
