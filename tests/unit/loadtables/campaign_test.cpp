#include "loadtables/campaign.h"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <mutex>
#include <set>
#include <thread>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::HasSubstr;

class Campaign : public ::testing::Test {
 protected:
  synthetic::Folder folder{"campaign"};
  CampaignSettings settings{0.3, 0.05, "closed form", "a test"};

  void SetUp() override {
    PlanOptions options;
    options.runs = 24;
    write_plan(make_plan(synthetic::tire(), "made_up_foam", options), folder.path());
  }
  static RunOutcome steady(const PlannedRun& run) {
    return {"steady", "", synthetic::truth(run.contact), 0.5, {{"steps", 7.0}}};
  }
  int finished() {
    int count = 0;
    for (const auto& status : campaign_status(folder.path())) count += status.outcome.has_value();
    return count;
  }
};

TEST_F(Campaign, MakesEveryRunOnceAndTurnsThemIntoATable) {
  EXPECT_EQ(run_campaign(folder.path(), settings, steady), 24);
  EXPECT_EQ(finished(), 24);
  EXPECT_EQ(run_campaign(folder.path(), settings, steady), 0);
  const auto samples = campaign_samples(folder.path());
  EXPECT_EQ(samples.runs, 24);
  EXPECT_EQ(samples.refused, 0);
  ASSERT_EQ(samples.set.samples.size(), 24u);
  const auto& [contact, load] = samples.set.samples[5];
  EXPECT_NEAR(load.drag, synthetic::truth(contact).drag, 1e-6 * load.drag);
  EXPECT_THAT(samples.set.source, HasSubstr("friction 0.3"));
  EXPECT_EQ(fit(samples.set, read_plan(folder.path()).tire, {}).quality().size(), 4u);
}

TEST_F(Campaign, GoesOnWhereItWasStopped) {
  std::atomic<int> made{0};
  const auto interrupted = [&](const PlannedRun& run) {
    if (made == 9) throw Interrupted();
    ++made;
    return steady(run);
  };
  EXPECT_THROW(run_campaign(folder.path(), settings, interrupted), Interrupted);
  EXPECT_EQ(finished(), 9);
  EXPECT_EQ(run_campaign(folder.path(), settings, steady), 15);
  EXPECT_EQ(finished(), 24);
}

TEST_F(Campaign, AKilledProcessLosesNoFinishedRun) {
  const auto slow = [](const PlannedRun& run) {
    std::this_thread::sleep_for(std::chrono::milliseconds(15));
    return steady(run);
  };
  const auto child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    run_campaign(folder.path(), settings, slow);
    _exit(0);
  }
  while (finished() < 4) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  const int kept = finished();
  EXPECT_GE(kept, 4);
  EXPECT_EQ(run_campaign(folder.path(), settings, steady), 24 - kept);
  EXPECT_EQ(finished(), 24);
  EXPECT_EQ(campaign_samples(folder.path()).set.samples.size(), 24u);
}

TEST_F(Campaign, AHalfWrittenResultOfAKilledRunIsIgnored) {
  std::filesystem::create_directories(folder / "results");
  write_text(folder / "results/0003.lock", "");  // left behind by a killed process
  std::filesystem::copy_file(folder / "plan.json", folder / "results/0004.json.part");
  EXPECT_EQ(run_campaign(folder.path(), settings, steady), 24);
}

TEST_F(Campaign, KeepsRefusedRunsWithTheirReasonButDoesNotFitThem) {
  const auto some = [](const PlannedRun& run) -> RunOutcome {
    if (run.id == 2) throw SolveError("particles left the window", 0.3);
    if (run.id == 3) return {"steady", "", {std::nan(""), 1.0, 0.0, 1.0}, 0.1, {{"residual", std::nan("")}}};
    if (run.relative_penetration > 0.9) return {"tire_overloaded", "85 % of the bottoming load", {}, 0.1, {}};
    return steady(run);
  };
  run_campaign(folder.path(), settings, some);
  const auto samples = campaign_samples(folder.path());
  EXPECT_EQ(samples.runs, 24);
  EXPECT_GE(samples.refused, 4);
  EXPECT_EQ(samples.set.samples.size() + static_cast<std::size_t>(samples.refused), 24u);
  const auto status = campaign_status(folder.path());
  EXPECT_EQ(status[1].outcome->state, "unstable");
  EXPECT_THAT(status[1].outcome->message, HasSubstr("particles left the window"));
  EXPECT_EQ(status[2].outcome->state, "unstable");
}

TEST_F(Campaign, GivesTheSameSamplesForAnyNumberOfWorkers) {
  CampaignOptions options;
  options.jobs = 4;
  run_campaign(folder.path(), settings, steady, options);
  const auto several = campaign_samples(folder.path());
  synthetic::Folder other("campaign_one");
  std::filesystem::copy_file(folder / "plan.json", other / "plan.json");
  run_campaign(other.path(), settings, steady);
  const auto one = campaign_samples(other.path());
  ASSERT_EQ(one.set.samples.size(), several.set.samples.size());
  for (std::size_t i = 0; i < one.set.samples.size(); ++i)
    EXPECT_EQ(one.set.samples[i].load.drag, several.set.samples[i].load.drag);
}

TEST_F(Campaign, TwoProcessesOnOneFolderShareTheWork) {
  std::mutex guard;
  std::multiset<int> made;
  const auto slow = [&](const PlannedRun& run) {
    {
      const std::lock_guard lock(guard);
      made.insert(run.id);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    return steady(run);
  };
  std::thread other([&] { run_campaign(folder.path(), settings, slow); });
  run_campaign(folder.path(), settings, slow);
  other.join();
  EXPECT_EQ(made.size(), 24u);
  EXPECT_EQ(finished(), 24);
}

TEST_F(Campaign, DoesNotMixRunsOfDifferentMaking) {
  CampaignOptions options;
  options.first = 3;
  EXPECT_EQ(run_campaign(folder.path(), settings, steady, options), 3);
  auto finer = settings;
  finer.spacing = 0.025;
  EXPECT_THROW(run_campaign(folder.path(), finer, steady), InputError);
  auto slippery = settings;
  slippery.friction = 0.0;
  EXPECT_THROW(run_campaign(folder.path(), slippery, steady), InputError);
  EXPECT_EQ(finished(), 3);
}

TEST_F(Campaign, RefusesDamagedAndForeignResults) {
  CampaignOptions options;
  options.first = 2;
  run_campaign(folder.path(), settings, steady, options);
  write_text(folder / "results/0001.json", "{ \"schema\": \"apc-load-run/1\", \"id\": 1 }");
  EXPECT_THROW(campaign_status(folder.path()), InputError);
  std::filesystem::copy_file(folder / "results/0002.json", folder / "results/0001.json",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_THROW(campaign_status(folder.path()), InputError);
}

TEST_F(Campaign, ReportsProgressUpToTheWhole) {
  double last = 0.0;
  CampaignOptions options;
  options.progress = [&](double share, const std::string&) {
    EXPECT_GT(share, last);
    last = share;
  };
  run_campaign(folder.path(), settings, steady, options);
  EXPECT_NEAR(last, 1.0, 1e-9);
}

TEST_F(Campaign, HasNoSamplesBeforeItsFirstRun) { EXPECT_THROW(campaign_samples(folder.path()), InputError); }

}  // namespace
}  // namespace apc::loadtables
