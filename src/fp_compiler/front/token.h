#pragma once
#include <cstdint>

#include "fp_compiler/span.h"

namespace arbiter::fp {

/// The tokens of the program grammar (3.11.2). Keywords are identifiers until the parser asks
/// (front/words/keywords.h): a word may be a component, a property or a variable.
enum class TokenKind : std::uint8_t {
  EndOfText,
  Identifier,
  Integer,   ///< digits only
  Float,     ///< with a point, an exponent, or both
  Dimension, ///< 1D, 2D, 3D: the only words that begin with a digit
  Comma,
  Semicolon,
  Dot,
  DotDot,
  OpenBracket,
  CloseBracket,
  OpenBrace,
  CloseBrace,
  Equals,
  Plus,
  Minus,
  OpenParen, ///< this and the next two: nvparse's texts alone
  CloseParen,
  Times,
  InvalidByte,        ///< a byte that begins no token
  OverlongIdentifier, ///< beyond kMaxIdentifierBytes
  OverlongNumeral,    ///< beyond kMaxNumeralBytes
};

struct Token {
  TokenKind kind = TokenKind::EndOfText;
  Span span;
};

/// Returns the kind's name for listings of tokens: "Identifier", "Comma".
[[nodiscard]] const char *name(TokenKind kind);

} // namespace arbiter::fp
