#include <GL/arbiter.h>
#include <algorithm>
#include <cstdio>

#include "apps/tools/check/json.h"
#include "apps/tools/check/rendered.h"
#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "apps/tools/language.h"
#include "apps/tools/machine_code.h"
#include "apps/tools/profile_choice.h"
#include "fp_compiler/back/assembly/assembly.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/front/lexer.h"
#include "fp_compiler/hw/native.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/ir/print.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::tools {

namespace {

/// Lists the tokens, one per line: "line:column  kind  text".
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

/// One program of the file, with its diagnostics and its output.
struct Emitted {
  fp::FileProgram program;
  std::vector<fp::Diagnostic> diagnostics;
  std::string text;
  int code = kExitOk;
};

/// Writes the checked program in the requested form into `into`.
/// \returns an exit code, after a complaint unless it is kExitOk.
int emitProgram(std::string_view text, const CompileArguments &arguments,
                const fp::hw::Profile &profile, Emitted &into) {
  const fp::FileProgram &program = into.program;
  std::string &emitted = into.text;
  const fp::ir::Language language = program.language;
  const bool isIr = arguments.emit == "ir" || arguments.emit == "assembly";
  if (isIr && arguments.numerics == "fx9" && !arguments.optimise && !fp::ir::isNvparse(language)) {
    complain("--numerics has no effect with --emit " + arguments.emit +
             " but beside --optimize, "
             "or on register combiners");
    return kExitUsage;
  }
  fp::CompileOptions options;
  options.limits = limitsOf(profile, language);
  options.numerics = fp::numericsNamed(arguments.numerics).value_or(fp::Numerics::Host);
  fp::CheckResult result = fp::checkProgramIn(text, program, options);
  const std::string name = arguments.file == "-" ? "<stdin>" : arguments.file;
  into.diagnostics = result.diagnostics;
  if (!arguments.json)
    std::fputs(rendered(name, text, result.diagnostics, styleOfErrors()).c_str(), stderr);
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

/// Returns a title line for a program, as a comment in the output's language.
std::string heading(std::string_view text, const fp::FileProgram &program,
                    const CompileArguments &arguments) {
  const std::string mark = arguments.emit == "glsl" ? "//" : arguments.emit == "llvm" ? ";" : "#";
  return mark + " " + titleOf(arguments.file == "-" ? "<stdin>" : arguments.file, text, program) +
         "\n";
}

/// Compiles the selected programs of the file, one after the other.
std::vector<Emitted> emitAll(std::string_view text, const CompileArguments &arguments,
                             const fp::hw::Profile &profile) {
  std::vector<Emitted> all;
  for (const fp::FileProgram &program : choosePrograms(arguments.language, text)) {
    Emitted &each = all.emplace_back();
    each.program = program;
    if (arguments.emit == "tokens")
      each.text = tokenListing(text, program);
    else
      each.code = emitProgram(text, arguments, profile, each);
  }
  return all;
}

std::string joined(std::string_view text, const CompileArguments &arguments,
                   const std::vector<Emitted> &all) {
  std::string emitted;
  for (const Emitted &each : all)
    emitted += (all.size() > 1 ? heading(text, each.program, arguments) : "") + each.text;
  return emitted;
}

std::string asJson(std::string_view text, const CompileArguments &arguments,
                   const fp::hw::Profile &profile, const std::vector<Emitted> &all) {
  JsonWriter json;
  json.beginObject().key("schema").value(ARBITER_COMPILE_SCHEMA);
  json.key("file").value(arguments.file == "-" ? "<stdin>" : arguments.file);
  json.key("profile").value(profile.name).key("emit").value(arguments.emit);
  json.key("programs").beginArray();
  for (const Emitted &each : all) {
    json.beginObject();
    json.key("language").value(languageTitle(each.program.language, each.program.in(text)));
    json.key("line").value(fp::locate(text, each.program.span.begin).line);
    json.key("status").value(name(each.code == kExitOk ? FileStatus::Valid : FileStatus::Invalid));
    writeDiagnostics(json, text, each.diagnostics);
    json.key("text").value(each.text).endObject();
  }
  return json.endArray().endObject().take();
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
  if (arguments.emit == "tokens" && text.size() > fp::kMaxTextBytes) {
    complain(arguments.file + ": longer than 1 MiB");
    return kExitInvalid;
  }
  const fp::hw::Profile &profile =
      profiles.value().of(arguments.file == "-" ? std::string() : arguments.file, text);
  const std::vector<Emitted> all = emitAll(text, arguments, profile);
  const auto failed = std::find_if(all.begin(), all.end(),
                                   [](const Emitted &each) { return each.code != kExitOk; });
  const int code = failed == all.end() ? int(kExitOk) : failed->code;
  if (code != kExitOk && (!arguments.json || code != kExitInvalid))
    return code;
  const std::string emitted =
      arguments.json ? asJson(text, arguments, profile, all) : joined(text, arguments, all);
  const std::string fault = writeOutput(arguments.output, emitted);
  if (!fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  return code;
}

} // namespace arbiter::tools
