#include "fp_compiler/front/lexer.h"

#include <gtest/gtest.h>
#include <string>

#include "fp_compiler/limits.h"

namespace arbiter::fp {
namespace {

/// Returns "Kind:text" of every token, separated by blanks.
std::string tokens(std::string_view text) {
  Lexer lexer(text);
  std::string all;
  for (Token token = lexer.next(); token.kind != TokenKind::EndOfText; token = lexer.next())
    all += (all.empty() ? "" : " ") + std::string(name(token.kind)) + ":" +
           std::string(text.substr(token.span.begin, token.span.end - token.span.begin));
  return all;
}

TEST(Lexer, Numerals) {
  EXPECT_EQ(tokens("0 12 007"), "Integer:0 Integer:12 Integer:007");
  EXPECT_EQ(tokens(".5 5. 1.5 1e3 1E+3 1.e-3 .5e1"),
            "Float:.5 Float:5. Float:1.5 Float:1e3 Float:1E+3 Float:1.e-3 Float:.5e1");
  EXPECT_EQ(tokens("1e"), "Integer:1 Identifier:e");
  EXPECT_EQ(tokens("1e+"), "Integer:1 Identifier:e Plus:+");
  EXPECT_EQ(tokens("1.5.x"), "Float:1.5 Dot:. Identifier:x");
}

TEST(Lexer, RangesAreNotFractions) {
  EXPECT_EQ(tokens("0..3"), "Integer:0 DotDot:.. Integer:3");
  EXPECT_EQ(tokens("0 .. 3"), "Integer:0 DotDot:.. Integer:3");
  EXPECT_EQ(tokens("a..b"), "Identifier:a DotDot:.. Identifier:b");
  EXPECT_EQ(tokens("1...5"), "Integer:1 DotDot:.. Float:.5");
}

TEST(Lexer, TargetsThatBeginWithADigit) {
  EXPECT_EQ(tokens("1D 2D;3D"), "Dimension:1D Dimension:2D Semicolon:; Dimension:3D");
  EXPECT_EQ(tokens("2Dx 4D 12D 2d"),
            "Integer:2 Identifier:Dx Integer:4 Identifier:D Integer:12 Identifier:D Integer:2 "
            "Identifier:d");
}

TEST(Lexer, IdentifiersAndPunctuation) {
  EXPECT_EQ(tokens("_a$9 $b __c"), "Identifier:_a$9 Identifier:$b Identifier:__c");
  EXPECT_EQ(tokens(",;.[]{}=+-"),
            "Comma:, Semicolon:; Dot:. OpenBracket:[ CloseBracket:] OpenBrace:{ CloseBrace:} "
            "Equals:= Plus:+ Minus:-");
}

TEST(Lexer, WhitespaceAndComments) {
  EXPECT_EQ(tokens("a\t\r\n b#c;\nd#e\rf#g"),
            "Identifier:a Identifier:b Identifier:d Identifier:f");
  EXPECT_EQ(tokens("#"), "");
  EXPECT_EQ(tokens("a\vb"), "Identifier:a InvalidByte:\v Identifier:b");
  EXPECT_EQ(tokens(std::string_view("a\0b", 3)),
            std::string("Identifier:a InvalidByte:\0 Identifier:b", 39));
}

TEST(Lexer, LengthsAreBounded) {
  const std::string name(kMaxIdentifierBytes, 'n');
  EXPECT_EQ(Lexer(name).next().kind, TokenKind::Identifier);
  EXPECT_EQ(Lexer(name + "n").next().kind, TokenKind::OverlongIdentifier);
  const std::string numeral(kMaxNumeralBytes, '9');
  EXPECT_EQ(Lexer(numeral).next().kind, TokenKind::Integer);
  EXPECT_EQ(Lexer(numeral + "9").next().kind, TokenKind::OverlongNumeral);
}

TEST(Lexer, TheEndRepeats) {
  Lexer lexer("a ");
  EXPECT_EQ(lexer.next().kind, TokenKind::Identifier);
  for (int i = 0; i < 3; ++i) {
    const Token end = lexer.next();
    EXPECT_EQ(end.kind, TokenKind::EndOfText);
    EXPECT_EQ(end.span, (Span{2, 2}));
  }
}

TEST(TokenStream, LooksTwoAhead) {
  TokenStream stream("x a . b", 1);
  EXPECT_EQ(stream.text(stream.peek()), "a");
  EXPECT_EQ(stream.peek(1).kind, TokenKind::Dot);
  EXPECT_FALSE(stream.accept(TokenKind::Dot));
  EXPECT_EQ(stream.text(stream.next()), "a");
  EXPECT_EQ(stream.lastEnd(), 3u);
  EXPECT_TRUE(stream.accept(TokenKind::Dot));
  EXPECT_EQ(stream.text(stream.next()), "b");
  EXPECT_TRUE(stream.at(TokenKind::EndOfText));
}

} // namespace
} // namespace arbiter::fp
