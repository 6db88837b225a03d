#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Pieces of HTML that the pages of `arbiter capture` and `arbiter report` share. What is named
/// `html` is markup already; what is named `text` may be any bytes.
namespace arbiter::tools {

/// Text as HTML: bytes that are not UTF-8, and control characters but for tab and line feed, are
/// shown as <i>\\xNN</i>.
[[nodiscard]] std::string escaped(std::string_view text);
/// The same for the value of an attribute, in double quotes: without the <i>.
[[nodiscard]] std::string escapedAttribute(std::string_view text);

/// A whole number in digits.
[[nodiscard]] std::string number(std::uint64_t value);
/// "1 program", "3 programs".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

[[nodiscard]] std::string cell(const std::string &html);
/// A cell of class n, aligned right.
[[nodiscard]] std::string numberCell(std::uint64_t value);

/// The lines of a program text, without their ends: CR LF, LF and CR each end one, as the compiler
/// counts them. A text that ends in a line end has no empty line behind it.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

/// What stands before a caret under `column` (1-based, in bytes) of a line: a tab for each tab, a
/// space for each other character.
[[nodiscard]] std::string caretIndent(std::string_view line, std::uint32_t column);

} // namespace arbiter::tools
