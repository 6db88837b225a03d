#pragma once
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fp_compiler/resources.h"
#include "tools/check/checked_file.h"
#include "tools/check/terminal.h"
#include "tools/language.h"
#include "util/json.h"

namespace arbiter::tools {

/// What many files came to: how many of each kind, the fullest of each resource, and those that do
/// not fit, with the first reason.
class Summary {
public:
  /// Counts: only line(), exitCode() and the numbers of each status will be asked for.
  enum class Detail { Counts, Tables };
  explicit Summary(Detail detail = Detail::Tables) : m_detail(detail) {}
  void add(const CheckedFile &file);
  /// A folder that could not be searched, or had nothing in it: an unreadable operand.
  void addFault() { ++m_faults; }

  /// "4 files under r300: 2 valid, 1 over the native limits, 1 invalid"; under others too where
  /// panels name them.
  [[nodiscard]] std::string line(const fp::hw::Profile &profile) const;
  /// The tables; empty if there is nothing to put into them.
  [[nodiscard]] std::string tables(const Style &style) const;
  /// The value of "summary": an object.
  void write(JsonWriter &json) const;

  /// The worst decides: what cannot be read, then what is invalid, then what is over the limits.
  [[nodiscard]] int exitCode() const;

private:
  static constexpr std::size_t kLanguages = kLanguageCount;
  static constexpr std::size_t kResources = sizeof(fp::ResourceCounts) / sizeof(std::uint32_t);

  /// The file that takes the largest part of a native limit; of equal ones the first.
  struct Fullest {
    std::uint32_t used = 0;
    std::uint32_t limit = 0;
    std::string file;
  };
  struct Misfit {
    std::string file;
    const fp::ResourceRow *row = nullptr; ///< none: over by what no count shows
    std::optional<std::uint32_t> used;
    std::uint32_t limit = 0;
    std::string why;
    std::uint32_t amount = 0; ///< of `used`, by `why`; 0 if it has none
  };

  void addFullest(const CheckedFile &file);
  void addMisfit(const CheckedFile &file);
  [[nodiscard]] std::string fullestTable(const Style &style) const;
  [[nodiscard]] std::string misfitTable() const;
  [[nodiscard]] std::size_t count(FileStatus status) const { return m_counts[std::size_t(status)]; }

  Detail m_detail;
  std::array<std::size_t, 4> m_counts = {}; ///< programs by FileStatus
  std::size_t m_files = 0;
  std::string m_last; ///< the name of the file that was added last
  std::size_t m_faults = 0;
  std::set<std::string> m_profiles;                    ///< names of those that files were judged by
  std::array<std::size_t, kLanguages> m_programs = {}; ///< with counts, by ir::Language
  std::array<std::array<Fullest, kResources>, kLanguages> m_fullest;
  std::vector<Misfit> m_misfits;
};

} // namespace arbiter::tools
