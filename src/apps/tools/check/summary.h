#pragma once
#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "apps/tools/check/checked_file.h"
#include "apps/tools/check/terminal.h"
#include "apps/tools/language.h"
#include "fp_compiler/resources.h"
#include "util/json.h"

namespace arbiter::tools {

/// Summarizes many files: the number with each status, the fullest file of each resource, and the
/// files that do not fit, with their first reason.
class Summary {
public:
  /// Counts suffices for line(), exitCode() and the numbers of each status.
  enum class Detail { Counts, Tables };
  explicit Summary(Detail detail = Detail::Tables) : m_detail(detail) {}
  void add(const CheckedFile &file);
  /// Counts a folder that could not be searched or was empty as an unreadable operand.
  void addFault() { ++m_faults; }

  /// Returns "4 files under r300: 2 valid, 1 over the native limits, 1 invalid". Names several
  /// profiles if panels select others.
  [[nodiscard]] std::string line(const fp::hw::Profile &profile) const;
  /// Returns the tables, or "" if they would be empty.
  [[nodiscard]] std::string tables(const Style &style) const;
  /// Writes the value of "summary", an object.
  void write(JsonWriter &json) const;

  /// Returns the exit code of the worst file: unreadable, then invalid, then over the limits.
  [[nodiscard]] int exitCode() const;

private:
  static constexpr std::size_t kLanguages = kLanguageCount;
  static constexpr std::size_t kResources = sizeof(fp::ResourceCounts) / sizeof(std::uint32_t);

  /// The file that uses the largest part of a native limit; of equals the first.
  struct Fullest {
    std::uint32_t used = 0;
    std::uint32_t limit = 0;
    std::string file;
  };
  struct Misfit {
    std::string file;
    const fp::ResourceRow *row = nullptr; ///< null if no count shows what is over
    std::optional<std::uint32_t> used;
    std::uint32_t limit = 0;
    std::string why;
    std::uint32_t amount = 0; ///< the part of `used` that `why` explains; 0: unknown
  };

  void addFullest(const CheckedFile &file);
  void addMisfit(const CheckedFile &file);
  [[nodiscard]] std::string fullestTable(const Style &style) const;
  [[nodiscard]] std::string misfitTable() const;
  [[nodiscard]] std::size_t count(FileStatus status) const { return m_counts[std::size_t(status)]; }

  Detail m_detail;
  std::array<std::size_t, 4> m_counts = {}; ///< number of programs by FileStatus
  std::size_t m_files = 0;
  std::string m_last; ///< name of the last added file
  std::size_t m_faults = 0;
  std::set<std::string> m_profiles;                    ///< names of the files' profiles
  std::array<std::size_t, kLanguages> m_programs = {}; ///< number of programs with counts, by
                                                       ///< ir::Language
  std::array<std::array<Fullest, kResources>, kLanguages> m_fullest;
  std::vector<Misfit> m_misfits;
};

} // namespace arbiter::tools
