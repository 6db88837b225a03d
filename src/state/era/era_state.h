#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "state/era/fences.h"
#include "state/era/point_sprites.h"
#include "state/era/vertex_array_objects.h"
#include "state/era/vertex_array_range.h"
#include "state/identity/era_offers.h"
#include "state/objects/hints.h"

/// Extensions from the years of the first fragment programs that today's hosts have dropped. They
/// keep a little state in a context: fences, vertex array ranges, hints. The table of
/// identity/era_offers.cpp lists them and says where each is offered.
namespace arbiter::state {

/// The client state that PushClientAttrib saves.
struct EraClientState {
  VertexArrayRange range;     ///< in CLIENT_VERTEX_ARRAY_BIT
  bool clientStorage = false; ///< UNPACK_CLIENT_STORAGE_APPLE, in CLIENT_PIXEL_STORE_BIT
};

/// The layer's client attribute stack, as deep as the host's.
class EraClientStack {
public:
  /// The state that a push saved.
  struct Entry {
    std::optional<VertexArrayRange> range;
    std::optional<bool> clientStorage;
    /// Apple's object that the host's default object held; nothing if another object was bound.
    std::optional<GLuint> vertexArray;
  };
  void push(const CoreContext &context, Entry entry);
  /// Returns nothing if the host's stack is empty too.
  [[nodiscard]] std::optional<Entry> pop();

private:
  std::vector<Entry> m_entries;
  GLint m_maxDepth = -1; ///< -1: not queried yet
};

struct EraState {
  EraOffers offered; ///< the extensions that the layer implements here
  Fences nvFences, appleFences;
  Hints hints;
  EraClientState client;
  EraClientStack clientStack;
  VertexArrayObjects vertexArrays;
  PointSprites sprites;
};

/// Executes the layer's part of PushClientAttrib.
void pushEraClient(CoreContext &context, GLbitfield mask);
/// Executes PopClientAttrib, including the host's part.
/// \param hostPop the host's function
void popEraClient(CoreContext &context, void (*hostPop)());

/// Sets one of the two hints, with the errors of Hint.
void setEraHint(CoreContext &context, GLenum target, GLenum mode);
/// Returns where the layer keeps the hint `target`; null if the hint is the host's.
[[nodiscard]] GLenum *eraHint(CoreContext &context, GLenum target);
/// Answers a query of GetIntegerv and the like. Returns false if it is the host's to answer.
[[nodiscard]] bool eraValue(CoreContext &context, GLenum pname, GLint &value);
/// Sets UNPACK_CLIENT_STORAGE_APPLE for PixelStore. Returns false if it is the host's to set.
[[nodiscard]] bool setClientStorage(CoreContext &context, GLenum pname, bool value);

enum class FenceOf : std::uint8_t { Nv, Apple };
/// Execute SetFenceNV and SetFenceAPPLE, FinishFenceNV and FinishFenceAPPLE, called or in a list.
/// \param condition SetFenceNV's; APPLE_fence implies the same one
void setFence(CoreContext &context, FenceOf of, GLuint name, GLenum condition);
void finishFence(CoreContext &context, FenceOf of, GLuint name);

} // namespace arbiter::state
