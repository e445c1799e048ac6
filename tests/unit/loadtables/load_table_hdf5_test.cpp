#include <gmock/gmock.h>

#include <fstream>

#include "apc/base/file.h"
#include "apc/base/hdf5.h"
#include "apc/base/require.h"
#include "loadtables/load_table_data.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class TableFiles : public ::testing::Test {
 protected:
  synthetic::Folder folder{"tables"};
  fs::path file = folder / "table.h5";

  std::string message(const fs::path& path) {
    try {
      load_table(path);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
};

TEST_F(TableFiles, GiveBackTheTableBitForBit) {
  const auto table = synthetic::table();
  save_table(table, file);
  const auto back = load_table(file);
  for (const double speed : {0.0, 17.0, 36.0})
    for (const double depth : {0.0, 0.1, 0.7})
      for (const double penetration : {0.01, 0.1, 0.3, 0.9}) {
        const auto a = table.load({speed, depth, penetration}), b = back.load({speed, depth, penetration});
        EXPECT_NEAR(a.drag, b.drag, 1e-10 * a.drag);
        EXPECT_NEAR(a.vertical, b.vertical, 1e-10 * a.vertical);
        EXPECT_NEAR(a.spin_ratio, b.spin_ratio, 1e-12);
      }
  EXPECT_EQ(back.data().coefficients, table.data().coefficients);
  EXPECT_EQ(back.provenance().material, "made_up_foam");
  EXPECT_EQ(back.provenance().source, "closed form");
  EXPECT_EQ(back.provenance().date, "2020-01-01");
  EXPECT_EQ(back.provenance().refused, 3);
  EXPECT_DOUBLE_EQ(back.provenance().spacing, 0.05);
  EXPECT_EQ(back.tire().name, "T40x14");
  EXPECT_EQ(back.tire().curve_load, table.tire().curve_load);
  ASSERT_EQ(back.quality().size(), 4u);
  EXPECT_DOUBLE_EQ(back.quality()[1].loo_rms_relative, table.quality()[1].loo_rms_relative);
  EXPECT_EQ(back.depth_range(), table.depth_range());
}

TEST_F(TableFiles, KeepTheSamplesSoThatATableCanBeRefitted) {
  const auto table = synthetic::table();
  save_table(table, file);
  const auto back = load_table(file);
  const auto& samples = back.data().samples;
  ASSERT_EQ(samples.samples.size(), 70u);
  EXPECT_TRUE(samples.has_rut && samples.has_spin);
  const auto again = fit(samples, table.tire(), table.provenance());
  EXPECT_EQ(again.data().coefficients, table.data().coefficients);
}

TEST_F(TableFiles, CarryAUnitOnEveryDataset) {
  save_table(synthetic::table(), file);
  const Hdf5Reader reader(file);
  for (const std::string path : {"coefficients", "axes/speed", "tire/curve_load", "samples/drag", "range/bed_depth"})
    EXPECT_FALSE(reader.text(path, "unit").empty()) << path;
  EXPECT_EQ(reader.text("/", "schema"), "apc-load-table/1");
}

TEST_F(TableFiles, TruncatedOnesAreRefused) {
  save_table(synthetic::table(), file);
  const auto whole = read_text(file);
  for (const double share : {0.02, 0.5, 0.97}) {
    std::ofstream(folder / "cut.h5", std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())));
    EXPECT_THAT(message(folder / "cut.h5"), HasSubstr("cut.h5")) << share;
  }
}

TEST_F(TableFiles, ForeignOnesAreRefused) {
  write_text(folder / "text.h5", "not HDF5 at all");
  EXPECT_THAT(message(folder / "text.h5"), AllOf(HasSubstr("text.h5"), HasSubstr("HDF5")));
  save_hdf5(folder / "other.h5", [](Hdf5Writer& writer) { writer.array("x", std::vector<double>{1.0}, "m"); });
  EXPECT_THAT(message(folder / "other.h5"), AllOf(HasSubstr("names no schema"), HasSubstr("apc loads")));
  EXPECT_THAT(message(folder / "absent.h5"), HasSubstr("no such file"));
}

TEST_F(TableFiles, OfAnotherVersionAreRefused) {
  save_hdf5(file, [](Hdf5Writer& writer) { writer.attribute("/", "schema", "apc-load-table/2"); });
  EXPECT_THAT(message(file), AllOf(HasSubstr("apc-load-table/2"), HasSubstr("apc-load-table/1")));
}

TEST_F(TableFiles, WithPartsMissingAreRefused) {
  save_hdf5(file, [](Hdf5Writer& writer) {
    writer.attribute("/", "schema", "apc-load-table/1");
    for (const char* name : {"material", "tire", "source", "command", "date", "version"})
      writer.attribute("/", name, "x");
    for (const char* name : {"friction", "spacing_m", "runs", "refused"}) writer.attribute("/", name, 0.0);
  });
  EXPECT_THAT(message(file), HasSubstr("axes/speed"));
}

}  // namespace
}  // namespace apc::loadtables
