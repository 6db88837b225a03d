#pragma once
#include <span>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

/// How `arbiter check` shows a result: text for people and editors, JSON for programs.
namespace arbiter::tools {

enum class FileStatus { Valid, OverNative, Invalid, Unreadable };

struct CheckedFile {
  std::string name; ///< as given; "-" is shown as "<stdin>"
  std::string text;
  fp::ir::Language language = fp::ir::Language::ArbFragment;
  FileStatus status = FileStatus::Valid;
  std::string fault; ///< Unreadable: why
  fp::CheckResult result;
};

/// One row of the table of resources, in the order of fp::ResourceCounts. A target lists its own.
struct ResourceRow {
  const char *name; ///< "alu_instructions", as in a profile
  const char *title;
  std::uint32_t fp::ResourceCounts::*member;
  bool fragment;
  bool vertex;

  [[nodiscard]] bool of(fp::ir::Language language) const {
    return language == fp::ir::Language::ArbVertex ? vertex : fragment;
  }
};

[[nodiscard]] std::span<const ResourceRow> resourceRows();

/// Diagnostics ("file:line:col: error: text [ID]" and, unless brief, source, caret and hint), then
/// the counts against the limits.
[[nodiscard]] std::string asText(const CheckedFile &file, const fp::hw::Profile &profile,
                                 bool brief);

/// ARBITER_CHECK_SCHEMA of GL/arbiter.h; described in arbiter(1).
[[nodiscard]] std::string asJson(std::span<const CheckedFile> files,
                                 const fp::hw::Profile &profile);

} // namespace arbiter::tools
