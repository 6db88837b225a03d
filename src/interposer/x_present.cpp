#include "interposer/x_present.h"

#include <cstdlib>
#include <memory>
#include <mutex>
#include <vector>

#include <dlfcn.h>
#include <sys/ipc.h>
#include <sys/shm.h>
#include <sys/uio.h>
#include <xcb/xcb.h>
#include <xcb/xcbext.h>

#include "swrast/image.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

using state::software::Drawable;

/// The functions of libxcb; libGLX has loaded it through libX11.
struct Xcb {
  void *handle = dlopen("libxcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  void *bridge = dlopen("libX11-xcb.so.1", RTLD_LAZY | RTLD_LOCAL);
  template <typename Function> static Function get(void *from, const char *name) {
    return from ? reinterpret_cast<Function>(dlsym(from, name)) : nullptr;
  }
  xcb_connection_t *(*connectionOf)(void *display) =
      get<xcb_connection_t *(*)(void *)>(bridge, "XGetXCBConnection");
// NOLINTNEXTLINE(bugprone-macro-parentheses): a member's name cannot stand in parentheses.
#define ARBITER_XCB(name) decltype(&::name) name = get<decltype(&::name)>(handle, #name)
  ARBITER_XCB(xcb_connection_has_error);
  ARBITER_XCB(xcb_get_extension_data);
  ARBITER_XCB(xcb_get_setup);
  ARBITER_XCB(xcb_generate_id);
  ARBITER_XCB(xcb_send_request);
  ARBITER_XCB(xcb_request_check);
  ARBITER_XCB(xcb_create_gc);
  ARBITER_XCB(xcb_get_geometry);
  ARBITER_XCB(xcb_get_geometry_reply);
  ARBITER_XCB(xcb_get_window_attributes);
  ARBITER_XCB(xcb_get_window_attributes_reply);
  ARBITER_XCB(xcb_get_input_focus);
  ARBITER_XCB(xcb_get_input_focus_reply);
  ARBITER_XCB(xcb_setup_roots_iterator);
  ARBITER_XCB(xcb_screen_next);
  ARBITER_XCB(xcb_screen_allowed_depths_iterator);
  ARBITER_XCB(xcb_depth_next);
  ARBITER_XCB(xcb_depth_visuals_iterator);
  ARBITER_XCB(xcb_visualtype_next);
#undef ARBITER_XCB
  [[nodiscard]] bool usable() const {
    return connectionOf && xcb_connection_has_error && xcb_get_extension_data && xcb_get_setup &&
           xcb_generate_id && xcb_send_request && xcb_request_check && xcb_create_gc &&
           xcb_get_geometry && xcb_get_geometry_reply && xcb_get_window_attributes &&
           xcb_get_window_attributes_reply && xcb_get_input_focus && xcb_get_input_focus_reply &&
           xcb_setup_roots_iterator && xcb_screen_next && xcb_screen_allowed_depths_iterator &&
           xcb_depth_next && xcb_depth_visuals_iterator && xcb_visualtype_next;
  }
};
const Xcb &xcb() {
  static const Xcb s_xcb;
  return s_xcb;
}

// --- The requests of MIT-SHM that are used ---

xcb_extension_t g_shm = {"MIT-SHM", 0};
constexpr std::uint8_t kAttach = 1, kDetach = 2, kPutImage = 3;

struct AttachRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t segment, id;
  std::uint8_t readOnly, pad[3];
};
struct DetachRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t segment;
};
struct PutImageRequest {
  std::uint8_t majorOpcode, minorOpcode;
  std::uint16_t length;
  std::uint32_t drawable, gc;
  std::uint16_t totalWidth, totalHeight, sourceX, sourceY, sourceWidth, sourceHeight;
  std::int16_t destX, destY;
  std::uint8_t depth, format, sendEvent, pad;
  std::uint32_t segment, offset;
};

template <typename Request>
xcb_void_cookie_t send(xcb_connection_t *connection, Request request, std::uint8_t opcode,
                       bool checked) {
  const xcb_protocol_request_t protocol{2, &g_shm, opcode, 1};
  // libxcb writes into the two elements before the first.
  iovec parts[4] = {};
  parts[2] = {&request, sizeof request};
  return {
      xcb().xcb_send_request(connection, checked ? XCB_REQUEST_CHECKED : 0, parts + 2, &protocol)};
}

/// An answer of libxcb's, which is to be freed.
template <typename Reply> using Answer = std::unique_ptr<Reply, decltype(&std::free)>;
template <typename Reply> Answer<Reply> answer(Reply *reply) { return {reply, &std::free}; }

struct Connection {
  const void *display = nullptr;
  xcb_connection_t *xcb = nullptr; ///< null: closed
  bool refused = false;            ///< the server cannot reach our memory
};

/// A window as a place to show pixels in.
struct Window {
  std::shared_ptr<Connection> connection;
  std::uint32_t window = 0, gc = 0;
  std::uint8_t depth = 0;
};

struct Segment {
  std::shared_ptr<Connection> connection;
  std::uint32_t name = 0;
  std::uint8_t *memory = nullptr;
  std::size_t bytes = 0;
  bool used = false;
};

constexpr std::size_t kGuard = 64; ///< that may be read before and behind an image
constexpr std::size_t kIdleSegments = 2;

/// Never destroyed: images may outlive the library's own destructors.
struct Tables {
  std::mutex mutex;
  std::vector<std::shared_ptr<Connection>> connections;
  std::vector<std::unique_ptr<Window>> windows;
  std::vector<std::unique_ptr<Segment>> segments;
};
Tables &tables() {
  static Tables *const s_tables = new Tables;
  return *s_tables;
}

void destroy(const Segment &segment) {
  if (segment.connection->xcb)
    send(segment.connection->xcb, DetachRequest{.segment = segment.name}, kDetach, false);
  shmdt(segment.memory);
}

/// Storage that is not used any more waits for the next image of its size.
void release(void *user) {
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  std::size_t idle = 0;
  static_cast<Segment *>(user)->used = false;
  for (std::size_t i = t.segments.size(); i-- > 0;) {
    const Segment &segment = *t.segments[i];
    if (segment.used || (segment.connection->xcb && ++idle <= kIdleSegments))
      continue;
    destroy(segment);
    t.segments.erase(t.segments.begin() + std::ptrdiff_t(i));
  }
}

/// Under the lock.
Segment *makeSegment(const std::shared_ptr<Connection> &connection, std::size_t bytes) {
  const int id = shmget(IPC_PRIVATE, bytes, IPC_CREAT | 0600);
  if (id < 0)
    return nullptr;
  void *const memory = shmat(id, nullptr, 0);
  auto segment = std::make_unique<Segment>();
  *segment = {connection, xcb().xcb_generate_id(connection->xcb),
              static_cast<std::uint8_t *>(memory), bytes, false};
  bool attached = memory != reinterpret_cast<void *>(-1);
  if (attached) {
    AttachRequest request{.segment = segment->name, .id = std::uint32_t(id), .readOnly = 1};
    const auto error = answer(
        xcb().xcb_request_check(connection->xcb, send(connection->xcb, request, kAttach, true)));
    attached = !error;
    if (error) {
      connection->refused = true;
      logInfo("layer", "X: the server cannot share memory with us; frames go by the host");
      shmdt(memory);
    }
  }
  // It lives on until both have let go.
  shmctl(id, IPC_RMID, nullptr);
  if (!attached)
    return nullptr;
  tables().segments.push_back(std::move(segment));
  return tables().segments.back().get();
}

std::shared_ptr<swrast::Storage> sharedMemory(const Drawable &drawable, std::size_t bytes) {
  const auto &window = *static_cast<const Window *>(drawable.presenter);
  Tables &t = tables();
  Segment *found = nullptr;
  {
    const std::lock_guard lock(t.mutex);
    if (!window.connection->xcb || window.connection->refused)
      return nullptr;
    for (const auto &segment : t.segments)
      if (!segment->used && segment->connection == window.connection &&
          segment->bytes == bytes + 2 * kGuard)
        found = segment.get();
    if (!found)
      found = makeSegment(window.connection, bytes + 2 * kGuard);
    if (!found)
      return nullptr;
    found->used = true;
  }
  return swrast::Storage::wrap(found->memory + kGuard, bytes, release, found);
}

bool show(const Drawable &drawable, const swrast::Image &image) {
  const auto &window = *static_cast<const Window *>(drawable.presenter);
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  const Segment *found = nullptr;
  for (const auto &segment : t.segments)
    if (image.storage && segment->memory + kGuard == image.storage->data())
      found = segment.get();
  // The server reads rows from the top down.
  if (!found || !window.connection->xcb || found->connection != window.connection ||
      (image.rowStride > 0 && image.height > 1) || image.width > 0x7FFF || image.height > 0x7FFF)
    return false;
  xcb_connection_t *const connection = window.connection->xcb;
  const std::int64_t stride = image.rowStride < 0 ? -image.rowStride : image.rowStride;
  PutImageRequest request{};
  request.drawable = window.window;
  request.gc = window.gc;
  request.totalWidth = std::uint16_t(stride / 4);
  request.totalHeight = std::uint16_t(image.height);
  request.sourceWidth = std::uint16_t(image.width);
  request.sourceHeight = std::uint16_t(image.height);
  request.depth = window.depth;
  request.format = XCB_IMAGE_FORMAT_Z_PIXMAP;
  request.segment = found->name;
  request.offset = std::uint32_t(image.pixel(0, image.height - 1) - found->memory);
  const xcb_void_cookie_t cookie = send(connection, request, kPutImage, true);
  // The check waits until the server has read: from then on the memory may be written again.
  return !answer(xcb().xcb_request_check(connection, cookie)) &&
         !xcb().xcb_connection_has_error(connection);
}

/// The visual has a byte each of blue, green and red, in this order.
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

/// Under the lock; null where the server has no MIT-SHM.
std::shared_ptr<Connection> connectionOf(void *display) {
  Tables &t = tables();
  for (const auto &known : t.connections)
    if (known->display == display)
      return known;
  auto made = std::make_shared<Connection>();
  made->display = display;
  made->xcb = xcb().connectionOf(display);
  const xcb_query_extension_reply_t *const shm =
      made->xcb ? xcb().xcb_get_extension_data(made->xcb, &g_shm) : nullptr;
  made->refused = !shm || !shm->present;
  t.connections.push_back(made);
  return made;
}

} // namespace

void offerPresenting(void *display, std::uint32_t name, Drawable &drawable) {
  if (!display || !xcb().usable())
    return;
  Tables &t = tables();
  const std::lock_guard lock(t.mutex);
  const std::shared_ptr<Connection> connection = connectionOf(display);
  if (!connection->xcb || connection->refused)
    return;
  xcb_connection_t *const c = connection->xcb;
  // Both questions go out before the first answer is waited for.
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
  Window *window = nullptr;
  for (const auto &known : t.windows)
    if (known->connection == connection && known->window == name && known->depth == geometry->depth)
      window = known.get();
  if (!window) {
    t.windows.push_back(std::make_unique<Window>());
    window = t.windows.back().get();
    *window = {connection, name, xcb().xcb_generate_id(c), geometry->depth};
    const std::uint32_t exposures = 0;
    xcb().xcb_create_gc(c, window->gc, name, XCB_GC_GRAPHICS_EXPOSURES, &exposures);
  }
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
}

} // namespace arbiter::interposer
