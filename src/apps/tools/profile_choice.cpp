#include "apps/tools/profile_choice.h"

#include "util/flags.h"

namespace arbiter::tools {

Result<ProfileChoice, fp::hw::ProfileError> ProfileChoice::make(const std::string &asked) {
  auto profile = fp::hw::loadProfile(asked.empty() ? settings().profile : asked);
  if (!profile)
    return profile.error();
  return ProfileChoice(std::move(profile).value(), asked);
}

const fp::hw::Profile &ProfileChoice::of(const std::string &path, std::string_view text) {
  if (!m_asked.empty())
    return m_common;
  const std::size_t slash = path.rfind('/');
  const std::string folder = slash == std::string::npos ? std::string() : path.substr(0, slash + 1);
  const std::string name = scene::profileOf(scene::parsePanel(text), folder);
  if (const fp::hw::Profile *builtin = fp::hw::findBuiltin(name))
    return *builtin;
  // A relative profile path needs a folder, and a text that is in no file has none.
  if (name.empty() || path.empty())
    return m_common;
  auto read = fp::hw::loadProfile(name); // read again: the file may have changed
  if (!read)
    return m_common;
  return m_files.insert_or_assign(name, std::move(read).value()).first->second;
}

std::string profileName(const std::string &asked, const scene::Document &document) {
  if (!asked.empty())
    return asked;
  const std::string named = document.profile();
  return named.empty() ? settings().profile : named;
}

} // namespace arbiter::tools
