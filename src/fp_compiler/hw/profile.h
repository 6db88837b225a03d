#pragma once
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fp_compiler/limits.h"
#include "fp_compiler/numerics.h"
#include "util/result.h"

/// Hardware profiles: limits as data, each number with its source. Built-in profiles come from
/// profiles/*.toml at build time. A user's profile is a TOML file of the same form
/// (docs/reference/profiles.md).
namespace arbiter::fp::hw {

enum class Row : std::uint8_t {
#define PROFILE_ROW(Enumerator, table, key, member, glName, least, most) Enumerator,
#include "fp_compiler/hw/rows.def"
#undef PROFILE_ROW
};

inline constexpr Row kAllRows[] = {
#define PROFILE_ROW(Enumerator, table, key, member, glName, least, most) Row::Enumerator,
#include "fp_compiler/hw/rows.def"
#undef PROFILE_ROW
};
inline constexpr int kRowCount = int(std::size(kAllRows));

struct RowInfo {
  Row row;
  const char *table;   ///< "api", "native", "state", "model", "vertex_api", "vertex_native" ...
  const char *key;     ///< "alu_instructions"
  const char *glName;  ///< without the prefix GL_
  std::uint32_t least; ///< guaranteed by the specification; a profile may go below it
  std::uint32_t most;  ///< the largest that Arbiter supports; a profile may not go above it
};
[[nodiscard]] std::span<const RowInfo> rows();
/// Returns the names of the tables, in the order of rows().
[[nodiscard]] std::span<const std::string_view> tables();

/// A key of [model] whose value is a name.
enum class Choice : std::uint8_t {
#define PROFILE_CHOICE(Enumerator, key, member, type, names, doc) Enumerator,
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
};

struct ChoiceInfo {
  Choice choice;
  const char *key;                     ///< "fragment"
  std::vector<std::string_view> names; ///< "documented", "r300" ... in the order of the values
};
/// Returns the choices in the order of choices.def.
[[nodiscard]] std::span<const ChoiceInfo> choices();
inline constexpr int kChoiceCount = [] {
  int count = 0;
#define PROFILE_CHOICE(...) ++count;
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
  return count;
}();
inline constexpr std::string_view kModelTable = "model";

/// The identity strings of the card (ARBITER_IDENTITY=profile). An empty value leaves the host's
/// own.
struct Identity {
  struct Text {
    std::string value;
    std::string source;
  };
  Text vendor;          ///< GL_VENDOR
  Text renderer;        ///< GL_RENDERER
  Text version;         ///< GL_VERSION: "N.M", then what the driver added
  Text shadingLanguage; ///< empty if the card's driver had none
  Text extensions;      ///< names with one space between them; empty: no list
  Text year;            ///< hides extensions of later years; empty: hides none

  [[nodiscard]] bool empty() const { return version.value.empty(); }
};

/// A key of a profile's [identity] table.
struct IdentityKey {
  const char *key;
  Identity::Text Identity::*member;
};
[[nodiscard]] std::span<const IdentityKey> identityKeys();

/// Limits of NV_register_combiners and NV_register_combiners2.
struct Combiners {
  std::uint32_t general = 0;           ///< general combiner stages, at least 2; 0: not offered
  std::uint32_t perStageConstants = 0; ///< 1: NV_register_combiners2 is offered
};

struct Profile {
  std::string name;
  std::string description;
  Limits fragment; ///< limits of the fragment target
  Limits vertex;   ///< limits of the vertex target, which has no model
  Combiners combiners;
  std::uint32_t textureShaders = 0;    ///< how many of NV_texture_shader, 2 and 3 are offered
  std::uint32_t aliasedAttributes = 0; ///< 1: generic attributes alias the conventional ones
  /// The arithmetic, unless ARBITER_NUMERICS says otherwise.
  Numerics numerics = Numerics::Host;
  /// True if the layer asks the host's driver for the numbers, by the names in rows(). The numbers
  /// here are then defaults for when there is no driver to ask (`arbiter check`).
  bool fromHost = false;
  std::array<std::string, kRowCount> sources;
  std::array<std::string, kChoiceCount> choiceSources;
  Identity identity;

  /// Gives the limits the card's name for messages: what the description begins with where it names
  /// a card before its chip, and the profile's name: "ATI Radeon 9700 (r300)". Call when both are
  /// there.
  void nameCard();

  [[nodiscard]] std::uint32_t value(Row row) const;
  void set(Row row, std::uint32_t value, std::string source);
  /// Returns an index into the choice's names.
  [[nodiscard]] std::uint32_t value(Choice choice) const;
  void set(Choice choice, std::uint32_t value, std::string source);
};

struct ProfileError {
  /// One line. It begins with "file:line:column: " if the error is in a file.
  std::string message;
};

inline constexpr std::string_view kDefaultProfile = "r300";

/// Returns the built-in profiles' names, the default first.
[[nodiscard]] std::vector<std::string_view> builtinNames();

/// Finds a built-in profile by name or alias.
/// \returns nullptr for a name that is not built in. Valid for the life of the process.
[[nodiscard]] const Profile *findBuiltin(std::string_view name);

/// True for a path: a name that has a slash or ends in ".toml".
[[nodiscard]] bool isProfileFile(std::string_view nameOrPath);

/// Loads a built-in profile by name, or a TOML file if isProfileFile(). Never throws. The error for
/// an unknown name lists the known names.
[[nodiscard]] Result<Profile, ProfileError> loadProfile(std::string_view nameOrPath);

/// Parses the TOML text of a profile.
/// \param path the file's name, for messages and sources
[[nodiscard]] Result<Profile, ProfileError> parseProfile(std::string_view text,
                                                         std::string_view path);

} // namespace arbiter::fp::hw
