#include "apps/tools/check/text.h"

#include <algorithm>
#include <cstdio>

#include "apps/tools/advise/show.h"
#include "apps/tools/check/rendered.h"
#include "apps/tools/check/why.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

constexpr const char *kOverApi = "  over the API limit";
constexpr const char *kOverBoth = "  over the API limit and the native limit";
constexpr const char *kOverNative = "  over the native limit";
constexpr const char *kNotEnforced = "  over the API limit, which is not enforced";
constexpr const char *kOverNativeAlone = "  over the native limit; the API limit is not enforced";

bool isOver(const CheckedFile &file, std::uint32_t fp::ResourceCounts::*resource) {
  return file.result.nativeCounts.*resource > file.limits.native.*resource;
}

std::string tableHead(const Style &style) {
  char line[128];
  std::snprintf(line, sizeof line, "  %-18s%8s%8s%8s%8s", "resource", "used", "limit", "native",
                "limit");
  const int cells = style.blocks ? 10 : 12;
  char bars[64] = "";
  if (style.gauges)
    std::snprintf(bars, sizeof bars, "  %-*s native", cells, "API");
  return painted(std::string(line) + bars, Color::Dim, style) + "\n";
}

/// Says which limits a count exceeds, in the words of the compiler's warning. A card may announce a
/// limit of indirections and still load a program that exceeds it. A card that does not run the
/// program itself has no limits.
std::string overText(const CheckedFile &file, const fp::ResourceRow &row, const Style &style) {
  const bool overApi = file.result.counts.*row.member > file.limits.api.*row.member;
  const bool overNative = isOver(file, row.member) && file.lack().empty();
  const bool unenforced = overApi && row.member == &fp::ResourceCounts::texIndirections &&
                          file.limits.refuseIndirections == 0;
  if (!overApi && !overNative)
    return {};
  const char *text = overApi ? kOverApi : kOverNative;
  if (unenforced)
    text = overNative ? kOverNativeAlone : kNotEnforced;
  else if (overApi && overNative)
    text = kOverBoth;
  return painted(text, Color::Bad, style);
}

/// Returns a row that always begins with the four numbers, because scripts read them.
std::string tableRow(const CheckedFile &file, const fp::ResourceRow &row, const Style &style) {
  const std::uint32_t used = file.result.counts.*row.member;
  const std::uint32_t limit = file.limits.api.*row.member;
  const std::uint32_t nativeUsed = file.result.nativeCounts.*row.member;
  const std::uint32_t nativeLimit = file.limits.native.*row.member;
  char line[128];
  std::snprintf(line, sizeof line, "  %-18s%8u%8u%8u%8u", row.title, used, limit, nativeUsed,
                nativeLimit);
  std::string text = line;
  if (style.gauges)
    text += "  " + gauge(used, limit, style) + " " + gauge(nativeUsed, nativeLimit, style);
  return text + overText(file, row, style) + "\n";
}

/// True if a row's reasons explain why the program does not fit.
bool isToBlame(const CheckedFile &file, const fp::ResourceRow &row) {
  using fp::ResourceCounts;
  const auto rows = fp::resourceRows();
  const bool counted = std::any_of(rows.begin(), rows.end(), [&](const fp::ResourceRow &each) {
    return isOver(file, each.member);
  });
  // If no count is over its limit, any reason may be the cause.
  if (!counted)
    return file.status == FileStatus::OverNative;
  const bool part = row.member == &ResourceCounts::aluInstructions ||
                    row.member == &ResourceCounts::texInstructions;
  return isOver(file, row.member) || (part && isOver(file, &ResourceCounts::instructions));
}

std::string table(const CheckedFile &file, const Why &why, const TextOptions &options) {
  std::string text = tableHead(options.style);
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (!row.of(file.language))
      continue;
    text += tableRow(file, row, options.style);
    if (options.why || isToBlame(file, row))
      text += why.reasons(row);
  }
  return text;
}

std::string joined(const std::vector<std::string> &names) {
  std::string text;
  for (const std::string &each : names)
    text += (text.empty() ? "" : ", ") + each;
  return text;
}

const std::vector<advise::Advice> &adviceOf(const CheckedFile &file) {
  static const std::vector<advise::Advice> kNone;
  return file.advice ? *file.advice : kNone;
}

/// Returns "file: 3 fixes made: ALU 40 -> 31", and a list of the fixes.
std::string fixedText(const CheckedFile &file) {
  if (!file.fixed)
    return "";
  const std::size_t count = file.fixed->applied.size();
  std::string text = shown(file.title()) + ": " + std::to_string(count) +
                     (count == 1 ? " fix made" : " fixes made");
  if (count != 0)
    text += ": " + advise::changeText(file.fixed->before, file.fixed->after);
  if (file.fixed->stopped)
    text += "; the search stopped at its bound, so run it again";
  text += "\n";
  for (const advise::Advice &advice : file.fixed->applied)
    text += "  " + advice.message + " [" + advice.rule +
            "]: " + advise::changeText(advice.before, advice.after) + "\n";
  return text;
}

/// Returns what a program is over: "over the API limit of ALU instructions", "over the card's own
/// limits: ALU instructions 68 of 64"; empty if it is over none.
std::string overLimits(const CheckedFile &file) {
  if (!file.hasPrograms())
    return {};
  std::vector<std::string> names;
  if (file.isOverApiAlone()) {
    for (const fp::Diagnostic &each : file.result.diagnostics)
      if (each.severity == fp::Severity::Error) {
        const fp::ResourceRow *const row = limitedRow(each);
        names.emplace_back(row ? row->title : each.message);
      }
    return "over the API limit of " + joined(names);
  }
  if (file.status != FileStatus::OverNative || !file.lack().empty())
    return {};
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (row.of(file.language) && isOver(file, row.member))
      names.push_back(std::string(row.title) + " " +
                      std::to_string(file.result.nativeCounts.*row.member) + " of " +
                      std::to_string(file.limits.native.*row.member));
  return names.empty() ? "over the card's own limits"
                       : "over the card's own limits: " + joined(names);
}

/// Says that there is no advice. A program that is over a limit needs some, so that it is said of
/// which none is known.
std::string withoutAdvice(const CheckedFile &file) {
  const std::string over = overLimits(file);
  if (over.empty())
    return file.counted() ? shown(file.title()) + ": no advice\n" : "";
  return shown(file.title()) + ": " + over + "; no rewriting is known that takes less\n";
}

std::string adviceText(const CheckedFile &file, const Style &style) {
  std::string text;
  for (const advise::Advice &advice : adviceOf(file))
    text += advise::fullText(rendered(shown(file.name), file.text, advise::noteOf(advice), style),
                             file.text, advice);
  return file.advice && text.empty() ? withoutAdvice(file) : text;
}

} // namespace

std::string briefText(const CheckedFile &file, const Style &style) {
  std::string text;
  for (const fp::Diagnostic &diagnostic : file.result.diagnostics)
    if (file.isShown(diagnostic))
      text += renderedLine(shown(file.name), file.text, diagnostic, style) + "\n";
  text += fixedText(file);
  for (const advise::Advice &advice : adviceOf(file))
    text += advise::lineText(
        renderedLine(shown(file.name), file.text, advise::noteOf(advice), style), advice);
  if (file.advice && file.advice->empty() && !overLimits(file).empty())
    text += withoutAdvice(file);
  return text;
}

std::string lackText(const CheckedFile &file, const fp::hw::Profile &profile) {
  return file.hasPrograms() ? "" : shown(file.title()) + ": " + verdict(file, profile) + "\n";
}

std::string verdict(const CheckedFile &file, const fp::hw::Profile &profile) {
  if (!file.hasPrograms())
    return profile.name + ": " + std::string(file.lack());
  if (file.status == FileStatus::OverNative && !file.lack().empty())
    return "valid; " + std::string(file.lack());
  switch (file.status) {
  case FileStatus::Valid:
    return "valid, within the native limits of " + profile.name;
  case FileStatus::OverNative:
    return "valid, but over the native limits of " + profile.name;
  case FileStatus::Invalid:
  case FileStatus::Unreadable:
    break;
  }
  return name(file.status);
}

std::string fullText(const CheckedFile &file, const fp::hw::Profile &profile,
                     const TextOptions &options) {
  const Color color = file.status == FileStatus::Valid                              ? Color::Good
                      : file.status == FileStatus::OverNative && file.hasPrograms() ? Color::Close
                                                                                    : Color::Bad;
  const std::string line =
      shown(file.title()) + ": " + painted(verdict(file, profile), color, options.style) + "\n";
  std::string text = (file.hasPrograms() ? "" : line) + fixedText(file);
  for (const fp::Diagnostic &diagnostic : file.result.diagnostics) {
    if (!file.isShown(diagnostic))
      continue;
    text += rendered(shown(file.name), file.text, diagnostic, options.style);
    if (text.back() != '\n')
      text += '\n';
  }
  if (!file.hasPrograms())
    return text;
  text += line;
  if (!file.counted())
    return text + adviceText(file, options.style);
  const Why why(file, options.style, options.why);
  text += table(file, why, options) + why.headline();
  if (options.why)
    text += why.nodes() + why.chain() + why.cycles() + why.costs();
  // The number of indirections alone does not show the cause, but the chain does.
  else if (isOver(file, &fp::ResourceCounts::texIndirections))
    text += why.chain();
  return text + adviceText(file, options.style);
}

} // namespace arbiter::tools
