#include "fp_compiler/back/glsl/helpers.h"

#include <algorithm>
#include <iterator>

namespace arbiter::fp::glsl {

using ir::Opcode;

namespace {
/// int() is undefined for values out of range. Such an address becomes an index outside every
/// array, with room for all offsets.
constexpr const char *kAddress =
    "int arb_address(float x) { return abs(x) < 1073741824.0 ? int(floor(x)) : -1073741824; }\n";

/// Returns one step of the binary search for LOG's exponent.
std::string step(const char *condition, const char *factor, int exponent) {
  return std::string("  if (") + condition + ") { m *= " + factor +
         "; e += " + std::to_string(exponent) + ".0; }\n";
}

/// Returns the helper for LOG. Its mantissa must be exact. A host's log2() may round up to the next
/// integer just below a power of two, and its exp2() of -127 is a denormal. Multiplications by
/// powers of two are exact.
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

/// Returns overloads for vectors of a function with one or two float arguments.
std::string forVectors(const std::string &name, int arguments) {
  std::string text;
  for (const std::string width : {"2", "3", "4"}) {
    const std::string type = "vec" + width;
    text += type + " " + name + "(" + type + " a" + (arguments == 2 ? ", " + type + " b" : "") +
            ") { return " + type + "(";
    for (std::size_t i = 0; i < std::size_t(width[0] - '0'); ++i) {
      const std::string component = std::string(".") + "xyzw"[i];
      text += (i ? ", " : "") + name + "(a" + component +
              (arguments == 2 ? ", b" + component : "") + ")";
    }
    text += "); }\n";
  }
  return text;
}

/// True if the sign of a zero can change a result, as a division can. Otherwise -0 times a finite
/// number may be either zero, and a shorter form is enough. Some hosts recognise that form as their
/// own multiplication.
bool tellsZeros(const ir::Program &program) {
  return std::any_of(program.code.begin(), program.code.end(), [](const auto &instruction) {
    return instruction.op == Opcode::Rcp || instruction.op == Opcode::Txp;
  });
}

std::string product(const char *arguments, const char *zero, const char *value, bool tellsZeros) {
  const std::string test = std::string("(") + zero + ")";
  return std::string("float ") + arguments +
         (tellsZeros ? std::string(" { float p = ") + value + "; return p != p && " + test +
                           " ? 0.0 : p; }\n"
                     : " { return " + test + " ? 0.0 : " + value + "; }\n");
}

/// Rounds to 24-bit floats as fp_compiler/numerics.h does. 0x5F7FFFC0 is the smallest magnitude
/// that rounds to 2^64 and so to infinity; NaN stays NaN. 0x20800000 is 2^-62.
constexpr const char *kRound =
    "float arb_round(float x) {\n"
    "  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF;\n"
    "  int near = (size + 63 + (size >> 7 & 1)) & -128;\n"
    "  near = size >= 0x5F7FFFC0 ? (size > 0x7F800000 ? size : 0x7F800000)\n"
    "                            : near < 0x20800000 ? 0 : near;\n"
    "  return intBitsToFloat(bits ^ size | near);\n}\n";
constexpr const char *kTruncate =
    "float arb_truncate(float x) {\n"
    "  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF;\n"
    "  int less = size >= 0x5F800000 ? (size >= 0x7F800000 ? size : 0x5F7FFF80)\n"
    "                                : size < 0x20800000 ? 0 : size & -128;\n"
    "  return intBitsToFloat(bits ^ size | less);\n}\n";
/// Rounds a colour to the nearest multiple of 1 / 4095, ties to even.
constexpr const char *kColor =
    "float arb_colour(float x) {\n"
    "  float unit = (x > 0.0 ? min(x, 1.0) : 0.0) * 4095.0, low = floor(unit), over = unit - low;\n"
    "  bool up = over > 0.5 || over == 0.5 && (int(low) & 1) == 1;\n"
    "  return arb_round((up ? low + 1.0 : low) * 0.00024420026);\n}\n";
constexpr const char *kPower =
    "float arb_pow(float a, float b) {\n"
    "  float power = arb_round(exp2(arb_round(arb_mul(b, arb_round(log2(a))))));\n"
    "  return b == 0.0 ? 1.0 : a > 0.0 ? power : 0.0;\n}\n";

/// The helpers below implement the formats of fp_compiler/ir/packing.h.
constexpr const char *kNearest =
    "float arb_nearest(float x) {\n"
    "  float low = floor(x), over = x - low;\n"
    "  return over > 0.5 || over == 0.5 && (int(low) & 1) == 1 ? low + 1.0 : low;\n}\n";
constexpr const char *kHalf =
    "int arb_half(float x) {\n"
    "  int bits = floatBitsToInt(x), size = bits & 0x7FFFFFFF, sign = bits >> 16 & 0x8000;\n"
    "  if (size > 0x7F800000) return sign | 0x7FFF;\n"
    "  if (size >= 0x477FF000) return sign | 0x7C00;\n"
    "  if (size < 0x38800000) return sign | int(arb_nearest(abs(x) * 16777216.0));\n"
    "  return sign | (size + 0xFFF + (size >> 13 & 1) - 0x38000000) >> 13;\n}\n";
constexpr const char *kSingle =
    "float arb_single(int h) {\n"
    "  int sign = (h & 0x8000) << 16, size = h & 0x7FFF;\n"
    "  if (size >= 0x7C00) return intBitsToFloat(sign | 0x7F800000 | (size & 0x3FF) << 13);\n"
    "  if (size < 0x400) return (sign != 0 ? -1.0 : 1.0) * float(size) * 5.9604644775390625e-8;\n"
    "  return intBitsToFloat(sign | (size << 13) + 0x38000000);\n}\n";
constexpr const char *kUnsigned =
    "int arb_unsigned(float x, float most) {\n"
    "  return int(arb_nearest((x > 0.0 ? min(x, 1.0) : 0.0) * most));\n}\n";
constexpr const char *kSigned = "int arb_signed(float x) {\n"
                                "  float c = x > -1.00787401575 ? min(x, 1.0) : -1.00787401575;\n"
                                "  return int(arb_nearest(127.0 * c + 128.0));\n}\n";
constexpr const char *kBytes =
    "vec4 arb_bytes(float x) {\n"
    "  int bits = floatBitsToInt(x);\n"
    "  return vec4(float(bits & 255), float(bits >> 8 & 255), float(bits >> 16 & 255),"
    " float(bits >> 24 & 255));\n}\n";
constexpr const char *kPk2h =
    "float arb_pk2h(vec2 a) { return intBitsToFloat(arb_half(a.x) | arb_half(a.y) << 16); }\n";
constexpr const char *kPk2us =
    "float arb_pk2us(vec2 a) {\n"
    "  return intBitsToFloat(arb_unsigned(a.x, 65535.0) | arb_unsigned(a.y, 65535.0) << 16);\n}\n";
constexpr const char *kPk4b =
    "float arb_pk4b(vec4 a) {\n"
    "  return intBitsToFloat(arb_signed(a.x) | arb_signed(a.y) << 8 | arb_signed(a.z) << 16 |"
    " arb_signed(a.w) << 24);\n}\n";
constexpr const char *kPk4ub =
    "float arb_pk4ub(vec4 a) {\n"
    "  return intBitsToFloat(arb_unsigned(a.x, 255.0) | arb_unsigned(a.y, 255.0) << 8 |"
    " arb_unsigned(a.z, 255.0) << 16 | arb_unsigned(a.w, 255.0) << 24);\n}\n";
constexpr const char *kUp2h =
    "vec4 arb_up2h(float x) {\n"
    "  int bits = floatBitsToInt(x);\n"
    "  return vec2(arb_single(bits & 0xFFFF), arb_single(bits >> 16 & 0xFFFF)).xyxy;\n}\n";
constexpr const char *kUp2us =
    "vec4 arb_up2us(float x) {\n"
    "  int bits = floatBitsToInt(x);\n"
    "  return vec2(float(bits & 0xFFFF), float(bits >> 16 & 0xFFFF)).xyxy / 65535.0;\n}\n";
constexpr const char *kUp4b = "vec4 arb_up4b(float x) { return (arb_bytes(x) - 128.0) / 127.0; }\n";
constexpr const char *kUp4ub = "vec4 arb_up4ub(float x) { return arb_bytes(x) / 255.0; }\n";

constexpr char kSums[] = "float arb_sum(vec3 p) { return (p.z + p.y) + p.x; }\n"
                         "float arb_sum(vec4 p) { return ((p.w + p.z) + p.y) + p.x; }\n"
                         "float arb_sum(vec3 p, float w) { return (p.x + (p.z + w)) + p.y; }\n";
/// Uses one statement for each sum, because Mesa rebalances the sums of one expression despite its
/// parentheses.
constexpr char kForwardSums[] =
    "float arb_sum(vec3 p) { float s = p.x + p.y; s += p.z; return s; }\n"
    "float arb_sum(vec3 p, float w) { float s = p.x + p.y; s += p.z; s += w; return s; }\n"
    "float arb_sum(vec4 p) { float s = p.x + p.y; s += p.z; s += p.w; return s; }\n";
constexpr char kRoundedSums[] =
    "float arb_sum(vec3 p) { return arb_round(arb_round(p.x + p.y) + p.z); }\n"
    "float arb_sum(vec3 p, float w) { return arb_round(arb_sum(p) + w); }\n"
    "float arb_sum(vec4 p) { return arb_sum(p.xyz, p.w); }\n";

struct Helper {
  std::string name, text;
};
} // namespace

std::string helpers(const ir::Program &program, Numerics numerics, const std::string &code) {
  const bool exact = tellsZeros(program);
  // Helpers call only helpers before them.
  const Helper all[] = {
      {"arb_address", kAddress},
      {"arb_log", logarithm()},
      {"arb_round", kRound + forVectors("arb_round", 1)},
      {"arb_truncate", kTruncate + forVectors("arb_truncate", 1)},
      {"arb_colour", kColor + forVectors("arb_colour", 1)},
      {"arb_mul", product("arb_mul(float a, float b)", "a == 0.0 || b == 0.0", "a * b", exact) +
                      forVectors("arb_mul", 2)},
      {"arb_mulz", product("arb_mulz(float z, float x)", "z == 0.0", "z * x", exact) +
                       forVectors("arb_mulz", 2)},
      {"arb_sum", numerics == Numerics::Fp24                    ? kRoundedSums
                  : program.language == ir::Language::ArbVertex ? kForwardSums
                                                                : kSums},
      {"arb_pow", kPower},
      {"arb_times", "int arb_times(float x) { return x >= 1.0 ? int(min(x, 65000.0)) : 0; }\n"},
      {"arb_nearest", kNearest},
      {"arb_half", kHalf},
      {"arb_single", kSingle},
      {"arb_unsigned", kUnsigned},
      {"arb_signed", kSigned},
      {"arb_bytes", kBytes},
      {"arb_pk2h", kPk2h},
      {"arb_pk2us", kPk2us},
      {"arb_pk4b", kPk4b},
      {"arb_pk4ub", kPk4ub},
      {"arb_up2h", kUp2h},
      {"arb_up2us", kUp2us},
      {"arb_up4b", kUp4b},
      {"arb_up4ub", kUp4ub},
  };
  std::string text;
  for (auto helper = std::rbegin(all); helper != std::rend(all); ++helper)
    if ((text + code).find(helper->name + "(") != std::string::npos)
      text = helper->text + text;
  return text;
}

} // namespace arbiter::fp::glsl
