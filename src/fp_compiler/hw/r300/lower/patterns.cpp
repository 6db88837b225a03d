#include <bit>

#include "fp_compiler/hw/r300/lower/emitter.h"
#include "fp_compiler/hw/r300/lower/pack.h"

/// Emits operations on several components at once: dot products, and comparisons and interpolations
/// that use a presubtract.
namespace arbiter::fp::hw::r300 {

namespace {
bool plainSource(const FlowArgument &argument) {
  return argument.bank != FlowArgument::Bank::None && !argument.absolute;
}
} // namespace

/// Puts numbers in constant memory so that the select of \p like reads them. Constants that need no
/// source are also allowed.
bool Emitter::literalLike(const Refs &refs, std::uint8_t components, const FlowArgument &like,
                          FlowArgument &argument) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((components >> c & 1) && refs[c].kind != Ref::Kind::Literal)
      return false;
  // A scalar should stay one that either unit can compute.
  const bool alpha = components == 8;
  if (std::has_single_bit(components) && like.bank == FlowArgument::Bank::Item)
    return false;
  // A select that repeats a component has room for only one number there.
  for (std::size_t c = 1; c < 3 && !alpha; ++c)
    for (std::size_t d = 0; d < c; ++d)
      if ((components >> c & 1) && (components >> d & 1) &&
          kTaps[like.select][c] == kTaps[like.select][d] &&
          std::bit_cast<std::uint32_t>(refs[c].value) !=
              std::bit_cast<std::uint32_t>(refs[d].value))
        return false;
  Refs values = refs;
  values[0] = alpha ? refs[3] : refs[0];
  const Rows::Place place = m_rows.at(values, alpha ? std::uint8_t(1) : components,
                                      alpha ? std::uint8_t(RgbSelect::Www) : like.select, m_origin);
  argument = {};
  argument.bank = FlowArgument::Bank::Row;
  argument.select = like.select;
  argument.negate = place.negate;
  argument.source[0] = place.row;
  return true;
}

/// Emits x - y as one argument of \p item, by a presubtract or because one of them is zero.
/// \param components of RGB, or 8 for the alpha half
bool Emitter::differenceOf(const Refs &x, const Refs &y, std::uint8_t components, Item &item,
                           FlowArgument &argument) {
  const bool alpha = components == 8;
  const auto takeOne = [&](const Refs &refs, FlowArgument &result) {
    return alpha ? takeAlpha(refs[3], result) : take(refs, components, result, true);
  };
  if (isLiteral(y, components, 0.0f))
    return takeOne(x, argument);
  if (isLiteral(x, components, 0.0f)) {
    if (!takeOne(y, argument))
      return false;
    argument.negate = !argument.negate;
    return true;
  }
  const auto usable = [&](const FlowArgument &source) {
    return plainSource(source) && (alpha ? source.select == std::uint8_t(AlphaSelect::W)
                                         : source.select <= std::uint8_t(RgbSelect::Zzz));
  };
  const bool oneMinus = isLiteral(x, components, 1.0f), minusOne = isLiteral(y, components, 1.0f);
  FlowArgument first, second;
  bool negate = false;
  if (oneMinus || minusOne) {
    if (!takeOne(oneMinus ? y : x, first) || !usable(first) || first.negate)
      return false;
    item.presubtract = Presubtract::OneMinusS0;
    negate = minusOne;
  } else {
    // Numbers are placed so that the select of the other operand reads them.
    const std::size_t at = std::size_t(std::countr_zero(components));
    const bool number = x[at].kind == Ref::Kind::Literal;
    if (number ? !takeOne(y, first) || !usable(first) : !takeOne(x, second) || !usable(second))
      return false;
    if (number ? !literalLike(x, components, first, second)
               : !literalLike(y, components, second, first) && !takeOne(y, first))
      return false;
    if (!usable(first) || !usable(second) || first.select != second.select)
      return false;
    // Source 0 is y, source 1 is x.
    item.presubtract =
        first.negate == second.negate ? Presubtract::S1MinusS0 : Presubtract::S1PlusS0;
    negate = second.negate;
    item.presubtracted[1] = second;
  }
  item.presubtracted[0] = first;
  argument = {};
  argument.select = first.select;
  argument.negate = negate;
  argument.presubtracted = true;
  return true;
}

bool Emitter::difference(const Value &x, const Value &y, std::uint8_t components, Item &item,
                         FlowArgument &argument) {
  return differenceOf(x.through, y.through, components, item, argument) ||
         differenceOf(x.direct, y.through, components, item, argument) ||
         differenceOf(x.through, y.direct, components, item, argument) ||
         differenceOf(x.direct, y.direct, components, item, argument);
}

/// Emits a compare in one half; difference() makes its argument C.
Value Emitter::compareHalf(std::uint8_t mask, const Value &x, const Value &y, float below,
                           float notBelow, const EmitOptions &options) {
  const bool alpha = mask == 8;
  Item item = like(alpha ? RgbOp::None : RgbOp::Cmp, alpha ? AlphaOp::Cmp : AlphaOp::None, options);
  item.kind = alpha ? Item::Kind::Alpha : Item::Kind::Rgb;
  auto &arguments = alpha ? item.alphaArguments : item.rgbArguments;
  if (!difference(x, y, mask, item, arguments[2])) {
    EmitOptions own;
    own.cause = options.cause;
    const Value rest = mad(mask, x, literals(1.0f), negated(y), own);
    const std::array<Value, 3> operands = {literals(notBelow), literals(below), rest};
    return componentwise(RgbOp::Cmp, AlphaOp::Cmp, mask, operands, options);
  }
  for (const std::size_t i : {0, 1}) {
    const Value number = literals(i == 0 ? notBelow : below);
    if (alpha)
      takeAlpha(number, 3, arguments[i]);
    else
      (void)take(number, mask, arguments[i], true);
  }
  const ItemId id = add(item, mask, options.toDestination);
  Value result;
  for (std::uint8_t c = 0; c < 4; ++c)
    result.direct[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
  result.through = result.direct;
  return result;
}

Value Emitter::compare(std::uint8_t mask, const Value &x, const Value &y, float below,
                       float notBelow, const EmitOptions &options) {
  Value result;
  for (const std::uint8_t half : {std::uint8_t(mask & 7), std::uint8_t(mask & 8)}) {
    if (half == 0)
      continue;
    const Value part = compareHalf(half, x, y, below, notBelow, options);
    for (std::size_t c = 0; c < 4; ++c)
      if (half >> c & 1)
        result.direct[c] = part.direct[c];
  }
  result.through = result.direct;
  return result;
}

Value Emitter::lerpHalf(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
                        const EmitOptions &options) {
  const bool alpha = mask == 8;
  Item item = like(alpha ? RgbOp::None : RgbOp::Mad, alpha ? AlphaOp::Mad : AlphaOp::None, options);
  item.kind = alpha ? Item::Kind::Alpha : Item::Kind::Rgb;
  item.mask = mask;
  auto &arguments = alpha ? item.alphaArguments : item.rgbArguments;
  bool fits = difference(b, c, mask, item, arguments[1]);
  if (fits && alpha) {
    takeAlpha(a, 3, arguments[0]);
    takeAlpha(c, 3, arguments[2]);
  } else if (fits) {
    fits = take(a, mask, arguments[0], true) && take(c, mask, arguments[2], true);
  }
  if (!fits || !packsAlone(m_flow, item)) {
    EmitOptions own;
    own.cause = options.cause;
    const Value rest = mad(mask, b, literals(1.0f), negated(c), own);
    return mad(mask, a, rest, c, options);
  }
  const ItemId id = add(item, mask, options.toDestination);
  Value result;
  for (std::uint8_t i = 0; i < 4; ++i)
    result.direct[i] = {Ref::Kind::Item, i, false, false, id, 0.0f};
  result.through = result.direct;
  return result;
}

Value Emitter::lerp(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
                    const EmitOptions &options) {
  return byHalves(mask, [&](std::uint8_t half) { return lerpHalf(half, a, b, c, options); });
}

Value Emitter::arch(std::uint8_t mask, const Value &f, const EmitOptions &options) {
  const bool alpha = mask == 8;
  Item item = like(alpha ? RgbOp::None : RgbOp::Mad, alpha ? AlphaOp::Mad : AlphaOp::None, options);
  item.kind = alpha ? Item::Kind::Alpha : Item::Kind::Rgb;
  item.modifier = Modifier::X4;
  item.presubtract = Presubtract::OneMinusTwoS0;
  if (alpha)
    takeAlpha(f, 3, item.presubtracted[0]);
  else
    (void)take(f, mask, item.presubtracted[0], true);
  // The presubtract result is n = -u, so the parabola is 4*(n|n| - n).
  FlowArgument n;
  n.presubtracted = true;
  n.select = item.presubtracted[0].select;
  auto &arguments = alpha ? item.alphaArguments : item.rgbArguments;
  arguments = {n, n, n};
  arguments[1].absolute = true;
  arguments[2].negate = true;
  const ItemId id = add(item, mask, options.toDestination);
  Refs refs;
  for (std::uint8_t c = 0; c < 4; ++c)
    refs[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
  return valueOf(refs);
}

bool Emitter::dotArguments(Item &item, const Refs &a, const Refs &b, bool commit) {
  if (!take(a, 7, item.rgbArguments[0], commit) || !take(b, 7, item.rgbArguments[1], commit))
    return false;
  return true;
}

namespace {
constexpr std::array<std::array<std::uint8_t, 4>, 24> kPermutations = [] {
  std::array<std::array<std::uint8_t, 4>, 24> all = {};
  std::size_t count = 0;
  // Permutations that leave w in place come first: a DP3 can only use those.
  for (std::uint8_t w = 4; w-- > 0;)
    for (std::uint8_t x = 0; x < 4; ++x)
      for (std::uint8_t y = 0; y < 4; ++y)
        for (std::uint8_t z = 0; z < 4; ++z)
          if (x != y && x != z && x != w && y != z && y != w && z != w)
            all[count++] = {x, y, z, w};
  return all;
}();

Refs permuted(const Refs &refs, const std::array<std::uint8_t, 4> &order) {
  return {refs[order[0]], refs[order[1]], refs[order[2]], refs[order[3]]};
}

bool isNegative(const Ref &ref) {
  return ref.kind == Ref::Kind::Literal ? ref.value < 0.0f : ref.negate;
}

/// Moves the signs of \p from to \p to, which leaves the products unchanged.
void moveSigns(Refs &from, Refs &to) {
  for (std::size_t c = 0; c < 4; ++c)
    if (isNegative(from[c])) {
      from[c] = negated(from[c]);
      to[c] = negated(to[c]);
    }
}

/// Tries the ways to read two vectors. Those that leave most copies without readers come first.
template <typename Try> bool eachReading(const Value &a, const Value &b, Try attempt) {
  const bool one = a.direct != a.through, other = b.direct != b.through;
  return attempt(a.through, b.through) || (one && attempt(a.direct, b.through)) ||
         (other && attempt(a.through, b.direct)) || (one && other && attempt(a.direct, b.direct));
}
} // namespace

Value Emitter::dot(RgbOp op, std::uint8_t mask, const Value &a, const Value &b,
                   const EmitOptions &options) {
  Item item = like(op, AlphaOp::Dp, options);
  item.kind = Item::Kind::Both;
  const std::size_t orders = op == RgbOp::Dp3 ? 6 : kPermutations.size();
  const auto attempt = [&](const Refs &x, const Refs &y, std::size_t order, int signs) {
    Refs first = permuted(x, kPermutations[order]), second = permuted(y, kPermutations[order]);
    if (signs == 1)
      moveSigns(first, second);
    else if (signs == 2)
      moveSigns(second, first);
    if (!dotArguments(item, first, second, false) || !dotArguments(item, first, second, true))
      return false;
    if (op == RgbOp::Dp4 && (!takeAlpha(first[3], item.alphaArguments[0]) ||
                             !takeAlpha(second[3], item.alphaArguments[1])))
      return false;
    return op == RgbOp::Dp3 || packsAlone(m_flow, item);
  };
  const bool fits = eachReading(a, b, [&](const Refs &x, const Refs &y) {
    for (std::size_t order = 0; order < orders; ++order)
      for (int signs = 0; signs < 3; ++signs)
        if (attempt(x, y, order, signs))
          return true;
    return false;
  });
  return fits ? dotResult(item, mask, options.toDestination)
              : dotByCopy(item, mask, a, b, options.toDestination);
}

Value Emitter::dotResult(const Item &item, std::uint8_t mask, bool toDestination) {
  Value result = replicated(item, mask, toDestination);
  // A Dp3 that does not write w leaves the alpha half free.
  if (item.rgb == RgbOp::Dp3)
    result.through[3] =
        result.direct[mask & 7 ? std::size_t(std::countr_zero(mask)) : std::size_t(0)];
  return result;
}

/// Emits a dot product after copying one or both sides to registers.
Value Emitter::dotByCopy(Item item, std::uint8_t mask, const Value &a, const Value &b,
                         bool toDestination) {
  FlowArgument ignored;
  std::array<std::uint8_t, 3> parts;
  const auto costOf = [&](const Value &value) {
    return take(value, 7, ignored, false) ? 0 : phases({&value, 1}, 7, parts);
  };
  EmitOptions own;
  own.cause = Cause::Swizzle;
  const std::uint8_t all = item.rgb == RgbOp::Dp3 ? 7 : 15;
  const auto order = [&](const Value &value, std::size_t i) {
    return Value{permuted(value.direct, kPermutations[i]),
                 permuted(value.through, kPermutations[i]), value.once};
  };
  std::size_t best = 0;
  std::uint32_t least = ~0u;
  for (std::size_t i = 0; i < 6; ++i) {
    const std::uint32_t cost = costOf(order(a, i)) + costOf(order(b, i));
    if (cost < least) {
      least = cost;
      best = i;
    }
  }
  Value x = order(a, best), y = order(b, best);
  // A join may have made an argument impossible meanwhile; then it is copied too.
  if (costOf(x) != 0)
    x = copy(all, x, own);
  if (costOf(y) != 0)
    y = copy(all, y, own);
  for (Value *side : {&x, &y})
    if (!take(*side, 7, item.rgbArguments[side == &x ? 0 : 1], true)) {
      *side = copy(all, *side, own);
      (void)take(*side, 7, item.rgbArguments[side == &x ? 0 : 1], true);
    }
  if (item.rgb == RgbOp::Dp4) {
    takeAlpha(x, 3, item.alphaArguments[0]);
    takeAlpha(y, 3, item.alphaArguments[1]);
    for (const std::size_t side : {0, 1})
      if (!packsAlone(m_flow, item)) {
        const Value whole = copy(all, side == 0 ? x : y, own);
        (void)take(whole, 7, item.rgbArguments[side], true);
        takeAlpha(whole, 3, item.alphaArguments[side]);
      }
  }
  return dotResult(item, mask, toDestination);
}

} // namespace arbiter::fp::hw::r300
