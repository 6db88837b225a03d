// Tests names and their places, as an editor uses them.
#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/inspect.h"

namespace arbiter::fp {
namespace {

using ir::Language;
using testing_support::small;

/// Returns "kind of access:text@offset" of every place, in text order.
std::string places(Language language, const std::string &text) {
  const Inspection found = inspectProgram(language, text, small());
  std::string all;
  for (const NameUse &use : found.names.uses()) {
    const Name &name = found.names.names()[use.name];
    EXPECT_EQ(text.substr(use.span.begin, use.span.end - use.span.begin), name.text);
    all += "DRW"[int(use.access)];
    all += std::string(name.text) + " ";
  }
  return all;
}

TEST(Names, OfAFragmentProgram) {
  EXPECT_EQ(places(Language::ArbFragment,
                   "!!ARBfp1.0\nTEMP a, b;\nPARAM c[] = { {1}, {2} };\nATTRIB t = "
                   "fragment.texcoord[0];\nOUTPUT o = result.color;\nALIAS z = a;\n"
                   "MAD a.x, t.x, c[1], -b.y;\nMOV o, z;\nEND"),
            "Da Db Dc Dt Do Dz Ra Wa Rt Rc Rb Wo Rz ");
}

TEST(Names, OfAVertexProgram) {
  EXPECT_EQ(places(Language::ArbVertex,
                   "!!ARBvp1.0\nADDRESS A0;\nPARAM m[4] = { state.matrix.mvp };\n"
                   "ARL A0.x, vertex.attrib[1].x;\nMOV result.position, m[A0.x + 1];\nEND"),
            "DA0 Dm WA0 Rm RA0 ");
}

TEST(Names, OfAnAtiShader) {
  EXPECT_EQ(places(Language::AtiFragment,
                   "!!ATIfs1.0\nStartConstants;\nCONSTANT c1 = {0.5};\nEndConstants;\n"
                   "StartOutputPass;\nSampleMap r1, t0.str;\nMUL r0, r1, c1;\nEndPass;\n"),
            "Dc1 Wr1 Wr0 Rr1 Rc1 ");
}

TEST(Names, OfStatementsThatAreNotWhole) {
  EXPECT_EQ(places(Language::ArbFragment,
                   "!!ARBfp1.0\nTEMP a, b;\nMOV a, ;\nMAD a, b b, b;\nMUL a.x, a.b, b"),
            "Da Db Wa Wa Rb Rb Rb Wa Ra Rb ");
}

TEST(Names, WithoutAHeader) {
  for (const char *header : {"", "!!ARBfp", "!!ARBvp1.0 x"})
    EXPECT_EQ(places(Language::ArbFragment, std::string(header) + "\nTEMP a;\nMOV a, a;\nEND\n"),
              "Da Wa Ra ")
        << header;
  const std::string text = "TEMP a;\nMOV b, a;\nEND\n";
  const Inspection found = inspectProgram(Language::ArbFragment, text, small());
  ASSERT_EQ(found.check.diagnostics.size(), 2u);
  EXPECT_STREQ(found.check.diagnostics[0].id, "header_missing");
  EXPECT_STREQ(found.check.diagnostics[1].id, "undeclared_name");
  // The plain check still reports only what the API should.
  EXPECT_EQ(checkProgram(Language::ArbFragment, text, small()).diagnostics.size(), 1u);
}

TEST(Names, AreFoundByPlace) {
  const std::string text = "!!ARBfp1.0\nTEMP ab;\nMOV ab, 1;\nEND\n";
  const Inspection found = inspectProgram(Language::ArbFragment, text, small());
  const auto at = std::uint32_t(text.find("MOV ab") + 4);
  for (std::uint32_t offset = at; offset <= at + 2; ++offset) {
    ASSERT_NE(found.names.at(offset), nullptr);
    EXPECT_EQ(found.names.at(offset)->access, Access::Write);
  }
  EXPECT_EQ(found.names.at(at - 1), nullptr);
  EXPECT_EQ(found.names.at(at + 3), nullptr);
  EXPECT_EQ(found.names.at(0), nullptr);
  EXPECT_EQ(found.names.find("nothing"), nullptr);
}

TEST(Names, AskingChangesNoVerdict) {
  for (const char *text :
       {"!!ARBfp1.0\nTEMP a;\nMOV a, 1;\nMOV result.color, a;\nEND\n", "!!ARBfp1.0\nMOV x, y;\nEND",
        "!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n",
        "!!ATIfs1.0\nStartOutputPass;\nMOV r0, c0;\nEndPass;\n"}) {
    const Language language = *languageOfText(text);
    const CheckResult plain = checkProgram(language, text, small());
    const Inspection asked = inspectProgram(language, text, small());
    EXPECT_EQ(plain.ok(), asked.check.ok());
    EXPECT_EQ(plain.errorString(text), asked.check.errorString(text));
    EXPECT_EQ(plain.counts, asked.check.counts);
  }
}

} // namespace
} // namespace arbiter::fp
