#include "apps/tools/report/histogram.h"

#include <algorithm>

#include "apps/tools/check/why.h"
#include "apps/tools/page/html.h"

namespace arbiter::tools {

namespace {

constexpr std::uint64_t kFewestBins = 8, kMaxBins = 24;

// Dimensions of the drawing in its own units.
constexpr double kWidth = 720, kHeight = 220, kLeft = 40, kRight = 12, kTop = 26, kBottom = 38;
constexpr double kPlotWidth = kWidth - kLeft - kRight, kPlotHeight = kHeight - kTop - kBottom;

std::string label(const Histogram &histogram, const Histogram::Bin &bin) {
  const bool last = &bin == &histogram.bins.back();
  if (last && histogram.open)
    return number(bin.first) + " and more";
  if (bin.first == bin.last)
    return number(bin.first);
  return number(bin.first) + "\xE2\x80\x93" + number(bin.last);
}

std::string attribute(const char *name, double value) {
  return std::string(" ") + name + "=\"" + decimal(value) + "\"";
}

std::string textAt(double x, double y, const char *anchor, const std::string &text) {
  return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=" + anchor + ">" + text +
         "</text>";
}

/// Returns a bar with its count above it.
std::string bar(const Histogram &histogram, std::size_t i, std::uint32_t highest) {
  const Histogram::Bin &bin = histogram.bins[i];
  if (bin.programs == 0)
    return {};
  const double step = kPlotWidth / double(histogram.bins.size());
  const double x = kLeft + step * double(i);
  const double height = std::max(2.0, kPlotHeight * bin.programs / highest);
  const double y = kTop + kPlotHeight - height;
  const bool over = bin.last > histogram.limit; // the limit lies between two bins
  return "<rect" + attribute("x", x + 1) + attribute("y", y) + attribute("width", step - 2) +
         attribute("height", height) + (over ? " class=beyond" : "") + "><title>" +
         label(histogram, bin) + ": " + counted(bin.programs, "program") + "</title></rect>" +
         textAt(x + step / 2, y - 4, "middle", number(bin.programs));
}

/// Returns the axis with as many amounts below the bars as fit.
std::string axis(const Histogram &histogram) {
  const double step = kPlotWidth / double(histogram.bins.size());
  const std::size_t every = histogram.bins.size() > 12 ? 2 : 1;
  std::string html = "<path d=\"M" + decimal(kLeft) + " " + decimal(kTop + kPlotHeight) + "h" +
                     decimal(kPlotWidth) + "\"/>";
  for (std::size_t i = 0; i < histogram.bins.size(); i += every) {
    const bool last = i + 1 == histogram.bins.size();
    const Histogram::Bin &bin = histogram.bins[i];
    html += textAt(kLeft + step * (double(i) + .5), kHeight - 22, "middle",
                   last && histogram.open ? number(bin.first) + "+" : number(bin.last));
  }
  return html;
}

/// Returns the limit's line between two bins, or a text if the limit is beyond the axis.
std::string limitLine(const Histogram &histogram) {
  const std::string word = "limit " + number(histogram.limit);
  std::size_t before = 0; // number of bins within the limit
  while (before < histogram.bins.size() && histogram.bins[before].last <= histogram.limit)
    ++before;
  if (histogram.limit > histogram.bins.back().last)
    return textAt(kWidth - kRight, 15, "end", word + ", beyond the axis \xE2\x86\x92");
  const double x = kLeft + kPlotWidth * double(before) / double(histogram.bins.size());
  const bool right = x > kLeft + kPlotWidth * .8;
  return "<path class=limit d=\"M" + decimal(x) + " 6V" + decimal(kTop + kPlotHeight) + "\"/>" +
         textAt(right ? x - 5 : x + 5, 15, right ? "end" : "start", word);
}

} // namespace

Histogram histogramOf(const std::vector<std::uint32_t> &amounts, std::uint32_t limit) {
  Histogram histogram;
  histogram.limit = limit;
  if (amounts.empty())
    return histogram;
  const std::uint64_t largest = *std::max_element(amounts.begin(), amounts.end());
  std::uint64_t end = std::max(largest, kFewestBins);
  if (limit != 0 && limit <= 4 * largest)
    end = std::clamp<std::uint64_t>(end, limit, 2 * std::uint64_t(limit));
  std::uint64_t width = 1;
  while ((end + width - 1) / width > kMaxBins)
    width *= 2;
  // A bin also ends at the limit if that is not a multiple of the width.
  for (std::uint64_t first = 1; first <= end;) {
    std::uint64_t last = (first + width - 1) / width * width;
    if (first <= limit && limit < last)
      last = limit;
    histogram.bins.push_back({std::uint32_t(first), std::uint32_t(last), 0});
    first = last + 1;
  }
  histogram.bins.front().first = 0;
  histogram.open = largest > histogram.bins.back().last;
  for (const std::uint32_t amount : amounts) {
    const auto bin = std::find_if(histogram.bins.begin(), histogram.bins.end(),
                                  [&](const auto &each) { return amount <= each.last; });
    ++(bin == histogram.bins.end() ? histogram.bins.back() : *bin).programs;
  }
  return histogram;
}

std::string drawing(const Histogram &histogram, const std::string &what) {
  if (histogram.bins.empty())
    return {};
  std::uint32_t highest = 1;
  for (const Histogram::Bin &bin : histogram.bins)
    highest = std::max(highest, bin.programs);
  std::string html = "<figure><svg class=histogram viewBox=\"0 0 " + decimal(kWidth) + " " +
                     decimal(kHeight) + "\" role=img aria-label=\"Programs by " +
                     escapedAttribute(what) + "; the figures are in the table below\">";
  html += axis(histogram);
  for (std::size_t i = 0; i < histogram.bins.size(); ++i)
    html += bar(histogram, i, highest);
  html += limitLine(histogram) +
          textAt(kLeft + kPlotWidth / 2, kHeight - 4, "middle", escaped(what)) + "</svg>\n";
  html += "<details><summary>Figures</summary><table><tr><th>" + escaped(what) +
          "</th><th class=n>programs</th></tr>\n";
  for (const Histogram::Bin &bin : histogram.bins)
    if (bin.programs != 0)
      html += "<tr>" + cell(label(histogram, bin)) + numberCell(bin.programs) + "</tr>\n";
  return html + "</table></details></figure>\n";
}

} // namespace arbiter::tools
