#include "loadtables/samples.h"

#include <gmock/gmock.h>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "apc/base/units.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace u = units;

const std::string remarks = "# schema: apc-loads/1\n# material: foam\n# tire: T1\n# source: a test\n";
const std::string header = "speed [kt],bed_depth [in],penetration [in],drag [kN],vertical [kN]\n";

SampleSet read(const std::string& text) {
  const synthetic::Folder folder("samples");
  write_text(folder / "loads.csv", text);
  return read_loads_csv(folder / "loads.csv");
}

std::string message(const std::string& text) {
  try {
    read(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LoadSamples, AreReadInSiWhateverTheirUnitsAndOrder) {
  const auto set = read(remarks + "# drag_rms: 0.03\n" +
                        "vertical [lbf],operator,drag [N],speed [m/s],penetration [mm],bed_depth [ft],spin_ratio\n"
                        "1000,7,2000,36,100,1.5,0.9\n");
  ASSERT_EQ(set.samples.size(), 1u);
  const auto& [contact, load] = set.samples.front();
  EXPECT_DOUBLE_EQ(contact.speed, 36.0);
  EXPECT_DOUBLE_EQ(contact.bed_depth, 1.5 * u::ft);
  EXPECT_DOUBLE_EQ(contact.penetration, 0.1);
  EXPECT_DOUBLE_EQ(load.drag, 2000.0);
  EXPECT_DOUBLE_EQ(load.vertical, 1000 * u::lbf);
  EXPECT_DOUBLE_EQ(load.spin_ratio, 0.9);
  EXPECT_TRUE(set.has_spin);
  EXPECT_FALSE(set.has_rut);
  EXPECT_EQ(set.material, "foam");
  EXPECT_EQ(set.tire, "T1");
  EXPECT_DOUBLE_EQ(set.drag_rms, 0.03);
}

TEST(LoadSamples, RowsWithAnEmptyCellAreNoSamples) {
  const auto set = read(remarks + header + "70,18,4,10,20\n70,18,5,,30\n70,18,6,nan,40\n");
  EXPECT_EQ(set.samples.size(), 1u);
}

TEST(LoadSamples, SurviveARoundTrip) {
  const synthetic::Folder folder("round_trip");
  auto set = synthetic::samples(20);
  set.drag_rms = 0.02;
  write_loads_csv(set, folder / "out/loads.csv");
  const auto back = read_loads_csv(folder / "out/loads.csv");
  EXPECT_EQ(back.material, set.material);
  EXPECT_EQ(back.source, set.source);
  EXPECT_DOUBLE_EQ(back.drag_rms, 0.02);
  ASSERT_EQ(back.samples.size(), set.samples.size());
  for (std::size_t i = 0; i < set.samples.size(); ++i) {
    const auto &a = set.samples[i], &b = back.samples[i];
    EXPECT_NEAR(b.contact.speed, a.contact.speed, 1e-8 * a.contact.speed);
    EXPECT_NEAR(b.contact.penetration, a.contact.penetration, 1e-8 * a.contact.penetration);
    EXPECT_NEAR(b.load.drag, a.load.drag, 1e-8 * a.load.drag);
    EXPECT_NEAR(b.load.vertical, a.load.vertical, 1e-8 * a.load.vertical);
    EXPECT_NEAR(b.load.rut_depth, a.load.rut_depth, 1e-8);
    EXPECT_NEAR(b.load.spin_ratio, a.load.spin_ratio, 1e-8);
  }
}

struct Mistake {
  const char *name, *text, *says;
};
class LoadSamplesMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(LoadSamplesMistake, IsRefusedWithFileAndRemedy) {
  EXPECT_THAT(message(GetParam().text), AllOf(HasSubstr("loads.csv"), HasSubstr(GetParam().says)));
}

#define REMARKS "# schema: apc-loads/1\n# material: foam\n# tire: T1\n# source: a test\n"
#define HEADER "speed [kt],bed_depth [in],penetration [in],drag [kN],vertical [kN]\n"
INSTANTIATE_TEST_SUITE_P(
    Each, LoadSamplesMistake,
    ::testing::Values(
        Mistake{"Empty", "", "empty"}, Mistake{"NoSchema", HEADER "70,18,4,10,20\n", "# schema"},
        Mistake{"OtherSchema", "# schema: apc-loads/2\n" HEADER "70,18,4,10,20\n", "apc-loads/1"},
        Mistake{"NoTire", "# schema: apc-loads/1\n# material: foam\n# source: s\n" HEADER "70,18,4,10,20\n", "# tire"},
        Mistake{"NoDrag", REMARKS "speed [kt],bed_depth [in],penetration [in],vertical [kN]\n70,18,4,20\n", "drag"},
        Mistake{"NoUnit", REMARKS "speed,bed_depth [in],penetration [in],drag [kN],vertical [kN]\n70,18,4,10,20\n",
                "a speed is needed"},
        Mistake{"WrongDimension",
                REMARKS "speed [kt],bed_depth [psi],penetration [in],drag [kN],vertical [kN]\n70,18,4,10,20\n",
                "bed_depth"},
        Mistake{"ShortRow", REMARKS HEADER "70,18,4,10\n", "line 6"},
        Mistake{"NotANumber", REMARKS HEADER "70,18,4,ten,20\n", "ten"},
        Mistake{"Infinite", REMARKS HEADER "70,18,4,inf,20\n", "finite"},
        Mistake{"NegativeSpeed", REMARKS HEADER "-70,18,4,10,20\n", "negative"},
        Mistake{"AbsurdSpeed", REMARKS HEADER "7000,18,4,10,20\n", "unit"},
        Mistake{"NegativeDepth", REMARKS HEADER "70,-18,4,10,20\n", "bed_depth"},
        Mistake{"AbsurdDepth", REMARKS HEADER "70,1800,4,10,20\n", "unit"},
        Mistake{"NegativePenetration", REMARKS HEADER "70,18,-4,10,20\n", "penetration"},
        Mistake{"NegativeDrag", REMARKS HEADER "70,18,4,-10,20\n", "drag"},
        Mistake{"NegativeVertical", REMARKS HEADER "70,18,4,10,-20\n", "vertical"},
        Mistake{"NoRows", REMARKS HEADER, "no complete sample"},
        Mistake{"BadRms", REMARKS "# drag_rms: lots\n" HEADER "70,18,4,10,20\n", "drag_rms"}),
    [](const auto& test) { return test.param.name; });

}  // namespace
}  // namespace apc::loadtables
