// Records that outlive their process: they are consistent at every moment, and completed once, by
// the right process.
#include "util/record/live_record.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "util/json.h"

namespace arbiter {
namespace {

namespace fs = std::filesystem;

class Records : public ::testing::Test {
protected:
  void SetUp() override { ASSERT_NE(mkdtemp(m_folder), nullptr); }
  void TearDown() override { fs::remove_all(m_folder); }
  [[nodiscard]] std::string path(const char *name) const {
    return std::string(m_folder) + "/" + name;
  }
  static std::string read(const std::string &path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] int files() const {
    return int(std::distance(fs::directory_iterator(m_folder), fs::directory_iterator()));
  }
  /// Expects that the signal killed the child.
  static void expectDead(pid_t child, int signal) {
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
  }

private:
  char m_folder[40] = "/tmp/arbiter-record-XXXXXX";
};

/// Fills in {"n": counter 3, "reasons": {those of counters 4 and 5}, "rows": [...]}.
void fill(LiveRecord &record) {
  JsonWriter json;
  json.beginObject().key("n").raw(counterPlace(3));
  json.key("reasons").raw(nonZeroPlace({{"four", 4}, {"five", 5}}, 2)).key("rows").raw("[|]");
  const std::string text = json.endObject().take();
  const std::size_t rows = text.find('|');
  ASSERT_TRUE(record.setFrame(text.substr(0, rows), text.substr(rows + 1)));
}

TEST_F(Records, TheReportIsWhatWasWrittenLast) {
  LiveRecord *const record = LiveRecord::make(path("r"), false);
  ASSERT_NE(record, nullptr);
  fill(*record);
  ASSERT_TRUE(record->addRow("1"));
  ASSERT_TRUE(record->addRow("{}"));
  record->counters()[3] = 18446744073709551615u;
  record->counters()[5] = 7;
  EXPECT_EQ(files(), 1) << "the record";
  ASSERT_TRUE(record->finish());
  EXPECT_EQ(read(path("r")),
            "{\n  \"n\": 18446744073709551615,\n  \"reasons\": {\n    \"five\": 7\n  },\n"
            "  \"rows\": [\n    1,\n    {}\n  ]\n}\n");
  EXPECT_EQ(files(), 1) << "the report alone";
  record->counters()[5] = 0;
  ASSERT_TRUE(record->finish()) << "its own report may be replaced";
  EXPECT_NE(read(path("r")).find("\"reasons\": {}"), std::string::npos);
}

TEST_F(Records, AKilledProcessLeavesAllThatItSaid) {
  const pid_t child = fork();
  if (child == 0) {
    LiveRecord *const record = LiveRecord::make(path("r"), false);
    fill(*record);
    record->addRow("\"seen\"");
    record->counters()[4] = 12;
    raise(SIGKILL);
  }
  expectDead(child, SIGKILL);
  EXPECT_FALSE(fs::exists(path("r")));
  EXPECT_EQ(completeRecords(path("r")), 1);
  EXPECT_NE(read(path("r")).find("\"four\": 12"), std::string::npos) << read(path("r"));
  EXPECT_NE(read(path("r")).find("\"seen\""), std::string::npos);
  EXPECT_EQ(completeRecords(path("r")), 0);
  EXPECT_EQ(files(), 1);
}

TEST_F(Records, ALivingProcessIsLeftAlone) {
  LiveRecord *const record = LiveRecord::make(path("r"), false);
  ASSERT_NE(record, nullptr);
  fill(*record);
  EXPECT_EQ(completeRecords(path("r")), 0);
  EXPECT_TRUE(record->finish());
}

TEST_F(Records, PatternsTakeAnyNumber) {
  for (int i = 0; i < 2; ++i) {
    const pid_t child = fork();
    if (child == 0) {
      LiveRecord *const record =
          LiveRecord::make(path("r-") + std::to_string(getpid()) + "%.json", true);
      fill(*record);
      raise(SIGKILL);
    }
    expectDead(child, SIGKILL);
  }
  EXPECT_EQ(completeRecords(path("other-%p%%.json")), 0);
  EXPECT_EQ(completeRecords(path("r-%p%%.json")), 2);
  EXPECT_EQ(files(), 2);
}

TEST_F(Records, AnotherProcessesReportIsNotReplaced) {
  LiveRecord *const record = LiveRecord::make(path("r"), false);
  ASSERT_NE(record, nullptr);
  fill(*record);
  usleep(20000);
  std::ofstream(path("r")) << "another's";
  ASSERT_TRUE(record->finish());
  EXPECT_EQ(read(path("r")), "another's");
  EXPECT_TRUE(fs::exists(path("r") + "." + std::to_string(getpid())));
}

TEST_F(Records, AProgramThatGoesOnAsAnotherIsToldOfTwice) {
  for (const char *const name : {"plain", "named"}) {
    const bool named = std::string_view(name) == "named";
    for (int i = 1; i <= 3; ++i) { // exec() ends a program without finish()
      if (i == 3)
        // Longer than the resolution of file times, so that the first report counts as an older one
        usleep(60000);
      LiveRecord *const record = LiveRecord::make(path(name), named);
      ASSERT_NE(record, nullptr);
      fill(*record);
      record->counters()[3] = std::uint64_t(i);
      if (i == 3) {
        ASSERT_TRUE(record->finish());
      }
    }
    std::string all;
    for (const auto &entry : fs::directory_iterator(path("")))
      if (entry.path().filename().string().starts_with(name))
        all += read(entry.path());
    for (const char *const count : {"\"n\": 1", "\"n\": 2", "\"n\": 3"})
      EXPECT_NE(all.find(count), std::string::npos) << count << " in " << all;
  }
}

TEST_F(Records, AChildsIsItsOwn) {
  LiveRecord *const record = LiveRecord::make(path("r"), false);
  ASSERT_NE(record, nullptr);
  fill(*record);
  record->counters()[3] = 1;
  const pid_t child = fork();
  if (child == 0) {
    record->afterFork();
    record->counters()[3] = 2;
    _exit(record->finish() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(record->counters()[3], 1u) << "the child counts with its parent";
  EXPECT_NE(read(path("r") + "." + std::to_string(child)).find("\"n\": 2"), std::string::npos);
  ASSERT_TRUE(record->finish());
  EXPECT_NE(read(path("r")).find("\"n\": 1"), std::string::npos);
}

TEST_F(Records, ADamagedOneIsNone) {
  const std::string name = path("r") + ".999999.running";
  std::ofstream(name) << "arbiter-record1";
  EXPECT_FALSE(LiveRecord::complete(name));
  fs::resize_file(name, 3 << 20);
  EXPECT_FALSE(LiveRecord::complete(name));
  EXPECT_EQ(files(), 1);
}

TEST_F(Records, WithoutAFileTheReportIsMadeAllTheSame) {
  const pid_t child = fork();
  if (child == 0) {
    // a record exceeds this file size limit, which would raise SIGXFSZ
    const rlimit limit = {100000, 100000};
    setrlimit(RLIMIT_FSIZE, &limit);
    LiveRecord *const record = LiveRecord::make(path("r"), false);
    fill(*record);
    _exit(record->finish() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(files(), 1);
  EXPECT_NE(read(path("r")).find("\"rows\": []"), std::string::npos);
}

TEST_F(Records, WhatDoesNotFitIsSaid) {
  LiveRecord *const record = LiveRecord::make(path("r"), false);
  ASSERT_NE(record, nullptr);
  fill(*record);
  const std::string row(100000, '1');
  int taken = 0;
  while (record->addRow(row))
    ++taken;
  EXPECT_GT(taken, 20);
  EXPECT_LT(taken, 32);
  EXPECT_FALSE(record->setFrame(std::string(1 << 20, ' '), ""));
  ASSERT_TRUE(record->finish());
  EXPECT_GT(fs::file_size(path("r")), std::size_t(taken) * row.size());
}

} // namespace
} // namespace arbiter
