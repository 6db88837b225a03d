// Formats an option for help: "--frames N (1 to 1000000; by default 1)". Replaces CLI11's words
// "TEXT", "INT", "REQUIRED", "Needs" and "Excludes".
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>
#include <memory>
#include <set>

#include "apps/tools/options/options.h"

namespace arbiter::tools {

namespace {

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return char(std::toupper(c)); });
  return text;
}

/// Parses CLI11's name of a type: "TEXT:{a,b} OR FILE", "INT:1 to 16".
struct Type {
  explicit Type(const std::string &text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string name = text.substr(0, colon), rest = text.substr(colon);
    if (const std::size_t end = rest.find('}'); rest.starts_with(":{"))
      words = rest.substr(1, end) + (rest.ends_with(" OR FILE") ? " or FILE" : "");
    else if (rest.size() > 1)
      range = rest.substr(1);
    isNumber = name == "INT" || name == "FLOAT";
  }
  bool isNumber = false;
  std::string words; ///< "{a,b}", "{a,b} or FILE"; empty: any
  std::string range; ///< of a number; empty: any
};

class OwnWords : public CLI::Formatter {
public:
  [[nodiscard]] std::string make_option_opts(const CLI::Option *option) const override {
    std::vector<std::string> parts;
    std::string text;
    if (option->get_items_expected_max() != 0) {
      const Type type(option->get_type_name());
      if (!option->get_positional())
        text = " " + placeholder(*option, type);
      if (!type.range.empty())
        parts.push_back(type.range);
      if (!option->get_default_str().empty())
        parts.push_back("by default " + option->get_default_str());
      if (option->get_required() && !option->get_positional())
        parts.emplace_back("required");
    }
    if (const std::string names = namesOf(option->get_needs()); !names.empty())
      parts.push_back("needs" + names);
    if (const std::string names = namesOf(option->get_excludes()); !names.empty())
      parts.push_back("not with" + names);
    return text + (parts.empty() ? "" : " (" + CLI::detail::join(parts, "; ") + ")");
  }

  [[nodiscard]] std::string make_option_usage(const CLI::Option *option) const override {
    const std::string name =
        make_option_name(option, true) + (option->get_expected_max() > 1 ? "..." : "");
    return option->get_required() ? name : "[" + name + "]";
  }

  /// Leaves out the part that the placeholder already shows.
  [[nodiscard]] std::string make_option_desc(const CLI::Option *option) const override {
    const std::string &description = option->get_description();
    const std::string said = saidPlaceholder(description);
    return said.empty() || option->get_positional() ? description
                                                    : description.substr(said.size() + 2);
  }

private:
  static std::string namesOf(const std::set<CLI::Option *> &options) {
    std::vector<std::string> names;
    names.reserve(options.size());
    for (const CLI::Option *option : options)
      names.push_back(" " + option->get_name());
    std::sort(names.begin(), names.end());
    return CLI::detail::join(names, "");
  }

  /// Returns the placeholder of a value: its words, the start of the description, N for a number,
  /// or the last word of the name.
  static std::string placeholder(const CLI::Option &option, const Type &type) {
    if (!type.words.empty())
      return type.words;
    if (std::string said = saidPlaceholder(option.get_description()); !said.empty())
      return said;
    const std::string &name = option.get_lnames().front();
    return type.isNumber ? "N" : upper(name.substr(name.rfind('-') + 1));
  }
};

} // namespace

std::string saidPlaceholder(const std::string &description) {
  const std::string first = description.substr(0, description.find(": "));
  const bool isOne = first.size() < description.size() && !first.empty() &&
                     (std::isupper(static_cast<unsigned char>(first[0])) || first[0] == '[') &&
                     first.find(' ') == std::string::npos;
  return isOne ? first : std::string();
}

void useOwnWords(CLI::App &app) { app.formatter(std::make_shared<OwnWords>()); }

} // namespace arbiter::tools
