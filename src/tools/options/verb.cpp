#include "tools/options/verb.h"

#include <CLI/CLI.hpp>

#include "tools/draw/gallery.h"

namespace arbiter::tools {

Option Option::oneOf(std::vector<std::string> words) const {
  return Option(m_option->check(CLI::IsMember(std::move(words))));
}

Option Option::oneOfOrFile(std::vector<std::string> words) const {
  return Option(m_option->check(CLI::IsMember(std::move(words)) | CLI::ExistingFile));
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
  return Option(m_option->check(CLI::Range(low, high)));
}

Option Option::range(double low, double high) const {
  return Option(m_option->check(CLI::Range(low, high)));
}

Option Option::positive() const { return Option(m_option->check(CLI::PositiveNumber)); }

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
