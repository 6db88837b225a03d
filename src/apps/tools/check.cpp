#include <algorithm>
#include <cstdio>

#include "apps/tools/check/cards.h"
#include "apps/tools/check/compare.h"
#include "apps/tools/check/find_files.h"
#include "apps/tools/check/json.h"
#include "apps/tools/check/summary.h"
#include "apps/tools/check/text.h"
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/profile_choice.h"

namespace arbiter::tools {

namespace {

/// With more files, list problems and print a summary instead of a table for each file.
constexpr std::size_t kFew = 8;

std::vector<CheckedFile> checkOne(const std::string &path, const CheckArguments &arguments,
                                  ProfileChoice &profiles) {
  const fp::LimitPolicy policy =
      arguments.limits == "report" ? fp::LimitPolicy::Report : fp::LimitPolicy::Enforce;
  std::vector<CheckedFile> programs = checkFile(path, arguments.language, policy, profiles);
  if (arguments.advise)
    addAdvice(programs, path, arguments.fix, policy);
  return programs;
}

void print(const std::string &text) { std::fwrite(text.data(), 1, text.size(), stdout); }

/// Writes one JSON document about all files.
class JsonReport {
public:
  explicit JsonReport(const fp::hw::Profile &profile) : m_profile(profile) {
    writeHead(m_json.beginObject(), profile);
    m_json.key("files").beginArray();
  }
  void add(const CheckedFile &file) {
    const bool another = file.profile != nullptr && file.profile->name != m_profile.name;
    writeFile(m_json, file, another ? file.profile : nullptr);
  }
  void end(const Summary &summary) {
    m_json.endArray().key("summary");
    summary.write(m_json);
    print(m_json.endObject().take());
  }

private:
  const fp::hw::Profile &m_profile;
  JsonWriter m_json;
};

/// Prints lines or tables for each file, then the summary.
class TextReport {
public:
  TextReport(const CheckArguments &arguments, const FoundFiles &found,
             const fp::hw::Profile &profile)
      : m_profile(profile), m_options{styleOf(arguments.gauges), arguments.why},
        m_brief(arguments.brief), m_several(found.folders || found.paths.size() > 1),
        m_many(found.folders || found.paths.size() > kFew),
        m_full(!m_brief && (!m_many || arguments.why || arguments.gauges == "always")) {}

  [[nodiscard]] std::string of(const CheckedFile &file) const {
    const fp::hw::Profile &profile = file.profile ? *file.profile : m_profile;
    if (m_full)
      return fullText(file, profile, m_options);
    return (m_brief ? lackText(file, profile) : "") + briefText(file, m_options.style);
  }
  void end(const Summary &summary) const {
    if (m_brief || !m_several)
      return;
    print(summary.line(m_profile));
    if (m_many)
      print(summary.tables(m_options.style));
  }

private:
  const fp::hw::Profile &m_profile;
  TextOptions m_options;
  bool m_brief;
  bool m_several;
  bool m_many;
  bool m_full;
};

int checkAll(const CheckArguments &arguments, ProfileChoice &profiles) {
  const FoundFiles found = findFiles(arguments.files);
  Summary summary(arguments.brief ? Summary::Detail::Counts : Summary::Detail::Tables);
  Progress progress(found.paths.size());
  const auto report = [&](const std::string &fault) {
    progress.clear();
    complain(shown(fault));
  };
  for (const std::string &fault : found.faults) {
    summary.addFault();
    report(fault);
  }
  JsonReport json(profiles.common());
  const TextReport text(arguments, found, profiles.common());
  for (std::size_t i = 0; i < found.paths.size(); ++i) {
    progress.at(i);
    for (const CheckedFile &file : checkOne(found.paths[i], arguments, profiles)) {
      summary.add(file);
      if (file.status == FileStatus::Unreadable)
        report(file.fault);
      if (arguments.json) {
        json.add(file);
      } else if (file.status != FileStatus::Unreadable) {
        if (const std::string part = text.of(file); !part.empty()) {
          progress.clear();
          print(part);
        }
      }
    }
  }
  progress.clear();
  arguments.json ? json.end(summary) : text.end(summary);
  return summary.exitCode();
}

/// Checks each file under every card's profile.
int checkCards(const CheckArguments &arguments) {
  if (arguments.profiles.size() != 1 || arguments.compare || arguments.gauges != "auto" ||
      arguments.advise || (arguments.json && arguments.brief) ||
      (arguments.why && (arguments.json || arguments.brief))) {
    complain("--profile all takes no other profile, no --compare, no --gauges and no --advise, and "
             "one of --brief, --why and --json");
    return kExitUsage;
  }
  const FoundFiles found = findFiles(arguments.files);
  const Style style = styleOf("auto");
  CardMatrix matrix(arguments.language,
                    arguments.limits == "report" ? fp::LimitPolicy::Report
                                                 : fp::LimitPolicy::Enforce,
                    arguments.why ? std::optional(style) : std::nullopt);
  Progress progress(found.paths.size());
  const auto report = [&](const std::string &fault) {
    progress.clear();
    complain(shown(fault));
  };
  for (const std::string &fault : found.faults) {
    matrix.addFault();
    report(fault);
  }
  for (std::size_t i = 0; i < found.paths.size(); ++i) {
    progress.at(i);
    if (const std::string fault = matrix.add(found.paths[i]); !fault.empty())
      report(fault);
  }
  progress.clear();
  const bool reasons = arguments.why || (!arguments.brief && matrix.size() <= kFew);
  print(arguments.json ? matrix.json() : matrix.text(style, reasons));
  return matrix.exitCode();
}

/// Returns `code`, or kExitUsage after a complaint if standard output could not be written.
int afterPrinting(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return code;
  complain("standard output cannot be written");
  return kExitUsage;
}

/// Compares two files, each under its profile, or one file under two profiles. The second side's
/// verdict is the exit code: the first is what the author had before.
int compareTwo(const CheckArguments &arguments, std::vector<ProfileChoice> &profiles) {
  if (arguments.files.size() + profiles.size() != 3) {
    complain("--compare takes two files, or one file and --profile twice");
    return kExitUsage;
  }
  if (arguments.files.size() == 2 ? isSameFile(arguments.files[0], arguments.files[1])
                                  : arguments.profiles[0] == arguments.profiles[1]) {
    complain("--compare: both sides are the same");
    return kExitUsage;
  }
  std::vector<Side> sides;
  Summary summary(Summary::Detail::Counts);
  for (std::size_t i = 0; i < 2; ++i) {
    ProfileChoice &choice = profiles[profiles.size() == 2 ? i : 0];
    const std::string &path = arguments.files[arguments.files.size() == 2 ? i : 0];
    std::vector<CheckedFile> programs = checkOne(path, arguments, choice);
    if (programs.size() > 1) {
      complain(shown(path) + ": has several programs; --language names the one to compare");
      return kExitUsage;
    }
    CheckedFile &file = programs.front();
    if (i == 1 || file.status == FileStatus::Unreadable)
      summary.add(file);
    if (file.status == FileStatus::Unreadable)
      complain(shown(file.fault));
    const fp::hw::Profile *const profile = file.profile ? file.profile : &choice.common();
    sides.push_back({std::move(file), profile});
  }
  const Comparison comparison(sides[0], sides[1]);
  print(arguments.json ? comparison.json() : comparison.text(styleOf(arguments.gauges)));
  return summary.exitCode();
}

} // namespace

int check(const CheckArguments &arguments) {
  const auto &names = arguments.profiles;
  if (std::find(names.begin(), names.end(), kAllCards) != names.end())
    return afterPrinting(checkCards(arguments));
  std::vector<ProfileChoice> profiles;
  for (const std::string &name : names.empty() ? std::vector<std::string>{""} : names) {
    auto choice = ProfileChoice::make(name);
    if (!choice) {
      complain(choice.error().message);
      return kExitUsage;
    }
    profiles.push_back(std::move(choice).value());
  }
  if (arguments.fix &&
      std::find(arguments.files.begin(), arguments.files.end(), "-") != arguments.files.end()) {
    complain("--fix writes files: standard input is none");
    return kExitUsage;
  }
  if (profiles.size() != 1 && !arguments.compare) {
    complain("--profile twice is for --compare");
    return kExitUsage;
  }
  return afterPrinting(arguments.compare ? compareTwo(arguments, profiles)
                                         : checkAll(arguments, profiles[0]));
}

} // namespace arbiter::tools
