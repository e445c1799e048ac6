#include "apc/bed/bed.h"

#include <gmock/gmock.h>

#include <unistd.h>

#include <filesystem>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"

namespace apc::bed {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;
namespace u = units;

constexpr const char* good = R"({
  "schema": "apc-bed/1", "name": "ramp and plateau", "source": "made for this test",
  "setback": "50 ft", "width": "150 ft", "material": "foam_50psi", "flush": "top",
  "profile": { "distance": {"unit": "ft", "values": [0, 50, 400]}, "depth": {"unit": "in", "values": [0, 18, 18]} },
  "blocks": { "length": "4 ft", "width": "2 ft" }, "grade": 0.01,
  "nominal": { "strength": "50 psi", "density": "320 kg/m^3", "bottoming_strain": 0.85 }, "built": "2019-03-01"
})";

class BedFile : public ::testing::Test {
 protected:
  fs::path folder = fs::temp_directory_path() / ("apc_bed_" + std::to_string(::getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }

  Bed load(const std::string& text) {
    write_text(folder / "bed.json", text);
    return load_bed(folder / "bed.json");
  }
  /// The good bed with one piece of text replaced.
  std::string altered(const std::string& from, const std::string& to) {
    std::string text = good;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
  }
  std::string message(const std::string& text) {
    try {
      load(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(BedFile, IsReadInSi) {
  const auto bed = load(good);
  EXPECT_EQ(bed.name, "ramp and plateau");
  EXPECT_EQ(bed.material, "foam_50psi");
  EXPECT_DOUBLE_EQ(bed.setback, 50 * u::ft);
  EXPECT_DOUBLE_EQ(bed.width, 150 * u::ft);
  EXPECT_DOUBLE_EQ(bed.length(), 400 * u::ft);
  EXPECT_DOUBLE_EQ(bed.block_length, 4 * u::ft);
  EXPECT_DOUBLE_EQ(bed.block_width, 2 * u::ft);
  EXPECT_DOUBLE_EQ(bed.grade, 0.01);
  ASSERT_TRUE(bed.nominal.has_value());
  EXPECT_DOUBLE_EQ(bed.nominal->strength, 50 * u::psi);
  EXPECT_DOUBLE_EQ(bed.nominal->bottoming_strain, 0.85);
  EXPECT_EQ(bed.built, "2019-03-01");
}

TEST_F(BedFile, OptionalPartsMayBeLeftOut) {
  const auto bed = load(R"({"schema": "apc-bed/1", "name": "n", "source": "s", "setback": "0 m", "width": "40 m",
    "material": "foam", "profile": {"distance": ["0 m", "90 m"], "depth": ["9 in", "24 in"]}})");
  EXPECT_EQ(bed.flush, Flush::top);
  EXPECT_EQ(bed.block_length, 0.0);
  EXPECT_FALSE(bed.nominal.has_value());
  EXPECT_TRUE(bed.built.empty());
  EXPECT_DOUBLE_EQ(bed.depth_at(0.0), 9 * u::in);  // a step front
}

TEST_F(BedFile, DepthIsLinearBetweenPointsAndZeroOutside) {
  const auto bed = load(good);
  EXPECT_DOUBLE_EQ(bed.depth_at(25 * u::ft), 9 * u::in);
  EXPECT_DOUBLE_EQ(bed.depth_at(200 * u::ft), 18 * u::in);
  EXPECT_DOUBLE_EQ(bed.depth_at(bed.length()), 18 * u::in);
  EXPECT_EQ(bed.depth_at(-0.001), 0.0);
  EXPECT_EQ(bed.depth_at(bed.length() + 0.001), 0.0);
  EXPECT_DOUBLE_EQ(bed.depth_slope_at(10 * u::ft), 18 * u::in / (50 * u::ft));
  EXPECT_EQ(bed.depth_slope_at(60 * u::ft), 0.0);
  EXPECT_EQ(bed.depth_slope_at(-1.0), 0.0);
  EXPECT_DOUBLE_EQ(bed.maximum_depth(), 18 * u::in);
}

TEST_F(BedFile, VolumeIsTheSectionTimesTheWidth) {
  const auto bed = load(good);
  const double section = 0.5 * 50 * u::ft * 18 * u::in + 350 * u::ft * 18 * u::in;
  EXPECT_NEAR(bed.volume(), section * 150 * u::ft, 1e-9 * bed.volume());
}

TEST_F(BedFile, RaisedBedsRiseAndRecessedBedsStayLevel) {
  auto bed = load(good);
  EXPECT_EQ(bed.top_at(100 * u::ft), 0.0);
  bed = load(altered(R"("flush": "top")", R"("flush": "base")"));
  EXPECT_EQ(bed.flush, Flush::base);
  EXPECT_DOUBLE_EQ(bed.top_at(25 * u::ft), 9 * u::in);
}

struct Mistake {
  const char *name, *from, *to, *place, *says;
};

class BedMistake : public BedFile, public ::testing::WithParamInterface<Mistake> {};

TEST_P(BedMistake, IsRefusedWithItsPlaceAndARemedy) {
  const auto& mistake = GetParam();
  EXPECT_THAT(message(altered(mistake.from, mistake.to)),
              AllOf(HasSubstr("bed.json"), HasSubstr(mistake.place), HasSubstr(mistake.says)));
}

INSTANTIATE_TEST_SUITE_P(
    Each, BedMistake,
    ::testing::Values(
        Mistake{"Schema", "apc-bed/1", "apc-bed/2", "/schema", "apc-bed/1"},
        Mistake{"MissingSource", R"("source": "made for this test",)", "", "/source", "missing"},
        Mistake{"MisspeltKey", R"("setback")", R"("setbak")", "/setback", "setbak"},
        Mistake{"UnknownKey", R"("grade": 0.01)", R"("grade": 0.01, "colour": 3)", "/colour", "unknown key"},
        Mistake{"UnknownInnerKey", R"("width": "2 ft")", R"("width": "2 ft", "height": "1 ft")", "/blocks/height",
                "unknown key"},
        Mistake{"BareNumber", R"("setback": "50 ft")", R"("setback": 50)", "/setback", "has no unit"},
        Mistake{"WrongDimension", R"("width": "150 ft")", R"("width": "150 psi")", "/width", "a length is needed"},
        Mistake{"UnknownUnit", R"("unit": "in")", R"("unit": "inches")", "/profile/depth/unit", "inches"},
        Mistake{"NegativeSetback", R"("setback": "50 ft")", R"("setback": "-50 ft")", "/setback", "negative"},
        Mistake{"FarSetback", R"("setback": "50 ft")", R"("setback": "50 km")", "/setback", "unit"},
        Mistake{"ZeroWidth", R"("width": "150 ft")", R"("width": "0 ft")", "/width", "not positive"},
        Mistake{"AbsurdWidth", R"("width": "150 ft")", R"("width": "150 km")", "/width", "unit"},
        Mistake{"UnknownFlush", R"("flush": "top")", R"("flush": "bottom")", "/flush", "\"base\""},
        Mistake{"UnequalLengths", "[0, 18, 18]", "[0, 18]", "/profile/depth", "2 values"},
        Mistake{"OnePoint", "[0, 50, 400]}, \"depth\": {\"unit\": \"in\", \"values\": [0, 18, 18]",
                "[0]}, \"depth\": {\"unit\": \"in\", \"values\": [18]", "/profile/distance", "at least"},
        Mistake{"StartNotZero", "[0, 50, 400]", "[10, 50, 400]", "/profile/distance/values/0", "10 is not 0"},
        Mistake{"NotIncreasing", "[0, 50, 400]", "[0, 50, 50]", "/profile/distance/values/2", "does not increase"},
        Mistake{"AbsurdLength", "[0, 50, 400]", "[0, 50, 40000]", "/profile/distance", "unit"},
        Mistake{"NegativeDepth", "[0, 18, 18]", "[0, 18, -18]", "/profile/depth/values/2", "-18 is negative"},
        Mistake{"AbsurdDepth", "[0, 18, 18]", "[0, 180, 18]", "/profile/depth/values/1", "Check the unit"},
        Mistake{"NoDepth", "[0, 18, 18]", "[0, 0, 0]", "/profile/depth", "pavement"},
        Mistake{"NanDepth", "[0, 18, 18]", "[0, NaN, 18]", "", "not JSON"},
        Mistake{"TextDepth", "[0, 18, 18]", "[0, \"nan\", 18]", "/profile/depth/values/1", "not a finite number"},
        Mistake{"InfiniteDepth", "[0, 18, 18]", "[0, 1e999, 18]", "", "not JSON"},
        Mistake{"NanQuantity", R"("setback": "50 ft")", R"("setback": "nan ft")", "/setback", "finite"},
        Mistake{"SteepGrade", "0.01", "1.0", "/grade", "0.01"},
        Mistake{"ZeroBlock", R"("length": "4 ft")", R"("length": "0 ft")", "/blocks/length", "not positive"},
        Mistake{"ZeroStrength", R"("50 psi")", R"("0 psi")", "/nominal/strength", "50 psi"},
        Mistake{"AbsurdDensity", "320 kg/m^3", "320 t/m^3", "/nominal/density", "320 kg/m^3"},
        Mistake{"StrainInPercent", "0.85", "85", "/nominal/bottoming_strain", "between 0 and 1"},
        Mistake{"NotADate", "2019-03-01", "March 2019", "/built", "2019-03-01"},
        Mistake{"ImpossibleDate", "2019-03-01", "2019-13-01", "/built", "year-month-day"}),
    [](const auto& test) { return test.param.name; });

TEST_F(BedFile, EmptyFileAndNoJsonAreSaidSo) {
  EXPECT_THAT(message(""), HasSubstr("empty"));
  EXPECT_THAT(message("depth = 18 in"), HasSubstr("not JSON"));
  EXPECT_THAT(message("[1, 2]"), HasSubstr("not an object"));
  EXPECT_THROW(load_bed(folder / "absent.json"), InputError);
}

TEST(ShippedBeds, AllLoadAndNameTheirSource) {
  std::size_t count = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(PROJECT_DIR) / "designs/beds")) {
    const auto bed = load_bed(entry.path());
    EXPECT_GT(bed.source.size(), 20u) << entry.path();
    EXPECT_TRUE(bed.nominal.has_value()) << entry.path();
    ++count;
  }
  EXPECT_GE(count, 4u);
}

}  // namespace
}  // namespace apc::bed
