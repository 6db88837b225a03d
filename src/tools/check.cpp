#include <algorithm>
#include <cstdio>

#include "tools/commands.h"
#include "tools/input.h"
#include "tools/language.h"
#include "tools/report.h"

namespace arbiter::tools {

namespace {

CheckedFile checkFile(const std::string &name, const CheckArguments &arguments,
                      const fp::hw::Profile &profile) {
  CheckedFile file;
  file.name = name == "-" ? "<stdin>" : name;
  auto input = readInput(name);
  if (!input) {
    file.status = FileStatus::Unreadable;
    file.fault = input.error().message;
    return file;
  }
  file.text = std::move(input).value();
  file.language = chooseLanguage(arguments.language, file.text);
  fp::CompileOptions options;
  options.limits = limitsOf(profile, file.language);
  options.policy =
      arguments.limits == "report" ? fp::LimitPolicy::Report : fp::LimitPolicy::Enforce;
  file.result = fp::checkProgram(file.language, file.text, options);
  if (!file.result.ok())
    file.status = FileStatus::Invalid;
  else if (!file.result.underNativeLimits)
    file.status = FileStatus::OverNative;
  return file;
}

/// The worst file decides: a file that cannot be read, then an invalid one, then one over limits.
int exitCode(const std::vector<CheckedFile> &files) {
  const auto any = [&](FileStatus status) {
    return std::any_of(files.begin(), files.end(),
                       [&](const CheckedFile &file) { return file.status == status; });
  };
  if (any(FileStatus::Unreadable))
    return kExitUsage;
  if (any(FileStatus::Invalid))
    return kExitInvalid;
  return any(FileStatus::OverNative) ? kExitOverNative : kExitOk;
}

} // namespace

int check(const CheckArguments &arguments) {
  const auto profile = fp::hw::loadProfile(arguments.profile);
  if (!profile) {
    complain(profile.error().message);
    return kExitUsage;
  }
  std::vector<CheckedFile> files;
  for (const std::string &name : arguments.files) {
    files.push_back(checkFile(name, arguments, profile.value()));
    const CheckedFile &file = files.back();
    if (file.status == FileStatus::Unreadable)
      complain(file.fault);
    else if (!arguments.json)
      std::fputs(asText(file, profile.value(), arguments.brief).c_str(), stdout);
  }
  if (arguments.json)
    std::fputs(asJson(files, profile.value()).c_str(), stdout);
  if (std::fflush(stdout) != 0) {
    complain("standard output cannot be written");
    return kExitUsage;
  }
  return exitCode(files);
}

} // namespace arbiter::tools
