#include "apps/tools/command_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

namespace arbiter::tools {
namespace {

namespace fs = std::filesystem;

/// A temporary folder with one program.
class CommandFileTest : public testing::Test {
protected:
  CommandFileTest() {
    std::string name = (fs::temp_directory_path() / "arbiter-command-XXXXXX").string();
    m_folder = ::mkdtemp(name.data());
    std::ofstream(m_folder + "/arbiter-game") << "#!/bin/sh\n";
    fs::permissions(m_folder + "/arbiter-game", fs::perms::owner_all);
  }
  ~CommandFileTest() override { fs::remove_all(m_folder); }

  std::string m_folder;
};

TEST_F(CommandFileTest, IsLookedForInFurtherFoldersBehindPath) {
  const std::string_view further[] = {"/nowhere", m_folder};
  const CommandFile game = findCommand({"arbiter-game", "-fast"}, further);
  EXPECT_EQ(game.found, m_folder + "/arbiter-game");
  EXPECT_EQ(game.words, (std::vector<std::string>{m_folder + "/arbiter-game", "-fast"}));
  EXPECT_TRUE(game.isBeyondPath);
  EXPECT_EQ(game.problem, "");
  EXPECT_EQ(game.interpreter, std::vector<std::string>{"/bin/sh"});
  EXPECT_FALSE(findCommand({"sh"}, further).isBeyondPath);
}

TEST_F(CommandFileTest, IsMissingWhereNoFolderHasIt) {
  EXPECT_EQ(findCommand({"arbiter-game"}).problem, "arbiter-game: not found in PATH");
  const std::string_view further[] = {"/nowhere"};
  const CommandFile none = findCommand({"arbiter-game"}, further);
  EXPECT_TRUE(none.found.empty());
  EXPECT_FALSE(none.isBeyondPath);
  // A name with a slash is not searched for.
  const std::string_view here[] = {m_folder};
  EXPECT_EQ(findCommand({"./arbiter-game"}, here).problem, "./arbiter-game: no such file");
}

} // namespace
} // namespace arbiter::tools
