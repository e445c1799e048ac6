/// A small finished design for commands that start from one.
#pragma once

#include <gtest/gtest.h>

#include "tests/scenarios/refusal.h"

namespace apc::scenarios {

/// Writes d/design.json into the folder; the shortest bed for one aircraft.
inline void make_design(const Folder& folder) {
  const auto said = run(folder, {"design", "--fleet", "acrp29_crj_200", "-o", "d", "--quiet"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
}

}  // namespace apc::scenarios
