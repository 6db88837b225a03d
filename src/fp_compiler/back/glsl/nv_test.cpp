// GLSL of programs under NVIDIA's options: the reference compiler accepts it, and it requests
// exactly the extensions that it needs.
#include <gtest/gtest.h>

#include "fp_compiler/back/glsl/validator.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/emit.h"
#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp::glsl {
namespace {

constexpr const char *kBits = "#extension GL_ARB_shader_bit_encoding : require";
constexpr const char *kLod = "#extension GL_ARB_shader_texture_lod : require";

/// Replaces EXT_gpu_shader4, which the reference compiler lacks, by a GLSL version that includes
/// its features.
std::string withIntegers(std::string glsl) {
  for (const std::string line : {"#extension GL_EXT_gpu_shader4 : require\n", "#version 120\n"})
    if (const std::size_t at = glsl.find(line); at != std::string::npos && contains(glsl, kBits))
      glsl.replace(at, line.size(), line[1] == 'v' ? "#version 330 compatibility\n" : "");
  return glsl;
}

std::string glslOf(std::string_view option, const std::string &statements) {
  const bool vertex = option.find("vertex") != std::string_view::npos;
  CompileOptions options = testing_support::generous();
  options.limits.nvOptions = 2;
  const std::string text = std::string(vertex ? "!!ARBvp1.0\n" : "!!ARBfp1.0\n") + "OPTION " +
                           std::string(option) + ";\nTEMP r, s;\n" + statements + "\nMOV result." +
                           (vertex ? "position" : "color") + ", r;\nEND\n";
  const CheckResult result = testing_support::check(text, options);
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  if (!result.ok())
    return {};
  GlslHost host;
  host.clipPlanes = false;
  const std::string glsl = emitGlsl(*result.program, host).text;
  EXPECT_TRUE(validates(withIntegers(glsl), vertex ? "vert" : "frag")) << text;
  return glsl;
}

TEST(NvGlsl, ConditionsAreChoices) {
  const std::string glsl =
      glslOf("NV_fragment_program", "MOVC s, fragment.color; MOV r, 0.0; MOV r (GT.x), 1.0; "
                                    "MOV r.y (NE.x), 2.0; KIL LT.y;");
  EXPECT_TRUE(contains(glsl, "?")) << glsl;
  EXPECT_FALSE(contains(glsl, "#extension")) << glsl;
}

TEST(NvGlsl, Derivatives) {
  const std::string glsl = glslOf("NV_fragment_program",
                                  "DDX r, fragment.texcoord[0]; DDY r.z, fragment.texcoord[0].x;");
  EXPECT_TRUE(contains(glsl, "dFdx(") && contains(glsl, "dFdy(")) << glsl;
}

TEST(NvGlsl, PackingReadsBits) {
  for (const char *pair : {"2H", "2US", "4B", "4UB"}) {
    const std::string glsl =
        glslOf("NV_fragment_program",
               std::string("PK") + pair + " s, fragment.color; UP" + pair + " r.xzw, s.x;");
    EXPECT_TRUE(contains(glsl, kBits)) << glsl;
    EXPECT_FALSE(contains(glsl, kLod)) << glsl;
  }
}

TEST(NvGlsl, EveryTargetAtAGivenLevel) {
  for (const char *target :
       {"1D", "2D", "3D", "CUBE", "RECT", "SHADOW1D", "SHADOW2D", "SHADOWRECT"}) {
    const std::string unit = std::string(", texture[0], ") + target + ";";
    const bool shadow = std::string_view(target).starts_with("S");
    const std::string option = shadow ? "OPTION ARB_fragment_program_shadow;" : "";
    const std::string begin = "!!ARBfp1.0\nOPTION NV_fragment_program2;\n" + option + "\nTEMP r;\n";
    for (const std::string &statement :
         {"TXL r, fragment.texcoord[0]" + unit,
          "TXD r, fragment.texcoord[0], fragment.texcoord[1], fragment.texcoord[2]" + unit}) {
      CompileOptions options = testing_support::generous();
      options.limits.nvOptions = 2;
      const std::string text = begin + statement + "\nMOV result.color, r;\nEND\n";
      const CheckResult result = testing_support::check(text, options);
      ASSERT_TRUE(result.ok()) << result.errorString(text);
      const std::string glsl = emitGlsl(*result.program).text;
      EXPECT_TRUE(validates(glsl)) << text;
      EXPECT_TRUE(contains(glsl, kLod)) << glsl;
    }
  }
}

// GLSL 1.20 has texture2DLod() in vertex shaders, but the reference compiler needs the extension
// enabled.
TEST(NvGlsl, VertexTexturesNeedNoExtension) {
  for (const char *op : {"TEX", "TXP", "TXB", "TXL"}) {
    const std::string glsl =
        glslOf("NV_vertex_program3", std::string(op) + " r, vertex.color, texture[0], 2D;");
    EXPECT_TRUE(contains(glsl, "texture2DLod(")) << glsl;
    EXPECT_FALSE(contains(glsl, ": require")) << glsl;
  }
}

TEST(NvGlsl, ComparisonsInVertexPrograms) {
  const std::string glsl = glslOf(
      "NV_vertex_program3;\nOPTION ARB_fragment_program_shadow",
      "TXL r, vertex.color, texture[0], SHADOW2D; TEX s, r, texture[1], SHADOWRECT; ADD r, r, s;");
  EXPECT_TRUE(contains(glsl, "shadow2DLod(") && contains(glsl, "shadow2DRect(")) << glsl;
}

TEST(NvGlsl, LoopsAndBranches) {
  const std::string glsl =
      glslOf("NV_fragment_program2", "LOOP {4, 0, 1}; ADD r, r, fragment.texcoord[A0.x + 1]; "
                                     "SGEC s.x, r, 3.0; BRK (NE.x); ENDLOOP; REP program.local[0]; "
                                     "IF EQ.x; ADD r, r, 1.0; ELSE; SUB r, r, 1.0; ENDIF; ENDREP;");
  EXPECT_TRUE(contains(glsl, "for (") && contains(glsl, "break;")) << glsl;
  EXPECT_TRUE(contains(glsl, "arb_left")) << glsl;
  EXPECT_TRUE(contains(
      glslOf("NV_vertex_program2", "a: ADD r, r, 1.0; SLTC s, r, vertex.color; BRA a (NE.x);"),
      "for ("));
}

TEST(NvGlsl, Facing) {
  EXPECT_TRUE(contains(glslOf("NV_fragment_program2", "MUL r, fragment.facing.x, fragment.color;"),
                       "gl_FrontFacing"));
}

} // namespace
} // namespace arbiter::fp::glsl
