#include "control/server.h"

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <sys/socket.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

#include "control/client.h"

namespace arbiter::control {
namespace {

using namespace std::chrono_literals;

/// Answers `echo` with its parameters, and sends an event to a client that asks for one.
class Echo : public Service {
public:
  Server *server = nullptr;
  std::atomic<int> clients{0}, requests{0};

  void connected(ClientId, pid_t) override { ++clients; }
  void disconnected(ClientId) override { --clients; }
  void received(ClientId client, Request request) override {
    ++requests;
    if (request.method == "event")
      server->send(client, eventLine("happened", request.params));
    if (request.method == "frames")
      lend(client);
    if (request.wantsAnswer)
      server->send(client, answerLine(request.id, request.params));
  }

private:
  void lend(ClientId client) {
    ring = FrameRing::make(8, 8);
    const int slot = ring->take();
    ring->pixels(slot)[0] = 42;
    server->send(client, bufferLine(ring->layout(), 1), ring->share());
    server->send(client, eventLine("frame", {{"serial", 1}, {"slot", slot}}));
  }
  std::shared_ptr<FrameRing> ring;
};

class Served : public testing::Test {
protected:
  void SetUp() override {
    std::string name = (std::filesystem::temp_directory_path() / "controlXXXXXX").string();
    m_runtime = mkdtemp(name.data());
    setenv("XDG_RUNTIME_DIR", m_runtime.c_str(), 1);
    const auto folder = socketFolder();
    ASSERT_TRUE(folder) << folder.error().message;
    m_folder = folder.value();
    m_path = m_folder + "/" + socketName(getpid(), Kind::Layer);
    auto fd = listenAt(m_path);
    ASSERT_TRUE(fd) << fd.error().message;
    m_server = Server::listening(std::move(fd.value()), m_path);
    m_echo.server = m_server.get();
    m_thread = std::thread([this] { m_server->run(m_echo); });
  }
  void TearDown() override {
    m_server->stop();
    m_thread.join();
    m_server.reset();
    EXPECT_FALSE(std::filesystem::exists(m_path)) << "the socket is left";
    std::filesystem::remove_all(m_runtime);
  }
  Client connect() {
    auto fd = connectTo(m_path);
    EXPECT_TRUE(fd);
    return Client(std::move(fd.value()));
  }
  /// Waits until the server has this many clients.
  void awaitClients(int count) {
    for (int i = 0; i < 6000 && m_echo.clients != count; ++i)
      std::this_thread::sleep_for(10ms);
    EXPECT_EQ(m_echo.clients, count);
  }

  std::string m_runtime, m_folder, m_path;
  Echo m_echo;
  std::unique_ptr<Server> m_server;
  std::thread m_thread;
};

TEST_F(Served, Answers) {
  Client client = connect();
  const Answer answer = client.call("echo", {{"a", 1}}, 10s);
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer.value()["a"], 1);
  client.notify("event", {{"b", 2}});
  std::optional<Event> event;
  while (!(event = client.nextEvent()) && client.await(10s)) {
  }
  ASSERT_TRUE(event);
  EXPECT_EQ(event->method, "happened");
  EXPECT_EQ(event->params["b"], 2);
}

TEST_F(Served, IsTheUsersAlone) {
  struct stat state;
  ASSERT_EQ(stat(m_path.c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 07777, 0600u);
  ASSERT_EQ(stat(m_folder.c_str(), &state), 0);
  EXPECT_EQ(state.st_mode & 07777, 0700u);
  chmod(m_folder.c_str(), 0755);
  EXPECT_FALSE(socketFolder()) << "others may enter it";
  chmod(m_folder.c_str(), 0700);
  EXPECT_TRUE(socketFolder());
}

TEST_F(Served, IsFoundAndDeadOnesGo) {
  const std::string dead = m_folder + "/999999.sock";
  { ASSERT_TRUE(listenAt(dead)); } // closed, but its file stays
  ASSERT_TRUE(std::filesystem::exists(dead));
  const std::vector<Listener> found = findListeners(m_folder);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].process, getpid());
  EXPECT_FALSE(std::filesystem::exists(dead));
  EXPECT_FALSE(listenAt(m_path)) << "a server listens there";
}

TEST_F(Served, LendsFrames) {
  Client client = connect();
  client.notify("frames");
  std::optional<Frame> frame;
  while (!(frame = client.nextFrame()) && client.await(10s)) {
  }
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->pixels[0], 42);
  EXPECT_EQ(frame->width, 8);
  client.release(*frame);
  EXPECT_TRUE(client.call("echo", Json::object(), 10s));
}

TEST_F(Served, TooManyClientsAreToldSo) {
  std::vector<Client> clients;
  for (std::size_t i = 0; i < Server::kMaxClients; ++i) {
    clients.push_back(connect());
    ASSERT_TRUE(clients.back().call("echo", Json::object(), 10s));
  }
  Client last = connect();
  while (last.connected() && last.await(10s)) {
  }
  EXPECT_FALSE(last.connected());
  EXPECT_TRUE(clients[0].call("echo", Json::object(), 10s));
}

TEST_F(Served, WhoSendsTooMuchIsCutOffAndNobodyElse) {
  Client good = connect();
  auto raw = connectTo(m_path);
  const std::string much(1 << 20, 'x');
  for (int i = 0; i < 6; ++i)
    (void)send(raw.value().get(), much.data(), much.size(), MSG_NOSIGNAL);
  char byte = 0;
  while (recv(raw.value().get(), &byte, 1, 0) > 0) {
  }
  awaitClients(1);
  EXPECT_TRUE(good.call("echo", Json::object(), 10s));
}

/// The server must not keep all answers for a client that sends requests and never reads.
TEST_F(Served, WhoReadsNothingIsCutOff) {
  auto raw = connectTo(m_path);
  const std::string line = requestLine(1, "echo", {{"text", std::string(1 << 20, 'x')}});
  for (int i = 0; i < 24; ++i)
    if (send(raw.value().get(), line.data(), line.size(), MSG_NOSIGNAL) < 0)
      break;
  awaitClients(0);
  EXPECT_TRUE(connect().call("echo", Json::object(), 10s));
}

TEST_F(Served, SurvivesHostileBytesAndDescriptors) {
  std::mt19937 random(7);
  Client good = connect();
  const auto descriptors = [] {
    const auto folder = std::filesystem::directory_iterator("/proc/self/fd");
    return std::distance(begin(folder), end(folder));
  };
  ASSERT_TRUE(good.call("echo", Json::object(), 10s)); // the server accepts a new client
  const auto before = descriptors();
  for (int round = 0; round < 100; ++round) {
    auto raw = connectTo(m_path);
    ASSERT_TRUE(raw);
    std::string bytes = round % 3 == 0 ? requestLine(1, "echo", Json::object()) : std::string();
    for (std::size_t i = random() % 3000; i > 0; --i)
      bytes += "{}[]\",:\n\n0e\xff\\ \0"[random() % 15];
    iovec part = {bytes.data(), bytes.size()};
    alignas(cmsghdr) char extra[CMSG_SPACE(sizeof(int))] = {};
    msghdr message = {};
    message.msg_iov = &part;
    message.msg_iovlen = 1;
    message.msg_control = extra;
    message.msg_controllen = sizeof extra;
    cmsghdr *const head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof(int));
    const int fd = STDIN_FILENO;
    std::memcpy(CMSG_DATA(head), &fd, sizeof fd);
    (void)sendmsg(raw.value().get(), &message, MSG_NOSIGNAL);
  }
  awaitClients(1);
  ASSERT_TRUE(good.call("echo", Json::object(), 10s));
  EXPECT_EQ(descriptors(), before) << "descriptors that came along are kept";
}

TEST(Connected, EndsWithItsClient) {
  int ends[2];
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
  Echo echo;
  const auto server = Server::connected(Descriptor(ends[0]));
  echo.server = server.get();
  std::thread thread([&] { server->run(echo); });
  {
    Client client((Descriptor(ends[1])));
    EXPECT_TRUE(client.call("echo", Json::object(), 10s));
  }
  thread.join();
  EXPECT_EQ(echo.clients, 0);
}

/// The client must survive a server that sends nonsense.
TEST(Client, SurvivesAHostileServer) {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    int ends[2];
    ASSERT_EQ(socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends), 0);
    Client client((Descriptor(ends[0])));
    const Descriptor server(ends[1]);
    const char *const lines[] = {
        "{\"method\":\"frame\",\"params\":{\"slot\":7,\"serial\":1}}\n",
        "{\"method\":\"frame.buffer\",\"params\":{\"width\":-1,\"slot_bytes\":1e99}}\n",
        ("{\"method\":\"frame.buffer\",\"params\":{\"width\":8,\"height\":8,\"stride\":32,"
         "\"slot_bytes\":4096,\"serial\":1}}\n"),
        "{\"id\":{},\"result\":[]}\n",
        "{\"id\":-5,\"error\":7}\n",
        "[]\n",
        "\n",
        "}{\n"};
    for (int i = 0; i < 4; ++i) {
      const char *const line = lines[random() % std::size(lines)];
      (void)send(server.get(), line, std::strlen(line), MSG_NOSIGNAL);
    }
    client.receive();
    EXPECT_FALSE(client.nextFrame());
  }
}

} // namespace
} // namespace arbiter::control
