// Inspects a pixel of the frame: the draws that write it, and the computation of a program there.
// Also measures pixels and time of each draw.
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <tuple>

#include "apps/tools/commands.h"
#include "apps/tools/ctl/actions.h"
#include "apps/tools/ctl/held_drawer.h"
#include "apps/tools/debug/pair.h"
#include "apps/tools/debug/session.h"
#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/language.h"
#include "control/base64.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::ctl {

namespace {

using wire::Json;

struct Pixel {
  int x = 0, y = 0;
  std::uint32_t framebuffer = 0; ///< the application's number; 0: the window
};

/// Parses X,Y or X,Y@FRAMEBUFFER.
std::optional<Pixel> pixelOf(std::string_view word) {
  Pixel pixel;
  const std::size_t mark = word.find('@');
  if (mark != std::string_view::npos) {
    const std::string_view name = word.substr(mark + 1);
    const auto end = std::from_chars(name.data(), name.data() + name.size(), pixel.framebuffer);
    if (end.ec != std::errc() || end.ptr != name.data() + name.size())
      return {};
  }
  const auto pair = debug::parsePair<int>(word.substr(0, mark));
  if (!pair || pair->first < 0 || pair->second < 0)
    return {};
  std::tie(pixel.x, pixel.y) = *pair;
  return pixel;
}

Failure noPixel(const std::string &word) {
  return {kExitUsage, "a pixel is X,Y, counted from the lower left, or X,Y@FRAMEBUFFER of one of "
                      "the application's framebuffer objects, not " +
                          word};
}

/// One draw of an answer to pixel.pick.
struct PickedDraw {
  std::int64_t number = 0;
  std::string command, fragment, vertex;
  std::array<float, 4> color = {};
};

std::vector<PickedDraw> drawsOf(const Json &answer) {
  std::vector<PickedDraw> draws;
  for (const Json &row : objectsAt(answer, "draws")) {
    wire::Params params(row);
    PickedDraw draw;
    draw.number = params.integer("draw", 1, INT32_MAX);
    draw.command = textAt(row, "command");
    draw.fragment = textAt(row, "fragment");
    draw.vertex = textAt(row, "vertex");
    draw.color.fill(NAN); // stays NaN where JSON has null
    params.floats("color", draw.color.data(), 4, true);
    if (params.ok())
      draws.push_back(std::move(draw));
  }
  return draws;
}

/// Returns a note about other framebuffers in the frame, and about draws that could not be
/// inspected.
std::string elsewhere(const Json &answer) {
  std::string text;
  for (const Json &row : objectsAt(answer, "framebuffers"))
    if (row.contains("framebuffer") && row["framebuffer"].is_number_unsigned())
      text += (text.empty() ? "" : ", ") + row["framebuffer"].dump();
  if (!text.empty())
    text = "; it draws to framebuffers " + text + " (X,Y@NAME; 0 is the window)";
  const auto lists = answer.find("lists");
  if (lists != answer.end() && lists->is_number_integer() && *lists != 0)
    text += "; what " + lists->dump() + " calls of display lists draw is not known";
  return text;
}

std::string programText(const std::string &id) { return id.empty() ? "fixed function" : id; }

/// Returns the requested draw, or the last one that writes the pixel.
Result<PickedDraw, Failure> choose(const Json &answer, const std::string &wanted) {
  const std::vector<PickedDraw> draws = drawsOf(answer);
  std::string others;
  for (const PickedDraw &draw : draws) {
    if (wanted == std::to_string(draw.number) ||
        (wanted.empty() && &draw == &draws.back() && !draw.fragment.empty()))
      return draw;
    if (!draw.fragment.empty())
      others += (others.empty() ? "" : ", ") + std::to_string(draw.number);
  }
  if (draws.empty()) {
    const std::string trouble = textAt(answer, "trouble");
    return Failure{kExitUsage, "no draw of the frame writes this pixel that can be looked at" +
                                   (trouble.empty() ? std::string() : " (" + trouble + ")") +
                                   elsewhere(answer)};
  }
  const std::string hint =
      others.empty() ? std::string() : "; draws with programs that write it: " + others;
  if (!wanted.empty())
    return Failure{kExitUsage, "draw " + wanted + " does not write this pixel" + hint};
  return Failure{kExitUsage, "draw " + std::to_string(draws.back().number) + " (" +
                                 draws.back().command +
                                 ") gives the pixel its colour, by fixed function" + hint};
}

/// Compiles the text of a held draw without a card's limits.
Result<fp::ir::Program, Failure> programOf(const Json &held, std::string &text) {
  text = textAt(held, "text");
  if (const auto bytes = wire::fromBase64(textAt(held, "text_base64")); bytes && !bytes->empty())
    text.assign(bytes->begin(), bytes->end());
  const auto profile = fp::hw::loadProfile("host");
  if (!profile)
    return Failure{kExitUsage, profile.error().message};
  const fp::ir::Language language = chooseLanguage("auto", text);
  fp::CheckResult result = fp::checkProgram(
      language, text, {limitsOf(profile.value(), language), fp::LimitPolicy::Report});
  if (!result.ok())
    return Failure{kExitInvalid, fp::renderAll("program", text, result.diagnostics)};
  return std::move(*result.program);
}

fp::Numerics numericsOf(const Json &held) {
  return fp::numericsNamed(textAt(held, "numerics")).value_or(fp::Numerics::Host);
}

std::array<std::uint8_t, 4> bytesOf(const std::array<float, 4> &color) {
  std::array<std::uint8_t, 4> bytes = {};
  for (std::size_t c = 0; c < 4; ++c)
    bytes[c] = debug::byteOf(color[c]);
  return bytes;
}

Result<Json, Failure> pick(Session &session, const std::string &word) {
  const auto pixel = pixelOf(word);
  if (!pixel)
    return noPixel(word);
  return session.connection.ask(
      "pixel.pick", {{"x", pixel->x}, {"y", pixel->y}, {"framebuffer", pixel->framebuffer}});
}

} // namespace

int pickDraws(Session &session, const Words &words) {
  return show(session, pick(session, words[0]), [](const Json &answer) {
    std::printf("%6s  %-22s %-10s %s\n", "DRAW", "COMMAND", "COLOUR", "PROGRAM");
    for (const PickedDraw &draw : drawsOf(answer))
      std::printf("%6lld  %-22s %-10s %s\n", static_cast<long long>(draw.number),
                  draw.command.c_str(), debug::hexColor(bytesOf(draw.color)).c_str(),
                  programText(draw.fragment).c_str());
  });
}

int tracePixel(Session &session, const Words &words) {
  const auto picked = pick(session, words[0]);
  if (!picked)
    return fail(picked.error());
  const auto draw = choose(picked.value(), words.size() > 1 ? words[1] : std::string());
  if (!draw)
    return fail(draw.error());
  const Pixel pixel = *pixelOf(words[0]);
  const auto held = session.connection.ask("pixel.hold", {{"x", pixel.x},
                                                          {"y", pixel.y},
                                                          {"framebuffer", pixel.framebuffer},
                                                          {"draw", draw.value().number},
                                                          {"fragment", draw.value().fragment}});
  if (!held)
    return fail(held.error());
  std::string text;
  const auto program = programOf(held.value(), text);
  HeldDrawer drawer(session.connection, held.value(), bytesOf(draw.value().color));
  if (!program)
    return fail(program.error());
  auto found =
      debug::findingsOf(drawer, program.value(), text, pixel.x, pixel.y, numericsOf(held.value()));
  if (!found)
    return fail({kExitUsage, words[0] + ": " + found.error().message});
  debug::Findings &findings = found.value();
  findings.document = draw.value().fragment;
  if (session.json) {
    debug::Json json = debug::findingsJson(findings);
    json["draw"] = draw.value().number;
    json["vertex"] = draw.value().vertex.empty() ? Json() : Json(draw.value().vertex);
    json["text"] = text;
    json["draws"] = picked.value()["draws"];
    printJson(json);
  } else {
    std::fputs(debug::findingsText(findings).c_str(), stdout);
  }
  return debug::exitCodeOf(findings);
}

int measureFrame(Session &session, const Words &) {
  auto measured = session.connection.ask("frame.measure", Json::object());
  return show(session, std::move(measured), [](const Json &answer) {
    std::printf("%6s %12s %10s  %s\n", "DRAWS", "PIXELS", "MS", "PROGRAM");
    const auto programs = answer.find("programs");
    if (programs == answer.end() || !programs->is_object())
      return;
    for (const auto &[id, row] : programs->items()) {
      if (!row.is_object())
        continue;
      wire::Params params(row);
      const auto pixels = row.find("pixels");
      const bool counted = pixels != row.end() && pixels->is_number_integer();
      std::printf("%6lld %12s %10.3f  %s\n",
                  static_cast<long long>(params.integer("draws", 0, INT32_MAX)),
                  counted ? std::to_string(pixels->get<std::int64_t>()).c_str() : "not counted",
                  params.number("milliseconds", 0), id.c_str());
    }
  });
}

} // namespace arbiter::tools::ctl
