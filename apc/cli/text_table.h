/// Rows of text under headings, as a table for a terminal or as a JSON record.
#pragma once

#include <string>
#include <vector>

namespace apc::cli {

struct TextTable {
  std::vector<std::string> headings;
  std::vector<std::vector<std::string>> rows;  ///< each as long as `headings`
};

/// Columns padded to their widest cell; the last one runs free. Cells that look like numbers stand right.
std::string aligned(const TextTable&);

/// {"schema": …, "rows": [{heading: cell, …}, …]}
std::string table_json(const TextTable&, const std::string& schema);

}  // namespace apc::cli
