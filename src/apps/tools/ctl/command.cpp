// Implements `arbiter ctl`, with which scripts control a process.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <poll.h>
#include <sstream>
#include <unistd.h>

#include "apps/tools/commands.h"
#include "apps/tools/ctl/actions.h"
#include "apps/tools/input.h"
#include "util/file.h"

namespace arbiter::tools {

namespace {

using namespace ctl;

volatile std::sig_atomic_t g_ended = 0;

void endAtSignals() {
  struct sigaction action = {};
  action.sa_handler = [](int) { g_ended = 1; };
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    sigaction(signal, &action, nullptr);
}

int listProcesses(bool json) {
  const auto folder = wire::socketFolder();
  if (!folder)
    return fail({kExitUsage, folder.error().message});
  wire::Json rows = wire::Json::array();
  for (const wire::Listener &listener : wire::findListeners(folder.value())) {
    std::string name;
    if (auto fd = wire::connectTo(listener.path)) {
      wire::Client client(std::move(fd.value()));
      const wire::Answer hello =
          client.call("hello", {{"client", "arbiter ctl"}}, std::chrono::milliseconds(1000));
      if (hello && hello.value().is_object())
        name = hello.value().value("program", "");
    }
    const char *const kind = listener.kind == wire::Kind::Layer ? "layer" : "renderer";
    rows.push_back({{"pid", listener.process}, {"server", kind}, {"program", name}});
    if (!json)
      std::printf("%8d  %-8s  %s\n", int(listener.process), kind, name.c_str());
  }
  if (json)
    printJson(rows);
  if (rows.empty())
    return fail(
        {kExitUsage, "no process listens; start one with arbiter run --control -- COMMAND"});
  return kExitOk;
}

/// Sets texts again when their files change. Ends when the process or this one ends, or after the
/// given time.
int hold(Session &session, double seconds) {
  using Clock = std::chrono::steady_clock;
  std::vector<FileState> states;
  for (std::size_t i = 1; i < session.watched.size(); i += 2)
    states.push_back(stateOf(session.watched[i].c_str()));
  const auto end = Clock::now() + std::chrono::milliseconds(std::int64_t(seconds * 1000));
  constexpr std::chrono::milliseconds kLook{50};
  while (g_ended == 0 && session.connection.client().connected()) {
    if (seconds > 0 && Clock::now() >= end)
      return kExitOk;
    session.connection.client().await(kLook);
    while (session.connection.client().nextEvent()) {
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      const std::string &file = session.watched[2 * i + 1];
      const FileState now = stateOf(file.c_str());
      if (now == states[i] || !now.exists || now.size == 0)
        continue;
      states[i] = now;
      (void)setText(session, session.watched[2 * i], file);
    }
  }
  if (g_ended == 0)
    return fail(
        {kExitUsage, "process " + std::to_string(session.connection.process()) + " has ended"});
  return kExitOk;
}

/// Runs the lines of standard input, one action each.
int runLines(Session &session) {
  int worst = kExitOk;
  std::string line;
  while (g_ended == 0 && std::getline(std::cin, line)) {
    std::istringstream stream(line);
    Words words;
    for (std::string word; stream >> word;)
      words.push_back(word);
    if (words.empty() || words[0][0] == '#')
      continue;
    session.output.clear();
    if (words.size() > 2 && words[words.size() - 2] == "-o") {
      session.output = words.back();
      words.resize(words.size() - 2);
    }
    const int code = runAction(session, words);
    std::fflush(stdout);
    worst = worst == kExitOk ? code : worst;
    if (!session.connection.client().connected())
      return fail({kExitUsage, "the process has ended"});
  }
  return worst;
}

} // namespace

std::string ctlActions() {
  std::string text;
  for (const ActionRow &row : actions()) {
    std::string usage = "  " + std::string(row.name) + " " + row.operands;
    usage.resize(std::max<std::size_t>(usage.size() + 1, 30), ' ');
    text += usage + row.help + "\n";
  }
  return text;
}

int controlProcess(const CtlArguments &arguments) {
  if (arguments.words[0] == "list" && arguments.words.size() == 1)
    return listProcesses(arguments.json);
  const bool lines = arguments.words[0] == "-" && arguments.words.size() == 1;
  if (!lines && !findAction(arguments.words[0]))
    return kExitUsage;
  auto opened = Connection::open(pid_t(arguments.process),
                                 std::chrono::milliseconds(std::int64_t(arguments.timeout * 1000)));
  if (!opened)
    return fail(opened.error());
  endAtSignals();
  Session session{*opened.value(), arguments.json, arguments.output, false, {}, 0};
  if (lines)
    return runLines(session);
  const int code = runAction(session, arguments.words);
  if (code != kExitOk || !session.changed)
    return code;
  complain(arguments.holdSeconds > 0 ? "held for a while"
                                     : "held until this ends (Ctrl+C); then it is undone");
  return hold(session, arguments.holdSeconds);
}

} // namespace arbiter::tools
