/// Reading the project's JSON files: every value is asked for by name and dimension, every mistake names the file, the
/// JSON path, the value and the remedy, and a key nobody asked for is an error.
///
///     const auto file = read_json("beds/jfk.json");
///     file.schema("apc-bed/1");
///     const double setback = file.quantity("setback", dimension::length);
///     const Json profile = file.object("profile");
///     file.finish();                                   // unknown keys of this object are refused here
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apc/base/quantity.h"

namespace apc {

/// One object of a JSON file, with its place. Copies share the record of which keys were asked for.
class Json {
 public:
  Json(std::shared_ptr<const nlohmann::ordered_json> value, std::string file, std::string path);
  ~Json();
  Json(const Json&);
  Json& operator=(const Json&);

  bool has(const std::string& key) const;  ///< does not count as asking
  std::vector<std::string> keys() const;

  /// SI value of `"70 kt"`. A bare number is accepted only where the dimension is none.
  double quantity(const std::string& key, const Dimension&) const;
  double quantity(const std::string& key, const Dimension&, double otherwise) const;
  /// `{"unit": "in", "values": [0, 18, 18]}` or an array of quantity strings, in SI.
  std::vector<double> quantities(const std::string& key, const Dimension&) const;
  double number(const std::string& key) const;
  double number(const std::string& key, double otherwise) const;
  std::vector<double> numbers(const std::string& key) const;
  int integer(const std::string& key) const;
  int integer(const std::string& key, int otherwise) const;
  bool flag(const std::string& key, bool otherwise) const;
  std::string text(const std::string& key) const;
  std::string text(const std::string& key, const std::string& otherwise) const;
  std::vector<std::string> texts(const std::string& key) const;
  Json object(const std::string& key) const;
  std::vector<Json> objects(const std::string& key) const;

  /// Marks a key as known without reading it (free-form content kept as it is).
  void ignore(const std::string& key) const;
  /// `schema` must be exactly `expected`.
  void schema(const std::string& expected) const;
  /// Refuses keys that nobody asked for, here and in the objects read from here.
  void finish() const;

  /// InputError "file path: value" + what is wrong, for checks of meaning (`file.refuse("depth", "is negative. …")`).
  [[noreturn]] void refuse(const std::string& key, const std::string& why) const;
  void check(bool ok, const std::string& key, const std::string& why) const {
    if (!ok) refuse(key, why);
  }

  const std::string& file() const { return file_; }
  const std::string& path() const { return path_; }
  const nlohmann::ordered_json& raw() const { return *value_; }

 private:
  struct Asked;
  const nlohmann::ordered_json& at(const std::string& key) const;
  std::string place(const std::string& key) const;

  std::shared_ptr<const nlohmann::ordered_json> value_;
  std::string file_, path_;
  std::shared_ptr<Asked> asked_;
};

/// Reads and parses; the top level must be an object. Errors carry line and column.
Json read_json(const std::filesystem::path&);
/// Same from a text already in memory; `name` stands for the file in messages.
Json parse_json(const std::string& text, const std::string& name);

}  // namespace apc
