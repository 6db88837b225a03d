#include "apps/tools/complete/candidates.h"

#include <sstream>

#include "apps/tools/ctl/actions.h"
#include "apps/tools/draw/gallery.h"
#include "apps/tools/draw/options.h"
#include "fp_compiler/hw/names.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::complete {

namespace {

constexpr std::chrono::milliseconds kPatience{500};

} // namespace

Candidates profiles() {
  Candidates found;
  for (const std::string_view name : fp::hw::builtinNames()) {
    const std::string &help = fp::hw::findBuiltin(name)->description;
    found.push_back({std::string(name), help});
    for (const std::string_view alias : fp::hw::aliasesOf(name))
      found.push_back({std::string(alias), help});
  }
  return found;
}

Candidates gallery() {
  Candidates found;
  for (const std::string &name : galleryNames())
    found.push_back({kGalleryScheme + name, "a document of the gallery"});
  return found;
}

Candidates images() {
  Candidates found;
  for (const std::string_view word : generatorWords())
    found.push_back({std::string(word),
                     std::string(scene::rowOf(*scene::findWord<scene::Generator>(word)).meaning)});
  return found;
}

Candidates actions() {
  Candidates found = {{"list", "the processes that listen"},
                      {"-", "actions from standard input, a line each"}};
  for (const ctl::ActionRow &row : ctl::actions())
    found.push_back({row.name, row.help});
  return found;
}

Candidates processes() {
  Candidates found;
  if (const auto folder = control::socketFolder())
    for (const control::Listener &each : control::findListeners(folder.value()))
      found.push_back({std::to_string(each.process), "a process that listens"});
  return found;
}

Candidates programs(int process) {
  Candidates found;
  auto opened = ctl::Connection::open(pid_t(process), kPatience);
  if (!opened)
    return found;
  const auto answer = opened.value()->ask("program.list", control::Json::object());
  if (!answer || !answer.value().is_object())
    return found;
  const auto rows = answer.value().find("programs");
  if (rows == answer.value().end() || !rows->is_array())
    return found;
  for (const control::Json &row : *rows)
    if (row.is_object() && row.contains("id") && row["id"].is_string())
      found.push_back({row["id"].get<std::string>(), row.value("target", std::string())});
  return found;
}

std::string operandOf(std::string_view action, std::size_t number) {
  for (const ctl::ActionRow &row : ctl::actions()) {
    if (action != row.name)
      continue;
    std::istringstream words(row.operands);
    std::string word;
    while (words >> word)
      if (number-- == 0)
        return word.front() == '[' ? word.substr(1, word.find(']') - 1) : word;
  }
  return {};
}

} // namespace arbiter::tools::complete
