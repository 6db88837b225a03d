#include "exact_program.h"

namespace software {
namespace {

constexpr const char *kTargetNames[kExactUnits] = {"2D", "RECT", "CUBE", "3D", "1D"};
constexpr const char *kInputs[] = {"fragment.color",       "fragment.color.secondary",
                                   "fragment.texcoord[0]", "fragment.texcoord[1]",
                                   "fragment.texcoord[2]", "fragment.fogcoord.x"};
constexpr int kTemporaries = 4;

/// Sums and products have no constants: hosts add those of several instructions up beforehand.
struct Operation {
  const char *name;
  int operands;
  bool constants;
};
constexpr Operation kOperations[] = {
    {"MOV", 1, false}, {"ABS", 1, false}, {"FLR", 1, false}, {"FRC", 1, false},
    {"ADD", 2, false}, {"SUB", 2, false}, {"MUL", 2, false}, {"MIN", 2, true},
    {"MAX", 2, true},  {"SLT", 2, true},  {"SGE", 2, true},  {"CMP", 3, true},
};

std::string swizzle(Random &random) {
  static constexpr const char *kTies[] = {"xxxx", "xxyy", "yyxx", "xyxy", "yxyx", "xyyz", "xxyz"};
  if (random.once(2))
    return "";
  if (random.once(2))
    return std::string(".") + random.pick(kTies);
  std::string result = ".";
  for (int i = 0; i < 4; ++i)
    result += "xyzw"[random.below(4)];
  return result;
}

/// Returns an input in any order. Of the fog coordinate that is its number, as hosts do without
/// products by its zeros, whose sign is a side of a cube map.
std::string input(Random &random) {
  const int which = random.below(int(std::size(kInputs)));
  const bool isNumber = which + 1 == int(std::size(kInputs));
  return kInputs[which] + (isNumber ? "" : swizzle(random));
}

std::string operand(Random &random, bool constants) {
  const std::string sign = random.once(3) ? "-" : "";
  const int kind = random.below(constants ? 8 : 7);
  if (kind < 4)
    return sign + "t" + std::to_string(random.below(kTemporaries)) + swizzle(random);
  if (kind < 7)
    return sign + input(random);
  static constexpr const char *kNumbers[] = {"0.5", "0.25", "1.0", "2.0", "-1.0", "0.1"};
  return sign + "{" + random.pick(kNumbers) + ", " + random.pick(kNumbers) + ", " +
         random.pick(kNumbers) + ", " + random.pick(kNumbers) + "}";
}

/// \param at where, but for a lookup that divides: what divides is never near zero
std::string lookUp(Random &random, const std::string &to, const std::string &at) {
  const int unit = random.below(kExactUnits);
  const bool projected = kExactTargets[unit] != GL_TEXTURE_CUBE_MAP && random.once(4);
  static constexpr const char *kOrders[] = {"", ".yxzw", ".xxyw", ".zyxw"};
  const std::string divided =
      "fragment.texcoord[" + std::to_string(random.below(3)) + "]" + random.pick(kOrders);
  return std::string(projected ? "TXP " : "TEX ") + to + ", " + (projected ? divided : at) +
         ", texture[" + std::to_string(unit) + "], " + kTargetNames[unit] + "; ";
}

std::string around(const std::string &body) {
  std::string text = "!!ARBfp1.0 TEMP ";
  for (int i = 0; i < kTemporaries; ++i)
    text += (i ? ", t" : "t") + std::to_string(i);
  return text + "; " + body + "END";
}

} // namespace

std::string plainProgram(Random &random) {
  const std::string from = input(random);
  return around(random.once(2) ? "MOV result.color, " + from + "; "
                               : lookUp(random, "result.color", from));
}

std::string exactProgram(Random &random) {
  std::string body;
  for (int i = 0; i < kTemporaries; ++i)
    body += "MOV t" + std::to_string(i) + ", " + input(random) + "; ";
  const int count = random.between(2, 7);
  for (int i = 0; i < count; ++i) {
    const std::string to = "t" + std::to_string(random.below(kTemporaries));
    if (random.once(3)) {
      body += lookUp(random, to, operand(random, true));
      continue;
    }
    const Operation operation = random.pick(kOperations);
    body += std::string(operation.name) + " " + to;
    for (int k = 0; k < operation.operands; ++k)
      body += ", " + operand(random, operation.constants);
    body += "; ";
  }
  return around(body + "MOV result.color, t0; ");
}

} // namespace software
