#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace arbiter {

/// True if the bytes are well-formed UTF-8 (Unicode table 3-7).
[[nodiscard]] bool isUtf8(std::string_view text);

/// Writes JSON (RFC 8259), one call for each token, indented by two spaces. It streams because it
/// also runs in the library that enters applications: it needs no tree, no heavy header, and throws
/// no exception for bytes that are not UTF-8 (each becomes U+FFFD). Keys keep the order of the
/// calls.
///
///   JsonWriter json;
///   json.beginObject().key("schema").value(1).key("programs").beginArray();
///   json.endArray().endObject();
class JsonWriter {
public:
  JsonWriter &beginObject() { return open('{'); }
  JsonWriter &endObject() { return close('}'); }
  JsonWriter &beginArray() { return open('['); }
  JsonWriter &endArray() { return close(']'); }

  /// Requires an open object and no key that waits for its value.
  JsonWriter &key(std::string_view name);

  JsonWriter &value(std::string_view text);
  JsonWriter &value(const char *text) { return value(std::string_view(text)); }
  JsonWriter &value(const std::string &text) { return value(std::string_view(text)); }
  JsonWriter &value(bool truth);
  JsonWriter &value(double number); ///< NaN and infinities become null
  JsonWriter &value(int number) { return value(std::int64_t(number)); }
  JsonWriter &value(unsigned number) { return value(std::uint64_t(number)); }
  JsonWriter &value(std::int64_t number);
  JsonWriter &value(std::uint64_t number);
  JsonWriter &null();
  /// Writes a value that is JSON already, or becomes JSON later (record_text.h).
  JsonWriter &raw(std::string_view json);

  /// Returns the whole text, ended by a newline. Requires every object and array closed.
  [[nodiscard]] std::string take();

private:
  JsonWriter &open(char bracket);
  JsonWriter &close(char bracket);
  void separate();
  void appendString(std::string_view text);

  std::string m_text;
  std::vector<bool> m_hasItems; ///< one for each open object or array
  bool m_afterKey = false;
};

} // namespace arbiter
