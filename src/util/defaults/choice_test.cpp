#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <sys/stat.h>
#include <unistd.h>

#include "util/defaults/choice.h"
#include "util/defaults/folders.h"

namespace arbiter::defaults {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class DefaultsFolder : public testing::Test {
protected:
  void SetUp() override {
    char name[] = "/tmp/arbiter-defaults-XXXXXX";
    ASSERT_NE(::mkdtemp(name), nullptr);
    root = fs::canonical(name);
  }
  void TearDown() override { fs::remove_all(root); }

  std::string put(const std::string &name, const std::string &text) {
    const fs::path path = root / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path) << text;
    return path;
  }
  std::function<const char *(const char *)> environment() {
    return [this](const char *name) {
      const auto at = variables.find(name);
      return at == variables.end() ? nullptr : at->second.c_str();
    };
  }
  Program program(const std::string &executable, std::vector<std::string> words) {
    return programOf({executable, std::move(words), environment()});
  }

  fs::path root;
  std::map<std::string, std::string> variables;
};

std::string entry(const std::string &title, const std::string &match, const std::string &set) {
  return "[[program]]\ntitle='" + title + "'\nmatch={" + match + "}\nset={" + set + "}\n";
}

TEST(Patterns, StarAndQuestionMark) {
  EXPECT_TRUE(matches("quake3*", "quake3.x86"));
  EXPECT_TRUE(matches("*a*b", "xaybab"));
  EXPECT_TRUE(matches("?", "a"));
  EXPECT_TRUE(matches("", ""));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_FALSE(matches("a", "A"));
  EXPECT_TRUE(matches("a", "A", true));
  EXPECT_FALSE(matches("quake3", "quake3.x86"));
  EXPECT_FALSE(matches("*b", "abc"));
  EXPECT_FALSE(matches("[ab]", "a")) << "brackets stand for themselves";
}

TEST_F(DefaultsFolder, LaterFoldersAndFilesWinKeyByKey) {
  put("a/10.toml", entry("first", "name='game'", "threads=1, limits='report', numerics='fp24'"));
  put("a/20.toml", entry("second", "name='game'", "threads=2"));
  put("b/00.toml", entry("third", "name='ga*'", "numerics='default'") +
                       entry("other", "name='other'", "threads=9"));
  put("b/.hidden.toml", entry("hidden", "name='game'", "threads=7"));
  put("b/notes.txt", "not TOML [[[");
  const Choice choice =
      choose(program("/x/game", {"game"}),
             readFolders({{root / "a"}, {root / "none"}, {root / "b"}}), environment());
  ASSERT_THAT(choice.entries, SizeIs(3));
  EXPECT_EQ(choice.entries[2].why, "name game");
  EXPECT_EQ(choice.find(Env::Threads)->value->text, "2");
  EXPECT_EQ(choice.find(Env::Threads)->place(), std::string(root / "a/20.toml") + ":4");
  EXPECT_EQ(choice.find(Env::Limits)->value->text, "report");
  EXPECT_EQ(choice.find(Env::Numerics)->value->text, "");
  EXPECT_EQ(choice.find(Env::Profile), nullptr);
}

TEST_F(DefaultsFolder, TheEnvironmentWinsEvenByNothing) {
  variables = {{"ARBITER_THREADS", "5"}, {"ARBITER_NUMERICS", ""}};
  put("a/1.toml", entry("t", "name='game'", "threads=1, numerics='fp24', limits='report'"));
  const Choice choice = choose(program("/x/game", {}), readFolders({{root / "a"}}), environment());
  EXPECT_FALSE(choice.find(Env::Threads)->used);
  EXPECT_FALSE(choice.find(Env::Numerics)->used);
  EXPECT_TRUE(choice.find(Env::Limits)->used);
}

TEST_F(DefaultsFolder, EachConditionMustHold) {
  const std::string file = put("games/q/game", "");
  const auto applies = [&](const std::string &match) {
    return !choose(program(file, {file}), {parseFile(entry("t", match, "threads=1"), "f")},
                   environment())
                .entries.empty();
  };
  EXPECT_TRUE(applies("name='game', path='*/q/*'"));
  EXPECT_FALSE(applies("name='game', path='*/r/*'"));
  EXPECT_FALSE(applies("name='game', windows='*'"));
  // The first is the published hash of no bytes. The second differs in the last digit.
  EXPECT_TRUE(applies("xxh128='99aa06d3014798d86001c324468d497f'"));
  EXPECT_FALSE(applies("xxh128='99aa06d3014798d86001c324468d4970'"));
}

TEST_F(DefaultsFolder, WindowsProgramsUnderWine) {
  const std::string exe = put("drive/Games/Quake/QUAKE.EXE", "MZ");
  fs::create_directories(root / "prefix/dosdevices");
  fs::create_directory_symlink(root / "drive", root / "prefix/dosdevices/c:");
  variables["WINEPREFIX"] = root / "prefix";
  // The words as they are before Wine sets the name, and after.
  for (const auto &[executable, words] :
       {std::pair{"/usr/bin/wine64", std::vector<std::string>{"wine64", exe, "-window"}},
        {"/usr/lib/wine/wine64-preloader", {"C:\\games\\quake\\quake.exe", "other.exe"}},
        {"/usr/lib/wine/wine-preloader", {"c:/games/quake/QUAKE.exe"}},
        {"/usr/bin/box64", {"box64", "/usr/bin/wine64", exe}}}) {
    const Program found = program(executable, words);
    EXPECT_EQ(fs::path(found.windowsPath), fs::path(exe)) << executable;
    EXPECT_FALSE(choose(found, {parseFile(entry("t", "windows='quake.exe'", "threads=1"), "f")},
                        environment())
                     .entries.empty());
    EXPECT_FALSE(
        choose(found, {parseFile(entry("t", "path='*/Quake/*'", "threads=1"), "f")}, environment())
            .entries.empty());
  }
  EXPECT_EQ(program("/usr/bin/vi", {"vi", exe}).windows, "") << "no loader, but an editor";
  EXPECT_EQ(program("/usr/lib/wine/wine64", {"D:\\none.exe"}).windowsPath, "");
  EXPECT_EQ(program("/usr/lib/wine/wine64", {"D:\\none.exe"}).windows, "none.exe");
  const std::string maps = put("maps", "140000000-140001000 r--p 00000000 fe:00 11010924    " +
                                           exe + "\n7f0-7f1 rw-p\n");
  EXPECT_EQ(programOf({"/usr/lib/wine/wine64", {"quake.exe"}, environment(), maps}).windowsPath,
            exe);
  EXPECT_EQ(programOf({"/usr/lib/wine/wine64", {"q.exe"}, environment(), maps}).windowsPath, "");
}

TEST_F(DefaultsFolder, TheFileThatALoaderWasGivenIsTheProgram) {
  const std::string file = put("bin/game", "");
  EXPECT_EQ(program("/lib/ld-linux-x86-64.so.2",
                    {"ld-linux-x86-64.so.2", "--library-path", "/lib", file, "a"})
                .name,
            "game");
  EXPECT_EQ(program("/usr/bin/winery", {"winery", "a.exe"}).windows, "");
  EXPECT_TRUE(isLoader("wine"));
  EXPECT_TRUE(isLoader("wine64-preloader"));
  EXPECT_FALSE(isLoader("winery"));
  EXPECT_FALSE(isLoader("boxes"));
}

TEST_F(DefaultsFolder, WhichFolders) {
  const auto paths = [&] {
    std::vector<std::string> found;
    for (const Folder &each : folders("/s", environment()))
      found.push_back(each.path + (each.users ? " (user)" : ""));
    return found;
  };
  EXPECT_THAT(paths(), ElementsAre("/s", "/etc/arbiter/defaults.d"));
  variables["HOME"] = "/h";
  EXPECT_THAT(paths(),
              ElementsAre("/s", "/etc/arbiter/defaults.d", "/h/.config/arbiter/defaults.d (user)"));
  variables["XDG_CONFIG_HOME"] = "/x";
  EXPECT_THAT(paths(),
              ElementsAre("/s", "/etc/arbiter/defaults.d", "/x/arbiter/defaults.d (user)"));
  variables["ARBITER_DEFAULTS"] = "0";
  EXPECT_THAT(paths(), IsEmpty());
  variables["ARBITER_DEFAULTS"] = "/a::/b";
  EXPECT_THAT(paths(), ElementsAre("/a", "/b"));
}

TEST_F(DefaultsFolder, FilesThatCannotBeFollowed) {
  fs::create_directories(root / "a/folder.toml");
  ASSERT_EQ(::mkfifo((root / "a/pipe.toml").c_str(), 0600), 0);
  put("a/long.toml", std::string(kMaxFileBytes + 1, '#'));
  put("a/z.toml", entry("good", "name='game'", "threads=1"));
  std::vector<std::string> errors;
  std::size_t entries = 0;
  for (const File &file : readFolders({{root / "a"}})) {
    errors.insert(errors.end(), file.errors.begin(), file.errors.end());
    entries += file.entries.size();
  }
  EXPECT_THAT(errors, ElementsAre(HasSubstr("folder.toml: "), HasSubstr("long.toml: longer"),
                                  HasSubstr("pipe.toml: not a regular file")));
  EXPECT_EQ(entries, 1u) << "the rest does not hold";
}

TEST_F(DefaultsFolder, AnothersFileInTheUsersFolder) {
  const std::string file = put("a/1.toml", entry("t", "name='game'", "threads=1"));
  if (::chown(file.c_str(), 65533, 65533) != 0)
    GTEST_SKIP() << "needs root: only root gives files away";
  EXPECT_THAT(readFolders({{root / "a", true}})[0].errors, ElementsAre(HasSubstr("another user")));
  EXPECT_THAT(readFolders({{root / "a", true}})[0].entries, IsEmpty());
  EXPECT_THAT(readFolders({{root / "a", false}})[0].entries, SizeIs(1));
}

} // namespace
} // namespace arbiter::defaults
