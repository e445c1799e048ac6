/// What the learning commands share: the case, the effects known, and how a long fit shows its progress.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "apc/cli/commands.h"
#include "apc/learning/diagnosis_json.h"
#include "apc/learning/next_run.h"

namespace apc::cli {

struct LearnWords {
  std::filesystem::path folder, aliases, model, from, out;
  std::vector<std::filesystem::path> own;  ///< the user's effect files
  unsigned threads = 0;
  bool force = false;
};

/// CASE, --aliases, --effect, --threads.
void add_case_options(CLI::App&, const std::shared_ptr<LearnWords>&);
learning::Case load(const LearnWords&);
/// The catalogue and the files of --effect.
std::vector<effects::Effect> known_effects(const LearnWords&);
/// Diagnoses with a progress line on stderr.
learning::Study study_of(const learning::Case&, const LearnWords&, const Settings&);

/// Which run to do next, where more than one explanation stands; also written into the diagnosis.
std::optional<learning::NextPlan> plan_of(const learning::Case&, learning::Study&, const LearnWords&, const Settings&);

/// The verdict, its numbers, what cannot be told apart and what would have been seen, for people.
std::string verdict_text(const learning::Study&);

}  // namespace apc::cli
