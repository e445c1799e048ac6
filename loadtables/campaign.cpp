#include "loadtables/campaign.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>

#include "apc/base/parallel.h"
#include "apc/base/require.h"

namespace apc::loadtables {
namespace fs = std::filesystem;

namespace {

fs::path result_file(const fs::path& folder, const PlannedRun& run) {
  return folder / "results" / fmt::format("{:04d}.json", run.id);
}

/// Exclusive claim on one run. The kernel frees it when the process ends, however it ends.
class Claim {
 public:
  explicit Claim(const fs::path& path) : path_(path), file_(open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    held_ = file_ >= 0 && flock(file_, LOCK_EX | LOCK_NB) == 0;
  }
  ~Claim() {
    std::error_code error;
    if (held_) fs::remove(path_, error);
    if (file_ >= 0) close(file_);
  }
  Claim(const Claim&) = delete;
  Claim& operator=(const Claim&) = delete;
  bool held() const { return held_; }

 private:
  fs::path path_;
  int file_;
  bool held_ = false;
};

/// Waits for the folder; the kernel frees it when the process ends, however it ends.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : file_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    require(file_ >= 0 && flock(file_, LOCK_EX) == 0, folder.string(), ": cannot be locked for this campaign");
  }
  ~FolderLock() { close(file_); }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_;
};

/// The first process writes the settings, the others must agree with them; the folder is locked meanwhile, so two that
/// start together cannot both be first.
void settle_settings(const fs::path& folder, const CampaignSettings& wanted) {
  const FolderLock lock(folder);
  const auto found = campaign_settings(folder);
  if (!found) {
    write_settings(wanted, folder);
    return;
  }
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * std::abs(b); };
  require(same(wanted.spacing, found->spacing), folder.string(), ": its runs were started with a particle spacing of ",
          found->spacing, " m, not ", wanted.spacing, " m. Keep to it, or make a new plan in another folder");
  require(same(wanted.friction, found->friction), folder.string(), ": its runs were started with a friction of ",
          found->friction, ", not ", wanted.friction, ". Keep to it, or make a new plan in another folder");
}

/// Work done and to do, shared by the workers.
class Ledger {
 public:
  Ledger(double total, const CampaignOptions& options) : total_(total), options_(options) {}
  void book(const PlannedRun& run, const RunOutcome& outcome) {
    const std::lock_guard lock(guard_);
    done_ += estimated_work(run);
    ++made_;
    if (!outcome.steady()) ++refused_;
    if (options_.progress)
      options_.progress(total_ > 0.0 ? std::min(done_ / total_, 1.0) : 1.0,
                        fmt::format("{} runs made{}", made_, refused_ ? fmt::format(", {} refused", refused_) : ""));
  }
  void skip(const PlannedRun& run) {
    const std::lock_guard lock(guard_);
    done_ += estimated_work(run);
  }
  int made() const { return made_; }

 private:
  std::mutex guard_;
  double total_, done_ = 0.0;
  int made_ = 0, refused_ = 0;
  const CampaignOptions& options_;
};

}  // namespace

double estimated_work(const PlannedRun& run) {
  // Particles per length of travel times steps per length of travel; thin beds are resolved by five particles.
  const double spacing = std::min(0.04, run.contact.bed_depth / 5.0);
  return (0.1 + run.contact.bed_depth) / (std::pow(spacing, 4) * run.contact.speed);
}

int run_campaign(const fs::path& folder, const CampaignSettings& settings,
                 const std::function<RunOutcome(const PlannedRun&)>& make, const CampaignOptions& options) {
  std::vector<PlannedRun> left;
  double work = 0.0;
  for (const auto& status : campaign_status(folder)) {
    if (status.outcome) continue;
    left.push_back(status.planned);
    work += estimated_work(status.planned);
  }
  settle_settings(folder, settings);
  std::error_code error;
  fs::create_directories(folder / "results", error);
  require(!error, folder.string(), ": cannot make the folder for results (", error.message(), ")");

  if (options.first > 0 && static_cast<std::size_t>(options.first) < left.size())
    work *= static_cast<double>(options.first) / static_cast<double>(left.size());
  Ledger ledger(work, options);
  std::atomic<int> begun{0};
  parallel_for(left.size(), std::max(1u, options.jobs), [&](std::size_t i) {
    if (options.stop && options.stop()) throw Interrupted();
    const auto& run = left[i];
    const auto file = result_file(folder, run);
    auto lock = file;
    const Claim claim(lock.replace_extension(".lock"));
    if (!claim.held() || fs::exists(file)) {  // another process has it, or finished it meanwhile
      ledger.skip(run);
      return;
    }
    if (options.first > 0 && begun++ >= options.first) return;
    RunOutcome outcome;
    try {
      outcome = make(run);
    } catch (const SolveError& failure) {
      outcome.state = "unstable";
      outcome.message = failure.what();
    }
    if (outcome.steady() && !(std::isfinite(outcome.load.drag) && std::isfinite(outcome.load.vertical) &&
                              std::isfinite(outcome.load.rut_depth) && std::isfinite(outcome.load.spin_ratio))) {
      outcome.state = "unstable";
      outcome.message = "steady, but a load is not finite";
    }
    write_outcome(run, outcome, file);
    ledger.book(run, outcome);
  });
  return ledger.made();
}

std::vector<RunStatus> campaign_status(const fs::path& folder) {
  std::vector<RunStatus> list;
  for (const auto& run : read_plan(folder).runs) {
    RunStatus status{run, std::nullopt};
    const auto file = result_file(folder, run);
    std::error_code error;
    if (fs::is_regular_file(file, error)) status.outcome = read_outcome(run, file);
    list.push_back(status);
  }
  return list;
}

CampaignSamples campaign_samples(const fs::path& folder) {
  const auto plan = read_plan(folder);
  const auto settings = campaign_settings(folder);
  require(settings.has_value(), folder.string(), ": no run has been made yet. Start with apc loads run ",
          folder.string());
  CampaignSamples result;
  result.set.material = plan.material;
  result.set.tire = plan.tire.name;
  result.set.source = fmt::format(
      "{}: SPH runs of one free-rolling, unbraked tire, friction {:g}, particle spacing {:.1f} mm (finer in thin "
      "beds), ACRP Report 29 "
      "§9.4.3.3 sequence",
      settings->solver, settings->friction, 1e3 * settings->spacing);
  result.set.has_rut = result.set.has_spin = true;
  for (const auto& status : campaign_status(folder)) {
    if (!status.outcome) continue;
    ++result.runs;
    if (status.outcome->steady())
      result.set.samples.push_back({status.planned.contact, status.outcome->load});
    else
      ++result.refused;
  }
  require(!result.set.samples.empty(), folder.string(), ": none of its ", result.runs, " finished runs is steady");
  return result;
}

}  // namespace apc::loadtables
