#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::ir {

/// One texture access, as the target sees it: TXP has divided already.
struct Sample {
  TexTarget target = TexTarget::Tex2D;
  std::uint8_t unit = 0;
  /// s, t, r (r is the reference of a shadow target); 0 where the target has no use for one.
  Vec4 coordinate = {};
  float bias = 0.0f;        ///< TXB's
  std::optional<float> lod; ///< TXL's, which needs no derivatives
  /// TXD's: those of the coordinate along the window's x and y.
  struct Gradient {
    Vec4 x = {}, y = {};
  };
  std::optional<Gradient> gradient;
};

/// One instruction as the interpreter did it, for a trace.
struct Step {
  std::size_t index = 0; ///< in Program::code
  /// As read: swizzled and signed; the whole coordinate operand of a texture access.
  Operands operands = {};
  std::optional<Sample> sample; ///< of a texture access
  /// The whole destination register after the write; an address register in x. Zero of KIL.
  Vec4 value = {};
  bool discards = false; ///< KIL's condition held
};

/// Everything outside a program that its result depends on. Empty functions give zeros.
struct Inputs {
  /// One vec4 for each of Program::attributes, in that order; missing ones are zero.
  std::span<const Vec4> attributes;
  /// Values of Env, Local and State rows.
  std::function<Vec4(const Parameter &)> parameter;
  std::function<Vec4(const Sample &)> texture;
  /// The fog coordinate, for the fog options.
  float fogCoordinate = 0.0f;
  /// The secondary colour, for Options::colorSum.
  Vec4 secondary = {};
  /// A vertex program takes Legacy for Fp24. The functions and attributes give what the application
  /// gave: rounding is the interpreter's.
  Numerics numerics = Numerics::Host;
  /// For error analysis: may change what an arithmetic opcode reads.
  std::function<void(const Instruction &, Operands &)> operands;
  /// Sees, and may change, each result before _SAT and the write.
  std::function<void(const Instruction &, Vec4 &)> result;
  /// Sees each instruction when it is done.
  std::function<void(const Step &)> observer;
  /// Goes on after a KIL that discards, as the neighbours of a discarded fragment do.
  bool pastKill = false;
};

/// What a program makes of one fragment.
struct Evaluation {
  std::vector<Vec4> outputs;  ///< one for each of Program::outputs; not clamped without fog option
  std::optional<float> depth; ///< if the program writes result.depth.z; not clamped
  bool killed = false;        ///< then the rest is zero, without Inputs::pastKill
};

/// The reference interpreter (semantics.h). Requires: validate(program) finds nothing.
[[nodiscard]] Evaluation evaluate(const Program &program, const Inputs &inputs);

/// The same of 2x2 pixels of the window, which DDX and DDY compare: lower left, lower right, upper
/// left, upper right.
[[nodiscard]] std::array<Evaluation, 4> evaluateQuad(const Program &program,
                                                     const std::array<Inputs, 4> &inputs);

} // namespace arbiter::fp::ir
