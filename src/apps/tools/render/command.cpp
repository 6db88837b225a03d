// Implements `arbiter render`, which draws documents for another process.
#include <cstdio>
#include <thread>
#include <unistd.h>

#include "apps/tools/commands.h"
#include "apps/tools/draw/surface.h"
#include "apps/tools/input.h"
#include "apps/tools/launch/in_layer.h"
#include "apps/tools/render/methods.h"
#include "control/address.h"

namespace arbiter::tools {

namespace {

/// Returns a complaint about --fd, or "".
std::string descriptorFault(const RenderArguments &arguments) {
  pid_t peer = 0;
  if (arguments.descriptor < 0 || control::isOwnPeer(arguments.descriptor, peer))
    return {};
  return "--fd " + std::to_string(arguments.descriptor) +
         ": is no connected socket whose other end is this user's";
}

/// Opens the socket that the arguments select. Requires: no descriptorFault().
std::unique_ptr<control::Server> openServer(const RenderArguments &arguments, std::string &fault) {
  if (arguments.descriptor >= 0)
    return control::Server::connected(control::Descriptor(arguments.descriptor));
  const auto folder = control::socketFolder();
  if (!folder) {
    fault = folder.error().message;
    return nullptr;
  }
  const std::string path =
      folder.value() + "/" + control::socketName(getpid(), control::Kind::Renderer);
  auto listening = control::listenAt(path);
  if (!listening) {
    fault = listening.error().message;
    return nullptr;
  }
  std::printf("%s\n", path.c_str());
  std::fflush(stdout);
  return control::Server::listening(std::move(listening.value()), path);
}

std::string withSlash(const std::string &folder) {
  return folder.empty() || folder.ends_with('/') ? folder : folder + "/";
}

int renderHere(const RenderArguments &arguments) {
  std::string fault;
  const std::unique_ptr<control::Server> server = openServer(arguments, fault);
  if (!server) {
    complain(fault.empty() ? "no more descriptors" : fault);
    return kExitUsage;
  }
  RenderService service(*server);
  std::thread socket([&] {
    server->run(service);
    service.endService();
  });
  // GL starts while the client receives its greeting.
  Surface surface;
  const char *const step = surface.open(16, 16);
  if (!step)
    RenderLoop(service, withSlash(arguments.folder)).run();
  else
    complain(step);
  server->stop();
  socket.join();
  return step ? kExitNoGl : kExitOk;
}

} // namespace

int render(const RenderArguments &arguments, const std::vector<std::string> &argv) {
  if (const std::string fault = descriptorFault(arguments); !fault.empty()) {
    complain(fault);
    return kExitUsage;
  }
  if (arguments.bare)
    return renderHere(arguments);
  if (arguments.inLayer)
    return isInLayer() ? renderHere(arguments) : int(kExitInternal);
  return executeInLayer(arguments.layer, argv);
}

} // namespace arbiter::tools
