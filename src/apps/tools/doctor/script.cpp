#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <unistd.h>

#include "apps/tools/doctor/finding.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxScript = 1u << 20; // a longer script is an installer that contains its
                                             // data

using Words = std::vector<std::string>;

/// Splits a shell line into commands, and each command into words. Removes quotes, but keeps
/// variables and substitutions.
std::vector<Words> commandsOf(const std::string &line) {
  std::vector<Words> commands(1);
  std::string word;
  char quote = 0;
  int depth = 0; // nesting of $( )
  bool any = false;
  const auto end = [&] {
    if (any)
      commands.back().push_back(word);
    word.clear();
    any = false;
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (c == '$' && i + 1 < line.size() && line[i + 1] == '(')
      ++depth;
    if (c == ')' && depth > 0)
      --depth;
    if (depth == 0 && quote == 0 && c == '#' && !any)
      break;
    if (depth == 0 && (c == '"' || c == '\'') && (quote == 0 || quote == c)) {
      quote = quote == 0 ? c : char(0);
      any = true;
      continue;
    }
    const bool separates = c == ';' || c == '&' || c == '|';
    if (quote == 0 && depth == 0 && (separates || std::isspace(static_cast<unsigned char>(c)))) {
      end();
      if (separates && !commands.back().empty())
        commands.emplace_back();
      continue;
    }
    word += c;
    any = true;
  }
  end();
  if (commands.back().empty())
    commands.pop_back();
  return commands;
}

bool isNumber(const std::string &word) {
  return std::all_of(word.begin(), word.end(),
                     [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; });
}

bool isAssignment(const std::string &word) {
  const std::size_t equal = word.find('=');
  return equal != std::string::npos && equal > 0 &&
         std::all_of(word.begin(), word.begin() + std::ptrdiff_t(equal), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
         });
}

/// Tracks the values of a script's variables as far as its text shows them.
class Variables {
public:
  explicit Variables(const fs::path &script) : m_script(script), m_folder(script.parent_path()) {}

  void set(const std::string &assignment) {
    const std::size_t equal = assignment.find('=');
    if (const std::optional<std::string> value = expanded(assignment.substr(equal + 1)))
      m_values[assignment.substr(0, equal)] = *value;
  }

  /// Returns a word with its variables and substitutions replaced, or nothing if a value is
  /// unknown.
  [[nodiscard]] std::optional<std::string> expanded(const std::string &word) const {
    std::string text;
    for (std::size_t i = 0; i < word.size();) {
      if (word[i] != '$' && word[i] != '`') {
        text += word[i++];
        continue;
      }
      const std::size_t end = endOf(word, i);
      const std::optional<std::string> value = valueOf(word.substr(i, end - i), end, word);
      if (!value)
        return std::nullopt;
      text += *value;
      i = end;
    }
    return text;
  }

private:
  /// Returns the end of the substitution or variable that begins at `at`.
  static std::size_t endOf(const std::string &word, std::size_t at) {
    const char open = word[at] == '`' ? '`' : at + 1 < word.size() ? word[at + 1] : char(0);
    if (open == '`')
      return std::min(word.find('`', at + 1), word.size() - 1) + 1;
    if (open == '{')
      return std::min(word.find('}', at), word.size() - 1) + 1;
    std::size_t end = at + 1;
    if (open == '(') {
      int depth = 0;
      for (; end < word.size(); ++end) {
        depth += word[end] == '(' ? 1 : word[end] == ')' ? -1 : 0;
        if (depth == 0)
          return end + 1;
      }
      return end;
    }
    while (end < word.size() &&
           (std::isalnum(static_cast<unsigned char>(word[end])) || word[end] == '_'))
      ++end;
    return std::max(end, std::min(at + 2, word.size())); // at least two characters, for $@ and $*
  }

  [[nodiscard]] std::optional<std::string> valueOf(const std::string &part, std::size_t end,
                                                   const std::string &word) const {
    if (part == "$0")
      return m_script.string();
    if (part[0] == '`' || part.starts_with("$(")) {
      // Scripts run such commands to find their own folder.
      for (const char *const own : {"dirname", "pwd", "realpath", "readlink"})
        if (part.find(own) != std::string::npos)
          return part.find("dirname") == std::string::npos && part.find("pwd") == std::string::npos
                     ? m_script.string()
                     : m_folder.string();
      return std::nullopt;
    }
    if (part.starts_with("${0"))
      return part == "${0}" ? m_script.string() : m_folder.string();
    std::string name = part.substr(part.starts_with("${") ? 2 : 1);
    if (name.ends_with('}'))
      name.pop_back();
    if (const auto known = m_values.find(name); known != m_values.end())
      return known->second;
    // An unknown variable at the start of "$HERE/game" is usually the script's folder.
    const bool first = word.find_first_of("$`") == end - part.size() && end == part.size();
    return first && end < word.size() && word[end] == '/' ? std::optional(m_folder.string())
                                                          : std::nullopt;
  }

  fs::path m_script;
  fs::path m_folder;
  std::map<std::string, std::string> m_values;
};

bool isProgram(const std::string &path) {
  std::error_code error;
  return !path.empty() && fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// Words before a command that run it, or that belong to the shell's syntax.
constexpr std::string_view kPassing[] = {"exec", "env",  "nohup", "nice", "setsid",
                                         "time", "then", "else",  "do",   "command"};
/// Commands that are never a script's purpose.
constexpr std::string_view kOwn[] = {
    "cd",     "export",  "if",       "[",        "test",   "unset", "set",  "echo",
    "local",  "while",   "for",      "case",     "fi",     "done",  "esac", "return",
    "exit",   "trap",    "shift",    "read",     "source", ".",     "{",    "}",
    "true",   "false",   "mkdir",    "rm",       "cp",     "cat",   "grep", "sed",
    "printf", "dirname", "basename", "readlink", "uname",  "sleep", "kill", "pushd",
    "popd",   "ulimit",  "chmod",    "which",    "ldd",    "awk",   "cut",  "tr"};

template <std::size_t N> bool isOne(const std::string &word, const std::string_view (&words)[N]) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// How likely a command is the script's purpose. Among equal ranks the last command counts.
enum class Rank { None, Bare, Path, Exec };

struct Started {
  std::vector<std::string> words; ///< the command's words, without prefixes
  bool exec = false;
};

Started commandOf(const Words &line, Script &script, Variables &variables) {
  Started started;
  std::size_t at = 0;
  bool passing = false;
  for (; at < line.size(); ++at) {
    const std::string &word = line[at];
    if (word == "exec")
      started.exec = true;
    if (word == "-i" && passing)
      script.clearsPreload = true;
    if (isAssignment(word)) {
      variables.set(word);
      script.clearsPreload = script.clearsPreload || word == "LD_PRELOAD=";
      script.libraryPath = script.libraryPath || word.starts_with("LD_LIBRARY_PATH=");
    } else if (isOne(word, kPassing)) {
      passing = true;
    } else if (!passing || (!word.starts_with("-") && !isNumber(word))) { // as in: nice -n 5
      break;
    }
  }
  started.words.assign(line.begin() + std::ptrdiff_t(at), line.end());
  return started;
}

void lookAtVariables(const Words &line, Script &script, Variables &variables) {
  const bool declares = line[0] == "export" || line[0] == "local" || line[0] == "readonly";
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (declares && isAssignment(line[i]))
      variables.set(line[i]);
    if (line[i] == "LD_PRELOAD" && line[0] == "unset")
      script.clearsPreload = true;
    // A value that does not contain the previous one loses the layer.
    if (line[i].starts_with("LD_PRELOAD=") && line[i].find("$LD_PRELOAD") == std::string::npos &&
        line[i].find("${LD_PRELOAD") == std::string::npos)
      script.clearsPreload = true;
    if (line[i].starts_with("LD_LIBRARY_PATH="))
      script.libraryPath = true;
  }
}

} // namespace

std::string sandboxedApplication(const std::vector<std::string> &words) {
  auto at = std::find(words.begin(), words.end(), "run");
  if (at == words.end())
    return {};
  for (++at; at != words.end(); ++at)
    if (!at->starts_with("-"))
      return *at;
  return {};
}

namespace {

/// Processes a script's commands one after the other.
class Reader {
public:
  explicit Reader(const std::string &path)
      : m_folder(fs::path(path).parent_path()), m_variables(path) {}

  void read(const Words &words) {
    lookAtVariables(words, script, m_variables);
    const Started started = commandOf(words, script, m_variables);
    if (started.words.empty() || isOne(started.words[0], kOwn) || !script.sandbox.empty())
      return;
    const std::string name = fs::path(started.words[0]).filename();
    if ((name == "flatpak" || name == "snap") && started.words.size() > 1) {
      script.sandbox = name;
      script.application = sandboxedApplication(started.words);
      return;
    }
    const std::optional<std::string> word = m_variables.expanded(started.words[0]);
    const bool bare = word && word->find('/') == std::string::npos;
    const Rank rank = started.exec ? Rank::Exec : bare ? Rank::Bare : Rank::Path;
    if (rank < m_rank)
      return;
    const std::string file = word && !word->empty() ? fileOf(*word) : std::string();
    if (file.empty() && rank != Rank::Exec)
      return;
    m_rank = rank;
    script.starts = file;
  }

  Script script;

private:
  /// Returns the path of a program, or "" if there is none. Resolves a relative name from the
  /// folder to which the script changes, usually its own.
  [[nodiscard]] std::string fileOf(const std::string &word) const {
    const bool relative = word[0] != '/' && word.find('/') != std::string::npos;
    const CommandFile command = findCommand({relative ? (m_folder / word).string() : word});
    return isProgram(command.path) ? command.path : std::string();
  }

  fs::path m_folder;
  Variables m_variables;
  Rank m_rank = Rank::None;
};

} // namespace

Script readScript(const std::string &path) {
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMaxScript, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  Reader reader(path);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    for (const Words &words : commandsOf(text.substr(at, end - at)))
      reader.read(words);
    at = end + 1;
  }
  return reader.script;
}

} // namespace arbiter::tools::doctor
