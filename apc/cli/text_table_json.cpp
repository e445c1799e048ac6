#include <nlohmann/json.hpp>

#include "apc/cli/text_table.h"

namespace apc::cli {

std::string table_json(const TextTable& table, const std::string& schema) {
  nlohmann::ordered_json out{{"schema", schema}, {"rows", nlohmann::ordered_json::array()}};
  for (const auto& row : table.rows) {
    nlohmann::ordered_json entry;
    for (std::size_t i = 0; i < row.size(); ++i) entry[table.headings[i]] = row[i];
    out["rows"].push_back(entry);
  }
  return out.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace apc::cli
