// Tests vertex programs with one planted error each (ARB_vertex_program 2.14.2 to 2.14.4).
#include "fp_compiler/front/testing/planted.h"

namespace arbiter::fp {
namespace {

using testing_support::Planted;

constexpr Planted kVertexPlanted[] = {
    // Features of fragment programs.
    {"fragment_only", "@TEX R0, R1, texture[0], 2D;\nEND"},
    {"fragment_only", "@KIL R0;\nEND"},
    {"fragment_only", "@LRP R0, R1, R1, R1;\nEND"},
    {"fragment_only", "@SIN R0, R1.x;\nEND"},
    {"fragment_only", "@MOV_SAT R0, R1;\nEND"},
    {"fragment_only", "MOV R0, @fragment.color;\nEND"},
    {"fragment_only", "ATTRIB a = @fragment.color;\nEND"},
    {"fragment_only", "MOV result.@depth, R0;\nEND"},
    {"fragment_only", "MOV result.color@[0], R0;\nEND"},
    {"fragment_only", "OUTPUT o = result.color@[1];\nEND"},
    {"fragment_only", "PARAM p = state.@texenv[0].color;\nEND"},
    {"fragment_only", "PARAM p = state.@depth.range;\nEND"},
    {"unknown_instruction", "@ARL_SAT R0, R1;\nEND"},
    {"nv_only", "@ARR R0, R1;\nEND"},
    {"nv_only", "@SSG R0, R1;\nEND"},
    {"nv_only", "@MOVC R0, R1;\nEND"},
    {"nv_only", "MOV result.@clip[0], R0;\nEND"},
    {"invalid_character", "MOV R0 @(GT), R1;\nEND"},
    // Names.
    {"reserved_name", "TEMP @vertex;\nEND"},
    {"reserved_name", "TEMP a, @ADDRESS;\nEND"},
    {"reserved_name", "ADDRESS @EXP;\nEND"},
    {"redeclared_name", "ADDRESS A;\nTEMP @A;\nEND"},
    {"undeclared_name", "MOV R0, @fragment;\nEND"},
    {"undeclared_name", "MOV R0, @texture;\nEND"},
    // Attributes.
    {"unknown_binding", "MOV R0, vertex.@colour;\nEND"},
    {"unknown_binding", "ATTRIB a = vertex.color.@front;\nEND"},
    {"syntax", "ATTRIB a = @R0;\nEND"},
    {"syntax", "MOV R0, vertex.attrib@;\nEND"},
    {"syntax", "MOV R0, vertex.attrib[@-1];\nEND"},
    {"attribute_index", "MOV R0, vertex.attrib[@16];\nEND"},
    {"texcoord_index", "MOV R0, vertex.texcoord[@8];\nEND"},
    {"relative_addressing", "ADDRESS A;\nMOV R0, vertex.texcoord[@A.x];\nEND"},
    {"relative_addressing", "ADDRESS A;\nMOV R0, program.env[@A.x];\nEND"},
    {"attribute_extension", "MOV R0, vertex.@weight;\nEND"},
    {"attribute_extension", "ATTRIB a = vertex.@weight[0];\nEND"},
    {"attribute_extension", "MOV R0, vertex.@matrixindex[0];\nEND"},
    {"attribute_alias", "MOV R0, vertex.position;\nMOV R1, @vertex.attrib[0];\nEND"},
    {"attribute_alias", "ATTRIB a = vertex.attrib[2];\nATTRIB b = @vertex.normal;\nEND"},
    {"attribute_alias", "MOV R0, vertex.color;\nMOV R1, -@vertex.attrib[3].x;\nEND"},
    {"attribute_alias", "MOV R0, vertex.color.secondary;\nMOV R1, @vertex.attrib[4];\nEND"},
    {"attribute_alias", "ADD R0, vertex.attrib[5], @vertex.fogcoord.x;\nEND"},
    {"attribute_alias", "ADD R0, vertex.attrib[8], @vertex.texcoord;\nEND"},
    {"attribute_alias", "ADD R0, vertex.texcoord[7], @vertex.attrib[15];\nEND"},
    {"read_only_destination", "MOV @vertex.position, R0;\nEND"},
    {"read_only_destination", "PARAM c[] = {1, 2};\nADDRESS A;\nMOV @c[0], R0;\nEND"},
    // Results.
    {"unknown_binding", "MOV result.@normal, R0;\nEND"},
    {"write_only_source", "MOV R0, @result.position;\nEND"},
    {"texcoord_index", "MOV result.texcoord[@8], R0;\nEND"},
    {"syntax", "OUTPUT o = result.color.back.secondary@.x;\nEND"},
    {"bad_mask", "MOV result.color.front.@secundary, R0;\nEND"},
    // State.
    {"unknown_binding", "PARAM p = state.texgen[0].@sphere.s;\nEND"},
    {"unknown_binding", "PARAM p = state.texgen.eye.@w;\nEND"},
    {"unknown_binding", "PARAM p = state.clip[0].@equation;\nEND"},
    {"unknown_binding", "PARAM p = state.point.@fade;\nEND"},
    {"unknown_binding", "PARAM p = state.@rasterpos;\nEND"},
    {"syntax", "PARAM p = state.clip@.plane;\nEND"},
    {"clip_plane_index", "PARAM p = state.clip[@6].plane;\nEND"},
    {"texcoord_index", "PARAM p = state.texgen[@8].eye.s;\nEND"},
    {"matrix_index", "PARAM p[] = { state.matrix.palette[@0] };\nEND"},
    // Address registers.
    {"address_register", "ADDRESS A;\nMOV @A.x, R0;\nEND"},
    {"address_register", "ADDRESS A;\nMOV R0, @A.x;\nEND"},
    {"address_register", "ADDRESS A;\nARL @R0.x, R1.x;\nEND"},
    {"address_register", "PARAM c[] = {1, 2};\nMOV R0, c[@R1.x];\nEND"},
    {"address_component", "ADDRESS A;\nARL A.@y, R1.x;\nEND"},
    {"address_component", "ADDRESS A;\nARL A.@xyzw, R1.x;\nEND"},
    {"address_component", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.@xx];\nEND"},
    {"syntax", "ADDRESS A;\nARL A@, R1.x;\nEND"},
    {"syntax", "ARL @result.position.x, R1.x;\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A@];\nEND"},
    {"invalid_character", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x@*2];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@-1];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@1.0];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+1@+1];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[1@+A.x];\nEND"},
    {"syntax", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[@vertex.position];\nEND"},
    {"relative_offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@4096];\nEND"},
    {"relative_offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x-@4096];\nEND"},
    {"relative_offset", "ADDRESS A;\nPARAM c[] = {1, 2};\nMOV R0, c[A.x+@4294967296];\nEND"},
    {"undeclared_name", "PARAM c[] = {1, 2};\nMOV R0, c[@A.x];\nEND"},
    {"undeclared_name", "ARL @A.x, R0.x;\nEND"},
    {"not_an_array", "ADDRESS A;\nMOV R0, R1@[A.x];\nEND"},
    {"array_index", "PARAM c[] = {1, 2};\nMOV R0, c[@2];\nEND"},
    {"scalar_suffix", "ADDRESS A;\nARL A.x, R0@;\nEND"},
    {"relative_duplicate", "ADDRESS A;\nPARAM c[] = { program.env[0..3], program.env[3] };\n"
                           "MOV R0, @c[A.x];\nEND"},
    {"relative_duplicate", "ADDRESS A;\nPARAM c[] = { state.matrix.mvp };\n"
                           "PARAM d[] = { state.matrix.mvp.row[2] };\n"
                           "MOV R0, c[A.x];\nMOV R0, -@d[A.x].x;\nEND"},
    // Components are xyzw.
    {"bad_swizzle", "MOV R0, R1.@r;\nEND"},
    {"bad_mask", "MOV R0.@rgb, R1;\nEND"},
    {"swz_selector", "SWZ R0, R1, @r, g, b, a;\nEND"},
};

TEST(VertexErrorPosition, IsTheFirstWrongByte) {
  EXPECT_GE(testing_support::expectPlanted("!!ARBvp1.0", kVertexPlanted), 300);
}

// Options come before all statements, so these programs have their own beginning.
constexpr Planted kPlantedVertexHeaders[] = {
    {"header_missing", "@"},
    {"header_missing", "!!ARB@fp1.0\nEND"},
    {"header_missing", "!!ARBvp1.@1\nEND"},
    {"header_missing", "!!@VP2.0\nEND"},
    {"header_missing", "@\n!!ARBvp1.0\nEND"},
    {"unsupported_option", "!!ARBvp1.0\nOPTION @ARB_fog_exp;\nEND"},
    {"unsupported_option", "!!ARBvp1.0\nOPTION @ARB_precision_hint_fastest;\nEND"},
    {"unsupported_option", "!!ARBvp1.0\nOPTION @ARB_position_invarient;\nEND"},
    {"unsupported_option", "!!ARBvp1.0\nOPTION @NV_vertex_program2;\nEND"},
    {"late_option", "!!ARBvp1.0\nTEMP a;\n@OPTION ARB_position_invariant;\nEND"},
    {"invariant_position",
     "!!ARBvp1.0\nOPTION ARB_position_invariant;\nMOV result.@position, 1;\nEND"},
    {"invariant_position",
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
