/// A design held against what an arrestor bed must satisfy, with everything the report on it needs.
#pragma once

#include <optional>

#include "apc/design/design_file.h"
#include "apc/report/record.h"
#include "apc/site/site.h"

namespace apc::report {

/// One case in the bed as built, and with the load tables wrong by their own error.
struct ComplianceCase {
  simulation::Model model;
  simulation::Result result;  ///< reference method, with history
  double use = 0.0;           ///< largest load over its limit, of all known gear limits, counted by the design or not
  double arrest_speed = 0.0, intact_speed = 0.0;  ///< m/s
  double table_error = 0.0;                       ///< relative, the largest leave-one-out error of drag of its tables
  double stop_low = 0.0, stop_high = 0.0;         ///< m, drag and vertical load scaled by 1 ± table_error
  double use_low = 0.0, use_high = 0.0;
  double learned_stop = 0.0, learned_use = 0.0;  ///< with the learned effects; mean nothing without any
};

/// Effects learned from measured runs, whose influence a report shows beside the tables' error.
struct LearnedEffects {
  std::vector<std::string> names;       ///< ids; empty = none were given
  double slowest = 0.0, fastest = 0.0;  ///< m/s, of the runs they were learned on
};

struct ComplianceRecord {
  design::DesignFile design;
  std::vector<ComplianceCase> cases;
  std::optional<site::Site> site;
  std::vector<site::Check> fit;
  LearnedEffects learned;
  Manifest manifest;  ///< without a date: the same inputs give the same bytes
};

enum class Verdict {
  pass,          ///< met, by a clause that was read in a source
  fail,          ///< not met
  not_checked,   ///< nothing here can tell
  not_verified,  ///< the clause itself is recalled, not read: what the check says is evidence, no verdict
};
const char* text(Verdict);

struct Finding {
  std::string clause;  ///< the requirement in checkable form
  std::string basis;   ///< where the clause stands, and whether it was read there
  bool read = false;   ///< false: recalled, unverified
  Verdict verdict = Verdict::not_checked;
  std::string evidence;  ///< HTML
};

/// Every checkable requirement of FAA AC 150/5220-22 as this project knows it.
std::vector<Finding> findings(const ComplianceRecord&);

std::string compliance_page(const ComplianceRecord&);
std::string compliance_json(const ComplianceRecord&);

}  // namespace apc::report
