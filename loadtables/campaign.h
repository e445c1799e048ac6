/// The load campaign: a folder with a plan and one result file per run. The state of the campaign is what the result
/// files say, nothing else: each is written whole or not at all, so a killed campaign loses the runs under way and no
/// other, several processes may work on one folder, and starting it again just goes on.
///
///   DIR/plan.json          what to run (plan.h)
///   DIR/settings.json      how every run of this folder is made: friction, spacing, command
///   DIR/results/0007.json  one per finished run, refused ones included
///   DIR/results/0007.lock  held while the run is under way; left-overs of a killed process hold nothing
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "loadtables/plan.h"
#include "loadtables/samples.h"

namespace apc::loadtables {

/// What became of one run. Only a steady one is a sample; the others map where runs are not feasible.
struct RunOutcome {
  std::string state;    ///< "steady", "did_not_settle", "tire_overloaded", "unstable"
  std::string message;  ///< why it is not steady
  TireLoad load;
  double wall_s = 0.0;
  std::map<std::string, double> facts;  ///< anything else worth keeping, SI: energy residual, particles, changes, …
  bool steady() const { return state == "steady"; }
};

/// How the runs of a folder are made. Fixed by the first run: samples of different making must not be mixed.
struct CampaignSettings {
  double friction = 0.3;
  double spacing = 0.0;  ///< m, largest; thin beds are resolved finer
  std::string solver;    ///< "apc sph 0.1.0"
  std::string command;   ///< of the first run; informative, may differ later
};

struct RunStatus {
  PlannedRun planned;
  std::optional<RunOutcome> outcome;
};

struct CampaignOptions {
  unsigned jobs = 1;
  int first = 0;  ///< make at most this many runs now; 0 = all that are left
  std::function<void(double share, const std::string& remark)> progress;
  std::function<bool()> stop;  ///< true: begin no further run
};

/// Makes every run that has no result yet. A SolveError of one run is kept as its outcome "unstable"; InputError and
/// Interrupted end the campaign, with finished runs kept. Returns the number of runs made.
int run_campaign(const std::filesystem::path& folder, const CampaignSettings&,
                 const std::function<RunOutcome(const PlannedRun&)>& make, const CampaignOptions& = {});

/// The plan's runs with what is known of them. InputError for a damaged result file.
std::vector<RunStatus> campaign_status(const std::filesystem::path& folder);

/// Settings of a folder that has been started.
std::optional<CampaignSettings> campaign_settings(const std::filesystem::path& folder);

/// Relative cost of a run: particles (depth) × steps (travel / speed).
double estimated_work(const PlannedRun&);

/// The steady runs as samples. `refused` counts the rest of the finished ones.
struct CampaignSamples {
  SampleSet set;
  int runs = 0, refused = 0;
};
CampaignSamples campaign_samples(const std::filesystem::path& folder);

void write_outcome(const PlannedRun&, const RunOutcome&, const std::filesystem::path&);
RunOutcome read_outcome(const PlannedRun&, const std::filesystem::path&);
void write_settings(const CampaignSettings&, const std::filesystem::path& folder);

}  // namespace apc::loadtables
