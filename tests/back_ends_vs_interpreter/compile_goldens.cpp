// Compiles and links every .glsl file of a folder with the host's own compiler.
//
// usage: compile-goldens FOLDER
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "gl_host.h"

namespace {
namespace fs = std::filesystem;

/// Links a text. Returns "" on success, else the host's log.
std::string link(const std::string &text) {
  const bool vertex = text.find("gl_Position") != std::string::npos;
  const GLuint shader = glCreateShader(vertex ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
  const char *source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  char log[4096] = "";
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  std::string complaints = log;
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  complaints += log;
  glDeleteShader(shader);
  glDeleteProgram(program);
  return linked ? "" : "not linked: " + complaints;
}
} // namespace

int main(int argc, char **argv) {
  if (argc != 2 || !fs::is_directory(argv[1])) {
    std::fputs("usage: compile-goldens FOLDER\n", stderr);
    return 2;
  }
  std::string why;
  const auto host = arbiter::differential::GlHost::create(why);
  if (!host) {
    std::fprintf(stderr, "compile-goldens: no GL context: %s\n", why.c_str());
    return 77;
  }
  std::vector<fs::path> files;
  for (const fs::directory_entry &entry : fs::directory_iterator(argv[1]))
    if (entry.path().extension() == ".glsl")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int failures = 0;
  for (const fs::path &path : files) {
    std::ifstream file(path, std::ios::binary);
    const std::string problem = link({std::istreambuf_iterator<char>(file), {}});
    if (problem.empty())
      continue;
    ++failures;
    std::printf("%s: %s\n", path.filename().c_str(), problem.c_str());
  }
  std::printf("%zu shaders on %s, %d failures\n", files.size(),
              reinterpret_cast<const char *>(glGetString(GL_RENDERER)), failures);
  return files.empty() || failures != 0 ? 1 : 0;
}
