#pragma once
#include <cstdint>
#include <random>
#include <string>

/// Edits of program texts by statement, which leave more of them valid than edits of bytes do.
namespace arbiter::fuzz {

/// \p text with one to four edits: statements left out, doubled, moved, put into blocks of their
/// own; words of a statement (conditions, suffixes, masks, numerals) replaced.
[[nodiscard]] std::string editStatements(std::string text, std::mt19937_64 &random);

/// The first statements of \p text, and the last ones of \p other.
[[nodiscard]] std::string spliceStatements(const std::string &text, const std::string &other,
                                           std::mt19937_64 &random);

} // namespace arbiter::fuzz
