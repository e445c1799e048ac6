/// CSV as the project exchanges it: `# key: value` lines, one header row `name [unit]`, then numbers; an empty cell or
/// `nan` is "no sample" (NaN). Columns come in any order and unit; unknown columns are kept.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "apc/base/quantity.h"

namespace apc {

struct CsvColumn {
  std::string name;            ///< without the unit: "speed"
  std::string unit;            ///< as written: "kt"; empty when the header gives none
  std::vector<double> values;  ///< in the unit of the file
};

struct CsvTable {
  std::string file;
  std::map<std::string, std::string> remarks;  ///< the `# key: value` lines
  std::vector<CsvColumn> columns;
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
  const CsvColumn* find(const std::string& name) const;
  /// The named column in SI. InputError when it is missing or its unit has another dimension.
  std::vector<double> column(const std::string& name, const Dimension&) const;
};

/// Throws InputError with file and line: no header, a row of another length, a cell that is no number.
CsvTable read_csv(const std::filesystem::path&);
CsvTable parse_csv(const std::string& text, const std::string& name);

/// Text of a CSV file; `digits` significant digits, NaN as an empty cell.
std::string csv_text(const std::map<std::string, std::string>& remarks, const std::vector<CsvColumn>& columns,
                     int digits = 7);

}  // namespace apc
