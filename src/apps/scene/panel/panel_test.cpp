#include "apps/scene/panel/panel.h"

#include <gmock/gmock.h>
#include <random>

#include "apps/scene/panel/complete.h"

namespace arbiter::scene {
namespace {

using fp::Severity;

constexpr const char *kTwirl = R"(!!ARBfp1.0
#@ profile r300, size 512 256, mesh quad, camera none, blend off
#@ local[0].x "magnitude" = 1 in -1..1 animate sine 5s
#@ texture 0 = landscape 512 512, linear, edge
  #@ texture 1 = twirl 512 512 radius 0.4 turn 4.5, nearest, mirror
# @ no panel, and neither is this: #@ size 1 1
END
)";

std::string at(const Panel &panel, std::string_view text, std::size_t index = 0) {
  const fp::Span span = panel.diagnostics.at(index).span;
  return std::string(text.substr(span.begin, span.end - span.begin));
}

TEST(Panel, ReadsTheDesignsExample) {
  const Panel panel = parsePanel(kTwirl);
  EXPECT_THAT(panel.diagnostics, testing::IsEmpty());
  EXPECT_TRUE(panel.written);
  EXPECT_EQ(panel.profile.text, "r300");
  EXPECT_EQ(panel.width.value, 512);
  EXPECT_EQ(panel.height.value, 256);
  ASSERT_EQ(panel.mesh.size(), 1u);
  EXPECT_EQ(panel.mesh[0].shape.value, Shape::Quad);
  ASSERT_EQ(panel.parameters.size(), 1u);
  const Parameter &magnitude = panel.parameters[0];
  EXPECT_EQ(magnitude.label.text, "magnitude");
  EXPECT_THAT(magnitude.mask, testing::ElementsAre(true, false, false, false));
  EXPECT_EQ(magnitude.low.value, -1);
  EXPECT_EQ(magnitude.high.value, 1);
  EXPECT_EQ(magnitude.animation->kind.value, AnimationKind::Sine);
  EXPECT_EQ(magnitude.animation->period.value, 5);
  ASSERT_EQ(panel.textures.size(), 2u);
  EXPECT_EQ(panel.textures[0].source.generator.value, Generator::Landscape);
  EXPECT_EQ(panel.textures[0].wrap.value, Wrap::Edge);
  EXPECT_EQ(panel.textures[1].source.argument("radius"), 0.4);
  EXPECT_EQ(panel.textures[1].filter.value, Filter::Nearest);
  EXPECT_EQ(panel.textures[1].wrap.value, Wrap::Mirror);
}

TEST(Panel, SpansAreTheNumbersBytes) {
  const std::string_view text = kTwirl;
  const Panel panel = parsePanel(text);
  const auto bytes = [&](fp::Span span) { return text.substr(span.begin, span.end - span.begin); };
  EXPECT_EQ(bytes(panel.parameters[0].values[0].span), "1");
  EXPECT_EQ(bytes(panel.parameters[0].low.span), "-1");
  EXPECT_EQ(bytes(panel.parameters[0].animation->period.span), "5") << "without its unit";
  EXPECT_EQ(bytes(panel.parameters[0].span),
            "local[0].x \"magnitude\" = 1 in -1..1 animate sine 5s");
  EXPECT_EQ(bytes(panel.textures[1].source.arguments.numbers[0].span), "0.4");
  EXPECT_EQ(bytes(panel.textures[1].filter.span), "nearest");
}

TEST(Panel, ReadsEveryKindOfLine) {
  const Panel panel = parsePanel(R"(!!ARBfp1.0
#@ title "A scene", numerics fp24, rate 25, depth lequal write off, cull back, stencil lit
#@ color off, clear 0.1 0.2 0.3 1, keep, target shadow 256 128, blend add
#@ mesh shells count 8 of torus parts 24 at 0 1 0 scale 0.5 and plane at 0 -1 0
#@ camera orbit yaw 30 pitch -20 distance 5 y 0.5
#@ texcoord 1 = normal, texcoord 2 = st 0.5 -0.25
#@ env[4..6] "elbow" = rotate 40 z 1 py 0.2 in -60..60 animate triangle 2s
#@ env[8..11] = camera shadow, local[2] = eye
#@ local[1].rgb "paint" = 1 0.5 .25 color, attrib[3] = 1 2 3 4
#@ texture 2 = normals strength 3 of "my heights.png", mipmap
#@ texture 3 = feedback of cells 64 64 density 0.4
#@ texture 4 = cube a.png b.png c.png d.png e.png f.png, texture 5 = depthof other, compare
#@ vertex skin.vp, then blur-x.fp, then blur-y.fp
)");
  EXPECT_THAT(panel.diagnostics, testing::IsEmpty());
  EXPECT_EQ(panel.title.text, "A scene");
  EXPECT_EQ(panel.state.depth->value, Depth::Lequal);
  EXPECT_FALSE(panel.state.depthWrite);
  EXPECT_FALSE(panel.state.colorWrite);
  EXPECT_TRUE(panel.state.keep);
  EXPECT_EQ(panel.target->name.text, "shadow");
  ASSERT_EQ(panel.mesh.size(), 2u);
  EXPECT_EQ(panel.mesh[0].of[0].argument("parts"), 24);
  EXPECT_EQ(panel.mesh[0].of[0].at[1].value, 1);
  EXPECT_EQ(panel.mesh[0].of[0].scale.value, 0.5);
  EXPECT_EQ(panel.camera->argument("pitch"), -20);
  EXPECT_EQ(panel.camera->argument("fov"), 45) << "the default";
  EXPECT_EQ(panel.coordinates[1].offset[1].value, -0.25);
  EXPECT_EQ(panel.parameters[0].count, 3u);
  EXPECT_EQ(panel.parameters[0].values[0].value, 40);
  EXPECT_EQ(panel.parameters[1].target.text, "shadow");
  EXPECT_EQ(panel.parameters[2].kind.value, ValueKind::Eye);
  EXPECT_TRUE(panel.parameters[3].color);
  EXPECT_EQ(panel.textures[0].source.of[0].files[0].text, "my heights.png");
  EXPECT_EQ(panel.textures[2].source.files.size(), 6u);
  EXPECT_TRUE(panel.textures[3].compare);
  EXPECT_EQ(panel.vertex.text, "skin.vp");
  EXPECT_EQ(panel.then.size(), 2u);
}

TEST(Panel, UnknownWordsAreWarningsAndTheRestHolds) {
  const std::string_view text = "!!ARBfp1.0\n#@ sise 3 4, blend addd, size 8 8 tall, cull back\n"
                                "#@ texture 0 = chequer 4, nearest, mirror\n";
  const Panel panel = parsePanel(text);
  EXPECT_TRUE(panel.ok());
  ASSERT_EQ(panel.diagnostics.size(), 4u);
  EXPECT_EQ(at(panel, text, 0), "sise");
  EXPECT_EQ(panel.diagnostics[0].severity, Severity::Warning);
  EXPECT_EQ(panel.diagnostics[0].hint, "did you mean 'size'?");
  EXPECT_EQ(at(panel, text, 1), "addd");
  EXPECT_EQ(at(panel, text, 2), "tall");
  EXPECT_EQ(at(panel, text, 3), "chequer");
  EXPECT_EQ(panel.width.value, 8);
  EXPECT_EQ(panel.state.cull->value, Cull::Back);
  EXPECT_TRUE(panel.textures.empty());
}

struct Wrong {
  const char *line;  ///< behind "#@ "
  const char *where; ///< the bytes that the diagnostic points at
  const char *id;
};

class WrongLines : public testing::TestWithParam<Wrong> {};

TEST_P(WrongLines, AreErrorsInTheirPlace) {
  const Wrong &wrong = GetParam();
  const std::string text = "!!ARBfp1.0\r\n#@ " + std::string(wrong.line) + "\r\nEND\r\n";
  const Panel panel = parsePanel(text);
  ASSERT_EQ(panel.diagnostics.size(), 1u) << wrong.line;
  EXPECT_FALSE(panel.ok()) << wrong.line;
  EXPECT_EQ(at(panel, text), wrong.where) << wrong.line;
  EXPECT_STREQ(panel.diagnostics[0].id, wrong.id) << wrong.line;
  EXPECT_FALSE(panel.diagnostics[0].message.empty());
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongLines,
    testing::Values(
        Wrong{"size 8", "", "panel_syntax"}, Wrong{"size 8 99999", "99999", "panel_range"},
        Wrong{"size 8.5 8", "8.5", "panel_range"}, Wrong{"size a 8", "a", "panel_syntax"},
        Wrong{"size 1 1, size 2 2", "size", "panel_twice"}, Wrong{"7", "7", "panel_syntax"},
        Wrong{"local 0 = 1", "0", "panel_syntax"}, Wrong{"local[0] 1", "1", "panel_syntax"},
        Wrong{"local[0] = ", "", "panel_syntax"}, Wrong{"local[0].yx = 1", ".yx", "panel_syntax"},
        Wrong{"local[0].xy = 1 2 3", "3", "panel_syntax"},
        Wrong{"local[0] = 1 in 2..1", "1", "panel_range"},
        Wrong{"local[0] = 1 in 0-1", "0-1", "panel_syntax"},
        Wrong{"local[0] = 1, local[0].y = 2", "local[0].y = 2", "panel_twice"},
        Wrong{"local[0..2] = 1", "1", "panel_syntax"},
        Wrong{"local[0..2] = rotate 30", "rotate", "panel_syntax"},
        Wrong{"local[2] = rotate 30 z 1", "rotate", "panel_syntax"},
        Wrong{"local[0].x = 1 animate turn 2s", "turn", "panel_syntax"},
        Wrong{"local[0] = eye animate sine 2s", "sine", "panel_syntax"},
        Wrong{"local[1e9] = 1", "1e9", "panel_range"},
        Wrong{"local[0] = 1e999", "1e999", "panel_syntax"},
        Wrong{"local[0] \"open = 1", "\"open = 1", "panel_syntax"},
        Wrong{"texture 32 = noise", "32", "panel_range"},
        Wrong{"texture 0 = noise, texture 0 = noise", "0", "panel_twice"},
        Wrong{"texture 0 = ../secret.png", "..", "panel_syntax"},
        Wrong{"texture 0 = \"../secret.png\"", "\"../secret.png\"", "panel_file"},
        Wrong{"texture 0 = \"/etc/passwd\"", "\"/etc/passwd\"", "panel_file"},
        Wrong{"texture 0 = feedback of sky", "sky", "panel_syntax"},
        Wrong{"texture 0 = normals of normals of normals of normals of bumps", "bumps",
              "panel_range"},
        Wrong{"texture 0 = checker cells 0", "0", "panel_range"},
        Wrong{"mesh shells of shells of shells of shells of shells of quad", "shells",
              "panel_range"},
        Wrong{"mesh shells", "", "panel_syntax"}, Wrong{"vertex", "", "panel_syntax"},
        Wrong{"camera orbit near 5 far 4", "orbit", "panel_range"},
        Wrong{"texcoord 1 normal", "normal", "panel_syntax"},
        Wrong{"depth less write maybe", "maybe", "panel_syntax"},
        Wrong{"clear 0 0 0", "", "panel_syntax"}, Wrong{"blend %", "%", "panel_syntax"}));

TEST(Panel, HostileTextEndsSoon) {
  std::string text = "!!ARBfp1.0\n";
  for (int i = 0; i < 20000; ++i)
    text += "#@ size \x80\xff, \"\n";
  EXPECT_EQ(parsePanel(text).diagnostics.size(), kMaxPanelDiagnostics);
  const std::string line = "#@ " + std::string(200000, '[');
  EXPECT_FALSE(parsePanel(line).ok());
  EXPECT_TRUE(parsePanel("#@").ok());
  EXPECT_TRUE(parsePanel("").ok());
  EXPECT_FALSE(parsePanel("END").written);
}

/// For any bytes, each span lies in the text, and parsing the text again gives the same result.
TEST(Panel, ChangedBytesKeepEverySpanInTheText) {
  std::string text = kTwirl;
  std::minstd_rand random(7);
  constexpr std::string_view kBytes = "#@,=[].\"x0 -9e\n\r\t%\xff/s";
  for (int i = 0; i < 5000; ++i) {
    if (i % 50 == 0)
      text = kTwirl;
    const std::size_t at = random() % text.size();
    if (random() % 3 == 0)
      text.erase(at, 1 + random() % 4);
    else
      text.insert(at, 1, kBytes[random() % kBytes.size()]);
    const Panel panel = parsePanel(text);
    for (const fp::Diagnostic &diagnostic : panel.diagnostics) {
      ASSERT_LE(diagnostic.span.begin, diagnostic.span.end) << text;
      ASSERT_LE(diagnostic.span.end, text.size()) << text;
    }
    for (const Parameter &parameter : panel.parameters)
      for (const Number &number : parameter.values)
        ASSERT_TRUE(number.written() && number.span.end <= text.size()) << text;
    (void)completePanel(text, std::uint32_t(at));
  }
}

TEST(Words, AreUniqueAndTheirDefaultsInRange) {
  const auto check = [](std::span<const WordRow> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i].word.empty()) {
        EXPECT_EQ(findWord(rows, rows[i].word), i) << rows[i].word << " stands in its table twice";
      }
      for (const ArgumentRow &argument : rows[i].arguments()) {
        EXPECT_LE(argument.low, argument.fallback) << argument.word;
        EXPECT_LE(argument.fallback, argument.high) << argument.word;
      }
    }
  };
  check(wordsOf<Setting>());
  check(wordsOf<Generator>());
  check(wordsOf<Shape>());
  check(wordsOf<CameraKind>());
  check(wordsOf<ValueKind>());
  // A filter's word behind a texture must not be a setting.
  for (const WordRow &row : wordsOf<Filter>())
    EXPECT_FALSE(findWord<Setting>(row.word)) << row.word;
  for (const WordRow &row : wordsOf<Wrap>())
    EXPECT_FALSE(findWord<Setting>(row.word)) << row.word;
}

} // namespace
} // namespace arbiter::scene
