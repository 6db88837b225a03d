#pragma once
#include <string>
#include <vector>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/resources.h"
#include "tools/check/checked_file.h"
#include "tools/check/terminal.h"

/// `arbiter check --profile all`: which cards a set of programs fits.
namespace arbiter::tools {

/// The name that stands for all cards where a profile is asked for.
inline constexpr const char *kAllCards = "all";

/// A resource of which a program needs more than a card has of its own.
struct OverCount {
  const fp::ResourceRow *row;
  std::uint32_t used, limit; ///< native
};

/// One program under one card.
struct CardCell {
  FileStatus status = FileStatus::Valid;
  bool hasLanguage = true; ///< false: the card has no programs of the language
  bool runsItself = true;  ///< false: it does not run those of the language, as lackOf() says
  std::vector<OverCount> over;
  /// What the card lacks, whatever the program is. Else, of one that is not valid, the first error
  /// with its line and column; of one that is over native the first reason of its model, if it has
  /// one.
  std::string why;
};

struct CardRow {
  std::string name; ///< titleOf() it; "-" is shown as "<stdin>"
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  std::vector<CardCell> cells; ///< one a card
  [[nodiscard]] bool loadsNowhere() const;
  [[nodiscard]] bool fitsNowhere() const;
};

/// A row a program, a column a built-in profile of a card.
class CardMatrix {
public:
  /// \param language as for checkFile()
  CardMatrix(std::string language, fp::LimitPolicy policy);

  /// Reads and checks one file under every card; "-" is standard input.
  /// \returns an empty string, or "name: reason"
  [[nodiscard]] std::string add(const std::string &path);
  /// An operand that could not be read or searched.
  void addFault() { ++m_faults; }

  [[nodiscard]] std::size_t size() const { return m_rows.size(); }
  /// \param reasons below the matrix, why each program does not fit
  [[nodiscard]] std::string text(const Style &style, bool reasons) const;
  [[nodiscard]] std::string json() const;
  /// 1: something could not be read; 2: a program is valid for no card; 3: one fits none; else 0.
  [[nodiscard]] int exitCode() const;

private:
  [[nodiscard]] std::size_t fitting(std::size_t card) const;

  const std::string m_language;
  const fp::LimitPolicy m_policy;
  std::vector<const fp::hw::Profile *> m_cards;
  std::vector<CardRow> m_rows;
  std::size_t m_files = 0;
  std::size_t m_faults = 0;
};

} // namespace arbiter::tools
