#pragma once
#include <string>

#include "fp_compiler/front/reference/reference.h"
#include "fp_compiler/ir/ir.h"

/// The tables' rows as Markdown, for hover and completion alike.
namespace arbiter::tools::lsp {

/// "MAD[_SAT] result, a, b, c" in that language.
[[nodiscard]] std::string signatureOf(fp::ir::Opcode op, fp::ir::Language language);
/// What it computes, its properties, its section.
[[nodiscard]] std::string documentationOf(fp::ir::Opcode op);
[[nodiscard]] std::string documentationOf(const fp::reference::Binding &binding);
[[nodiscard]] std::string documentationOf(const fp::reference::Entry &entry);

[[nodiscard]] std::string signatureOf(const fp::reference::AtiOp &op);
[[nodiscard]] std::string documentationOf(const fp::reference::AtiOp &op);

/// The specification that a section number is of.
[[nodiscard]] std::string sectionText(std::string_view section);

/// A block of program text.
[[nodiscard]] std::string codeBlock(std::string_view text);

} // namespace arbiter::tools::lsp
