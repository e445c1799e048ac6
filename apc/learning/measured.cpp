#include "apc/learning/measured.h"

#include <algorithm>
#include <array>

namespace apc::learning {
namespace {

struct Entry {
  std::string name;
  Dimension dimension;
};

const std::array<Entry, 14>& entries() {
  static const std::array<Entry, 14> table = {{{"speed", dimension::speed},
                                               {"acceleration_x", dimension::acceleration},
                                               {"acceleration_z", dimension::acceleration},
                                               {"pitch", dimension::angle},
                                               {"pitch_rate", dimension::angular_speed},
                                               {"nose_stroke", dimension::length},
                                               {"main_stroke", dimension::length},
                                               {"nose_drag", dimension::force},
                                               {"nose_vertical", dimension::force},
                                               {"main_drag", dimension::force},
                                               {"main_vertical", dimension::force},
                                               {"nose_spin", dimension::angular_speed},
                                               {"main_spin", dimension::angular_speed},
                                               {"nose_distance", dimension::length}}};
  return table;
}

}  // namespace

const std::string& name_of(Quantity quantity) { return entries()[static_cast<std::size_t>(quantity)].name; }

Dimension dimension_of(Quantity quantity) { return entries()[static_cast<std::size_t>(quantity)].dimension; }

std::optional<Quantity> quantity_named(const std::string& name) {
  for (std::size_t i = 0; i < entries().size(); ++i)
    if (entries()[i].name == name) return static_cast<Quantity>(i);
  return {};
}

const Channel* Run::find(Quantity quantity) const {
  const auto found =
      std::find_if(channels.begin(), channels.end(), [&](const Channel& c) { return c.quantity == quantity; });
  return found == channels.end() ? nullptr : &*found;
}

}  // namespace apc::learning
