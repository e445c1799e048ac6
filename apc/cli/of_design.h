/// What commands that start from a finished design have in common: their options, and the models of its cases.
#pragma once

#include <string>

#include "apc/cli/fleet_inputs.h"
#include "apc/design/design_file.h"

namespace CLI {
class App;
}

namespace apc::cli {

/// The options as typed; empty = not given.
struct OfDesign {
  std::string design;
  Choice choice;  ///< loads and tires
  std::filesystem::path out;
  unsigned threads = 0;
};

/// --design, --loads, --tires, --threads, -o. `out_help` says what the folder gets.
void add_design_options(CLI::App&, OfDesign&, const std::string& out_help);

struct LoadedDesign {
  design::DesignFile design;
  std::vector<simulation::Model> models;  ///< one per case, in the bed as built
  std::vector<report::InputFile> files;   ///< the design's own file among them
};

/// InputError for a file that is no design of this version.
LoadedDesign load_design_models(const OfDesign&);

}  // namespace apc::cli
