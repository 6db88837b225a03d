#include <gmock/gmock.h>

#include "util/defaults/entry.h"

namespace arbiter::defaults {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> errorsOf(std::string_view text) {
  return parseFile(text, "d/f.toml").errors;
}

const std::string *valueOf(const Entry &entry, Env variable) {
  for (const Value &value : entry.values)
    if (value.variable == variable)
      return &value.text;
  return nullptr;
}

TEST(ReadDefaults, AnEntryWithAllThatThereIs) {
  const File file = parseFile(R"([[program]]
title = "A game"
source = ["https://a.example/1", "https://a.example/2"]
note = "copies into 4096 bytes"
[program.match]
name = ["game.x86", "game-*"]
path = "*/game/*"
windows = "Game.exe"
xxh128 = "00112233445566778899AABBCCDDEEFF"
[program.set]
profile = "nv30"
limits = "report"
identity = "profile"
extensions_max_year = 2001
extensions_max_length = 4095
extensions = "GL_EXT_abgr=off"
numerics = "legacy"
backend = "host"
fixed_function = "always"
attributes = "alias"
threads = "2"
)",
                              "d/f.toml");
  ASSERT_THAT(file.errors, IsEmpty());
  ASSERT_EQ(file.entries.size(), 1u);
  const Entry &entry = file.entries[0];
  EXPECT_EQ(entry.title, "A game");
  EXPECT_EQ(entry.line, 1u);
  EXPECT_THAT(entry.match.names, ElementsAre("game.x86", "game-*"));
  EXPECT_THAT(entry.match.hashes, ElementsAre("00112233445566778899aabbccddeeff"));
  EXPECT_THAT(entry.sources, ElementsAre("https://a.example/1", "https://a.example/2"));
  EXPECT_EQ(entry.values.size(), keys().size()) << "a key that this file does not try";
  EXPECT_EQ(*valueOf(entry, Env::ExtensionsMaxLength), "4095");
  EXPECT_EQ(*valueOf(entry, Env::Threads), "2");
}

TEST(ReadDefaults, DefaultUndoesAndAPathBeginsAtTheFile) {
  const File file = parseFile("[[program]]\ntitle='t'\nmatch.name='n'\n"
                              "set = { profile = 'mine.toml', numerics = 'default' }\n",
                              "/d/f.toml");
  ASSERT_THAT(file.errors, IsEmpty());
  EXPECT_EQ(*valueOf(file.entries[0], Env::Profile), "/d/mine.toml");
  EXPECT_EQ(*valueOf(file.entries[0], Env::Numerics), "");
}

TEST(ReadDefaults, ABadValueIsLeftOutWithItsPlaceAndTheRestHolds) {
  const File file = parseFile("[[program]]\ntitle='t'\nmatch.name='n'\n[program.set]\n"
                              "extensions_max_year = 20\nnumerics = 'fp24'\n",
                              "d/f.toml");
  EXPECT_THAT(file.errors,
              ElementsAre("d/f.toml:5:23: extensions_max_year: expected a whole number "
                          "from 1992 to 9999, not \"20\""));
  ASSERT_EQ(file.entries.size(), 1u);
  EXPECT_EQ(*valueOf(file.entries[0], Env::Numerics), "fp24");
}

TEST(ReadDefaults, ABadEntryIsLeftOutAndTheNextOneHolds) {
  const File file = parseFile("[[program]]\ntitle='a'\nmatch.nam='n'\nset.threads=1\n"
                              "[[program]]\ntitle='b'\nmatch.name='n'\nset.threads=1\n",
                              "d/f.toml");
  EXPECT_THAT(file.errors,
              ElementsAre("d/f.toml:3:7: unknown key \"nam\" in match; did you mean name?"));
  ASSERT_EQ(file.entries.size(), 1u);
  EXPECT_EQ(file.entries[0].title, "b");
}

TEST(ReadDefaults, WhatIsNoTomlHasALine) {
  EXPECT_THAT(errorsOf("a = 1\n[[program]\n"), ElementsAre(HasSubstr("d/f.toml:2:")));
  EXPECT_THAT(errorsOf("\n\n[[["), ElementsAre(HasSubstr("d/f.toml:3")));
  EXPECT_THAT(errorsOf("\n\"\\x\" = 1"), ElementsAre(HasSubstr("d/f.toml:2")));
  EXPECT_THAT(errorsOf("\xff\xfe\n"), ElementsAre(HasSubstr("d/f.toml:1")));
}

TEST(ReadDefaults, EachMistakeIsSaid) {
  const std::string head = "[[program]]\ntitle='t'\n", match = "match.name='n'\n",
                    set = "set.threads=1\n";
  EXPECT_THAT(errorsOf("programs = 1"), ElementsAre(HasSubstr("did you mean program?")));
  EXPECT_THAT(errorsOf("program = 1"), ElementsAre(HasSubstr("list of tables")));
  EXPECT_THAT(errorsOf("[[program]]\n" + match + set), ElementsAre(HasSubstr("without a title")));
  EXPECT_THAT(errorsOf(head + set), ElementsAre(HasSubstr("no match")));
  EXPECT_THAT(errorsOf(head + match), ElementsAre(HasSubstr("no set")));
  EXPECT_THAT(errorsOf(head + "match={}\n" + set), ElementsAre(HasSubstr("must be a table")));
  EXPECT_THAT(errorsOf(head + "match.name=[]\n" + set), ElementsAre(HasSubstr("empty list")));
  EXPECT_THAT(errorsOf(head + "match.name=1\n" + set), ElementsAre(HasSubstr("must be a string")));
  EXPECT_THAT(errorsOf(head + "match.name='a/b'\n" + set), ElementsAre(HasSubstr("its folder")));
  EXPECT_THAT(errorsOf(head + "match.xxh128='12'\n" + set), ElementsAre(HasSubstr("32 hex")));
  EXPECT_THAT(errorsOf(head + match + "set=1\n"), ElementsAre(HasSubstr("set must be a table")));
  EXPECT_THAT(errorsOf(head + match + "set.stats='f'\n"), ElementsAre(HasSubstr("unknown key")));
  EXPECT_THAT(errorsOf(head + match + "set.threads=true\n"),
              ElementsAre(HasSubstr("whole number")));
  EXPECT_THAT(errorsOf(head + match + "set.threads=''\n"), ElementsAre(HasSubstr("is empty")));
  EXPECT_THAT(errorsOf(head + match + set + "sauce='a'\n"), ElementsAre(HasSubstr("did you mean")));
}

} // namespace
} // namespace arbiter::defaults
