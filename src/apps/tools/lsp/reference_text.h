#pragma once
#include <string>

#include "fp_compiler/front/reference/reference.h"
#include "fp_compiler/ir/ir.h"

/// Formats rows of the reference tables as Markdown, for hover and completion.
namespace arbiter::tools::lsp {

/// Returns an opcode's syntax in a language, such as "MAD[_SAT] result, a, b, c".
[[nodiscard]] std::string signatureOf(fp::ir::Opcode op, fp::ir::Language language);
/// Returns an opcode's result, its properties and its section.
[[nodiscard]] std::string documentationOf(fp::ir::Opcode op);
[[nodiscard]] std::string documentationOf(const fp::reference::Binding &binding);
[[nodiscard]] std::string documentationOf(const fp::reference::Entry &entry);

[[nodiscard]] std::string signatureOf(const fp::reference::AtiOp &op);
[[nodiscard]] std::string documentationOf(const fp::reference::AtiOp &op);

/// Returns the specification that a section number refers to.
[[nodiscard]] std::string sectionText(std::string_view section);

/// Returns a Markdown block of program text.
[[nodiscard]] std::string codeBlock(std::string_view text);

} // namespace arbiter::tools::lsp
