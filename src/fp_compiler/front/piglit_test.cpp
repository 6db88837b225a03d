// Tests Piglit's parser programs for ARBfp1.0 and ARBvp1.0 if the package is installed. Each
// program says whether it must load.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <map>

#include "fp_compiler/front/testing/test_support.h"

namespace arbiter::fp {
namespace {

namespace fs = std::filesystem;
using testing_support::check;
using testing_support::firstError;
using testing_support::generous;

constexpr const char *kLanguages[] = {"ARBfp1.0", "ARBvp1.0"};

/// Returns name and text of every program of a language; empty without piglit.
std::map<std::string, std::string> programs(const std::string &language) {
  std::map<std::string, std::string> found;
  for (const char *root : {"/usr/lib/x86_64-linux-gnu/piglit", "/usr/lib/aarch64-linux-gnu/piglit",
                           "/usr/lib/i386-linux-gnu/piglit", "/usr/lib/piglit"}) {
    const fs::path folder = fs::path(root) / "tests/asmparsertest/shaders" / language;
    if (!fs::is_directory(folder))
      continue;
    for (const fs::directory_entry &entry : fs::directory_iterator(folder)) {
      std::ifstream file(entry.path(), std::ios::binary);
      found[entry.path().filename().string()] = {std::istreambuf_iterator<char>(file), {}};
    }
  }
  return found;
}

bool contains(const std::string &text, const char *piece) {
  return text.find(piece) != std::string::npos;
}

ir::Language languageNamed(const std::string &name) {
  return name == "ARBvp1.0" ? ir::Language::ArbVertex : ir::Language::ArbFragment;
}

/// Returns where a text names an option of NVIDIA; npos if it does not.
std::size_t nvOption(const std::string &text) {
  const std::size_t option = text.find("OPTION\tNV_");
  return option == std::string::npos ? option : option + std::string_view("OPTION\t").size();
}

TEST(Piglit, ParserProgramsLoadOrFailAsTheySay) {
  for (const std::string language : kLanguages) {
    const auto all = programs(language);
    if (all.empty())
      GTEST_SKIP() << "not installed: piglit";
    int plain = 0;
    for (const auto &[name, text] : all) {
      const CheckResult result = checkProgram(languageNamed(language), text, generous());
      if (const std::size_t option = nvOption(text); option != std::string::npos) {
        EXPECT_EQ(firstError(result), "unsupported_option") << name;
        EXPECT_EQ(result.errorPosition(), std::int32_t(option)) << name;
      } else {
        ++plain;
        EXPECT_EQ(result.ok(), !contains(text, "# FAIL")) << name << "\n"
                                                          << result.errorString(text);
      }
    }
    EXPECT_GT(plain, 85) << language;
  }
}

TEST(Piglit, ParserProgramsCutAtEveryByteAndWithEachTokenGoneOrDoubled) {
  for (const std::string language : kLanguages) {
    const auto all = programs(language);
    if (all.empty())
      GTEST_SKIP() << "not installed: piglit";
    const auto expectSane = [&](const std::string &text, const std::string &name) {
      const CheckResult result = checkProgram(languageNamed(language), text, generous());
      EXPECT_EQ(result.ok(), result.errorPosition() < 0) << name;
      EXPECT_LE(result.errorPosition(), std::int32_t(text.size())) << name;
    };
    for (const auto &program : all) {
      const std::string &name = program.first;
      const std::string &text = program.second;
      for (std::size_t size = 0; size < text.size(); ++size)
        expectSane(text.substr(0, size), name);
      testing_support::forEachTokenEdit(
          text, [&](const std::string &edited) { expectSane(edited, name); });
    }
  }
}

} // namespace
} // namespace arbiter::fp
