// Tests vertex programs with one planted error each (ARB_vertex_program 2.14.2 to 2.14.4).
#include "fp_compiler/front/testing/planted.h"

namespace arbiter::fp {
namespace {

using testing_support::Planted;

constexpr Planted kVertexPlanted[] = {
    // Features of fragment programs.
    {"fragment-only", "@TEX R0, R1, texture[0], 2D;\nEND"},
    {"fragment-only", "@KIL R0;\nEND"},
    {"fragment-only", "@LRP R0, R1, R1, R1;\nEND"},
    {"fragment-only", "@SIN R0, R1.x;\nEND"},
    {"fragment-only", "@MOV_SAT R0, R1;\nEND"},
    {"fragment-only", "MOV R0, @fragment.color;\nEND"},
    {"fragment-only", "ATTRIB a = @fragment.color;\nEND"},
    {"fragment-only", "MOV result.@depth, R0;\nEND"},
    {"fragment-only", "MOV result.color@[0], R0;\nEND"},
    {"fragment-only", "OUTPUT o = result.color@[1];\nEND"},
    {"fragment-only", "PARAM p = state.@texenv[0].color;\nEND"},
    {"fragment-only", "PARAM p = state.@depth.range;\nEND"},
    {"unknown-instruction", "@ARL_SAT R0, R1;\nEND"},
    {"nv-only", "@ARR R0, R1;\nEND"},
    {"nv-only", "@SSG R0, R1;\nEND"},
    {"nv-only", "@MOVC R0, R1;\nEND"},
    {"nv-only", "MOV result.@clip[0], R0;\nEND"},
    {"invalid-character", "MOV R0 @(GT), R1;\nEND"},
    // Names.
    {"reserved-name", "TEMP @vertex;\nEND"},
    {"reserved-name", "TEMP a, @ADDRESS;\nEND"},
    {"reserved-name", "ADDRESS @EXP;\nEND"},
    {"redeclared-name", "ADDRESS A;\nTEMP @A;\nEND"},
    {"undeclared-name", "MOV R0, @fragment;\nEND"},
    {"undeclared-name", "MOV R0, @texture;\nEND"},
    // Attributes.
    {"unknown-binding", "MOV R0, vertex.@colour;\nEND"},
    {"unknown-binding", "ATTRIB a = vertex.color.@front;\nEND"},
    {"syntax", "ATTRIB a = @R0;\nEND"},
    {"syntax", "MOV R0, vertex.attrib@;\nEND"},
    {"syntax", "MOV R0, vertex.attrib[@-1];\nEND"},
    {"attribute-index", "MOV R0, vertex.attrib[@16];\nEND"},
    {"texcoord-index", "MOV R0, vertex.texcoord[@8];\nEND"},
    {"relative-addressing", "ADDRESS A;\nMOV R0, vertex.texcoord[@A.x];\nEND"},
    {"relative-addressing", "ADDRESS A;\nMOV R0, program.env[@A.x];\nEND"},
    {"attribute-extension", "MOV R0, vertex.@weight;\nEND"},
    {"attribute-extension", "ATTRIB a = vertex.@weight[0];\nEND"},
    {"attribute-extension", "MOV R0, vertex.@matrixindex[0];\nEND"},
    {"attribute-alias", "MOV R0, vertex.position;\nMOV R1, @vertex.attrib[0];\nEND"},
    {"attribute-alias", "ATTRIB a = vertex.attrib[2];\nATTRIB b = @vertex.normal;\nEND"},
    {"attribute-alias", "MOV R0, vertex.color;\nMOV R1, -@vertex.attrib[3].x;\nEND"},
    {"attribute-alias", "MOV R0, vertex.color.secondary;\nMOV R1, @vertex.attrib[4];\nEND"},
    {"attribute-alias", "ADD R0, vertex.attrib[5], @vertex.fogcoord.x;\nEND"},
    {"attribute-alias", "ADD R0, vertex.attrib[8], @vertex.texcoord;\nEND"},
    {"attribute-alias", "ADD R0, vertex.texcoord[7], @vertex.attrib[15];\nEND"},
    {"read-only-destination", "MOV @vertex.position, R0;\nEND"},
    {"read-only-destination", "PARAM c[] = {1, 2};\nADDRESS A;\nMOV @c[0], R0;\nEND"},
    // Results.
    {"unknown-binding", "MOV result.@normal, R0;\nEND"},
    {"write-only-source", "MOV R0, @result.position;\nEND"},
    {"texcoord-index", "MOV result.texcoord[@8], R0;\nEND"},
    {"syntax", "OUTPUT o = result.color.back.secondary@.x;\nEND"},
    {"bad-mask", "MOV result.color.front.@secundary, R0;\nEND"},
    // State.
    {"unknown-binding", "PARAM p = state.texgen[0].@sphere.s;\nEND"},
    {"unknown-binding", "PARAM p = state.texgen.eye.@w;\nEND"},
    {"unknown-binding", "PARAM p = state.clip[0].@equation;\nEND"},
    {"unknown-binding", "PARAM p = state.point.@fade;\nEND"},
    {"unknown-binding", "PARAM p = state.@rasterpos;\nEND"},
    {"syntax", "PARAM p = state.clip@.plane;\nEND"},
    {"clip-plane-index", "PARAM p = state.clip[@6].plane;\nEND"},
    {"texcoord-index", "PARAM p = state.texgen[@8].eye.s;\nEND"},
    {"matrix-index", "PARAM p[] = { state.matrix.palette[@0] };\nEND"},
    // Address registers.
    {"address-register", "ADDRESS A;\nMOV @A.x, R0;\nEND"},
    {"address-register", "ADDRESS A;\nMOV R0, @A.x;\nEND"},
    {"address-register", "ADDRESS A;\nARL @R0.x, R1.x;\nEND"},
    {"address-register", "PARAM c[] = {1, 2};\nMOV R0, c[@R1.x];\nEND"},
    {"address-component", "ADDRESS A;\nARL A.@y, R1.x;\nEND"},
    {"address-component", "ADDRESS A;\nARL A.@xyzw, R1.x;\nEND"},
    {"address-component", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.@xx];\nEND"},
    {"syntax", "ADDRESS A;\nARL A@, R1.x;\nEND"},
    {"syntax", "ARL @result.position.x, R1.x;\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A@];\nEND"},
    {"invalid-character", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x@*2];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@-1];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@1.0];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+1@+1];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[1@+A.x];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[@vertex.position];\nEND"},
    {"relative-offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@4096];\nEND"},
    {"relative-offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x-@4096];\nEND"},
    {"relative-offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@4294967296];\nEND"},
    {"undeclared-name", "PARAM c[] = {1, 2};\nMOV R0, c[@A.x];\nEND"},
    {"undeclared-name", "ARL @A.x, R0.x;\nEND"},
    {"not-an-array", "ADDRESS A;\nMOV R0, R1@[A.x];\nEND"},
    {"array-index", "PARAM c[] = {1, 2};\nMOV R0, c[@2];\nEND"},
    {"scalar-suffix", "ADDRESS A;\nARL A.x, R0@;\nEND"},
    {"relative-duplicate", "ADDRESS A;\nPARAM c[] = { program.env[0..3], program.env[3] };\n"
                           "MOV R0, @c[A.x];\nEND"},
    {"relative-duplicate", "ADDRESS A;\nPARAM c[] = { state.matrix.mvp };\n"
                           "PARAM d[] = { state.matrix.mvp.row[2] };\n"
                           "MOV R0, c[A.x];\nMOV R0, -@d[A.x].x;\nEND"},
    // Components are xyzw.
    {"bad-swizzle", "MOV R0, R1.@r;\nEND"},
    {"bad-mask", "MOV R0.@rgb, R1;\nEND"},
    {"swz-selector", "SWZ R0, R1, @r, g, b, a;\nEND"},
};

TEST(VertexErrorPosition, IsTheFirstWrongByte) {
  EXPECT_GE(testing_support::expectPlanted("!!ARBvp1.0", kVertexPlanted), 300);
}

// Options come before all statements, so these programs have their own beginning.
constexpr Planted kPlantedVertexHeaders[] = {
    {"header-missing", "@"},
    {"header-missing", "!!ARB@fp1.0\nEND"},
    {"header-missing", "!!ARBvp1.@1\nEND"},
    {"header-missing", "!!@VP2.0\nEND"},
    {"header-missing", "@\n!!ARBvp1.0\nEND"},
    {"unsupported-option", "!!ARBvp1.0\nOPTION @ARB_fog_exp;\nEND"},
    {"unsupported-option", "!!ARBvp1.0\nOPTION @ARB_precision_hint_fastest;\nEND"},
    {"unsupported-option", "!!ARBvp1.0\nOPTION @ARB_position_invarient;\nEND"},
    {"unsupported-option", "!!ARBvp1.0\nOPTION @NV_vertex_program2;\nEND"},
    {"late-option", "!!ARBvp1.0\nTEMP a;\n@OPTION ARB_position_invariant;\nEND"},
    {"invariant-position",
     "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.@position, 1;\nEND"},
    {"invariant-position",
     "!!ARBvp1.0\nOPTION ARB_position_invariant;\nOUTPUT o = result.@position;\nEND"},
};

TEST(VertexErrorPosition, IsTheFirstWrongByteOfHeaderAndOptions) {
  testing_support::expectPlantedHeaders(ir::Language::ArbVertex, kPlantedVertexHeaders);
}

TEST(VertexErrorPosition, AnOptionOfNvIsNamedAndOnTheRoadMap) {
  for (const std::string option : {"NV_vertex_program2", "NV_vertex_program3"}) {
    const std::string text = "!!ARBvp1.0\nOPTION " + option + ";\nEND";
    const std::string message =
        checkProgram(ir::Language::ArbVertex, text, testing_support::small()).errorString(text);
    EXPECT_NE(message.find(option + " is not offered"), std::string::npos) << message;
  }
}

} // namespace
} // namespace arbiter::fp
