// Writes textures and frames as PNG.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <optional>

#include "apps/scene/picture.h"
#include "apps/tools/commands.h"
#include "apps/tools/ctl/actions.h"
#include "apps/tools/input.h"
#include "control/base64.h"

namespace arbiter::tools::ctl {

namespace {

using scene::Picture;
using wire::Json;

/// Parses "7", or "0:3D" with a target, into members of a request.
std::optional<Json> parseName(const std::string &word) {
  int name = 0;
  const std::size_t mark = std::min(word.find(':'), word.size());
  const auto [end, error] = std::from_chars(word.data(), word.data() + mark, name);
  if (error != std::errc() || end != word.data() + mark || name < 0)
    return std::nullopt;
  Json params = {{"name", name}};
  if (mark < word.size())
    params["target"] = word.substr(mark + 1);
  return params;
}

int badName(const std::string &word) {
  return fail(
      {kExitUsage, "a texture is a number, or NUMBER:TARGET (arbiter ctl textures), not " + word});
}

int write(const std::string &path, const Picture &picture) {
  const std::string fault = scene::writePng(path, picture);
  return fault.empty() ? int(kExitOk) : fail({kExitUsage, fault});
}

/// Returns the image of an answer; empty if there is none.
Picture pictureOf(const Json &answer) {
  Picture picture;
  const auto image = answer.find("image");
  if (image == answer.end() || !image->is_object())
    return picture;
  wire::Params params(*image);
  picture.width = int(params.integer("width", 1, wire::kMaxFrameSide));
  picture.height = int(params.integer("height", 1, wire::kMaxFrameSide));
  auto bytes = wire::fromBase64(params.text("rgba"));
  if (params.ok() && bytes &&
      bytes->size() == std::size_t(picture.width) * std::size_t(picture.height) * 4)
    picture.bytes = std::move(*bytes);
  return picture;
}

} // namespace

int listTextures(Session &session, const Words &) {
  auto listed = session.connection.ask("texture.list", Json::object());
  return show(session, std::move(listed), [](const Json &answer) {
    std::printf("%10s %4s %-6s %16s  %s\n", "NAME", "UNIT", "TARGET", "SIZE", "FORMAT");
    for (const Json &row : objectsAt(answer, "textures")) {
      wire::Params params(row);
      const std::string size = std::to_string(params.integer("width", 0, INT32_MAX)) + "x" +
                               std::to_string(params.integer("height", 0, INT32_MAX)) + "x" +
                               std::to_string(params.integer("depth", 0, INT32_MAX));
      std::printf("%10lld %4lld %-6s %16s  %s%s\n",
                  static_cast<long long>(params.integer("name", 0, INT32_MAX)),
                  static_cast<long long>(params.integer("unit", 0, INT32_MAX)),
                  params.text("target").c_str(), size.c_str(), params.text("format").c_str(),
                  params.truth("changed") ? "  changed" : "");
    }
  });
}

int getTexture(Session &session, const Words &words) {
  std::optional<Json> params = parseName(words[0]);
  if (!params)
    return badName(words[0]);
  (*params)["size"] = 512;
  const std::string path = words.size() > 1 ? words[1] : session.output;
  if (path.empty())
    return fail({kExitUsage, "say where the picture goes: -o FILE.png"});
  const auto answer = session.connection.ask("texture.get", *params);
  if (!answer)
    return fail(answer.error());
  const Picture picture = pictureOf(answer.value());
  if (picture.bytes.empty())
    return fail({kExitInternal, "the answer holds no picture"});
  return write(path, picture);
}

int setTexture(Session &session, const Words &words) {
  std::optional<Json> params = parseName(words[0]);
  if (!params)
    return badName(words[0]);
  const auto picture = scene::readPng(words[1]);
  if (!picture)
    return fail({kExitUsage, picture.error().message});
  const Picture &value = picture.value();
  (*params)["image"] = {
      {"width", value.width}, {"height", value.height}, {"rgba", wire::toBase64(value.bytes)}};
  const auto answer = session.connection.ask("texture.set", *params);
  if (!answer)
    return fail(answer.error());
  session.changed = true;
  return kExitOk;
}

int takeFrame(Session &session, const Words &) {
  if (session.output.empty())
    return fail({kExitUsage, "say where the picture goes: -o FILE.png"});
  const auto frame = session.connection.frame();
  if (!frame)
    return fail(frame.error());
  const wire::Frame &shown = frame.value();
  Picture picture{shown.width, shown.height, {}};
  const std::size_t row = std::size_t(shown.width) * 4;
  picture.bytes.resize(row * std::size_t(shown.height));
  for (std::size_t y = 0; y < std::size_t(shown.height); ++y)
    std::memcpy(picture.bytes.data() + y * row, shown.pixels + y * shown.stride, row);
  session.connection.client().release(shown);
  // A window's alpha is never visible, and may have any value.
  for (std::size_t i = 3; i < picture.bytes.size(); i += 4)
    picture.bytes[i] = 255;
  return write(session.output, picture);
}

} // namespace arbiter::tools::ctl
