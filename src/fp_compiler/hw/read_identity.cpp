#include <algorithm>

#include "fp_compiler/hw/read_toml.h"

namespace arbiter::fp::hw {

namespace {

bool isExtensionName(std::string_view name) {
  return name.starts_with("GL_") && name.size() <= 128 &&
         name.find_first_not_of(
             "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_") ==
             std::string_view::npos;
}

/// Returns why `value` is not valid for the key, or an empty text if it is. Names of extensions may
/// be separated by spaces, commas and line ends, as glxinfo prints them. On return one space
/// separates them.
std::string identityFault(std::string_view key, std::string &value) {
  if (key == "extensions") {
    std::string names;
    for (std::size_t at = 0; at < value.size();) {
      const std::size_t end = std::min(value.find_first_of(" ,\t\r\n", at), value.size());
      const std::string_view name = std::string_view(value).substr(at, end - at);
      at = end + 1;
      if (name.empty())
        continue;
      if (!isExtensionName(name))
        return "no name of an extension: \"" + std::string(name.substr(0, 40)) + "\"";
      names += (names.empty() ? "" : " ") + std::string(name);
    }
    value = std::move(names);
    return "";
  }
  for (const char c : value)
    if (c < 0x20 || c > 0x7E)
      return "must be plain ASCII";
  const auto digit = [&](std::size_t at) {
    return at < value.size() && value[at] >= '0' && value[at] <= '9';
  };
  if ((key == "version" || key == "shading_language_version") &&
      !(digit(0) && value[1] == '.' && digit(2)))
    return "must begin with N.M, a version number";
  return "";
}

} // namespace

bool readIdentity(Reader &reader, Profile &profile, const toml::table &table) {
  std::vector<std::string_view> keys;
  for (const IdentityKey &row : identityKeys())
    keys.emplace_back(row.key);
  for (const auto &[key, node] : table) {
    const std::string name = "identity." + std::string(key.str());
    const auto at = std::find(keys.begin(), keys.end(), key.str());
    if (at == keys.end())
      return reader.fail(key.source(), "unknown row \"" + name + "\"" + meant(key.str(), keys));
    Identity::Text text;
    const toml::node *value = readSourced(reader, name, node, text.source);
    if (value == nullptr)
      return false;
    if (key.str() == "year") {
      const std::int64_t year = value->value_or(std::int64_t(0));
      if (!value->is_integer() || year < 1992 || year > 9999)
        return reader.fail(value->source(), name + " must be a year, 1992 to 9999");
      text.value = std::to_string(year);
    } else {
      if (!value->is_string())
        return reader.fail(value->source(), name + " must be a string");
      text.value = value->value_or(std::string());
      if (const std::string fault = identityFault(key.str(), text.value); !fault.empty())
        return reader.fail(value->source(), name + ": " + fault);
    }
    profile.identity.*identityKeys()[std::size_t(at - keys.begin())].member = std::move(text);
  }
  return true;
}

} // namespace arbiter::fp::hw
