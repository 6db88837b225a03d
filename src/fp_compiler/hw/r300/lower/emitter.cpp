#include "fp_compiler/hw/r300/lower/emitter.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace arbiter::fp::hw::r300 {

Ref literal(float value) {
  Ref ref;
  ref.value = value;
  return ref;
}

Value literals(float value) {
  Refs refs;
  refs.fill(literal(value));
  return valueOf(refs);
}

bool isLiteral(const Refs &refs, std::uint8_t mask, float value) {
  for (std::size_t c = 0; c < 4; ++c)
    if ((mask >> c & 1) && (refs[c].kind != Ref::Kind::Literal || refs[c].value != value))
      return false;
  return true;
}

Ref negated(Ref ref) {
  if (ref.kind == Ref::Kind::Literal)
    ref.value = -ref.value;
  else
    ref.negate = !ref.negate;
  return ref;
}

Value negated(Value value) {
  for (std::size_t c = 0; c < 4; ++c) {
    value.direct[c] = negated(value.direct[c]);
    value.through[c] = negated(value.through[c]);
  }
  return value;
}

Value broadcast(const Value &value, std::size_t component) {
  Value result;
  result.direct.fill(value.direct[component]);
  result.through.fill(value.through[component]);
  return result;
}

void Emitter::begin(std::uint16_t origin, Variable destination) {
  m_origin = origin;
  m_destination = destination;
  m_renamed = false;
  m_written = 0;
  m_pieces.clear();
}

void Emitter::set(Variable variable, std::uint8_t mask, const Value &value, bool once) {
  m_current[variable].once = once;
  for (std::size_t c = 0; c < 4; ++c)
    if (mask >> c & 1) {
      m_current[variable].direct[c] = value.direct[c];
      m_current[variable].through[c] = value.through[c];
    }
}

Item Emitter::like(RgbOp rgb, AlphaOp alpha, const EmitOptions &options) const {
  Item item;
  item.rgb = rgb;
  item.alpha = alpha;
  item.clamp = options.clamp;
  item.modifier = options.modifier;
  item.cause = options.cause;
  item.origin = m_origin;
  return item;
}

namespace {
/// True if a select gives the constant without a source: 0, 1/2 and 1.
bool freeConstant(float value, std::uint8_t &select) {
  const float size = std::fabs(value);
  if (size == 0.0f)
    select = std::uint8_t(RgbSelect::Zero);
  else if (size == 1.0f)
    select = std::uint8_t(RgbSelect::One);
  else if (size == 0.5f)
    select = std::uint8_t(RgbSelect::Half);
  else
    return false;
  return true;
}

} // namespace

bool Emitter::take(const Refs &refs, std::uint8_t components, FlowArgument &argument, bool commit) {
  const std::size_t first = std::size_t(std::countr_zero(components));
  const Ref &one = refs[first];
  bool equal = true;
  for (std::size_t c = first + 1; c < 3; ++c) {
    if (!(components >> c & 1))
      continue;
    if (refs[c].kind != one.kind || refs[c].absolute != one.absolute ||
        refs[c].negate != one.negate)
      return false;
    equal &= sameNumber(refs[c].value, one.value);
  }
  argument = {};
  argument.absolute = one.absolute;
  argument.negate = one.negate;
  if (one.kind != Ref::Kind::Literal)
    return takeItems(refs, components, argument, commit);
  if (equal && freeConstant(one.value, argument.select)) {
    argument.negate = std::signbit(one.value);
    return true;
  }
  if (!commit)
    return true;
  const Rows::Place place = m_rows.rgb(refs, components, m_origin);
  argument.bank = FlowArgument::Bank::Row;
  argument.select = place.select;
  argument.negate = place.negate;
  argument.source[0] = place.row;
  return true;
}

bool Emitter::takeItems(const Refs &refs, std::uint8_t components, FlowArgument &argument,
                        bool commit) {
  for (std::uint8_t select = 0;; ++select) {
    if (select == std::uint8_t(RgbSelect::Zero))
      return false;
    bool fits = true;
    for (std::size_t c = 0; c < 3; ++c)
      fits &= !(components >> c & 1) || refs[c].component == kTaps[select][c];
    if (!fits)
      continue;
    argument.select = select;
    break;
  }
  std::array<Ref, 3> colors, alphas;
  std::size_t colorCount = 0, alphaCount = 0;
  for (std::size_t c = 0; c < 3; ++c)
    if (components >> c & 1) {
      if (refs[c].component < 3)
        colors[colorCount++] = refs[c];
      else
        alphas[alphaCount++] = refs[c];
      argument.source[c] = refs[c].index;
    }
  const Ref &one = colorCount ? colors[0] : alphas[0];
  if (one.kind == Ref::Kind::Row) {
    for (std::size_t i = 1; i < colorCount; ++i)
      if (colors[i].index != one.index)
        return false;
    for (std::size_t i = 0; i < alphaCount; ++i)
      if (alphas[i].index != one.index)
        return false;
    argument.bank = FlowArgument::Bank::Row;
    argument.source[0] = one.index;
    return true;
  }
  argument.bank = FlowArgument::Bank::Item;
  const std::span<const Ref> color(colors.data(), colorCount), alpha(alphas.data(), alphaCount);
  // Check both before either commits: no half of an argument may be joined if the other cannot be.
  if ((colorCount && !join(color, false)) || (alphaCount && !join(alpha, false)))
    return false;
  if (!commit)
    return true;
  if (colorCount)
    (void)join(color, true);
  return !alphaCount || join(alpha, true);
}

bool Emitter::take(const Value &value, std::uint8_t components, FlowArgument &argument,
                   bool commit) {
  return take(value.through, components, argument, commit) ||
         take(value.direct, components, argument, commit);
}

bool Emitter::takeAlpha(const Ref &ref, FlowArgument &argument) {
  argument = {};
  argument.absolute = ref.absolute;
  argument.negate = ref.negate;
  if (ref.kind == Ref::Kind::Literal) {
    if (freeConstant(ref.value, argument.select)) {
      argument.select = std::uint8_t(argument.select - std::uint8_t(RgbSelect::Zero) +
                                     std::uint8_t(AlphaSelect::Zero));
      argument.negate = std::signbit(ref.value);
      return true;
    }
    const Rows::Place place = m_rows.alpha(ref, m_origin);
    argument.bank = FlowArgument::Bank::Row;
    argument.select = place.select;
    argument.negate = place.negate;
    argument.source[0] = place.row;
    return true;
  }
  argument.select = ref.component;
  argument.source[0] = ref.index;
  argument.bank = ref.kind == Ref::Kind::Row ? FlowArgument::Bank::Row : FlowArgument::Bank::Item;
  return ref.kind == Ref::Kind::Row || join({&ref, 1}, true);
}

void Emitter::takeAlpha(const Value &value, std::size_t component, FlowArgument &argument) {
  if (!takeAlpha(value.through[component], argument))
    (void)takeAlpha(value.direct[component], argument);
}

bool Emitter::feasible(std::span<const Value> operands, std::uint8_t components) {
  FlowArgument ignored;
  for (const Value &operand : operands)
    if (!take(operand, components, ignored, false))
      return false;
  return true;
}

/// Returns the fewest parts of \p components that are one operation each.
std::uint32_t Emitter::phases(std::span<const Value> operands, std::uint8_t components,
                              std::array<std::uint8_t, 3> &parts) {
  if (components == 0)
    return 0;
  parts[0] = components;
  if (std::has_single_bit(components) || feasible(operands, components))
    return 1;
  if (components == 7)
    for (const std::uint8_t two : {3, 6, 5})
      if (feasible(operands, two)) {
        parts[0] = two;
        parts[1] = std::uint8_t(components & ~two);
        return 2;
      }
  std::uint32_t count = 0;
  for (std::uint8_t bit = 1; bit < 8; bit = std::uint8_t(bit << 1))
    if (components & bit)
      parts[count++] = bit;
  return count;
}

/// Splits as phases() does, but reads through copies if that takes no more operations.
std::uint32_t Emitter::split(std::span<const Value> operands, std::uint8_t components,
                             std::array<std::uint8_t, 3> &parts) {
  const std::uint32_t count = phases(operands, components, parts);
  std::array<Value, 3> throughCopies;
  bool once = false, differ = false;
  for (std::size_t i = 0; i < operands.size(); ++i) {
    once |= operands[i].once;
    differ |= operands[i].direct != operands[i].through;
  }
  if (!differ || count == 3 || std::popcount(components) < 2)
    return count;
  for (std::size_t i = 0; i < operands.size(); ++i)
    throughCopies[i] = valueOf(operands[i].through);
  std::array<std::uint8_t, 3> others;
  const std::uint32_t through =
      phases(std::span<const Value>(throughCopies).first(operands.size()), components, others);
  if (through > count + (once ? 1u : 0u))
    return count;
  parts = others;
  return through;
}

void Emitter::rgbPhase(const Item &like, std::uint8_t components, std::span<const Value> operands,
                       bool toDestination, Value &result) {
  Item item = like;
  item.kind = Item::Kind::Rgb;
  item.alpha = AlphaOp::None;
  for (std::size_t i = 0; i < operands.size(); ++i)
    if (!take(operands[i], components, item.rgbArguments[i], true)) {
      // Each argument alone could join its registers, but both together cannot. A single component
      // can always be read.
      assert(!std::has_single_bit(components));
      for (std::uint8_t bit = 1; bit < 8; bit = std::uint8_t(bit << 1))
        if (components & bit)
          rgbPhase(like, bit, operands, toDestination, result);
      return;
    }
  const ItemId id = add(item, components, toDestination);
  for (std::uint8_t c = 0; c < 3; ++c)
    if (components >> c & 1)
      result.direct[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
}

void Emitter::alphaPart(const Item &like, std::span<const Value> operands, bool toDestination,
                        Value &result) {
  Item item = like;
  item.kind = Item::Kind::Alpha;
  item.rgb = RgbOp::None;
  for (std::size_t i = 0; i < operands.size(); ++i)
    takeAlpha(operands[i], 3, item.alphaArguments[i]);
  result.direct[3] = {Ref::Kind::Item, 3, false, false, add(item, 8, toDestination), 0.0f};
}

Value Emitter::componentwise(RgbOp rgb, AlphaOp alpha, std::uint8_t mask,
                             std::span<const Value> operands, const EmitOptions &options) {
  Value result;
  const Item item = like(rgb, alpha, options);
  std::array<std::uint8_t, 3> parts;
  const std::uint32_t count = split(operands, mask & 7, parts);
  for (std::uint32_t i = 0; i < count; ++i) {
    Item part = item;
    if (i > 0 && part.cause == Cause::Instruction)
      part.cause = Cause::Swizzle;
    rgbPhase(part, parts[i], operands, options.toDestination, result);
  }
  if (mask & 8)
    alphaPart(item, operands, options.toDestination, result);
  result.through = result.direct;
  return result;
}

Value Emitter::replicated(Item item, std::uint8_t mask, bool toDestination) {
  item.replicated = true;
  item.kind = Item::Kind::Both;
  const ItemId id = add(item, mask, toDestination);
  Value result;
  for (std::uint8_t c = 0; c < 4; ++c)
    result.direct[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
  result.through = result.direct;
  return result;
}

Value Emitter::scalar(AlphaOp op, std::uint8_t mask, const Value &operand,
                      const EmitOptions &options) {
  Item item = like(RgbOp::ReplAlpha, op, options);
  takeAlpha(operand, 3, item.alphaArguments[0]);
  Value result = replicated(item, mask, options.toDestination);
  // A reader of w leaves the RGB half of this operation free.
  result.through.fill(result.direct[3]);
  return result;
}

} // namespace arbiter::fp::hw::r300
