#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
} // namespace CLI

/// A verb's options, said without CLI11's header: reading it and making its templates takes longer
/// than the rest of `arbiter`. What is said here becomes CLI11's in verb.cpp.
namespace arbiter::tools {

/// One option. Each function says one more thing of it.
class Option {
public:
  explicit Option(CLI::Option *option) : m_option(option) {}

  [[nodiscard]] CLI::Option *get() const { return m_option; }
  /// One of these words.
  Option oneOf(std::vector<std::string> words) const;
  /// One of these words, or a file that is there, or standard input, "-".
  Option oneOfOrFile(std::vector<std::string> words) const;
  /// Files, of which `gallery:NAME` is one of the gallery's.
  Option documents() const;
  Option range(int low, int high) const;
  Option range(double low, double high) const;
  /// A whole number over 0.
  Option positive() const;
  /// Help has the value that the variable has now.
  Option showDefault() const;
  /// Once or more, a value each time.
  Option repeatable() const;
  Option required() const;
  /// So many values.
  Option count(int least, int most) const;
  /// Not in help.
  Option hidden() const;
  Option needs(const Option &other) const;
  Option needs(const std::string &name) const;
  Option excludes(const Option &other) const;
  Option excludes(const std::string &name) const;

private:
  CLI::Option *m_option;
};

/// A subcommand of `arbiter`, being made. Variables get their values when a command line is parsed,
/// and must outlive that.
class Verb {
public:
  Verb(CLI::App &app, const std::string &name, const std::string &help);

  /// \param names "-o,--output"; without a dash: an operand
  Option option(const std::string &names, std::string &value, const std::string &help);
  Option option(const std::string &names, std::vector<std::string> &values,
                const std::string &help);
  Option option(const std::string &names, int &value, const std::string &help);
  Option option(const std::string &names, double &value, const std::string &help);
  Option flag(const std::string &names, bool &value, const std::string &help = {});
  /// A flag that may have a value, joined to it by "=". Without one the value is "true".
  Option flagOrValue(const std::string &names, std::string &value, const std::string &help);
  /// What help says behind the options.
  void footer(const std::string &text);
  /// What begins with the first operand is another's command line.
  void prefixCommand();

  /// How many options it has so far, its own --help among them.
  [[nodiscard]] std::size_t count() const;
  /// Those from that one on stand in a group of help.
  void group(const std::string &name, std::size_t first);

  /// Not in help.
  void hide();

private:
  CLI::App *m_app;
};

/// What a command line that is parsed says of one option of a verb.
struct Said {
  std::string name;  ///< "--why"
  std::string group; ///< of help
  bool given = false;
  std::string value; ///< the first one, or the default
};
[[nodiscard]] std::vector<Said> saidOf(const CLI::App &verb);
[[nodiscard]] std::string nameOf(const CLI::App &verb);

} // namespace arbiter::tools
