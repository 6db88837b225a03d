#include "fp_compiler/hw/profile.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace arbiter::fp::hw {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string errorOf(std::string_view text) {
  const auto result = parseProfile(text, "p.toml");
  return result ? "" : result.error().message;
}

TEST(Profiles, TheDefaultIsARadeon9700) {
  const Profile *profile = findBuiltin(kDefaultProfile);
  ASSERT_NE(profile, nullptr);
  EXPECT_EQ(builtinNames().front(), kDefaultProfile);
  EXPECT_EQ(profile->fragment.api, (ResourceCounts{96, 64, 32, 4, 32, 32, 10}));
  EXPECT_EQ(profile->fragment.native, profile->fragment.api);
  EXPECT_EQ(profile->fragment.textureImageUnits, 16u);
  EXPECT_EQ(profile->fragment.textureCoords, 8u);
  EXPECT_FALSE(profile->fromHost);
}

// NV_vertex_program came with the GeForce3. NVIDIA's drivers also offered it on earlier chips, and
// Mesa's drivers had it too.
TEST(Profiles, CardsHaveTheVertexProgramsThatTheirDriversNamed) {
  for (const std::string_view name : builtinNames()) {
    const Profile &profile = *findBuiltin(name);
    const std::string &names = profile.identity.extensions.value;
    const bool named = names.find("GL_NV_vertex_program1_1 ") != std::string::npos;
    const bool nvidias = name.starts_with("nv") || profile.fromHost;
    EXPECT_EQ(profile.vertex.nvVertexProgram, named || nvidias ? 1u : 0u) << name;
    EXPECT_EQ(named, !names.empty() && (nvidias || name == "i915")) << name;
  }
  // An old file, from before there was a row for NV_vertex_program.
  const auto old = parseProfile("inherits = \"r300\"\n[model]\nnv_vertex_options = 1\n", "p.toml");
  ASSERT_TRUE(old) << errorOf("");
  EXPECT_EQ(old.value().vertex.nvVertexProgram, 1u);
}

TEST(Profiles, CatalystAnnouncedMoreThanTheChipHas) {
  const Profile *profile = findBuiltin("r300-catalyst-2004");
  ASSERT_NE(profile, nullptr);
  EXPECT_EQ(profile->fragment.api, (ResourceCounts{160, 128, 32, 31, 32, 32, 10}));
  EXPECT_EQ(profile->fragment.native, findBuiltin("r300")->fragment.native);
}

// No built-in profile may promise less than ARB_fragment_program's state tables require.
TEST(Profiles, EveryBuiltInMeetsTheSpecificationAndHasSources) {
  EXPECT_EQ(builtinNames().size(), 13u);
  for (const std::string_view name : builtinNames()) {
    const Profile *profile = findBuiltin(name);
    ASSERT_NE(profile, nullptr) << name;
    EXPECT_FALSE(profile->description.empty()) << name;
    for (const RowInfo &row : rows()) {
      EXPECT_GE(profile->value(row.row), row.least) << name << " " << row.glName;
      EXPECT_LE(profile->value(row.row), row.most) << name << " " << row.glName;
      EXPECT_FALSE(profile->sources[std::size_t(row.row)].empty()) << name << " " << row.glName;
    }
  }
  EXPECT_TRUE(findBuiltin("host")->fromHost);
}

TEST(Profiles, CardsHaveModelsAndTheHostAndNv40None) {
  constexpr std::pair<std::string_view, NativeModel> kModels[] = {
      {"r300", NativeModel::R300},       {"r300-catalyst-2004", NativeModel::R300},
      {"r350", NativeModel::R300},       {"r360", NativeModel::R300},
      {"r420", NativeModel::R300},       {"nv30", NativeModel::Nv30},
      {"nv35", NativeModel::Nv35},       {"i915", NativeModel::I915},
      {"host", NativeModel::Documented}, {"nv40", NativeModel::Documented},
      {"nv10", NativeModel::Documented}, {"nv20", NativeModel::Documented},
      {"nv25", NativeModel::Documented},
  };
  ASSERT_EQ(std::size(kModels), builtinNames().size());
  for (const auto &[name, model] : kModels) {
    const Profile &profile = *findBuiltin(name);
    EXPECT_EQ(profile.fragment.nativeModel, model) << name;
    EXPECT_EQ(profile.vertex.nativeModel, NativeModel::Documented) << name;
    EXPECT_EQ(profile.numerics, Numerics::Host) << name;
    EXPECT_EQ(profile.fragment.scaleRectangles, model == NativeModel::R300 ? 1u : 0u) << name;
    for (const std::string &source : profile.choiceSources)
      EXPECT_FALSE(source.empty()) << name;
  }
}

TEST(Profiles, NamesOfChoicesAreThoseOfTheirTypes) {
  ASSERT_EQ(choices().size(), std::size_t(kChoiceCount));
  for (const ChoiceInfo &info : choices()) {
    ASSERT_EQ(&info - choices().data(), std::ptrdiff_t(info.choice));
    if (info.choice == Choice::Numerics) {
      EXPECT_TRUE(std::equal(info.names.begin(), info.names.end(), kNumericsNames.begin(),
                             kNumericsNames.end()));
      EXPECT_EQ(info.names[std::size_t(Numerics::Fp24)], "fp24");
    } else {
      EXPECT_EQ(info.names[std::size_t(NativeModel::Documented)], "documented");
      EXPECT_EQ(info.names[std::size_t(NativeModel::R300)], "r300");
      EXPECT_EQ(info.names[std::size_t(NativeModel::Nv30)], "nv30");
      EXPECT_EQ(info.names[std::size_t(NativeModel::I915)], "i915");
      EXPECT_EQ(info.names[std::size_t(NativeModel::Nv35)], "nv35");
    }
  }
}

// Source: Mesa's r300_screen.c. The R400 has more instructions and temporaries than the R300, but
// no more nodes.
TEST(Profiles, R420HasLongerBlocksAndNoMoreNodes) {
  const Limits &limits = findBuiltin("r420")->fragment;
  EXPECT_EQ(limits.native, (ResourceCounts{512, 512, 512, 4, 64, 32, 10}));
  EXPECT_EQ(findBuiltin("r350")->fragment.native, findBuiltin("r300")->fragment.native);
  EXPECT_EQ(findBuiltin("nv35")->fragment.native, findBuiltin("nv30")->fragment.native);
}

TEST(Profiles, AnUnknownNameListsTheKnownOnes) {
  const auto result = loadProfile("r3000");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message,
            "no profile \"r3000\"; did you mean \"r300\"? (built in: r300, r300-catalyst-2004, "
            "r350, r360, r420, nv10, nv20, nv25, nv30, nv35, nv40, i915, host; or the path of a "
            "TOML file; arbiter profiles says which cards these are)");
  EXPECT_EQ(findBuiltin("r3000"), nullptr);
}

TEST(Profiles, ACardIsKnownByWhatPeopleCallIt) {
  for (const auto &[typed, name] : {std::pair("radeon9700", "r300"),
                                    std::pair("9700", "r300"),
                                    std::pair("Radeon 9700", "r300"),
                                    std::pair("R300", "r300"),
                                    std::pair("geforcefx", "nv30"),
                                    std::pair("GeForce-FX", "nv30"),
                                    std::pair("geforce4", "nv25"),
                                    std::pair("geforce3", "nv20"),
                                    std::pair("r300-catalyst-2004", "r300-catalyst-2004"),
                                    std::pair("gf4", "nv25"),
                                    std::pair("GF3", "nv20"),
                                    std::pair("gf4 mx", "nv10"),
                                    std::pair("r9700", "r300"),
                                    std::pair("R9800", "r350"),
                                    std::pair("fx5900", "nv35"),
                                    std::pair("gf fx 5900", "nv35"),
                                    std::pair("9800", "r350"),
                                    std::pair("gf6800", "nv40"),
                                    std::pair("ATI Radeon 9700", "r300"),
                                    std::pair("NVIDIA GeForce4 Ti", "nv25"),
                                    std::pair("Intel 915G", "i915")}) {
    const Profile *const profile = findBuiltin(typed);
    ASSERT_NE(profile, nullptr) << typed;
    EXPECT_EQ(profile->name, name);
  }
  for (const char *const none : {"", " ", "-", "|", "radeon9700|9700"})
    EXPECT_EQ(findBuiltin(none), nullptr) << none;
  for (const auto &[typed, known] :
       {std::pair("970", "9700"), std::pair("gf7", "geforce2"), std::pair("fx5200", "fx5800")}) {
    const auto near = loadProfile(typed);
    ASSERT_FALSE(near);
    const std::string start = std::string("no profile \"") + typed + "\"; did you mean \"" + known;
    EXPECT_TRUE(near.error().message.starts_with(start + "\"?")) << near.error().message;
  }
  const auto absent = loadProfile("Radeon 8500");
  ASSERT_FALSE(absent);
  EXPECT_EQ(absent.error().message,
            "no profile \"Radeon 8500\": the chip, an R200, has no ARB_fragment_program; its ATI "
            "fragment shaders have the same limits under every profile");
}

TEST(Profiles, MessagesCallACardByItsNameAndItsProfiles) {
  const Profile &r300 = *findBuiltin("r300");
  EXPECT_STREQ(r300.fragment.card, "ATI Radeon 9700 (r300)");
  EXPECT_EQ(r300.vertex.card, r300.fragment.card);
  EXPECT_STREQ(findBuiltin("r300-catalyst-2004")->fragment.card, "r300-catalyst-2004");
  EXPECT_STREQ(findBuiltin("host")->fragment.card, "host");
  const auto own = parseProfile("name = 'half'\ninherits = 'r300'\n", "p.toml");
  ASSERT_TRUE(own);
  EXPECT_STREQ(own.value().fragment.card, "ATI Radeon 9700 (half)");
  const auto described =
      parseProfile("name = 'half'\ninherits = 'r300'\ndescription = 'a test: of (it)'\n", "p.toml");
  ASSERT_TRUE(described);
  EXPECT_STREQ(described.value().vertex.card, "half");
}

TEST(Profiles, TheVertexTargetHasItsOwnNumbers) {
  const Limits &vertex = findBuiltin(kDefaultProfile)->vertex;
  EXPECT_EQ(vertex.api.instructions, 256u);
  EXPECT_EQ(vertex.api.temporaries, 32u);
  EXPECT_EQ(vertex.api.parameters, 256u);
  EXPECT_EQ(vertex.api.addressRegisters, 1u);
  EXPECT_EQ(vertex.envParameters, 256u);
  EXPECT_EQ(vertex.native, vertex.api);
  const Profile &i915 = *findBuiltin("i915");
  EXPECT_EQ(i915.vertex.native.instructions, 0u); // runs on the CPU, whatever the program
  // Limits of both targets are one row.
  for (const std::string_view name : builtinNames()) {
    const Profile &profile = *findBuiltin(name);
    EXPECT_EQ(profile.vertex.textureCoords, profile.fragment.textureCoords) << name;
    EXPECT_EQ(profile.vertex.programMatrices, profile.fragment.programMatrices) << name;
    EXPECT_EQ(profile.vertex.clipPlanes, profile.value(Row::ClipPlanes)) << name;
  }
}

// The profile has every row that existed before there were rows of vertex programs.
TEST(UserProfile, WithoutRowsOfVertexProgramsHasTheDefaultProfiles) {
  std::string text;
  std::string table;
  for (const RowInfo &row : rows()) {
    if (std::string_view(row.table).starts_with("vertex_") || row.row == Row::ClipPlanes)
      continue;
    if (table != row.table)
      text += "[" + (table = row.table) + "]\n";
    text += std::string(row.key) + " = " + std::to_string(row.least) + "\n";
  }
  const auto result = parseProfile(text, "p.toml");
  ASSERT_TRUE(result) << result.error().message;
  const Profile &profile = result.value();
  EXPECT_EQ(profile.vertex.api, findBuiltin("r300")->vertex.api);
  EXPECT_EQ(profile.vertex.textureCoords, 2u);
  EXPECT_EQ(profile.sources[std::size_t(Row::VertexApiInstructions)],
            "as r300, for the file does not say");
}

TEST(UserProfile, InheritsAndOverrides) {
  const auto result = parseProfile("name = 'small'\ninherits = 'r300'\n[api]\ntemporaries = 16\n"
                                   "attribs = { value = 11, source = 'me' }\n",
                                   "p.toml");
  ASSERT_TRUE(result) << result.error().message;
  const Profile &profile = result.value();
  EXPECT_EQ(profile.name, "small");
  EXPECT_EQ(profile.fragment.api.temporaries, 16u);
  EXPECT_EQ(profile.sources[std::size_t(Row::ApiTemporaries)], "p.toml:4");
  EXPECT_EQ(profile.sources[std::size_t(Row::ApiAttribs)], "me");
  EXPECT_EQ(profile.fragment.native.temporaries, 32u);
  const auto vertex = parseProfile("inherits = 'nv30'\n[vertex_api]\nparameters = 96\n", "v.toml");
  ASSERT_TRUE(vertex) << vertex.error().message;
  EXPECT_EQ(vertex.value().vertex.api.parameters, 96u);
  EXPECT_EQ(vertex.value().vertex.api.addressRegisters, 2u);
  EXPECT_THAT(errorOf("inherits = 'r300'\n[vertex_api]\nalu_instructions = 3\n"),
              StartsWith("p.toml:3:1: unknown row \"vertex_api.alu_instructions\""));
}

TEST(UserProfile, ANamelessOneIsCalledByItsPath) {
  const auto result = parseProfile("inherits = 'r300'\n", "p.toml");
  ASSERT_TRUE(result);
  EXPECT_EQ(result.value().name, "p.toml");
}

TEST(UserProfile, ErrorsHaveFileLineAndColumn) {
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\n  temporarys = 3\n"),
              StartsWith("p.toml:3:3: unknown row \"api.temporarys\"; did you mean"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\ntemporaries = -1\n"),
              StartsWith("p.toml:3:15: api.temporaries = -1 is out of range: 0 to 4096"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[state]\ntexture_image_units = 33\n"),
              HasSubstr("out of range: 0 to 32"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\ntemporaries = '3'\n"),
              StartsWith("p.toml:3:15: api.temporaries must be a whole number"));
  EXPECT_THAT(errorOf("inherits = 'r30'\n"),
              StartsWith("p.toml:1:12: no profile \"r30\"; did you"));
  EXPECT_THAT(errorOf("inherit = 'r300'\n"),
              StartsWith("p.toml:1:1: unknown key \"inherit\"; did you mean \"inherits\"?"));
  EXPECT_THAT(errorOf("name = 'x'\n"), HasSubstr("no row api.instructions, and nothing inherited"));
  EXPECT_THAT(errorOf("a = [1\n"), StartsWith("p.toml:"));
  EXPECT_THAT(errorOf("inherits = 3\n"), HasSubstr("no profile"));
  EXPECT_THAT(errorOf("inherits = 'r300'\napi = 3\n"), HasSubstr("api must be a table"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\nattribs = {source = 'x'}\n"),
              HasSubstr("api.attribs has no value"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\nattribs = {value = 1, source = 2}\n"),
              HasSubstr("source must be a string"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\nattribs = {value = 1, why = 'x'}\n"),
              HasSubstr("unknown key \"why\""));
}

TEST(Profiles, EachCardSaysWhoItIsWithSources) {
  for (const std::string_view name : builtinNames()) {
    const Identity &identity = findBuiltin(name)->identity;
    EXPECT_EQ(identity.empty(),
              name == "host" || name == "r350" || name == "r360" || name == "nv40")
        << name;
    for (const IdentityKey &row : identityKeys()) {
      const Identity::Text &text = identity.*row.member;
      EXPECT_EQ(text.value.empty(), text.source.empty()) << name << " " << row.key;
    }
    EXPECT_EQ(identity.extensions.value.find("  "), std::string::npos) << name;
    EXPECT_EQ(identity.extensions.value.find('\n'), std::string::npos) << name;
  }
  EXPECT_EQ(findBuiltin("r300")->identity.vendor.value, "ATI Technologies Inc.");
  EXPECT_EQ(findBuiltin("nv30")->identity.vendor.value, "NVIDIA Corporation");
}

TEST(UserProfile, HasAnIdentityOfItsOwnOrTheInheritedOne) {
  const auto result =
      parseProfile("inherits = 'r300'\n[identity]\n"
                   "renderer = 'RADEON 9700 PRO x86/SSE2'\n"
                   "year = { value = 2002, source = 'me' }\n"
                   "extensions = '''\n  GL_EXT_abgr, GL_EXT_bgra,\n GL_ARB_a  '''\n",
                   "p.toml");
  ASSERT_TRUE(result) << result.error().message;
  const Identity &identity = result.value().identity;
  EXPECT_EQ(identity.vendor.value, "ATI Technologies Inc.");
  EXPECT_EQ(identity.renderer.value, "RADEON 9700 PRO x86/SSE2");
  EXPECT_EQ(identity.renderer.source, "p.toml:3");
  EXPECT_EQ(identity.extensions.value, "GL_EXT_abgr GL_EXT_bgra GL_ARB_a");
  EXPECT_EQ(identity.year.value, "2002");
  EXPECT_EQ(identity.year.source, "me");
  const std::string head = "inherits = 'r300'\n[identity]\n";
  EXPECT_THAT(errorOf(head + "vender = 'x'\n"),
              StartsWith("p.toml:3:1: unknown row \"identity.vender\"; did you mean \"vendor\"?"));
  EXPECT_THAT(errorOf(head + "version = 'OpenGL 1.3'\n"), HasSubstr("must begin with N.M"));
  EXPECT_THAT(errorOf(head + "version = ''\n"), HasSubstr("must begin with N.M"));
  EXPECT_THAT(errorOf(head + "vendor = 3\n"), HasSubstr("identity.vendor must be a string"));
  EXPECT_THAT(errorOf(head + "vendor = \"a\\u001b[2J\"\n"), HasSubstr("must be plain ASCII"));
  EXPECT_THAT(errorOf(head + "year = '2002'\n"), HasSubstr("must be a year"));
  EXPECT_THAT(errorOf(head + "year = 1900\n"), HasSubstr("must be a year"));
  EXPECT_THAT(errorOf(head + "extensions = 'WGL_ARB_pbuffer'\n"),
              HasSubstr("no name of an extension: \"WGL_ARB_pbuffer\""));
  EXPECT_THAT(errorOf("inherits = 'r300'\nidentity = 3\n"), HasSubstr("identity must be a table"));
}

TEST(UserProfile, HasAModelOfItsOwnOrTheInheritedOneOrNone) {
  const auto own = parseProfile("inherits = 'r300'\n[model]\nscale_rectangles = 0\n"
                                "numerics = { value = 'fp24', source = 'me' }\n",
                                "p.toml");
  ASSERT_TRUE(own) << own.error().message;
  EXPECT_EQ(own.value().fragment.nativeModel, NativeModel::R300);
  EXPECT_EQ(own.value().fragment.scaleRectangles, 0u);
  EXPECT_EQ(own.value().numerics, Numerics::Fp24);
  EXPECT_EQ(own.value().choiceSources[std::size_t(Choice::Numerics)], "me");
  const auto none = parseProfile("inherits = 'r300'\n[model]\nfragment = 'documented'\n", "p.toml");
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_EQ(none.value().fragment.nativeModel, NativeModel::Documented);
  EXPECT_EQ(none.value().choiceSources[std::size_t(Choice::FragmentModel)], "p.toml:3");
  std::string whole;
  std::string table;
  for (const RowInfo &row : rows()) {
    if (row.table == kModelTable)
      continue;
    if (table != row.table)
      whole += "[" + (table = row.table) + "]\n";
    whole += std::string(row.key) + " = " + std::to_string(row.least) + "\n";
  }
  const auto unsaid = parseProfile(whole, "p.toml");
  ASSERT_TRUE(unsaid) << unsaid.error().message;
  EXPECT_EQ(unsaid.value().fragment.nativeModel, NativeModel::Documented);
  EXPECT_EQ(unsaid.value().choiceSources[std::size_t(Choice::FragmentModel)],
            "the file does not say");

  const std::string head = "inherits = 'r300'\n[model]\n";
  EXPECT_THAT(errorOf(head + "  fragment = 'r30'\n"),
              StartsWith("p.toml:3:14: model.fragment cannot be \"r30\"; did you mean \"r300\"? "
                         "(one of documented, r300, nv30, i915, nv35)"));
  EXPECT_THAT(errorOf(head + "numerics = 3\n"),
              StartsWith("p.toml:3:12: model.numerics must be a string"));
  EXPECT_THAT(errorOf(head + "numeric = 'host'\n"),
              StartsWith("p.toml:3:1: unknown row \"model.numeric\"; did you mean \"numerics\"?"));
  EXPECT_THAT(errorOf(head + "numerics = { source = 'x' }\n"),
              HasSubstr("model.numerics has no value"));
  EXPECT_THAT(errorOf(head + "scale_rectangles = 2\n"), HasSubstr("out of range: 0 to 1"));
  EXPECT_THAT(errorOf("inherits = 'r300'\nmodel = 'r300'\n"), HasSubstr("model must be a table"));
  EXPECT_THAT(errorOf("inherits = 'r300'\n[api]\nfragment = 'r300'\n"),
              HasSubstr("unknown row \"api.fragment\""));
}

TEST(UserProfile, CanGiveUpAnInheritedIdentity) {
  const auto result = parseProfile("inherits = 'r300'\nidentity = false\n", "p.toml");
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_TRUE(result.value().identity.empty());
  EXPECT_TRUE(result.value().identity.extensions.value.empty());
  EXPECT_THAT(errorOf("inherits = 'r300'\nidentity = true\n"),
              StartsWith("p.toml:2:12: identity must be a table"));
}

TEST(UserProfile, HostileTextIsAnErrorNotACrash) {
  EXPECT_NE(errorOf(std::string(5000, '[')), "");
  EXPECT_NE(errorOf(std::string("a = \xff\xfe")), "");
  EXPECT_NE(errorOf("a = 99999999999999999999"), "");
  std::string nested = "a = ";
  nested += std::string(100000, '[');
  EXPECT_NE(errorOf(nested), "");
}

// toml++ 3.3 has assertions that damaged text can fail. Each must become an error.
TEST(UserProfile, AnyDamageIsAnErrorWithThePath) {
  const std::string good = "name = 'a'\ninherits = \"r300\" # why\n[api]\n"
                           "temporaries = { value = 16, source = 'me' }\nattribs = 0xA\n";
  ASSERT_EQ(errorOf(good), "");
  int refused = 0;
  const auto expectClean = [&](const std::string &text) {
    const std::string error = errorOf(text);
    refused += error.empty() ? 0 : 1;
    EXPECT_TRUE(error.empty() || error.rfind("p.toml:", 0) == 0) << error << "\n" << text;
  };
  for (std::size_t at = 0; at < good.size(); ++at) {
    expectClean(good.substr(0, at));
    expectClean(good.substr(at));
    for (const char c : std::string_view("[]{}\"'=.,\n\0\xff#\\", 14)) {
      expectClean(std::string(good).replace(at, 1, 1, c));
      expectClean(std::string(good).insert(at, 2, c));
    }
  }
  EXPECT_GT(refused, 1000);
}

TEST(UserProfile, FilesAreReadWholeOrRefused) {
  char pattern[] = "/tmp/arbiter-profile-XXXXXX";
  ASSERT_NE(::mkdtemp(pattern), nullptr);
  const std::filesystem::path folder = pattern;
  std::ofstream(folder / "good.toml") << "inherits = 'nv30'\n";
  std::ofstream(folder / "big.toml") << std::string(300 << 10, '\n');
  EXPECT_TRUE(loadProfile((folder / "good.toml").string()));
  const auto big = loadProfile((folder / "big.toml").string());
  ASSERT_FALSE(big);
  EXPECT_THAT(big.error().message, HasSubstr("big.toml: "));
  EXPECT_FALSE(loadProfile(folder.string()));
  EXPECT_FALSE(loadProfile((folder / "none.toml").string()));
  std::filesystem::remove_all(folder);
}

} // namespace
} // namespace arbiter::fp::hw
