#include "apps/tools/debug/draws/client.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include "apps/tools/launch/child.h"
#include "control/attached.h"

namespace arbiter::tools::debug {

namespace {

/// The time to wait for an answer; compiling a long program on a busy machine takes seconds.
constexpr std::chrono::seconds kPatience{120};
/// The time in which a process that failed exits.
constexpr std::chrono::milliseconds kExit{200};

} // namespace

DrawClient::DrawClient(const std::string &name, control::Descriptor socket, pid_t process)
    : m_name(name), m_client(std::make_unique<control::Client>(std::move(socket))),
      m_process(process) {}

DebugError DrawClient::error(const std::string &what) const {
  return {"the process that draws (" + m_name + ") " + what};
}

void DrawClient::close() {
  m_client.reset(); // the process exits when the socket closes
  if (const pid_t process = std::exchange(m_process, -1); process > 0)
    endChild(process, 0);
}

Result<std::unique_ptr<DrawClient>, DebugError>
DrawClient::start(const std::string &name, const std::function<int()> &work) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return DebugError{std::string("no socket for the drawing process: ") + std::strerror(errno)};
  control::Descriptor ours(ends[0]), theirs(ends[1]);
  const pid_t process = startChild([&] {
    ours = {}; // otherwise it would keep the debugger's end open and never see it close
    ::dup2(theirs.get(), STDIN_FILENO);
    ::dup2(STDERR_FILENO, STDOUT_FILENO); // apart from the debugger's output
    return work();
  });
  if (process < 0)
    return DebugError{std::string("no drawing process: ") + std::strerror(errno)};
  return std::unique_ptr<DrawClient>(new DrawClient(name, std::move(ours), process));
}

/// Returns an error that tells how the process ended. Kills the process if it is only silent.
DebugError DrawClient::lost() {
  m_client.reset();
  int status = 0;
  const pid_t process = std::exchange(m_process, -1);
  if (!awaitChild(process, kExit, status)) {
    endChild(process, SIGKILL);
    return error("did not answer for " + std::to_string(kPatience.count()) + " seconds");
  }
  if (!WIFSIGNALED(status))
    return error("ended");
  return error("was ended by signal " + std::to_string(WTERMSIG(status)) + ", " +
               ::strsignal(WTERMSIG(status)));
}

Result<control::Json, DebugError> DrawClient::ask(const std::string &method, Json params) {
  if (!m_client)
    return error("is gone");
  control::Answer answer = m_client->call(method, std::move(params), kPatience);
  if (!answer && answer.error().code == 0)
    return lost();
  if (!answer)
    return DebugError{answer.error().message, answer.error().code == control::kWrongParameters};
  if (!answer.value().is_object())
    return error("answered nonsense");
  return std::move(answer).value();
}

std::optional<DebugError> DrawClient::take(const Json &, std::span<std::uint8_t> bytes) {
  if (control::readMemory(m_client->takeDescriptor(), bytes))
    return {};
  return error("drew another number of pixels");
}

std::optional<DebugError> DrawClient::open(const Json &what) {
  const auto answer = ask("pixel.open", what);
  if (!answer)
    return answer.error();
  control::Params params(answer.value());
  m_size = {int(params.integer("width", 1, INT32_MAX)),
            int(params.integer("height", 1, INT32_MAX))};
  if (!params.ok())
    return error("has no picture");
  return {};
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
DrawClient::picture(const Region &region) {
  return askItems<std::array<std::uint8_t, 4>>(
      "pixel.picture", regionJson(region), std::size_t(region.width) * std::size_t(region.height));
}

Result<DrawClient::Vec4, DebugError> DrawClient::vertexState(const fp::ir::StateRef &state) {
  const auto answer =
      ask("pixel.state", {{"item", int(state.item)}, {"index", state.index}, {"row", state.row}});
  if (!answer)
    return answer.error();
  Vec4 value = {};
  control::Params(answer.value()).floats("value", value.data(), value.size(), true);
  return value;
}

} // namespace arbiter::tools::debug
