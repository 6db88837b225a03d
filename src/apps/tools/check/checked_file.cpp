#include "apps/tools/check/checked_file.h"

#include <algorithm>
#include <cassert>

#include "apps/scene/document.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "fp_compiler/doubts/doubts.h"

namespace arbiter::tools {

const char *name(FileStatus status) {
  switch (status) {
  case FileStatus::Valid:
    return "valid";
  case FileStatus::OverNative:
    return "over_native";
  case FileStatus::Invalid:
    return "invalid";
  case FileStatus::Unreadable:
    return "unreadable";
  }
  return "";
}

namespace {

/// Checks the lines of the panel. They are comments for GL, but `draw` uses them.
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

void check(CheckedFile &file, fp::LimitPolicy policy) {
  file.result = fp::checkProgramIn(file.text, file.program(), {file.limits, policy});
  fp::addDoubts(file.text, file.program(), file.result);
  file.status = !file.result.ok()                ? FileStatus::Invalid
                : !file.result.underNativeLimits ? FileStatus::OverNative
                                                 : FileStatus::Valid;
}

std::vector<CheckedFile> checkText(const std::string &path, const std::string &text,
                                   const std::string &language, fp::LimitPolicy policy,
                                   const fp::hw::Profile &profile) {
  const std::size_t all = fp::programsOf(text).size();
  std::vector<CheckedFile> programs;
  for (const fp::FileProgram &program : choosePrograms(language, text)) {
    CheckedFile &file = programs.emplace_back();
    file.name = path == "-" ? "<stdin>" : path;
    file.text = text;
    if (program.in(text).size() != text.size())
      file.part = program.span;
    file.hasSiblings = file.part && all > 1;
    file.language = program.language;
    file.profile = &profile;
    file.limits = limitsOf(profile, file.language);
    check(file, policy);
  }
  addPanel(path, programs.front());
  return programs;
}

/// Returns the file's text, or an element with the error.
Result<std::string, CheckedFile> readFile(const std::string &path) {
  auto input = readInput(path);
  if (input)
    return std::move(input).value();
  CheckedFile file;
  file.name = path == "-" ? "<stdin>" : path;
  file.status = FileStatus::Unreadable;
  file.fault = input.error().message;
  return file;
}

/// Makes the fixes of every program, in the text and in the file.
void fixAll(std::vector<CheckedFile> &programs, const std::string &path, fp::LimitPolicy policy) {
  std::string text = programs.front().text;
  const std::string old = text;
  // Replacing from the last program on keeps the positions of the others.
  for (auto file = programs.rbegin(); file != programs.rend(); ++file) {
    if (!file->counted() && !file->isOverApiAlone())
      continue;
    const fp::Span span = file->program().span;
    file->fixed = advise::applyAll(file->source(), {file->language, file->limits});
    text.replace(span.begin, span.end - span.begin, file->fixed->text);
  }
  if (text == old)
    return;
  if (const std::string fault = replaceFile(path, text); !fault.empty()) {
    programs.resize(1);
    programs.front().status = FileStatus::Unreadable;
    programs.front().fault = fault;
    return;
  }
  std::int64_t moved = 0;
  for (CheckedFile &file : programs) {
    const std::size_t size = file.fixed ? file.fixed->text.size() : file.source().size();
    const fp::Span span = file.program().span;
    const auto begin = std::uint32_t(span.begin + moved);
    moved += std::int64_t(size) - (span.end - span.begin);
    if (file.part)
      file.part = fp::Span{begin, begin + std::uint32_t(size)};
    file.text = text;
    check(file, policy);
  }
  addPanel(path, programs.front());
}

} // namespace

std::string CheckedFile::title() const {
  return hasSiblings ? titleOf(name, text, program()) : name;
}

std::vector<CheckedFile> checkFile(const std::string &path, const std::string &language,
                                   fp::LimitPolicy policy, const fp::hw::Profile &profile) {
  auto text = readFile(path);
  if (!text)
    return {text.error()};
  return checkText(path, text.value(), language, policy, profile);
}

std::vector<CheckedFile> checkFile(const std::string &path, const std::string &language,
                                   fp::LimitPolicy policy, ProfileChoice &profiles) {
  auto text = readFile(path);
  if (!text)
    return {text.error()};
  return checkText(path, text.value(), language, policy,
                   profiles.of(path == "-" ? std::string() : path, text.value()));
}

void addAdvice(std::vector<CheckedFile> &programs, const std::string &path, bool fix,
               fp::LimitPolicy policy) {
  if (programs.front().status == FileStatus::Unreadable)
    return;
  if (fix)
    fixAll(programs, path, policy);
  if (programs.front().status == FileStatus::Unreadable)
    return;
  for (CheckedFile &file : programs) {
    file.advice = advise::advise(file.source(), {file.language, file.limits});
    for (advise::Advice &advice : *file.advice)
      advise::move(advice, file.program().span.begin);
  }
}

bool CheckedFile::isOverApiAlone() const {
  return status == FileStatus::Invalid &&
         std::all_of(result.diagnostics.begin(), result.diagnostics.end(),
                     [](const fp::Diagnostic &each) {
                       return each.severity != fp::Severity::Error || isOfLimit(each);
                     });
}

const fp::hw::NativeReport &CheckedFile::native() const {
  assert(counted());
  if (!m_native)
    m_native = fp::hw::explainNative(*result.program, result.counts, limits, text);
  return *m_native;
}

} // namespace arbiter::tools
