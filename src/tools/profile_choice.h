#pragma once
#include <map>
#include <string>

#include "fp_compiler/hw/profile.h"
#include "scene/document.h"
#include "util/result.h"

/// Which profile a program is judged by.
namespace arbiter::tools {

/// The profile that was asked for; else the one that the text's panel names; else
/// ARBITER_PROFILE's, or the default. `draw`, `debug` and the window choose in the same order.
class ProfileChoice {
public:
  /// \param asked a name or a file, of the command line or of an editor's settings; empty: none
  [[nodiscard]] static Result<ProfileChoice, fp::hw::ProfileError> make(const std::string &asked);

  /// Of the text of the file of that path; an empty path: of a text that is in no file. Of a panel
  /// whose profile does not load: common(), as the panel's diagnostics say so.
  /// Valid as long as this object.
  [[nodiscard]] const fp::hw::Profile &of(const std::string &path, std::string_view text);
  /// Of a text without a panel.
  [[nodiscard]] const fp::hw::Profile &common() const { return m_common; }
  /// As it was given; empty: none.
  [[nodiscard]] const std::string &asked() const { return m_asked; }

private:
  ProfileChoice(fp::hw::Profile common, std::string asked)
      : m_common(std::move(common)), m_asked(std::move(asked)) {}

  fp::hw::Profile m_common;
  std::string m_asked;
  std::map<std::string, fp::hw::Profile> m_files; ///< by path, as they were when last read
};

/// The name of a document's profile, for loadProfile(), in the same order.
[[nodiscard]] std::string profileName(const std::string &asked, const scene::Document &document);

} // namespace arbiter::tools
