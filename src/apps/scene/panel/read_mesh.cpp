#include "apps/scene/panel/reader.h"

namespace arbiter::scene {

namespace {

constexpr std::size_t kMaxParts = 16; ///< joined by "and"
constexpr double kFar = 1000;

bool holdsShape(Shape shape) {
  return shape == Shape::Shells || shape == Shape::Fins || shape == Shape::Volume;
}

bool readPlace(Reader &reader, ShapeSpec &spec) {
  for (Number &component : spec.at)
    if (!reader.number("x, y and z of the place", -kFar, kFar, component))
      return false;
  return true;
}

bool readKind(Reader &reader, ShapeSpec &spec) {
  if (!isFile(reader.peek()))
    return reader.word("shape", spec.shape);
  spec.shape = {Shape::File, reader.peek().span};
  return reader.file("the file of a mesh", spec.file);
}

bool readShape(Reader &reader, int nesting, ShapeSpec &spec) {
  if (!readKind(reader, spec))
    return false;
  const WordRow &row = rowOf(spec.shape.value);
  Reader::defaults(row, spec.arguments);
  for (bool found = true; found;) {
    if (!reader.argument(row, spec.arguments, found))
      return false;
    if (!found && (found = reader.acceptWord("at")) && !readPlace(reader, spec))
      return false;
    if (!found && (found = reader.acceptWord("scale")) &&
        !reader.number("a scale", 0.001, kFar, spec.scale))
      return false;
  }
  if (!holdsShape(spec.shape.value))
    return true;
  if (!reader.acceptWord("of"))
    return reader.expected("'of' and a shape", "for example: shells count 16 of sphere");
  if (nesting == kMaxNesting)
    return reader.error(reader.peek().span, "panel_range", "shapes are nested too deep");
  return readShape(reader, nesting + 1, spec.of.emplace_back());
}

} // namespace

bool readMesh(Reader &reader) {
  Panel &panel = reader.panel();
  std::vector<ShapeSpec> shapes;
  const std::uint32_t begin = reader.peek().span.begin;
  do {
    if (shapes.size() == kMaxParts)
      return reader.error(reader.peek().span, "panel_range", "a mesh has at most 16 shapes");
    if (!readShape(reader, 0, shapes.emplace_back()))
      return false;
  } while (reader.acceptWord("and"));
  panel.mesh = std::move(shapes);
  panel.meshSpan = {begin, reader.last()};
  return true;
}

bool readCamera(Reader &reader) {
  CameraSpec camera;
  if (!reader.word("camera", camera.kind))
    return false;
  const WordRow &row = rowOf(camera.kind.value);
  Reader::defaults(row, camera.arguments);
  for (bool found = true; found;)
    if (!reader.argument(row, camera.arguments, found))
      return false;
  if (camera.kind.value == CameraKind::Orbit && camera.argument("near") >= camera.argument("far"))
    return reader.error(camera.kind.span, "panel_range", "near is to be less than far");
  reader.panel().camera = camera;
  return true;
}

bool readCoordinate(Reader &reader) {
  CoordinateSpec spec;
  Number set;
  if (!reader.integer("a texture coordinate set", 0, 7, set))
    return false;
  spec.set = unsigned(set.value);
  if (!reader.accept(TokenKind::Equals))
    return reader.expected("'='", "for example: texcoord 1 = normal");
  if (!reader.word("source of texture coordinates", spec.source))
    return false;
  if (spec.source.value == Coordinate::St && reader.at(TokenKind::Number))
    for (Number &each : spec.offset)
      if (!reader.number("what is added to s and t", -kFar, kFar, each))
        return false;
  for (const CoordinateSpec &other : reader.panel().coordinates)
    if (other.set == spec.set)
      return reader.error(set.span, "panel_twice", "this texture coordinate set is said twice",
                          "one of the two is to go");
  reader.panel().coordinates.push_back(spec);
  return true;
}

} // namespace arbiter::scene
