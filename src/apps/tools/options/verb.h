#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// Describes a verb's options without CLI11's header, which takes long to compile. verb.cpp
/// translates the description for CLI11.
namespace arbiter::tools {

/// Returns whether help shows an option.
[[nodiscard]] bool isShown(const CLI::Option &option);

/// One option; each function adds one property.
class Option {
public:
  explicit Option(CLI::Option *option) : m_option(option) {}

  [[nodiscard]] CLI::Option *get() const { return m_option; }
  /// Accepts one of these words.
  Option oneOf(std::vector<std::string> words) const;
  /// Accepts one of these words, an existing file, or "-" for standard input.
  Option oneOfOrFile(std::vector<std::string> words) const;
  /// Accepts files; `gallery:NAME` names one of the gallery's.
  Option documents() const;
  Option range(int low, int high) const;
  Option range(double low, double high) const;
  /// Accepts a whole number over 0.
  Option positive() const;
  /// Shows the variable's current value as the default in help.
  Option showDefault() const;
  /// Accepts the option several times, with one value each time.
  Option repeatable() const;
  Option required() const;
  /// Accepts this many values.
  Option count(int least, int most) const;
  /// Hides the option from help.
  Option hidden() const;
  Option needs(const Option &other) const;
  Option needs(const std::string &name) const;
  Option excludes(const Option &other) const;
  Option excludes(const std::string &name) const;

private:
  CLI::Option *m_option;
};

/// Builds a subcommand of `arbiter`. Parsing writes the values to the given variables, which must
/// outlive it.
class Verb {
public:
  Verb(CLI::App &app, const std::string &name, const std::string &help);

  /// Adds an option or an operand.
  /// \param names "-o,--output"; an operand has no dash
  Option option(const std::string &names, std::string &value, const std::string &help);
  Option option(const std::string &names, std::vector<std::string> &values,
                const std::string &help);
  Option option(const std::string &names, int &value, const std::string &help);
  Option option(const std::string &names, double &value, const std::string &help);
  Option flag(const std::string &names, bool &value, const std::string &help = {});
  /// Adds a flag with an optional value, joined by "=". Without a value it is "true".
  Option flagOrValue(const std::string &names, std::string &value, const std::string &help);
  /// Sets the help text after the options.
  void footer(const std::string &text);
  /// Treats everything from the first operand on as another command line.
  void prefixCommand();

  /// Returns the number of its options so far, including --help.
  [[nodiscard]] std::size_t count() const;
  /// Puts the options from index `first` on into a group of help.
  void group(const std::string &name, std::size_t first);

  /// Hides the verb from help.
  void hide();

private:
  CLI::App *m_app;
};

/// A parsed command line's result for one option of a verb.
struct Said {
  std::string name;  ///< "--why"
  std::string group; ///< the group in help
  bool given = false;
  std::string value; ///< the first value, or the default
};
[[nodiscard]] std::vector<Said> saidOf(const CLI::App &verb);
[[nodiscard]] std::string nameOf(const CLI::App &verb);

} // namespace arbiter::tools
