// Parses any bytes as a program string, in the language of its header. Besides the sanitizers'
// findings, a result that violates the front end's contract is a finding.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "fp_compiler/compiler.h"
#include "fp_compiler/front/nvparse/text.h"
#include "fp_compiler/ir/validate.h"

namespace {

using namespace arbiter::fp;

CompileOptions makeOptions(LimitPolicy policy) {
  CompileOptions options;
  options.policy = policy;
  options.limits.api = {96, 64, 32, 4, 32, 32, 10, 1};
  options.limits.native = options.limits.api;
  options.limits.localParameters = options.limits.envParameters = 32;
  options.limits.textureCoords = options.limits.textureUnits = 8;
  options.limits.textureImageUnits = 16;
  options.limits.programMatrices = 8;
  options.limits.programMatrixStackDepth = 4;
  options.limits.drawBuffers = 4;
  options.limits.nvOptions = 2;
  options.limits.generalCombiners = options.policy == LimitPolicy::Enforce ? 4 : 8;
  options.limits.perStageConstants = 1;
  options.limits.textureShaders = 3;
  return options;
}

void require(bool condition) {
  if (!condition)
    std::abort();
}

/// Requires that the text written from a state is read as that state.
void checkWritten(ir::Language language, std::string_view text, const CompileOptions &options) {
  const nvparse::ParseResult parsed = nvparse::parse(language, text, options);
  require(parsed.text.has_value());
  const std::string written = nvparse::write(*parsed.text);
  const nvparse::ParseResult again = nvparse::parse(language, written, options);
  require(again.text.has_value());
  require(again.text->combiners == parsed.text->combiners);
  require(again.text->shaders == parsed.text->shaders);
  require(nvparse::write(*again.text) == written);
}

void checkAnswer(std::string_view text, const CheckResult &result) {
  require(result.ok() == (result.errorPosition() < 0));
  require(std::int64_t(result.errorPosition()) <= std::int64_t(text.size()));
  require(result.diagnostics.size() <= kMaxDiagnostics);
  std::uint32_t last = 0;
  for (const Diagnostic &diagnostic : result.diagnostics) {
    require(diagnostic.span.begin >= last && diagnostic.span.begin <= diagnostic.span.end);
    require(!diagnostic.message.empty() && diagnostic.message.find('\n') == std::string::npos);
    last = diagnostic.span.begin;
  }
  require(result.errorString(text).empty() == result.diagnostics.empty());
  if (!result.ok())
    return;
  const ir::Program &program = *result.program;
  require(ir::validate(program).empty());
  const bool native = result.native.language != ir::NativeLanguage::None;
  require(native == (program.options.native != ir::NativeLanguage::None));
  if (isNvparse(languageOfText(text).value_or(ir::Language::ArbFragment)) ||
      program.language == ir::Language::AtiFragment || program.options.nv != ir::NvOption::None)
    return; // counted before it is lowered
  require(result.counts.instructions == program.code.size());
  require(result.counts.temporaries == program.temporaries.size());
  require(result.counts.attribs == program.attributes.size());
  require(result.counts.addressRegisters == program.addresses.size());
  // Arrays with relative addressing count equal constants separately.
  if (program.arrays.empty())
    require(result.counts.parameters <= program.parameters.size());
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size) {
  static const CompileOptions kOptions[] = {makeOptions(LimitPolicy::Enforce),
                                            makeOptions(LimitPolicy::Report)};
  const std::string_view text(reinterpret_cast<const char *>(data), size);
  const ir::Language language = languageOfText(text).value_or(ir::Language::ArbFragment);
  const CheckResult result = checkProgram(language, text, kOptions[size % 2]);
  checkAnswer(text, result);
  if (result.ok() && isNvparse(language))
    checkWritten(language, text, kOptions[size % 2]);
  // A text that loads under the limits also loads if they are only reported, and gives the same
  // program.
  if (result.ok() && size % 2 == 0) {
    const CheckResult reported = checkProgram(language, text, kOptions[1]);
    require(reported.ok() && reported.counts == result.counts);
  }
  return 0;
}
