#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/front/nv/words.h"
#include "fp_compiler/ir/evaluate.h"
#include "fp_compiler/testing/specials.h"

/// Builds programs around the statements of opcode_cases.def, in each of NVIDIA's options and
/// languages.
namespace arbiter::fp::nv::testing {

using ir::NativeLanguage;
using ir::NvOption;
using ir::Vec4;

using fp::testing::kInf;
using fp::testing::kNan;

inline float bits(std::uint32_t value) { return std::bit_cast<float>(value); }

/// Values of the first parameters. The later ones are (n, n + 1/4, n + 1/2, n + 3/4).
inline const Vec4 kRows[] = {
    {-2, 0, 2, kNan},
    {1, 2, 3, 4},
    {0.5f, -0.25f, 1.75f, 0.1f},
    {kInf, -kInf, -0.0f, 0},
    {1e-40f, 65520, 1e10f, -1e-8f},
    {3, 0, 1, 2.7f},
    {0.3333333f, 2.7f, -3.6f, 100},
    {0, 1, -1, 2}, // what k is
    {0.5f, 1.5f, 2.5f, -0.5f},
    {},
    {bits(0x3c00c000), bits(0x80ff7f01), bits(0x0000ffff), bits(0x7bff0001)},
    {},
    {},
    {},
    {},
    {0.25f, 0.5f, 0.75f, 1},
};

inline Vec4 rowOf(std::uint16_t index) {
  const auto n = float(index);
  return index < std::size(kRows) ? kRows[index] : Vec4{n, n + 0.25f, n + 0.5f, n + 0.75f};
}

struct Language {
  const char *name;
  bool vertex;
  NvOption option;
  NativeLanguage native;
  const char *header;

  [[nodiscard]] bool has(ir::Opcode op) const {
    return option == NvOption::None ? offers(native, op) : offers(arb(), option, op);
  }
  [[nodiscard]] Word word(std::string_view text) const {
    return option == NvOption::None ? classify(text, native) : classify(text, arb(), option);
  }
  [[nodiscard]] bool conditions() const { return word("MOVC").keyword == Keyword::Opcode; }

private:
  [[nodiscard]] const ArbLanguage &arb() const {
    return arbLanguage(vertex ? ir::Language::ArbVertex : ir::Language::ArbFragment);
  }
};
inline constexpr Language kLanguages[] = {
    {"F1", false, NvOption::First, NativeLanguage::None,
     "!!ARBfp1.0\nOPTION NV_fragment_program;\n"},
    {"F2", false, NvOption::Second, NativeLanguage::None,
     "!!ARBfp1.0\nOPTION NV_fragment_program2;\n"},
    {"V2", true, NvOption::First, NativeLanguage::None, "!!ARBvp1.0\nOPTION NV_vertex_program2;\n"},
    {"V3", true, NvOption::Second, NativeLanguage::None,
     "!!ARBvp1.0\nOPTION NV_vertex_program3;\n"},
    {"FP1", false, NvOption::None, NativeLanguage::Fp1, "!!FP1.0\n"},
    {"VP1", true, NvOption::None, NativeLanguage::Vp1, "!!VP1.0\n"},
    {"VP11", true, NvOption::None, NativeLanguage::Vp11, "!!VP1.1\n"},
    {"VP2", true, NvOption::None, NativeLanguage::Vp2, "!!VP2.0\n"},
};

/// Returns a single name in the language's words.
inline std::string inWords(const Language &language, const std::string &name) {
  const bool native = language.option == NvOption::None;
  const std::string registers = "rstabck";
  if (name.size() == 1 && registers.find(name) != std::string::npos)
    return native ? "R" + std::to_string(registers.find(name)) : name;
  if (name == "f")
    return native ? "f[TEX0]" : "fragment.texcoord[0]";
  if (name == "T")
    return native ? "TEX0, 2D" : "texture[0], 2D";
  if (name == "A" || name == "B")
    return native ? (name == "A" ? "A0" : "A1") : name;
  return name == "E" && native ? "c" : name;
}

/// Returns the statements in the language's words. The caller replaces stars.
inline std::string translated(const Language &language, const std::string &statements) {
  std::string text, name;
  bool member = false; // behind a point: a mask
  for (const char letter : statements + " ") {
    if (std::isalnum(static_cast<unsigned char>(letter)) || letter == '_') {
      name += letter;
      continue;
    }
    text += member ? name : inWords(language, name);
    member = letter == '.';
    name.clear();
    text += letter;
  }
  return text;
}

/// Returns the whole text of a program.
/// \param rows of the parameters, for a, b and c
/// \param behind statements before the results are written
inline std::string wholeText(const Language &language, const char *rows, std::string statements,
                             const std::string &behind) {
  const bool native = language.option == NvOption::None;
  std::string text = language.header;
  if (!native) {
    text += "TEMP r, s, t, a, b, c, k;\n";
    text += "PARAM P[16] = { program.local[0..15] };\n";
    if (language.vertex)
      text += "ADDRESS A, B;\nPARAM E[96] = { program.env[0..95] };\n";
  }
  const auto load = [&](const char *target, const std::string &row) {
    text += "MOV " + inWords(language, target) + ", " +
            (!native           ? "P["
             : language.vertex ? "c["
                               : "p[") +
            row + "];\n";
  };
  std::istringstream sources(rows);
  std::string row;
  for (const char *const target : {"a", "b", "c"})
    if (sources >> row)
      load(target, row);
  load("k", "7");
  // In NVIDIA's languages registers start at zero anyway.
  for (const char *const zero : {"r", "s", "t"})
    load(zero, "13");
  std::string result = behind;
  if (language.vertex)
    result += native ? "MOV o[HPOS], R0;\nMOV o[TEX0], R0;\n"
                     : "MOV result.position, r;\nMOV result.texcoord[0], r;\n";
  else
    result += native ? "MOV o[COLR], R0;\n" : "MOV result.color, r;\n";
  statements = translated(language, statements);
  if (const auto out = statements.find("OUT "); out != std::string::npos)
    return text + statements.replace(out, 4, result) + "\nEND\n";
  return text + statements + "\n" + result + "END\n";
}

/// Returns a texel of the image of opcode_cases.def.
/// \param x, y change of the coordinate to the next pixel
inline Vec4 sampled(const ir::Sample &sample, const Vec4 &x, const Vec4 &y) {
  constexpr float kSize = 16, kLast = 4;
  const float longest = std::max(std::hypot(x[0], x[1]), std::hypot(y[0], y[1])) * kSize;
  const float lod = sample.lod ? *sample.lod : std::log2(longest) + sample.bias;
  // Nearest level (OpenGL 2.1, 3.8.8): one half rounds to the lower level.
  const float level = std::clamp(std::ceil(lod + 0.5f) - 1, 0.0f, kLast);
  const float size = std::ldexp(kSize, -int(level));
  const auto texel = [&](std::size_t i) {
    return std::floor((sample.coordinate[i] - std::floor(sample.coordinate[i])) * size);
  };
  return {texel(0), texel(1), level, 7};
}

/// Returns the results of the lower left of four pixels.
inline ir::Evaluation evaluated(const ir::Program &program) {
  std::array<ir::Inputs, 4> given;
  std::array<std::vector<Vec4>, 4> attributes;
  const bool vertex = program.language == ir::Language::ArbVertex;
  std::array<Vec4, 4> asked = {}; // the coordinates of the four pixels, once all have been there
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const auto x = float(lane & 1), y = float(lane >> 1);
    attributes[lane].assign(program.attributes.size(), {x, y, x, 1});
    given[lane].attributes = attributes[lane];
    given[lane].parameter = [](const ir::Parameter &parameter) { return rowOf(parameter.index); };
    given[lane].texture = [&asked, lane, vertex](const ir::Sample &sample) {
      asked[lane] = sample.coordinate;
      Vec4 along = {}, up = {}; // a vertex has none
      for (std::size_t i = 0; i < 4 && !vertex; ++i) {
        along[i] = asked[1][i] - asked[0][i];
        up[i] = asked[2][i] - asked[0][i];
      }
      return sample.gradient ? sampled(sample, sample.gradient->x, sample.gradient->y)
                             : sampled(sample, along, up);
    };
  }
  if (vertex)
    return ir::evaluate(program, given[0]);
  // The first run records the coordinates from which derivatives are computed.
  (void)ir::evaluateQuad(program, given);
  return ir::evaluateQuad(program, given)[0];
}

} // namespace arbiter::fp::nv::testing
