#include "rovio_sfm/app/web_control.h"

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "rovio_sfm/scene/ids.h"

namespace rovio_sfm {
namespace {

using Json = nlohmann::json;

constexpr size_t kMaxName = 64;
constexpr size_t kMaxQuoted = 80;  // characters of a value in a message

std::invalid_argument Unfit(const std::string& field, const std::string& value,
                            const std::string& expected) {
  return std::invalid_argument(field + " = " + value.substr(0, kMaxQuoted) + ": expected " +
                               expected);
}

std::string TextOf(const Json& value) {
  return value.dump(-1, ' ', true, Json::error_handler_t::replace);
}

// Reads the fields of an object, and refuses what none of them was.
class FieldReader {
 public:
  explicit FieldReader(const std::string& text) : json_(Json::parse(text, nullptr, false)) {
    if (!json_.is_object()) throw std::invalid_argument("body: expected a JSON object");
  }

  std::string Text(const char* name) {
    const Json value = Take(name);
    if (!value.is_string()) throw Unfit(name, TextOf(value), "a text");
    return value.get<std::string>();
  }

  uint32_t Session(const char* name) {
    const Json value = Take(name);
    const bool fits = value.is_number_unsigned() && value.get<uint64_t>() > 0 &&
                      value.get<uint64_t>() <= std::numeric_limits<uint32_t>::max();
    if (!fits) throw Unfit(name, TextOf(value), "the number of a session, from 1");
    return value.get<uint32_t>();
  }

  // False where it is left out.
  bool Flag(const char* name) {
    const Json value = Take(name);
    if (value.is_null()) return false;
    if (!value.is_boolean()) throw Unfit(name, TextOf(value), "true or false");
    return value.get<bool>();
  }

  void RefuseOthers() const {
    if (json_.empty()) return;
    throw std::invalid_argument(TextOf(json_.begin().key()).substr(0, kMaxQuoted) +
                                ": unknown field");
  }

 private:
  Json Take(const char* name) {
    const Json value = json_.value(name, Json());
    json_.erase(name);
    return value;
  }

  Json json_;
};

ControlOrder ReadFinish(FieldReader* fields) {
  FinishSessionOrder order{fields->Text("robot")};
  std::string error;
  if (!IsValidRobotName(order.robot, &error)) {
    throw Unfit("robot", TextOf(order.robot), "a name as rovio1");
  }
  return order;
}

ControlOrder ReadMerge(FieldReader* fields) {
  const uint32_t session_a = fields->Session("session_a"), session_b = fields->Session("session_b");
  return MergeSessionsOrder{session_a, session_b, fields->Flag("force")};
}

ControlOrder ReadUnmerge(FieldReader* fields) {
  return UnmergeSessionOrder{fields->Session("session")};
}

// mapping has the last word on the name.
ControlOrder ReadSave(FieldReader* fields) {
  SaveMapOrder order{fields->Text("name"), fields->Flag("overwrite")};
  if (order.name.empty() || order.name.size() > kMaxName) {
    throw Unfit("name", TextOf(order.name), "1 to 64 characters, as friday.db");
  }
  return order;
}

using ReadOrder = ControlOrder (*)(FieldReader*);

const std::map<std::string, ReadOrder>& Readers() {
  static const std::map<std::string, ReadOrder> readers = {{"finish_session", ReadFinish},
                                                           {"merge_sessions", ReadMerge},
                                                           {"save_map", ReadSave},
                                                           {"unmerge_session", ReadUnmerge}};
  return readers;
}

}  // namespace

std::optional<ControlOrder> ParseOrder(const std::string& service, const std::string& json,
                                       std::string* error) {
  const auto reader = Readers().find(service);
  if (reader == Readers().end()) {
    *error = "expected one of " + OrderNames();
    return std::nullopt;
  }
  try {
    FieldReader fields(json);
    const ControlOrder order = reader->second(&fields);
    fields.RefuseOthers();
    return order;
  } catch (const std::invalid_argument& unfit) {
    *error = unfit.what();
    return std::nullopt;
  }
}

std::string OrderNames() {
  std::string names;
  for (const auto& [name, reader] : Readers()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

bool IsOrder(const std::string& service) { return Readers().count(service) > 0; }

}  // namespace rovio_sfm
