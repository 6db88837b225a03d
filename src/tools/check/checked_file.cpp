#include "tools/check/checked_file.h"

#include <cassert>

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

CheckedFile checkFile(const std::string &path, const std::string &language, fp::LimitPolicy policy,
                      const fp::hw::Profile &profile) {
  CheckedFile file;
  file.name = path == "-" ? "<stdin>" : path;
  auto input = readInput(path);
  if (!input) {
    file.status = FileStatus::Unreadable;
    file.fault = input.error().message;
    return file;
  }
  file.text = std::move(input).value();
  file.language = chooseLanguage(language, file.text);
  file.limits = limitsOf(profile, file.language);
  file.result = fp::checkProgram(file.language, file.text, {file.limits, policy});
  if (!file.result.ok())
    file.status = FileStatus::Invalid;
  else if (!file.result.underNativeLimits)
    file.status = FileStatus::OverNative;
  return file;
}

const fp::hw::NativeReport &CheckedFile::native() const {
  assert(counted());
  if (!m_native)
    m_native = fp::hw::explainNative(*result.program, result.counts, limits, text);
  return *m_native;
}

} // namespace arbiter::tools
