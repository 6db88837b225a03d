#include "state/raster_draw/immediate/list_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <utility>

#include "state/host_draw/native_inputs.h"
#include "state/host_draw/stages/application_glsl.h"
#include "state/mirror/dirty_bits.h"
#include "state/primitives/recorder.h"
#include "state/raster_draw/immediate/replay.h"
#include "state/raster_draw/raster_context.h"
#include "state/raster_draw/vertices/vertex_convert.h"
#include "state/raster_draw/vertices/vertex_fetch.h"

namespace arbiter::state {

namespace {

/// Most vertices of one draw. A larger draw stays in the host's list, which stores repeated
/// vertices once.
constexpr GLsizei kMaxVertices = 1 << 20;

const host::HostTable &ownHostOf(const RasterContext &context) {
  return context.host == &kRecordingHost ? *context.trueHost : *context.host;
}

/// True if the application's own GLSL shades vertices now.
bool applicationShadesVertices(RasterContext &context) {
  const host::HostTable &host = ownHostOf(context);
  const auto name = [&](GLenum binding) {
    GLint value = 0;
    host.GetIntegerv(binding, &value);
    return GLuint(value);
  };
  if (context.hostProgramIsOurs)
    return false;
  if (const GLuint program = name(GL_CURRENT_PROGRAM))
    return stagesOf(context, program).vertex;
  const GLuint pipeline = context.application.pipelinesUsed ? name(GL_PROGRAM_PIPELINE_BINDING) : 0;
  return pipeline != 0 && stagesOfPipeline(context, pipeline).vertex;
}

/// Returns the generic arrays that the host would not alias with the conventional ones, in a list
/// that is compiled or under fixed function. 0 means that the host draws correctly.
std::uint32_t strangeArrays(RasterContext &context) {
  if (!context.attributesAlias || context.aliases->arraysUsed == 0 || context.aliases->areOne ||
      context.insideBeginEnd) [[likely]]
    return 0;
  const bool program = context.row(Target::Vertex).enabled;
  if (context.listMode == 0 && (program || applicationShadesVertices(context)))
    return 0;
  return enabledArrays(context, ownHostOf(context)) & context.aliases->arraysUsed &
         (program ? ~0u : ~context.aliases->ofProgramsAlone);
}

/// Calls the host itself while this object lives. Requires that the host neither compiles a list
/// nor has an open primitive.
class OwnHost {
public:
  explicit OwnHost(RasterContext &context) : m_context(context), m_before(context.host) {
    context.host = &ownHostOf(context);
  }
  ~OwnHost() { m_context.host = m_before; }
  OwnHost(const OwnHost &) = delete;
  OwnHost &operator=(const OwnHost &) = delete;

private:
  RasterContext &m_context;
  const host::HostTable *const m_before;
};

ListArrays &arraysOf(RasterContext &context) {
  ListRecorder::Arrays &arrays = context.list->arrays();
  if (!arrays)
    arrays = {new ListArrays(ownHostOf(context), context.caps),
              [](ListArrays *made) { delete made; }};
  return *arrays;
}

class OpenArrays {
public:
  OpenArrays(RasterContext &context, const DrawCommand &command)
      : m_context(context), m_arrays(arraysOf(context)) {
    const OwnHost host(context);
    isOpen = m_arrays.open(context, command,
                           context.listMode == 0 || context.list->takeArraysDirty(context));
  }
  ~OpenArrays() {
    const OwnHost host(m_context);
    m_arrays.close(m_context);
  }
  OpenArrays(const OpenArrays &) = delete;
  OpenArrays &operator=(const OpenArrays &) = delete;

  bool isOpen = false;
  void addTo(ImmediateRecorder &recorder, const DrawCommand &command) const {
    m_arrays.addTo(recorder, command);
  }
  void sendTo(const host::HostTable &host, const DrawCommand &command) const {
    m_arrays.sendTo(host, command);
  }

private:
  RasterContext &m_context;
  ListArrays &m_arrays;
};

/// True for the types that commands for single attributes have. Hosts convert other types by rules
/// of their own.
bool isPlain(const VertexSource::Array &array) {
  switch (array.type) {
  case GL_BYTE:
  case GL_UNSIGNED_BYTE:
  case GL_SHORT:
  case GL_UNSIGNED_SHORT:
  case GL_INT:
  case GL_UNSIGNED_INT:
  case GL_FLOAT:
  case GL_DOUBLE:
    return !array.bgra && conversionOf(array, false) != nullptr;
  default:
    return false;
  }
}

/// An array whose values are converted as by the command for its attribute: table 2.9 of OpenGL
/// 2.1, whatever rule the host uses for arrays.
struct Column {
  int slot = 0;
  Convert convert = nullptr;
  const std::uint8_t *base = nullptr;
  std::size_t stride = 0;
  unsigned components = 4;

  [[nodiscard]] std::array<float, 4> at(std::int64_t index) const {
    std::array<float, 4> value = {0, 0, 0, 1};
    convert({base + index * std::int64_t(stride),
             stride,
             1,
             {&value[0], &value[1], &value[2], &value[3]}});
    if (slot == kEdgeFlag)
      value[0] = value[0] != 0.0f ? 1.0f : 0.0f;
    return value;
  }
};

std::int64_t indexOf(GLenum type, const void *indices, std::size_t i) {
  const auto load = [&](auto value) {
    std::memcpy(&value, static_cast<const std::uint8_t *>(indices) + i * sizeof value,
                sizeof value);
    return std::int64_t(value);
  };
  return type == GL_UNSIGNED_BYTE    ? load(std::uint8_t())
         : type == GL_UNSIGNED_SHORT ? load(std::uint16_t())
                                     : load(std::uint32_t());
}

/// Draws on the host, by the command itself or from `arrays`. The host may be compiling a list.
void drawOnHost(const host::HostTable &host, const DrawCommand &c, const OpenArrays *arrays) {
  if (arrays) {
    host.Begin(c.mode);
    arrays->sendTo(host, c);
    host.End();
  } else if (c.indexType == 0) {
    host.DrawArrays(c.mode, c.first, c.count);
  } else if (c.baseVertex == 0) {
    host.DrawElements(c.mode, c.count, c.indexType, c.indices);
  } else {
    host.DrawElementsBaseVertex(c.mode, c.count, c.indexType, c.indices, c.baseVertex);
  }
}

} // namespace

namespace {

/// Returns the aliases that count now. Arrays enabled by EnableClientState count as conventional
/// ones while a program reads them.
AttributeAliases aliasesNow(const RasterContext &context) {
  if (!context.attributesAlias)
    return {};
  const bool program = context.row(Target::Vertex).enabled;
  return {.arraysUsed = context.aliases->arraysUsed,
          .ofProgramsAlone = program ? 0 : context.aliases->ofProgramsAlone};
}

} // namespace

bool ListArrays::open(RasterContext &context, const DrawCommand &command, bool changed) {
  // Buffers can be written without notice here, and primitive restart has no dirty bit of its own.
  const AttributeAliases aliases = aliasesNow(context);
  changed = std::exchange(m_aliases, aliases) != aliases || changed;
  m_mirror.clock.mark(dirty::kBuffers | dirty::kRaster | (changed ? dirty::kArrays : 0u));
  m_mirror.refreshArrays();
  const ArrayBindings &arrays = m_mirror.arrays;
  if (arrays.restart)
    return false;
  // Outside of lists, arrays are converted as the host converts them.
  m_symmetric = context.listMode == 0 && context.caps.symmetricSigned;
  for (std::uint32_t left = arrays.enabled; left != 0; left &= left - 1) {
    const VertexSource::Array &array = arrays.slots[std::size_t(std::countr_zero(left))].array;
    if (context.listMode == 0 ? !conversionOf(array, m_symmetric) : !isPlain(array))
      return false;
  }
  return m_source.open(context, m_mirror, arrays.enabled, command) && isWithin(command);
}

/// True if all vertices lie in the buffers. Client memory cannot be checked.
bool ListArrays::isWithin(const DrawCommand &command) const {
  IndexBounds bounds = {command.first, std::int64_t(command.first) + command.count - 1};
  if (command.indexType != 0 &&
      !boundsOf(command.indexType, m_source.indices(), std::uint32_t(command.count), bounds))
    return false;
  const std::uint32_t count = m_source.source().count;
  return bounds.minimum + command.baseVertex >= 0 &&
         (count == 0 || bounds.maximum + command.baseVertex < std::int64_t(count));
}

template <typename Set> void ListArrays::read(const DrawCommand &command, Set &&set) const {
  std::array<Column, kSlots> columns;
  std::size_t count = 0;
  for (std::uint32_t left = m_mirror.arrays.enabled; left != 0; left &= left - 1) {
    const int slot = std::countr_zero(left);
    const VertexSource::Array &array = m_source.source().arrays[std::size_t(slot)];
    columns[count++] = {slot, conversionOf(array, m_symmetric),
                        static_cast<const std::uint8_t *>(array.base), array.stride,
                        unsigned(array.components)};
  }
  // The position has the lowest slot and comes last: it makes the vertex.
  for (GLsizei i = 0; i < command.count; ++i) {
    const std::int64_t index =
        command.baseVertex + (command.indexType == 0
                                  ? command.first + std::int64_t(i)
                                  : indexOf(command.indexType, m_source.indices(), std::size_t(i)));
    for (std::size_t c = count; c-- > 0;)
      set(columns[c].slot, columns[c].at(index), columns[c].components);
  }
}

void ListArrays::addTo(ImmediateRecorder &recorder, const DrawCommand &command) const {
  read(command, [&](int slot, const std::array<float, 4> &v, unsigned components) {
    if (slot == kPosition)
      recorder.vertex(v[0], v[1], v[2], v[3], components);
    else
      recorder.set(slot, v[0], v[1], v[2], v[3], components);
  });
}

void ListArrays::sendTo(const host::HostTable &host, const DrawCommand &command) const {
  read(command, [&](int slot, const std::array<float, 4> &v, unsigned) {
    setAttribute(host, slot, v.data(), 4);
  });
}

bool recordArrays(RasterContext &context, const DrawCommand &command) {
  if (!context.list->keeps() || context.insideBeginEnd || context.list->recordsPrimitive() ||
      command.count > kMaxVertices || !context.list->hasRoom(command.count))
    return false;
  const OpenArrays arrays(context, command);
  const OpenArrays *const strange = strangeArrays(context) != 0 ? &arrays : nullptr;
  if (!arrays.isOpen || !context.list->beginPrimitive(context, command.mode))
    return false;
  if (context.list->isEarly())
    drawOnHost(*context.trueHost, command, strange);
  arrays.addTo(context.list->recorder(), command);
  context.list->endPrimitive(context, true);
  if (context.list->executes()) {
    if (context.list->beginExecuted(context, command.mode))
      drawOnHost(*context.host, command, strange);
    context.list->endExecuted(context);
  }
  return true;
}

bool recordElement(RasterContext &context, GLint index) {
  const DrawCommand command = {.first = index, .count = 1};
  // While aliases are in use, the rasterizer's open primitive cannot go to the host with this
  // element: the host would misread its arrays.
  const bool isDeferred = context.listMode == 0 && context.recorder && context.attributesAlias &&
                          context.insideBeginEnd;
  if ((!isDeferred && !(context.listMode != 0 && context.list->recordsPrimitive())) || index < 0)
    return false;
  const OpenArrays arrays(context, command);
  if (arrays.isOpen)
    arrays.addTo(isDeferred ? *context.recorder : context.list->recorder(), command);
  return arrays.isOpen;
}

bool aliasedDraw(RasterContext &context, const DrawCommand &command) {
  const bool draws = command.mode <= GL_POLYGON && command.count > 0 && command.first >= 0 &&
                     !context.insideBeginEnd;
  if (!draws || strangeArrays(context) == 0) [[likely]]
    return false;
  const OpenArrays arrays(context, command);
  if (!arrays.isOpen)
    return false;
  drawOnHost(*context.host, command, &arrays);
  ++*context.drawCounter;
  return true;
}

bool aliasedDrawRange(RasterContext &context, GLuint start, GLuint end,
                      const DrawCommand &command) {
  return end >= start && aliasedDraw(context, command);
}

namespace {

/// True if a multi-draw is left to the host: it is an error, or no array aliases.
bool drawsNone(RasterContext &context, GLenum mode, const GLsizei *count, GLsizei drawCount) {
  return mode > GL_POLYGON || drawCount <= 0 || strangeArrays(context) == 0 ||
         std::any_of(count, count + drawCount, [](GLsizei each) { return each < 0; });
}

} // namespace

void drawEach(RasterContext &context, const MultiDraw &draws,
              bool (*takes)(RasterContext &, const DrawCommand &)) {
  for (GLsizei i = 0; i < draws.drawCount; ++i)
    if (const DrawCommand command = draws.at(i); !takes(context, command))
      drawOnHost(*context.host, command, nullptr);
}

bool aliasedMultiDrawArrays(RasterContext &context, GLenum mode, const GLint *first,
                            const GLsizei *count, GLsizei drawCount) {
  if (drawsNone(context, mode, count, drawCount)) [[likely]]
    return false;
  drawEach(context, {mode, first, count, drawCount}, aliasedDraw);
  return true;
}

bool aliasedMultiDrawElements(RasterContext &context, GLenum mode, const GLsizei *count,
                              GLenum type, const void *const *indices, GLsizei drawCount,
                              const GLint *baseVertices) {
  if (drawsNone(context, mode, count, drawCount)) [[likely]]
    return false;
  drawEach(context, {mode, nullptr, count, drawCount, type, indices, baseVertices}, aliasedDraw);
  return true;
}

} // namespace arbiter::state
