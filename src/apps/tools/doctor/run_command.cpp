#include <GL/arbiter.h>
#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sys/wait.h>
#include <unistd.h>

#include "apps/tools/doctor/finding.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/child.h"
#include "apps/tools/launch/in_layer.h"
#include "apps/tools/launch/shell_text.h"
#include "apps/tools/temporary_folder.h"
#include "util/record/live_record.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr auto kPoll = std::chrono::milliseconds(20);
constexpr auto kGrace = std::chrono::seconds(2); // the delay between SIGTERM and SIGKILL

struct End {
  int status = 0;        ///< result of waitpid()
  bool timedOut = false; ///< true if it was ended after the time limit
};

/// Runs the command in its own process group, so that its children end with it.
End runFor(const std::vector<Assignment> &environment, const std::vector<std::string> &command,
           double seconds) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setpgid(0, 0);
    ::dup2(STDERR_FILENO, STDOUT_FILENO); // standard output is reserved for the report
    ::_exit(execute(environment, command));
  }
  End end;
  if (child < 0)
    return end;
  ::setpgid(child, child);
  const auto patience = std::chrono::milliseconds(std::int64_t(seconds * 1000));
  const auto limit = Clock::now() + patience;
  // Processes that a launcher left behind run until the time is over.
  if (awaitChild(child, patience, end.status)) {
    while (::kill(-child, 0) == 0 && Clock::now() < limit)
      ::usleep(useconds_t(std::chrono::microseconds(kPoll).count()));
    ::kill(-child, SIGTERM);
    return end;
  }
  end.timedOut = true;
  ::kill(-child, SIGTERM);
  if (!awaitChild(child, kGrace, end.status)) {
    ::kill(-child, SIGKILL);
    static_cast<void>(awaitChild(child, kGrace, end.status));
  }
  return end;
}

/// Summarizes what the processes of a run reported.
struct Report {
  int contexts = 0, offered = 0;
  std::string names;                   ///< names of programs that made contexts
  std::string obstacle;                ///< of a context without the layer's programs
  std::set<std::string> refused;       ///< hashes of programs that only the profile refuses
  std::string profile, reason, remedy; ///< of the first refused program
};

void readRefused(const Json &statistics, Report &report) {
  for (const Json &program : statistics.value("programs", Json::array())) {
    const Json error = program.value("error", Json());
    if (!error.is_object() || !error.contains("refused_by_profile"))
      continue;
    const Json &refusal = error["refused_by_profile"];
    if (report.refused.empty()) {
      report.profile = statistics.value("profile", "");
      report.reason = refusal.value("reason", "");
      report.remedy = refusal.value("remedy", "");
    }
    report.refused.insert(program.value("target", "") + " " + program.value("hash", ""));
  }
}

void read(const Json &statistics, Report &report) {
  const Json contexts = statistics.value("contexts", Json::array());
  if (contexts.empty())
    return;
  std::string name = "?";
  if (const Json defaults = statistics.value("defaults", Json()); defaults.is_object())
    name = defaults["program"].value("windows", Json()).is_string()
               ? defaults["program"].value("windows", "?")
               : defaults["program"].value("name", "?");
  if (report.names.find(name) == std::string::npos)
    report.names += (report.names.empty() ? "" : ", ") + name;
  readRefused(statistics, report);
  for (const Json &context : contexts) {
    ++report.contexts;
    report.offered += context.value("offered", false) ? 1 : 0;
    if (context.contains("obstacle"))
      report.obstacle = context.value("obstacle", "");
  }
}

Report readReports(const std::string &folder) {
  Report report;
  std::error_code error;
  for (const auto &each : fs::directory_iterator(folder, error)) {
    std::ifstream stream(each.path());
    const Json statistics = Json::parse(stream, nullptr, false);
    if (statistics.is_object())
      read(statistics, report);
  }
  return report;
}

std::string howItEnded(const End &end) {
  if (end.timedOut)
    return "was ended when its time was over";
  if (WIFSIGNALED(end.status))
    return std::string("was ended by a signal (") + ::strsignal(WTERMSIG(end.status)) + ")";
  return "ended with exit status " + std::to_string(WEXITSTATUS(end.status));
}

void dropDisproved(Examination &examination) {
  std::erase_if(examination.findings, [](const Finding &each) {
    return each.level == Level::Possible || each.id == "no_gl" || each.id == "vulkan_only" ||
           each.id == kIndirect;
  });
}

void addRefused(Examination &examination, const CommandFile &command, const Report &report) {
  if (report.refused.empty())
    return;
  const std::size_t count = report.refused.size();
  examination.add({"refused", Level::Possible, command.path,
                   "The profile " + report.profile + " refuses " + std::to_string(count) +
                       (count == 1 ? " program" : " programs") + " that the profile host loads (" +
                       (count == 1 ? "" : "the first at ") + report.reason +
                       "): what is drawn with " + (count == 1 ? "it" : "them") +
                       " may look different.",
                   "If something looks wrong, load " + std::string(count == 1 ? "it" : "them") +
                       " (" + report.remedy + "): `arbiter run " +
                       report.remedy.substr(0, report.remedy.find(" or ")) + " -- " +
                       shellLine(command.words) + "`."});
}

std::string remedyWithoutContext(const Examination &examination) {
  if (examination.has("no_gl"))
    return "Name the program that draws.";
  for (const Finding &each : examination.findings)
    if (each.id == kNoDisplay)
      return each.what + " " + each.remedy;
  return "Give it longer (--for), and the window that it may ask for first; what else stands here "
         "may be why.";
}

void add(Examination &examination, const CommandFile &command, const Report &report,
         const End &end) {
  const std::string ran = "It ran, and " + howItEnded(end);
  if (report.contexts == 0) {
    examination.add({"no_context", Level::Obstacle, command.path,
                     ran + "; no process of it made a GL context through the layer.",
                     remedyWithoutContext(examination)});
    std::erase_if(examination.findings, [](const Finding &each) { return each.id == kNoDisplay; });
    return;
  }
  dropDisproved(examination);
  const std::string made = report.names + " made " + std::to_string(report.contexts) +
                           (report.contexts == 1 ? " context" : " contexts");
  if (report.offered != 0) {
    examination.add({"reached",
                     Level::Note,
                     command.path,
                     ran + "; " + made + " through the layer, " + std::to_string(report.offered) +
                         " of them with its programs.",
                     {}});
    addRefused(examination, command, report);
    return;
  }
  if (report.obstacle.find("indirect") != std::string::npos)
    examination.add({kIndirect, Level::Obstacle, command.path,
                     ran + "; " + made + ", and " + report.obstacle + ".", kDirectRemedy});
  else if (report.obstacle.find("older") != std::string::npos ||
           report.obstacle.find("GLSL") != std::string::npos)
    examination.add(
        {"old_driver", Level::Obstacle, command.path,
         ran + "; " + made + ", and the layer can do nothing there: " + report.obstacle + ".",
         "Install a newer driver, or draw on the processor: LIBGL_ALWAYS_SOFTWARE=1 "
         "with Mesa."});
  else
    examination.add({"core_profile", Level::Obstacle, command.path,
                     ran + "; " + made +
                         " of the core profile or of OpenGL ES, which have no programs in "
                         "assembly: they pass through the layer.",
                     "If it has a renderer for OpenGL 2 or older, choose that."});
}

} // namespace

void runAndLook(Examination &examination, const CommandFile &command, const RunSettings &settings) {
  const TemporaryFolder folder("arbiter-doctor");
  const auto fail = [&](const std::string &why) {
    examination.add({"not_run", Level::Obstacle, command.path, "It was not run: " + why + ".", {}});
  };
  if (folder.path().empty())
    return fail(std::string("no folder for the statistics: ") + std::strerror(errno));
  LayerArguments arguments;
  arguments.library = settings.library;
  arguments.stats = folder.path() + "/%p.json";
  const auto launch = layerLaunch(arguments);
  if (!launch)
    return fail(launch.error().message);
  const End end = runFor(launch.value().environment, command.words, settings.seconds);
  static_cast<void>(completeRecords(arguments.stats));
  add(examination, command, readReports(folder.path()), end);
}

} // namespace arbiter::tools::doctor
