#pragma once
#include <span>

#include "fp_compiler/hw/r300/lower/rows.h"

/// Writes operations that the chip has: splits by phase what no native swizzle or sign says, copies
/// what cannot be split, and joins registers whose components are read together.
namespace arbiter::fp::hw::r300 {

/// A vector to read: the register as it was written, and what is behind the copies that wrote it.
/// Either may be read; the second leaves the copies without readers.
struct Value {
  Refs direct = {}, through = {};
  /// One operation alone reads it: what splits that one is as cheap as the copy.
  bool once = false;
};
[[nodiscard]] inline Value valueOf(const Refs &refs) { return {refs, refs, false}; }
[[nodiscard]] Ref literal(float value);
[[nodiscard]] Value literals(float value);
/// Whether all of \p mask are the literal \p value.
[[nodiscard]] bool isLiteral(const Refs &refs, std::uint8_t mask, float value);
[[nodiscard]] Ref negated(Ref ref);
[[nodiscard]] Value negated(Value value);
/// Component \p component in all four.
[[nodiscard]] Value broadcast(const Value &value, std::size_t component);

/// What a result is emitted with, beside its operation.
struct EmitOptions {
  bool toDestination = false; ///< to the instruction's destination; else to a fresh variable
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

  /// What follows is of instruction \p origin, which writes \p destination.
  void begin(std::uint16_t origin, Variable destination);
  [[nodiscard]] std::uint16_t origin() const { return m_origin; }

  /// The current version of \p variable.
  [[nodiscard]] const Value &current(Variable variable) const { return m_current[variable]; }
  /// \p once: see Value; of the components as a whole.
  void set(Variable variable, std::uint8_t mask, const Value &value, bool once = false);
  /// False where the value's register has been written since and must be one with what is there
  /// now.
  [[nodiscard]] bool readable(const Ref &ref);

  /// An operation of both units, component by component. RGB and alpha are operations apart.
  Value componentwise(RgbOp rgb, AlphaOp alpha, std::uint8_t mask, std::span<const Value> operands,
                      const EmitOptions &options);
  /// a*b + c; the form of copies, sums and products too.
  Value mad(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
            const EmitOptions &options);
  Value copy(std::uint8_t mask, const Value &value, const EmitOptions &options);
  /// Of Ex2, Lg2, Rcp, Rsq: reads component w of \p operand.
  Value scalar(AlphaOp op, std::uint8_t mask, const Value &operand, const EmitOptions &options);
  Value dot(RgbOp op, std::uint8_t mask, const Value &a, const Value &b,
            const EmitOptions &options);
  /// x - y < 0 ? below : notBelow, of two numbers 0 or 1.
  Value compare(std::uint8_t mask, const Value &x, const Value &y, float below, float notBelow,
                const EmitOptions &options);
  /// a*b + (1-a)*c
  Value lerp(std::uint8_t mask, const Value &a, const Value &b, const Value &c,
             const EmitOptions &options);
  /// 4*(u - u|u|) of u = 2f - 1: a parabola that is near sin(pi*u).
  Value arch(std::uint8_t mask, const Value &f, const EmitOptions &options);
  /// All of the result's components; those outside of \p mask are not the program's.
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
  bool m_renamed = false;       ///< into fresh variables: the destination's old value is still read
  std::uint8_t m_written = 0;   ///< components of the destination, by this instruction
  std::vector<ItemId> m_pieces; ///< that wrote them
};

} // namespace arbiter::fp::hw::r300
