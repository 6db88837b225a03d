#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "util/hud/hud_options.h"
#include "util/log.h"

/// What the environment asks for. One table, flags.def, holds every variable and flag.
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
/// The row of a variable.
[[nodiscard]] const EnvInfo &info(Env variable);

/// ARBITER_BACKEND.
enum class Backend : std::uint8_t { Auto, Host, Swrast };
/// ARBITER_ATTRIBUTES.
enum class Attributes : std::uint8_t { OfProfile, Alias, Apart };

/// An extension that is announced, or is not, whatever else rules the list.
struct ExtensionSwitch {
  std::string name; ///< "GL_NV_fence"
  bool on = false;

  bool operator==(const ExtensionSwitch &) const = default;
};

/// True if the name is to be announced.
[[nodiscard]] bool isSwitchedOn(std::span<const ExtensionSwitch> switches, std::string_view name);

/// The environment, parsed. Defaults are those of a process with no ARBITER_ variable.
struct Settings {
  std::string profile = "r300"; ///< name or path, unresolved: see fp_compiler/hw/profile.h
  bool enforceLimits = true;    ///< false: ARBITER_LIMITS=report
  bool identityOfProfile = false;
  std::string
      numerics; ///< "host", "legacy", "fp24", "fx9" (fp_compiler/numerics.h); empty: the profile's
  Backend backend = Backend::Auto;
  bool alwaysFixedFunction = true; ///< false: ARBITER_FIXED_FUNCTION=programs
  Attributes attributes = Attributes::OfProfile;
  std::uint32_t threads = 0; ///< of the rasterizer; 0: one a processor
  std::string cpu;           ///< "avx512", "avx2", "sse4.1"; empty: this one
  bool cache = true;         ///< of programs, on disk
  std::uint32_t cacheMaxMegabytes = 64;
  std::uint32_t extensionsMaxYear = 0;     ///< 0: of any year
  std::uint32_t extensionsMaxLength = 0;   ///< bytes of the joined names; 0: of any length
  std::vector<ExtensionSwitch> extensions; ///< each name once
  std::string statsPath;                   ///< empty: none; expandPid() is still to be applied
  std::string capturePath;                 ///< a folder; empty: no capture
  std::string replacePath;                 ///< a folder; empty: no replacement
  LogLevel logLevel = LogLevel::Warn;
  std::string logPath;     ///< empty: standard error
  std::string hostVendor;  ///< empty: libglvnd's own choice
  std::string jitLibrary;  ///< empty: the one beside the layer's own library
  std::string hostOsmesa;  ///< empty: the one the front was built for
  std::uint32_t debug = 0; ///< one bit a DebugFlag
  bool control = false;    ///< clients may connect (state/control)
  HudOptions hud;          ///< figures in each frame (state/hud)

  [[nodiscard]] bool has(DebugFlag flag) const { return (debug >> unsigned(flag) & 1u) != 0; }
};

/// Longer values are refused: no path or list that is meant can be longer.
inline constexpr std::size_t kMaxEnvBytes = 4096;

/// Not longer than that, and without control characters.
[[nodiscard]] bool isUsable(std::string_view value);

/// Parses values as `lookup` gives them (nullptr: not set). A value that cannot be used leaves the
/// default and adds one line to `warnings`.
[[nodiscard]] Settings parseSettings(const std::function<const char *(const char *)> &lookup,
                                     std::vector<std::string> &warnings);

/// The value of a variable that the environment does not have; null: none. The layer's library
/// defines it (interposer/process.cpp): there defaults of single programs hold. Other programs
/// have none. Visible, as the address of a hidden one that is missing is not null on 32-bit x86:
/// linkers resolve it against the address that the file is loaded at.
[[gnu::weak, gnu::visibility("default")]] const char *fallbackValue(const char *name);
/// Logs what fallbackValue() found wrong, and what it gives; called when the log is open.
[[gnu::weak, gnu::visibility("default")]] void reportFallbacks();

/// This process's settings: read by secure_getenv once, at the first call (none in a set-user-id
/// program), and where that has no variable by fallbackValue(). The first call also opens the log,
/// writes the warnings to it, and prints the help if asked. Never throws; later changes of the
/// environment are not seen.
[[nodiscard]] const Settings &settings() noexcept;

/// Shorthand for settings().has(flag); keep the answer where calls are hot.
[[nodiscard]] inline bool debugFlag(DebugFlag flag) noexcept { return settings().has(flag); }

/// One line for the log if the flag is set, whatever the level, unless the log is off.
[[gnu::format(printf, 3, 4)]] void logFlag(DebugFlag flag, const char *room, const char *format,
                                           ...) noexcept;

/// The text of ARBITER_DEBUG=help.
[[nodiscard]] std::string flagsHelp();

} // namespace arbiter
