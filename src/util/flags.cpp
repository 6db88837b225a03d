#include "util/flags.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdlib>
#include <unistd.h>

#include "util/file.h"
#include "util/suggest.h"
#include "util/text/letters.h"

namespace arbiter {

namespace {

constexpr EnvInfo kEnvironment[] = {
#define ARBITER_ENV(Enumerator, name, values, fallback, doc) {name, values, fallback, doc},
#include "util/flags.def"
};

constexpr DebugFlagInfo kDebugFlags[] = {
#define ARBITER_DEBUG_FLAG(Enumerator, name, doc) {name, doc},
#include "util/flags.def"
};
static_assert(std::size(kDebugFlags) <= 32, "Settings::debug has 32 bits");

struct LevelName {
  const char *name;
  LogLevel level;
};
constexpr LevelName kLevels[] = {
    {"off", LogLevel::Off},   {"error", LogLevel::Error}, {"warn", LogLevel::Warn},
    {"info", LogLevel::Info}, {"debug", LogLevel::Debug},
};

const LevelName *findLevel(std::string_view text) {
  for (const LevelName &row : kLevels)
    if (text == row.name)
      return &row;
  return nullptr;
}

/// Quotes the first bytes of a value for a message, made printable.
std::string quoted(std::string_view value) {
  std::string text = "\"";
  for (const char c : value.substr(0, 40))
    text += c < 0x20 || c == 0x7F ? '?' : c;
  return text + (value.size() > 40 ? "...\"" : "\"");
}

bool hasControl(std::string_view value) {
  return std::any_of(value.begin(), value.end(),
                     [](char c) { return (c >= 0 && c < 0x20) || c == 0x7F; });
}

/// Collects warnings that begin with a variable's name.
struct Reader {
  const std::function<const char *(const char *)> &lookup;
  std::vector<std::string> &warnings;

  void warn(Env variable, const std::string &text) {
    warnings.push_back(std::string(info(variable).name) + ": " + text + "; ignored");
  }

  /// Returns "" if the variable is not set, is empty, or is unusable.
  std::string_view read(Env variable) {
    const char *raw = lookup(info(variable).name);
    if (raw == nullptr)
      return {};
    const std::string_view value(raw);
    if (value.size() > kMaxEnvBytes) {
      warn(variable, "longer than " + std::to_string(kMaxEnvBytes) + " bytes");
      return {};
    }
    if (hasControl(value)) {
      warn(variable, "a control character in the value");
      return {};
    }
    return value;
  }
};

void readLog(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Log);
  if (value.empty())
    return;
  if (const LevelName *row = findLevel(value)) {
    result.logLevel = row->level;
    return;
  }
  const std::size_t colon = value.find(':');
  const LevelName *row =
      colon == std::string_view::npos ? nullptr : findLevel(value.substr(0, colon));
  if (row != nullptr && colon + 1 < value.size()) {
    result.logLevel = row->level;
    result.logPath = value.substr(colon + 1);
  } else if (row == nullptr && value.find('/') != std::string_view::npos) {
    result.logLevel = LogLevel::Info;
    result.logPath = value;
  } else {
    reader.warn(Env::Log, "expected off, error, warn, info, debug, a path with a slash, or "
                          "LEVEL:FILE, not " +
                              quoted(value));
  }
}

void readDebug(Reader &reader, Settings &result) {
  std::string_view list = reader.read(Env::Debug);
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view name = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    if (name.empty())
      continue;
    bool known = false;
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < std::size(kDebugFlags); ++i) {
      names.emplace_back(kDebugFlags[i].name);
      if (name == kDebugFlags[i].name) {
        result.debug |= 1u << i;
        known = true;
      }
    }
    if (!known) {
      const std::string_view near = nearest(name, names);
      reader.warn(Env::Debug, "no flag " + quoted(name) +
                                  (near.empty() ? std::string(" (help lists them)")
                                                : " (did you mean " + std::string(near) + "?)"));
      return; // one warning for each bad value
    }
  }
}

void readLimits(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Limits);
  if (value == "report")
    result.enforceLimits = false;
  else if (!value.empty() && value != "enforce")
    reader.warn(Env::Limits, "expected enforce or report, not " + quoted(value));
}

void readIdentity(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Identity);
  if (value == "profile")
    result.identityOfProfile = true;
  else if (!value.empty() && value != "host")
    reader.warn(Env::Identity, "expected host or profile, not " + quoted(value));
}

void readBackend(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Backend);
  if (value == "host")
    result.backend = Backend::Host;
  else if (value == "swrast")
    result.backend = Backend::Swrast;
  else if (!value.empty() && value != "auto")
    reader.warn(Env::Backend, "expected auto, host or swrast, not " + quoted(value));
}

void readFixedFunction(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::FixedFunction);
  if (value == "programs")
    result.alwaysFixedFunction = false;
  else if (!value.empty() && value != "always")
    reader.warn(Env::FixedFunction, "expected always or programs, not " + quoted(value));
}

void readAttributes(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Attributes);
  if (value == "alias")
    result.attributes = Attributes::Alias;
  else if (value == "apart")
    result.attributes = Attributes::Apart;
  else if (!value.empty())
    reader.warn(Env::Attributes, "expected alias or apart, not " + quoted(value));
}

void readCpu(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Cpu);
  if (value == "avx512" || value == "avx2" || value == "sse4.1")
    result.cpu = value;
  else if (!value.empty())
    reader.warn(Env::Cpu, "expected avx512, avx2 or sse4.1, not " + quoted(value));
}

void readNumerics(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Numerics);
  if (value == "host" || value == "legacy" || value == "fp24" || value == "fx9")
    result.numerics = value;
  else if (!value.empty())
    reader.warn(Env::Numerics, "expected host, legacy, fp24 or fx9, not " + quoted(value));
}

/// Reads a whole decimal number in a range. Returns `fallback` if there is none, with a warning if
/// the value is bad.
std::uint32_t readNumber(Reader &reader, Env variable, std::uint32_t least, std::uint32_t most,
                         std::uint32_t fallback) {
  const std::string_view value = reader.read(variable);
  if (value.empty())
    return fallback;
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), number);
  if (error == std::errc() && end == value.data() + value.size() && number >= least &&
      number <= most)
    return number;
  reader.warn(variable, "expected a whole number from " + std::to_string(least) + " to " +
                            std::to_string(most) + ", not " + quoted(value));
  return fallback;
}

/// Reads "NAME=on,NAME=off". The last mention of a name counts.
void readExtensions(Reader &reader, Settings &result) {
  constexpr std::string_view kOn = "=on", kOff = "=off";
  std::string_view list = reader.read(Env::Extensions);
  while (!list.empty()) {
    const std::size_t comma = std::min(list.find(','), list.size());
    const std::string_view item = list.substr(0, comma);
    list.remove_prefix(std::min(comma + 1, list.size()));
    if (item.empty())
      continue;
    const bool on = item.ends_with(kOn);
    const std::string_view name =
        item.substr(0, item.size() - (on ? kOn.size() : std::min(item.size(), kOff.size())));
    const bool isName = (name.starts_with("GL_") || name.starts_with("GLX_")) &&
                        std::all_of(name.begin(), name.end(), [](unsigned char c) {
                          return std::isalnum(c) != 0 || c == '_';
                        });
    if (!isName || (!on && !item.ends_with(kOff))) {
      reader.warn(Env::Extensions, "expected GL_NAME=on, GL_NAME=off or the same of a GLX_ name, "
                                   "not " +
                                       quoted(item));
      result.extensions.clear();
      return; // one warning for each bad value
    }
    std::erase_if(result.extensions, [&](const ExtensionSwitch &row) { return row.name == name; });
    result.extensions.push_back({std::string(name), on});
  }
}

void readCache(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::Cache);
  if (value == "0")
    result.cache = false;
  else if (!value.empty() && value != "1")
    reader.warn(Env::Cache, "expected 0 or 1, not " + quoted(value));
  result.cacheMaxMegabytes =
      readNumber(reader, Env::CacheMaxMb, 1, 65536, result.cacheMaxMegabytes);
}

/// Reads 1 or 0; false if not set.
bool readSwitch(Reader &reader, Env variable) {
  const std::string_view value = reader.read(variable);
  if (!value.empty() && value != "0" && value != "1")
    reader.warn(variable, "expected 0 or 1, not " + quoted(value));
  return value == "1";
}

void readHud(Reader &reader, Settings &result) {
  std::string wrong;
  if (const auto options = parseHudOptions(reader.read(Env::Hud), wrong))
    result.hud = *options;
  else
    reader.warn(Env::Hud, wrong);
}

/// Reads a name that becomes part of a library's file name (libGLX_NAME.so.0), so it must not
/// contain a path.
void readHostVendor(Reader &reader, Settings &result) {
  const std::string_view value = reader.read(Env::HostVendor);
  const auto nameByte = [](char c) { return isLetterOrDigit(c) || c == '_' || c == '-'; };
  for (const char c : value) {
    if (!nameByte(c)) {
      reader.warn(Env::HostVendor,
                  "expected letters, digits, - and _ (mesa, nvidia), not " + quoted(value));
      return;
    }
  }
  if (value == "arbiter")
    reader.warn(Env::HostVendor, "Arbiter cannot be its own host");
  else
    result.hostVendor = value;
}

const Settings *readProcess() {
  std::vector<std::string> warnings;
  auto *result = new Settings(parseSettings(
      [](const char *name) -> const char * {
        const char *const set = ::secure_getenv(name);
        return set != nullptr || fallbackValue == nullptr ? set : fallbackValue(name);
      },
      warnings));
  if (!configureLog(result->logLevel, result->logPath.c_str()))
    warnings.push_back("ARBITER_LOG: cannot open the file (it must be a regular file, no symbolic "
                       "link); logging to standard error");
  for (const std::string &warning : warnings)
    logWarn("settings", "%s", warning.c_str());
  if (reportFallbacks != nullptr)
    reportFallbacks();
  if (result->has(DebugFlag::Help))
    writeAll(STDERR_FILENO, flagsHelp());
  return result;
}

} // namespace

std::span<const EnvInfo> environmentTable() { return kEnvironment; }
std::span<const DebugFlagInfo> debugFlagTable() { return kDebugFlags; }
const EnvInfo &info(Env variable) { return kEnvironment[std::size_t(variable)]; }

bool isUsable(std::string_view value) { return value.size() <= kMaxEnvBytes && !hasControl(value); }

bool isSwitchedOn(std::span<const ExtensionSwitch> switches, std::string_view name) {
  return std::any_of(switches.begin(), switches.end(),
                     [&](const ExtensionSwitch &each) { return each.on && each.name == name; });
}

Settings parseSettings(const std::function<const char *(const char *)> &lookup,
                       std::vector<std::string> &warnings) {
  Settings result;
  Reader reader{lookup, warnings};
  readLog(reader, result);
  // Only for the warning; util/defaults uses the value
  static_cast<void>(reader.read(Env::Defaults));
  readDebug(reader, result);
  readLimits(reader, result);
  readHostVendor(reader, result);
  readCache(reader, result);
  readIdentity(reader, result);
  readNumerics(reader, result);
  readBackend(reader, result);
  readFixedFunction(reader, result);
  readAttributes(reader, result);
  readCpu(reader, result);
  result.threads = readNumber(reader, Env::Threads, 1, 64, 0);
  result.extensionsMaxYear = readNumber(reader, Env::ExtensionsMaxYear, 1992, 9999, 0);
  result.extensionsMaxLength = readNumber(reader, Env::ExtensionsMaxLength, 1, 1u << 20, 0);
  readExtensions(reader, result);
  result.control = readSwitch(reader, Env::Control);
  readHud(reader, result);
  result.capturePath = reader.read(Env::Capture);
  result.replacePath = reader.read(Env::Replace);
  result.statsPath = reader.read(Env::Stats);
  result.hostOsmesa = reader.read(Env::HostOsmesa);
  result.jitLibrary = reader.read(Env::JitLibrary);
  if (const std::string_view profile = reader.read(Env::Profile); !profile.empty())
    result.profile = profile;
  return result;
}

const Settings &settings() noexcept {
  // The settings are never destroyed: the application's destructors may call GL after the layer's
  // would have run.
  static const Settings *const instance = []() -> const Settings * {
    try {
      return readProcess();
    } catch (...) {
      return nullptr; // out of memory before the layer was asked for anything
    }
  }();
  if (instance != nullptr)
    return *instance;
  static const Settings defaults;
  return defaults;
}

std::string flagsHelp() {
  std::string text = "ARBITER_DEBUG=FLAG[,FLAG...]\n";
  for (const DebugFlagInfo &row : kDebugFlags) {
    std::string name = row.name;
    name.resize(std::max<std::size_t>(name.size() + 1, 12), ' ');
    text += "  " + name + row.doc + "\n";
  }
  text += "Other variables\n";
  for (const EnvInfo &row : kEnvironment) {
    text += "  " + std::string(row.name) + "=" + row.values;
    if (*row.fallback != '\0')
      text += " (default " + std::string(row.fallback) + ")";
    text += "\n      " + std::string(row.doc) + "\n";
  }
  return text;
}

} // namespace arbiter
