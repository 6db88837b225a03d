#include "fp_compiler/back/glsl/helpers.h"

#include <algorithm>

namespace arbiter::fp::glsl {

using ir::Opcode;

namespace {
/// int() of a value that no int holds is undefined; such an index is one that no array has, with
/// room for every offset.
constexpr const char *kAddress =
    "int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }\n";

/// One step of the search for LOG's exponent.
std::string step(const char *condition, const char *factor, int exponent) {
  return std::string("  if (") + condition + ") { m *= " + factor +
         "; e += " + std::to_string(exponent) + ".0; }\n";
}

/// The mantissa is exact: a host's log2() may round up to the next integer just below a power of
/// two, and its exp2() of -127 is a denormal. Multiplications by powers of two lose nothing.
std::string logarithm() {
  return "vec4 arb_log(float x) {\n"
         "  float m = abs(x), l = log2(m), e = 0.0;\n"
         "  if (!(m > 0.0 && m <= 3.4028235e38)) return vec4(l, 1.0, l, 1.0);\n" +
         step("m >= 18446744073709551616.0", "5.421010862427522e-20", 64) +
         step("m >= 4294967296.0", "2.3283064365386963e-10", 32) +
         step("m >= 65536.0", "0.0000152587890625", 16) + step("m >= 256.0", "0.00390625", 8) +
         step("m >= 16.0", "0.0625", 4) + step("m >= 4.0", "0.25", 2) + step("m >= 2.0", "0.5", 1) +
         step("m < 1.0842021724855044e-19", "18446744073709551616.0", -64) +
         step("m < 4.656612873077393e-10", "4294967296.0", -32) +
         step("m < 0.000030517578125", "65536.0", -16) + step("m < 0.0078125", "256.0", -8) +
         step("m < 0.125", "16.0", -4) + step("m < 0.5", "4.0", -2) + step("m < 1.0", "2.0", -1) +
         "  return vec4(e, m, l, 1.0);\n}\n";
}

bool uses(const ir::Program &program, Opcode op) {
  return std::any_of(program.code.begin(), program.code.end(),
                     [op](const ir::Instruction &instruction) { return instruction.op == op; });
}
} // namespace

std::string helpers(const ir::Program &program) {
  return (uses(program, Opcode::Arl) ? kAddress : "") +
         (uses(program, Opcode::Log) ? logarithm() : std::string());
}

} // namespace arbiter::fp::glsl
