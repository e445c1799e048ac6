#include "apc/base/parallel.h"

#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

namespace apc {
namespace {

TEST(ParallelFor, DoesEveryPieceOnceForAnyNumberOfThreads) {
  for (const unsigned threads : {1u, 2u, 5u, 0u}) {
    std::vector<int> done(1000, 0);
    parallel_for(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), 1000);
    EXPECT_EQ(*std::max_element(done.begin(), done.end()), 1);
  }
}

TEST(ParallelFor, PassesTheFirstFailureOn) {
  for (const unsigned threads : {1u, 3u})
    EXPECT_THROW(parallel_for(50, threads,
                              [](std::size_t i) {
                                if (i == 7) throw std::runtime_error("seven");
                              }),
                 std::runtime_error);
}

TEST(ParallelFor, NothingToDoIsDone) {
  EXPECT_NO_THROW(parallel_for(0, 4, [](std::size_t) { throw std::runtime_error("never"); }));
}

}  // namespace
}  // namespace apc
