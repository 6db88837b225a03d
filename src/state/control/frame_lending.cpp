// Frames for clients, in shared memory.
#include <cstring>

#include "state/control/session.h"
#include "state/raster_draw/raster_context.h"

namespace arbiter::state::control {

void Session::wantFrames(wire::ClientId client, std::uint32_t every, int width, int height) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_clients.find(client);
  if (found == m_clients.end())
    return;
  found->second.every = every;
  found->second.width = width;
  found->second.height = height;
  found->second.seen = 0;
}

void Session::lendFrame(RasterContext &context) {
  struct Wish {
    wire::ClientId id;
    int width, height;
  };
  std::vector<Wish> wishes;
  {
    const std::lock_guard lock(m_mutex);
    for (auto &[id, client] : m_clients)
      if (client.every != 0 && client.seen++ % client.every == 0 &&
          !(client.ring && client.ring->isFull()))
        wishes.push_back({id, client.width, client.height});
  }
  if (wishes.empty())
    return;
  const char *why = nullptr;
  const Picture picture = readDrawable(context, why);
  if (picture.bytes.empty())
    return;
  for (const Wish &wish : wishes)
    lend(wish.id, reduced(picture, wish.width, wish.height), context);
}

void Session::lend(wire::ClientId id, const Picture &picture, const RasterContext &context) {
  const std::lock_guard lock(m_mutex);
  const auto found = m_clients.find(id);
  if (found == m_clients.end())
    return;
  Client &client = found->second;
  const wire::FrameLayout *layout = client.ring ? &client.ring->layout() : nullptr;
  if (!layout || layout->width != picture.width || layout->height != picture.height) {
    client.ring = wire::FrameRing::make(picture.width, picture.height);
    if (!client.ring)
      return;
    layout = &client.ring->layout();
    ++client.serial;
    m_server->send(id, wire::bufferLine(*layout, client.serial), client.ring->share());
  }
  const int slot = client.ring->take();
  if (slot < 0)
    return;
  std::memcpy(client.ring->pixels(slot), picture.bytes.data(), picture.bytes.size());
  m_server->send(id, wire::eventLine("frame", wire::Json::object({{"serial", client.serial},
                                                                  {"slot", slot},
                                                                  {"number", frames()},
                                                                  {"width", picture.width},
                                                                  {"height", picture.height},
                                                                  {"context", context.serial}})));
}

} // namespace arbiter::state::control
