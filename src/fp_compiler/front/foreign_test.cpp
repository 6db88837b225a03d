// Tests texts that people pass to `arbiter check` by mistake, and programs that only look like
// them.
#include "fp_compiler/front/foreign.h"

#include <gtest/gtest.h>

#include <string>

#include "fp_compiler/compiler.h"

namespace arbiter::fp {
namespace {

using namespace std::string_literals;

std::string foreignKind(std::string_view text) { return foreignText(text).kind; }

TEST(Foreign, OtherLanguagesAreKnown) {
  EXPECT_EQ(foreignKind("#version 120\nuniform sampler2D image;\nvoid main() {\n"
                        "  gl_FragColor = texture2D(image, gl_TexCoord[0].st);\n}\n"),
            "GLSL");
  EXPECT_EQ(foreignKind("// a comment\nvoid main(void)\n{\n  gl_Position = ftransform();\n}\n"),
            "GLSL");
  EXPECT_EQ(foreignKind("in vec3 normal;\nout vec4 colour;\nvoid main() { colour = vec4(1); }\n"),
            "GLSL");
  EXPECT_EQ(foreignKind("Texture2D image;\nSamplerState linear;\n"
                        "float4 main(float2 uv : TEXCOORD0) : SV_Target {\n"
                        "  return image.Sample(linear, uv);\n}\n"),
            "HLSL");
  EXPECT_EQ(
      foreignKind("void main(half2 uv : TEXCOORD0, uniform samplerRECT image,\n"
                  "          out half4 colour : COLOR) {\n  colour = texRECT(image, uv);\n}\n"),
      "Cg");
  EXPECT_EQ(foreignKind("float4 main(float2 uv : TEXCOORD0) : COLOR { return uv.xyxy; }\n"),
            "Cg or HLSL");
  EXPECT_EQ(foreignKind("ps_2_0\ndcl t0\ndef c0, 1, 0, 0, 0\nmov oC0, c0\n"),
            "Direct3D's shader assembly (ps_2_0)");
  EXPECT_EQ(foreignKind("// of 2001\nvs.1.1\nmov oPos, v0\n"),
            "Direct3D's shader assembly (vs.1.1)");
  EXPECT_EQ(foreignKind("; SPIR-V\n; Version: 1.0\nOpCapability Shader\n"), "SPIR-V assembly");
  EXPECT_EQ(foreignKind("[require]\nGL >= 2.1\n\n[fragment program]\n!!ARBfp1.0\nEND\n"),
            "a shader_test of piglit");
}

TEST(Foreign, FilesThatAreNoTextAreKnown) {
  EXPECT_EQ(foreignKind("\x7F"
                        "ELF\x02\x01\x01"s),
            "an ELF file");
  EXPECT_EQ(foreignKind("\x89PNG\r\n\x1A\n"s), "a PNG picture");
  EXPECT_EQ(foreignKind("\x03\x02\x23\x07\x00\x00\x01\x00"s), "a SPIR-V module");
  EXPECT_EQ(foreignKind("\x07\x23\x02\x03\x00\x01\x00\x00"s), "a SPIR-V module");
  EXPECT_EQ(foreignKind("abc\0def"s), "a binary file");
}

TEST(Foreign, ProgramsWithAWrongHeaderAreNot) {
  for (const char *const text : {
           "",
           "\n",
           "END\n",
           "ARBfp1.0\nMOV result.color, fragment.color;\nEND\n",
           "!ARBfp1.0\nMOV result.color, fragment.color;\nEND\n",
           "!!ARBfp2.0\nTEMP vec4;\nMOV result.color, vec4;\nEND\n",
           "# void main() { gl_FragColor = vec4(1.0); }\nMOV result.color, fragment.color;\nEND\n",
           "#version 120\nTEMP half4, float4;\nMOV result.color, half4;\nEND\n",
           "TEMP varying;\nDP3 varying, fragment.color, fragment.color;\n",
           "StartOutputPass;\nMOV r0, color0;\nEndPass;\n",
           "MOV result.color, fragment.texcoord[0];",
           "{ rgb { spare0 = col0 * tex0; } }\nout.rgb = spare0;\n",
           "texture_2d();\nnop();\n",
           "notes about the precision of a varying, and a layout\n",
       })
    EXPECT_EQ(foreignKind(text), "") << text;
}

Diagnostic first(std::string_view text) {
  const CheckResult result = checkProgram(ir::Language::ArbFragment, text, {});
  EXPECT_EQ(result.diagnostics.size(), 1u) << text;
  return result.diagnostics.at(0);
}

TEST(Foreign, TheDiagnosticSaysSo) {
  const Diagnostic glsl = first("void main() { gl_FragColor; }");
  EXPECT_EQ(glsl.message, "this is GLSL, which Arbiter does not read");
  EXPECT_STREQ(glsl.id, "header_missing");
  EXPECT_NE(glsl.hint.find("cgc -oglsl"), std::string::npos);
  const Diagnostic direct3d = first("ps_2_0\ndcl t0\nmov oC0, t0\n");
  EXPECT_EQ(direct3d.message,
            "this is Direct3D's shader assembly (ps_2_0), which Arbiter does not read");
  EXPECT_NE(direct3d.hint.find("arbiter capture"), std::string::npos);
}

TEST(Foreign, NoHeaderInFrontHelps) {
  for (const char *const text :
       {"void main() { gl_FragColor; }", "ps_2_0\nmov oC0, c0\n", "vs.1.1\nmov oPos, v0\n",
        "float4 main() : SV_Target { return 1; }", "float4 main() : COLOR { return 1; }",
        "fixed4 main() : COLOR { return texRECT(a, b); }", "; SPIR-V\n", "\x89PNG\r\n", "DXBC",
        "[require]\nGL >= 2.1\n"}) {
    const Diagnostic said = first(text);
    EXPECT_FALSE(said.hint.empty()) << text;
    EXPECT_EQ(said.hint.find("!!"), std::string::npos) << text << ": " << said.hint;
  }
  EXPECT_NE(first("MOV result.color, fragment.color;\nEND\n").hint.find("!!ARBfp1.0"),
            std::string::npos);
}

} // namespace
} // namespace arbiter::fp
