#include "fp_compiler/back/glsl/expression.h"

#include <algorithm>

namespace arbiter::fp::glsl {

using analysis::Guard;
using analysis::OperandFacts;
using ir::Instruction;
using ir::Opcode;
using ir::Operand;

namespace {
/// Writes one instruction's expression. All operands are read before the one assignment writes.
struct Writer {
  const Registers &registers;
  const Instruction &instruction;
  const Components &components;
  const OperandFacts &facts;
  const Numerics numerics;

  std::string vec(int operand, const Components &at) const {
    return vector(registers, instruction.src[std::size_t(operand)], at);
  }
  std::string vec(int operand) const { return vec(operand, components); }
  std::string at(int operand, int position) const {
    return component(registers, instruction.src[std::size_t(operand)], position);
  }
  std::string call(const char *function) const {
    return std::string(function) + "(" + vec(0) + ")";
  }
  std::string call2(const char *function) const {
    return std::string(function) + "(" + vec(0) + ", " + vec(1) + ")";
  }
  std::string infix(const char *symbol) const { return vec(0) + " " + symbol + " " + vec(1); }

  /// Replicates a scalar to every component of the mask.
  std::string replicate(const std::string &scalar) const {
    return compose(std::vector<std::string>(components.size(), scalar));
  }
  std::string function(const char *name) const {
    return replicate(rounded(std::string(name) + "(" + at(0, 0) + ")"));
  }
  /// Selects the texts of the result components in the mask.
  std::string pick(const std::array<std::string, 4> &results) const {
    std::vector<std::string> parts;
    for (const int position : components)
      parts.push_back(results[std::size_t(position)]);
    return compose(parts);
  }

  /// Returns 0 or 1 by a comparison. GLSL's vector comparisons do not take scalars.
  std::string compare(const char *symbol, const char *function) const {
    if (components.size() == 1)
      return "float(" + infix(symbol) + ")";
    return typeName(components.size()) + "(" + call2(function) + ")";
  }

  std::string differ() const {
    if (components.size() == 1)
      return "float(!(" + infix("==") + "))";
    return typeName(components.size()) + "(not(" + call2("equal") + "))";
  }

  /// Calls a helper that packs components \p reads of the operand into one number.
  std::string pack(const char *helper, const Components &reads) const {
    return replicate(std::string(helper) + "(" + vec(0, reads) + ")");
  }
  std::string unpack(const char *helper) const {
    return std::string(helper) + "(" + at(0, 0) + ")" + suffix(components);
  }

  bool rounds() const { return numerics == Numerics::Fp24; }
  /// Rounds the result of a single operation to the mode's registers.
  std::string rounded(const std::string &text) const {
    return rounds() ? "arb_round(" + text + ")" : text;
  }
  /// Returns the mode's product. It binds as tightly as a multiplication.
  std::string product(const std::string &a, const std::string &b, Guard guard) const {
    return rounded(guard == Guard::Both    ? "arb_mul(" + a + ", " + b + ")"
                   : guard == Guard::Left  ? "arb_mulz(" + a + ", " + b + ")"
                   : guard == Guard::Right ? "arb_mulz(" + b + ", " + a + ")"
                                           : a + " * " + b);
  }
  std::string product() const { return product(vec(0), vec(1), facts.first); }
  /// True if the host's own dot(), mix() and cross() can be used.
  bool plain() const {
    return !rounds() && facts.first == Guard::None && facts.second == Guard::None;
  }

  std::string dot(const Components &at) const;
  std::string dph() const;
  std::string lrp() const;
  std::string cmp() const;
  std::string power(const std::string &base, const std::string &exponent) const;
  std::string lit() const;
  std::string cross() const;
};

/// Returns a dot product. For fragment programs, dot() is assumed to sum in the order of
/// ir/semantics.h, as it does in llvmpipe.
std::string Writer::dot(const Components &at) const {
  if (plain() && !registers.ofVertices())
    return "dot(" + vec(0, at) + ", " + vec(1, at) + ")";
  return "arb_sum(" + product(vec(0, at), vec(1, at), facts.first) + ")";
}

/// Returns DPH, summed in the order of Mesa's own ARB parser.
std::string Writer::dph() const {
  if (!plain() || registers.ofVertices())
    return "arb_sum(" + product(vec(0, {0, 1, 2}), vec(1, {0, 1, 2}), facts.first) + ", " +
           at(1, 3) + ")";
  const auto term = [&](int i) { return at(0, i) + " * " + at(1, i); };
  return "(" + term(0) + " + (" + term(2) + " + " + at(1, 3) + ")) + " + term(1);
}

std::string Writer::lrp() const {
  if (plain())
    return "mix(" + vec(2) + ", " + vec(1) + ", " + vec(0) + ")";
  const std::string rest = rounds() ? rounded("1.0 - " + vec(0)) : "(1.0 - " + vec(0) + ")";
  return rounded(product() + " + " + product(rest, vec(2), facts.second));
}

/// Returns CMP with ternary operators. mix() would multiply the value that is not selected.
std::string Writer::cmp() const {
  const Operand &condition = instruction.src[0];
  const bool alike = std::all_of(components.begin(), components.end(), [&](int position) {
    return at(0, position) == at(0, components.front());
  });
  if (alike)
    return component(registers, condition, components.front()) + " < 0.0 ? " + vec(1) + " : " +
           vec(2);
  std::vector<std::string> parts;
  for (const int position : components)
    parts.push_back(at(0, position) + " < 0.0 ? " + at(1, position) + " : " + at(2, position));
  return compose(parts);
}

/// Returns a power. GLSL leaves pow() undefined for a negative base, and for a zero base with an
/// exponent that is not positive. Hosts give NaN, infinity or zero. Hosts also give NaN for one to
/// the power of infinity, where Legacy gives 1: the product with log2(1) is zero.
std::string Writer::power(const std::string &base, const std::string &exponent) const {
  if (rounds())
    return "arb_pow(" + base + ", " + exponent + ")";
  if (numerics != Numerics::Host && !facts.exponentFinite && instruction.op == Opcode::Pow)
    return "(" + exponent + " == 0.0 || " + base + " == 1.0 ? 1.0 : (" + base + " > 0.0 ? pow(" +
           base + ", " + exponent + ") : 0.0))";
  if (facts.exponentPositive)
    return "pow(" + (facts.baseNotNegative ? base : "max(" + base + ", 0.0)") + ", " + exponent +
           ")";
  const std::string power = " ? pow(" + base + ", " + exponent + ") : ";
  if (facts.exponentNotZero)
    return "(" + base + " > 0.0" + power + "0.0)";
  // The test is one condition instead of nested ones, which take a tenth more time with NVIDIA's
  // compiler at 4096x4096. The exponent comes first, because Mesa branches if the second operand
  // contains a call.
  return "(" + exponent + " != 0.0 && " + base + " > 0.0" + power + "float(" + exponent +
         " == 0.0))";
}

std::string Writer::lit() const {
  const std::string limit = rounds() ? "127.9990234375" : "127.99999";
  const std::string exponent = "clamp(" + at(0, 3) + ", -" + limit + ", " + limit + ")";
  return pick({"1.0", "max(" + at(0, 0) + ", 0.0)",
               "(" + at(0, 0) + " > 0.0 ? " + power(at(0, 1), exponent) + " : 0.0)", "1.0"});
}

std::string Writer::cross() const {
  if (components.front() == 3)
    return "0.0"; // reads no operand, so that its registers may have no name
  const Components yzx = {1, 2, 0}, zxy = {2, 0, 1};
  const std::string result =
      plain() ? "cross(" + vec(0, {0, 1, 2}) + ", " + vec(1, {0, 1, 2}) + ")"
              : rounded("(" + product(vec(0, yzx), vec(1, zxy), facts.first) + " - " +
                        product(vec(0, zxy), vec(1, yzx), facts.second) + ")");
  if (components.back() == 3)
    return "vec4(" + result + ", 0.0)" + suffix(components);
  return components.size() == 3 ? result : result + suffix(components);
}
} // namespace

std::string expression(const Registers &registers, const Instruction &instruction,
                       const Components &components, const OperandFacts &facts, Numerics numerics) {
  const Writer w{registers, instruction, components, facts, numerics};
  const Components xyz = {0, 1, 2};
  const Components all = {0, 1, 2, 3};
  switch (instruction.op) {
  case Opcode::Abs:
    return w.call("abs");
  case Opcode::Add:
    return w.rounded(w.infix("+"));
  case Opcode::Cmp:
    return w.cmp();
  case Opcode::Cos:
    return w.function("cos");
  case Opcode::Dp3:
    return w.replicate(w.dot(xyz));
  case Opcode::Dp4:
    return w.replicate(w.dot(all));
  case Opcode::Dph:
    return w.replicate(w.dph());
  case Opcode::Dst:
    return w.pick({"1.0", w.product(w.at(0, 1), w.at(1, 1), facts.first), w.at(0, 2), w.at(1, 3)});
  case Opcode::Ex2:
    return w.function("exp2");
  case Opcode::Flr:
    return w.call("floor");
  case Opcode::Frc:
    return w.rounded(w.call("fract"));
  case Opcode::Lg2:
    return w.function("log2");
  case Opcode::Lit:
    return w.lit();
  case Opcode::Lrp:
    return w.lrp();
  case Opcode::Mad:
    return w.rounded(w.product() + " + " + w.vec(2));
  case Opcode::Max:
    return w.call2("max");
  case Opcode::Min:
    return w.call2("min");
  case Opcode::Mov:
  case Opcode::Swz:
    return w.vec(0);
  case Opcode::Mul:
    return w.product();
  case Opcode::Pow:
    return w.replicate(w.power(w.at(0, 0), w.at(1, 0)));
  case Opcode::Rcp:
    return w.replicate(w.rounded("1.0 / " + w.at(0, 0)));
  case Opcode::Rsq:
    return w.replicate(w.rounded("inversesqrt(abs(" + w.at(0, 0) + "))"));
  case Opcode::Scs:
    return w.pick(
        {w.rounded("cos(" + w.at(0, 0) + ")"), w.rounded("sin(" + w.at(0, 0) + ")"), "0.0", "0.0"});
  case Opcode::Sge:
    return w.compare(">=", "greaterThanEqual");
  case Opcode::Sin:
    return w.function("sin");
  case Opcode::Slt:
    return w.compare("<", "lessThan");
  case Opcode::Sub:
    return w.rounded(w.infix("-"));
  case Opcode::Xpd:
    return w.cross();
  case Opcode::Arl:
    return "arb_address(" + w.at(0, 0) + ")";
  case Opcode::Exp:
    return w.pick({"exp2(floor(" + w.at(0, 0) + "))", "fract(" + w.at(0, 0) + ")",
                   "exp2(" + w.at(0, 0) + ")", "1.0"});
  case Opcode::Log:
    return "arb_log(" + w.at(0, 0) + ")" + suffix(components);
  case Opcode::Seq:
    return w.compare("==", "equal");
  case Opcode::Sne:
    return w.differ();
  case Opcode::Ddx:
    return w.rounded(w.call("dFdx"));
  case Opcode::Ddy:
    return w.rounded(w.call("dFdy"));
  case Opcode::Pk2h:
    return w.pack("arb_pk2h", {0, 1});
  case Opcode::Pk2us:
    return w.pack("arb_pk2us", {0, 1});
  case Opcode::Pk4b:
    return w.pack("arb_pk4b", all);
  case Opcode::Pk4ub:
    return w.pack("arb_pk4ub", all);
  case Opcode::Up2h:
    return w.unpack("arb_up2h");
  case Opcode::Up2us:
    return w.unpack("arb_up2us");
  case Opcode::Up4b:
    return w.unpack("arb_up4b");
  case Opcode::Up4ub:
    return w.unpack("arb_up4ub");
  case Opcode::Tex:
  case Opcode::Txp:
  case Opcode::Txb:
  case Opcode::Txd:
  case Opcode::Txl:
    return w.rounded(sample(registers, instruction) + suffix(components));
  case Opcode::Kil: // no result
  case Opcode::Rep:
  case Opcode::Endrep:
  case Opcode::Brk:
#define FP_NV_WORD(Enumerator, ...) case Opcode::Enumerator:
#include "fp_compiler/ir/ops.def"
    break;
  }
  return "";
}

std::string killCondition(const Registers &registers, const Operand &operand) {
  std::vector<std::string> parts;
  Components distinct;
  for (int position = 0; position < 4; ++position) {
    const std::string text = component(registers, operand, position);
    if (std::find(parts.begin(), parts.end(), text) == parts.end()) {
      parts.push_back(text);
      distinct.push_back(position);
    }
  }
  if (distinct.size() == 1)
    return parts.front() + " < 0.0";
  return "any(lessThan(" + vector(registers, operand, distinct) + ", " + typeName(distinct.size()) +
         "(0.0)))";
}

} // namespace arbiter::fp::glsl
