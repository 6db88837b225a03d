#pragma once
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "fp_compiler/ir/ir.h"

/// Builds programs in tests and generators: `b.op(Opcode::Mad, b.color(), {t.xyz..., ...})`.
namespace arbiter::fp::ir {

/// Each component as a letter for swz() and mask().
inline constexpr const char *kLetters[] = {"x", "y", "z", "w"};

/// An operand under construction. Every function returns a changed copy.
struct Source : Operand {
  /// Sets the swizzle: one of the letters xyzw01, which is repeated, or four.
  [[nodiscard]] Source swz(std::string_view letters) const;
  /// Negates all four components.
  [[nodiscard]] Source operator-() const;
  /// Negates the components whose bits are set in \p mask.
  [[nodiscard]] Source negated(std::uint8_t mask) const;
};

/// A destination under construction.
struct Target : Destination {
  /// Sets the write mask: "x", "xz", "xyzw".
  [[nodiscard]] Target mask(std::string_view letters) const;
  [[nodiscard]] Target sat() const;
  /// Returns the register as an operand.
  [[nodiscard]] Source read() const;
};

/// Returns the destination with another write mask.
[[nodiscard]] inline Target withMask(Target target, std::uint8_t mask) {
  target.Destination::mask = mask;
  return target;
}

class Builder {
public:
  explicit Builder(Language language = Language::ArbFragment) { m_program.language = language; }
  /// Appends to a program.
  explicit Builder(Program &&program) : m_program(std::move(program)) {}
  /// Declares a temporary, named "t<n>" if no name is given.
  Target temporary(std::string_view name = {});
  Target color(int index = 0);
  Target depth();
  /// Declares a vertex result, or a colour or a depth.
  Target result(OutputKind kind, int index = 0);
  /// Declares an address register, named "a<n>". It is the destination of ARL.
  Target address();
  Source attribute(AttributeKind kind, int index = 0);
  Source constant(float x, float y, float z, float w);
  Source constant(float all) { return constant(all, all, all, all); }
  Source env(int index);
  Source local(int index);
  Source state(const StateRef &ref);
  /// Declares an array of rows made by the functions above, and returns its index.
  int array(std::initializer_list<Source> rows) { return array(std::vector<Source>(rows)); }
  int array(const std::vector<Source> &rows);
  /// Returns an operand that reads row `address.x + offset` of an array.
  [[nodiscard]] static Source element(int array, const Target &address, int offset = 0);

  Builder &op(Opcode opcode, const Target &dst, std::initializer_list<Source> sources);
  Builder &tex(Opcode opcode, const Target &dst, const Source &coordinate, int unit,
               TexTarget target);
  Builder &kil(const Source &source);

  /// Sets the source span of the instructions from \p first on.
  void setSpan(std::size_t first, Span span);

  Options &options() { return m_program.options; }
  [[nodiscard]] const Program &program() const { return m_program; }
  [[nodiscard]] Program take() { return std::move(m_program); }

private:
  Target output(Output wanted);
  Source parameter(Parameter wanted);
  Program m_program;
};

} // namespace arbiter::fp::ir
