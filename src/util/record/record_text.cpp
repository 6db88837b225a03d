#include "util/record/record_text.h"

#include <charconv>

namespace arbiter {

namespace {

// These are control characters, which JSON writes as escapes, so that no text contains them.
constexpr char kCounter = '\x01'; ///< then three digits in base 16
constexpr char kObject = '\x02';  ///< its depth as one digit, then members to kEnd
constexpr char kMember = '\x03';  ///< behind a member's name: three digits follow
constexpr char kEnd = '\x04';
constexpr std::size_t kDigits = 3;

std::string digitsOf(unsigned index) {
  static constexpr char kHex[] = "0123456789abcdef";
  return {kHex[index >> 8 & 15], kHex[index >> 4 & 15], kHex[index & 15]};
}

/// Removes the three digits at the front of `text` and returns the counter that they name.
std::uint64_t takeCounter(std::string_view &text, const std::uint64_t *counters, unsigned count) {
  unsigned index = count;
  const std::string_view digits = text.substr(0, kDigits);
  std::from_chars(digits.data(), digits.data() + digits.size(), index, 16);
  text.remove_prefix(digits.size());
  return index < count ? counters[index] : 0;
}

bool writeNumber(const TextSink &sink, std::uint64_t number) {
  char digits[24];
  const auto end = std::to_chars(digits, digits + sizeof digits, number);
  return sink({digits, std::size_t(end.ptr - digits)});
}

bool writeLine(const TextSink &sink, int depth) {
  bool good = sink("\n");
  for (int i = 0; i < depth; ++i)
    good = good && sink("  ");
  return good;
}

/// Writes the members of an object and its end.
bool writeObject(const TextSink &sink, std::string_view &text, const std::uint64_t *counters,
                 unsigned count) {
  const int depth = text.empty() ? 0 : text[0] - '0';
  text.remove_prefix(text.empty() ? 0 : 1);
  bool good = sink("{"), any = false;
  while (!text.empty() && text[0] != kEnd) {
    const std::size_t length = text.find(kMember);
    if (length == std::string_view::npos)
      return false;
    const std::string_view name = text.substr(0, length);
    text.remove_prefix(length + 1);
    const std::uint64_t value = takeCounter(text, counters, count);
    if (value == 0)
      continue;
    good = good && (!any || sink(",")) && writeLine(sink, depth) && sink("\"") && sink(name) &&
           sink("\": ") && writeNumber(sink, value);
    any = true;
  }
  text.remove_prefix(text.empty() ? 0 : 1);
  return good && (!any || writeLine(sink, depth - 1)) && sink("}");
}

} // namespace

std::string counterPlace(unsigned index) { return kCounter + digitsOf(index); }

std::string nonZeroPlace(const std::vector<NamedCounter> &counters, int depth) {
  std::string text = {kObject, char('0' + depth)};
  for (const NamedCounter &counter : counters)
    text += counter.name + (kMember + digitsOf(counter.index));
  return text + kEnd;
}

bool fillIn(const TextSink &sink, std::string_view text, const std::uint64_t *counters,
            unsigned count) {
  while (!text.empty()) {
    const std::size_t plain = std::min(text.find_first_of("\x01\x02"), text.size());
    if (!sink(text.substr(0, plain)))
      return false;
    text.remove_prefix(plain);
    if (text.empty())
      break;
    const char kind = text[0];
    text.remove_prefix(1);
    if (!(kind == kCounter ? writeNumber(sink, takeCounter(text, counters, count))
                           : writeObject(sink, text, counters, count)))
      return false;
  }
  return true;
}

} // namespace arbiter
