#pragma once
#include <optional>
#include <string>
#include <vector>

#include "apps/tools/check/checked_file.h"
#include "apps/tools/check/terminal.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/resources.h"

/// Implements `arbiter check --profile all`, which shows the cards that a set of programs fits.
namespace arbiter::tools {

/// The profile name that stands for all cards.
inline constexpr const char *kAllCards = "all";

/// A resource of which a program needs more than a card has natively.
struct OverCount {
  const fp::ResourceRow *row;
  std::uint32_t used, limit; ///< native
};

/// The result of one program on one card.
struct CardCell {
  FileStatus status = FileStatus::Valid;
  bool hasLanguage = true; ///< false if the card has no programs of the language
  bool runsItself = true;  ///< false if the card does not run them itself, as lackOf() says
  std::vector<OverCount> over;
  /// Says why the card runs no such program. If it runs them: the first error of an invalid
  /// program, with its line and column, or the first reason of the card's model for a count that is
  /// over its native limit.
  std::string why;
  /// The further errors, or every reason with its instructions, as indented lines. Filled only if
  /// the matrix was asked for details.
  std::string details;
};

struct CardRow {
  std::string name; ///< its titleOf(); "-" is shown as "<stdin>"
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  std::vector<CardCell> cells; ///< one for each card
  [[nodiscard]] bool loadsNowhere() const;
  [[nodiscard]] bool fitsNowhere() const;
};

/// A matrix with a row for each program and a column for each built-in profile of a card.
class CardMatrix {
public:
  /// \param language as for checkFile()
  /// \param details the style of CardCell::details; empty: there are none
  CardMatrix(std::string language, fp::LimitPolicy policy, std::optional<Style> details = {});

  /// Reads and checks one file for every card; "-" is standard input.
  /// \returns an empty string, or "name: reason"
  [[nodiscard]] std::string add(const std::string &path);
  /// Counts an operand that could not be read or searched.
  void addFault() { ++m_faults; }

  [[nodiscard]] std::size_t size() const { return m_rows.size(); }
  /// Returns the matrix as text; each column is headed by the card's name and its profile's.
  /// \param reasons adds below the matrix why each program does not fit, once for all cards that
  /// have the same reason
  [[nodiscard]] std::string text(const Style &style, bool reasons) const;
  [[nodiscard]] std::string json() const;
  /// Returns 1 if something could not be read, 2 if a program is valid for no card, 3 if one fits
  /// no card, else 0.
  [[nodiscard]] int exitCode() const;

private:
  [[nodiscard]] std::size_t fitting(std::size_t card) const;
  [[nodiscard]] std::string head(std::size_t width, const Style &style) const;
  [[nodiscard]] std::size_t columnOf(std::size_t card) const;
  [[nodiscard]] std::string outcome() const;
  [[nodiscard]] std::string reasonsOf(const CardRow &row) const;

  const std::string m_language;
  const fp::LimitPolicy m_policy;
  const std::optional<Style> m_details;
  std::vector<const fp::hw::Profile *> m_cards;
  std::vector<CardRow> m_rows;
  std::size_t m_files = 0;
  std::size_t m_faults = 0;
};

} // namespace arbiter::tools
