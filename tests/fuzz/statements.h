#pragma once
#include <cstdint>
#include <random>
#include <string>

/// Edits program texts by statement, which leaves more of them valid than edits of bytes do.
namespace arbiter::fuzz {

/// Returns \p text with one to four edits: statements removed, doubled, moved or put into blocks;
/// words of a statement (conditions, suffixes, masks, numerals) replaced.
[[nodiscard]] std::string editStatements(std::string text, std::mt19937_64 &random);

/// Returns the first statements of \p text followed by the last ones of \p other.
[[nodiscard]] std::string spliceStatements(const std::string &text, const std::string &other,
                                           std::mt19937_64 &random);

} // namespace arbiter::fuzz
