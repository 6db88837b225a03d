#pragma once
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace arbiter::fp::glsl {

inline bool contains(const std::string &text, const std::string &part) {
  return text.find(part) != std::string::npos;
}

/// Succeeds if the reference compiler accepts the shader; fails with its messages otherwise.
/// \param stage "frag" or "vert"
inline ::testing::AssertionResult validates(const std::string &text, const char *stage = "frag") {
  static const bool present = std::system("glslangValidator -v >/dev/null 2>&1") == 0;
  if (!present)
    return ::testing::AssertionSuccess() << "glslangValidator is not installed";
  const auto path = std::filesystem::temp_directory_path() /
                    ("arbiter-glsl-test-" + std::to_string(getpid()) + "." + stage);
  std::ofstream(path) << text;
  const std::string command =
      "glslangValidator '" + path.string() + "' > '" + path.string() + ".log' 2>&1";
  const bool ok = std::system(command.c_str()) == 0;
  std::ifstream log(path.string() + ".log");
  const std::string complaints((std::istreambuf_iterator<char>(log)), {});
  std::filesystem::remove(path);
  std::filesystem::remove(path.string() + ".log");
  if (ok)
    return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << complaints << "\n" << text;
}

} // namespace arbiter::fp::glsl
