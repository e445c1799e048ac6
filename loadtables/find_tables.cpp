#include "loadtables/find_tables.h"

#include <algorithm>
#include <set>

#include "apc/base/quantity.h"
#include "apc/base/require.h"
#include "loadtables/fit.h"

namespace apc::loadtables {
namespace fs = std::filesystem;

namespace {

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

std::string suggestion(const std::string& word, const std::set<std::string>& names) {
  const std::vector<std::string> list(names.begin(), names.end());
  const auto near = nearest(word, list.data(), list.size());
  return near.empty() ? std::string() : concat(" Did you mean \"", near, "\"?");
}

}  // namespace

std::string table_file_name(const std::string& tire, const std::string& material) {
  return tire + "_" + material + ".h5";
}

std::vector<TableFile> list_tables(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code error;
  if (fs::is_regular_file(folder, error)) {
    paths.push_back(folder);
  } else {
    require(fs::is_directory(folder, error), folder.string(),
            ": no such folder of load tables. Give a folder with .h5 or .csv tables");
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.is_regular_file()) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end(), [](const fs::path& a, const fs::path& b) {
    return std::pair(a.extension() != ".h5", a.filename()) < std::pair(b.extension() != ".h5", b.filename());
  });
  std::vector<TableFile> tables;
  for (const auto& path : paths) {
    if (path.extension() == ".h5") {
      const auto head = table_head(path);
      if (!head.tire.empty()) tables.push_back({path, head.tire, head.material});
    } else if (path.extension() == ".csv") {
      const auto head = loads_csv_head(path);
      if (!head.tire.empty()) tables.push_back({path, head.tire, head.material});
    }
  }
  return tables;
}

LoadTable find_table(const fs::path& folder, const std::string& material, const TableTire& tire) {
  // The file of that name is taken at its word: when it is damaged, that is the message.
  std::error_code error;
  if (const auto named = folder / table_file_name(tire.name, material); fs::is_regular_file(named, error)) {
    auto table = load_table(named);
    require(table.tire().name == tire.name && table.provenance().material == material, named.string(),
            ": says it is for the tire \"", table.tire().name, "\" in \"", table.provenance().material,
            "\". Rename it or make it again");
    return table;
  }
  const auto files = list_tables(folder);
  require(!files.empty(), folder.string(),
          ": holds no load table. Make one with apc loads fit, or give another --loads");
  std::set<std::string> materials, tires;
  for (const auto& file : files) {
    materials.insert(file.material);
    if (file.material != material) continue;
    tires.insert(file.tire);
    if (file.tire != tire.name) continue;
    if (file.path.extension() == ".h5") return load_table(file.path);
    const auto samples = read_loads_csv(file.path);
    Provenance from;
    from.material = samples.material;
    from.source = samples.source;
    from.command = concat("fitted from ", file.path.filename().string());
    from.runs = static_cast<int>(samples.samples.size());
    return fit(samples, tire, from);
  }
  require(materials.contains(material), folder.string(), ": no load tables for the material \"", material, "\".",
          suggestion(material, materials), " There are tables for: ", joined(materials));
  throw InputError(concat(folder.string(), ": no load table for the tire \"", tire.name, "\" in \"", material, "\".",
                          suggestion(tire.name, tires), " There are tables for: ", joined(tires),
                          ". Make one with apc loads plan, run and fit"));
}

}  // namespace apc::loadtables
