#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <unistd.h>

#include "tools/doctor/finding.h"

namespace arbiter::tools::doctor {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxScript = 1u << 20; // a longer one is an installer with its data

/// The words of a line of a shell, quotes gone; variables and substitutions stay as they are.
std::vector<std::string> wordsOf(const std::string &line) {
  std::vector<std::string> words;
  std::string word;
  char quote = 0;
  int depth = 0; // of $( )
  bool any = false;
  const auto end = [&] {
    if (any)
      words.push_back(word);
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
    if (quote == 0 && depth == 0 &&
        (std::isspace(static_cast<unsigned char>(c)) || c == ';' || c == '&' || c == '|')) {
      end();
      continue;
    }
    word += c;
    any = true;
  }
  end();
  return words;
}

bool isAssignment(const std::string &word) {
  const std::size_t equal = word.find('=');
  return equal != std::string::npos && equal > 0 &&
         std::all_of(word.begin(), word.begin() + std::ptrdiff_t(equal), [](char c) {
           return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
         });
}

/// A word with a variable or a substitution in front ("$HERE/game", "$(dirname "$0")/game"): such
/// scripts mean their own folder.
std::string fromHere(const std::string &word, const fs::path &folder) {
  if (word.empty() || word[0] == '/')
    return word;
  if (word[0] == '$') {
    const std::size_t slash =
        word.rfind(')') == std::string::npos
            ? word.find('/', word.find('}') == std::string::npos ? 0 : word.find('}'))
            : word.find('/', word.rfind(')'));
    return slash == std::string::npos ? std::string() : (folder / word.substr(slash + 1)).string();
  }
  return word.find('/') == std::string::npos ? word : (folder / word).string();
}

bool isProgram(const std::string &path) {
  std::error_code error;
  return !path.empty() && fs::is_regular_file(path, error) && ::access(path.c_str(), X_OK) == 0;
}

/// Commands that a script uses on its way, or that run the rest of their words.
constexpr std::string_view kPassing[] = {"exec", "env",  "nohup", "nice", "setsid",
                                         "time", "then", "else",  "do",   "command"};
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

struct Started {
  std::vector<std::string> words; ///< the command's, without what stands before it
  bool exec = false;
};

Started commandOf(const std::vector<std::string> &line, Script &script) {
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
      script.clearsPreload = script.clearsPreload || word == "LD_PRELOAD=";
      script.libraryPath = script.libraryPath || word.starts_with("LD_LIBRARY_PATH=");
    } else if (isOne(word, kPassing)) {
      passing = true;
    } else if (!passing || !word.starts_with("-")) {
      break;
    }
  }
  started.words.assign(line.begin() + std::ptrdiff_t(at), line.end());
  return started;
}

void lookAtVariables(const std::vector<std::string> &line, Script &script) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == "LD_PRELOAD" && line[0] == "unset")
      script.clearsPreload = true;
    // What is set anew without what was there before loses the layer.
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

Script readScript(const std::string &path) {
  Script script;
  std::ifstream stream(path, std::ios::binary);
  std::string text(kMaxScript, '\0');
  stream.read(text.data(), std::streamsize(text.size()));
  text.resize(std::size_t(stream.gcount()));
  const fs::path folder = fs::path(path).parent_path();
  bool certain = false;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::vector<std::string> line = wordsOf(text.substr(at, end - at));
    at = end + 1;
    if (line.empty())
      continue;
    lookAtVariables(line, script);
    const Started started = commandOf(line, script);
    if (started.words.empty() || isOne(started.words[0], kOwn))
      continue;
    const std::string name = fs::path(started.words[0]).filename();
    if ((name == "flatpak" || name == "snap") && started.words.size() > 1) {
      script.sandbox = name;
      script.application = sandboxedApplication(started.words);
      return script;
    }
    // The last one that is there counts, and one behind `exec` before others.
    const std::string file = fromHere(started.words[0], folder);
    const CommandFile command = file.empty() ? CommandFile{} : findCommand({file});
    if (isProgram(command.path) && (started.exec || !certain)) {
      script.starts = command.path;
      script.word = started.words[0];
      certain = certain || started.exec;
    }
  }
  return script;
}

} // namespace arbiter::tools::doctor
