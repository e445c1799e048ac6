/// From a fleet's file to one model per case, with a note of every file that was read.
#pragma once

#include "apc/cli/inputs.h"
#include "apc/design/fleet.h"

namespace apc::cli {

struct FleetModels {
  std::vector<simulation::Model> models;  ///< one per case of the fleet
  std::vector<report::InputFile> files;
  std::string identity;  ///< changes whenever the content of any input does
};

/// `fleet_note` is the note on the fleet's file. Checks each case's mass and centre of gravity against its aircraft.
FleetModels load_fleet_models(const design::Fleet&, const report::InputFile& fleet_note, const Choice&);

}  // namespace apc::cli
