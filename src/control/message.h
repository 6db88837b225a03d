#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "util/result.h"

/// JSON-RPC 2.0 as control speaks it: a message a line (docs/write/control.md).
namespace arbiter::control {

using Json = nlohmann::json;

inline constexpr int kProtocol = 1;
/// Of a line, its end included.
inline constexpr std::size_t kMaxLineBytes = std::size_t(4) << 20;
inline constexpr int kMaxDepth = 32;
/// Values of one message: what a tree of them takes in memory is bounded by it.
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

/// What a request is answered with.
using Answer = Result<Json, Fault>;

/// The text of a line, its end not included, as JSON. Errors: no JSON, or over one of the limits.
[[nodiscard]] Result<Json, Fault> parseMessage(std::string_view line);

struct Request {
  Json id; ///< number, text or null
  bool wantsAnswer = false;
  std::string method;
  Json params; ///< an object
};
/// Errors: no request. `id` is then what it has of one, for the answer.
[[nodiscard]] Result<Request, Fault> toRequest(Json message, Json &id);

// Whole lines, ended by \n. Text that is not UTF-8 has U+FFFD in its place.
[[nodiscard]] std::string requestLine(std::uint64_t id, std::string_view method, Json params);
[[nodiscard]] std::string eventLine(std::string_view method, Json params);
[[nodiscard]] std::string answerLine(const Json &id, const Answer &answer);

/// Reads members of a request's parameters, and keeps the first thing that is wrong with one.
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
  /// `count` numbers that a float can hold; null stays what `values` has where `holes` is true.
  void floats(const char *name, float *values, std::size_t count, bool holes = false);
  /// The member as it is; null where there is none.
  [[nodiscard]] const Json *object(const char *name);

  /// Says that a member is wrong, in words of the caller's.
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
