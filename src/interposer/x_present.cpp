#include "interposer/x_present.h"

#include <algorithm>
#include <new>
#include <vector>

#include "interposer/x_segment.h"
#include "interposer/x_window.h"
#include "swrast/image/image.h"
#include "util/thread.h"

namespace arbiter::interposer {

namespace {

using state::Drawable;

/// The X graphics context that pictures are put with, for windows of a screen's depth.
struct GraphicsContext {
  std::shared_ptr<Connection> connection;
  std::uint32_t root = 0, name = 0;
  std::uint8_t depth = 0;
};

constexpr std::size_t kGuard = 64; ///< bytes that may be read before and behind an image
constexpr std::size_t kIdleSegments = 2;

/// The tables of this file. They are never destroyed, as images may outlive the library's
/// destructors. No request is sent under their lock: sending takes Xlib's lock, which another
/// thread may hold while it waits for this one.
struct Tables {
  std::mutex mutex;
  std::vector<std::shared_ptr<Connection>> connections;
  std::vector<GraphicsContext> contexts;
  std::vector<std::unique_ptr<Window>> windows;
  std::vector<std::unique_ptr<Segment>> segments;
  std::uint64_t shown = 0;
};
Tables &tables() {
  static Tables *const s_tables = new Tables;
  return *s_tables;
}

/// Keeps unused storage for the next image of its size.
void release(void *user) {
  Tables &t = tables();
  std::vector<std::unique_ptr<Segment>> leaving;
  {
    const std::lock_guard lock(t.mutex);
    std::size_t idle = 0;
    static_cast<Segment *>(user)->used = false;
    for (std::size_t i = t.segments.size(); i-- > 0;) {
      const Segment &segment = *t.segments[i];
      if (segment.used || (segment.connection()->xcb && ++idle <= kIdleSegments))
        continue;
      try {
        leaving.push_back(std::move(t.segments[i]));
      } catch (const std::bad_alloc &) { // the segment stays for now
        break;
      }
      t.segments.erase(t.segments.begin() + std::ptrdiff_t(i));
    }
  }
}

bool isRead(void *user, bool wait) {
  const NoCancel scope;
  return static_cast<Segment *>(user)->isRead(wait);
}

constexpr swrast::Storage::Owner kOwner = {release, isRead};

/// Returns the idle segment whose picture was put longest ago.
Segment *takeIdle(const std::shared_ptr<Connection> &connection, std::size_t bytes) {
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  Segment *found = nullptr;
  for (const auto &segment : t.segments)
    if (!segment->used && segment->connection() == connection && segment->bytes() == bytes &&
        (!found || segment->shownAt < found->shownAt))
      found = segment.get();
  if (found)
    found->used = true;
  return found;
}

std::shared_ptr<swrast::Storage> sharedMemory(const Drawable &drawable, std::size_t bytes) {
  const NoCancel scope;
  const auto &window = *static_cast<const Window *>(drawable.presenter);
  if (!window.connection->xcb || window.connection->refused)
    return nullptr;
  Segment *segment = takeIdle(window.connection, bytes + 2 * kGuard);
  if (!segment) {
    std::unique_ptr<Segment> made = Segment::make(window.connection, bytes + 2 * kGuard);
    if (!made)
      return nullptr;
    segment = made.get();
    segment->used = true;
    Tables &t = tables();
    const std::lock_guard lock(t.mutex);
    t.segments.push_back(std::move(made));
  }
  segment->isRead(true);
  return swrast::Storage::wrap(segment->memory() + kGuard, bytes, kOwner, segment);
}

/// Returns the segment that the image's pixels are in; null for other memory. The image keeps the
/// segment alive.
Segment *segmentOf(const swrast::Image &image) {
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  for (const auto &segment : t.segments)
    if (image.storage && segment->memory() + kGuard == image.storage->data()) {
      segment->shownAt = ++t.shown;
      return segment.get();
    }
  return nullptr;
}

bool show(const Drawable &drawable, const swrast::Image &image) {
  const NoCancel scope;
  auto &window = *static_cast<Window *>(drawable.presenter);
  // The server reads rows from top to bottom.
  if (window.failed || (image.rowStride > 0 && image.height > 1) || image.width > 0x7FFF ||
      image.height > 0x7FFF)
    return false;
  Segment *const segment = segmentOf(image);
  if (!segment || segment->connection() != window.connection)
    return false;
  const std::int64_t stride = image.rowStride < 0 ? -image.rowStride : image.rowStride;
  const Picture picture = {.drawable = window.window,
                           .gc = window.gc,
                           .depth = window.depth,
                           .width = std::uint16_t(image.width),
                           .height = std::uint16_t(image.height),
                           .rowPixels = std::uint16_t(stride / 4),
                           .offset =
                               std::size_t(image.pixel(0, image.height - 1) - segment->memory())};
  const bool shown = segment->show(picture, window.failed);
  if (shown)
    window.hostMissedFrames = true;
  return shown;
}

/// Takes all answers of the connection that have arrived.
void takeAnswers(const Connection &connection) {
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  for (const auto &segment : t.segments)
    if (segment->connection().get() == &connection)
      segment->isRead(false);
  for (const auto &window : t.windows)
    if (window->connection.get() == &connection)
      window->takeAnswers();
}

bool sizeOf(const Drawable &drawable, int &width, int &height, bool sure) {
  const NoCancel scope;
  auto &window = *static_cast<Window *>(drawable.presenter);
  return window.size(width, height, sure, [&] { takeAnswers(*window.connection); });
}

/// True if the visual has a byte each of blue, green and red, in this order.
bool isTrueColor(xcb_connection_t *connection, std::uint32_t root, std::uint32_t visual) {
  const xcb_setup_t *const setup = xcb().xcb_get_setup(connection);
  if (setup->image_byte_order != XCB_IMAGE_ORDER_LSB_FIRST)
    return false;
  for (auto screen = xcb().xcb_setup_roots_iterator(setup); screen.rem != 0;
       xcb().xcb_screen_next(&screen)) {
    if (screen.data->root != root)
      continue;
    for (auto depth = xcb().xcb_screen_allowed_depths_iterator(screen.data); depth.rem != 0;
         xcb().xcb_depth_next(&depth))
      for (auto type = xcb().xcb_depth_visuals_iterator(depth.data); type.rem != 0;
           xcb().xcb_visualtype_next(&type))
        if (type.data->visual_id == visual)
          return type.data->red_mask == 0xFF0000 && type.data->green_mask == 0xFF00 &&
                 type.data->blue_mask == 0xFF;
  }
  return false;
}

/// Returns the display's connection; marked as refused if the server has no MIT-SHM.
std::shared_ptr<Connection> connectionOf(void *display) {
  Tables &t = tables();
  {
    const std::lock_guard lock(t.mutex);
    for (const auto &known : t.connections)
      if (known->display == display)
        return known;
  }
  auto made = std::make_shared<Connection>(display, xlibBridge().connectionOf(display));
  made->refused = !made->xcb || !hasSharedMemory(made->xcb);
  const std::lock_guard lock(t.mutex);
  t.connections.push_back(made);
  return made;
}

/// Returns a graphics context; 0 if there is none. \param window a window of the same screen and
/// depth
std::uint32_t graphicsContextOf(const std::shared_ptr<Connection> &connection, std::uint32_t root,
                                std::uint8_t depth, std::uint32_t window) {
  Tables &t = tables();
  {
    const std::lock_guard lock(t.mutex);
    for (const GraphicsContext &known : t.contexts)
      if (known.connection == connection && known.root == root && known.depth == depth)
        return known.name;
  }
  xcb_connection_t *const c = connection->xcb;
  const std::uint32_t name = xcb().xcb_generate_id(c);
  const std::uint32_t exposures = 0;
  const auto cookie =
      xcb().xcb_create_gc_checked(c, name, window, XCB_GC_GRAPHICS_EXPOSURES, &exposures);
  if (answer(xcb().xcb_request_check(c, cookie)))
    return 0;
  const std::lock_guard lock(t.mutex);
  t.contexts.push_back({connection, root, name, depth});
  return name;
}

} // namespace

bool hostMissedFrames(const state::Drawable &drawable, bool forget) {
  auto &window = *static_cast<Window *>(drawable.presenter);
  return forget ? window.hostMissedFrames.exchange(false) : window.hostMissedFrames.load();
}

void offerPresenting(void *display, std::uint32_t name, Drawable &drawable) {
  const NoCancel scope;
  if (!display || !xcb().usable || !xlibBridge().connectionOf)
    return;
  const std::shared_ptr<Connection> connection = connectionOf(display);
  xcb_connection_t *const c = connection->xcb;
  if (!c || connection->refused)
    return;
  // Both queries are sent before the first answer is waited for.
  const auto attributesCookie = xcb().xcb_get_window_attributes(c, name);
  const auto geometryCookie = xcb().xcb_get_geometry(c, name);
  xcb_generic_error_t *errors[2] = {};
  const auto attributes =
      answer(xcb().xcb_get_window_attributes_reply(c, attributesCookie, &errors[0]));
  const auto geometry = answer(xcb().xcb_get_geometry_reply(c, geometryCookie, &errors[1]));
  std::free(errors[0]);
  std::free(errors[1]);
  if (!attributes || !geometry || (geometry->depth != 24 && geometry->depth != 32) ||
      !isTrueColor(c, geometry->root, attributes->visual))
    return;
  const std::uint32_t gc = graphicsContextOf(connection, geometry->root, geometry->depth, name);
  if (gc == 0)
    return;
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  Window *window = nullptr;
  for (const auto &known : t.windows)
    if (known->connection == connection && known->window == name && known->gc == gc)
      window = known.get();
  if (!window) {
    t.windows.push_back(std::make_unique<Window>(connection, name, gc, geometry->depth));
    window = t.windows.back().get();
  }
  window->forget();
  drawable.size = sizeOf;
  drawable.presenter = window;
  drawable.sharedMemory = sharedMemory;
  drawable.show = show;
}

void presentingDisplayCloses(const void *display) {
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  std::erase_if(t.connections, [display](const std::shared_ptr<Connection> &connection) {
    if (connection->display != display)
      return false;
    connection->xcb = nullptr;
    return true;
  });
  std::erase_if(t.contexts,
                [](const GraphicsContext &context) { return !context.connection->xcb; });
  // As the connection is closed, this sends nothing.
  std::erase_if(t.segments, [](const std::unique_ptr<Segment> &segment) {
    return !segment->used && !segment->connection()->xcb;
  });
}

} // namespace arbiter::interposer
