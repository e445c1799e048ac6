/// The parts of `apc loads`: the campaign (plan, run, status) and the tables (fit, show, import, export, check).
#pragma once

#include <filesystem>
#include <string>

#include "apc/cli/commands.h"
#include "loadtables/campaign.h"
#include "loadtables/check_table.h"
#include "loadtables/load_table.h"

namespace apc::aircraft {
struct Tire;
}

namespace apc::cli {

void add_loads_plan(CLI::App& loads, Settings&);
void add_loads_run(CLI::App& loads, Settings&);
void add_loads_status(CLI::App& loads, Settings&);
void add_loads_fit(CLI::App& loads, Settings&);
void add_loads_show(CLI::App& loads, Settings&);
void add_loads_import(CLI::App& loads, Settings&);
void add_loads_export(CLI::App& loads, Settings&);
void add_loads_check(CLI::App& loads, Settings&);

/// A tire of the shipped library, or of `library` when it is given. InputError with the nearest name.
aircraft::Tire find_tire(const std::string& name, const std::filesystem::path& library);

/// Today's date, UTC, "2024-05-31".
std::string today();

/// Reports on stdout.
std::string table_report(const loadtables::LoadTable&, const loadtables::TableCheck&);
std::string table_slices(const loadtables::LoadTable&, double speed, report::UnitSystem);
std::string status_report(const std::vector<loadtables::RunStatus>&, const std::filesystem::path& folder);

/// Records for --json.
std::string table_record(const loadtables::LoadTable&, const loadtables::TableCheck&);
std::string status_record(const std::vector<loadtables::RunStatus>&);

}  // namespace apc::cli
