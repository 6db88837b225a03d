#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <epoxy/gl.h>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <unistd.h>

#include "apps/tools/doctor/finding.h"
#include "apps/tools/draw/surface.h"
#include "apps/tools/launch/child.h"

namespace arbiter::tools::doctor {

namespace {

constexpr std::chrono::seconds kPatience{20}; // limit, in case a driver hangs

/// Reads from \p end until it is closed or the time is over.
std::string readFor(int end, std::chrono::steady_clock::duration patience) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + patience;
  std::string answer;
  char block[512];
  while (true) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    pollfd wanted = {end, POLLIN, 0};
    const int ready = left > 0 ? ::poll(&wanted, 1, int(left)) : 0;
    if (ready < 0 && errno == EINTR)
      continue;
    const ssize_t count = ready > 0 ? ::read(end, block, sizeof block) : 0;
    if (count < 0 && errno == EINTR)
      continue;
    if (count <= 0)
      return answer;
    answer.append(block, std::size_t(count));
  }
}

/// Returns the host GL's version, renderer and GLSL version without opening a window. Returns "" if
/// there is no answer, or if the driver ended the process.
std::string askHost() {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return {};
  std::fflush(nullptr);
  const pid_t child = startChild([&]() -> int {
    // A driver's messages would not help the user here.
    if (::freopen("/dev/null", "w", stderr) == nullptr)
      return 1;
    Surface surface;
    std::string answer;
    if (surface.open(16, 16) == nullptr)
      for (const GLenum name :
           {GLenum(GL_VERSION), GLenum(GL_RENDERER), GLenum(GL_SHADING_LANGUAGE_VERSION)}) {
        const auto *const text = reinterpret_cast<const char *>(glGetString(name));
        answer += std::string(text == nullptr ? "" : text) + "\n";
      }
    const ssize_t written = ::write(ends[1], answer.data(), answer.size());
    ::_exit(written < 0 ? 1 : 0);
  });
  ::close(ends[1]);
  std::string answer = child > 0 ? readFor(ends[0], kPatience) : std::string();
  ::close(ends[0]);
  // alarm() in the child would not end a driver that blocks SIGALRM. A child that has answered is
  // no longer needed.
  if (child > 0)
    endChild(child, SIGKILL);
  return answer;
}

} // namespace

void examineHost(Examination &examination) {
  const std::string answer = askHost();
  const std::size_t first = answer.find('\n');
  if (first == std::string::npos || first == 0) {
    examination.add({"host_unknown",
                     Level::Note,
                     {},
                     "The host's GL gives no context without a window, so that its version is not "
                     "known here.",
                     {}});
    return;
  }
  const std::string version = answer.substr(0, first);
  const std::size_t second = answer.find('\n', first + 1);
  const std::string renderer = answer.substr(first + 1, second - first - 1);
  int major = 0, minor = 0, glslMajor = 0, glslMinor = 0;
  const bool numbers = std::sscanf(version.c_str(), "%d.%d", &major, &minor) == 2;
  static_cast<void>(std::sscanf(answer.c_str() + second + 1, "%d.%d", &glslMajor, &glslMinor));
  if (numbers && (major < 2 || glslMajor * 100 + glslMinor < 120))
    examination.add(
        {"old_driver",
         Level::Obstacle,
         {},
         "The host's driver (" + renderer + ") has OpenGL " + version +
             "; the layer needs 2.0 with GLSL 1.20 under it.",
         "Install a newer driver, or draw on the processor: LIBGL_ALWAYS_SOFTWARE=1 with "
         "Mesa."});
  else
    examination.add({"host",
                     Level::Note,
                     {},
                     "The host's driver is " + renderer + ", OpenGL " + version + ".",
                     {}});
}

} // namespace arbiter::tools::doctor
