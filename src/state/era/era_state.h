#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "state/core/era_offers.h"
#include "state/era/fences.h"
#include "state/era/point_sprites.h"
#include "state/era/vertex_array_objects.h"
#include "state/era/vertex_array_range.h"
#include "state/objects/hints.h"

/// Extensions of the years of the first fragment programs that today's hosts have dropped, and that
/// keep a little state in a context: fences, vertex array ranges, hints. Which they are, and where
/// each is offered, is the table of era_offers.cpp.
namespace arbiter::state {

/// Client state, which PushClientAttrib saves.
struct EraClientState {
  VertexArrayRange range;     ///< of CLIENT_VERTEX_ARRAY_BIT
  bool clientStorage = false; ///< UNPACK_CLIENT_STORAGE_APPLE, of CLIENT_PIXEL_STORE_BIT
};

/// The client attribute stack's part of it, as deep as the host's.
class EraClientStack {
public:
  /// What a push saved.
  struct Entry {
    std::optional<VertexArrayRange> range;
    std::optional<bool> clientStorage;
    /// The object that was in the host's default one, where that was current.
    std::optional<GLuint> vertexArray;
  };
  void push(const Context &context, Entry entry);
  /// Without an entry: the host's stack is empty too.
  [[nodiscard]] std::optional<Entry> pop();

private:
  std::vector<Entry> m_entries;
  GLint m_maxDepth = -1; ///< -1: not asked for yet
};

struct EraState {
  EraOffers offered; ///< what the layer itself has here
  Fences nvFences, appleFences;
  Hints hints;
  EraClientState client;
  EraClientStack clientStack;
  VertexArrayObjects vertexArrays;
  PointSprites sprites;
};

/// PushClientAttrib and PopClientAttrib, about the host's own.
void pushEraClient(Context &context, GLbitfield mask);
/// \param hostPop the host's
void popEraClient(Context &context, void (*hostPop)());

/// Sets a hint of the two, with the errors of Hint.
void setEraHint(Context &context, GLenum target, GLenum mode);
/// The place of the hint that `target` names where the layer has it; null: it is the host's.
[[nodiscard]] GLenum *eraHint(Context &context, GLenum target);
/// A value of GetIntegerv and its kin; false: it is the host's to answer.
[[nodiscard]] bool eraValue(Context &context, GLenum pname, GLint &value);
/// PixelStore of UNPACK_CLIENT_STORAGE_APPLE where the layer has it; false: it is the host's.
[[nodiscard]] bool setClientStorage(Context &context, GLenum pname, bool value);

enum class FenceOf : std::uint8_t { Nv, Apple };
/// SetFenceNV and SetFenceAPPLE, FinishFenceNV and FinishFenceAPPLE, of a list too.
/// \param condition of SetFenceNV; Apple's has the same one, unsaid
void setFence(Context &context, FenceOf of, GLuint name, GLenum condition);
void finishFence(Context &context, FenceOf of, GLuint name);

} // namespace arbiter::state
