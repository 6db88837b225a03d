// Shows and changes programs' texts and parameters.
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "apps/tools/commands.h"
#include "apps/tools/ctl/actions.h"
#include "apps/tools/input.h"
#include "control/base64.h"

namespace arbiter::tools::ctl {

namespace {

using wire::Json;

/// The time during which draws are counted before they are shown.
constexpr std::chrono::milliseconds kCounted{250};

bool trueAt(const Json &object, const char *name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_boolean() && found->get<bool>();
}

std::int64_t integerAt(const Json &object, const char *name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : 0;
}

double numberAt(const Json &object, const char *name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_number() ? found->get<double>() : 0;
}

/// Returns the text that is drawn with, from an answer to program.get.
std::string drawnText(const Json &answer) {
  if (std::string edit = textAt(answer, "edit"); !edit.empty())
    return edit;
  if (const auto bytes = wire::fromBase64(textAt(answer, "text_base64")); bytes && !bytes->empty())
    return {bytes->begin(), bytes->end()};
  return textAt(answer, "text");
}

/// Sends a request and ignores its result.
int request(Session &session, const std::string &method, Json params) {
  auto answer = session.connection.ask(method, std::move(params));
  session.changed = session.changed || answer;
  return show(session, std::move(answer), [](const Json &) {});
}

void printDiagnostics(const std::string &file, const Json &answer) {
  for (const Json &each : objectsAt(answer, "diagnostics")) {
    std::fprintf(stderr, "%s:%lld:%lld: %s: %s [%s]\n", file.c_str(),
                 static_cast<long long>(integerAt(each, "line")),
                 static_cast<long long>(integerAt(each, "column")),
                 textAt(each, "severity").c_str(), textAt(each, "message").c_str(),
                 textAt(each, "id").c_str());
    if (const std::string hint = textAt(each, "hint"); !hint.empty())
      std::fprintf(stderr, "  %s\n", hint.c_str());
  }
}

/// Parses NAME=X,Y,Z,W; missing components are 0, as in `arbiter draw`.
bool parseValue(const std::string &word, std::string &name, Json &value) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos)
    return false;
  name = word.substr(0, equals);
  double numbers[4] = {};
  const char *at = word.c_str() + equals + 1;
  for (double &number : numbers) {
    char *end = nullptr;
    number = std::strtod(at, &end);
    if (end == at)
      return false;
    if (*end == '\0') {
      value = Json::array({numbers[0], numbers[1], numbers[2], numbers[3]});
      return true;
    }
    if (*end != ',')
      return false;
    at = end + 1;
  }
  return false;
}

/// True if a name from the process, which may be hostile, stays in its folder.
bool isFileName(const std::string &name) {
  return !name.empty() && name.find('/') == std::string::npos && name[0] != '.';
}

} // namespace

Result<std::string, Failure> wholeId(Session &session, const std::string &word) {
  constexpr std::size_t kDigits = 32;
  const std::size_t dot = std::min(word.find('.'), word.size());
  const std::string stem = word.substr(0, dot), ending = word.substr(dot);
  if (stem.size() == kDigits && !ending.empty())
    return word;
  const auto list = session.connection.ask("program.list", Json::object());
  if (!list)
    return list.error();
  std::vector<std::string> found;
  for (const Json &row : objectsAt(list.value(), "programs"))
    if (const std::string id = textAt(row, "id");
        !stem.empty() && id.starts_with(stem) && id.ends_with(ending))
      found.push_back(id);
  if (found.size() == 1)
    return found.front();
  if (found.empty())
    return Failure{kExitUsage, "there is no program " + word + " (arbiter ctl programs)"};
  std::string all;
  for (const std::string &id : found)
    all += (all.empty() ? "" : ", ") + id;
  return Failure{kExitUsage, "several programs begin with " + word + ": " + all};
}

int listPrograms(Session &session, const Words &) {
  // The process counts draws only since its first client connected.
  session.connection.awaitAge(kCounted);
  auto listed = session.connection.ask("program.list", Json::object());
  return show(session, std::move(listed), [](const Json &answer) {
    std::printf("%-38s %-12s %7s %7s %9s %10s  %s\n", "ID", "TARGET", "SLOTS", "NATIVE", "DRAWS",
                "MS", "STATE");
    for (const Json &row : objectsAt(answer, "programs")) {
      const auto instructions = [&](const char *counts) {
        const auto found = row.find(counts);
        return found != row.end() && found->is_object() ? integerAt(*found, "instructions") : 0;
      };
      std::string state = trueAt(row, "effective") ? "drawn with"
                          : trueAt(row, "bound")   ? "bound"
                                                   : "";
      for (const auto &[name, word] :
           {std::pair("edited", "edited"), std::pair("replaced", "replaced")})
        if (trueAt(row, name))
          state += (state.empty() ? "" : ", ") + std::string(word);
      if (!trueAt(row, "enabled"))
        state += (state.empty() ? "" : ", ") + std::string("off");
      if (!trueAt(row, "under_native_limits"))
        state += (state.empty() ? "" : ", ") + std::string("over native limits");
      std::printf("%-38s %-12s %7lld %7lld %9lld %10.2f  %s\n", textAt(row, "id").c_str(),
                  textAt(row, "target").c_str(), static_cast<long long>(instructions("counts")),
                  static_cast<long long>(instructions("native_counts")),
                  static_cast<long long>(integerAt(row, "draws")), numberAt(row, "milliseconds"),
                  state.c_str());
    }
  });
}

int getText(Session &session, const Words &words) {
  const auto answer = session.connection.ask("program.get", {{"id", words[0]}});
  if (!answer)
    return fail(answer.error());
  if (session.json) {
    printJson(answer.value());
    return kExitOk;
  }
  const std::string fault =
      writeOutput(session.output.empty() ? "-" : session.output, drawnText(answer.value()));
  return fault.empty() ? int(kExitOk) : fail({kExitUsage, fault});
}

int setText(Session &session, const std::string &id, const std::string &file) {
  const auto text = readInput(file);
  if (!text)
    return fail({kExitUsage, text.error().message});
  const auto answer = session.connection.ask(
      "program.set", {{"id", id}, {"text", text.value()}, {"revision", ++session.revision}});
  if (!answer)
    return fail(answer.error());
  session.changed = true;
  if (session.json)
    printJson(answer.value());
  printDiagnostics(file, answer.value());
  if (trueAt(answer.value(), "ok"))
    return kExitOk;
  complain(file + " is not valid; what was drawn with before stays");
  return kExitInvalid;
}

int setProgram(Session &session, const Words &words) {
  const int code = setText(session, words[0], words[1]);
  if (code == kExitOk && words[1] != "-")
    session.watched.insert(session.watched.end(), {words[0], words[1]});
  return code;
}

int resetPrograms(Session &session, const Words &words) {
  Json params = Json::object();
  if (!words.empty()) {
    params["id"] = words[0];
    for (std::size_t i = 0; i < session.watched.size();)
      if (session.watched[i] == words[0])
        session.watched.erase(session.watched.begin() + std::ptrdiff_t(i),
                              session.watched.begin() + std::ptrdiff_t(i) + 2);
      else
        i += 2;
  } else {
    session.watched.clear();
    for (const char *method : {"param.reset", "texture.reset"})
      if (const int code = request(session, method, Json::object()); code != kExitOk)
        return code;
  }
  return request(session, "program.reset", std::move(params));
}

int enableProgram(Session &session, const Words &words) {
  return request(session, "program.enable", {{"id", words[0]}, {"enabled", true}});
}

int disableProgram(Session &session, const Words &words) {
  return request(session, "program.enable", {{"id", words[0]}, {"enabled", false}});
}

int listParameters(Session &session, const Words &words) {
  Json params = Json::object();
  if (!words.empty())
    params["id"] = words[0];
  auto listed = session.connection.ask("param.list", std::move(params));
  return show(session, std::move(listed), [](const Json &answer) {
    for (const Json &row : objectsAt(answer, "parameters"))
      std::printf("%-38s %-32s %s%s\n", textAt(row, "id").c_str(), textAt(row, "name").c_str(),
                  row.value("value", Json()).dump().c_str(), trueAt(row, "held") ? "  held" : "");
  });
}

int setParameter(Session &session, const Words &words) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    std::string name;
    Json value;
    if (!parseValue(words[i], name, value))
      return fail(
          {kExitUsage, "expected NAME=X,Y,Z,W, as program.local[0]=0.5,1,0,1, not " + words[i]});
    const int code =
        request(session, "param.set", {{"id", words[0]}, {"name", name}, {"value", value}});
    if (code != kExitOk)
      return code;
  }
  return kExitOk;
}

int exportFolder(Session &session, const Words &words) {
  const auto list = session.connection.ask("program.list", Json::object());
  if (!list)
    return fail(list.error());
  std::error_code error;
  std::filesystem::create_directory(words[0], error);
  if (error)
    return fail({kExitUsage, words[0] + ": " + error.message()});
  std::size_t own = 0, edited = 0;
  for (const Json &row : objectsAt(list.value(), "programs")) {
    const std::string id = textAt(row, "id");
    if (!isFileName(id))
      continue;
    const auto program = session.connection.ask("program.get", {{"id", id}});
    if (!program)
      return fail(program.error());
    ++(textAt(program.value(), "edit").empty() ? own : edited);
    const std::string fault = writeOutput(words[0] + "/" + id, drawnText(program.value()));
    if (!fault.empty())
      return fail({kExitUsage, fault});
  }
  std::printf("%s: %zu edited, %zu as the application has them\n"
              "arbiter run --replace %s -- COMMAND draws with them\n",
              words[0].c_str(), edited, own, words[0].c_str());
  return kExitOk;
}

} // namespace arbiter::tools::ctl
