#include <cstdio>

#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"
#include "tools/commands.h"
#include "tools/input.h"
#include "tools/language.h"
#include "tools/machine_code.h"
#include "tools/profile_choice.h"

namespace arbiter::tools {

namespace {

/// One line a token: "line:column  kind  text".
std::string tokenListing(std::string_view file, const fp::FileProgram &program) {
  const std::string_view text = file.substr(0, program.span.end);
  const std::string_view own = program.in(file);
  std::string listing;
  const auto add = [&](fp::Span span, const char *kind) {
    const fp::LineColumn at = fp::locate(text, span.begin);
    const std::string place = std::to_string(at.line) + ":" + std::to_string(at.column);
    char line[64];
    std::snprintf(line, sizeof line, "%-9s %-14s ", place.c_str(), kind);
    listing += line;
    listing += text.substr(span.begin, span.end - span.begin);
    listing += '\n';
  };
  std::uint32_t begin = program.span.begin;
  for (const LanguageRow &row : languageRows())
    if (own.starts_with(row.header))
      begin += std::uint32_t(std::string_view(row.header).size());
  if (begin != program.span.begin)
    add({program.span.begin, begin}, "Header");
  const bool calls = own.starts_with("!!RC") || own.starts_with("!!TS");
  fp::Lexer lexer(text, begin, calls ? fp::Words::Calls : fp::Words::Identifiers);
  for (fp::Token token = lexer.next(); token.kind != fp::TokenKind::EndOfText; token = lexer.next())
    add(token.span, fp::name(token.kind));
  return listing;
}

std::string emit(fp::ir::Program &program, const CompileArguments &arguments) {
  const fp::Numerics numerics = fp::numericsNamed(arguments.numerics).value_or(fp::Numerics::Host);
  if (arguments.emit == "glsl")
    return fp::emitGlsl(program, {}, numerics).text;
  return arguments.emit == "assembly" ? fp::emitAssembly(program) : fp::ir::print(program);
}

/// Writes the checked program in the form asked for into `emitted`.
/// \returns an exit code, after a complaint unless it is kExitOk.
int emitProgram(std::string_view text, const fp::FileProgram &program,
                const CompileArguments &arguments, const fp::hw::Profile &profile,
                std::string &emitted) {
  const fp::ir::Language language = program.language;
  const bool isIr = arguments.emit == "ir" || arguments.emit == "assembly";
  if (isIr && arguments.numerics == "fx9" && !arguments.optimise && !fp::ir::isNvparse(language)) {
    complain("--numerics has no effect with --emit " + arguments.emit +
             " but beside --optimise, "
             "or on register combiners");
    return kExitUsage;
  }
  fp::CompileOptions options;
  options.limits = limitsOf(profile, language);
  options.numerics = fp::numericsNamed(arguments.numerics).value_or(fp::Numerics::Host);
  fp::CheckResult result = fp::checkProgramIn(text, program, options);
  const std::string name = arguments.file == "-" ? "<stdin>" : arguments.file;
  for (const fp::Diagnostic &diagnostic : result.diagnostics)
    std::fputs(fp::render(name, text, diagnostic).c_str(), stderr);
  if (!result.ok())
    return kExitInvalid;
  if (arguments.emit == "assembly" && language == fp::ir::Language::AtiFragment) {
    complain(arguments.file + ": no assembly text says what an ATI shader does");
    return kExitUsage;
  }
  if (arguments.optimise && isIr)
    fp::optimise(*result.program,
                 fp::ir::numericsOf(
                     language, fp::numericsNamed(arguments.numerics).value_or(fp::Numerics::Host)));
  if (arguments.emit == "assembly" && result.program->options.nv != fp::ir::NvOption::None &&
      !fp::isOfArb(*result.program)) {
    complain(arguments.file + ": no assembly text of the ARB says what this program does" +
             (arguments.optimise ? "" : "; with -O there may be one"));
    return kExitUsage;
  }
  if (arguments.emit != "ir" && result.native.language == fp::ir::NativeLanguage::Vsp1) {
    complain(arguments.file +
             ": a vertex state program draws nothing; --emit ir shows what it does");
    return kExitUsage;
  }
  if (arguments.emit == "llvm" || arguments.emit == "machine") {
    auto code = machineCode(
        *result.program, fp::numericsNamed(arguments.numerics).value_or(fp::Numerics::Host),
        arguments.emit == "llvm" ? fp::jit::Listing::Ir : fp::jit::Listing::Assembly);
    if (!code) {
      complain(arguments.file + ": " + code.error().message);
      return kExitUsage;
    }
    emitted = std::move(code.value());
    return kExitOk;
  }
  if (arguments.emit != "native") {
    emitted = emit(*result.program, arguments);
    return kExitOk;
  }
  emitted = fp::hw::explainNative(*result.program, result.counts, options.limits, text).disassembly;
  if (!emitted.empty())
    return kExitOk;
  complain(arguments.file + ": the profile " + profile.name + " has no model that runs " +
           (languageRow(language).header + 2) + " programs: its limits are documented numbers");
  return kExitUsage;
}

/// A line above each program of a file that has several, as a comment of what is emitted.
std::string heading(std::string_view text, const fp::FileProgram &program,
                    const CompileArguments &arguments) {
  const std::string mark = arguments.emit == "glsl" ? "//" : arguments.emit == "llvm" ? ";" : "#";
  return mark + " " + titleOf(arguments.file == "-" ? "<stdin>" : arguments.file, text, program) +
         "\n";
}

/// The programs of the file that are meant, one after the other, into `emitted`.
/// \returns as emitProgram()
int emitAll(std::string_view text, const CompileArguments &arguments,
            const fp::hw::Profile &profile, std::string &emitted) {
  const std::vector<fp::FileProgram> programs = choosePrograms(arguments.language, text);
  int worst = kExitOk;
  for (const fp::FileProgram &program : programs) {
    std::string own;
    if (arguments.emit == "tokens")
      own = tokenListing(text, program);
    else if (const int code = emitProgram(text, program, arguments, profile, own); code != kExitOk)
      worst = worst == kExitOk ? code : worst;
    if (programs.size() > 1)
      emitted += heading(text, program, arguments);
    emitted += own;
  }
  return worst;
}

} // namespace

int compile(const CompileArguments &arguments) {
  if (arguments.output != "-" && isSameFile(arguments.output, arguments.file)) {
    complain(arguments.output + ": is the program itself");
    return kExitUsage;
  }
  auto profiles = ProfileChoice::make(arguments.profile);
  if (!profiles) {
    complain(profiles.error().message);
    return kExitUsage;
  }
  const auto input = readInput(arguments.file);
  if (!input) {
    complain(input.error().message);
    return kExitUsage;
  }
  const std::string &text = input.value();
  std::string emitted;
  if (arguments.emit == "tokens" && text.size() > fp::kMaxTextBytes) {
    complain(arguments.file + ": longer than 1 MiB");
    return kExitInvalid;
  }
  const int code = emitAll(
      text, arguments,
      profiles.value().of(arguments.file == "-" ? std::string() : arguments.file, text), emitted);
  if (code != kExitOk)
    return code;
  const std::string fault = writeOutput(arguments.output, emitted);
  if (!fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  return kExitOk;
}

} // namespace arbiter::tools
