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

/// Hardware profiles: limits as data, each number with its source. Built-in ones come from
/// profiles/*.toml at build time; a user's is a TOML file of the same form
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
  const char *glName;  ///< without GL_
  std::uint32_t least; ///< what the specification guarantees; a profile may go below it
  std::uint32_t most;  ///< what Arbiter can hold; a profile may not go above it
};
[[nodiscard]] std::span<const RowInfo> rows();
/// The tables of rows(), in their order.
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
/// In the order of choices.def.
[[nodiscard]] std::span<const ChoiceInfo> choices();
inline constexpr int kChoiceCount = [] {
  int count = 0;
#define PROFILE_CHOICE(...) ++count;
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
  return count;
}();
inline constexpr std::string_view kModelTable = "model";

/// Whom the card says it is (ARBITER_IDENTITY=profile); an empty value is the host's own.
struct Identity {
  struct Text {
    std::string value;
    std::string source;
  };
  Text vendor;          ///< GL_VENDOR
  Text renderer;        ///< GL_RENDERER
  Text version;         ///< GL_VERSION: "N.M", then what the driver added
  Text shadingLanguage; ///< GL_SHADING_LANGUAGE_VERSION; empty where the card's driver had none
  Text extensions;      ///< names, parted by one space each; empty: no list
  Text year;            ///< extensions of later years are not announced; empty: of any year

  [[nodiscard]] bool empty() const { return version.value.empty(); }
};

/// A key of a profile's [identity] table.
struct IdentityKey {
  const char *key;
  Identity::Text Identity::*member;
};
[[nodiscard]] std::span<const IdentityKey> identityKeys();

/// NV_register_combiners and 2 of the card.
struct Combiners {
  std::uint32_t general = 0;           ///< general combiner stages, at least 2; 0: not offered
  std::uint32_t perStageConstants = 0; ///< NV_register_combiners2
};

struct Profile {
  std::string name;
  std::string description;
  Limits fragment; ///< the numbers of the fragment target
  Limits vertex;   ///< the numbers of the vertex target; it has no model, only documented limits
  Combiners combiners;
  std::uint32_t textureShaders = 0;    ///< the first so many of NV_texture_shader, 2 and 3
  std::uint32_t aliasedAttributes = 0; ///< generic attributes are the conventional ones
  /// How arithmetic is done unless ARBITER_NUMERICS says otherwise.
  Numerics numerics = Numerics::Host;
  /// The numbers are to be asked from the host's driver, by the names in rows(); those here are
  /// documented defaults for when there is no driver to ask (`arbiter check`).
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
  /// An index into the choice's names.
  [[nodiscard]] std::uint32_t value(Choice choice) const;
  void set(Choice choice, std::uint32_t value, std::string source);
};

struct ProfileError {
  /// One line; begins with "file:line:column: " where a file is at fault.
  std::string message;
};

inline constexpr std::string_view kDefaultProfile = "r300";

/// The built-in profiles' names, the default first.
[[nodiscard]] std::vector<std::string_view> builtinNames();

/// \returns nullptr for a name that is not built in. Valid for the life of the process.
[[nodiscard]] const Profile *findBuiltin(std::string_view name);

/// A path: anything with a slash or ending in ".toml". All else is a name.
[[nodiscard]] bool isProfileFile(std::string_view nameOrPath);

/// A built-in name, or the path of a TOML file by isProfileFile().
/// Never throws; an unknown name's error lists the known ones.
[[nodiscard]] Result<Profile, ProfileError> loadProfile(std::string_view nameOrPath);

/// A TOML text as loadProfile() reads it from a file; `path` is for messages and sources.
[[nodiscard]] Result<Profile, ProfileError> parseProfile(std::string_view text,
                                                         std::string_view path);

} // namespace arbiter::fp::hw
