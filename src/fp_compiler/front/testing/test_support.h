#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "fp_compiler/compiler.h"
#include "fp_compiler/front/lexer.h"

/// Helpers for the front end's tests.
namespace arbiter::fp::testing_support {

/// Returns limits like those of the first cards. They are small, so that tests reach them.
inline CompileOptions small(LimitPolicy policy = LimitPolicy::Enforce) {
  CompileOptions options;
  Limits &limits = options.limits;
  limits.api = {.instructions = 96,
                .aluInstructions = 64,
                .texInstructions = 32,
                .texIndirections = 4,
                .temporaries = 32,
                .parameters = 32,
                .attribs = 10,
                .addressRegisters = 1};
  limits.native = limits.api;
  limits.localParameters = 32;
  limits.envParameters = 32;
  limits.textureCoords = 8;
  limits.textureImageUnits = 16;
  limits.textureUnits = 8;
  limits.programMatrices = 8;
  limits.programMatrixStackDepth = 4;
  limits.drawBuffers = 4;
  options.policy = policy;
  return options;
}

/// Returns limits like those of software hosts.
inline CompileOptions generous() {
  CompileOptions options = small();
  options.limits.api = {16384, 16384, 16384, 16384, 4096, 4096, 16, 8};
  options.limits.native = options.limits.api;
  options.limits.localParameters = options.limits.envParameters = 4096;
  return options;
}

/// Returns small limits. For the golden programs of a folder `nvidia` they include NVIDIA's options
/// and languages.
inline CompileOptions smallFor(const std::filesystem::path &golden) {
  CompileOptions options = small();
  if (golden.parent_path().parent_path().filename() != "nvidia")
    return options;
  options.limits.nvOptions = 2;
  options.limits.clipPlanes = 6;
  options.limits.api.addressRegisters = options.limits.native.addressRegisters = 2;
  return options;
}

/// Checks a text in the language of its header; without a header, as a fragment program.
inline CheckResult check(std::string_view text, const CompileOptions &options = small()) {
  return checkProgram(languageOfText(text).value_or(ir::Language::ArbFragment), text, options);
}

/// Returns a program with the statements between header and END.
inline std::string wrap(std::string_view statements) {
  return "!!ARBfp1.0\n" + std::string(statements) + "\nEND\n";
}

inline std::string wrapVertex(std::string_view statements) {
  return "!!ARBvp1.0\n" + std::string(statements) + "\nEND\n";
}

inline std::string repeat(std::string_view piece, std::size_t times) {
  std::string all;
  all.reserve(piece.size() * times);
  while (times-- > 0)
    all += piece;
  return all;
}

/// Calls `visit` with the text without each of its tokens, and with each of them doubled.
template <typename Visit> void forEachTokenEdit(const std::string &text, Visit visit) {
  constexpr std::uint32_t kHeaderBytes = 10;
  Lexer lexer(text, kHeaderBytes);
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfText; token = lexer.next()) {
    std::string without = text;
    without.erase(token.span.begin, token.span.end - token.span.begin);
    visit(without);
    std::string doubled = text;
    doubled.insert(token.span.end,
                   " " + text.substr(token.span.begin, token.span.end - token.span.begin));
    visit(doubled);
  }
}

/// Returns the ID of the first error, or "" for a program that loads.
inline std::string firstError(const CheckResult &result) {
  for (const Diagnostic &diagnostic : result.diagnostics)
    if (diagnostic.severity == Severity::Error)
      return diagnostic.id;
  return "";
}

} // namespace arbiter::fp::testing_support
