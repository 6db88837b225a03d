/// The cache on disk: stored values are found, and any damage to the files is no more than a miss.
#include "util/cache/cache_store.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace arbiter {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
protected:
  void SetUp() override {
    char pattern[] = "/tmp/arbiter-cache-XXXXXX";
    ASSERT_NE(::mkdtemp(pattern), nullptr);
    m_top = pattern;
    m_folder = m_top + "/deep/er/arbiter";
  }
  void TearDown() override {
    fs::permissions(m_top, fs::perms::owner_all);
    fs::remove_all(m_top);
  }
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto &entry : fs::recursive_directory_iterator(m_folder))
      if (entry.is_regular_file() && entry.path() != m_folder + "/key")
        found.push_back(entry.path());
    return found;
  }
  static std::string bytesOf(const fs::path &path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
  }
  /// Makes the file accessible to its owner only, so that the test judges its content.
  static void write(const fs::path &path, const std::string &bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  }

  std::string m_top, m_folder;
};
constexpr std::uint64_t kMegabyte = 1u << 20;

TEST_F(Cache, FindsWhatWasStoredByAnyStoreOfTheFolder) {
  const CacheStore store(m_folder, kMegabyte * 16);
  ASSERT_TRUE(store.usable());
  EXPECT_EQ(store.find("key"), std::nullopt);
  EXPECT_TRUE(store.store("key", std::string("va\0lue", 6)));
  EXPECT_TRUE(store.store("", ""));
  EXPECT_EQ(CacheStore(m_folder, kMegabyte).find("key"), std::string("va\0lue", 6));
  EXPECT_EQ(store.find(""), "");
  EXPECT_EQ(store.find("kez"), std::nullopt);
  EXPECT_TRUE(store.store("key", "new"));
  EXPECT_EQ(store.find("key"), "new");
  EXPECT_EQ(cacheUsage(m_folder).files, 2u);
  EXPECT_EQ(clearCache(m_folder).files, 0u);
  EXPECT_EQ(store.find("key"), std::nullopt);
  EXPECT_TRUE(store.store("key", "again")); // the subfolder is created again
}

TEST_F(Cache, FilesAndFoldersAreTheOwnersOnly) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  ASSERT_EQ(files().size(), 1u);
  EXPECT_EQ(fs::status(files()[0]).permissions(), fs::perms(0600));
  EXPECT_EQ(fs::status(files()[0].parent_path()).permissions(), fs::perms(0700));
  EXPECT_EQ(fs::status(m_folder).permissions(), fs::perms(0700));
  EXPECT_EQ(fs::status(m_folder + "/key").permissions(), fs::perms(0600));
  EXPECT_EQ(fs::file_size(m_folder + "/key"), 16u);
}

TEST_F(Cache, AFolderThatOthersMayReadIsTakenFromThem) {
  fs::create_directories(m_folder);
  ASSERT_EQ(::chmod(m_folder.c_str(), 0755), 0);
  EXPECT_TRUE(CacheStore(m_folder, kMegabyte).usable());
  EXPECT_EQ(fs::status(m_folder).permissions(), fs::perms(0700));
}

TEST_F(Cache, AFileThatOthersMayReadOrWriteIsAMissAndGoes) {
  const CacheStore store(m_folder, kMegabyte);
  for (const unsigned mode : {0640u, 0604u, 0620u, 0602u}) {
    ASSERT_TRUE(store.store("key", "value"));
    ASSERT_EQ(store.find("key"), "value");
    ASSERT_EQ(::chmod(files().at(0).c_str(), mode), 0);
    EXPECT_EQ(store.find("key"), std::nullopt) << mode;
    EXPECT_TRUE(files().empty()) << mode;
  }
}

// The entry is complete and has the right key, but another user, machine or folder made it.
TEST_F(Cache, AnEntryThatAnotherSecretSignedIsAMiss) {
  const CacheStore store(m_folder, kMegabyte), foreign(m_top + "/foreign", kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  ASSERT_TRUE(foreign.store("key", "planted"));
  const fs::path here = files().at(0);
  const fs::path there = fs::path(m_top + "/foreign") / fs::relative(here, m_folder);
  const std::string own = bytesOf(here);
  write(here, bytesOf(there));
  EXPECT_EQ(store.find("key"), std::nullopt);
  EXPECT_FALSE(fs::exists(here));
  // With its own secret it becomes a valid entry.
  ASSERT_TRUE(store.store("key", "value"));
  write(here, bytesOf(there));
  write(m_folder + "/key", bytesOf(m_top + "/foreign/key"));
  EXPECT_EQ(CacheStore(m_folder, kMegabyte).find("key"), "planted");
}

TEST_F(Cache, ASecretThatIsNoneIsReplacedAndSignsNothing) {
  const std::string secret = m_folder + "/key";
  for (const char *const what : {"gone", "short", "long", "open", "link", "folder"}) {
    ASSERT_TRUE(CacheStore(m_folder, kMegabyte).store("key", "value"));
    const std::string before = bytesOf(secret);
    if (what == std::string("gone"))
      fs::remove(secret);
    else if (what == std::string("short"))
      write(secret, before.substr(1));
    else if (what == std::string("long"))
      write(secret, before + "x");
    else if (what == std::string("open"))
      ASSERT_EQ(::chmod(secret.c_str(), 0644), 0);
    else {
      fs::rename(secret, m_top + "/moved");
      if (what == std::string("link"))
        fs::create_symlink(m_top + "/moved", secret);
      else
        fs::create_directory(secret);
    }
    const CacheStore store(m_folder, kMegabyte);
    EXPECT_EQ(store.usable(), what != std::string("folder")) << what;
    EXPECT_EQ(store.find("key"), std::nullopt) << what;
    EXPECT_EQ(store.store("key", "new"), store.usable()) << what;
    if (!store.usable())
      continue;
    EXPECT_NE(bytesOf(secret), before) << what;
    EXPECT_EQ(CacheStore(m_folder, kMegabyte).find("key"), "new") << what;
  }
}

TEST_F(Cache, EveryTruncationAndEveryFlippedBitIsAMissAndRemovesTheFile) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("a key", "some value of a program"));
  const fs::path path = files().at(0);
  const std::string good = bytesOf(path);
  for (std::size_t length = 0; length < good.size(); ++length) {
    write(path, good.substr(0, length));
    ASSERT_EQ(store.find("a key"), std::nullopt) << length;
    ASSERT_FALSE(fs::exists(path)) << length;
  }
  for (std::size_t bit = 0; bit < good.size() * 8; ++bit) {
    std::string bad = good;
    bad[bit / 8] = char(bad[bit / 8] ^ (1 << (bit % 8)));
    write(path, bad);
    ASSERT_EQ(store.find("a key"), std::nullopt) << bit;
    ASSERT_FALSE(fs::exists(path)) << bit;
  }
  write(path, good + "x");
  EXPECT_EQ(store.find("a key"), std::nullopt);
  write(path, good);
  EXPECT_EQ(store.find("a key"), "some value of a program");
}

TEST_F(Cache, AFileOfAnotherKeyIsNotTaken) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("one", "1"));
  const fs::path path = files().at(0);
  const std::string ofOne = bytesOf(path);
  ASSERT_TRUE(store.store("two", "2"));
  for (const fs::path &file : files())
    write(file, ofOne);
  EXPECT_EQ(store.find("two"), std::nullopt);
  EXPECT_EQ(store.find("one"), "1");
  // Two entries have changed places.
  ASSERT_TRUE(store.store("two", "2"));
  const fs::path a = files().at(0), b = files().at(1);
  const std::string ofA = bytesOf(a);
  write(a, bytesOf(b));
  write(b, ofA);
  EXPECT_EQ(store.find("one"), std::nullopt);
  EXPECT_EQ(store.find("two"), std::nullopt);
}

TEST_F(Cache, StaysWithinItsSizeAndKeepsWhatWasUsedLast) {
  const std::uint64_t limit = 64 * 4096;
  const CacheStore store(m_folder, limit);
  const std::string value(400, 'v');
  for (int i = 0; i < 1000; ++i)
    ASSERT_TRUE(store.store("key" + std::to_string(i), value));
  EXPECT_LE(cacheUsage(m_folder).bytes, limit);
  EXPECT_GT(cacheUsage(m_folder).bytes, limit / 2);
  EXPECT_FALSE(store.store("large", std::string(3000, 'v'))); // more than half a share
  // All files of a subfolder but one are old: that one outlives the rest.
  clearCache(m_folder);
  ASSERT_TRUE(store.store("kept", value));
  const fs::path kept = files().at(0);
  for (int i = 0; i < 600; ++i) {
    ASSERT_TRUE(store.store("x" + std::to_string(i), value));
    for (const auto &entry : fs::directory_iterator(kept.parent_path()))
      if (entry.path() != kept)
        fs::last_write_time(entry.path(),
                            fs::file_time_type::clock::now() - std::chrono::hours(1 + i % 7));
  }
  EXPECT_EQ(store.find("kept"), value);
}

TEST_F(Cache, AHitMakesAnEntryYoung) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  const auto old = fs::file_time_type::clock::now() - std::chrono::hours(24);
  fs::last_write_time(files().at(0), old);
  EXPECT_EQ(store.find("key"), "value");
  EXPECT_GT(fs::last_write_time(files().at(0)), old + std::chrono::hours(23));
}

TEST_F(Cache, GoesWithoutWhereItCannotWrite) {
  EXPECT_FALSE(CacheStore("", kMegabyte).usable());
  EXPECT_FALSE(CacheStore("relative/path", kMegabyte).usable());
  EXPECT_FALSE(CacheStore("/proc/arbiter", kMegabyte).usable());
  EXPECT_FALSE(CacheStore("/dev/null/arbiter", kMegabyte).usable());
  write(m_top + "/file", "");
  EXPECT_FALSE(CacheStore(m_top + "/file", kMegabyte).usable());
  fs::create_directory(m_top + "/open");
  ASSERT_EQ(::chmod((m_top + "/open").c_str(), 0777), 0); // others could plant files
  EXPECT_FALSE(CacheStore(m_top + "/open", kMegabyte).usable());
  fs::create_directory_symlink("/tmp", m_top + "/link");
  EXPECT_FALSE(CacheStore(m_top + "/link", kMegabyte).usable());
  EXPECT_FALSE(CacheStore("", kMegabyte).store("key", "value"));
  EXPECT_EQ(CacheStore("", kMegabyte).find("key"), std::nullopt);
  // The folder turns read-only, or vanishes, while it is in use.
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  if (::geteuid() != 0) { // root writes anywhere
    fs::permissions(m_folder, fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_FALSE(store.store("other key of another subfolder", "value"));
    EXPECT_EQ(store.find("key"), "value");
    fs::permissions(m_folder, fs::perms::owner_all);
  }
  fs::remove_all(m_folder);
  EXPECT_FALSE(store.store("key", "value"));
  EXPECT_EQ(store.find("key"), std::nullopt);
}

TEST_F(Cache, AFullDiskLeavesNothingBehind) {
  const CacheStore store(m_folder, kMegabyte * 64);
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) { // the file size limit stands for a full disk: write() falls short
    struct rlimit limit = {2048, 2048};
    ::signal(SIGXFSZ, SIG_IGN);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const bool stored = store.store("key", std::string(8000, 'v'));
    ::_exit(stored ? 1 : 0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(cacheUsage(m_folder).files, 0u);
}

TEST_F(Cache, ALinkIsNotFollowed) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  const fs::path path = files().at(0);
  const fs::path elsewhere = m_top + "/elsewhere";
  fs::rename(path, elsewhere);
  fs::create_symlink(elsewhere, path);
  EXPECT_EQ(store.find("key"), std::nullopt);
  EXPECT_TRUE(store.store("key", "other")); // replaces the link
  EXPECT_EQ(store.find("key"), "other");
  EXPECT_NE(bytesOf(elsewhere).find("value"), std::string::npos);
}

// Writers, readers and evictions use the same keys at once. A reader sees a whole value or none.
TEST_F(Cache, ProcessesShareItWithoutATornRead) {
  const CacheStore parent(m_folder, 64 * 16384);
  std::vector<pid_t> children;
  for (int process = 0; process < 4; ++process) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      const CacheStore store(m_folder, 64 * 16384);
      int torn = 0;
      for (int i = 0; i < 500; ++i) {
        const std::string key = "key" + std::to_string(i * 7 % 40);
        const std::string value =
            key + std::string(std::size_t(i * 31 % 4000), char('a' + process));
        store.store(key, value);
        const auto seen = store.find(key);
        if (seen &&
            (seen->rfind(key, 0) != 0 ||
             seen->find_first_not_of((*seen)[seen->size() - 1], key.size()) != std::string::npos))
          ++torn;
      }
      ::_exit(torn == 0 ? 0 : 1);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  for (const fs::path &file : files())
    EXPECT_EQ(file.string().find(".tmp"), std::string::npos);
  EXPECT_LE(cacheUsage(m_folder).files, 40u);
}

TEST_F(Cache, ClearingLeavesForeignFiles) {
  const CacheStore store(m_folder, kMegabyte);
  ASSERT_TRUE(store.store("key", "value"));
  const fs::path mine = files().at(0).parent_path() / "notes.txt";
  write(mine, "mine");
  clearCache(m_folder);
  EXPECT_EQ(bytesOf(mine), "mine");
  EXPECT_EQ(store.find("key"), std::nullopt);
}

} // namespace
} // namespace arbiter
