/// A user's law in one line of text: `k*b*p*v^n`. Numbers, names, + − * / ^, parentheses and the functions exp, ln,
/// sqrt, tanh, sin, cos, abs, min, max, step. Dimensions are checked when the formula is read, so a law with wrong
/// units never runs; the message names the term.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "apc/base/quantity.h"

namespace apc::effects {

/// A name a formula may use, with its dimension; its value is found at `index`.
struct FormulaName {
  std::string name;
  Dimension dimension;
};

class Formula {
 public:
  /// Throws InputError: unknown name, syntax, or terms whose dimensions do not fit; `wanted` is the dimension of the
  /// whole.
  Formula(const std::string& text, const std::vector<FormulaName>& names, const Dimension& wanted);
  /// Values in the order of `names`, SI.
  double operator()(const double* values) const;
  const std::string& text() const { return text_; }

  struct Node;

 private:
  std::string text_;
  std::shared_ptr<const Node> root_;
};

}  // namespace apc::effects
