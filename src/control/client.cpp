#include "control/client.h"

#include <algorithm>
#include <poll.h>
#include <utility>

namespace arbiter::control {

namespace {

/// Beyond this number the oldest events that the caller did not take are dropped.
constexpr std::size_t kMaxEvents = 1024;

std::int64_t integerAt(const Json &object, const char *name) {
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found != object.end() && found->is_number_integer() ? found->get<std::int64_t>() : -1;
}

Fault faultOf(const Json &error) {
  Fault fault = {kNoRequest, "the error has no message", {}};
  if (!error.is_object())
    return fault;
  fault.code = int(integerAt(error, "code"));
  if (const auto text = error.find("message"); text != error.end() && text->is_string())
    fault.message = text->get<std::string>();
  if (const auto data = error.find("data"); data != error.end())
    fault.data = *data;
  return fault;
}

} // namespace

Client::Client(Descriptor connected) : m_channel(std::move(connected)) {}

void Client::send(std::string line) {
  if (!m_closed && (!m_channel.queue(std::move(line)) || !m_channel.write()))
    m_closed = true;
}

std::uint64_t Client::request(std::string_view method, Json params) {
  send(requestLine(++m_lastId, method, std::move(params)));
  return m_lastId;
}

void Client::notify(std::string_view method, Json params) {
  send(eventLine(method, std::move(params)));
}

void Client::receive() {
  if (!m_closed && !m_channel.write())
    m_closed = true;
  while (!m_closed) {
    const Channel::Read read = m_channel.read(true);
    if (read == Channel::Read::Closed)
      m_closed = true;
    if (read != Channel::Read::Some)
      return;
    std::string line;
    Channel::Line next;
    while ((next = m_channel.next(line)) == Channel::Line::One) {
      Result<Json, Fault> message = parseMessage(line);
      if (!message) {
        m_closed = true;
        return;
      }
      take(std::move(message.value()));
    }
    if (next == Channel::Line::TooLong)
      m_closed = true;
  }
}

void Client::take(Json message) {
  if (!message.is_object())
    return;
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string()) {
    const std::int64_t id = integerAt(message, "id");
    const auto result = message.find("result"), error = message.find("error");
    if (result != message.end())
      m_answers.emplace_back(std::uint64_t(id), std::move(*result));
    else if (error != message.end())
      m_answers.emplace_back(std::uint64_t(id), faultOf(*error));
    return;
  }
  const auto found = message.find("params");
  Json params = found != message.end() ? std::move(*found) : Json::object();
  const std::string name = method->get<std::string>();
  if (name == "frame.buffer")
    return takeBuffer(params);
  if (name == "frame")
    return takeFrame(std::move(params));
  if (m_events.size() >= kMaxEvents)
    m_events.pop_front();
  m_events.push_back({name, std::move(params)});
}

void Client::takeBuffer(const Json &params) {
  FrameLayout layout;
  const std::int64_t width = integerAt(params, "width"), height = integerAt(params, "height");
  if (width > 0 && width <= kMaxFrameSide && height > 0 && height <= kMaxFrameSide) {
    layout.width = int(width);
    layout.height = int(height);
  }
  layout.stride = std::size_t(integerAt(params, "stride"));
  layout.slotBytes = std::size_t(integerAt(params, "slot_bytes"));
  m_buffer = {integerAt(params, "serial"), FrameView::map(m_channel.takeDescriptor(), layout)};
}

void Client::takeFrame(Json params) {
  const std::int64_t serial = integerAt(params, "serial"), slot = integerAt(params, "slot");
  if (!m_buffer.view || serial != m_buffer.serial || slot < 0 || slot >= kFrameSlots)
    return giveBack(serial, slot);
  if (m_frame) // a newer frame has arrived
    giveBack(m_frame->serial, m_frame->slot);
  const FrameLayout &layout = m_buffer.view->layout();
  m_frame = Frame{m_buffer.view->pixels(int(slot)),
                  layout.width,
                  layout.height,
                  layout.stride,
                  slot,
                  serial,
                  std::move(params)};
  m_frameView = m_buffer.view;
}

void Client::giveBack(std::int64_t serial, std::int64_t slot) {
  notify("frame.release", Json::object({{"serial", serial}, {"slot", slot}}));
}

std::optional<Frame> Client::nextFrame() {
  if (!m_frame)
    return std::nullopt;
  m_lent.push_back(std::move(m_frameView));
  return std::exchange(m_frame, std::nullopt);
}

void Client::release(const Frame &frame) {
  const auto holds = [&](const std::shared_ptr<FrameView> &view) {
    return view->pixels(int(frame.slot)) == frame.pixels;
  };
  if (const auto it = std::find_if(m_lent.begin(), m_lent.end(), holds); it != m_lent.end())
    m_lent.erase(it);
  giveBack(frame.serial, frame.slot);
}

std::optional<Answer> Client::takeAnswer(std::uint64_t id) {
  const auto it = std::find_if(m_answers.begin(), m_answers.end(),
                               [&](const auto &each) { return each.first == id; });
  if (it == m_answers.end())
    return std::nullopt;
  Answer answer = std::move(it->second);
  m_answers.erase(it);
  return answer;
}

std::optional<std::pair<std::uint64_t, Answer>> Client::nextAnswer() {
  if (m_answers.empty())
    return std::nullopt;
  auto first = std::move(m_answers.front());
  m_answers.pop_front();
  return first;
}

std::optional<Event> Client::nextEvent() {
  if (m_events.empty())
    return std::nullopt;
  Event first = std::move(m_events.front());
  m_events.pop_front();
  return first;
}

bool Client::await(std::chrono::milliseconds atMost) {
  pollfd polled = {m_channel.fd(), short(POLLIN | (m_channel.wantsToWrite() ? POLLOUT : 0)), 0};
  if (m_closed || poll(&polled, 1, int(atMost.count())) <= 0)
    return false;
  receive();
  return true;
}

bool Client::awaitUntil(std::chrono::steady_clock::time_point end) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
  if (m_closed || left.count() <= 0)
    return false;
  await(left);
  return true;
}

Answer Client::call(std::string_view method, Json params, std::chrono::milliseconds atMost) {
  const std::uint64_t id = request(method, std::move(params));
  const auto end = std::chrono::steady_clock::now() + atMost;
  for (;;) {
    if (std::optional<Answer> answer = takeAnswer(id))
      return std::move(*answer);
    if (m_closed)
      return Fault{0, "the process has ended, or hung up", {}};
    if (!awaitUntil(end))
      return Fault{0, "no answer in " + std::to_string(atMost.count()) + " ms", {}};
  }
}

} // namespace arbiter::control
