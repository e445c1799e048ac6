/// A finished study with everything its reports need.
#pragma once

#include "apc/report/record.h"
#include "apc/report/unit_system.h"
#include "apc/study/envelope.h"
#include "apc/study/tornado.h"

namespace apc::report {

struct StudyRecord {
  std::vector<simulation::Model> models;  ///< one per aircraft and bed
  study::Axes axes;
  std::vector<study::CaseResult> results;
  std::vector<study::Envelope> envelopes;
  std::vector<study::Tornado> tornados;
  std::size_t remembered = 0;  ///< cases that an earlier start had finished
  double seconds = 0.0;
  Manifest manifest;
};

/// The full record: `cases[]` with the keys of one overrun's record plus inputs, `envelopes[]`, `tornados[]`.
std::string study_json(const StudyRecord&);
/// One row per case, SI.
std::string study_csv(const StudyRecord&);
/// For a terminal.
std::string study_brief(const StudyRecord&, UnitSystem);
/// One self-contained page.
std::string study_page(const StudyRecord&);

}  // namespace apc::report
