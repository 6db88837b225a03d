#pragma once
#include <map>
#include <string>

#include "apps/scene/document.h"
#include "fp_compiler/hw/profile.h"
#include "util/result.h"

/// Chooses the hardware profile by which a program is judged.
namespace arbiter::tools {

/// Takes the first of: the requested profile, the profile in the text's panel, ARBITER_PROFILE, the
/// default. `draw`, `debug` and the window use the same order.
class ProfileChoice {
public:
  /// \param asked a name or a file, from the command line or an editor's settings; empty: none
  [[nodiscard]] static Result<ProfileChoice, fp::hw::ProfileError> make(const std::string &asked);

  /// Returns the profile for a text. If the panel's profile does not load, returns common(); the
  /// panel's diagnostics report that.
  /// The reference is valid as long as this object.
  /// \param path of the text's file; empty: in no file
  [[nodiscard]] const fp::hw::Profile &of(const std::string &path, std::string_view text);
  /// Returns the profile for a text without a panel.
  [[nodiscard]] const fp::hw::Profile &common() const { return m_common; }
  /// Returns the requested profile as it was given; empty: none.
  [[nodiscard]] const std::string &asked() const { return m_asked; }

private:
  ProfileChoice(fp::hw::Profile common, std::string asked)
      : m_common(std::move(common)), m_asked(std::move(asked)) {}

  fp::hw::Profile m_common;
  std::string m_asked;
  std::map<std::string, fp::hw::Profile> m_files; ///< by path, as last read
};

/// Returns the name of a document's profile for loadProfile(), chosen in the same order.
[[nodiscard]] std::string profileName(const std::string &asked, const scene::Document &document);

} // namespace arbiter::tools
