// Compares the documentation's tables with the parser in both directions. The parser must accept
// what they list, and its hints must list the same words.
#include "fp_compiler/front/reference/reference.h"

#include <gtest/gtest.h>

#include "fp_compiler/front/testing/test_support.h"
#include "fp_compiler/front/words/keywords.h"

namespace arbiter::fp {
namespace {

using ir::Language;
using testing_support::check;
using testing_support::firstError;
using testing_support::generous;
using testing_support::wrap;
using testing_support::wrapVertex;

constexpr Language kArb[] = {Language::ArbFragment, Language::ArbVertex};

std::string program(Language language, const std::string &statements) {
  return language == Language::ArbVertex ? wrapVertex(statements) : wrap(statements);
}

CompileOptions everything() {
  CompileOptions options = generous();
  options.limits.paletteMatrices = 1; // so that state.matrix.palette[0] is there
  return options;
}

/// Returns the path with 0 for every index.
std::string spelled(const reference::Binding &binding) {
  std::string text = binding.path();
  for (std::size_t at = text.find("[n]"); at != std::string::npos; at = text.find("[n]"))
    text.replace(at, 3, "[0]");
  return text;
}

std::string declaration(const reference::Binding &binding, Language language) {
  const std::string_view root = binding.segments[0].word;
  const std::string text = spelled(binding);
  if (root == "result")
    return (language == Language::ArbFragment ? "OPTION ARB_draw_buffers;\nOUTPUT o = "
                                              : "OUTPUT o = ") +
           text + ";";
  if (root == "program" || root == "state")
    return "PARAM p = " + text + ";";
  return "ATTRIB a = " + text + ";";
}

TEST(Reference, EveryBindingIsOne) {
  for (const Language language : kArb) {
    EXPECT_GT(reference::bindings(language).size(), 60u);
    for (const reference::Binding &binding : reference::bindings(language)) {
      const std::string text = program(language, declaration(binding, language));
      EXPECT_EQ(firstError(check(text, everything())), "") << text;
      EXPECT_FALSE(binding.doc.empty());
    }
  }
}

TEST(Reference, IndexesAreWhereTheParserWantsThem) {
  for (const Language language : kArb)
    for (const reference::Binding &binding : reference::bindings(language))
      for (std::size_t i = 0; i < binding.segments.size(); ++i) {
        if (binding.segments[i].index == reference::Index::None)
          continue;
        reference::Binding without = binding;
        without.segments[i].index = reference::Index::None;
        const std::string text = program(language, declaration(without, language));
        EXPECT_EQ(firstError(check(text, everything())) == "",
                  binding.segments[i].index == reference::Index::Optional)
            << text;
      }
}

/// Returns the words of a hint "one of a, b, c".
std::vector<std::string> offered(const std::string &hint) {
  std::vector<std::string> words;
  constexpr std::string_view kOneOf = "one of ";
  if (!hint.starts_with(kOneOf))
    return words;
  for (std::size_t at = kOneOf.size(); at < hint.size();) {
    const std::size_t end = std::min(hint.find(", ", at), hint.size());
    words.push_back(hint.substr(at, end - at));
    at = end + 2;
  }
  std::sort(words.begin(), words.end());
  return words;
}

TEST(Reference, TheParserOffersTheSameWords) {
  std::size_t compared = 0;
  for (const Language language : kArb)
    for (const reference::Binding &binding : reference::bindings(language))
      for (std::size_t length = 1; length < binding.segments.size(); ++length) {
        reference::Binding wrong = binding;
        wrong.segments.resize(length);
        std::vector<std::string_view> path;
        for (const reference::Segment &segment : wrong.segments)
          path.push_back(segment.word);
        wrong.segments.push_back({"qqqqqqqqqqqqqqqq"});
        const CheckResult result =
            check(program(language, declaration(wrong, language)), everything());
        ASSERT_FALSE(result.ok());
        const std::vector<std::string> hinted = offered(result.diagnostics[0].hint);
        if (hinted.empty())
          continue; // a hint of another kind
        std::vector<std::string> listed;
        for (const reference::Segment &segment : reference::wordsBehind(language, path))
          listed.emplace_back(segment.word);
        std::sort(listed.begin(), listed.end());
        // A face may come before a property, but the hint names only the properties.
        const auto isFace = [](const std::string &word) {
          return word == "front" || word == "back";
        };
        if (std::none_of(hinted.begin(), hinted.end(), isFace))
          std::erase_if(listed, isFace);
        EXPECT_EQ(hinted, listed) << declaration(wrong, language);
        ++compared;
      }
  EXPECT_GT(compared, 100u);
}

TEST(Reference, KeywordsAreTheLexersOwn) {
  for (const Language language : kArb)
    for (const reference::Entry &entry : reference::keywords(language))
      EXPECT_NE(classify(entry.word, arbLanguage(language)).keyword, Keyword::None) << entry.word;
}

TEST(Reference, OptionsAndTargetsAreTaken) {
  CompileOptions options = testing_support::small();
  options.limits.nvOptions = 2;
  for (const Language language : kArb)
    for (const reference::Entry &entry : reference::options(language))
      EXPECT_TRUE(check(program(language, "OPTION " + std::string(entry.word) + ";"), options).ok())
          << entry.word;
  for (const reference::Entry &entry : reference::targets())
    EXPECT_TRUE(check(wrap("OPTION ARB_fragment_program_shadow;\nTEX result.color, "
                           "fragment.texcoord, texture, " +
                           std::string(entry.word) + ";"))
                    .ok())
        << entry.word;
}

TEST(Reference, AtiWordsAreTaken) {
  const auto shader = [](const std::string &setup, const std::string &instruction) {
    return "!!ATIfs1.0\nStartConstants;\nCONSTANT c0 = program.env[0];\nEndConstants;\n"
           "StartOutputPass;\n" +
           setup + instruction + "EndPass;\n";
  };
  for (const reference::AtiOp &op : reference::atiOps()) {
    std::string text = std::string(op.word) + " r0";
    for (int i = 0; i < op.arguments; ++i)
      text += ", c0";
    EXPECT_EQ(firstError(check(shader("", text + ";\n"))), "") << text;
  }
  for (const reference::Entry &entry : reference::atiCoordinates())
    EXPECT_EQ(firstError(check(
                  shader("SampleMap r1, t0." + std::string(entry.word) + ";\n", "MOV r0, r1;\n"))),
              "");
  for (const reference::Entry &entry : reference::atiDestinationModifiers())
    EXPECT_EQ(firstError(check(shader("", "MOV r0.rgb." + std::string(entry.word) + ", c0;\n"))),
              "");
  for (const reference::Entry &entry : reference::atiArgumentModifiers())
    EXPECT_EQ(firstError(check(shader("", "MOV r0, c0." + std::string(entry.word) + ";\n"))), "");
}

TEST(Reference, AlternativesExpand) {
  std::vector<std::string> material;
  for (const reference::Binding &binding : reference::bindings(Language::ArbVertex))
    if (binding.segments[1].word == "material" && binding.segments.back().word == "shininess")
      material.push_back(binding.path());
  EXPECT_EQ(material,
            (std::vector<std::string>{"state.material.shininess", "state.material.front.shininess",
                                      "state.material.back.shininess"}));
}

} // namespace
} // namespace arbiter::fp
