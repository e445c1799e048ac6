/// From a folder of load tables to the one a gear needs: `<tire>_<material>.h5` first, then any table or exchange file
/// (.csv, fitted on the spot) that says it is for this tire and material.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "loadtables/load_table.h"

namespace apc::loadtables {

/// A file that holds, or can become, a table.
struct TableFile {
  std::filesystem::path path;
  std::string tire, material;
};

/// Every table file in `folder` (or `folder` itself when it is a file), sorted by name; native ones first. Files of
/// other kinds are skipped. InputError when there is no such folder or file.
std::vector<TableFile> list_tables(const std::filesystem::path& folder);

/// The table of this tire in this material. `tire` also completes exchange files, which name their tire only.
/// InputError lists the materials (or tires) there are, with the nearest one.
LoadTable find_table(const std::filesystem::path& folder, const std::string& material, const TableTire& tire);

/// Shipped file name of a table: "H29x9.0-15_foam_50psi.h5".
std::string table_file_name(const std::string& tire, const std::string& material);

}  // namespace apc::loadtables
