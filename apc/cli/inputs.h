/// From names and paths on the command line to a checked model, with a note of every file that was read.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "apc/report/record.h"

namespace apc::cli {

/// What the user named; empty = the shipped data.
struct Choice {
  std::string aircraft, bed;
  std::filesystem::path loads;  ///< a folder of load tables (.h5), or of samples (.csv) to be fitted
  std::filesystem::path tires;  ///< a tire library; empty = the shipped one and a tires.json beside the aircraft's file
};

struct Inputs {
  simulation::Model model;
  std::vector<report::InputFile> files;
};

/// Throws InputError for anything that is missing or wrong, before any work is done.
Inputs read_inputs(const Choice&);
/// The same for a bed that is at hand; `from` notes where it comes from ("fleet", "design") and names the place in
/// messages.
Inputs read_inputs(const Choice&, bed::Bed, const report::InputFile& from);

/// The tire library for an aircraft's file: `tires` when it is given, otherwise the shipped one and a tires.json beside
/// the aircraft's file, which wins. Notes what was read.
aircraft::TireLibrary read_tires(const std::filesystem::path& tires, const std::filesystem::path& aircraft_file,
                                 std::vector<report::InputFile>& files);

/// Now, "2024-05-31 14:05 UTC", for the date of a report; no simulation knows a clock.
std::string utc_now();

/// The note on one input file: its content's hash and what it says about its source.
report::InputFile note(const std::string& role, const std::filesystem::path&, const std::string& source);

}  // namespace apc::cli
