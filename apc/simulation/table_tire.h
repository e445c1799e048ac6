/// The tire a load table belongs to, as the aircraft's tire library describes it.
#pragma once

#include "aircraft/aircraft.h"
#include "loadtables/load_table.h"

namespace apc::simulation {

loadtables::TableTire table_tire(const aircraft::Tire&);

}  // namespace apc::simulation
