#include "apps/tools/report/gauges.h"

#include <algorithm>

#include "apps/tools/check/why.h"
#include "apps/tools/page/html.h"
#include "fp_compiler/resources.h"

namespace arbiter::tools {

namespace {

/// Returns "used / limit", and the amount over the limit.
std::string figures(std::uint32_t used, std::uint32_t limit) {
  std::string html = number(used) + " / " + number(limit);
  if (used > limit)
    html = "<b class=over>" + html + "<br>over by " + number(used - limit) + "</b>";
  return html;
}

std::string percent(double part) { return decimal(100 * part) + "%"; }

} // namespace

std::string gaugeBar(std::uint32_t used, std::uint32_t limit) {
  const bool over = used > limit;
  const double part = over ? 1 : limit == 0 ? 0 : double(used) / limit;
  std::string html = over          ? "<span class=\"gauge full\" aria-hidden=true>"
                     : part >= 0.9 ? "<span class=\"gauge close\" aria-hidden=true>"
                                   : "<span class=gauge aria-hidden=true>";
  html += "<span style=\"width:" + percent(part) + "\"></span>";
  if (over)
    html += "<b style=\"left:" + percent(double(limit) / used) + "\"></b>";
  return html + "</span>";
}

std::string gaugeTable(const CheckedFile &file) {
  std::string html = "<table class=gauges><thead><tr><th scope=col>resource</th>"
                     "<th scope=col colspan=2>native: used / limit</th>"
                     "<th scope=col class=n>API: used / limit</th></tr></thead><tbody>\n";
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    if (!row.of(file.language))
      continue;
    const std::uint32_t used = file.result.nativeCounts.*row.member;
    const std::uint32_t limit = file.limits.native.*row.member;
    html += std::string("<tr><th scope=row>") + row.title + "</th>" + cell(gaugeBar(used, limit)) +
            "<td class=n>" + figures(used, limit) + "</td><td class=n>" +
            figures(file.result.counts.*row.member, file.limits.api.*row.member) + "</td></tr>\n";
  }
  return html + "</tbody></table>\n";
}

Fullest fullestOf(const CheckedFile &file) {
  Fullest fullest;
  for (const fp::ResourceRow &row : fp::resourceRows()) {
    const Fullest each{row.title, file.result.nativeCounts.*row.member,
                       file.limits.native.*row.member};
    if (row.of(file.language) && each.limit != 0 && each.part() > fullest.part())
      fullest = each;
  }
  return fullest;
}

} // namespace arbiter::tools
