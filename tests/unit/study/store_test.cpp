#include "apc/study/store.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/study/result_text.h"

namespace apc::study {
namespace {

/// A path of its own per test, removed at the end.
struct Place {
  std::filesystem::path path;
  Place() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    path = std::filesystem::temp_directory_path() / ("apc_store_" + std::to_string(::getpid()) + "_" + test->name()) /
           "cases.store";
  }
  ~Place() { std::filesystem::remove_all(path.parent_path()); }
};

TEST(Store, FindsWhatAnEarlierStartFinished) {
  const Place place;
  Store(place.path, "work").put("a", "1");
  const Store again(place.path, "work");
  EXPECT_EQ(again.found(), 1u);
  EXPECT_EQ(again.find("a"), "1");
  EXPECT_FALSE(again.find("b"));
}

TEST(Store, LosesOnlyTheLineThatWasBeingWritten) {
  const Place place;
  {
    Store store(place.path, "work");
    store.put("a", "1"), store.put("b", "2");
  }
  const auto text = read_text(place.path);
  for (std::size_t cut = text.size() - 1; cut > text.find("a\t1") + 4; --cut) {
    std::ofstream(place.path, std::ios::trunc) << text.substr(0, cut);
    {
      Store store(place.path, "work");
      EXPECT_EQ(store.find("a"), "1") << "cut at " << cut;
      EXPECT_FALSE(store.find("b")) << "cut at " << cut;
      store.put("c", "3");
    }
    EXPECT_EQ(Store(place.path, "work").find("c"), "3") << "cut at " << cut;
  }
}

TEST(Store, IsNeverContinuedByOtherWork) {
  const Place place;
  Store(place.path, "work").put("a", "1");
  try {
    Store(place.path, "other work");
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("belongs to other work"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("-o"), std::string::npos);
  }
  std::ofstream(place.path, std::ios::trunc) << "distance,depth\n1,2\n";
  EXPECT_THROW(Store(place.path, "work"), InputError);
}

TEST(ResultText, BringsEveryNumberBackBitForBit) {
  simulation::Result result;
  result.stop_distance = 0.1 + 0.2, result.exit_speed = std::nan(""), result.message = "stopped | in\tthe bed";
  result.gears.resize(2);
  result.gears[1].name = "main", result.gears[1].peak_drag = 1.0 / 3.0, result.gears[1].bottomed = true;
  result.gears[1].failed_by = "vertical", result.gears[1].failed_at = 1.0 / 7.0;
  result.coverage.push_back({"main", "M44", 0.9, 0.02, 0.03, 0.04, 0.05});
  result.energy["bed"] = 1e7 / 3, result.warnings = {"left the table"};
  const auto back = result_from(to_text(result));
  EXPECT_EQ(back.stop_distance, result.stop_distance);
  EXPECT_TRUE(std::isnan(back.exit_speed));
  EXPECT_EQ(back.gears[1].peak_drag, result.gears[1].peak_drag);
  EXPECT_TRUE(back.gears[1].bottomed);
  EXPECT_EQ(back.energy.at("bed"), result.energy.at("bed"));
  EXPECT_EQ(back.gears[1].failed_by, "vertical");
  EXPECT_EQ(back.coverage[0].speed_above, 0.03);
  EXPECT_EQ(back.coverage[0].penetration_outside, 0.05);
  EXPECT_EQ(back.warnings.front(), "left the table");
  EXPECT_EQ(to_text(back), to_text(result));
  EXPECT_THROW(result_from("0x1p+0|"), InputError);
}

}  // namespace
}  // namespace apc::study
