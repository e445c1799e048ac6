#include "apc/cli/text_table.h"

#include <algorithm>
#include <cctype>

#include "apc/base/require.h"

namespace apc::cli {
namespace {

/// Characters, not bytes: UTF-8 continuation bytes take no room.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

bool is_numeric(const std::string& cell) {
  return cell == "-" || (!cell.empty() && (std::isdigit(static_cast<unsigned char>(cell.front())) ||
                                           (cell.front() == '-' && cell.size() > 1)));
}

}  // namespace

std::string aligned(const TextTable& table) {
  const std::size_t columns = table.headings.size();
  std::vector<std::size_t> widths(columns);
  std::vector<char> numeric(columns, table.rows.empty() ? 0 : 1);
  for (std::size_t i = 0; i < columns; ++i) widths[i] = width(table.headings[i]);
  for (const auto& row : table.rows) {
    expect(row.size() == columns, "a table row has another length than the headings");
    for (std::size_t i = 0; i < columns; ++i) {
      widths[i] = std::max(widths[i], width(row[i]));
      if (i == 0 || !is_numeric(row[i])) numeric[i] = 0;
    }
  }
  std::string out;
  const auto add = [&](const std::vector<std::string>& row) {
    std::string line;
    for (std::size_t i = 0; i < columns; ++i) {
      const std::string padding(widths[i] - width(row[i]), ' ');
      line += (i ? "  " : "") + (numeric[i] ? padding + row[i] : row[i] + padding);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + "\n";
  };
  add(table.headings);
  for (const auto& row : table.rows) add(row);
  return out;
}

}  // namespace apc::cli
