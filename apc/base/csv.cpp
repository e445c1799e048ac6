#include "apc/base/csv.h"

#include <charconv>
#include <cmath>
#include <limits>

#include "apc/base/file.h"
#include "apc/base/require.h"

namespace apc {
namespace {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> result;
  for (std::size_t start = 0;;) {
    const auto comma = line.find(',', start);
    result.push_back(trimmed(line.substr(start, comma == std::string_view::npos ? comma : comma - start)));
    if (comma == std::string_view::npos) return result;
    start = comma + 1;
  }
}

CsvColumn header(std::string_view cell) {
  const auto open = cell.find('[');
  if (open == std::string_view::npos) return {std::string(cell), "", {}};
  const auto close = cell.find(']', open);
  return {
      std::string(trimmed(cell.substr(0, open))), std::string(trimmed(cell.substr(open + 1, close - open - 1))), {}};
}

}  // namespace

const CsvColumn* CsvTable::find(const std::string& name) const {
  for (const auto& column : columns)
    if (column.name == name) return &column;
  return nullptr;
}

std::vector<double> CsvTable::column(const std::string& name, const Dimension& wanted) const {
  const auto* found = find(name);
  if (!found) {
    std::vector<std::string> names;
    for (const auto& each : columns) names.push_back(each.name);
    const auto near = nearest(name, names.data(), names.size());
    throw InputError(concat(file, ": has no column \"", name, "\"",
                            near.empty() ? std::string() : concat(" (found \"", near, "\")"), ". Add a column \"", name,
                            wanted == dimension::none ? std::string("\"") : concat(" [unit]\"")));
  }
  Unit unit;
  try {
    if (!found->unit.empty()) unit = parse_unit(found->unit == "-" ? "rad" : found->unit);
  } catch (const InputError& reason) {
    throw InputError(concat(file, ": column \"", name, "\": ", reason.what()));
  }
  require(unit.dimension == wanted, file, ": column \"", name, "\" is in [", found->unit, "], but ",
          name_of(wanted).name, " is needed");
  std::vector<double> values = found->values;
  for (auto& value : values) value = unit.factor * value + unit.offset;
  return values;
}

CsvTable parse_csv(const std::string& text, const std::string& name) {
  CsvTable table;
  table.file = name;
  std::size_t number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const auto newline = text.find('\n', start);
    const auto line =
        trimmed(std::string_view(text).substr(start, newline == std::string::npos ? newline : newline - start));
    start = newline == std::string::npos ? text.size() : newline + 1;
    ++number;
    if (line.empty()) continue;
    if (line.front() == '#') {
      if (const auto colon = line.find(':'); colon != std::string_view::npos && table.columns.empty())
        table.remarks.emplace(trimmed(line.substr(1, colon - 1)), trimmed(line.substr(colon + 1)));
      continue;
    }
    const auto row = cells(line);
    if (table.columns.empty()) {
      for (const auto cell : row) table.columns.push_back(header(cell));
      double value = 0.0;
      const auto first = row.front();
      require(std::from_chars(first.data(), first.data() + first.size(), value).ec != std::errc(), name, " line ",
              number, ": starts with numbers; a header row such as \"speed [kt],drag [kN]\" is needed first");
      continue;
    }
    require(row.size() == table.columns.size(), name, " line ", number, ": has ", row.size(), " cells, the header has ",
            table.columns.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
      double value = std::numeric_limits<double>::quiet_NaN();
      const auto cell = row[i];
      if (!cell.empty() && cell != "nan" && cell != "NaN") {
        const char* const begin = cell.data() + (cell.front() == '+' ? 1 : 0);
        const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
        require(error == std::errc() && end == cell.data() + cell.size(), name, " line ", number, ", column \"",
                table.columns[i].name, "\": \"", cell, "\" is not a number. Leave the cell empty for no sample");
      }
      table.columns[i].values.push_back(value);
    }
  }
  require(!table.columns.empty(), name, ": is empty. A header row and numbers are needed");
  return table;
}

CsvTable read_csv(const std::filesystem::path& path) { return parse_csv(read_text(path), path.string()); }

std::string csv_text(const std::map<std::string, std::string>& remarks, const std::vector<CsvColumn>& columns,
                     int digits) {
  std::string text;
  for (const auto& [key, value] : remarks) text += "# " + key + ": " + value + "\n";
  for (std::size_t i = 0; i < columns.size(); ++i)
    text += (i ? "," : "") + columns[i].name + (columns[i].unit.empty() ? "" : " [" + columns[i].unit + "]");
  text += "\n";
  const std::size_t rows = columns.empty() ? 0 : columns.front().values.size();
  char number[40];
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      if (i) text += ',';
      const double value = columns[i].values[row];
      if (std::isnan(value)) continue;
      std::snprintf(number, sizeof number, "%.*g", digits, value);
      text += number;
    }
    text += '\n';
  }
  return text;
}

}  // namespace apc
