/// What the scorer knows about one case: the truth and one program's answer to it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace scoring {

struct Claim {
  std::string id;
  double probability = 0.0;
  std::map<std::string, double> parameters;                   // SI
  std::map<std::string, std::pair<double, double>> interval;  // SI
  std::map<std::string, double> work;                         // J, by run
};

struct Answer {
  bool readable = false;
  std::string verdict;
  std::vector<Claim> effects;  // most probable first
  std::vector<std::set<std::string>> set90;
  std::optional<double> seconds;
};

struct TrueEffect {
  std::string id, law, amplitude;
  std::map<std::string, double> parameters;
  double detectability = 0.0, after_worst_rival = 0.0;
};

struct HeldError {
  double base = 0.0, ideal = 0.0;
};

struct Truth {
  std::string name, kind, verdict, remark;  // kind: N M X P C U E
  std::vector<TrueEffect> effects;
  bool decidable = false;
  std::map<std::string, std::map<std::string, double>> work;  // run → effect → J
  std::map<std::string, HeldError> held;
  std::set<std::string> ids() const;
};

/// "412 kJ" → 412000; bare numbers as they are.
double si(const std::string& text);

Answer read_answer(const std::filesystem::path& folder, const std::string& name);
Truth read_truth(const std::filesystem::path& case_folder);

/// Held-out error of one predicted run (NaN when no prediction was given).
double held_error(const std::filesystem::path& case_folder, const std::filesystem::path& prediction,
                  const std::string& run);

}  // namespace scoring
