#include "apps/tools/check/summary.h"

#include <algorithm>
#include <cstdio>

#include "apps/tools/commands.h"
#include "apps/tools/language.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

/// Returns the largest reason for a resource, preferably one with instructions. The total has no
/// reasons of its own, so that reasons for any resource count for it. The same is true without a
/// row, if no count shows what is over.
const fp::hw::Reason *reasonFor(const fp::hw::NativeReport &report, const fp::ResourceRow *row) {
  const bool any = row == nullptr || row->member == &fp::ResourceCounts::instructions;
  const fp::hw::Reason *found = nullptr;
  for (const fp::hw::Reason &reason : report.reasons) {
    if (!any && reason.resource != row->member)
      continue;
    if (!reason.instructions.empty())
      return &reason;
    if (found == nullptr)
      found = &reason;
  }
  return found;
}

/// Returns the first row that is over its limit, preferably one with a reason, or none.
const fp::ResourceRow *overRow(const CheckedFile &file) {
  const fp::ResourceRow *found = nullptr;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (file.result.nativeCounts.*row.member <= file.limits.native.*row.member)
      continue;
    if (row.member != &fp::ResourceCounts::instructions &&
        reasonFor(file.native(), &row) != nullptr)
      return &row;
    if (found == nullptr)
      found = &row;
  }
  return found;
}

} // namespace

void Summary::add(const CheckedFile &file) {
  if (file.profile != nullptr)
    m_profiles.insert(file.profile->name);
  ++m_counts[std::size_t(file.status)];
  if (!file.hasSiblings || m_last != file.name)
    ++m_files;
  m_last = file.name;
  if (m_detail == Detail::Counts)
    return;
  if (file.counted() && file.lack().empty()) {
    ++m_programs[std::size_t(file.language)];
    addFullest(file);
  }
  if (file.status == FileStatus::OverNative || file.status == FileStatus::Invalid)
    addMisfit(file);
}

void Summary::addFullest(const CheckedFile &file) {
  auto &fullest = m_fullest[std::size_t(file.language)];
  std::size_t at = 0;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    Fullest &held = fullest[at++];
    const std::uint32_t used = file.result.nativeCounts.*row.member;
    const std::uint32_t limit = file.limits.native.*row.member;
    // Compares used / limit without dividing by a limit of 0.
    const bool fuller = std::uint64_t(used) * std::max(held.limit, 1u) >
                        std::uint64_t(held.used) * std::max(limit, 1u);
    if (held.file.empty() || fuller)
      held = {used, limit, file.title()};
  }
}

void Summary::addMisfit(const CheckedFile &file) {
  if (!file.hasPrograms() || (file.counted() && !file.lack().empty())) {
    m_misfits.push_back({file.title(), nullptr, {}, 0, std::string(file.lack())});
    return;
  }
  if (file.status == FileStatus::Invalid) {
    for (const fp::Diagnostic &diagnostic : file.result.diagnostics) {
      if (diagnostic.severity != fp::Severity::Error)
        continue;
      if (!isOfLimit(diagnostic))
        return; // invalid for every card
      m_misfits.push_back({file.title(), limitedRow(diagnostic), {}, 0, diagnostic.message});
      return;
    }
    return;
  }
  Misfit misfit{file.title(), overRow(file), {}, 0, "", 0};
  if (misfit.row != nullptr) {
    misfit.used = file.result.nativeCounts.*misfit.row->member;
    misfit.limit = file.limits.native.*misfit.row->member;
  }
  if (const fp::hw::Reason *reason = reasonFor(file.native(), misfit.row)) {
    misfit.why = reason->text;
    misfit.amount = reason->amount;
  }
  m_misfits.push_back(std::move(misfit));
}

std::string Summary::line(const fp::hw::Profile &profile) const {
  std::size_t total = 0;
  for (const std::size_t each : m_counts)
    total += each;
  std::string names;
  for (const std::string &each : m_profiles)
    names += (names.empty() ? "" : ", ") + each;
  std::string text = std::to_string(m_files) + (m_files == 1 ? " file" : " files");
  if (total != m_files)
    text = std::to_string(total) + " programs in " + text;
  text += " under " + (names.empty() ? profile.name : names) + ": " +
          std::to_string(count(FileStatus::Valid)) + " valid";
  const auto add = [&](FileStatus status, const char *what) {
    if (count(status) != 0)
      text += ", " + std::to_string(count(status)) + " " + what;
  };
  add(FileStatus::OverNative, "over the native limits");
  add(FileStatus::Invalid, "invalid");
  add(FileStatus::Unreadable, "unreadable");
  return text + "\n";
}

std::string Summary::fullestTable(const Style &style) const {
  std::string text;
  for (const LanguageRow &language : languageRows()) {
    const std::size_t programs = m_programs[std::size_t(language.language)];
    if (programs == 0)
      continue;
    text += "the fullest of " + std::to_string(programs) + " " + (language.header + 2) +
            (programs == 1 ? " program" : " programs") + ":\n";
    std::size_t at = 0;
    for (const fp::ResourceRow &row : fp::resourceRows()) {
      const Fullest &held = m_fullest[std::size_t(language.language)][at++];
      if (!row.of(language.language))
        continue;
      char numbers[64];
      std::snprintf(numbers, sizeof numbers, "  %-18s%8u%8u  ", row.title, held.used, held.limit);
      text += numbers;
      if (style.gauges)
        text += gauge(held.used, held.limit, style) + "  ";
      text += shown(held.file) + "\n";
    }
  }
  return text;
}

std::string Summary::misfitTable() const {
  std::string text;
  for (const Misfit &misfit : m_misfits) {
    const char *title = misfit.row == nullptr ? "" : misfit.row->title;
    char numbers[64];
    if (misfit.used)
      std::snprintf(numbers, sizeof numbers, "  %-18s%8u%8u  ", title, *misfit.used, misfit.limit);
    else
      std::snprintf(numbers, sizeof numbers, "  %-18s%8s%8s  ", title, "-", "-");
    text += numbers + shown(misfit.file) + (misfit.why.empty() ? "" : ": " + misfit.why);
    text += misfit.amount == 0 ? "\n" : " (" + std::to_string(misfit.amount) + ")\n";
  }
  return text.empty() ? text : "do not fit:\n" + text;
}

std::string Summary::tables(const Style &style) const {
  return fullestTable(style) + misfitTable();
}

void Summary::write(JsonWriter &json) const {
  json.beginObject();
  json.key("valid").value(std::uint64_t(count(FileStatus::Valid)));
  json.key("over_native").value(std::uint64_t(count(FileStatus::OverNative)));
  json.key("invalid").value(std::uint64_t(count(FileStatus::Invalid)));
  json.key("unreadable").value(std::uint64_t(count(FileStatus::Unreadable)));
  json.key("fullest").beginArray();
  for (const LanguageRow &language : languageRows()) {
    if (m_programs[std::size_t(language.language)] == 0)
      continue;
    std::size_t at = 0;
    for (const fp::ResourceRow &row : fp::resourceRows()) {
      const Fullest &held = m_fullest[std::size_t(language.language)][at++];
      if (!row.of(language.language))
        continue;
      json.beginObject();
      json.key("language").value(language.header + 2).key("resource").value(row.name);
      json.key("native_used").value(held.used).key("native_limit").value(held.limit);
      json.key("file").value(held.file);
      json.endObject();
    }
  }
  json.endArray();
  json.key("misfits").beginArray();
  for (const Misfit &misfit : m_misfits) {
    json.beginObject();
    json.key("file").value(misfit.file);
    if (misfit.row != nullptr)
      json.key("resource").value(misfit.row->name);
    if (misfit.used)
      json.key("native_used").value(*misfit.used).key("native_limit").value(misfit.limit);
    json.key("why").value(misfit.why);
    if (misfit.amount != 0)
      json.key("amount").value(misfit.amount);
    json.endObject();
  }
  json.endArray();
  json.endObject();
}

int Summary::exitCode() const {
  if (m_faults != 0 || count(FileStatus::Unreadable) != 0)
    return kExitUsage;
  if (count(FileStatus::Invalid) != 0)
    return kExitInvalid;
  return count(FileStatus::OverNative) != 0 ? kExitOverNative : kExitOk;
}

} // namespace arbiter::tools
