#include "apps/tools/report/program_set.h"

#include <algorithm>
#include <filesystem>

#include "apps/tools/check/find_files.h"
#include "apps/tools/check/terminal.h"
#include "apps/tools/language.h"

namespace arbiter::tools {

namespace {

namespace fs = std::filesystem;

struct Wanted {
  std::string path, name;
  std::string language = "auto";
};

std::vector<Wanted> wantedOfCapture(const std::string &folder, const CaptureIndex &capture) {
  std::vector<Wanted> wanted;
  for (const CapturedProgram &program : capture.programs)
    wanted.push_back({(fs::path(folder) / program.file()).native(), program.file(),
                      languageRow(program.target->language).name});
  return wanted;
}

std::vector<Wanted> wantedOf(const std::vector<std::string> &operands,
                             std::vector<std::string> &faults) {
  std::vector<Wanted> wanted;
  FoundFiles found = findFiles(operands);
  faults = std::move(found.faults);
  const bool below = operands.size() == 1 && found.folders;
  for (std::string &path : found.paths) {
    std::string name = below ? fs::path(path).lexically_relative(operands[0]).native() : path;
    wanted.push_back({std::move(path), std::move(name)});
  }
  return wanted;
}

} // namespace

const char *word(Verdict verdict) {
  switch (verdict) {
  case Verdict::Fits:
    return "fits";
  case Verdict::Over:
    return "does not fit";
  case Verdict::Invalid:
    return "invalid";
  case Verdict::Unreadable:
    return "unreadable";
  }
  return "";
}

Verdict verdictOf(const ReportedProgram &program) {
  if (program.file.status == FileStatus::Unreadable)
    return Verdict::Unreadable;
  if (!program.file.counted())
    return Verdict::Invalid;
  return program.refused || !program.file.result.underNativeLimits ? Verdict::Over : Verdict::Fits;
}

void admitRefused(ReportedProgram &program) {
  CheckedFile &file = program.file;
  if (file.status != FileStatus::Invalid)
    return;
  fp::CheckResult result =
      fp::checkProgramIn(file.text, file.program(), {file.limits, fp::LimitPolicy::Report});
  if (!result.ok())
    return; // the first result has all errors
  program.refused = true;
  file.status = FileStatus::OverNative; // over the API's limits, and so over the card's
  file.result = std::move(result);
}

std::size_t ProgramSet::count(Verdict verdict) const {
  return std::size_t(std::count_if(programs.begin(), programs.end(), [&](const auto &program) {
    return program.verdict == verdict;
  }));
}

bool isCapture(const std::string &folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    const std::string name = at->path().filename().native();
    if (name.starts_with("process-") && name.ends_with(".json"))
      return true;
  }
  return false;
}

ProgramSet readPrograms(const std::vector<std::string> &operands, const fp::hw::Profile &profile) {
  ProgramSet set;
  set.profile = profile;
  for (const std::string &operand : operands)
    set.source += (set.source.empty() ? "" : " ") + operand;
  set.fromCapture = operands.size() == 1 && isCapture(operands[0]);
  std::vector<Wanted> wanted;
  if (set.fromCapture) {
    set.capture = readCapture(operands[0]);
    set.faults = set.capture.faults;
    wanted = wantedOfCapture(operands[0], set.capture);
  } else {
    wanted = wantedOf(operands, set.faults);
  }
  Progress progress(wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    progress.at(i);
    std::vector<CheckedFile> files =
        checkFile(wanted[i].path, wanted[i].language, fp::LimitPolicy::Enforce, profile);
    if (set.fromCapture)
      files.resize(1); // only the first program is drawn with
    for (CheckedFile &file : files) {
      ReportedProgram &program = set.programs.emplace_back();
      program.file = std::move(file);
      admitRefused(program);
      program.file.name = wanted[i].name;
      program.verdict = verdictOf(program);
      program.captured = set.fromCapture ? int(i) : -1;
      if (program.verdict == Verdict::Unreadable)
        set.faults.push_back(program.file.fault);
    }
  }
  return set;
}

} // namespace arbiter::tools
