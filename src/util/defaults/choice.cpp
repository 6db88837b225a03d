#include "util/defaults/choice.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <sys/auxv.h>
#include <utility>

#include "util/defaults/folders.h"
#include "util/thread.h"

namespace arbiter::defaults {

namespace {

/// Evaluates conditions for a program. Its file is hashed at most once, and only if all other
/// conditions hold.
class Matcher {
public:
  explicit Matcher(const Program &program) : m_program(program) {}

  /// Returns why the entry applies to the program; nothing if it does not.
  std::optional<std::string> why(const Match &match) {
    std::string held;
    if (!holds(match.names, m_program.name, "name", false, held) ||
        !holds(match.windows, m_program.windows, "windows", true, held) ||
        !pathHolds(match.paths, held))
      return std::nullopt;
    if (!match.hashes.empty() && !holds(match.hashes, hash(), "xxh128", false, held))
      return std::nullopt;
    return held;
  }

private:
  static bool holds(const std::vector<std::string> &patterns, const std::string &text,
                    const char *key, bool anyCase, std::string &held) {
    if (patterns.empty())
      return true;
    if (text.empty() || std::none_of(patterns.begin(), patterns.end(), [&](const auto &pattern) {
          return matches(pattern, text, anyCase);
        }))
      return false;
    held += std::string(held.empty() ? "" : ", ") + key + " " + text;
    return true;
  }

  /// The pattern may match either file: the one that runs, or the Windows program that it runs.
  bool pathHolds(const std::vector<std::string> &patterns, std::string &held) const {
    return holds(patterns, m_program.file(), "path", false, held) ||
           holds(patterns, m_program.path, "path", false, held);
  }

  const std::string &hash() {
    if (!m_hash)
      m_hash = hashOfFile(m_program.file());
    return *m_hash;
  }

  const Program &m_program;
  std::optional<std::string> m_hash;
};

Choice readOwn(const std::string &shipped) {
  if (::getauxval(AT_SECURE) != 0)
    return {};
  const Facts facts = ownFacts();
  std::vector<File> files = readFolders(folders(shipped, facts.environment));
  return choose(programOf(facts), std::move(files), facts.environment);
}

std::atomic<const Choice *> g_own = nullptr;

} // namespace

std::string Setting::place() const { return entry->file + ":" + std::to_string(value->line); }

const Setting *Choice::find(Env variable) const {
  for (const Setting &setting : settings)
    if (setting.key->variable == variable)
      return &setting;
  return nullptr;
}

Choice choose(Program program, std::vector<File> files,
              const std::function<const char *(const char *)> &environment) {
  Choice choice{std::move(program), std::move(files), {}, {}};
  Matcher matcher(choice.program);
  for (const File &file : choice.files)
    for (const Entry &entry : file.entries)
      if (std::optional<std::string> why = matcher.why(entry.match))
        choice.entries.push_back({&entry, std::move(*why)});
  for (const Key &key : keys()) {
    Setting last;
    for (const Chosen &chosen : choice.entries)
      for (const Value &value : chosen.entry->values)
        if (value.variable == key.variable)
          last = {&key, &value, chosen.entry};
    if (last.key == nullptr)
      continue;
    last.used = environment(info(key.variable).name) == nullptr;
    choice.settings.push_back(last);
  }
  return choice;
}

const Choice &ownChoice(const std::string &shipped) {
  static const Choice *const s_own = [&] {
    const NoCancel scope; // files are opened on the application's thread
    const auto *const own = new Choice(readOwn(shipped));
    g_own.store(own, std::memory_order_release);
    return own;
  }();
  return *s_own;
}

const Choice *ownChoiceIfRead() noexcept { return g_own.load(std::memory_order_acquire); }

} // namespace arbiter::defaults
