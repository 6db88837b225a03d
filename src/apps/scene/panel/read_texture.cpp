#include "apps/scene/panel/reader.h"

namespace arbiter::scene {

namespace {

constexpr std::size_t kFaces = 6;

bool takesSize(Generator generator) {
  switch (generator) {
  case Generator::File:
  case Generator::Cube:
  case Generator::Rule:
  case Generator::Picture:
  case Generator::DepthOf:
  case Generator::Normals:
  case Generator::Feedback:
    return false;
  default:
    return true;
  }
}

bool readFiles(Reader &reader, std::size_t count, TextureSource &source) {
  while (source.files.size() < count)
    if (!reader.file("the file of an image", source.files.emplace_back()))
      return false;
  return true;
}

/// Reads six files, or one with all faces.
bool readFaces(Reader &reader, TextureSource &source) {
  const std::string_view first = reader.peek().text;
  return readFiles(reader, first.ends_with(".dds") || first.ends_with(".DDS") ? 1 : kFaces, source);
}

bool readSize(Reader &reader, TextureSource &source) {
  if (!reader.at(TokenKind::Number))
    return true;
  if (!reader.integer("a width", 1, kMaxTextureSide, source.width))
    return false;
  source.height = source.width;
  return !reader.at(TokenKind::Number) ||
         reader.integer("a height", 1, kMaxTextureSide, source.height);
}

bool readSource(Reader &reader, int nesting, TextureSource &source);

/// Reads "of" and a source. A source that must not be nested is an error.
bool readInner(Reader &reader, int nesting, TextureSource &source) {
  const Generator outer = source.generator.value;
  if (outer != Generator::Normals && outer != Generator::Feedback)
    return true;
  if (!reader.acceptWord("of"))
    return outer == Generator::Feedback ||
           reader.expected("'of' and heights", "for example: normals strength 2 of bumps");
  if (nesting == kMaxNesting)
    return reader.error(reader.peek().span, "panel_range", "generators are nested too deep");
  const fp::Span span = reader.peek().span;
  if (!readSource(reader, nesting + 1, source.of.emplace_back()))
    return false;
  const Generator inner = source.of.front().generator.value;
  if (isCube(inner) || inner == Generator::Picture || inner == Generator::DepthOf ||
      inner == Generator::Feedback)
    return reader.error(span, "panel_syntax", "'of' takes an image with two sides");
  return true;
}

bool readSource(Reader &reader, int nesting, TextureSource &source) {
  if (isFile(reader.peek())) {
    source.generator = {Generator::File, reader.peek().span};
    return readFiles(reader, 1, source);
  }
  if (!reader.word("image", source.generator))
    return false;
  const Generator generator = source.generator.value;
  const WordRow &row = rowOf(generator);
  Reader::defaults(row, source.arguments);
  if (generator == Generator::Cube)
    return readFaces(reader, source);
  if (generator == Generator::Picture || generator == Generator::DepthOf)
    return reader.name("the name of a target", source.target);
  if (takesSize(generator) && !readSize(reader, source))
    return false;
  for (bool found = true; found;)
    if (!reader.argument(row, source.arguments, found))
      return false;
  return readInner(reader, nesting, source);
}

} // namespace

bool readTexture(Reader &reader, std::uint32_t begin) {
  TextureSpec texture;
  Number unit;
  if (!reader.integer("a texture image unit", 0, kMaxUnits - 1, unit))
    return false;
  texture.unit = unsigned(unit.value);
  texture.unitSpan = unit.span;
  if (!reader.accept(TokenKind::Equals))
    return reader.expected("'=' and an image", "for example: texture 0 = checker");
  if (!readSource(reader, 0, texture.source))
    return false;
  for (const TextureSpec &other : reader.panel().textures)
    if (other.unit == texture.unit)
      return reader.error(unit.span, "panel_twice", "this unit has an image already",
                          "one of the two is to go");
  texture.span = {begin, reader.last()};
  reader.panel().textures.push_back(std::move(texture));
  return true;
}

bool readSampler(Reader &reader, bool good) {
  if (!reader.at(TokenKind::Word))
    return false;
  const Token token = reader.peek();
  TextureSpec spare;
  TextureSpec &texture = good ? reader.panel().textures.back() : spare;
  if (const auto filter = findWord<Filter>(token.text))
    texture.filter = {*filter, token.span};
  else if (const auto wrap = findWord<Wrap>(token.text))
    texture.wrap = {*wrap, token.span};
  else if (token.text == "compare")
    texture.compare = true;
  else
    return false;
  reader.take();
  texture.span.end = token.span.end;
  return true;
}

} // namespace arbiter::scene
