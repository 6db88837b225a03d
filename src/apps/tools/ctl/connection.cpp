#include "apps/tools/ctl/connection.h"

#include <algorithm>

#include "apps/tools/commands.h"

namespace arbiter::tools::ctl {

namespace {

constexpr const char *kHowToStart = "start it with arbiter run --control -- COMMAND";

std::string listOf(const std::vector<wire::Listener> &listeners) {
  std::string text;
  for (const wire::Listener &listener : listeners)
    text += (text.empty() ? "" : ", ") + std::to_string(listener.process);
  return text;
}

Result<pid_t, Failure> onlyOne(const std::vector<wire::Listener> &listeners) {
  if (listeners.empty())
    return Failure{kExitUsage, std::string("no process listens; ") + kHowToStart};
  if (listeners.size() > 1)
    return Failure{kExitUsage, "processes " + listOf(listeners) +
                                   " listen; say which one with --pid (arbiter ctl list)"};
  return listeners.front().process;
}

} // namespace

Result<std::unique_ptr<Connection>, Failure> Connection::open(pid_t process,
                                                              std::chrono::milliseconds patience) {
  const auto folder = wire::socketFolder();
  if (!folder)
    return Failure{kExitUsage, folder.error().message};
  std::vector<wire::Listener> listeners = wire::findListeners(folder.value());
  std::erase_if(listeners, [](const auto &each) { return each.kind != wire::Kind::Layer; });
  if (process == 0) {
    const auto only = onlyOne(listeners);
    if (!only)
      return only.error();
    process = only.value();
  }
  const auto found = std::find_if(listeners.begin(), listeners.end(),
                                  [&](const auto &each) { return each.process == process; });
  if (found == listeners.end())
    return Failure{kExitUsage, "process " + std::to_string(process) + " does not listen" +
                                   (listeners.empty() ? "" : "; " + listOf(listeners) + " do") +
                                   "; " + kHowToStart};
  auto fd = wire::connectTo(found->path);
  if (!fd)
    return Failure{kExitUsage, fd.error().message};
  return std::make_unique<Connection>(process, std::move(fd.value()), patience);
}

Failure Connection::noAnswer() {
  const std::string who = "process " + std::to_string(m_process);
  if (!m_client.connected())
    return {kExitUsage, who + " has ended, or hung up"};
  const wire::Answer ping =
      m_client.call("ping", wire::Json::object(), std::chrono::milliseconds(1000));
  if (!ping)
    return {kExitUsage, who + " does not answer at all; is it stopped?"};
  const auto idle = ping.value().find("idle");
  if (idle == ping.value().end() || idle->is_null())
    return {kExitUsage, who + " has drawn nothing yet; it answers where a frame ends"};
  return {kExitUsage, who + " has drawn nothing for " + idle->dump() +
                          " ms; it answers where a frame ends (--timeout waits longer)"};
}

Result<wire::Json, Failure> Connection::ask(const std::string &method, wire::Json params) {
  wire::Answer answer = m_client.call(method, std::move(params), m_patience);
  if (answer)
    return std::move(answer.value());
  if (answer.error().code == 0)
    return noAnswer();
  return Failure{kExitUsage, method + ": " + answer.error().message};
}

void Connection::awaitAge(std::chrono::milliseconds age) {
  while (m_client.awaitUntil(m_since + age)) {
  }
}

Result<wire::Frame, Failure> Connection::frame() {
  if (auto wanted = ask("frame.want", {{"every", 1}}); !wanted)
    return wanted.error();
  const auto end = std::chrono::steady_clock::now() + m_patience;
  std::optional<wire::Frame> frame;
  while (!(frame = m_client.nextFrame()))
    if (!m_client.awaitUntil(end))
      return noAnswer();
  if (auto enough = ask("frame.want", {{"every", 0}}); !enough)
    return enough.error();
  return *frame;
}

} // namespace arbiter::tools::ctl
