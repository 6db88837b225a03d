#include "util/hud/hud_options.h"

#include <array>
#include <charconv>
#include <iterator>

#include "util/suggest.h"

namespace arbiter {

namespace {

constexpr std::string_view kPartNames[kHudParts] = {"version", "host",  "fps",
                                                    "graph",   "draws", "programs"};

struct CornerName {
  std::string_view name;
  bool right, bottom;
};
constexpr CornerName kCorners[] = {{"top-left", false, false},
                                   {"top-right", true, false},
                                   {"bottom-left", false, true},
                                   {"bottom-right", true, true}};

constexpr std::string_view kOtherWords[] = {"hidden", "scale=N", "key=NAME"};

/// Returns a message that `word` is unknown, with the nearest known word.
std::string notKnown(std::string_view word) {
  std::array<std::string_view, std::size(kPartNames) + std::size(kCorners) + std::size(kOtherWords)>
      known;
  std::size_t count = 0;
  for (const std::string_view name : kPartNames)
    known[count++] = name;
  for (const CornerName &corner : kCorners)
    known[count++] = corner.name;
  for (const std::string_view name : kOtherWords)
    known[count++] = name;
  std::string all;
  for (const std::string_view name : known)
    all += (all.empty() ? "" : ", ") + std::string(name);
  std::string text = "expected 0, 1 or words of " + all + ", not \"" + std::string(word) + "\"";
  if (const std::string_view near = nearest(word, known); !near.empty())
    text += " (did you mean " + std::string(near) + "?)";
  return text;
}

bool readNumber(std::string_view text, int low, int high, int &number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() && number >= low &&
         number <= high;
}

bool takePrefix(std::string_view &text, std::string_view prefix) {
  if (!text.starts_with(prefix))
    return false;
  text.remove_prefix(prefix.size());
  return true;
}

/// Reads F1 to F12, optionally behind shift+, ctrl+ and alt+.
bool readKey(std::string_view text, HudKey &key) {
  constexpr std::uint32_t kF1 = 0xFFBE; // XK_F1
  key = {};
  if (text == "none")
    return true;
  for (;;) {
    if (takePrefix(text, "shift+"))
      key.shift = true;
    else if (takePrefix(text, "ctrl+"))
      key.control = true;
    else if (takePrefix(text, "alt+"))
      key.alt = true;
    else
      break;
  }
  int number = 0;
  if (!takePrefix(text, "F") || !readNumber(text, 1, 12, number))
    return false;
  key.keysym = kF1 + std::uint32_t(number - 1);
  return true;
}

/// Reads one word.
/// \return what is wrong with it; empty: nothing
std::string readWord(std::string_view word, HudOptions &options, std::uint8_t &parts) {
  for (unsigned i = 0; i < kHudParts; ++i)
    if (word == kPartNames[i]) {
      parts = std::uint8_t(parts | 1u << i);
      return {};
    }
  for (const CornerName &corner : kCorners)
    if (word == corner.name) {
      options.right = corner.right;
      options.bottom = corner.bottom;
      return {};
    }
  if (word == "hidden") {
    options.hidden = true;
    return {};
  }
  if (takePrefix(word, "scale=")) {
    if (!readNumber(word, 1, 16, options.scale))
      return "expected scale=1 to scale=16, not \"" + std::string(word) + "\"";
    return {};
  }
  if (takePrefix(word, "key=")) {
    if (!readKey(word, options.key))
      return "expected key=F1 to key=F12, with shift+, ctrl+ or alt+ before it, or key=none, not "
             "\"" +
             std::string(word) + "\"";
    return {};
  }
  return notKnown(word);
}

} // namespace

std::optional<HudOptions> parseHudOptions(std::string_view value, std::string &wrong) {
  HudOptions options;
  if (value.empty() || value == "0")
    return options;
  options.on = true;
  if (value == "1")
    return options;
  std::uint8_t parts = 0;
  while (!value.empty()) {
    const std::size_t comma = value.find(',');
    if (wrong = readWord(value.substr(0, comma), options, parts); !wrong.empty())
      return std::nullopt;
    value = comma == std::string_view::npos ? std::string_view() : value.substr(comma + 1);
  }
  if (parts != 0)
    options.parts = parts;
  return options;
}

} // namespace arbiter
