#include "apps/tools/ctl/actions.h"

#include <algorithm>
#include <cstdio>
#include <thread>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "util/suggest.h"

namespace arbiter::tools::ctl {

namespace {

int waitSeconds(Session &session, const Words &words) {
  char *end = nullptr;
  const double seconds = std::strtod(words[0].c_str(), &end);
  if (end == words[0].c_str() || *end != '\0' || !(seconds >= 0) || seconds > 86400)
    return fail({kExitUsage, "wait takes a number of seconds, not " + words[0]});
  const auto until =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(std::int64_t(seconds * 1000));
  wire::Client &client = session.connection.client();
  while (client.awaitUntil(until)) {
  }
  return client.connected() ? int(kExitOk) : fail({kExitUsage, "the process has ended"});
}

constexpr std::size_t kAny = 64;
constexpr ActionRow kActions[] = {
    {"programs", "", 0, 0, listPrograms,
     "the programs that are loaded, and a quarter second's draws"},
    {"get", "ID", 1, 1, getText, "the text that is drawn with"},
    {"set", "ID FILE", 2, 2, setProgram, "draws with that text, and with what it becomes"},
    {"reset", "[ID]", 0, 1, resetPrograms, "the application's own text again"},
    {"enable", "ID", 1, 1, enableProgram, "switches a program on again"},
    {"disable", "ID", 1, 1, disableProgram, "draws as if its target were not enabled"},
    {"params", "[ID]", 0, 1, listParameters, "what programs read, and the values"},
    {"param", "ID NAME=X,Y,Z,W..", 2, kAny, setParameter, "holds values of parameters"},
    {"textures", "", 0, 0, listTextures, "what is bound where the frame ends"},
    {"texture", "NAME [FILE.png]", 1, 2, getTexture, "a texture as a small PNG (-o)"},
    {"paint", "NAME FILE.png", 2, 2, setTexture, "puts a picture in a texture's place"},
    {"frame", "", 0, 0, takeFrame, "the frame as PNG (-o)"},
    {"pick", "X,Y[@FRAMEBUFFER]", 1, 1, pickDraws,
     "the draws that write a pixel (from the lower left) of the window, or of an object"},
    {"trace", "X,Y[@FRAMEBUFFER] [DRAW]", 1, 2, tracePixel,
     "what the program of its last draw computes there"},
    {"measure", "", 0, 0, measureFrame, "pixels and milliseconds of each program in one frame"},
    {"stats", "", 0, 0, showStats, "figures"},
    {"export", "FOLDER", 1, 1, exportFolder, "texts as a folder for arbiter run --replace"},
    {"wait", "SECONDS", 1, 1, waitSeconds, "does nothing for so long"},
};

} // namespace

std::span<const ActionRow> actions() { return kActions; }

int fail(const Failure &failure) {
  complain(failure.message);
  return failure.code;
}

void printJson(const wire::Json &answer) {
  std::printf("%s\n", answer.dump(2, ' ', false, wire::Json::error_handler_t::replace).c_str());
}

const ActionRow *findAction(const std::string &name) {
  const auto *const row = std::find_if(std::begin(kActions), std::end(kActions),
                                       [&](const ActionRow &each) { return name == each.name; });
  if (row != std::end(kActions))
    return row;
  std::vector<std::string_view> names = {"list"};
  for (const ActionRow &each : kActions)
    names.emplace_back(each.name);
  const std::string_view near = nearest(name, names);
  complain("no action " + name + (near.empty() ? "" : "; did you mean " + std::string(near) + "?") +
           " (arbiter ctl --help)");
  return nullptr;
}

int runAction(Session &session, const Words &words) {
  const ActionRow *const row = findAction(words[0]);
  if (!row)
    return kExitUsage;
  Words rest(words.begin() + 1, words.end());
  if (rest.size() < row->least || rest.size() > row->most)
    return fail({kExitUsage, "usage: arbiter ctl " + std::string(row->name) +
                                 (*row->operands == '\0' ? "" : " ") + row->operands});
  const std::string_view operands = row->operands;
  if (!rest.empty() && (operands.starts_with("ID") || operands.starts_with("[ID"))) {
    const auto id = wholeId(session, rest[0]);
    if (!id)
      return fail(id.error());
    rest[0] = id.value();
  }
  return row->run(session, rest);
}

int show(Session &session, Result<wire::Json, Failure> answer,
         const std::function<void(const wire::Json &)> &print) {
  if (!answer)
    return fail(answer.error());
  session.json ? printJson(answer.value()) : print(answer.value());
  return kExitOk;
}

std::string textAt(const wire::Json &object, const char *name) {
  const auto found = object.find(name);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::vector<wire::Json> objectsAt(const wire::Json &object, const char *name) {
  std::vector<wire::Json> objects;
  if (const auto found = object.find(name); found != object.end() && found->is_array())
    std::copy_if(found->begin(), found->end(), std::back_inserter(objects),
                 [](const wire::Json &each) { return each.is_object(); });
  return objects;
}

int showStats(Session &session, const Words &) {
  return show(session, session.connection.ask("stats", wire::Json::object()), printJson);
}

} // namespace arbiter::tools::ctl
