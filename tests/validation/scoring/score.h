/// The score table of a set of answers, as the cases' own README defines it.
#pragma once

#include "answer.h"

namespace scoring {

struct Share {
  int hits = 0, of = 0;
  void count(bool hit) { hits += hit ? 1 : 0, ++of; }
  /// 95 % Clopper–Pearson interval.
  std::pair<double, double> interval() const;
  std::string text() const;
};

struct Table {
  std::string text;                     ///< to print
  std::vector<std::string> failures;    ///< one line per failed case
  std::map<std::string, Share> shares;  ///< by name of the score
  std::map<std::string, double> numbers;
};

Table score(const std::filesystem::path& cases, const std::filesystem::path& answers);

}  // namespace scoring
