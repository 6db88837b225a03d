#include "apps/tools/input.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <memory>
#include <sys/stat.h>
#include <unistd.h>

#include "util/file.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxInputBytes = 64u << 20;

struct Close {
  void operator()(std::FILE *file) const {
    if (file != stdin && file != stdout)
      std::fclose(file);
  }
};
using OpenFile = std::unique_ptr<std::FILE, Close>;

std::string &speaker() {
  static std::string s_speaker = "arbiter";
  return s_speaker;
}

} // namespace

Result<std::string, FileError> readInput(const std::string &name) {
  const OpenFile file(name == "-" ? stdin : std::fopen(name.c_str(), "rbe"));
  if (!file)
    return FileError{name + ": " + std::strerror(errno)};
  struct stat status = {};
  if (::fstat(fileno(file.get()), &status) == 0 && S_ISDIR(status.st_mode))
    return FileError{name + ": " + std::strerror(EISDIR)};
  std::string bytes;
  char buffer[65536];
  while (const std::size_t count = std::fread(buffer, 1, sizeof buffer, file.get())) {
    if (bytes.size() + count > kMaxInputBytes)
      return FileError{name + ": larger than 64 MiB"};
    bytes.append(buffer, count);
  }
  if (std::ferror(file.get()))
    return FileError{name + ": " + std::strerror(errno)};
  return bytes;
}

std::string writeOutput(const std::string &name, std::string_view bytes) {
  OpenFile file(name == "-" ? stdout : std::fopen(name.c_str(), "wbe"));
  if (!file)
    return name + ": " + std::strerror(errno);
  bool good = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  good = std::fflush(file.get()) == 0 && good;
  return good ? std::string() : name + ": " + std::strerror(errno);
}

std::string replaceFile(const std::string &name, std::string_view bytes) {
  const auto fault = [&] { return name + ": " + std::strerror(errno); };
  std::error_code error;
  const fs::path path = fs::canonical(name, error);
  if (error)
    return name + ": " + error.message();
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0)
    return fault();
  if (!S_ISREG(status.st_mode))
    return name + ": no regular file";
  std::string temporary = path.string() + ".XXXXXX";
  const int descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
  if (descriptor < 0)
    return fault();
  const bool good = writeAll(descriptor, bytes) &&
                    ::fchmod(descriptor, status.st_mode & 07777) == 0 && ::fsync(descriptor) == 0;
  const std::string reason = good ? "" : fault();
  ::close(descriptor);
  if (good && std::rename(temporary.c_str(), path.c_str()) == 0)
    return {};
  std::string last = good ? fault() : reason;
  ::unlink(temporary.c_str());
  return last;
}

bool isSameFile(const std::string &a, const std::string &b) {
  if (a == "-" || b == "-")
    return a == b;
  std::error_code error;
  if (fs::equivalent(a, b, error) && !error)
    return true;
  return fs::absolute(a, error).lexically_normal() == fs::absolute(b, error).lexically_normal();
}

std::string whyNotWritable(const std::string &path) {
  std::error_code error;
  if (fs::is_directory(path, error))
    return path + ": " + std::strerror(EISDIR);
  const fs::path folder = fs::absolute(path, error).parent_path();
  const bool there = fs::exists(path, error);
  if (::access(there ? path.c_str() : folder.c_str(), W_OK) != 0)
    return path + ": " + std::strerror(errno);
  return {};
}

void complain(const std::string &text) {
  std::fprintf(stderr, "%s: %s\n", speaker().c_str(), text.c_str());
}

void speakAs(const std::string &verb) { speaker() = "arbiter " + verb; }

} // namespace arbiter::tools
