// Tests the small parts: keywords, numerals, suffixes, suggestions, symbols.
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include "fp_compiler/front/symbols.h"
#include "fp_compiler/front/words/keywords.h"
#include "fp_compiler/front/words/numeral.h"
#include "fp_compiler/front/words/suffix.h"
#include "util/suggest.h"

namespace arbiter::fp {
namespace {

const ArbLanguage &kFragment = arbLanguage(ir::Language::ArbFragment);
const ArbLanguage &kVertex = arbLanguage(ir::Language::ArbVertex);

// The list of reserved keywords in ARB_vertex_program 2.14.2.
constexpr std::string_view kVertexReserved[] = {
    "ABS", "ADD", "ADDRESS", "ALIAS",  "ARL",    "ATTRIB",  "DP3",    "DP4",   "DPH",   "DST",
    "END", "EX2", "EXP",     "FLR",    "FRC",    "LG2",     "LIT",    "LOG",   "MAD",   "MAX",
    "MIN", "MOV", "MUL",     "OPTION", "OUTPUT", "PARAM",   "POW",    "RCP",   "RSQ",   "SGE",
    "SLT", "SUB", "SWZ",     "TEMP",   "XPD",    "program", "result", "state", "vertex"};

// The list of reserved keywords in ARB_fragment_program 3.11.2.
constexpr std::string_view kReserved[] = {
    "ABS",      "ABS_SAT", "ADD",     "ADD_SAT", "ALIAS",   "ATTRIB",  "CMP",     "CMP_SAT",
    "COS",      "COS_SAT", "DP3",     "DP3_SAT", "DP4",     "DP4_SAT", "DPH",     "DPH_SAT",
    "DST",      "DST_SAT", "END",     "EX2",     "EX2_SAT", "FLR",     "FLR_SAT", "FRC",
    "FRC_SAT",  "KIL",     "LG2",     "LG2_SAT", "LIT",     "LIT_SAT", "LRP",     "LRP_SAT",
    "MAD",      "MAD_SAT", "MAX",     "MAX_SAT", "MIN",     "MIN_SAT", "MOV",     "MOV_SAT",
    "MUL",      "MUL_SAT", "OPTION",  "OUTPUT",  "PARAM",   "POW",     "POW_SAT", "RCP",
    "RCP_SAT",  "RSQ",     "RSQ_SAT", "SIN",     "SIN_SAT", "SCS",     "SCS_SAT", "SGE",
    "SGE_SAT",  "SLT",     "SLT_SAT", "SUB",     "SUB_SAT", "SWZ",     "SWZ_SAT", "TEMP",
    "TEX",      "TEX_SAT", "TXB",     "TXB_SAT", "TXP",     "TXP_SAT", "XPD",     "XPD_SAT",
    "fragment", "program", "result",  "state",   "texture"};

TEST(Keywords, AreTheSpecificationsList) {
  for (std::string_view word : kReserved)
    EXPECT_NE(classify(word, kFragment).keyword, Keyword::None) << word;
}

TEST(Keywords, EverythingElseIsAName) {
  for (std::string_view word :
       {"KIL_SAT", "ADDRESS", "ARL",     "EXP",          "LOG",     "DDX",     "TXD",
        "vertex",  "mov",     "Mov",     "MOV_",         "MOV_sat", "END_SAT", "temp",
        "out",     "half",    "default", "gl_FragColor", "MO",      "MOVE",    ""})
    EXPECT_EQ(classify(word, kFragment).keyword, Keyword::None) << word;
}

TEST(Keywords, OfVertexPrograms) {
  for (std::string_view word : kVertexReserved)
    EXPECT_NE(classify(word, kVertex).keyword, Keyword::None) << word;
  for (std::string_view word : kReserved)
    if (std::find(std::begin(kVertexReserved), std::end(kVertexReserved), word) ==
        std::end(kVertexReserved)) {
      EXPECT_EQ(classify(word, kVertex).keyword, Keyword::None) << word;
    }
}

TEST(Keywords, OpcodesAreTold) {
  EXPECT_EQ(classify("TXP", kFragment).op, ir::Opcode::Txp);
  EXPECT_FALSE(classify("TXP", kFragment).saturate);
  EXPECT_EQ(classify("ABS_SAT", kFragment).op, ir::Opcode::Abs);
  EXPECT_TRUE(classify("ABS_SAT", kFragment).saturate);
}

TEST(Numeral, IntegersSaturate) {
  EXPECT_EQ(parseInteger("0"), 0u);
  EXPECT_EQ(parseInteger("00042"), 42u);
  EXPECT_EQ(parseInteger("2147483648"), 2147483648u);
  EXPECT_EQ(parseInteger("4294967294"), 4294967294u);
  for (std::string_view big : {"4294967295", "4294967296", "18446744073709551616",
                               "99999999999999999999999999999999999999999999999999999999999999"})
    EXPECT_EQ(parseInteger(big), std::numeric_limits<std::uint32_t>::max()) << big;
}

TEST(Numeral, FloatsAreTheNearest) {
  EXPECT_EQ(parseFloat("0.1").value, 0.1f);
  EXPECT_EQ(parseFloat(".5").value, 0.5f);
  EXPECT_EQ(parseFloat("5.").value, 5.0f);
  EXPECT_EQ(parseFloat("5.e1").value, 50.0f);
  EXPECT_EQ(parseFloat("16777217").value, 16777216.0f);
  EXPECT_EQ(parseFloat("3.4028235e38").value, std::numeric_limits<float>::max());
  EXPECT_EQ(parseFloat("1e-45").value, std::numeric_limits<float>::denorm_min());
}

TEST(Numeral, FloatsOutOfRange) {
  for (std::string_view big : {"1e999", "1e39", "0.1e400", "1E+99999999999", "10000e38",
                               "999999999999999999999999999999999999999999"}) {
    EXPECT_TRUE(parseFloat(big).overflow) << big;
    EXPECT_EQ(parseFloat(big).value, std::numeric_limits<float>::max()) << big;
  }
  for (std::string_view tiny : {"1e-999", "0.00000000000000000001e-40", "1e-99999999999",
                                "1000e-400", "0e999", "0.0e99999999999"}) {
    EXPECT_FALSE(parseFloat(tiny).overflow) << tiny;
    EXPECT_EQ(parseFloat(tiny).value, 0.0f) << tiny;
  }
}

TEST(Suffix, MasksAreTheFifteenOfEachSet) {
  int accepted = 0;
  for (std::string_view letters : {"xyzw", "rgba"})
    for (unsigned bits = 1; bits < 16; ++bits) {
      std::string word;
      for (unsigned i = 0; i < 4; ++i)
        if (bits & (1u << i))
          word += letters[i];
      std::uint8_t mask = 0;
      EXPECT_FALSE(readMask(word, true, mask)) << word;
      EXPECT_EQ(mask, bits) << word;
      ++accepted;
    }
  EXPECT_EQ(accepted, 30);
}

TEST(Suffix, OffsetsPointAtTheWrongLetter) {
  std::uint8_t mask = 0;
  EXPECT_EQ(readMask("xzy", true, mask).offset, 2u);
  EXPECT_EQ(readMask("xa", true, mask).offset, 1u);
  ir::Swizzle swizzle{};
  EXPECT_EQ(readSwizzle("xyzg", true, false, swizzle).offset, 3u);
  EXPECT_EQ(readSwizzle("xyzwx", true, false, swizzle).offset, 4u);
  EXPECT_EQ(readSwizzle("xx", true, true, swizzle).offset, 1u);
  char set = 0;
  ir::Select select{};
  EXPECT_FALSE(readSelector("x", true, set, select));
  EXPECT_FALSE(readSelector("0", true, set, select));
  EXPECT_TRUE(readSelector("r", true, set, select));
  EXPECT_TRUE(readSelector("01", true, set, select));
}

TEST(Suffix, VertexProgramsHaveNoColorLetters) {
  std::uint8_t mask = 0;
  ir::Swizzle swizzle{};
  ir::Select select{};
  char set = 0;
  EXPECT_EQ(readMask("xa", false, mask).offset, 1u);
  EXPECT_TRUE(readMask("r", false, mask));
  EXPECT_FALSE(readMask("xw", false, mask));
  EXPECT_TRUE(readSwizzle("rgba", false, false, swizzle));
  EXPECT_FALSE(readSwizzle("xyzw", false, false, swizzle));
  EXPECT_TRUE(readSelector("a", false, set, select));
}

TEST(Suggest, FindsTheNearest) {
  const std::string_view words[] = {"normal", "colour", "light"};
  EXPECT_EQ(nearest("color", words), "colour");
  EXPECT_EQ(nearest("noraml", words), "normal");
  EXPECT_EQ(nearest("LIGHT", words), "light");
  EXPECT_EQ(nearest("specular", words), "");
  EXPECT_EQ(nearest("", words), "");
  EXPECT_EQ(didYouMean("lite", {"light"}, "else"), "else");
  EXPECT_EQ(didYouMean("ligth", {"light"}), "did you mean 'light'?");
}

TEST(Symbols, UnknownNamesMayBeDeclaredLater) {
  SymbolTable table;
  EXPECT_EQ(table.find("a"), nullptr);
  EXPECT_EQ(table.declare("a", {}), nullptr);
  EXPECT_EQ(table.declare("a", {SymbolKind::Temporary, 3, {}}), nullptr);
  const Symbol *before = table.declare("a", {SymbolKind::Parameter, 4, {}});
  ASSERT_NE(before, nullptr);
  EXPECT_EQ(before->index, 3);
  EXPECT_EQ(table.suggest("A"), "did you mean 'a'?");
}

} // namespace
} // namespace arbiter::fp
