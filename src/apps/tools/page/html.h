#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

/// Formats pieces of HTML for the pages of `arbiter capture` and `arbiter report`. A parameter
/// `html` is markup; a parameter `text` may be any bytes.
namespace arbiter::tools {

/// Returns text as HTML. Bytes that are not UTF-8 are shown as <i>\\xNN</i>, and so are control
/// characters except tab and line feed.
[[nodiscard]] std::string escaped(std::string_view text);
/// Returns text for the value of an attribute in double quotes, escaped without the <i>.
[[nodiscard]] std::string escapedAttribute(std::string_view text);

/// Returns a number's decimal digits.
[[nodiscard]] std::string number(std::uint64_t value);
/// Returns a number with its noun: "1 program", "3 programs".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

[[nodiscard]] std::string cell(const std::string &html);
/// Returns a cell of class n, aligned right.
[[nodiscard]] std::string numberCell(std::uint64_t value);

/// Splits a program text into lines without their ends. CR LF, LF and CR each end a line, as for
/// the compiler. A final line end does not start another line.
[[nodiscard]] std::vector<std::string_view> linesOf(std::string_view text);

/// Returns the indentation of a caret under a column: a tab for each tab before it, a space for
/// each other character.
/// \param column 1-based, in bytes
[[nodiscard]] std::string caretIndent(std::string_view line, std::uint32_t column);

} // namespace arbiter::tools
