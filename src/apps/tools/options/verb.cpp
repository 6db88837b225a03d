#include "apps/tools/options/verb.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <sys/stat.h>

#include "apps/tools/draw/gallery.h"
#include "util/suggest.h"

namespace arbiter::tools {

namespace {

std::string listed(const std::vector<std::string> &words, const char *last) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? last : ", ") + words[i];
  return text;
}

/// Returns why there is no file of that name to read.
std::string whyNoFile(const std::string &name) {
  struct stat status = {};
  return std::strerror(::stat(name.c_str(), &status) == 0 ? EISDIR : errno);
}

/// Accepts one of the words, or a value that `takes` accepts. Replaces CLI11's validator, whose
/// message is "x not in {a,b}".
CLI::Validator among(std::vector<std::string> words, const std::string &other,
                     const std::function<bool(const std::string &)> &takes) {
  const std::string shown =
      "{" + CLI::detail::join(words) + "}" + (other.empty() ? "" : " OR FILE");
  const auto check = [words = std::move(words), other, takes](std::string &value) {
    if (std::find(words.begin(), words.end(), value) != words.end() || takes(value))
      return std::string();
    if (!other.empty() && value.find_first_of("./") != std::string::npos)
      return value + ": " + whyNoFile(value);
    const std::vector<std::string_view> views(words.begin(), words.end());
    const std::string_view near = nearest(value, views);
    return value + ": expected " + listed(words, other.empty() ? " or " : ", ") + other +
           (near.empty() ? "" : "; did you mean " + std::string(near) + "?");
  };
  return {check, shown};
}

std::string numberText(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

template <typename T> CLI::Validator between(T low, T high, const char *what) {
  const bool open = high == std::numeric_limits<T>::max();
  const std::string range = numberText(low) + (open ? " or more" : " to " + numberText(high));
  const auto check = [=](std::string &text) {
    T value;
    if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high)
      return std::string();
    return text + ": expected " + what + (open ? ", " : " from ") + range;
  };
  return {check, range};
}

} // namespace

bool isShown(const CLI::Option &option) { return !option.get_group().empty(); }

Option Option::oneOf(std::vector<std::string> words) const {
  return Option(
      m_option->check(among(std::move(words), "", [](const std::string &) { return false; })));
}

Option Option::oneOfOrFile(std::vector<std::string> words) const {
  return Option(m_option->check(among(std::move(words), " or a file", [](const std::string &name) {
    return name == "-" || CLI::ExistingFile(name).empty();
  })));
}

Option Option::documents() const {
  const auto path = [](std::string &name) {
    const auto found = documentPath(name);
    if (found)
      name = found.value();
    return found ? std::string() : found.error().message;
  };
  return Option(m_option->transform(CLI::Validator(path, "")));
}

Option Option::range(int low, int high) const {
  return Option(m_option->check(between(low, high, "a whole number")));
}

Option Option::range(double low, double high) const {
  return Option(m_option->check(between(low, high, "a number")));
}

Option Option::positive() const {
  return Option(m_option->check(between(1, std::numeric_limits<int>::max(), "a whole number")));
}

Option Option::showDefault() const { return Option(m_option->capture_default_str()); }

Option Option::repeatable() const { return Option(m_option->allow_extra_args(false)->take_all()); }

Option Option::required() const { return Option(m_option->required()); }

Option Option::count(int least, int most) const { return Option(m_option->expected(least, most)); }

Option Option::hidden() const { return Option(m_option->group("")); }

Option Option::needs(const Option &other) const { return Option(m_option->needs(other.get())); }

Option Option::needs(const std::string &name) const { return Option(m_option->needs(name)); }

Option Option::excludes(const Option &other) const {
  return Option(m_option->excludes(other.get()));
}

Option Option::excludes(const std::string &name) const { return Option(m_option->excludes(name)); }

Verb::Verb(CLI::App &app, const std::string &name, const std::string &help)
    : m_app(app.add_subcommand(name, help)) {}

Option Verb::option(const std::string &names, std::string &value, const std::string &help) {
  return Option(m_app->add_option(names, value, help));
}

Option Verb::option(const std::string &names, std::vector<std::string> &values,
                    const std::string &help) {
  return Option(m_app->add_option(names, values, help));
}

Option Verb::option(const std::string &names, int &value, const std::string &help) {
  return Option(m_app->add_option(names, value, help));
}

Option Verb::option(const std::string &names, double &value, const std::string &help) {
  return Option(m_app->add_option(names, value, help));
}

Option Verb::flag(const std::string &names, bool &value, const std::string &help) {
  return Option(m_app->add_flag(names, value, help));
}

Option Verb::flagOrValue(const std::string &names, std::string &value, const std::string &help) {
  return Option(m_app->add_flag(names, value, help));
}

void Verb::footer(const std::string &text) { m_app->footer(text); }

void Verb::prefixCommand() { m_app->prefix_command(); }

std::size_t Verb::count() const {
  return static_cast<const CLI::App *>(m_app)->get_options({}).size();
}

void Verb::group(const std::string &name, std::size_t first) {
  const std::vector<CLI::Option *> options = m_app->get_options({});
  for (std::size_t i = first; i < options.size(); ++i)
    options[i]->group(name);
}

void Verb::hide() { m_app->group(""); }

std::vector<Said> saidOf(const CLI::App &verb) {
  std::vector<Said> all;
  for (const CLI::Option *option : verb.get_options())
    all.push_back(
        {option->get_name(), option->get_group(), option->count() != 0,
         option->results().empty() ? option->get_default_str() : option->results().front()});
  return all;
}

std::string nameOf(const CLI::App &verb) { return verb.get_name(); }

} // namespace arbiter::tools
