/// The promise on bad input, asserted on the real program.
#pragma once

#include <gtest/gtest.h>

#include "tests/scenarios/program.h"

namespace apc::scenarios {

/// One line on stderr that holds all of `mentions`, nothing on stdout, exit 2, the folder as it was.
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
