#include "loadtables/find_tables.h"

#include <gmock/gmock.h>

#include <fstream>

#include "apc/base/file.h"
#include "apc/base/require.h"
#include "tests/unit/loadtables/synthetic_tire.h"

namespace apc::loadtables {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class TableFolder : public ::testing::Test {
 protected:
  synthetic::Folder folder{"find"};
  std::string message(const std::string& material, const std::string& tire) {
    auto wanted = synthetic::tire();
    wanted.name = tire;
    try {
      find_table(folder.path(), material, wanted);
    } catch (const InputError& error) {
      return error.what();
    }
    return "found";
  }
};

TEST_F(TableFolder, FindsATableByItsNameAndByItsContent) {
  save_table(synthetic::table(), folder / table_file_name("T40x14", "made_up_foam"));
  EXPECT_EQ(find_table(folder.path(), "made_up_foam", synthetic::tire()).tire().name, "T40x14");
  std::filesystem::rename(folder / "T40x14_made_up_foam.h5", folder / "whatever.h5");
  EXPECT_EQ(find_table(folder.path(), "made_up_foam", synthetic::tire()).tire().name, "T40x14");
  EXPECT_EQ(list_tables(folder / "whatever.h5").size(), 1u);
}

TEST_F(TableFolder, FitsExchangeFilesOnTheSpot) {
  write_loads_csv(synthetic::samples(), folder / "loads_main.csv");
  write_text(folder / "notes.csv", "a,b\n1,2\n");
  write_text(folder / "readme.txt", "tables");
  const auto table = find_table(folder.path(), "made_up_foam", synthetic::tire());
  EXPECT_EQ(table.provenance().runs, 70);
  EXPECT_EQ(table.quality().size(), 4u);
  EXPECT_EQ(list_tables(folder.path()).size(), 1u);
}

TEST_F(TableFolder, NamesWhatThereIsWhenSomethingIsMissing) {
  EXPECT_THAT(message("made_up_foam", "T40x14"), HasSubstr("no load table"));
  write_loads_csv(synthetic::samples(), folder / "loads_main.csv");
  EXPECT_THAT(message("made_up_foan", "T40x14"),
              AllOf(HasSubstr("made_up_foan"), HasSubstr("Did you mean \"made_up_foam\"")));
  EXPECT_THAT(message("made_up_foam", "T40x15"), AllOf(HasSubstr("T40x15"), HasSubstr("T40x14")));
  EXPECT_THROW(list_tables(folder / "absent"), InputError);
}

TEST_F(TableFolder, ADamagedTableIsCalledDamagedNotMissing) {
  save_table(synthetic::table(), folder / table_file_name("T40x14", "made_up_foam"));
  const auto whole = read_text(folder / "T40x14_made_up_foam.h5");
  std::ofstream(folder / "T40x14_made_up_foam.h5", std::ios::binary) << whole.substr(0, whole.size() / 2);
  EXPECT_THAT(message("made_up_foam", "T40x14"), HasSubstr("damaged"));
}

}  // namespace
}  // namespace apc::loadtables
