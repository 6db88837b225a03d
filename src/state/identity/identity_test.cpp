/// The identity shows the card's strings, and no more than host and layer can do.
#include "state/identity/identity.h"

#include <algorithm>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "state/testing/current_context.h"
#include "util/flags.h"

namespace arbiter::state {
namespace {

using testing::CurrentContext;
using testing::FakeHost;

fp::hw::Identity card() {
  fp::hw::Identity identity;
  identity.vendor.value = "ATI Technologies Inc.";
  identity.renderer.value = "RADEON 9700 Generic";
  identity.version.value = "1.3.4510 (X4.3.0-3.12.0)";
  identity.extensions.value =
      "GL_ARB_fragment_program GL_ARB_vertex_program GL_ATI_envmap_bumpmap GL_EXT_abgr";
  return identity;
}

HostCaps caps(int major = 4, int minor = 5) {
  HostCaps caps;
  caps.major = major;
  caps.minor = minor;
  caps.glslVersion = 450;
  caps.compatibility = true;
  caps.extensions = {"GL_ARB_vertex_program", "GL_EXT_abgr", "GL_KHR_no_error", "GL_NEW_and_odd",
                     "GL_ARB_multitexture"};
  return caps;
}

using Names = std::vector<std::string>;

TEST(Identity, WithoutRulesEverythingIsTheHosts) {
  const Identity identity = makeIdentity(caps(), true, {});
  EXPECT_EQ(identity.vendor + identity.renderer + identity.version + identity.shadingLanguage, "");
  const Names theirs = caps().extensions; // in the host's order, and the layer's follow
  ASSERT_GT(identity.extensions.names.size(), theirs.size());
  EXPECT_TRUE(std::equal(theirs.begin(), theirs.end(), identity.extensions.names.begin()));
}

TEST(Identity, NvidiasOptionsAreAnnouncedAsFarAsTheProfileHasThem) {
  HostCaps host = caps();
  host.bitEncoding = true;
  host.extensions.emplace_back("GL_ARB_shader_texture_lod");
  const auto announced = [&](std::uint32_t fragment, std::uint32_t vertex, std::uint32_t program,
                             bool asHost = false) {
    IdentityRules rules;
    rules.nvFragmentOptions = fragment;
    rules.nvVertexOptions = vertex;
    rules.nvVertexProgram = program;
    rules.nvAsHost = asHost;
    Names found;
    for (const std::string &name : makeIdentity(host, true, rules).extensions.names)
      if (name.starts_with("GL_NV_fragment_program") || name.starts_with("GL_NV_vertex_program"))
        found.push_back(name.substr(6));
    return found;
  };
  EXPECT_EQ(announced(0, 0, 0), Names{});
  EXPECT_EQ(announced(1, 0, 0), Names{"fragment_program_option"});
  EXPECT_EQ(announced(0, 2, 0), (Names{"vertex_program2_option", "vertex_program3"}));
  host.glslVersion = 120;
  EXPECT_EQ(announced(0, 2, 0), Names{}) << "they promise clip distances";
  host.glslVersion = 450;
  EXPECT_EQ(announced(0, 0, 1), (Names{"vertex_program", "vertex_program1_1"}))
      << "cards before the GeForce FX";
  EXPECT_EQ(announced(1, 1, 1),
            (Names{"fragment_program", "fragment_program_option", "vertex_program",
                   "vertex_program1_1", "vertex_program2", "vertex_program2_option"}));
  EXPECT_EQ(announced(2, 2, 1).size(), 8u);
  EXPECT_EQ(announced(2, 2, 1, true), Names{}) << "the host announces none";
  host.extensions.emplace_back("GL_NV_vertex_program");
  EXPECT_EQ(announced(2, 2, 1, true), Names{"vertex_program"});
  host.bitEncoding = false; // GLSL lacks them without it
  EXPECT_EQ(announced(2, 2, 1), Names{});
}

TEST(Identity, ACardsListIsCutToWhatWorks) {
  const fp::hw::Identity c = card();
  const Identity identity = makeIdentity(caps(), true, {&c});
  EXPECT_EQ(identity.vendor, "ATI Technologies Inc.");
  EXPECT_EQ(identity.version, "1.3.4510 (X4.3.0-3.12.0)");
  EXPECT_EQ(identity.major * 10 + identity.minor, 13);
  // ATI_envmap_bumpmap is dropped, as the host lacks it. The layer adds ARB_fragment_program.
  EXPECT_EQ(identity.extensions.names,
            (Names{"GL_EXT_abgr", "GL_ARB_fragment_program", "GL_ARB_vertex_program"}));
  EXPECT_EQ(identity.extensions.joined,
            "GL_EXT_abgr GL_ARB_fragment_program GL_ARB_vertex_program ");
  EXPECT_TRUE(identity.hidesShadingLanguage);
}

TEST(Identity, WhatTheLayerCannotDoIsNotAnnouncedForTheCardsSake) {
  const fp::hw::Identity c = card();
  const Names names = makeIdentity(caps(), false, {&c}).extensions.names;
  EXPECT_EQ(std::count(names.begin(), names.end(), "GL_ARB_fragment_program"), 0);
}

TEST(Identity, AVersionAboveTheHostsIsNotPromised) {
  fp::hw::Identity c = card();
  c.version.value = "4.6 from the future";
  const Identity identity = makeIdentity(caps(), true, {&c});
  EXPECT_EQ(identity.version, "");
  EXPECT_EQ(identity.major, 0);
  EXPECT_FALSE(identity.hidesShadingLanguage);
  EXPECT_EQ(identity.renderer, "RADEON 9700 Generic");
}

TEST(Identity, TheShadingLanguageIsThereWithItsExtensionOrOpenGl2) {
  fp::hw::Identity c = card();
  c.shadingLanguage.value = "1.00";
  c.extensions.value += " GL_ARB_shading_language_100";
  HostCaps host = caps();
  EXPECT_TRUE(makeIdentity(host, true, {&c}).hidesShadingLanguage); // the host lacks the extension
  host.extensions.emplace_back("GL_ARB_shading_language_100");
  EXPECT_FALSE(makeIdentity(host, true, {&c}).hidesShadingLanguage);
  EXPECT_EQ(makeIdentity(host, true, {&c}).shadingLanguage, "1.00");
  c.version.value = "2.0";
  c.shadingLanguage.value = "9.90";
  EXPECT_FALSE(makeIdentity(caps(), true, {&c}).hidesShadingLanguage);
  EXPECT_EQ(makeIdentity(caps(), true, {&c}).shadingLanguage, ""); // above the host's version
}

TEST(Extensions, LaterYearsAndUnknownOnesAreCut) {
  // The targets are not offered, so the list is the host's alone, whatever the layer learns to add.
  EXPECT_EQ(makeIdentity(caps(), false, {nullptr, 2002}).extensions.names,
            (Names{"GL_EXT_abgr", "GL_ARB_multitexture"}));
  EXPECT_EQ(makeIdentity(caps(), true, {nullptr, 1998}).extensions.names,
            (Names{"GL_EXT_abgr", "GL_ARB_multitexture"}));
  EXPECT_EQ(makeIdentity(caps(), true, {nullptr, 1992}).extensions.joined, "");
  const Names all = makeIdentity(caps(), true, {nullptr, 9999}).extensions.names;
  EXPECT_EQ(std::count(all.begin(), all.end(), "GL_NEW_and_odd"), 0);
}

// An application may keep the pointers of GetString after another context became current.
TEST(Identity, EqualOnesAreOneForTheLifeOfTheProcess) {
  const Identity *const first = &internIdentity(makeIdentity(caps(), true, {}));
  const Identity *const again = &internIdentity(makeIdentity(caps(), true, {}));
  EXPECT_EQ(first, again);
  EXPECT_NE(first, &internIdentity(makeIdentity(caps(), true, {nullptr, 2001, 0})));
  EXPECT_EQ(first->extensions.joined, makeIdentity(caps(), true, {}).extensions.joined);
}

TEST(Extensions, ACardsYearCutsToo) {
  fp::hw::Identity c = card();
  c.year.value = "2001";
  EXPECT_EQ(makeIdentity(caps(), true, {&c}).extensions.names, Names{"GL_EXT_abgr"});
}

// An off-by-one here would overrun a buffer of the program that the limit is for.
TEST(Extensions, ALengthIsKeptToTheByteAndCutsBetweenNames) {
  const std::string whole = makeIdentity(caps(), false, {nullptr, 0, 1u << 20}).extensions.joined;
  EXPECT_EQ(whole, "GL_EXT_abgr GL_ARB_multitexture GL_KHR_no_error GL_NEW_and_odd ");
  for (std::uint32_t length = 1; length <= whole.size() + 1; ++length) {
    const FilteredExtensions cut = makeIdentity(caps(), false, {nullptr, 0, length}).extensions;
    ASSERT_LE(cut.joined.size(), length);
    ASSERT_EQ(whole.rfind(cut.joined, 0), 0u) << length;
    ASSERT_TRUE(cut.joined.empty() || cut.joined.back() == ' ') << length;
    ASSERT_EQ(std::size_t(std::count(cut.joined.begin(), cut.joined.end(), ' ')), cut.names.size());
    if (cut.joined.size() < whole.size()) { // the next name would not have fitted
      ASSERT_GT(whole.find(' ', cut.joined.size()) + 1, length);
    }
  }
}

using Switches = std::vector<ExtensionSwitch>;

Identity switched(const HostCaps &host, const Switches &switches, IdentityRules rules = {}) {
  rules.switches = &switches;
  return makeIdentity(host, true, rules);
}

bool announces(const Identity &identity, const std::string &name) {
  const Names &names = identity.extensions.names;
  const bool listed = std::find(names.begin(), names.end(), name) != names.end();
  EXPECT_EQ((" " + identity.extensions.joined).find(" " + name + " ") != std::string::npos, listed);
  return listed;
}

TEST(ExtensionSwitches, HideNamesOfTheLayersAndOfTheHosts) {
  const Identity identity = switched(
      caps(), {{"GL_EXT_abgr", false}, {"GL_ARB_fragment_program", false}, {"GL_X", false}});
  EXPECT_FALSE(announces(identity, "GL_EXT_abgr"));
  EXPECT_FALSE(announces(identity, "GL_ARB_fragment_program"));
  EXPECT_TRUE(announces(identity, "GL_ARB_multitexture"));
  EXPECT_EQ(identity.absent, Names{});
}

TEST(ExtensionSwitches, AnnounceWhatARuleHides) {
  const fp::hw::Identity c = card();
  IdentityRules rules;
  rules.card = &c;
  EXPECT_FALSE(announces(makeIdentity(caps(), true, rules), "GL_KHR_no_error"));
  EXPECT_TRUE(announces(switched(caps(), {{"GL_KHR_no_error", true}}, rules), "GL_KHR_no_error"));
  HostCaps host = caps();
  host.bitEncoding = true;
  host.extensions.emplace_back("GL_ARB_shader_texture_lod");
  IdentityRules asHost;
  asHost.nvAsHost = true;
  asHost.nvVertexProgram = 1;
  EXPECT_FALSE(announces(makeIdentity(host, true, asHost), "GL_NV_vertex_program"));
  EXPECT_TRUE(
      announces(switched(host, {{"GL_NV_vertex_program", true}}, asHost), "GL_NV_vertex_program"));
}

TEST(ExtensionSwitches, WhatNobodyHasIsNotAnnouncedAndIsSaid) {
  HostCaps host = caps();
  host.extensions.emplace_back("GL_NV_gpu_program4"); // a language that the layer refuses
  const Identity identity = switched(
      host, {{"GL_NOT_there", true}, {"GL_NV_gpu_program4", true}, {"GLX_ARB_multisample", true}});
  EXPECT_EQ(identity.absent, (Names{"GL_NOT_there", "GL_NV_gpu_program4"}));
  EXPECT_FALSE(announces(identity, "GL_NOT_there"));
  EXPECT_FALSE(announces(identity, "GLX_ARB_multisample")) << "glXQueryExtensionsString's";
}

/// Returns capabilities of a host with modern extensions, with the length of its string.
HostCaps modernHost() {
  HostCaps host = caps();
  host.extensions = {"GL_EXT_abgr"};
  for (int i = 0; i < 4; ++i)
    host.extensions.push_back("GL_NEW_" + std::to_string(i) + "_of_no_known_year");
  host.extensions.insert(host.extensions.end(),
                         {"GL_ARB_vertex_program", "GL_KHR_no_error", "GL_ARB_sync"});
  for (const std::string &name : host.extensions)
    host.extensionBytes += name.size() + 1;
  return host;
}

// Engines that were patched for long strings have buffers of 8192 bytes; hosts are near that.
TEST(ExtensionString, IsNoLongerThanTheHosts) {
  const HostCaps host = modernHost();
  const FilteredExtensions seen = makeIdentity(host, true, {}).extensions;
  EXPECT_LE(seen.joined.size(), host.extensionBytes);
  EXPECT_EQ(seen.joined.find("NEW_3"), std::string::npos) << "the newest go first";
  for (const char *old : {"GL_EXT_abgr ", "GL_ARB_vertex_program ", "GL_ARB_fragment_program "})
    EXPECT_NE(seen.joined.find(old), std::string::npos) << old;
  // GetStringi has all of them, for modern programs.
  for (const std::string &name : host.extensions)
    EXPECT_EQ(std::count(seen.names.begin(), seen.names.end(), name), 1) << name;
  // A name that was switched on stays, whatever its year.
  const Switches keep = {{"GL_NEW_3_of_no_known_year", true}};
  IdentityRules rules;
  rules.switches = &keep;
  const std::string kept = makeIdentity(host, true, rules).extensions.joined;
  EXPECT_NE(kept.find("NEW_3"), std::string::npos);
  EXPECT_EQ(kept.find("NEW_2"), std::string::npos);
}

TEST(ExtensionString, KeepsWhatProgramsOfTheEraMayKnow) {
  HostCaps host = caps();
  host.extensions = {"GL_EXT_abgr", "GL_ARB_multitexture", "GL_ARB_vertex_program"};
  host.extensionBytes = 10;
  const FilteredExtensions seen = makeIdentity(host, true, {}).extensions;
  for (const std::string &name : host.extensions)
    EXPECT_NE(seen.joined.find(name + " "), std::string::npos) << name;
}

TEST(ExtensionYears, NoCardLosesWhatItsOwnDriverNamed) {
  for (const std::string_view name : fp::hw::builtinNames()) {
    const fp::hw::Identity &identity = fp::hw::findBuiltin(name)->identity;
    if (identity.year.value.empty())
      continue;
    std::istringstream names(identity.extensions.value);
    for (std::string each; names >> each;)
      EXPECT_LE(extensionYear(each).value_or(9999), std::uint32_t(std::stoi(identity.year.value)))
          << name << ": " << each;
  }
}

TEST(ExtensionYears, AreThoseOfTheSpecifications) {
  EXPECT_EQ(extensionYear("GL_ARB_fragment_program"), 2002u);
  EXPECT_EQ(extensionYear("GL_ARB_vertex_program"), 2002u);
  EXPECT_EQ(extensionYear("GL_ATI_fragment_shader"), 2001u);
  EXPECT_EQ(extensionYear("GL_ARB_multitexture"), 1998u);
  EXPECT_EQ(extensionYear("GL_KHR_no_error"), 2015u);
  EXPECT_EQ(extensionYear("GL_ARB_fragment"), std::nullopt);
  EXPECT_EQ(extensionYear(""), std::nullopt);
  const char *before = "";
  std::size_t rows = 0;
  for (const char *name : {
#define EXTENSION_YEAR(name, year) name,
#include "state/identity/extension_years.def"
#undef EXTENSION_YEAR
       }) {
    EXPECT_LT(std::string(before), name); // the search is binary
    before = name;
    ++rows;
  }
  EXPECT_GT(rows, 900u);
}

// --- Queries of an application ---

std::string string(Context &context, GLenum name) {
  const auto *const text = reinterpret_cast<const char *>(handlers::GetString(context, name));
  return text ? text : "(null)";
}

TEST(IdentityQueries, EveryWayToAskAgrees) {
  FakeHost host;
  CurrentContext context(host);
  const fp::hw::Identity c = card();
  context->identity = &internIdentity(makeIdentity(context->caps, true, {&c}));
  EXPECT_EQ(string(*context, GL_VENDOR), "ATI Technologies Inc.");
  EXPECT_EQ(string(*context, GL_RENDERER), "RADEON 9700 Generic");
  EXPECT_EQ(string(*context, GL_VERSION), "1.3.4510 (X4.3.0-3.12.0)");
  GLint count = 0, major = 0, minor = 0;
  handlers::GetIntegerv(*context, GL_NUM_EXTENSIONS, &count);
  handlers::GetIntegerv(*context, GL_MAJOR_VERSION, &major);
  handlers::GetIntegerv(*context, GL_MINOR_VERSION, &minor);
  EXPECT_EQ(major * 10 + minor, 13);
  std::string joined;
  for (GLint i = 0; i < count; ++i)
    joined +=
        reinterpret_cast<const char *>(handlers::GetStringi(*context, GL_EXTENSIONS, GLuint(i))) +
        std::string(" ");
  EXPECT_EQ(joined, string(*context, GL_EXTENSIONS));
  EXPECT_EQ(joined, "GL_ARB_fragment_program GL_ARB_vertex_program ");
  EXPECT_EQ(handlers::GetStringi(*context, GL_EXTENSIONS, GLuint(count)), nullptr);
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_VALUE));
}

TEST(IdentityQueries, TheShadingLanguageIsAnErrorWhereTheVersionHasNone) {
  FakeHost host;
  CurrentContext context(host);
  EXPECT_EQ(string(*context, GL_SHADING_LANGUAGE_VERSION), "1.30");
  const fp::hw::Identity c = card();
  context->identity = &internIdentity(makeIdentity(context->caps, true, {&c}));
  EXPECT_EQ(string(*context, GL_SHADING_LANGUAGE_VERSION), "(null)");
  EXPECT_EQ(handlers::GetError(*context), GLenum(GL_INVALID_ENUM));
}

TEST(IdentityQueries, WithoutSettingsTheHostAnswers) {
  FakeHost host;
  CurrentContext context(host);
  EXPECT_EQ(string(*context, GL_VENDOR), "Fake Inc.");
  EXPECT_EQ(string(*context, GL_RENDERER), "Fake renderer");
  EXPECT_EQ(string(*context, GL_VERSION), "3.0 Fake");
}

} // namespace
} // namespace arbiter::state
