#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/hud/hud_options.h"
#include "util/log.h"

/// The settings of the environment. One table, flags.def, holds every variable and flag.
namespace arbiter {

enum class Env : std::uint8_t {
#define ARBITER_ENV(Enumerator, name, values, fallback, doc) Enumerator,
#include "util/flags.def"
};

enum class DebugFlag : std::uint8_t {
#define ARBITER_DEBUG_FLAG(Enumerator, name, doc) Enumerator,
#include "util/flags.def"
};

struct EnvInfo {
  const char *name;     ///< "ARBITER_LOG"
  const char *values;   ///< "LEVEL|FILE"
  const char *fallback; ///< the default as text; empty for none
  const char *doc;
};
struct DebugFlagInfo {
  const char *name; ///< as in ARBITER_DEBUG
  const char *doc;
};

[[nodiscard]] std::span<const EnvInfo> environmentTable();
[[nodiscard]] std::span<const DebugFlagInfo> debugFlagTable();
/// Returns the row of a variable.
[[nodiscard]] const EnvInfo &info(Env variable);

/// The values of ARBITER_BACKEND.
enum class Backend : std::uint8_t { Auto, Host, Swrast };
/// The values of ARBITER_ATTRIBUTES.
enum class Attributes : std::uint8_t { OfProfile, Alias, Apart };

/// Announces or hides an extension, whatever other settings decide about the list.
struct ExtensionSwitch {
  std::string name; ///< "GL_NV_fence"
  bool on = false;

  bool operator==(const ExtensionSwitch &) const = default;
};

/// True if the name is to be announced.
[[nodiscard]] bool isSwitchedOn(std::span<const ExtensionSwitch> switches, std::string_view name);

/// The parsed environment. The initial values are those of a process without any ARBITER_ variable.
struct Settings {
  std::string profile = "r300"; ///< name or path, unresolved: see fp_compiler/hw/profile.h
  bool enforceLimits = true;    ///< false: ARBITER_LIMITS=report
  bool identityOfProfile = false;
  std::string
      numerics; ///< "host", "legacy", "fp24", "fx9" (fp_compiler/numerics.h); empty: the profile's
  Backend backend = Backend::Auto;
  bool alwaysFixedFunction = true; ///< false: ARBITER_FIXED_FUNCTION=programs
  Attributes attributes = Attributes::OfProfile;
  std::uint32_t threads = 0; ///< of the rasterizer; 0: one for each processor
  std::string cpu;           ///< "avx512", "avx2", "sse4.1"; empty: this processor's
  bool cache = true;         ///< of programs, on disk
  std::uint32_t cacheMaxMegabytes = 64;
  std::uint32_t extensionsMaxYear = 0;     ///< 0: no limit
  std::uint32_t extensionsMaxLength = 0;   ///< bytes of the joined names; 0: no limit
  std::vector<ExtensionSwitch> extensions; ///< each name once
  std::string statsPath;                   ///< empty: none; expandPid() has not been applied yet
  std::string capturePath;                 ///< a folder; empty: no capture
  std::string replacePath;                 ///< a folder; empty: no replacement
  LogLevel logLevel = LogLevel::Warn;
  std::string logPath;     ///< empty: standard error
  std::string hostVendor;  ///< empty: libglvnd's own choice
  std::string jitLibrary;  ///< empty: the one beside the layer's own library
  std::string hostOsmesa;  ///< empty: the one the front was built for
  std::uint32_t debug = 0; ///< one bit for each DebugFlag
  bool control = false;    ///< clients may connect (state/control)
  HudOptions hud;          ///< values shown in each frame (state/hud)

  [[nodiscard]] bool has(DebugFlag flag) const { return (debug >> unsigned(flag) & 1u) != 0; }
};

/// Longer values are refused: no real path or list is longer.
inline constexpr std::size_t kMaxEnvBytes = 4096;

/// True if the value is not longer than that and has no control characters.
[[nodiscard]] bool isUsable(std::string_view value);

/// Parses the values that `lookup` returns (nullptr: not set). A bad value leaves the default and
/// adds one line to `warnings`.
[[nodiscard]] Settings parseSettings(const std::function<const char *(const char *)> &lookup,
                                     std::vector<std::string> &warnings);

/// Returns the value of a variable that the environment does not set; null: none. Only the layer's
/// library defines this function (interposer/process.cpp), for the defaults of single programs. It
/// has default visibility because on 32-bit x86 the address of a missing hidden function is not
/// null: linkers resolve it against the file's load address.
[[gnu::weak, gnu::visibility("default")]] const char *fallbackValue(const char *name);
/// Logs the errors that fallbackValue() found, and the values it returns. Called when the log is
/// open.
[[gnu::weak, gnu::visibility("default")]] void reportFallbacks();

/// Returns this process's settings. The first call reads them by secure_getenv (none in a
/// set-user-id program), then by fallbackValue(). It also opens the log, writes the warnings to it,
/// and prints the help if asked. Never throws, and ignores later changes of the environment.
[[nodiscard]] const Settings &settings() noexcept;

/// Returns settings().has(flag); keep the result in hot code.
[[nodiscard]] inline bool debugFlag(DebugFlag flag) noexcept { return settings().has(flag); }

/// Logs one line if the flag is set, whatever the level, unless the log is off.
[[gnu::format(printf, 3, 4)]] void logFlag(DebugFlag flag, const char *room, const char *format,
                                           ...) noexcept;

/// Returns the text of ARBITER_DEBUG=help.
[[nodiscard]] std::string flagsHelp();

} // namespace arbiter
