// Tests computations of control and of the figures in the frame that need no host.
#include "state/control/tallies.h"

#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

#include "state/control/host_pixels.h"
#include "state/core/core_context.h"
#include "state/hud/font.h"
#include "state/hud/hud_text.h"
#include "state/programs/program_edits.h"

namespace arbiter::state {
namespace {

using control::FrameTimes;
using control::Picture;
using control::Tallies;

TEST(Tallies, CountDrawsOfEachProgram) {
  Tallies tallies;
  tallies.begin(1, {{"a.vp", "b.fp"}, 10, 0, control::nowNanoseconds()});
  tallies.end(1, [](std::size_t) { return std::uint64_t(13); });
  tallies.end(1, [](std::size_t) { return std::uint64_t(99); }); // it has ended already
  tallies.begin(2, {{"", "b.fp"}, 5, 0, control::nowNanoseconds()});
  tallies.end(2, [](std::size_t) { return std::uint64_t(6); });
  tallies.begin(3, {{"", "c.fp"}, 20, 0, control::nowNanoseconds(), 7});
  tallies.end(
      3, [](std::size_t) { return std::uint64_t(25); }, 9);
  const auto all = tallies.all();
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.at("a.vp").draws, 3u);
  EXPECT_EQ(all.at("c.fp").draws, 5u);
  EXPECT_EQ(all.at("c.fp").rasterized, 2u) << "the host drew three of the five";
  EXPECT_EQ(all.at("b.fp").draws, 4u);
  tallies.clear();
  EXPECT_TRUE(tallies.all().empty());
}

TEST(FrameTimes, AreOfTheLastFrames) {
  FrameTimes times;
  EXPECT_EQ(times.mean(), 0);
  std::int64_t now = 1'000'000'000;
  times.frameEnded(now);
  EXPECT_EQ(times.count(), 0u) << "one end is no time";
  times.frameEnded(now += 50'000'000);
  for (int i = 0; i < 63; ++i)
    times.frameEnded(now += 10'000'000);
  EXPECT_DOUBLE_EQ(times.worst(), 50);
  times.frameEnded(now += 20'000'000); // the first one drops out
  EXPECT_DOUBLE_EQ(times.last(), 20);
  EXPECT_DOUBLE_EQ(times.worst(), 20);
  EXPECT_NEAR(times.mean(), (63 * 10 + 20) / 64.0, 1e-9);
}

TEST(Picture, IsMadeSmallerByMeans) {
  Picture picture = {4, 2, {}};
  for (int i = 0; i < 8; ++i)
    for (int c = 0; c < 4; ++c)
      picture.bytes.push_back(std::uint8_t(i % 4 < 2 ? 10 : 20 + i));
  const Picture same = control::reduced(picture, 4, 0);
  EXPECT_EQ(same.bytes, picture.bytes);
  const Picture half = control::reduced(picture, 2, 0);
  EXPECT_EQ(half.width, 2);
  EXPECT_EQ(half.height, 1);
  EXPECT_EQ(half.bytes[0], 10);
  EXPECT_EQ(half.bytes[4], (22 + 23 + 26 + 27 + 2) / 4);
  const Picture narrow = control::reduced({1, 9, std::vector<std::uint8_t>(36, 7)}, 3, 3);
  EXPECT_EQ(narrow.height, 3);
  EXPECT_EQ(narrow.bytes[0], 7);
}

TEST(Hud, WritesLettersBottomRowFirst) {
  const Picture picture = hud::pictureOf({"I"}, {}, 1);
  const auto ink = [&](int x, int y) {
    return picture.bytes[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4] > 128;
  };
  int rows = 0;
  for (int y = 0; y < picture.height; ++y)
    rows += ink(2 + 2, y); // the stem
  EXPECT_EQ(rows, hud::kGlyphHeight);
  EXPECT_FALSE(ink(0, 0));
  // L has its bar at the bottom.
  const Picture l = hud::pictureOf({"L"}, {}, 1);
  const auto inkOfL = [&](int x, int y) {
    return l.bytes[(std::size_t(y) * std::size_t(l.width) + std::size_t(x)) * 4] > 128;
  };
  EXPECT_TRUE(inkOfL(2 + 4, l.height - 2 - hud::kGlyphHeight));
  EXPECT_FALSE(inkOfL(2 + 4, l.height - 2 - 1));
}

TEST(Hud, DrawsABarAFrame) {
  const Picture picture = hud::pictureOf({}, {10, 1000.f / 30, 5}, 1);
  const auto heightOf = [&](int x) {
    int rows = 0;
    for (int y = 0; y < picture.height; ++y)
      rows +=
          picture.bytes[(std::size_t(y) * std::size_t(picture.width) + std::size_t(x)) * 4] > 64;
    return rows;
  };
  EXPECT_EQ(heightOf(2), 7) << "10 of 33.3 ms are three tenths of 24 rows";
  EXPECT_EQ(heightOf(4), 24) << "the worst one is as high as the graph";
  EXPECT_EQ(heightOf(6), 3);
  EXPECT_EQ(heightOf(8), 0) << "the border";
}

TEST(Hud, LettersGrowWithTheFrame) {
  EXPECT_EQ(hud::scaleOf({}, 320, 240), 1);
  EXPECT_EQ(hud::scaleOf({}, 640, 480), 2);
  EXPECT_EQ(hud::scaleOf({}, 800, 600), 2);
  EXPECT_EQ(hud::scaleOf({}, 3840, 2160), 4);
  EXPECT_EQ(hud::scaleOf({}, 320, 2160), 1) << "lines do not leave a narrow frame";
  EXPECT_EQ(hud::scaleOf({.scale = 3}, 320, 240), 3);
}

/// Returns the number of lines, and adds 100 for a graph.
int partsIn(int frameHeight, const HudOptions &options = {}) {
  const HudOptions fitted = hud::fitted(options, frameHeight);
  return int(hud::linesOf({}, fitted).size()) + (fitted.has(HudPart::Graph) ? 100 : 0);
}

TEST(Hud, LeavesSmallFramesVisible) {
  EXPECT_EQ(partsIn(480), 105);
  EXPECT_EQ(partsIn(400), 5);
  EXPECT_EQ(partsIn(300), 3);
  EXPECT_EQ(partsIn(200), 2);
  EXPECT_EQ(partsIn(1), 1);
  EXPECT_EQ(hud::linesOf({}, hud::fitted({}, 1)), std::vector<std::string>{"no frames yet"});
  for (int height = 120; height < 480; ++height) {
    const HudOptions fitted = hud::fitted({}, height);
    EXPECT_LE(hud::pictureOf(hud::linesOf({}, fitted), {}, hud::scaleOf({}, 640, height)).height,
              height / 8)
        << height;
  }
  HudOptions asked;
  asked.parts &= std::uint8_t(~(1u << unsigned(HudPart::Host)));
  EXPECT_EQ(partsIn(200, asked), 104) << "parts that were asked for stay";
  EXPECT_EQ(partsIn(200, {.scale = 1}), 105) << "and so do all where a scale was";
}

TEST(Hud, HasALetterForAllThatIsSaid) {
  hud::Figures figures;
  figures.version = hud::versionLine("r300", "ATI Radeon 9700 (R300, 2002): the API limits");
  figures.host = "llvmpipe (LLVM 15.0.6, 256 bits)";
  figures.draws = {{"host_glsl", 3}, {"rasterizer", 120}};
  figures.programs = 5;
  EXPECT_EQ(hud::linesOf(figures, {})[2], "no frames yet");
  EXPECT_EQ(hud::linesOf(figures, {})[4], "programs 5  over native 0");
  figures.times = {10, 30};
  figures.refused = 2;
  const std::vector<std::string> lines = hud::linesOf(figures, {});
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[2], "50.0 fps  20.0 ms  worst 30.0");
  EXPECT_EQ(lines[3], "host_glsl 3  rasterizer 120");
  EXPECT_EQ(lines[4], "programs 5  over native 0  refused 2");
  for (const std::string &line : lines)
    for (const char letter : line) {
      int ink = 0;
      for (int row = 0; row < hud::kGlyphHeight; ++row)
        ink |= hud::glyphRow(letter, row);
      EXPECT_TRUE(letter == ' ' || ink != 0) << letter;
    }
}

TEST(Hud, NamesTheProfileAndItsCard) {
  const std::string line =
      hud::versionLine("nv30", "NVIDIA GeForce FX (NV30, 2003): 1024 instructions");
  EXPECT_TRUE(line.starts_with("Arbiter ")) << line;
  EXPECT_TRUE(line.ends_with("  profile nv30, NVIDIA GeForce FX")) << line;
  EXPECT_TRUE(hud::versionLine("host", "The host driver's own limits").ends_with("profile host"));
}

/// The words of a line in small letters, with what they count taken out.
std::vector<std::string> wordsOf(const std::string &line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;)
    if (word.find_first_of("0123456789") == std::string::npos)
      words.push_back(word);
  return words;
}

TEST(Hud, HasItsWordsOnThePage) {
  std::ifstream page(std::string(std::getenv("ARBITER_SOURCE_ROOT")) +
                     "/docs/use/troubleshooting.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  const std::size_t table = text.find("## What the figures");
  ASSERT_NE(table, std::string::npos);
  const std::string part = text.substr(table, text.find("\n## ", table) - table);
  hud::Figures figures;
  for (int path = 0; path < kPathCount; ++path)
    figures.draws.push_back({pathName(Path(path)), 1});
  figures.times = {10, 30};
  figures.refused = 2;
  HudOptions options;
  options.parts = 1u << unsigned(HudPart::Fps) | 1u << unsigned(HudPart::Draws) |
                  1u << unsigned(HudPart::Programs);
  int count = 0;
  for (const std::string &line : hud::linesOf(figures, options))
    for (const std::string &word : wordsOf(line)) {
      ++count;
      EXPECT_NE(part.find(word), std::string::npos) << word;
    }
  EXPECT_GT(count, kPathCount + 5);
}

TEST(Hud, HasThePartsThatAreAskedFor) {
  hud::Figures figures;
  HudOptions options;
  options.parts = 1u << unsigned(HudPart::Draws);
  EXPECT_EQ(hud::linesOf(figures, options), std::vector<std::string>{"no draws"});
}

TEST(ProgramEdits, TellWhatChangedSince) {
  ProgramEdits &edits = ProgramEdits::instance();
  const std::uint64_t before = edits.generation();
  edits.setText("a.fp", "text");
  edits.setEnabled("b.fp", false);
  EXPECT_TRUE(edits.changedSince("a.fp", before));
  EXPECT_TRUE(edits.changedSince("b.fp", before));
  EXPECT_FALSE(edits.changedSince("c.fp", before));
  EXPECT_TRUE(edits.isOff("b.fp"));
  EXPECT_TRUE(edits.anyOff());
  const std::uint64_t now = edits.generation();
  EXPECT_FALSE(edits.changedSince("a.fp", now));
  edits.clear();
  EXPECT_TRUE(edits.changedSince("a.fp", now)) << "undoing is a change";
  std::string text;
  EXPECT_FALSE(edits.text("a.fp", text));
  EXPECT_FALSE(edits.anyOff());
}

TEST(ProgramEdits, HoldValues) {
  ProgramEdits &edits = ProgramEdits::instance();
  HeldValue value;
  value.index = 2;
  value.program = "a.fp";
  value.hash = hashBytes("a");
  value.value = {1, 2, 3, 4};
  edits.hold(value);
  value.value = {5, 6, 7, 8};
  edits.hold(value);
  EXPECT_EQ(edits.held(Target::Fragment, false, 2, hashBytes("a")), value.value);
  EXPECT_FALSE(edits.held(Target::Fragment, false, 2, hashBytes("b")));
  EXPECT_FALSE(edits.held(Target::Fragment, true, 2, hashBytes("a")));
  EXPECT_FALSE(edits.held(Target::Vertex, false, 2, hashBytes("a")));
  EXPECT_EQ(edits.letGo([](const HeldValue &) { return true; }), 1u);
  EXPECT_FALSE(edits.anyHeld());
}

} // namespace
} // namespace arbiter::state
