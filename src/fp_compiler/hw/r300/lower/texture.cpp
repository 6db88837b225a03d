#include <utility>

#include "fp_compiler/hw/r300/lower/emitter.h"
#include "fp_compiler/hw/r300/lower/move.h"

/// Emits operations that write or read whole registers: interpolants and texture operations.
namespace arbiter::fp::hw::r300 {

namespace {
Ref read(const FlowArgument &argument, std::uint8_t component, std::size_t constants,
         std::size_t source) {
  Ref ref;
  if (argument.bank == FlowArgument::Bank::None) {
    constexpr float kConstants[] = {0.0f, 1.0f, 0.5f};
    const float value = kConstants[constants];
    ref.value = argument.negate ? -value : value;
    return ref;
  }
  const bool row = argument.bank == FlowArgument::Bank::Row;
  ref.kind = row ? Ref::Kind::Row : Ref::Kind::Item;
  ref.component = component;
  ref.absolute = argument.absolute;
  ref.negate = argument.negate;
  ref.index = argument.source[row ? 0 : source];
  return ref;
}

/// Returns the component that an argument of a scalar operation reads.
Ref rgbRead(const FlowArgument &argument, std::size_t component) {
  return read(argument, kTaps[argument.select][component],
              std::size_t(argument.select) - std::size_t(RgbSelect::Zero), component);
}
Ref alphaRead(const FlowArgument &argument) {
  return read(argument, argument.select,
              std::size_t(argument.select) - std::size_t(AlphaSelect::Zero), 0);
}
} // namespace

Refs Emitter::interpolant(std::uint16_t attribute) {
  Item item;
  item.kind = Item::Kind::Interpolant;
  item.attribute = attribute;
  const ItemId id = add(item, 0xF, false);
  Refs refs;
  for (std::uint8_t c = 0; c < 4; ++c)
    refs[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
  return refs;
}

/// Computes a scalar again in all of \p components. This is as cheap as a copy, and the first
/// computation may become dead. Returns false if the item is not a scalar operation, or if its
/// arguments have been overwritten.
bool Emitter::spread(const Ref &scalar, std::uint8_t components, Refs &result) {
  const Item item = m_flow.items[scalar.index];
  const bool alpha = item.kind == Item::Kind::Alpha;
  if ((!alpha && item.kind != Item::Kind::Rgb) || item.replicated ||
      item.presubtract != Presubtract::None)
    return false;
  const RgbOp rgb = alpha ? otherUnit(item.alpha) : item.rgb;
  std::array<Value, 3> operands;
  for (std::size_t i = 0; i < std::size_t(argumentsOf(rgb)); ++i) {
    const Ref ref =
        alpha ? alphaRead(item.alphaArguments[i]) : rgbRead(item.rgbArguments[i], scalar.component);
    if (!readable(ref))
      return false;
    Refs refs;
    refs.fill(ref);
    operands[i] = valueOf(refs);
  }
  EmitOptions options;
  options.clamp = item.clamp;
  options.modifier = item.modifier;
  options.cause = item.cause;
  const std::uint16_t origin = std::exchange(m_origin, item.origin);
  result =
      componentwise(rgb, otherUnit(rgb), components,
                    std::span<const Value>(operands).first(std::size_t(argumentsOf(rgb))), options)
          .direct;
  m_origin = origin;
  return true;
}

/// Returns \p coordinate with its components in one register, each in its own place.
Refs Emitter::plainCoordinate(std::uint8_t components, const Value &value) {
  Refs plain = {};
  std::uint8_t bad = 0;
  bool scalar = true;
  const Ref *first = nullptr;
  for (std::uint8_t c = 0; c < 4; ++c) {
    if (!(components >> c & 1))
      continue;
    const auto fits = [&](const Ref &ref) {
      if (ref.kind != Ref::Kind::Item || ref.negate || ref.absolute ||
          (ref.component != c && !m_flow.items[ref.index].replicated))
        return false;
      plain[c] = ref;
      plain[c].component = c;
      return true;
    };
    const Ref &ref = value.through[c];
    first = first ? first : &ref;
    scalar &= ref == *first && ref.kind == Ref::Kind::Item && !ref.negate && !ref.absolute;
    if (!fits(ref) && !fits(value.direct[c]))
      bad |= std::uint8_t(1 << c);
  }
  const auto joined = [&] {
    std::array<Ref, 4> all;
    std::size_t count = 0;
    for (std::size_t c = 0; c < 4; ++c)
      if (components >> c & 1)
        all[count++] = plain[c];
    return join({all.data(), count}, true);
  };
  const auto copied = [&](std::uint8_t which) {
    EmitOptions own;
    own.cause = Cause::TextureOperand;
    const Value fresh = copy(which, value, own);
    for (std::size_t c = 0; c < 4; ++c)
      if (which >> c & 1)
        plain[c] = fresh.direct[c];
  };
  if (bad && scalar && spread(*first, components, plain))
    bad = 0;
  if (bad)
    copied(bad);
  if (!joined()) {
    copied(components);
    (void)joined();
  }
  return plain;
}

Refs Emitter::texture(TexOp op, const ir::Instruction &instruction, std::uint8_t coordinates,
                      const Value &coordinate, std::uint8_t mask, bool toDestination) {
  const Refs plain = plainCoordinate(coordinates, coordinate);
  Item item = like(RgbOp::None, AlphaOp::None, {});
  item.kind = Item::Kind::Texture;
  item.texture = op;
  item.unit = instruction.unit;
  item.target = instruction.target;
  for (std::size_t c = 0; c < 3; ++c)
    if (coordinates >> c & 1)
      item.rgbArguments[0].source[c] = plain[c].index;
  if (coordinates & 8)
    item.alphaArguments[0].source[0] = plain[3].index;
  Refs result = {};
  if (op == TexOp::Kill) {
    (void)add(item, 0, false);
    return result;
  }
  const ItemId id = add(item, mask, toDestination);
  // A sample writes the whole register, whatever its mask.
  for (std::uint8_t c = 0; c < 4; ++c) {
    result[c] = {Ref::Kind::Item, c, false, false, id, 0.0f};
    Item &sample = m_flow.items[id];
    if (!(mask >> c & 1)) {
      sample.variables[c] = m_flow.variables[id][c] = m_nextVariable++;
      sample.mask |= std::uint8_t(1 << c);
      m_flow.versions[id][c] = 1;
    }
  }
  return result;
}

} // namespace arbiter::fp::hw::r300
