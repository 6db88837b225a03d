#pragma once
#include <span>

#include "apps/tools/debug/pixel/drawer.h"
#include "control/message.h"

namespace arbiter::tools::debug {

/// Draws in another process, by requests of the control protocol (docs/write/control.md).
class RemoteDrawer : public Drawer {
public:
  [[nodiscard]] Result<std::vector<Vec4>, DebugError>
  draw(const std::string &text, std::size_t targets, const Region &region,
       const std::vector<Vec4> &locals = {}) override;
  [[nodiscard]] Result<std::array<int, 3>, DebugError>
  textureSize(unsigned unit, fp::ir::TexTarget target) override;

protected:
  using Json = control::Json;
  /// Sends a request and returns its result.
  virtual Result<Json, DebugError> ask(const std::string &method, Json params) = 0;
  /// Takes the values that an answer brought. Fails if their bytes are not as many as asked for.
  virtual std::optional<DebugError> take(const Json &answer, std::span<std::uint8_t> bytes) = 0;

  /// Sends a request whose answer brings `count` items.
  template <typename Item>
  Result<std::vector<Item>, DebugError> askItems(const std::string &method, Json params,
                                                 std::size_t count) {
    auto answer = ask(method, std::move(params));
    if (!answer)
      return answer.error();
    std::vector<Item> items(count);
    auto *const bytes = reinterpret_cast<std::uint8_t *>(items.data());
    if (auto error = take(answer.value(), {bytes, count * sizeof(Item)}))
      return *error;
    return items;
  }
};

/// Returns the members of a request that name a region.
[[nodiscard]] control::Json regionJson(const Region &region);
/// Returns a target's word in requests.
[[nodiscard]] const char *targetWord(fp::ir::TexTarget target);

} // namespace arbiter::tools::debug
