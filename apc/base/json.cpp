#include "apc/base/json.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc {
namespace {

using Value = nlohmann::ordered_json;

std::string shown(const Value& value) {
  auto text = value.dump();
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return text;
}

}  // namespace

struct Json::Asked {
  std::set<std::string> keys;
  std::vector<Json> children;
};

Json::Json(std::shared_ptr<const Value> value, std::string file, std::string path)
    : value_(std::move(value)), file_(std::move(file)), path_(std::move(path)), asked_(std::make_shared<Asked>()) {}
Json::~Json() = default;
Json::Json(const Json&) = default;
Json& Json::operator=(const Json&) = default;

std::string Json::place(const std::string& key) const { return file_ + " " + path_ + "/" + key; }

void Json::refuse(const std::string& key, const std::string& why) const {
  const auto value = has(key) ? shown((*value_)[key]) : std::string("(missing)");
  throw InputError(place(key) + ": " + value + " " + why);
}

bool Json::has(const std::string& key) const { return value_->contains(key); }

std::vector<std::string> Json::keys() const {
  std::vector<std::string> names;
  for (const auto& item : value_->items()) names.push_back(item.key());
  return names;
}

const Value& Json::at(const std::string& key) const {
  asked_->keys.insert(key);
  if (value_->contains(key)) return (*value_)[key];
  const auto present = keys();
  const auto near = nearest(key, present.data(), present.size());
  throw InputError(concat(place(key), ": is missing", near.empty() ? std::string() : concat(" (found \"", near, "\")"),
                          ". Add \"", key, "\""));
}

double Json::quantity(const std::string& key, const Dimension& wanted) const {
  const auto& value = at(key);
  const auto expected = name_of(wanted);
  if (value.is_number()) {
    if (wanted == dimension::none) return number(key);
    throw InputError(concat(place(key), ": ", shown(value), " has no unit (", expected.name, " is needed). Write \"",
                            shown(value), " ", expected.example.substr(expected.example.find(' ') + 1), "\""));
  }
  require(value.is_string(), place(key), ": ", shown(value), " is not a quantity (", expected.name,
          " is needed). Write for example \"", expected.example, "\"");
  try {
    return parse_quantity(value.get<std::string>(), wanted);
  } catch (const InputError& reason) {
    throw InputError(place(key) + ": " + reason.what());
  }
}

double Json::quantity(const std::string& key, const Dimension& wanted, double otherwise) const {
  asked_->keys.insert(key);
  return has(key) ? quantity(key, wanted) : otherwise;
}

std::vector<double> Json::quantities(const std::string& key, const Dimension& wanted) const {
  const auto& value = at(key);
  std::vector<double> result;
  if (value.is_array()) {
    std::size_t index = 0;
    for (const auto& each : value) {
      const auto where = concat(place(key), "/", index++);
      require(each.is_string(), where, ": ", shown(each), " has no unit (", name_of(wanted).name,
              " is needed). Write {\"unit\": \"...\", \"values\": [...]} or quantity strings");
      try {
        result.push_back(parse_quantity(each.get<std::string>(), wanted));
      } catch (const InputError& reason) {
        throw InputError(where + ": " + reason.what());
      }
    }
    return result;
  }
  require(value.is_object(), place(key), ": ", shown(value),
          " is not a list of quantities. Write {\"unit\": \"in\", \"values\": [...]}");
  const auto list = object(key);
  const auto unit_text = list.text("unit");
  Unit unit;
  try {
    unit = parse_unit(unit_text);
  } catch (const InputError& reason) {
    throw InputError(list.place("unit") + ": " + reason.what());
  }
  list.check(unit.dimension == wanted, "unit",
             concat("is the unit of ", name_of(unit.dimension).name, ", but ", name_of(wanted).name, " is needed"));
  for (const double each : list.numbers("values")) result.push_back(unit.factor * each + unit.offset);
  return result;
}

double Json::number(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_number(), place(key), ": ", shown(value), " is not a number. Write a bare number such as 0.25");
  const double result = value.get<double>();
  require(std::isfinite(result), place(key), ": is not a finite number");
  return result;
}

double Json::number(const std::string& key, double otherwise) const {
  asked_->keys.insert(key);
  return has(key) ? number(key) : otherwise;
}

std::vector<double> Json::numbers(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_array(), place(key), ": ", shown(value), " is not a list of numbers. Write [0, 18, 18]");
  std::vector<double> result;
  for (const auto& each : value) {
    require(each.is_number() && std::isfinite(each.get<double>()), place(key), "/", result.size(), ": ", shown(each),
            " is not a finite number");
    result.push_back(each.get<double>());
  }
  return result;
}

int Json::integer(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_number_integer(), place(key), ": ", shown(value), " is not a whole number");
  return value.get<int>();
}

int Json::integer(const std::string& key, int otherwise) const {
  asked_->keys.insert(key);
  return has(key) ? integer(key) : otherwise;
}

bool Json::flag(const std::string& key, bool otherwise) const {
  asked_->keys.insert(key);
  if (!has(key)) return otherwise;
  const auto& value = at(key);
  require(value.is_boolean(), place(key), ": ", shown(value), " is neither true nor false");
  return value.get<bool>();
}

std::string Json::text(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_string(), place(key), ": ", shown(value), " is not a text. Write it in double quotes");
  const auto result = value.get<std::string>();
  require(!result.empty(), place(key), ": is empty");
  return result;
}

std::string Json::text(const std::string& key, const std::string& otherwise) const {
  asked_->keys.insert(key);
  return has(key) ? text(key) : otherwise;
}

std::vector<std::string> Json::texts(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_array(), place(key), ": ", shown(value), " is not a list of texts");
  std::vector<std::string> result;
  for (const auto& each : value) {
    require(each.is_string(), place(key), "/", result.size(), ": ", shown(each), " is not a text");
    result.push_back(each.get<std::string>());
  }
  return result;
}

Json Json::object(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_object(), place(key), ": ", shown(value), " is not an object. Write { ... }");
  Json child(std::shared_ptr<const Value>(value_, &value), file_, path_ + "/" + key);
  asked_->children.push_back(child);
  return child;
}

std::vector<Json> Json::objects(const std::string& key) const {
  const auto& value = at(key);
  require(value.is_array(), place(key), ": ", shown(value), " is not a list. Write [ {...}, {...} ]");
  std::vector<Json> result;
  for (const auto& each : value) {
    const auto where = concat(path_, "/", key, "/", result.size());
    require(each.is_object(), file_, " ", where, ": ", shown(each), " is not an object. Write { ... }");
    result.emplace_back(std::shared_ptr<const Value>(value_, &each), file_, where);
    asked_->children.push_back(result.back());
  }
  return result;
}

void Json::ignore(const std::string& key) const { asked_->keys.insert(key); }

void Json::schema(const std::string& expected) const {
  const auto found = text("schema");
  require(found == expected, place("schema"), ": \"", found, "\" is not what is needed here (\"", expected, "\")");
}

void Json::finish() const {
  for (const auto& item : value_->items()) {
    if (asked_->keys.contains(item.key())) continue;
    const std::vector<std::string> known(asked_->keys.begin(), asked_->keys.end());
    const auto near = nearest(item.key(), known.data(), known.size());
    throw InputError(concat(place(item.key()), ": ", shown(item.value()), " is an unknown key",
                            near.empty() ? std::string(". Remove it") : concat(". Did you mean \"", near, "\"?")));
  }
  for (const auto& child : asked_->children) child.finish();
}

Json parse_json(const std::string& text, const std::string& name) {
  require(text.find_first_not_of(" \t\r\n") != std::string::npos, name, ": is empty. A JSON object is needed");
  std::shared_ptr<const Value> value;
  try {
    value = std::make_shared<const Value>(Value::parse(text));
  } catch (const nlohmann::json::exception& error) {
    std::string what = error.what();
    if (const auto bracket = what.find("] "); bracket != std::string::npos) what = what.substr(bracket + 2);
    throw InputError(name + ": is not JSON: " + what);
  }
  require(value->is_object(), name, ": is JSON but not an object. Write { ... }");
  return {value, name, ""};
}

Json read_json(const std::filesystem::path& path) { return parse_json(read_text(path), path.string()); }

}  // namespace apc
