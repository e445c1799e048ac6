#include <gmock/gmock.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "apc/base/file.h"
#include "apc/base/hdf5.h"
#include "apc/base/require.h"

namespace apc {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Files : public ::testing::Test {
 protected:
  fs::path folder = fs::temp_directory_path() / ("apc_files_" + std::to_string(getpid()));
  void SetUp() override { fs::create_directories(folder); }
  void TearDown() override { fs::remove_all(folder); }
  template <class Call>
  std::string refusal(const Call& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }
  std::size_t entries() { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {})); }
};

TEST_F(Files, AreWrittenWholeWithTheirFolders) {
  write_text(folder / "a/b/c.txt", "text");
  EXPECT_EQ(read_text(folder / "a/b/c.txt"), "text");
  write_text(folder / "a/b/c.txt", "other");
  EXPECT_EQ(read_text(folder / "a/b/c.txt"), "other");
}

TEST_F(Files, AFailedWriteLeavesNothingAndKeepsTheOld) {
  write_text(folder / "kept.txt", "old");
  EXPECT_THROW(write_atomically(folder / "kept.txt",
                                [](const fs::path& part) {
                                  std::ofstream(part) << "half";
                                  throw InputError("stopped");
                                }),
               InputError);
  EXPECT_EQ(read_text(folder / "kept.txt"), "old");
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, SeveralWritersOfOnePathLeaveOneWholeFile) {
  std::atomic<int> refused{0};
  const auto writer = [&](char letter) {
    for (int i = 0; i < 200; ++i) try {
        write_text(folder / "shared.txt", std::string(1000, letter));
      } catch (const InputError&) {
        ++refused;
      }
  };
  std::thread one(writer, 'a'), two(writer, 'b');
  one.join();
  two.join();
  EXPECT_EQ(refused, 0);
  EXPECT_THAT(read_text(folder / "shared.txt"), AnyOf(std::string(1000, 'a'), std::string(1000, 'b')));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, MissingOnesAndFoldersAreRefused) {
  EXPECT_THAT(refusal([&] { read_text(folder / "absent"); }), HasSubstr("no such file"));
  EXPECT_THAT(refusal([&] { read_text(folder); }), HasSubstr("is a folder"));
  write_text(folder / "file", "");
  EXPECT_THAT(refusal([&] { write_text(folder / "file/below", "x"); }), HasSubstr("file/below"));
}

TEST_F(Files, ShippedNamesResolveAndMisspeltOnesAreHelped) {
  const auto bed = resolve("emas_18in_50psi", "designs/beds", "bed");
  EXPECT_TRUE(fs::exists(bed));
  EXPECT_EQ(resolve(bed.string(), "designs/beds", "bed"), bed);
  EXPECT_THAT(refusal([] { resolve("emas_18in_50psy", "designs/beds", "bed"); }),
              AllOf(HasSubstr("no such bed"), HasSubstr("Did you mean \"emas_18in_50psi\"")));
  EXPECT_THAT(refusal([] { resolve("", "designs/beds", "bed"); }), HasSubstr("empty"));
  EXPECT_THAT(refusal([&] { resolve(folder.string(), "designs/beds", "bed"); }), HasSubstr("is a folder"));
}

TEST_F(Files, TheTireLibraryIsNoAircraft) {
  EXPECT_THAT(shipped_names("aircraft/data"),
              AllOf(::testing::Contains("B737-800"), ::testing::Not(::testing::Contains("tires"))));
  EXPECT_THAT(refusal([] { resolve("tyres", "aircraft/data", "aircraft"); }),
              AllOf(HasSubstr("no such aircraft"), HasSubstr("B737-800"), ::testing::Not(HasSubstr("tires"))));
}

TEST_F(Files, Hdf5GivesBackArraysTextsAndNumbers) {
  const auto path = folder / "x.h5";
  save_hdf5(path, [](Hdf5Writer& file) {
    file.array("group/matrix", Array{{2, 3}, {1, 2, 3, 4, 5, 6}}, "N");
    file.floats("group/floats", {0.5f, 1.5f}, "m");
    file.integers("counts", {1, 2, 3});
    file.attribute("/", "schema", "test/1");
    file.attribute("group", "number", 2.5);
  });
  const Hdf5Reader file(path);
  EXPECT_THAT(file.array("group/matrix").shape, ElementsAre(2, 3));
  EXPECT_THAT(file.array("group/matrix").values, ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_THAT(file.floats("group/floats"), ElementsAre(0.5f, 1.5f));
  EXPECT_THAT(file.integers("counts"), ElementsAre(1, 2, 3));
  EXPECT_EQ(file.text("/", "schema"), "test/1");
  EXPECT_EQ(file.text("group/matrix", "unit"), "N");
  EXPECT_EQ(file.number("group", "number"), 2.5);
  EXPECT_TRUE(file.has("group/matrix"));
  EXPECT_FALSE(file.has("group/absent"));
  EXPECT_FALSE(file.has("absent/matrix"));
  EXPECT_THAT(file.members("group"), ElementsAre("floats", "matrix"));
  EXPECT_EQ(entries(), 1u);
}

TEST_F(Files, Hdf5AttributesMakeTheGroupsTheyNeed) {
  save_hdf5(folder / "deep.h5", [](Hdf5Writer& file) { file.attribute("fit/drag", "rms", 0.25); });
  EXPECT_EQ(Hdf5Reader(folder / "deep.h5").number("fit/drag", "rms"), 0.25);
}

TEST_F(Files, Hdf5RefusesTruncatedForeignAndIncompleteFiles) {
  const auto path = folder / "x.h5";
  save_hdf5(path, [](Hdf5Writer& file) { file.array("x", std::vector<double>(5000, 1.0), "m"); });
  const auto whole = read_text(path);
  std::ofstream(folder / "cut.h5", std::ios::binary) << whole.substr(0, whole.size() / 2);
  write_text(folder / "text.h5", "no HDF5");
  EXPECT_THAT(refusal([&] { Hdf5Reader(folder / "cut.h5").array("x"); }), HasSubstr("cut.h5"));
  EXPECT_THAT(refusal([&] { const Hdf5Reader file(folder / "text.h5"); }), HasSubstr("not an HDF5 file"));
  EXPECT_THAT(refusal([&] { const Hdf5Reader file(folder / "absent.h5"); }), HasSubstr("no such file"));
  EXPECT_THAT(refusal([&] { Hdf5Reader(path).array("y"); }), HasSubstr("holds no \"y\""));
  EXPECT_THAT(refusal([&] { Hdf5Reader(path).text("/", "schema"); }), HasSubstr("schema"));
}

TEST_F(Files, AFailedHdf5WriteLeavesNothing) {
  EXPECT_THROW(save_hdf5(folder / "x.h5",
                         [](Hdf5Writer& file) {
                           file.array("x", std::vector<double>{1.0}, "m");
                           throw Interrupted();
                         }),
               Interrupted);
  EXPECT_EQ(entries(), 0u);
}

}  // namespace
}  // namespace apc
