#include "apps/tools/debug/draws/client.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace arbiter::tools::debug {

namespace {

using Json = nlohmann::json;

/// Seconds to wait for an answer; compiling a long program on a busy machine takes seconds.
constexpr int kPatience = 120;

Json regionJson(const Region &region) {
  return {{"x", region.x}, {"y", region.y}, {"width", region.width}, {"height", region.height}};
}

/// Returns an integer member, or 0 if there is none.
std::int64_t integerAt(const Json &json, const char *name) {
  const auto found = json.find(name);
  return found != json.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

std::size_t pixelsOf(const Region &region) {
  return std::size_t(region.width) * std::size_t(region.height);
}

/// Turns the new process into the drawing process. The socket becomes descriptor 0, and output goes
/// to standard error, apart from the debugger's.
[[noreturn]] void become(int descriptor, const std::function<void()> &start) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  ::dup2(descriptor, STDIN_FILENO);
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
  start();
  ::_exit(127);
}

} // namespace

DrawClient::DrawClient(std::string name, int descriptor, int process)
    : m_name(std::move(name)), m_channel(std::make_unique<Channel>(descriptor)),
      m_process(process) {}

DrawClient::~DrawClient() { close(); }

void DrawClient::close() {
  m_channel.reset(); // the process exits when the socket closes
  if (m_process <= 0)
    return;
  while (::waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
  }
  m_process = -1;
}

Result<std::unique_ptr<DrawClient>, DebugError>
DrawClient::start(std::string name, const std::function<void()> &start) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
    return DebugError{std::string("no socket for the drawing process: ") + std::strerror(errno)};
  const pid_t process = ::fork();
  if (process == 0) {
    ::close(ends[0]); // otherwise it would keep the debugger's end open and never see it close
    become(ends[1], start);
  }
  ::close(ends[1]);
  if (process < 0) {
    ::close(ends[0]);
    return DebugError{std::string("no drawing process: ") + std::strerror(errno)};
  }
  return std::unique_ptr<DrawClient>(new DrawClient(std::move(name), ends[0], process));
}

/// Returns an error that tells how the process ended. Kills the process if it is only silent.
DebugError DrawClient::lost() {
  int status = 0;
  m_channel.reset();
  for (int i = 0; i < 20; ++i) { // a process that failed exits soon
    if (m_process <= 0 || ::waitpid(m_process, &status, WNOHANG) == m_process) {
      m_process = -1;
      if (WIFSIGNALED(status))
        return {"the process that draws (" + m_name + ") was ended by signal " +
                std::to_string(WTERMSIG(status)) + ", " + ::strsignal(WTERMSIG(status))};
      return {"the process that draws (" + m_name + ") ended"};
    }
    ::usleep(10000);
  }
  ::kill(m_process, SIGKILL);
  ::waitpid(m_process, &status, 0);
  m_process = -1;
  return {"the process that draws (" + m_name + ") did not answer for " +
          std::to_string(kPatience) + " seconds"};
}

Result<Json, DebugError> DrawClient::ask(const Json &request) {
  if (!m_channel)
    return DebugError{"the process that draws (" + m_name + ") is gone"};
  if (!m_channel->send(request.dump(-1, ' ', false, Json::error_handler_t::replace)))
    return lost();
  const auto line = m_channel->receive(kPatience);
  if (!line)
    return lost();
  Json answer = Json::parse(*line, nullptr, false);
  if (!answer.is_object())
    return DebugError{"the process that draws (" + m_name + ") answered nonsense"};
  if (const auto error = answer.find("error"); error != answer.end() && error->is_string())
    return DebugError{error->get<std::string>(), answer.value("of_usage", Json()) == true};
  return answer;
}

template <typename Item>
Result<std::vector<Item>, DebugError> DrawClient::askItems(const Json &request, std::size_t count) {
  auto answer = ask(request);
  if (!answer)
    return answer.error();
  std::vector<Item> items(count);
  const std::size_t bytes = count * sizeof(Item);
  if (integerAt(answer.value(), "bytes") != std::int64_t(bytes))
    return DebugError{"the process that draws (" + m_name + ") drew another number of pixels"};
  if (!m_channel->receive(items.data(), bytes, kPatience))
    return lost();
  return items;
}

std::optional<DebugError> DrawClient::open(const Json &what) {
  const auto answer = ask({{"open", what}});
  if (!answer)
    return answer.error();
  m_size = {int(integerAt(answer.value(), "width")), int(integerAt(answer.value(), "height"))};
  if (m_size[0] <= 0 || m_size[1] <= 0)
    return DebugError{"the process that draws (" + m_name + ") has no picture"};
  return {};
}

Result<std::vector<Drawer::Vec4>, DebugError> DrawClient::draw(const std::string &text,
                                                               std::size_t targets,
                                                               const Region &region,
                                                               const std::vector<Vec4> &locals) {
  Json request = {{"draw", text}, {"targets", targets}, {"region", regionJson(region)}};
  if (!locals.empty())
    request["locals"] = locals;
  return askItems<Vec4>(request, targets * pixelsOf(region));
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
DrawClient::picture(const Region &region) {
  return askItems<std::array<std::uint8_t, 4>>({{"picture", regionJson(region)}}, pixelsOf(region));
}

Result<std::array<int, 3>, DebugError> DrawClient::textureSize(unsigned unit,
                                                               fp::ir::TexTarget target) {
  const auto answer = ask({{"texture", unit}, {"target", int(target)}});
  if (!answer)
    return answer.error();
  std::array<int, 3> size = {};
  const auto found = answer.value().find("size");
  if (found != answer.value().end() && found->is_array() && found->size() == 3)
    for (std::size_t i = 0; i < 3; ++i)
      if ((*found)[i].is_number_integer())
        size[i] = (*found)[i].get<int>();
  return size;
}

Result<DrawClient::Vec4, DebugError> DrawClient::vertexState(const fp::ir::StateRef &state) {
  const auto answer = ask({{"state", int(state.item)}, {"index", state.index}, {"row", state.row}});
  if (!answer)
    return answer.error();
  Vec4 value = {};
  const auto found = answer.value().find("value");
  if (found != answer.value().end() && found->is_array() && found->size() == value.size())
    for (std::size_t i = 0; i < value.size(); ++i)
      if ((*found)[i].is_number())
        value[i] = (*found)[i].get<float>();
  return value;
}

} // namespace arbiter::tools::debug
