// Tests counting and limits (3.11.3.6, 3.11.4.5.1, 3.11.6).
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

using testing_support::check;
using testing_support::firstError;
using testing_support::generous;
using testing_support::repeat;
using testing_support::small;
using testing_support::wrap;

ResourceCounts counts(std::string_view statements) {
  const std::string text = wrap(statements);
  const CheckResult result = check(text, generous());
  EXPECT_TRUE(result.ok()) << result.errorString(text);
  return result.counts;
}

TEST(Counts, EmptyProgram) { EXPECT_EQ(counts(""), (ResourceCounts{.texIndirections = 1})); }

TEST(Counts, InstructionsAndNotEnd) {
  const ResourceCounts c = counts("TEMP a;\nMOV a, 1;\nKIL a;\nTEX a, a, texture[0], 2D;\n"
                                  "SWZ a, a, x, y, z, w;\n");
  EXPECT_EQ(c.instructions, 4u);
  EXPECT_EQ(c.aluInstructions, 2u);
  EXPECT_EQ(c.texInstructions, 2u);
}

TEST(Counts, DeclaredTemporariesEvenUnusedButNotAliases) {
  EXPECT_EQ(counts("TEMP a, b, c;\nALIAS d = a;\nALIAS e = d;").temporaries, 3u);
}

TEST(Counts, BoundAttributesOnce) {
  EXPECT_EQ(counts("ATTRIB a = fragment.color;\nATTRIB b = fragment.color.primary;\n"
                   "ATTRIB c = fragment.texcoord[3];\nTEMP t;\nMOV t, fragment.texcoord[3];\n"
                   "MOV t, fragment.position;")
                .attribs,
            3u);
}

TEST(Counts, StateVectorsOnce) {
  EXPECT_EQ(counts("PARAM a = state.material.diffuse;\nPARAM b = state.material.front.diffuse;\n"
                   "PARAM c = state.material.back.diffuse;\nPARAM d = program.env[0];\n"
                   "PARAM e = program.local[0];\nPARAM f[] = {program.env[0..1]};\n"
                   "PARAM g[] = {state.matrix.mvp};\nPARAM h = state.matrix.mvp.row[2];\n"
                   "PARAM i = state.matrix.mvp.transpose.row[2];\n")
                .parameters,
            2u + 1 + 1 + 1 + 4 + 1);
}

TEST(Counts, ConstantsOnceIfAllFourComponentsAreEqual) {
  EXPECT_EQ(counts("PARAM a = 1;\nPARAM b = {1, 1, 1, 1};\nPARAM c = {1.0};\n"
                   "PARAM d = {1, 0, 0, 1};\nTEMP t;\nADD t, 1.00, {1, 0};")
                .parameters,
            2u);
  // The constants are numerically equal, but two values.
  const CheckResult zeros = check(wrap("PARAM a = {0, 0, 0, 0};\nPARAM b = {-0, 0, 0, 0};"));
  EXPECT_EQ(zeros.counts.parameters, 1u);
  EXPECT_EQ(zeros.program->parameters.size(), 2u);
}

TEST(Counts, NativeFit) {
  CompileOptions options = small();
  options.limits.native.aluInstructions = 1;
  EXPECT_TRUE(check(wrap("TEMP a;\nMOV a, 1;"), options).underNativeLimits);
  EXPECT_FALSE(check(wrap("TEMP a;\nMOV a, 1;\nMOV a, 1;"), options).underNativeLimits);
}

// The cases of 3.11.6, and others that are easy to get wrong.
TEST(Indirections, ByTheApisRule) {
  const auto nodes = [](std::string_view body) {
    return counts("TEMP a, b, c;\n" + std::string(body)).texIndirections;
  };
  EXPECT_EQ(nodes("TEX a, fragment.texcoord[0], texture[0], 2D;\n"
                  "TEX b, fragment.texcoord[1], texture[1], 2D;"),
            1u);
  EXPECT_EQ(nodes("TEX a, fragment.texcoord[0], texture[0], 2D;\n"
                  "TEX b, a, texture[1], 2D;"),
            2u)
      << "a coordinate written by TEX";
  EXPECT_EQ(nodes("MOV a, fragment.texcoord[0];\nTEX b, a, texture[0], 2D;"), 2u)
      << "a coordinate written by ALU";
  EXPECT_EQ(nodes("MOV a.x, 1;\nTEX b, a.w, texture[0], 2D;"), 2u) << "masks are ignored";
  EXPECT_EQ(nodes("ADD a, b, c;\nTEX c, fragment.texcoord[0], texture[0], 2D;"), 2u)
      << "a result that ALU read";
  EXPECT_EQ(nodes("MOV a, 1;\nTEX a, fragment.texcoord[0], texture[0], 2D;"), 2u)
      << "a result that ALU wrote";
  EXPECT_EQ(nodes("TEX a, fragment.texcoord[0], texture[0], 2D;\n"
                  "TEX a, fragment.texcoord[1], texture[0], 2D;"),
            1u)
      << "a result that only TEX wrote";
  EXPECT_EQ(nodes("TEX a, b, texture[0], 2D;\nTEX b, fragment.texcoord[1], texture[0], 2D;"), 1u)
      << "a coordinate is no ALU operand";
  EXPECT_EQ(nodes("MOV a, 1;\nKIL a;"), 2u) << "KIL reads a coordinate";
  EXPECT_EQ(nodes("MOV b, a;\nKIL a;"), 1u) << "KIL writes nothing";
  EXPECT_EQ(nodes("MOV a, 1;\nTEX result.color, fragment.texcoord[0], texture[0], 2D;\n"
                  "KIL fragment.color;\nTEX b, 1, texture[0], 2D;"),
            1u)
      << "outputs, attributes and parameters never open a node";
  EXPECT_EQ(nodes("MOV a, 1;\nTEX b, a, texture[0], 2D;\nTEX c, a, texture[1], 2D;"), 2u)
      << "the new node has written b alone";
  EXPECT_EQ(nodes("MOV a, 1;\nTEX b, a, texture[0], 2D;\nTEX c, b, texture[1], 2D;"), 3u);
}

/// Makes a program with `count` units of one resource.
struct Maker {
  const char *id;
  std::uint32_t ResourceCounts::*resource;
  std::string (*make)(std::uint32_t count);
};

std::string numbered(const char *before, std::uint32_t count, const char *after) {
  std::string all;
  for (std::uint32_t i = 0; i < count; ++i)
    all += before + std::to_string(i) + after;
  return all;
}

const Maker kMakers[] = {
    {"limit_instructions", &ResourceCounts::instructions,
     [](std::uint32_t n) { return repeat("MOV result.color, 0;\n", n); }},
    {"limit_alu_instructions", &ResourceCounts::aluInstructions,
     [](std::uint32_t n) { return repeat("MOV result.color, 0;\n", n); }},
    {"limit_tex_instructions", &ResourceCounts::texInstructions,
     [](std::uint32_t n) { return repeat("KIL fragment.color;\n", n); }},
    {"limit_tex_indirections", &ResourceCounts::texIndirections,
     [](std::uint32_t n) { return "TEMP a;\n" + repeat("MOV a, 0; KIL a;\n", n - 1); }},
    {"limit_temporaries", &ResourceCounts::temporaries,
     [](std::uint32_t n) { return numbered("TEMP t", n, ";\n"); }},
    {"limit_parameters", &ResourceCounts::parameters,
     [](std::uint32_t n) { return numbered("KIL ", n, ";\n"); }},
    {"limit_attribs", &ResourceCounts::attribs,
     [](std::uint32_t n) { return numbered("KIL fragment.texcoord[", n, "];\n"); }},
};

TEST(Limits, AtTheLimitLoadsAndOneMoreFailsWhereItGoesOver) {
  for (const Maker &maker : kMakers) {
    CompileOptions options = generous();
    options.limits.api.*maker.resource = 6;
    for (std::uint32_t n : {5u, 6u})
      EXPECT_TRUE(check(wrap(maker.make(n)), options).ok()) << maker.id << " " << n;
    const std::string text = wrap(maker.make(7));
    const CheckResult over = check(text, options);
    EXPECT_EQ(firstError(over), maker.id);
    EXPECT_EQ(over.diagnostics.size(), 1u) << maker.id;
    // The seventh unit is in the last statement.
    EXPECT_GT(over.errorPosition(), std::int32_t(text.rfind('\n', text.find("\nEND") - 2)));
    options.policy = LimitPolicy::Report;
    const CheckResult reported = check(text, options);
    EXPECT_TRUE(reported.ok()) << maker.id;
    EXPECT_EQ(reported.counts.*maker.resource, 7u);
    ASSERT_EQ(reported.diagnostics.size(), 1u) << maker.id;
    EXPECT_EQ(reported.diagnostics[0].severity, Severity::Warning);
    EXPECT_STREQ(reported.diagnostics[0].id, maker.id);
    EXPECT_EQ(reported.errorPosition(), -1);
  }
}

TEST(Limits, AFogOptionTakesItsShare) {
  const struct {
    const char *option;
    std::uint32_t instructions;
  } modes[] = {{"ARB_fog_exp", 3}, {"ARB_fog_exp2", 4}, {"ARB_fog_linear", 2}};
  for (const auto &mode : modes)
    for (const Maker &maker : kMakers) {
      CompileOptions options = generous();
      options.limits.api.*maker.resource = 8;
      std::uint32_t debit = mode.instructions;
      if (maker.resource == &ResourceCounts::temporaries ||
          maker.resource == &ResourceCounts::attribs)
        debit = 1;
      else if (maker.resource == &ResourceCounts::parameters)
        debit = 2;
      else if (maker.resource == &ResourceCounts::texInstructions ||
               maker.resource == &ResourceCounts::texIndirections)
        debit = 0;
      const std::string option = "OPTION " + std::string(mode.option) + ";\n";
      const CheckResult fits = check(wrap(option + maker.make(8 - debit)), options);
      EXPECT_TRUE(fits.ok()) << mode.option << " " << maker.id;
      // The program's own counts do not include what fog needs.
      EXPECT_EQ(fits.counts.*maker.resource, 8 - debit);
      if (debit != 0 || maker.resource != &ResourceCounts::attribs) {
        EXPECT_EQ(firstError(check(wrap(option + maker.make(9 - debit)), options)), maker.id)
            << mode.option;
      }
    }
}

TEST(Limits, BeyondWhatCanBeNumberedNoPolicyHelps) {
  CompileOptions options = generous();
  options.policy = LimitPolicy::Report;
  std::string names = "TEMP t";
  for (int i = 0; i < 70000; ++i)
    names += ",t" + std::to_string(i);
  EXPECT_EQ(firstError(check(wrap(names + ";"), options)), "limit_temporaries");
  const CheckResult constants = check(wrap(numbered("KIL ", 70000, ";")), options);
  EXPECT_FALSE(constants.ok());
  bool found = false;
  for (const Diagnostic &diagnostic : constants.diagnostics)
    found |= diagnostic.severity == Severity::Error &&
             std::string_view(diagnostic.id) == "limit_parameters";
  EXPECT_TRUE(found);
}

TEST(Limits, ReportLoadsArraysOverTheParameterLimit) {
  const std::string text = wrap("PARAM p[33] = { program.env[0..31], 5 };\nKIL p[32];");
  EXPECT_EQ(firstError(check(text)), "array_size");
  const CheckResult reported = check(text, small(LimitPolicy::Report));
  ASSERT_TRUE(reported.ok());
  EXPECT_EQ(reported.counts.parameters, 33u);
  ASSERT_EQ(reported.diagnostics.size(), 2u);
  EXPECT_STREQ(reported.diagnostics[0].id, "array_size");
  EXPECT_STREQ(reported.diagnostics[1].id, "limit_parameters");
}

TEST(Limits, IndirectionsThatTheProfileDoesNotRefuseLoadAndAreNotNative) {
  CompileOptions options = generous();
  options.limits.api.texIndirections = options.limits.native.texIndirections = 2;
  const std::string text = wrap("TEMP t;\nTEX t, fragment.texcoord[0], texture[0], 2D;\n"
                                "TEX t, t, texture[0], 2D;\nTEX t, t, texture[0], 2D;");
  EXPECT_EQ(firstError(check(text, options)), "limit_tex_indirections");
  options.limits.refuseIndirections = 0;
  const CheckResult loaded = check(text, options);
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded.counts.texIndirections, 3u);
  EXPECT_FALSE(loaded.underNativeLimits);
  ASSERT_EQ(loaded.diagnostics.size(), 1u);
  EXPECT_EQ(loaded.diagnostics[0].severity, Severity::Warning);
  EXPECT_EQ(loaded.diagnostics[0].message,
            "the limit is 2 texture indirections, and this program needs 3: it loads, but not "
            "natively");
  options.limits.native.texIndirections = 3;
  options.limits.card = "A card (a)";
  EXPECT_EQ(check(text, options).diagnostics[0].message,
            "A card (a) runs 2 texture indirections, and this program needs 3: it loads; what the "
            "card makes of it fits");
  const CheckResult wrong = check(text + "!", options);
  EXPECT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.diagnostics[0].message,
            "A card (a) runs 2 texture indirections, and this program needs at least 3");
}

TEST(Limits, AreSaidWithTheCardAndWithWhetherTheProgramLoads) {
  CompileOptions options = generous();
  options.limits.api.aluInstructions = 2;
  options.limits.card = "A card (a)";
  const std::string text = wrap(repeat("MOV result.color, 0;\n", 4));
  EXPECT_EQ(check(text, options).diagnostics.at(0).message,
            "more than 2 ALU instructions, the limit of A card (a)");
  options.policy = LimitPolicy::Report;
  EXPECT_EQ(check(text, options).diagnostics.at(0).message,
            "A card (a) has 2 ALU instructions, and this program needs 4: it loads, as limits are "
            "only reported");
}

TEST(Limits, AZeroLimitWithAFogOptionDoesNotWrapAround) {
  CompileOptions options = generous();
  options.limits.api.temporaries = 0;
  EXPECT_EQ(firstError(check(wrap("OPTION ARB_fog_exp;\nTEMP a;"), options)), "limit_temporaries");
}

} // namespace
} // namespace arbiter::fp
