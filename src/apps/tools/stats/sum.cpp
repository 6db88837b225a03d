#include "apps/tools/stats/sum.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "apps/tools/input.h"

namespace arbiter::tools::stats {

namespace {

using Json = nlohmann::json;
using Counts = std::map<std::string, std::uint64_t>;

constexpr int kFirstSchema = 2; // the first with members of these names

/// Returns the word of a path or a reason. Files of schema 3 have hyphens in it, and those of
/// schema 2 another word for one path.
std::string wordNow(std::string word) {
  std::replace(word.begin(), word.end(), '-', '_');
  return word == "recorded" ? "recorded_in_list" : word;
}

void addCounts(Counts &counts, const Json &from) {
  for (const auto &[name, count] : from.items()) {
    if (!count.is_number_unsigned() || count == 0u)
      continue;
    counts[wordNow(name)] += count.get<std::uint64_t>();
  }
}

void readPrograms(const Json &json, Figures &figures) {
  figures.programs = json.at("programs_not_listed").get<std::uint64_t>();
  for (const Json &program : json.at("programs")) {
    ++figures.programs;
    figures.overNative += program.value("under_native_limits", true) ? 0u : 1u;
    const Json &error = program.at("error");
    figures.refused += error.is_object() && error.contains("refused_by_profile") ? 1u : 0u;
  }
}

Report reportOf(const Json &json) {
  Report report;
  Figures &figures = report.figures;
  figures.files = 1;
  figures.contexts =
      json.at("contexts").size() + json.at("contexts_not_listed").get<std::uint64_t>();
  figures.frames = json.at("frames").get<std::uint64_t>();
  readPrograms(json, figures);
  Json draws = json.at("draws");
  addCounts(figures.draws, draws.at("reasons"));
  for (const char *const sum : {"host_untouched", "dropped"}) // of the reasons
    draws.erase(sum);
  addCounts(figures.draws, draws);
  addCounts(figures.givenToHost, json.at("software").at("given_to_host"));
  if (const Json &defaults = json.at("defaults"); defaults.is_object()) {
    const Json &program = defaults.at("program");
    const Json &windows = program.at("windows");
    report.program = (windows.is_string() ? windows : program.at("name")).get<std::string>();
  }
  return report;
}

/// Returns "a 3  b 1", most first.
std::string words(const Counts &counts) {
  std::vector<std::pair<std::string, std::uint64_t>> sorted(counts.begin(), counts.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto &a, const auto &b) { return a.second > b.second; });
  std::string text;
  for (const auto &[word, count] : sorted)
    text += (text.empty() ? "" : "  ") + word + " " + std::to_string(count);
  return text;
}

void writeCounts(JsonWriter &json, const char *key, const Counts &counts) {
  json.key(key).beginObject();
  for (const auto &[word, count] : counts)
    json.key(word.c_str()).value(count);
  json.endObject();
}

} // namespace

void Figures::add(const Figures &others) {
  files += others.files;
  contexts += others.contexts;
  frames += others.frames;
  programs += others.programs;
  overNative += others.overNative;
  refused += others.refused;
  for (const auto &[word, count] : others.draws)
    draws[word] += count;
  for (const auto &[word, count] : others.givenToHost)
    givenToHost[word] += count;
}

std::string Figures::line() const {
  std::string text = "frames " + std::to_string(frames) + "  programs " + std::to_string(programs);
  if (overNative != 0)
    text += "  over native " + std::to_string(overNative);
  if (refused != 0)
    text += "  refused " + std::to_string(refused);
  return text + "  " + (draws.empty() ? "no draws" : words(draws));
}

std::string Figures::reasonsLine() const { return words(givenToHost); }

void Figures::write(JsonWriter &json) const {
  json.key("contexts").value(contexts).key("frames").value(frames);
  json.key("programs").value(programs).key("over_native").value(overNative);
  json.key("refused").value(refused);
  writeCounts(json, "draws", draws);
  writeCounts(json, "given_to_host", givenToHost);
}

Result<Report, std::string> readReport(const std::string &path) {
  const auto text = readInput(path);
  if (!text)
    return text.error().message;
  const Json json = Json::parse(text.value(), nullptr, false);
  const int schema = json.is_object() && json.contains("schema") && json["schema"].is_number()
                         ? json["schema"].get<int>()
                         : 0;
  try {
    if (schema >= kFirstSchema && schema <= ARBITER_STATS_SCHEMA)
      return reportOf(json);
  } catch (const Json::exception &) { // a member is missing
    return path + ": is no file of statistics";
  }
  return path + (schema > ARBITER_STATS_SCHEMA ? ": was written by a later version of Arbiter"
                                               : ": is no file of statistics");
}

} // namespace arbiter::tools::stats
