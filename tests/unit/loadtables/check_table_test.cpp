#include "loadtables/check_table.h"

#include <gmock/gmock.h>

#include "loadtables/load_table_data.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(TableCheck, PassesAGoodTable) {
  const auto check = check_table(synthetic::table());
  EXPECT_THAT(check.failures, IsEmpty());
  EXPECT_GE(check.least_drag, 0.0);
  EXPECT_GT(check.points, 10000);
  EXPECT_LT(check.drag_rms, 0.02);
}

TEST(TableCheck, FindsAVerticalLoadThatFalls) {
  auto data = std::make_shared<LoadTable::Data>(synthetic::table().data());
  const auto ratios = static_cast<std::size_t>(data->ratio.coefficients());
  for (std::size_t i = vertical; i < data->coefficients.size(); i += responses)
    if (const auto k = i / responses % ratios; k > 20 && k < 30) data->coefficients[i] *= 0.3;
  const auto check = check_table(LoadTable(data));
  EXPECT_GT(check.falling_share, 0.0);
  EXPECT_THAT(check.failures, Contains(HasSubstr("falls by")));
}

TEST(TableCheck, FindsANegativeDragAndSamplesThatDoNotComeBack) {
  auto data = std::make_shared<LoadTable::Data>(synthetic::table().data());
  for (std::size_t i = drag; i < data->coefficients.size(); i += responses) data->coefficients[i] *= -0.5;
  const auto check = check_table(LoadTable(data));
  EXPECT_THAT(check.failures, Contains(HasSubstr("drag falls to")));
  EXPECT_THAT(check.failures, Contains(HasSubstr("of the samples comes back")));
}

}  // namespace
}  // namespace apc::loadtables
