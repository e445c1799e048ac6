/// Weak rivals of the diagnosis, to hold its scores against: they see the same runs and answer in the same form.
#pragma once

#include "apc/learning/diagnose.h"

namespace scoring {

enum class Baseline {
  always_nothing,
  always_inertial,    ///< with the amplitude of least squares
  white_noise_bic,    ///< least squares on every reading with its quoted white noise; the best effect by BIC
  sparse_regression,  ///< sequentially thresholded least squares of the differentiated speed on terms of the catalogue
};
const char* name_of(Baseline);

/// Verdict, claims and what would be added; nominal model and prior means in everything else.
apc::learning::Study answer_of(Baseline, const apc::learning::Case&);

}  // namespace scoring
