// The statistics file is written completely or not at all, is private, and does not replace another
// process's figures.
#include <GL/arbiter.h>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "state/statistics/statistics.h"
#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

std::string g_path;

std::string read(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}
bool exists(const std::string &path) { return access(path.c_str(), F_OK) == 0; }

/// The members that the page of statistics describes.
constexpr const char *kMembers[] = {
#define ARBITER_MEMBER(place, doc) place,
#include "state/statistics/members.def"
#undef ARBITER_MEMBER
};
constexpr const char *kPaths[] = {
#define ARBITER_PATH(name, word, doc) word,
#include "state/core/paths.def"
#undef ARBITER_PATH
};

/// Adds the places of a value's members: "programs[].counts".
void addPlaces(std::set<std::string> &places, const nlohmann::json &value, const std::string &at) {
  // The names in these are words, resources, commands or settings.
  static const std::set<std::string> kFree = {
      "defaults",       "programs[].counts",      "programs[].native_counts",
      "feedback.kinds", "software.given_to_host", "draws.reasons"};
  if (value.is_array())
    for (const nlohmann::json &each : value)
      addPlaces(places, each, at + "[]");
  if (!value.is_object() || value.empty() || kFree.count(at) != 0) {
    if (!value.is_array())
      places.insert(at);
    return;
  }
  for (const auto &[name, each] : value.items())
    addPlaces(places, each, at.empty() ? name : at + "." + name);
}

/// Expects that the statistics have the members of members.def, and no others.
void expectDescribed(const std::string &text) {
  std::set<std::string> places;
  addPlaces(places, nlohmann::json::parse(text), "");
  std::set<std::string> described(std::begin(kMembers), std::end(kMembers));
  for (const char *path : kPaths)
    described.insert(std::string("draws.") + path);
  for (const std::string &place : places)
    EXPECT_EQ(described.count(place), 1u) << place << " is in no row of members.def";
  // Some need a driver that is too old, a profile that refuses, or a warning.
  for (const std::string place : kMembers) {
    if (place.find("obstacle") == place.npos && place.find("refused") == place.npos &&
        place.find("warning") == place.npos && place != "draws") {
      EXPECT_EQ(places.count(place), 1u) << place << " is in no file";
    }
  }
}

TEST(Statistics, ProgramsAndDrawsAreInTheFile) {
  FakeHost host;
  {
    const CurrentContext context(host);
    use(*context, "!!ARBfp1.0\nMOV result.color, program.env[0];\nEND");
    EXPECT_TRUE(draw(*context));
    EXPECT_TRUE(draw(*context));
    load(*context, "!!ARBfp1.0\nMOV nowhere, 0;\nEND");
    handlers::CopyTexImage2D(*context, GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 16, 8, 0);
    frameEnd(&*context);
  }
  writeStatistics();
  const std::string text = read(g_path);
  const std::string schema = "\"schema\": " + std::to_string(ARBITER_STATS_SCHEMA);
  EXPECT_NE(text.find(schema), std::string::npos) << text;
  EXPECT_NE(text.find("\"host_glsl\": 2"), std::string::npos) << text;
  EXPECT_NE(text.find("\"position\": 15"), std::string::npos) << text;
  EXPECT_NE(text.find("\"pixels\": 128"), std::string::npos) << text;
  EXPECT_NE(text.find("\"frames\": 1"), std::string::npos) << text;
  expectDescribed(text);
  struct stat info {};
  ASSERT_EQ(stat(g_path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, mode_t(0600));
}

TEST(Statistics, AForkedChildWritesBesideIt) {
  writeStatistics();
  const std::string before = read(g_path);
  const pid_t child = fork();
  if (child == 0) {
    writeStatistics();
    _exit(0);
  }
  int status = 1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read(g_path), before) << "the parent's figures are gone";
  const std::string beside = g_path + "." + std::to_string(child);
  EXPECT_TRUE(exists(beside));
  unlink(beside.c_str());
}

TEST(Statistics, ASymbolicLinkIsNotFollowed) {
  const std::string victim = g_path + ".victim";
  std::ofstream(victim) << "precious";
  unlink(g_path.c_str());
  ASSERT_EQ(symlink(victim.c_str(), g_path.c_str()), 0);
  writeStatistics();
  EXPECT_EQ(read(victim), "precious");
  unlink(g_path.c_str());
  unlink(victim.c_str());
  writeStatistics();
  EXPECT_TRUE(exists(g_path));
}

} // namespace
} // namespace arbiter::state

int main(int argc, char **argv) {
  ::testing::InitGoogleTest(&argc, argv);
  char directory[] = "/tmp/arbiter-statistics-XXXXXX";
  if (!mkdtemp(directory))
    return 1;
  arbiter::state::g_path = std::string(directory) + "/stats.json";
  setenv("ARBITER_STATS", arbiter::state::g_path.c_str(), 1); // read once, by the first context
  const int result = RUN_ALL_TESTS();
  // Without the directory, writing at exit fails, which must do no harm.
  unlink(arbiter::state::g_path.c_str());
  rmdir(directory);
  return result;
}
