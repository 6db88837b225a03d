#include "fp_compiler/file_programs.h"

#include <algorithm>

#include "fp_compiler/front/diagnostic_ids.h"
#include "util/text/letters.h"

namespace arbiter::fp {

namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

bool isBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }

bool isOfWord(char c) { return isLetterOrDigit(c) || c == '_' || c == '$'; }

std::size_t endOfLine(std::string_view file, std::size_t at) {
  return std::min(file.find_first_of("\r\n", at), file.size());
}

/// Returns the offset of the first byte outside of white space and comments.
std::size_t behindComments(std::string_view file) {
  std::size_t at = 0;
  while (at < file.size()) {
    const std::string_view rest = file.substr(at);
    if (isBlank(rest.front()))
      ++at;
    else if (rest.starts_with('#') || rest.starts_with("//"))
      at = endOfLine(file, at);
    else if (rest.starts_with("/*"))
      at = std::min(file.find("*/", at + 2), file.size() - 2) + 2;
    else
      break;
  }
  return at;
}

/// Returns the offset of the first header at a line's beginning, from the given byte on, or the
/// file's size. Register combiners after texture shaders belong to the same text.
std::size_t nextHeader(std::string_view file, std::size_t at, ir::Language before) {
  while (at < file.size()) {
    const std::size_t first = std::min(file.find_first_not_of(" \t", at), file.size());
    const std::optional<ir::Language> language = languageOfText(file.substr(first));
    if (language &&
        (before != ir::Language::TextureShaders || *language != ir::Language::Combiners))
      return first;
    at = endOfLine(file, at) + 1;
  }
  return file.size();
}

/// Returns the offset after the END of a program, which is a word where a statement can begin.
/// Returns `limit` if there is no END before it.
std::size_t endOfProgram(std::string_view file, std::size_t begin, std::size_t limit) {
  std::size_t at = std::min(file.find_first_of(" \t\r\n\v\f#;", begin), limit);
  bool statement = true; // true if a statement can begin here
  while (at < limit) {
    const char c = file[at];
    if (c == '#') {
      at = endOfLine(file, at);
    } else if (isBlank(c)) {
      ++at;
    } else if (!isOfWord(c)) {
      statement = c == ';' || c == ':';
      ++at;
    } else {
      const std::size_t word = at;
      while (at < limit && isOfWord(file[at]))
        ++at;
      if (statement && file.substr(word, at - word) == "END")
        return at;
      statement = false;
    }
  }
  return limit;
}

Span moved(Span span, std::uint32_t by) { return {span.begin + by, span.end + by}; }

/// Moves all places from the program's own text to the file.
void place(CheckResult &result, std::uint32_t by) {
  for (Diagnostic &diagnostic : result.diagnostics)
    diagnostic.span = moved(diagnostic.span, by);
  if (!result.program)
    return;
  for (ir::Instruction &instruction : result.program->code) {
    instruction.span = moved(instruction.span, by);
    instruction.dst.span = moved(instruction.dst.span, by);
    for (ir::Operand &operand : instruction.src)
      operand.span = moved(operand.span, by);
  }
}

void warnOfHeader(std::string_view file, const FileProgram &program, CheckResult &result) {
  const std::uint32_t begin = program.span.begin;
  if (begin == 0 || programsOf(file).size() != 1)
    return;
  const std::size_t end = std::min(file.find_first_of(" \t\r\n\v\f#;", begin), file.size());
  result.diagnostics.insert(
      result.diagnostics.begin(),
      {Severity::Warning, info(DiagnosticId::HeaderBehind).id, Span{begin, std::uint32_t(end)},
       "the header is there, but not at the first byte",
       "GL refuses the file as it is; a loader that looks for the header finds it"});
}

} // namespace

std::vector<FileProgram> programsOf(std::string_view file) {
  std::vector<FileProgram> programs;
  std::size_t begin = behindComments(file);
  if (!languageOfText(file.substr(begin)))
    begin = file.size();
  while (begin < file.size()) {
    const ir::Language language = *languageOfText(file.substr(begin));
    const std::size_t behind = nextHeader(file, endOfLine(file, begin) + 1, language);
    const std::size_t end = endOfProgram(file, begin, behind);
    programs.push_back({language, {std::uint32_t(begin), std::uint32_t(end)}});
    begin = behind;
  }
  if (programs.empty())
    programs.emplace_back();
  if (programs.size() == 1 && programs[0].span.begin == 0)
    programs[0].span.end = std::uint32_t(file.size());
  return programs;
}

FileProgram programOf(std::string_view file, ir::Language language) {
  for (const FileProgram &program : programsOf(file))
    if (program.language == language)
      return program;
  return {language, {0, std::uint32_t(file.size())}};
}

CheckResult checkProgramIn(std::string_view file, const FileProgram &program,
                           const CompileOptions &options) {
  CheckResult result = checkProgram(program.language, program.in(file), options);
  place(result, program.span.begin);
  warnOfHeader(file, program, result);
  return result;
}

Inspection inspectProgramIn(std::string_view file, const FileProgram &program,
                            const CompileOptions &options) {
  Inspection inspection = inspectProgram(program.language, program.in(file), options);
  place(inspection.check, program.span.begin);
  inspection.names.move(program.span.begin);
  warnOfHeader(file, program, inspection.check);
  return inspection;
}

} // namespace arbiter::fp
