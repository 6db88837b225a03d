#include "apps/tools/capture_index.h"

#include <GL/arbiter.h>
#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "fp_compiler/file_programs.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/resources.h"
#include "util/hash.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr CaptureTarget kTargets[] = {
    {"fragment", ".fp", fp::ir::Language::ArbFragment},
    {"vertex", ".vp", fp::ir::Language::ArbVertex},
    {"ati_fragment", ".atifs", fp::ir::Language::AtiFragment},
    {"ati_fragment_api", ".atifs", fp::ir::Language::AtiFragment},
    {"combiners", ".nvrc", fp::ir::Language::Combiners},
    {"texture_shaders", ".nvts", fp::ir::Language::TextureShaders},
    {"vertex_state", ".vsp", fp::ir::Language::ArbVertex}, // the header decides
};

using Programs = std::map<std::string, CapturedProgram>; ///< by file name

fp::ResourceCounts readCounts(const Json &json) {
  fp::ResourceCounts counts;
  for (const fp::ResourceRow &row : fp::resourceRows())
    counts.*row.member = json.value(row.name, 0u);
  return counts;
}

/// Returns a number. NaN and infinity are written as null, and are read as 0.
double readNumber(const Json &json) { return json.is_number() ? json.get<double>() : 0.0; }

void readUse(const Json &json, CapturedProgram &program) {
  program.parameters.clear();
  for (const Json &row : json.at("parameters")) {
    CapturedParameter &parameter = program.parameters.emplace_back();
    parameter.name = row.at("name").get<std::string>();
    for (std::size_t i = 0; i < 4; ++i)
      parameter.value[i] = readNumber(row.at("value").at(i));
  }
  program.textures.clear();
  for (const Json &row : json.at("textures")) {
    CapturedTexture &texture = program.textures.emplace_back();
    texture.unit = row.at("unit").get<unsigned>();
    texture.target = row.at("target").get<std::string>();
    texture.name = row.at("name").get<unsigned>();
    texture.width = row.at("width").get<unsigned>();
    texture.height = row.at("height").get<unsigned>();
    texture.depth = row.at("depth").get<unsigned>();
    texture.format = row.at("format").get<std::string>();
    texture.enabled = row.at("enabled").get<std::vector<std::string>>();
  }
}

/// Adds the draws by path. A record of an earlier version has one path for all draws.
void addPaths(const Json &json, CapturedProgram &program) {
  const auto draws = json.at("draws").get<std::uint64_t>();
  if (!json.contains("draws_by") && draws != 0)
    program.drawsBy[json.at("path").get<std::string>()] += draws;
  if (json.contains("draws_by"))
    for (const auto &[path, count] : json.at("draws_by").items())
      program.drawsBy[path] += count.get<std::uint64_t>();
}

/// Adds one process's record of a program to the data of other processes.
void mergeProgram(const Json &json, std::uint64_t process, Programs &programs) {
  const CaptureTarget *const target = findCaptureTarget(json.at("target").get<std::string>());
  const auto hash = json.at("hash").get<std::string>();
  const auto it = target ? programs.find(hash + target->extension) : programs.end();
  if (it == programs.end())
    return; // the user removed its text
  CapturedProgram &program = it->second;
  program.target = target; // the record decides among targets with the same extension
  program.recorded = true;
  program.loads += json.at("loads").get<std::uint64_t>();
  program.frames += json.at("frames").get<std::uint64_t>();
  program.draws += json.at("draws").get<std::uint64_t>();
  addPaths(json, program);
  program.replaced |= json.at("replaced").get<bool>();
  std::set<std::uint32_t> &contexts = program.processes[process];
  for (const Json &context : json.at("contexts"))
    contexts.insert(context.get<std::uint32_t>());
  program.options = json.at("options").get<std::vector<std::string>>();
  if (json.contains("counts")) {
    program.counted = true;
    program.counts = readCounts(json.at("counts"));
    program.nativeCounts = readCounts(json.at("native_counts"));
    program.underNativeLimits = json.at("under_native_limits").get<bool>();
  }
  program.warning = json.value("warning", program.warning);
  if (!json.at("error").is_null()) {
    program.errorPosition = json.at("error").at("position").get<std::int64_t>();
    program.error = json.at("error").at("text").get<std::string>();
  }
  const auto lastUse = json.at("last_use").get<std::int64_t>();
  if (lastUse <= program.lastUse)
    return;
  readUse(json, program);
  program.lastUse = lastUse;
}

void mergeRecord(const Json &json, CaptureIndex &index, Programs &programs) {
  if (json.at("schema").get<int>() != ARBITER_CAPTURE_SCHEMA)
    throw std::runtime_error("written by another version");
  CapturedProcess process;
  process.pid = json.at("pid").get<std::uint64_t>();
  process.command = json.at("command").get<std::string>();
  process.profile = json.at("profile").get<std::string>();
  process.frames = json.at("frames").get<std::uint64_t>();
  process.contexts = json.at("contexts_made").get<std::uint64_t>();
  process.notListed = json.at("programs_not_listed").get<std::uint64_t>();
  process.complete = json.at("complete").get<bool>();
  process.programs = json.at("programs").size();
  process.notWritten = json.at("files_not_written").get<std::uint64_t>();
  process.whyNotWritten = json.value("why_not_written", "");
  for (const Json &program : json.at("programs"))
    mergeProgram(program, process.pid, programs);
  index.profile = process.profile;
  index.processes.push_back(std::move(process));
}

/// Compiles a text that has no record, as the layer would have done.
void compileHere(CapturedProgram &program, const fp::hw::Profile &profile) {
  fp::CompileOptions options;
  options.limits = limitsOf(profile, program.target->language);
  options.policy = fp::LimitPolicy::Report;
  const fp::CheckResult result = fp::checkProgramIn(
      program.text, fp::programOf(program.text, program.target->language), options);
  program.counted = result.ok();
  program.counts = result.counts;
  program.nativeCounts = result.nativeCounts;
  program.underNativeLimits = result.underNativeLimits;
  program.errorPosition = result.errorPosition();
  (result.ok() ? program.warning : program.error) = result.errorString(program.text);
}

bool isRecord(const std::string &name) {
  return name.starts_with("process-") && name.ends_with(".json");
}

void writeCounts(JsonWriter &json, const char *key, const fp::ResourceCounts &counts,
                 fp::ir::Language language) {
  json.key(key).beginObject();
  for (const fp::ResourceRow &row : fp::resourceRows())
    if (row.of(language))
      json.key(row.name).value(counts.*row.member);
  json.endObject();
}

void writeUse(JsonWriter &json, const CapturedProgram &program) {
  json.key("parameters").beginArray();
  for (const CapturedParameter &parameter : program.parameters) {
    json.beginObject().key("name").value(parameter.name).key("value").beginArray();
    for (const double component : parameter.value)
      json.value(component);
    json.endArray().endObject();
  }
  json.endArray();
  json.key("textures").beginArray();
  for (const CapturedTexture &texture : program.textures) {
    json.beginObject().key("unit").value(texture.unit).key("target").value(texture.target);
    json.key("name").value(texture.name).key("width").value(texture.width);
    json.key("height").value(texture.height).key("depth").value(texture.depth);
    json.key("format").value(texture.format).key("enabled").beginArray();
    for (const std::string &name : texture.enabled)
      json.value(name);
    json.endArray().endObject();
  }
  json.endArray();
}

void writeProgram(JsonWriter &json, const CapturedProgram &program) {
  json.beginObject();
  json.key("hash").value(program.hash).key("target").value(program.target->word);
  json.key("file").value(program.file());
  json.key("bytes").value(std::uint64_t(program.text.size()));
  json.key("edited").value(program.edited).key("replaced").value(program.replaced);
  json.key("loads").value(program.loads).key("frames").value(program.frames);
  json.key("draws").value(program.draws).key("path").value(program.path());
  json.key("draws_by").beginObject();
  for (const auto &[path, count] : program.drawsBy)
    json.key(path.c_str()).value(count);
  json.endObject();
  json.key("processes").beginArray();
  for (const auto &[pid, contexts] : program.processes) {
    json.beginObject().key("pid").value(pid).key("contexts").beginArray();
    for (const std::uint32_t context : contexts)
      json.value(context);
    json.endArray().endObject();
  }
  json.endArray().key("options").beginArray();
  for (const std::string &option : program.options)
    json.value(option);
  json.endArray();
  if (program.counted) {
    writeCounts(json, "counts", program.counts, program.target->language);
    writeCounts(json, "native_counts", program.nativeCounts, program.target->language);
    json.key("under_native_limits").value(program.underNativeLimits);
  }
  json.key("error");
  if (program.error.empty()) {
    json.null();
  } else {
    const auto at = std::uint32_t(std::max<std::int64_t>(program.errorPosition, 0));
    const fp::LineColumn place = fp::locate(program.text, at);
    json.beginObject().key("position").value(program.errorPosition);
    json.key("line").value(place.line).key("column").value(place.column);
    json.key("text").value(program.error).endObject();
  }
  if (!program.warning.empty())
    json.key("warning").value(program.warning);
  writeUse(json, program);
  if (!program.glsl.empty())
    json.key("glsl").value(program.glsl);
  json.endObject();
}

} // namespace

std::size_t CapturedProgram::contextCount() const {
  std::size_t count = 0;
  for (const auto &[pid, contexts] : processes)
    count += contexts.size();
  return count;
}

std::string CapturedProgram::path() const {
  if (drawsBy.size() == 1)
    return drawsBy.begin()->first;
  std::vector<std::pair<std::string, std::uint64_t>> sorted(drawsBy.begin(), drawsBy.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto &a, const auto &b) { return a.second > b.second; });
  std::string all;
  for (const auto &[name, count] : sorted)
    all += (all.empty() ? "" : ", ") + name + " " + std::to_string(count);
  return all;
}

const CaptureTarget *findCaptureTarget(std::string_view word) {
  for (const CaptureTarget &target : kTargets)
    if (word == target.word)
      return &target;
  return nullptr;
}

const CaptureTarget *captureTargetOf(const std::string &fileName) {
  constexpr std::size_t kDigits = 32;
  if (fileName.find_first_not_of("0123456789abcdef") != kDigits)
    return nullptr;
  for (const CaptureTarget &target : kTargets)
    if (fileName.substr(kDigits) == target.extension)
      return &target;
  return nullptr;
}

std::vector<std::string> editedTexts(const std::string &folder) {
  std::vector<std::string> edited;
  std::error_code error;
  for (const auto &entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    const auto text = captureTargetOf(name) ? readInput(entry.path()) : FileError{};
    if (text.ok() && toHex(hashBytes(text.value())) != name.substr(0, 32))
      edited.push_back(entry.path());
  }
  std::sort(edited.begin(), edited.end());
  return edited;
}

CaptureIndex readCapture(const std::string &folder) {
  CaptureIndex index;
  Programs programs;
  std::vector<fs::path> records;
  std::error_code error;
  for (const auto &entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename();
    if (isRecord(name))
      records.push_back(entry.path());
    const CaptureTarget *const target = captureTargetOf(name);
    if (!target)
      continue;
    auto text = readInput(entry.path());
    if (!text) {
      index.faults.push_back(text.error().message);
      continue;
    }
    CapturedProgram &program = programs[name];
    program.hash = name.substr(0, 32);
    program.target = target;
    program.text = std::move(text).value();
    program.edited = toHex(hashBytes(program.text)) != program.hash;
    if (auto glsl = readInput(entry.path().string() + ".glsl"))
      program.glsl = std::move(glsl).value();
  }
  std::sort(records.begin(), records.end());
  for (const fs::path &path : records) {
    const auto text = readInput(path);
    try {
      mergeRecord(Json::parse(text ? text.value() : ""), index, programs);
    } catch (const std::exception &fault) {
      index.faults.push_back(path.string() + ": " + fault.what());
    }
  }
  if (index.profile.empty())
    index.profile = std::string(fp::hw::kDefaultProfile);
  const auto profile = fp::hw::loadProfile(index.profile);
  for (auto &[name, program] : programs) {
    if (!program.recorded && profile)
      compileHere(program, profile.value());
    index.programs.push_back(std::move(program));
  }
  std::stable_sort(index.programs.begin(), index.programs.end(),
                   [](const auto &a, const auto &b) { return a.draws > b.draws; });
  return index;
}

std::vector<std::string> whatIsMissing(const CaptureIndex &index) {
  std::vector<std::string> missing;
  const auto counted = [](std::uint64_t count, const std::string &what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
  };
  for (const CapturedProcess &process : index.processes) {
    const std::string name =
        "process " + std::to_string(process.pid) + " (" + process.command + ") ";
    const std::string holds =
        counted(process.programs, "program") + " and " + counted(process.frames, "frame");
    if (!process.complete)
      missing.push_back(name + "was ended before it could complete its record, which holds " +
                        holds + "; what came in its last second may be missing");
    if (process.notListed != 0)
      missing.push_back(name + "reached the limit of a record, which holds " + holds + "; " +
                        counted(process.notListed, "load") + " of further texts " +
                        (process.notListed == 1 ? "is" : "are") + " missing");
    if (process.notWritten != 0)
      missing.push_back(name + "could not write " + counted(process.notWritten, "file") + " (" +
                        process.whyNotWritten + "); its record holds " + holds);
  }
  const auto alone = std::count_if(index.programs.begin(), index.programs.end(),
                                   [](const CapturedProgram &each) { return !each.recorded; });
  if (alone != 0)
    missing.push_back(counted(std::uint64_t(alone), "text") +
                      " came without a record: the process was ended too early, or could not "
                      "write it");
  return missing;
}

std::string indexJson(const CaptureIndex &index) {
  JsonWriter json;
  json.beginObject();
  json.key("schema").value(ARBITER_CAPTURE_SCHEMA);
  json.key("profile").value(index.profile);
  json.key("processes").beginArray();
  for (const CapturedProcess &process : index.processes) {
    json.beginObject().key("pid").value(process.pid).key("command").value(process.command);
    json.key("profile").value(process.profile).key("contexts_made").value(process.contexts);
    json.key("frames").value(process.frames).key("complete").value(process.complete);
    json.key("programs_not_listed").value(process.notListed);
    json.key("files_not_written").value(process.notWritten).endObject();
  }
  json.endArray();
  json.key("programs").beginArray();
  for (const CapturedProgram &program : index.programs)
    writeProgram(json, program);
  json.endArray().endObject();
  return json.take();
}

} // namespace arbiter::tools
