#include "tools/check/checked_file.h"

#include <algorithm>
#include <cassert>

#include "scene/document.h"
#include "tools/input.h"
#include "tools/language.h"

namespace arbiter::tools {

const char *name(FileStatus status) {
  switch (status) {
  case FileStatus::Valid:
    return "valid";
  case FileStatus::OverNative:
    return "over-native";
  case FileStatus::Invalid:
    return "invalid";
  case FileStatus::Unreadable:
    return "unreadable";
  }
  return "";
}

namespace {

/// The lines of a text's panel are checked with it: they are comments to GL, and what `draw` draws.
void addPanel(const std::string &path, CheckedFile &file) {
  auto &all = file.result.diagnostics;
  const auto panel = scene::checkPanel(path == "-" ? std::string() : path, file.text);
  if (panel.empty())
    return;
  all.insert(all.end(), panel.begin(), panel.end());
  std::stable_sort(all.begin(), all.end(),
                   [](const auto &a, const auto &b) { return a.span.begin < b.span.begin; });
  const auto isError = [](const fp::Diagnostic &each) {
    return each.severity == fp::Severity::Error;
  };
  if (std::any_of(panel.begin(), panel.end(), isError))
    file.status = FileStatus::Invalid;
}

/// \returns false if there is nothing to check
bool readFile(const std::string &path, CheckedFile &file) {
  file.name = path == "-" ? "<stdin>" : path;
  auto input = readInput(path);
  if (!input) {
    file.status = FileStatus::Unreadable;
    file.fault = input.error().message;
    return false;
  }
  file.text = std::move(input).value();
  return true;
}

void checkText(const std::string &path, CheckedFile &file, fp::LimitPolicy policy) {
  file.result = fp::checkProgram(file.language, file.text, {file.limits, policy});
  file.status = !file.result.ok()                ? FileStatus::Invalid
                : !file.result.underNativeLimits ? FileStatus::OverNative
                                                 : FileStatus::Valid;
  addPanel(path, file);
}

void judge(const std::string &path, const std::string &language, fp::LimitPolicy policy,
           const fp::hw::Profile &profile, CheckedFile &file) {
  file.language = chooseLanguage(language, file.text);
  file.profile = &profile;
  file.limits = limitsOf(profile, file.language);
  checkText(path, file, policy);
}

} // namespace

CheckedFile checkFile(const std::string &path, const std::string &language, fp::LimitPolicy policy,
                      const fp::hw::Profile &profile) {
  CheckedFile file;
  if (readFile(path, file))
    judge(path, language, policy, profile, file);
  return file;
}

CheckedFile checkFile(const std::string &path, const std::string &language, fp::LimitPolicy policy,
                      ProfileChoice &profiles) {
  CheckedFile file;
  if (readFile(path, file))
    judge(path, language, policy, profiles.of(path == "-" ? std::string() : path, file.text), file);
  return file;
}

void addAdvice(CheckedFile &file, const std::string &path, bool fix, fp::LimitPolicy policy) {
  if (file.status == FileStatus::Unreadable)
    return;
  const advise::Setting setting{file.language, file.limits};
  if (fix && file.counted()) {
    file.fixed = advise::applyAll(file.text, setting);
    if (!file.fixed->applied.empty()) {
      if (const std::string fault = replaceFile(path, file.fixed->text); !fault.empty()) {
        file.status = FileStatus::Unreadable;
        file.fault = fault;
        return;
      }
      file.text = file.fixed->text;
      checkText(path, file, policy);
    }
  }
  file.advice = advise::advise(file.text, setting);
}

const fp::hw::NativeReport &CheckedFile::native() const {
  assert(counted());
  if (!m_native)
    m_native = fp::hw::explainNative(*result.program, result.counts, limits, text);
  return *m_native;
}

} // namespace arbiter::tools
