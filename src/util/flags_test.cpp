#include "util/flags.h"

#include <gtest/gtest.h>
#include <map>

namespace arbiter {
namespace {

struct Parsed {
  Settings settings;
  std::vector<std::string> warnings;
};

Parsed parse(const std::map<std::string, std::string> &environment) {
  Parsed parsed;
  parsed.settings = parseSettings(
      [&](const char *name) -> const char * {
        const auto found = environment.find(name);
        return found == environment.end() ? nullptr : found->second.c_str();
      },
      parsed.warnings);
  return parsed;
}

TEST(Settings, DefaultsAreWhatTheTableSays) {
  const Parsed parsed = parse({});
  EXPECT_TRUE(parsed.warnings.empty());
  EXPECT_EQ(parsed.settings.profile, info(Env::Profile).fallback);
  EXPECT_STREQ(info(Env::Limits).fallback, "enforce");
  EXPECT_TRUE(parsed.settings.enforceLimits);
  EXPECT_STREQ(info(Env::Log).fallback, "warn");
  EXPECT_EQ(parsed.settings.logLevel, LogLevel::Warn);
  EXPECT_EQ(parsed.settings.debug, 0u);
  EXPECT_EQ(parsed.settings.statsPath, "");
}

TEST(Settings, EmptyValuesAreDefaults) {
  std::map<std::string, std::string> environment;
  for (const EnvInfo &row : environmentTable())
    environment[row.name] = "";
  const Parsed parsed = parse(environment);
  EXPECT_TRUE(parsed.warnings.empty());
  EXPECT_EQ(parsed.settings.profile, "r300");
}

TEST(Settings, ReadsEveryVariable) {
  const Parsed parsed = parse({{"ARBITER_PROFILE", "nv30"},
                               {"ARBITER_LIMITS", "report"},
                               {"ARBITER_STATS", "/tmp/s-%p.json"},
                               {"ARBITER_CAPTURE", "/tmp/capture"},
                               {"ARBITER_REPLACE", "/tmp/edited"},
                               {"ARBITER_LOG", "debug:/tmp/log"},
                               {"ARBITER_DEBUG", "glsl,,text"},
                               {"ARBITER_HOST_VENDOR", "mesa"},
                               {"ARBITER_HOST_OSMESA", "/opt/libOSMesa.so.8"}});
  EXPECT_TRUE(parsed.warnings.empty());
  EXPECT_EQ(parsed.settings.profile, "nv30");
  EXPECT_FALSE(parsed.settings.enforceLimits);
  EXPECT_EQ(parsed.settings.statsPath, "/tmp/s-%p.json");
  EXPECT_EQ(parsed.settings.capturePath, "/tmp/capture");
  EXPECT_EQ(parsed.settings.replacePath, "/tmp/edited");
  EXPECT_EQ(parsed.settings.logLevel, LogLevel::Debug);
  EXPECT_EQ(parsed.settings.logPath, "/tmp/log");
  EXPECT_TRUE(parsed.settings.has(DebugFlag::Glsl));
  EXPECT_TRUE(parsed.settings.has(DebugFlag::Text));
  EXPECT_FALSE(parsed.settings.has(DebugFlag::Help));
  EXPECT_EQ(parsed.settings.hostVendor, "mesa");
  EXPECT_EQ(parsed.settings.hostOsmesa, "/opt/libOSMesa.so.8");
}

TEST(Settings, LogTakesALevelAPathOrBoth) {
  EXPECT_EQ(parse({{"ARBITER_LOG", "off"}}).settings.logLevel, LogLevel::Off);
  const Parsed path = parse({{"ARBITER_LOG", "./a:b"}});
  EXPECT_EQ(path.settings.logLevel, LogLevel::Info);
  EXPECT_EQ(path.settings.logPath, "./a:b");
  for (const char *bad : {"verbose", "debug:", "4", "DEBUG"}) {
    const Parsed parsed = parse({{"ARBITER_LOG", bad}});
    EXPECT_EQ(parsed.warnings.size(), 1u) << bad;
    EXPECT_EQ(parsed.settings.logLevel, LogLevel::Warn) << bad;
    EXPECT_EQ(parsed.settings.logPath, "") << bad;
  }
}

TEST(Settings, AnUnknownFlagNamesTheNearestAndKeepsTheOthers) {
  const Parsed parsed = parse({{"ARBITER_DEBUG", "text,glssl"}});
  ASSERT_EQ(parsed.warnings.size(), 1u);
  EXPECT_EQ(parsed.warnings[0], "ARBITER_DEBUG: no flag \"glssl\" (did you mean glsl?); ignored");
  EXPECT_TRUE(parsed.settings.has(DebugFlag::Text));
}

TEST(Settings, HostileValuesGiveOneWarningAndAreIgnored) {
  const std::string huge(kMaxEnvBytes + 1, 'a');
  for (const EnvInfo &row : environmentTable()) {
    for (const std::string &bad : {huge, std::string("r300\x1b[2J"), std::string("/tmp/a\nb")}) {
      const Parsed parsed = parse({{row.name, bad}});
      ASSERT_EQ(parsed.warnings.size(), 1u) << row.name;
      EXPECT_EQ(parsed.warnings[0].rfind(row.name, 0), 0u);
      EXPECT_LT(parsed.warnings[0].size(), 200u);
      EXPECT_EQ(parsed.settings.profile, "r300");
      EXPECT_EQ(parsed.settings.logPath, "");
      EXPECT_EQ(parsed.settings.statsPath, "");
      EXPECT_EQ(parsed.settings.hostVendor, "");
      EXPECT_EQ(parsed.settings.hostOsmesa, "");
      EXPECT_TRUE(parsed.settings.enforceLimits);
    }
  }
}

TEST(Settings, TheIdentityIsTheHostsOrTheProfiles) {
  EXPECT_FALSE(parse({}).settings.identityOfProfile);
  EXPECT_FALSE(parse({{"ARBITER_IDENTITY", "host"}}).settings.identityOfProfile);
  EXPECT_TRUE(parse({{"ARBITER_IDENTITY", "profile"}}).settings.identityOfProfile);
  const Parsed bad = parse({{"ARBITER_IDENTITY", "r300"}});
  EXPECT_FALSE(bad.settings.identityOfProfile);
  ASSERT_EQ(bad.warnings.size(), 1u);
  EXPECT_EQ(bad.warnings[0], "ARBITER_IDENTITY: expected host or profile, not \"r300\"; ignored");
}

TEST(Settings, ExtensionsAreNamesThatAreOnOrOff) {
  const Parsed good =
      parse({{"ARBITER_EXTENSIONS", "GL_NV_fence=on,,GL_EXT_abgr=off,GLX_EXT_swap_control=off,"
                                    "GL_NV_fence=off"}});
  EXPECT_TRUE(good.warnings.empty());
  EXPECT_EQ(good.settings.extensions,
            (std::vector<ExtensionSwitch>{
                {"GL_EXT_abgr", false}, {"GLX_EXT_swap_control", false}, {"GL_NV_fence", false}}));
  for (const char *bad : {"GL_NV_fence", "NV_fence=on", "GL_A=on,GL_NV fence=off", "=on", "off",
                          "GL_A=on=off", "EGL_KHR_image=on"}) {
    const Parsed parsed = parse({{"ARBITER_EXTENSIONS", bad}});
    ASSERT_EQ(parsed.warnings.size(), 1u) << bad;
    EXPECT_EQ(parsed.warnings[0].rfind("ARBITER_EXTENSIONS: expected GL_NAME=on", 0), 0u)
        << parsed.warnings[0];
    EXPECT_TRUE(parsed.settings.extensions.empty()) << bad;
  }
}

TEST(Settings, FixedFunctionIsAlwaysOrPrograms) {
  EXPECT_TRUE(parse({}).settings.alwaysFixedFunction);
  EXPECT_FALSE(parse({{"ARBITER_FIXED_FUNCTION", "programs"}}).settings.alwaysFixedFunction);
  EXPECT_TRUE(parse({{"ARBITER_FIXED_FUNCTION", "always"}}).settings.alwaysFixedFunction);
  const auto bad = parse({{"ARBITER_FIXED_FUNCTION", "never"}});
  EXPECT_TRUE(bad.settings.alwaysFixedFunction);
  EXPECT_EQ(bad.warnings.size(), 1u);
}

TEST(Settings, AttributesAliasOrAreApart) {
  EXPECT_EQ(parse({}).settings.attributes, Attributes::OfProfile);
  EXPECT_EQ(parse({{"ARBITER_ATTRIBUTES", "alias"}}).settings.attributes, Attributes::Alias);
  EXPECT_EQ(parse({{"ARBITER_ATTRIBUTES", "apart"}}).settings.attributes, Attributes::Apart);
  const auto bad = parse({{"ARBITER_ATTRIBUTES", "both"}});
  EXPECT_EQ(bad.settings.attributes, Attributes::OfProfile);
  EXPECT_EQ(bad.warnings.size(), 1u);
}

TEST(Settings, TheProcessorIsThisOneOrOfAFamily) {
  EXPECT_EQ(parse({}).settings.cpu, "");
  for (const char *const family : {"avx512", "avx2", "sse4.1"})
    EXPECT_EQ(parse({{"ARBITER_CPU", family}}).settings.cpu, family);
  const auto bad = parse({{"ARBITER_CPU", "haswell"}});
  EXPECT_EQ(bad.settings.cpu, "");
  EXPECT_EQ(bad.warnings.size(), 1u);
}

TEST(Settings, NumericsAreOneOfThreeOrTheProfiles) {
  EXPECT_EQ(parse({}).settings.numerics, "");
  for (const char *const mode : {"host", "legacy", "fp24"}) {
    EXPECT_EQ(parse({{"ARBITER_NUMERICS", mode}}).settings.numerics, mode);
    EXPECT_TRUE(parse({{"ARBITER_NUMERICS", mode}}).warnings.empty());
  }
  const Parsed bad = parse({{"ARBITER_NUMERICS", "fp32"}});
  EXPECT_EQ(bad.settings.numerics, "");
  ASSERT_EQ(bad.warnings.size(), 1u);
  EXPECT_EQ(bad.warnings[0],
            "ARBITER_NUMERICS: expected host, legacy, fp24 or fx9, not \"fp32\"; ignored");
}

TEST(Settings, NumbersAreWholeAndInRange) {
  const Parsed good =
      parse({{"ARBITER_EXTENSIONS_MAX_YEAR", "2003"}, {"ARBITER_EXTENSIONS_MAX_LENGTH", "4095"}});
  EXPECT_TRUE(good.warnings.empty());
  EXPECT_EQ(good.settings.extensionsMaxYear, 2003u);
  EXPECT_EQ(good.settings.extensionsMaxLength, 4095u);
  for (const char *bad : {"-1", "2003x", "x", "0x7d3", "1991", "10000", "4294969299", "+2003",
                          " 2003", "2003.0", "99999999999999999999999999"}) {
    const Parsed parsed = parse({{"ARBITER_EXTENSIONS_MAX_YEAR", bad}});
    EXPECT_EQ(parsed.settings.extensionsMaxYear, 0u) << bad;
    ASSERT_EQ(parsed.warnings.size(), 1u) << bad;
    EXPECT_EQ(parsed.warnings[0].rfind("ARBITER_EXTENSIONS_MAX_YEAR: expected a whole number from "
                                       "1992 to 9999, not \"",
                                       0),
              0u)
        << parsed.warnings[0];
  }
  for (const char *bad : {"0", "-4096", "1048577", "4k", "4294967297"})
    EXPECT_EQ(parse({{"ARBITER_EXTENSIONS_MAX_LENGTH", bad}}).warnings.size(), 1u) << bad;
}

TEST(Settings, TheCacheIsOnUnlessItIsTurnedOff) {
  EXPECT_TRUE(parse({}).settings.cache);
  EXPECT_EQ(std::to_string(parse({}).settings.cacheMaxMegabytes), info(Env::CacheMaxMb).fallback);
  EXPECT_FALSE(parse({{"ARBITER_CACHE", "0"}}).settings.cache);
  EXPECT_TRUE(parse({{"ARBITER_CACHE", "1"}}).settings.cache);
  EXPECT_EQ(parse({{"ARBITER_CACHE_MAX_MB", "5"}}).settings.cacheMaxMegabytes, 5u);
  for (const char *bad : {"no", "2", "-0"}) {
    EXPECT_TRUE(parse({{"ARBITER_CACHE", bad}}).settings.cache) << bad;
    EXPECT_EQ(parse({{"ARBITER_CACHE", bad}}).warnings.size(), 1u) << bad;
  }
  for (const char *bad : {"0", "65537", "-5", "lots", "99999999999999999999"}) {
    EXPECT_EQ(parse({{"ARBITER_CACHE_MAX_MB", bad}}).settings.cacheMaxMegabytes, 64u) << bad;
    EXPECT_EQ(parse({{"ARBITER_CACHE_MAX_MB", bad}}).warnings.size(), 1u) << bad;
  }
}

TEST(Settings, TheHostVendorIsAPlainNameAndNotOurselves) {
  for (const char *bad : {"../evil", "a/b", "me sa", "arbiter"}) {
    const Parsed parsed = parse({{"ARBITER_HOST_VENDOR", bad}});
    EXPECT_EQ(parsed.warnings.size(), 1u) << bad;
    EXPECT_EQ(parsed.settings.hostVendor, "") << bad;
  }
}

TEST(Settings, HelpListsEveryRow) {
  const std::string help = flagsHelp();
  for (const EnvInfo &row : environmentTable())
    EXPECT_NE(help.find(row.name), std::string::npos) << row.name;
  for (const DebugFlagInfo &row : debugFlagTable())
    EXPECT_NE(help.find(std::string("  ") + row.name + " "), std::string::npos) << row.name;
}

} // namespace
} // namespace arbiter
