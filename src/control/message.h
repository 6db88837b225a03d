#pragma once
#include <GL/arbiter.h>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "util/result.h"

/// The control protocol's JSON-RPC 2.0: one message a line (docs/write/control.md).
namespace arbiter::control {

using Json = nlohmann::json;

inline constexpr int kProtocol = ARBITER_CONTROL_PROTOCOL;
/// The limit of a line, including its end.
inline constexpr std::size_t kMaxLineBytes = std::size_t(4) << 20;
inline constexpr int kMaxDepth = 32;
/// The limit of values in a message, which bounds the memory of their tree.
inline constexpr std::size_t kMaxValues = 65536;

enum ErrorCode : int {
  kNoJson = -32700,
  kNoRequest = -32600,
  kNoMethod = -32601,
  kWrongParameters = -32602,
  kUnknownName = -32001,
  kOtherWriter = -32002,
  kOldRevision = -32003,
  kNotPossible = -32004,
  kTooBusy = -32005,
};

/// A JSON-RPC error.
struct Fault {
  int code = 0;
  std::string message;
  Json data; ///< null: none
};

/// The answer to a request.
using Answer = Result<Json, Fault>;

/// Parses the text of a line, without its end, as JSON. Fails if it is not JSON or exceeds a limit.
[[nodiscard]] Result<Json, Fault> parseMessage(std::string_view line);

struct Request {
  Json id; ///< number, text or null
  bool wantsAnswer = false;
  std::string method;
  Json params; ///< an object
};
/// Converts a message to a request. Fails if it is none; `id` is then set to the message's id, if
/// any, for the answer.
[[nodiscard]] Result<Request, Fault> toRequest(Json message, Json &id);

// These functions return whole lines, ended by \n. Bytes that are not UTF-8 become U+FFFD.
[[nodiscard]] std::string requestLine(std::uint64_t id, std::string_view method, Json params);
[[nodiscard]] std::string eventLine(std::string_view method, Json params);
[[nodiscard]] std::string answerLine(const Json &id, const Answer &answer);

/// Reads members of a request's parameters, and keeps the first error.
class Params {
public:
  explicit Params(const Json &object) : m_object(object) {}

  [[nodiscard]] bool has(const char *name) const;
  [[nodiscard]] std::string text(const char *name);
  [[nodiscard]] std::string text(const char *name, const std::string &fallback);
  [[nodiscard]] std::int64_t integer(const char *name, std::int64_t least, std::int64_t most);
  [[nodiscard]] std::int64_t integer(const char *name, std::int64_t least, std::int64_t most,
                                     std::int64_t fallback);
  [[nodiscard]] double number(const char *name, double fallback);
  [[nodiscard]] bool truth(const char *name);
  /// Reads `count` numbers that a float can hold. If `holes` is true, null keeps the present
  /// element of `values`.
  void floats(const char *name, float *values, std::size_t count, bool holes = false);
  /// Returns the member unchecked; null if there is none.
  [[nodiscard]] const Json *object(const char *name);

  /// Records an error about a member, in the caller's words.
  void refuse(const char *name, const std::string &what);
  [[nodiscard]] bool ok() const { return m_fault.code == 0; }
  /// Requires !ok().
  [[nodiscard]] const Fault &fault() const { return m_fault; }

private:
  const Json *find(const char *name) const;
  const Json *need(const char *name);
  const Json &m_object;
  Fault m_fault;
};

} // namespace arbiter::control
