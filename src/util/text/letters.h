#pragma once

/// Classifies the characters of ASCII, whatever the locale is.
namespace arbiter {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool isLetterOrDigit(char c) { return isLetter(c) || isDigit(c); }
constexpr bool isBlank(char c) { return c == ' ' || c == '\t'; }
constexpr bool endsLine(char c) { return c == '\n' || c == '\r'; }
constexpr char lowerCase(char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; }

} // namespace arbiter
