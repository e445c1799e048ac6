/// A small finished design for commands that start from one.
#pragma once

#include <gtest/gtest.h>

#include "tests/scenarios/program.h"

namespace apc::scenarios {

/// Writes d/design.json into the folder; the shortest bed for one aircraft.
inline void make_design(const Folder& folder) {
  const auto said = run(folder, {"design", "--fleet", "acrp29_crj_200", "-o", "d", "--quiet"});
  ASSERT_EQ(said.exit_code, 0) << said.err;
}

/// One line on stderr, nothing on stdout, exit 2, the folder as it was.
inline void expect_refused(const Folder& folder, const std::vector<std::string>& words,
                           const std::vector<std::string>& mentions) {
  const auto before = folder.files();
  const auto said = run(folder, words);
  EXPECT_EQ(said.exit_code, 2) << said.err;
  EXPECT_EQ(said.error_lines(), 1u) << said.err;
  EXPECT_EQ(said.out, "");
  for (const auto& part : mentions)
    EXPECT_NE(said.err.find(part), std::string::npos) << "no \"" << part << "\" in: " << said.err;
  EXPECT_EQ(folder.files(), before);
}

}  // namespace apc::scenarios
