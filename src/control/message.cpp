#include "control/message.h"

#include <cmath>
#include <limits>
#include <utility>

namespace arbiter::control {

namespace {

/// The depth and number of values of a JSON text, found without parsing it into a tree.
struct Extent {
  int depth = 0;
  std::size_t values = 1;
};

Extent extentOf(std::string_view line) {
  Extent extent;
  int depth = 0;
  bool inText = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (inText) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inText = false;
      continue;
    }
    if (c == '"')
      inText = true;
    else if (c == '[' || c == '{')
      extent.depth = std::max(extent.depth, ++depth);
    else if (c == ']' || c == '}')
      --depth;
    if (c == ',' || c == '[' || c == '{')
      ++extent.values;
  }
  return extent;
}

std::string lineOf(const Json &message) {
  std::string line = message.dump(-1, ' ', false, Json::error_handler_t::replace);
  line += '\n';
  return line;
}

Json shell() { return Json::object({{"jsonrpc", "2.0"}}); }

} // namespace

Result<Json, Fault> parseMessage(std::string_view line) {
  if (line.size() >= kMaxLineBytes)
    return Fault{kNoRequest, "a line has at most 4 MiB", {}};
  const Extent extent = extentOf(line);
  if (extent.depth > kMaxDepth)
    return Fault{kNoRequest, "arrays and objects nest at most 32 deep", {}};
  if (extent.values > kMaxValues)
    return Fault{kNoRequest, "a message has at most 65536 values", {}};
  Json message = Json::parse(line.begin(), line.end(), nullptr, false);
  if (message.is_discarded())
    return Fault{kNoJson, "the line is no JSON", {}};
  return message;
}

Result<Request, Fault> toRequest(Json message, Json &id) {
  id = nullptr;
  if (!message.is_object())
    return Fault{kNoRequest,
                 message.is_array() ? "batches are not served: a request a line"
                                    : "a request is an object",
                 {}};
  Request request;
  if (const auto found = message.find("id"); found != message.end()) {
    if (!found->is_string() && !found->is_number() && !found->is_null())
      return Fault{kNoRequest, "\"id\" is a number or a text", {}};
    request.wantsAnswer = true;
    id = request.id = *found;
  }
  const auto version = message.find("jsonrpc");
  if (version == message.end() || *version != "2.0")
    return Fault{kNoRequest, "\"jsonrpc\" is \"2.0\"", {}};
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string())
    return Fault{kNoRequest, "\"method\" is a text", {}};
  request.method = method->get<std::string>();
  request.params = Json::object();
  if (const auto params = message.find("params"); params != message.end()) {
    if (!params->is_object())
      return Fault{kNoRequest, "\"params\" is an object", {}};
    request.params = std::move(*params);
  }
  return request;
}

std::string requestLine(std::uint64_t id, std::string_view method, Json params) {
  Json message = shell();
  message["id"] = id;
  message["method"] = method;
  message["params"] = std::move(params);
  return lineOf(message);
}

std::string eventLine(std::string_view method, Json params) {
  Json message = shell();
  message["method"] = method;
  message["params"] = std::move(params);
  return lineOf(message);
}

std::string answerLine(const Json &id, const Answer &answer) {
  Json message = shell();
  message["id"] = id;
  if (answer) {
    message["result"] = answer.value();
    return lineOf(message);
  }
  Json error = Json::object({{"code", answer.error().code}, {"message", answer.error().message}});
  if (!answer.error().data.is_null())
    error["data"] = answer.error().data;
  message["error"] = std::move(error);
  return lineOf(message);
}

const Json *Params::find(const char *name) const {
  const auto found = m_object.find(name);
  return found == m_object.end() ? nullptr : &*found;
}

const Json *Params::need(const char *name) {
  const Json *const found = find(name);
  if (!found)
    refuse(name, "is missing");
  return found;
}

bool Params::has(const char *name) const { return find(name) != nullptr; }

void Params::refuse(const char *name, const std::string &what) {
  if (ok())
    m_fault = {kWrongParameters, "\"" + std::string(name) + "\" " + what, {}};
}

std::string Params::text(const char *name) {
  const Json *const found = need(name);
  if (!found)
    return {};
  if (found->is_string())
    return found->get<std::string>();
  refuse(name, "is a text");
  return {};
}

std::string Params::text(const char *name, const std::string &fallback) {
  return has(name) ? text(name) : fallback;
}

std::int64_t Params::integer(const char *name, std::int64_t least, std::int64_t most) {
  const Json *const found = need(name);
  if (!found)
    return least;
  // An unsigned number that int64_t cannot hold is out of every range.
  const bool huge =
      found->is_number_unsigned() &&
      found->get<std::uint64_t>() > std::uint64_t(std::numeric_limits<std::int64_t>::max());
  if (found->is_number_integer() && !huge) {
    const auto value = found->get<std::int64_t>();
    if (value >= least && value <= most)
      return value;
  }
  refuse(name, "is an integer from " + std::to_string(least) + " to " + std::to_string(most));
  return least;
}

std::int64_t Params::integer(const char *name, std::int64_t least, std::int64_t most,
                             std::int64_t fallback) {
  return has(name) ? integer(name, least, most) : fallback;
}

double Params::number(const char *name, double fallback) {
  const Json *const found = find(name);
  if (!found)
    return fallback;
  if (found->is_number() && std::isfinite(found->get<double>()))
    return found->get<double>();
  refuse(name, "is a number");
  return fallback;
}

bool Params::truth(const char *name) {
  const Json *const found = need(name);
  if (found && found->is_boolean())
    return found->get<bool>();
  if (found)
    refuse(name, "is true or false");
  return false;
}

void Params::floats(const char *name, float *values, std::size_t count, bool holes) {
  const Json *const found = need(name);
  if (!found)
    return;
  bool good = found->is_array() && found->size() == count;
  for (std::size_t i = 0; good && i < count; ++i) {
    const Json &value = (*found)[i];
    if (holes && value.is_null())
      continue;
    good = value.is_number() &&
           std::fabs(value.get<double>()) <= double(std::numeric_limits<float>::max());
    if (good)
      values[i] = float(value.get<double>());
  }
  if (!good)
    refuse(name, "is an array of " + std::to_string(count) + " numbers");
}

const Json *Params::object(const char *name) {
  const Json *const found = find(name);
  if (found && !found->is_object()) {
    refuse(name, "is an object");
    return nullptr;
  }
  return found;
}

} // namespace arbiter::control
