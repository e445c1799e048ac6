#include "apc/effects/formula.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>

#include "apc/base/require.h"

namespace apc::effects {

struct Formula::Node {
  enum class Kind { number, name, sum, difference, product, quotient, power, call };
  Kind kind = Kind::number;
  double number = 0.0;
  std::size_t index = 0;
  double (*function1)(double) = nullptr;
  double (*function2)(double, double) = nullptr;
  std::shared_ptr<const Node> left, right;
  Dimension dimension{};
  bool constant = false;
  std::string text;
};

namespace {

using Node = Formula::Node;
using Pointer = std::shared_ptr<const Node>;

double step(double x) { return x > 0.0 ? 1.0 : 0.0; }
double smallest(double a, double b) { return std::min(a, b); }
double largest(double a, double b) { return std::max(a, b); }

std::string in_words(const Dimension& d) {
  static const char* const base[] = {"kg", "m", "s", "K"};
  std::string text;
  for (std::size_t i = 0; i < 4; ++i) {
    if (d.exponents[i] == 0) continue;
    if (!text.empty()) text += ' ';
    text += base[i];
    if (d.exponents[i] != 1) text += '^', text += std::to_string(d.exponents[i]);
  }
  return text.empty() ? "no dimension" : text;
}

double value_of(const Node& n, const double* values) {
  switch (n.kind) {
    case Node::Kind::number:
      return n.number;
    case Node::Kind::name:
      return values[n.index];
    case Node::Kind::sum:
      return value_of(*n.left, values) + value_of(*n.right, values);
    case Node::Kind::difference:
      return value_of(*n.left, values) - value_of(*n.right, values);
    case Node::Kind::product:
      return value_of(*n.left, values) * value_of(*n.right, values);
    case Node::Kind::quotient:
      return value_of(*n.left, values) / value_of(*n.right, values);
    case Node::Kind::power:
      return std::pow(value_of(*n.left, values), value_of(*n.right, values));
    case Node::Kind::call:
      return n.function1 ? n.function1(value_of(*n.left, values))
                         : n.function2(value_of(*n.left, values), value_of(*n.right, values));
  }
  return 0.0;
}

class Parser {
 public:
  Parser(const std::string& text, const std::vector<FormulaName>& names) : text_(text), names_(names) {}

  Pointer whole() {
    Pointer result = sum();
    skip();
    require(at_ == text_.size(), "formula \"", text_, "\": \"", text_.substr(at_),
            "\" is left over. Check the parentheses and operators.");
    return result;
  }

 private:
  void skip() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  bool take(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  Pointer finish(Node node, std::size_t from) {
    node.text = text_.substr(from, at_ - from);
    return std::make_shared<const Node>(std::move(node));
  }

  Pointer sum() {
    skip();
    const std::size_t from = at_;
    Pointer left = product();
    for (;;) {
      const bool plus = take('+');
      if (!plus && !take('-')) return left;
      Pointer right = product();
      require(left->dimension == right->dimension, "formula \"", text_, "\": \"", left->text, "\" (",
              in_words(left->dimension), ") and \"", right->text, "\" (", in_words(right->dimension),
              ") cannot be added. Give the parameter in \"", right->text, "\" another unit.");
      Node node;
      node.kind = plus ? Node::Kind::sum : Node::Kind::difference;
      node.dimension = left->dimension;
      node.constant = left->constant && right->constant;
      node.left = left, node.right = right;
      left = finish(node, from);
    }
  }

  Pointer product() {
    skip();
    const std::size_t from = at_;
    Pointer left = factor();
    for (;;) {
      const bool times = take('*');
      if (!times && !take('/')) return left;
      Pointer right = factor();
      Node node;
      node.kind = times ? Node::Kind::product : Node::Kind::quotient;
      for (std::size_t i = 0; i < 4; ++i)
        node.dimension.exponents[i] = left->dimension.exponents[i] + (times ? 1 : -1) * right->dimension.exponents[i];
      node.constant = left->constant && right->constant;
      node.left = left, node.right = right;
      left = finish(node, from);
    }
  }

  Pointer factor() {
    skip();
    const std::size_t from = at_;
    if (take('-')) {
      Node zero, node;
      zero.constant = true;
      Pointer right = factor();
      zero.dimension = right->dimension;
      node.kind = Node::Kind::difference;
      node.dimension = right->dimension;
      node.constant = right->constant;
      node.left = std::make_shared<const Node>(zero), node.right = right;
      return finish(node, from);
    }
    Pointer base = atom();
    if (!take('^')) return base;
    Pointer exponent = factor();
    require(exponent->dimension == dimension::none, "formula \"", text_, "\": the exponent \"", exponent->text,
            "\" has the dimension ", in_words(exponent->dimension), ". Exponents are pure numbers.");
    Node node;
    node.kind = Node::Kind::power;
    if (!(base->dimension == dimension::none)) {
      require(exponent->constant, "formula \"", text_, "\": \"", base->text, "\" (", in_words(base->dimension),
              ") is raised to a power that is not a constant, so its unit is unknown. Divide it by a reference first.");
      const double power = value_of(*exponent, nullptr);
      for (std::size_t i = 0; i < 4; ++i) {
        const double e = base->dimension.exponents[i] * power;
        require(std::abs(e - std::round(e)) < 1e-9, "formula \"", text_, "\": \"", base->text, "^", power,
                "\" gives a broken unit.");
        node.dimension.exponents[i] = static_cast<int>(std::lround(e));
      }
    }
    node.constant = base->constant && exponent->constant;
    node.left = base, node.right = exponent;
    return finish(node, from);
  }

  Pointer atom() {
    skip();
    const std::size_t from = at_;
    require(at_ < text_.size(), "formula \"", text_, "\": it ends too early.");
    if (take('(')) {
      Pointer inner = sum();
      require(take(')'), "formula \"", text_, "\": a closing parenthesis is missing.");
      return inner;
    }
    Node node;
    const char c = text_[at_];
    if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') {
      char* end = nullptr;
      node.number = std::strtod(text_.c_str() + at_, &end);
      at_ = static_cast<std::size_t>(end - text_.c_str());
      node.constant = true;
      return finish(node, from);
    }
    require(std::isalpha(static_cast<unsigned char>(c)) != 0, "formula \"", text_, "\": \"", text_.substr(at_),
            "\" is neither a number nor a name.");
    std::size_t end = at_;
    while (end < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[end])) || text_[end] == '_')) ++end;
    const std::string name = text_.substr(at_, end - at_);
    at_ = end;
    if (take('(')) return call(name, from);
    const auto found = std::find_if(names_.begin(), names_.end(), [&](const FormulaName& n) { return n.name == name; });
    if (found == names_.end()) {
      std::string known;
      for (const auto& n : names_) known += " " + n.name;
      throw InputError(concat("formula \"", text_, "\": \"", name, "\" is unknown. Known:", known, "."));
    }
    node.kind = Node::Kind::name;
    node.index = static_cast<std::size_t>(found - names_.begin());
    node.dimension = found->dimension;
    return finish(node, from);
  }

  Pointer call(const std::string& name, std::size_t from) {
    static const std::map<std::string, double (*)(double)> one = {
        {"exp", std::exp}, {"ln", std::log},  {"sqrt", std::sqrt}, {"tanh", std::tanh},
        {"sin", std::sin}, {"cos", std::cos}, {"abs", std::fabs},  {"step", step}};
    static const std::map<std::string, double (*)(double, double)> two = {{"min", smallest}, {"max", largest}};
    Node node;
    node.kind = Node::Kind::call;
    node.left = sum();
    node.constant = node.left->constant;
    if (const auto f = one.find(name); f != one.end()) {
      node.function1 = f->second;
      if (name == "abs") {
        node.dimension = node.left->dimension;
      } else if (name == "sqrt") {
        for (std::size_t i = 0; i < 4; ++i) {
          require(node.left->dimension.exponents[i] % 2 == 0, "formula \"", text_, "\": sqrt(", node.left->text,
                  ") gives a broken unit.");
          node.dimension.exponents[i] = node.left->dimension.exponents[i] / 2;
        }
      } else if (name != "step") {
        require(node.left->dimension == dimension::none, "formula \"", text_, "\": ", name, "(", node.left->text,
                ") needs a pure number, but \"", node.left->text, "\" has the dimension ",
                in_words(node.left->dimension), ". Divide it by a reference.");
      }
    } else if (const auto g = two.find(name); g != two.end()) {
      require(take(','), "formula \"", text_, "\": ", name, " takes two arguments.");
      node.function2 = g->second;
      node.right = sum();
      node.constant = node.constant && node.right->constant;
      require(node.left->dimension == node.right->dimension, "formula \"", text_, "\": ", name, " compares \"",
              node.left->text, "\" with \"", node.right->text, "\", which have other dimensions.");
      node.dimension = node.left->dimension;
    } else {
      throw InputError(concat("formula \"", text_, "\": there is no function \"", name,
                              "\". There are exp ln sqrt tanh sin cos abs step min max."));
    }
    require(take(')'), "formula \"", text_, "\": a closing parenthesis is missing after ", name, ".");
    return finish(node, from);
  }

  const std::string& text_;
  const std::vector<FormulaName>& names_;
  std::size_t at_ = 0;
};

}  // namespace

Formula::Formula(const std::string& text, const std::vector<FormulaName>& names, const Dimension& wanted)
    : text_(text), root_(Parser(text_, names).whole()) {
  require(root_->dimension == wanted, "formula \"", text_, "\": it gives ", in_words(root_->dimension), " where ",
          in_words(wanted), " is needed. Give its parameter another unit.");
}

double Formula::operator()(const double* values) const { return value_of(*root_, values); }

}  // namespace apc::effects
