// Tests hints for programs that are written as in GLSL, Cg, HLSL or C: each hint has the form of
// the language that the header names, with the author's own names.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp::c_like {
namespace {

using testing_support::check;
using testing_support::generous;

std::vector<Diagnostic> said(const std::string &text) {
  CompileOptions options = generous();
  options.limits.nvOptions = 2;
  options.limits.nvVertexProgram = 1;
  options.limits.generalCombiners = 8;
  options.limits.textureShaders = 3;
  return check(text, options).diagnostics;
}

/// The hint of the one error; another number of errors fails.
std::string only(const std::string &text) {
  const std::vector<Diagnostic> all = said(text);
  EXPECT_EQ(all.size(), 1u) << text << (all.size() > 1 ? all[1].message : "");
  return all.empty() ? "none" : all.front().hint;
}

std::string fragment(const std::string &statement) {
  return only("!!ARBfp1.0\nTEMP a, b, c;\n" + statement + "\nMOV result.color, a;\nEND\n");
}
std::string vertex(const std::string &statement) {
  return only("!!ARBvp1.0\nTEMP a, b, c;\n" + statement + "\nMOV result.position, a;\nEND\n");
}
std::string option(const std::string &name, const std::string &statement) {
  return only("!!ARBfp1.0\nOPTION " + name + ";\nTEMP a, b, c;\n" + statement +
              "\nMOV result.color, a;\nEND\n");
}
std::string own(const std::string &statement) {
  return only("!!FP1.0\n" + statement + "\nMOV o[COLR], R0;\nEND\n");
}
std::string ati(const std::string &statement) {
  return only("!!ATIfs1.0\nStartOutputPass;\nMOV r0, r1;\n" + statement + "\nEndPass;\n");
}
std::string combiners(const std::string &statement) {
  return only("!!RC1.0\n" + statement + "\nout.rgb = spare0;\n");
}
std::string begins(const std::string &form) {
  return "a statement begins with its instruction: " + form;
}

TEST(CNames, AreTheRegistersOfTheLanguage) {
  EXPECT_EQ(fragment("MOV gl_FragColor, a;"),
            "gl_FragColor is GLSL's; the assembly writes result.color");
  EXPECT_EQ(fragment("MOV a, gl_FragCoord;"),
            "gl_FragCoord is GLSL's; the assembly reads fragment.position");
  EXPECT_EQ(fragment("MOV a, gl_TexCoord[0];"),
            "gl_TexCoord is GLSL's; the assembly reads fragment.texcoord[n]");
  EXPECT_EQ(fragment("MOV oC0, a;"), "oC0 is Direct3D's; the assembly writes result.color");
  EXPECT_EQ(vertex("MOV gl_TexCoord[0], a;"),
            "gl_TexCoord is GLSL's; the assembly writes result.texcoord[n]");
  EXPECT_EQ(vertex("MOV a, gl_MultiTexCoord2;"),
            "gl_MultiTexCoord2 is GLSL's; the assembly reads vertex.texcoord[2]");
  EXPECT_EQ(vertex("MOV gl_FragColor, a;"),
            "gl_FragColor is GLSL's, and there is nothing like it here");
  EXPECT_EQ(own("MOV gl_FragColor, R0;"), "gl_FragColor is GLSL's; the assembly writes o[COLR]");
  EXPECT_EQ(own("MOV R0, gl_FragCoord;"), "gl_FragCoord is GLSL's; the assembly reads f[WPOS]");
  EXPECT_EQ(only("!!VP1.0\nMOV gl_Position, v[OPOS];\nMOV o[HPOS], v[OPOS];\nEND\n"),
            "gl_Position is GLSL's; the assembly writes o[HPOS]");
  EXPECT_EQ(ati("MUL gl_FragColor, r0, r1;"),
            "gl_FragColor is GLSL's; the assembly leaves the colour in r0");
  EXPECT_EQ(ati("MUL r0, gl_Color, r1;"), "gl_Color is GLSL's; the assembly reads color0");
  EXPECT_EQ(combiners("gl_FragColor = tex0;"),
            "gl_FragColor is GLSL's; the assembly writes out.rgb and out.a");
}

TEST(CAssignments, AreInstructions) {
  EXPECT_EQ(fragment("a = b;"), begins("MOV a, b;"));
  EXPECT_EQ(fragment("gl_FragColor = a;"), begins("MOV result.color, a;"));
  EXPECT_EQ(fragment("result.color = a;"), begins("MOV result.color, a;"));
  EXPECT_EQ(fragment("a.x = -b.y;"), begins("MOV a.x, -b.y;"));
  EXPECT_EQ(fragment("a.xy = b * 2.0;"), begins("MUL a.xy, b, 2.0;"));
  EXPECT_EQ(fragment("a.st += b;"), begins("ADD a.xy, a.xy, b;"));
  EXPECT_EQ(fragment("a = b * 2.0f;"), begins("MUL a, b, 2.0;"));
  EXPECT_EQ(fragment("a = b + c;"), begins("ADD a, b, c;"));
  EXPECT_EQ(fragment("a = b - c;"), begins("SUB a, b, c;"));
  EXPECT_EQ(only("!!VP1.0\nR0 = R1 - R2;\nMOV o[HPOS], R0;\nEND\n"), begins("ADD R0, R1, -R2;"));
  EXPECT_EQ(fragment("a = b / c;"), begins("RCP tmp.x, c.x; MUL a, b, tmp.x;"));
  EXPECT_EQ(fragment("a += b;"), begins("ADD a, a, b;"));
  EXPECT_EQ(fragment("a = vec4(1.0, 0.0, 0.0, 1.0);"), begins("MOV a, {1.0, 0.0, 0.0, 1.0};"));
  EXPECT_EQ(fragment("a = gl_TexCoord[1].st;"), begins("MOV a, fragment.texcoord[1].xyyy;"));
  EXPECT_EQ(fragment("a = texture2D(b, c);"),
            "a statement begins with its instruction, and has no calls: TEX does what texture2D "
            "does");
  EXPECT_NE(fragment("a = normalize(b);").find("DP3, RSQ and MUL together do it"),
            std::string::npos);
  EXPECT_EQ(fragment("a = (b + c) * 2.0;"),
            "a statement begins with its instruction, which does one step: ADD, MUL or another, "
            "then a and its operands");
  EXPECT_EQ(own("R0 = R1 * R2;"), begins("MUL R0, R1, R2;"));
  EXPECT_EQ(ati("r0 = r0 * r1;"), begins("MUL r0, r0, r1;"));
}

TEST(CDeclarations, AreTheLanguagesOwn) {
  EXPECT_EQ(fragment("float x = 1.0;"), "write PARAM x = 1.0;");
  EXPECT_EQ(fragment("const vec3 x = vec3(0, 1, 0);"), "write PARAM x = {0, 1, 0};");
  EXPECT_EQ(fragment("vec4 x;\nMOV x, a;"), "write TEMP x;");
  EXPECT_EQ(fragment("half4 x = a * b;\nMOV x, a;"), "write TEMP x;");
  EXPECT_EQ(fragment("uniform vec4 x;\nMOV a, x;"), "write PARAM x = program.local[0];");
  EXPECT_EQ(fragment("varying vec2 x;"), "write ATTRIB x = fragment.texcoord[0];");
  EXPECT_EQ(vertex("attribute vec4 x;"), "write ATTRIB x = vertex.attrib[1];");
  EXPECT_EQ(vertex("varying vec4 x;"), "write OUTPUT x = result.texcoord[0];");
  EXPECT_EQ(fragment("out vec4 x;"), "write OUTPUT x = result.color;");
  EXPECT_EQ(fragment("uniform sampler2D x;"),
            "textures have no names: TEX names their unit, texture[0]");
  EXPECT_EQ(fragment("precision mediump float;"), "leave it out");
  EXPECT_EQ(own("float x = 1.0;"), "write DEFINE x = 1.0;");
  EXPECT_EQ(ati("vec4 x;"), "registers are there without a declaration: r0 to r5");
  EXPECT_EQ(combiners("vec4 x = 1;"), "write const0 = (r, g, b, a);");
}

TEST(CFunctionsAndBlocks, AreNotThere) {
  const std::string function =
      "there are no functions: statements stand between the header and END";
  EXPECT_EQ(fragment("void main() {"), function);
  EXPECT_EQ(fragment("main() {"), function);
  EXPECT_EQ(fragment("float f(float x) {"), function);
  EXPECT_EQ(fragment("}"), "there are no blocks: END ends the program");
  EXPECT_NE(fragment("if (a.x > 0.5) {").find("CMP chooses"), std::string::npos);
  EXPECT_NE(vertex("if (a.x > 0.5) {").find("SLT gives 1 or 0"), std::string::npos);
  EXPECT_EQ(option("NV_fragment_program2", "if (a.x > 0.5) {"),
            "IF, ELSE and ENDIF do it, by a condition code: IF GT.x;");
  EXPECT_EQ(said("!!ARBfp1.0\nTEMP a;\nMOV a, 1.0;\n}\nfor (i = 0; i < 4; i++)\nADD a, a, a;\n"
                 "MOV result.color, a;\nEND\n")
                .size(),
            2u)
      << "one error for the brace, one for the loop";
  EXPECT_NE(fragment("for (i = 0; i < 4; i++) {").find("there are no loops"), std::string::npos);
  EXPECT_NE(fragment("return a;").find("END"), std::string::npos);
}

/// KIL and CMP ask whether an operand is below zero. SLT gives 0 or 1, which never is.
TEST(CConditions, AreDifferences) {
  const std::string begins =
      "an operand is one value, and below zero is the condition: SUB computes ";
  EXPECT_EQ(fragment("CMP a, b.x < 0.5, b, c;"), begins + "b.x - 0.5 before it");
  EXPECT_EQ(fragment("CMP a, b.x > 0.5, b, c;"), begins + "0.5 - b.x before it");
  EXPECT_EQ(fragment("MOV a, b;\n  KIL b.a < 0.5;"), begins + "b.a - 0.5 before it");
}

/// The operands of these are not in the order of the opcode that resembles them, or their base is
/// another.
TEST(CFunctions, WhoseOpcodeDiffersSayHow) {
  const std::string begins = "a statement begins with its instruction, and has no calls: ";
  EXPECT_EQ(fragment("a = log(b.x);"), begins + "log(x) is 0.693147 times LG2 of x");
  EXPECT_EQ(fragment("a = step(b, c);"),
            begins + "step(edge, x) is SGE with x first: SGE result, x, edge;");
  const std::string mix = "mix(a, b, t) is LRP with t first, and b before a: LRP result, t, b, a;";
  EXPECT_EQ(fragment("a = mix(b, c, 0.5);"), begins + mix);
  EXPECT_EQ(fragment("mix a, b, c, 0.5;"), mix);
  EXPECT_EQ(vertex("a = mix(b, c, 0.5);"),
            begins + "mix(a, b, t) is SUB tmp, b, a; MAD result, t, tmp, a;");
  EXPECT_EQ(fragment("EXP a, b.x;"), "use EX2") << "Direct3D's is of base 2";
}

TEST(CExpressions, AreInstructionsBeforeTheOperand) {
  EXPECT_EQ(fragment("MUL a, b * 2.0, c;"),
            "an operand is one value; MUL computes b * 2.0 before it");
  EXPECT_EQ(fragment("MOV a, b + c;"), "an operand is one value; ADD computes b + c before it");
  EXPECT_EQ(fragment("MOV a, b / c;"),
            "an operand is one value; RCP and MUL compute b / c before it");
  EXPECT_EQ(fragment("MOV a, b; // c"), "a comment begins with #");
  EXPECT_EQ(fragment("MOV a, b; /* c */"), "a comment begins with #");
  EXPECT_EQ(fragment("MUL a, b, 2.0f;"), "a number takes no letter: write 2.0");
  EXPECT_EQ(own("MUL R0, R1, 2.0f;"), "a number takes no letter: write 2.0");
  EXPECT_EQ(fragment("MUL a, b, f2;"),
            "declare it first, with TEMP, PARAM, ATTRIB, OUTPUT or ALIAS");
  EXPECT_EQ(fragment("MOV a, vec4(1.0, 0.5, 0.0, 1.0);"),
            "a constant vector stands in braces: {1.0, 0.5, 0.0, 1.0}");
  EXPECT_EQ(fragment("MOV a, vec4(0.5);"), "a number fills all four components: write 0.5");
  EXPECT_EQ(fragment("MOV a, b < 0.5;"), "an operand is one value; SLT computes b < 0.5 before it");
  EXPECT_EQ(fragment("MOV a, b*-1;"), "an operand is one value; MUL computes b * -1 before it");
  EXPECT_EQ(fragment("MOV a, exp(b.x);"),
            "an operand is one value, and there are no calls: exp(x) is EX2 of 1.442695 * x");
  EXPECT_EQ(fragment("MOV a, (1.0, 0.5);"), "a constant vector stands in braces: {1.0, 0.5}");
  EXPECT_EQ(fragment("MOV a, dot(b, c);"),
            "an operand is one value, and there are no calls: DP3 or DP4 does what dot does");
  EXPECT_EQ(fragment("MOV a, b.xyz;"),
            "a suffix is one or four of x, y, z, w, or of r, g, b, a: write .xyzz");
  EXPECT_EQ(vertex("MOV a, b.st;"), "a suffix is one or four of x, y, z, w: write .xyyy");
}

TEST(Declarations, ThatLackTheirValueAreShown) {
  EXPECT_EQ(fragment("OUTPUT o;"), "write OUTPUT o = result.color;");
  EXPECT_EQ(fragment("ATTRIB t;"), "write ATTRIB t = fragment.texcoord[0];");
  EXPECT_EQ(vertex("ATTRIB t;"), "write ATTRIB t = vertex.position;");
  EXPECT_EQ(fragment("PARAM k;"), "write PARAM k = program.local[0]; or a constant behind '='");
  EXPECT_EQ(fragment("TEMP t = 1.0;"),
            "a declaration gives no value: MOV t, ... gives one, and PARAM t = ...; is a constant");
}

TEST(Bindings, ThatLackTheirNameAreShown) {
  EXPECT_EQ(fragment("MOV result, a;"), "name the result: result.color or result.depth");
  EXPECT_EQ(vertex("MOV result, a;"),
            "name the result: result.position, result.color, result.texcoord[0]");
  EXPECT_EQ(fragment("MOV a, fragment;"),
            "name the attribute: fragment.color, fragment.texcoord[0]");
  EXPECT_EQ(fragment("MOV a, program;"), "name the parameter: program.local[0] or program.env[0]");
}

TEST(Units, HaveNumbers) {
  const auto written = [](const std::string &unit) {
    return "write texture[" + unit + "]: the units have numbers and no names";
  };
  EXPECT_EQ(fragment("TEX a, b, tex0, 2D;"), written("0"));
  EXPECT_EQ(fragment("TEX a, b, s3, 2D;"), written("3"));
  EXPECT_EQ(fragment("TEX a, b, 1, 2D;"), written("1"));
  EXPECT_EQ(fragment("TEX a, b, picture, 2D;"), written("0"));
  EXPECT_EQ(fragment("TEX a, texture[0], b, 2D;"),
            "the coordinate stands before the unit: TEX a, b, texture[0], 2D;");
}

TEST(Scalars, AreShownWithTheirComponent) {
  EXPECT_EQ(fragment("RCP a, b;"), "choose one of x, y, z, w: write b.x");
  EXPECT_EQ(fragment("RSQ a, -b;"), "choose one of x, y, z, w: write -b.x");
  EXPECT_EQ(fragment("POW a, b.x, 2.0;"), "a constant needs it too: write {2.0}.x");
  EXPECT_EQ(fragment("EX2 a, {2.0};"), "a constant needs it too: write {2.0}.x");
  EXPECT_TRUE(
      said("!!ARBfp1.0\nTEMP a;\nPOW a, {2.0}.x, 2.0.x;\nMOV result.color, a;\nEND").empty());
  EXPECT_TRUE(said("!!ARBfp1.0\nOPTION NV_fragment_program;\nTEMP a;\nPOW a, 2.0, 3.0;\n"
                   "MOV result.color, a;\nEND")
                  .empty());
}

TEST(Opcodes, OfLaterCardsAreMadeOfOthers) {
  EXPECT_EQ(only("!!ARBvp1.0\nTEMP a;\nDIV a, a, 2.0;\nEND\n"),
            "RCP and MUL together do it: RCP tmp.x, {2.0}.x; MUL a, a, tmp.x;");
  const std::string text = "!!ARBfp1.0\nTEMP a, b;\nDIV a, b, a;\nEND\n";
  EXPECT_EQ(check(text).diagnostics.at(0).hint,
            "RCP and MUL together do it: RCP tmp.x, a.x; MUL a, b, tmp.x;");
}

} // namespace
} // namespace arbiter::fp::c_like
