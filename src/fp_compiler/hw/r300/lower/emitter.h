#pragma once
#include <span>

#include "fp_compiler/hw/r300/lower/rows.h"

/// Emits operations that the chip has. Splits operations whose swizzles or signs are not native,
/// copies what cannot be split, and joins registers whose components are read together.
namespace arbiter::fp::hw::r300 {

/// A vector to read: the register as it was written, and the sources of the copies that wrote it.
/// Either may be read. Reading `through` leaves the copies without readers.
struct Value {
  Refs direct = {}, through = {};
  /// True if a single operation reads it. To split that operation is then as cheap as the copy.
  bool once = false;
};
[[nodiscard]] inline Value valueOf(const Refs &refs) { return {refs, refs, false}; }
[[nodiscard]] Ref literal(float value);
[[nodiscard]] Value literals(float value);
/// True if every component in \p mask is the literal \p value.
[[nodiscard]] bool isLiteral(const Refs &refs, std::uint8_t mask, float value);
[[nodiscard]] Ref negated(Ref ref);
[[nodiscard]] Value negated(Value value);
/// Returns component \p component in all four components.
[[nodiscard]] Value broadcast(const Value &value, std::size_t component);

/// Makes a value of its RGB part and its alpha part. `part` computes the components of a mask.
template <typename Part> [[nodiscard]] Value byHalves(std::uint8_t mask, const Part &part) {
  Value result;
  for (const std::uint8_t half : {std::uint8_t(mask & 7), std::uint8_t(mask & 8)}) {
    if (half == 0)
      continue;
    const Value value = part(half);
    for (std::size_t i = 0; i < 4; ++i)
      if (half >> i & 1)
        result.direct[i] = value.direct[i];
  }
  result.through = result.direct;
  return result;
}

/// Options of a result: its destination and modifiers.
struct EmitOptions {
  bool toDestination = false; ///< write the instruction's destination; otherwise a fresh variable
  bool clamp = false;
  Modifier modifier = Modifier::One;
  Cause cause = Cause::Instruction;
};

class Emitter {
public:
  Emitter(const ir::Program &program, std::size_t registers, Flow &flow)
      : m_flow(flow), m_rows(program, flow.rows), m_current(registers),
        m_nextVariable(Variable(registers)) {}

  [[nodiscard]] Rows &rows() { return m_rows; }

  /// Starts instruction \p origin, which writes \p destination. What is emitted from here on
  /// belongs to it.
  void begin(std::uint16_t origin, Variable destination);
  [[nodiscard]] std::uint16_t origin() const { return m_origin; }

  /// Returns the current version of \p variable.
  [[nodiscard]] const Value &current(Variable variable) const { return m_current[variable]; }
  /// Sets the current version of components of \p variable.
  /// \param once as in Value, for the components as a whole
  void set(Variable variable, std::uint8_t mask, const Value &value, bool once = false);
  /// True if the value can still be read. False if its register has been overwritten and has
  /// several versions, so that it cannot be split off.
  [[nodiscard]] bool readable(const Ref &ref);

  /// Emits an operation of both units, component by component, as separate RGB and alpha
  /// operations.
  Value componentwise(RgbOp rgb, AlphaOp alpha, std::uint8_t mask, std::span<const Value> operands,
                      const EmitOptions &options);
  /// Emits a*b + c. Copies, sums and products have this form too.
  Value mad(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
            const EmitOptions &options);
  Value copy(std::uint8_t mask, const Value &value, const EmitOptions &options);
  /// Emits Ex2, Lg2, Rcp or Rsq of component w of \p operand.
  Value scalar(AlphaOp op, std::uint8_t mask, const Value &operand, const EmitOptions &options);
  Value dot(RgbOp op, std::uint8_t mask, const Value &a, const Value &b,
            const EmitOptions &options);
  /// Emits x - y < 0 ? below : notBelow. `below` and `notBelow` are 0 or 1.
  Value compare(std::uint8_t mask, const Value &x, const Value &y, float below, float notBelow,
                const EmitOptions &options);
  /// Emits a*b + (1-a)*c.
  Value lerp(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
             const EmitOptions &options);
  /// Emits 4*(u - u|u|) with u = 2f - 1, a parabola close to sin(pi*u).
  Value arch(std::uint8_t mask, const Value &f, const EmitOptions &options);
  /// Emits a texture operation. It writes all components; those outside of \p mask have no meaning.
  Refs texture(TexOp op, const ir::Instruction &instruction, std::uint8_t coordinates,
               const Value &coordinate, std::uint8_t mask, bool toDestination);
  Refs interpolant(std::uint16_t attribute);

private:
  bool take(const Refs &refs, std::uint8_t components, FlowArgument &argument, bool commit);
  bool take(const Value &value, std::uint8_t components, FlowArgument &argument, bool commit);
  bool takeItems(const Refs &refs, std::uint8_t components, FlowArgument &argument, bool commit);
  bool takeAlpha(const Ref &ref, FlowArgument &argument);
  void takeAlpha(const Value &value, std::size_t component, FlowArgument &argument);
  bool join(std::span<const Ref> refs, bool commit);
  void merge(std::span<const Ref> refs, ItemId root, const std::array<Variable, 4> &variables);
  [[nodiscard]] bool isCurrent(const Ref &ref) const;
  bool splitOff(std::span<const Ref> refs, const Ref &ref, bool commit);

  bool feasible(std::span<const Value> operands, std::uint8_t components);
  std::uint32_t phases(std::span<const Value> operands, std::uint8_t components,
                       std::array<std::uint8_t, 3> &parts);
  std::uint32_t split(std::span<const Value> operands, std::uint8_t components,
                      std::array<std::uint8_t, 3> &parts);
  void rgbPhase(const Item &like, std::uint8_t components, std::span<const Value> operands,
                bool toDestination, Value &result);
  void alphaPart(const Item &like, std::span<const Value> operands, bool toDestination,
                 Value &result);
  bool literalLike(const Refs &refs, std::uint8_t components, const FlowArgument &like,
                   FlowArgument &argument);
  bool difference(const Value &x, const Value &y, std::uint8_t components, Item &item,
                  FlowArgument &argument);
  bool differenceOf(const Refs &x, const Refs &y, std::uint8_t components, Item &item,
                    FlowArgument &argument);
  Value compareHalf(std::uint8_t mask, const Value &x, const Value &y, float below, float notBelow,
                    const EmitOptions &options);
  Value lerpHalf(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
                 const EmitOptions &options);
  bool dotArguments(Item &item, const Refs &a, const Refs &b, bool commit);
  Value dotByCopy(Item item, std::uint8_t mask, const Value &a, const Value &b, bool toDestination);
  Value dotResult(const Item &item, std::uint8_t mask, bool toDestination);
  Value replicated(Item item, std::uint8_t mask, bool toDestination);

  bool spread(const Ref &scalar, std::uint8_t components, Refs &result);
  Refs plainCoordinate(std::uint8_t components, const Value &value);

  [[nodiscard]] Item like(RgbOp rgb, AlphaOp alpha, const EmitOptions &options) const;
  ItemId add(Item item, std::uint8_t mask, bool toDestination);
  void avoidHazard(const Item &item);

  Flow &m_flow;
  Rows m_rows;
  std::vector<Value> m_current;
  Variable m_nextVariable;
  std::uint16_t m_origin = kNone;
  Variable m_destination = kNoVariable;
  bool m_renamed =
      false; ///< true if fresh variables take the result: the destination's old value is still read
  std::uint8_t m_written = 0;   ///< components of the destination that this instruction has written
  std::vector<ItemId> m_pieces; ///< the items that wrote them
};

} // namespace arbiter::fp::hw::r300
