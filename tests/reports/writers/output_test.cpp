#include "reports/writers/output.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <fstream>
#include <stdexcept>

namespace plumb::output_test {
namespace {

namespace fs = std::filesystem;

class OutputFolderTest : public ::testing::Test {
 protected:
  OutputFolderTest() { fs::create_directories(root_); }
  ~OutputFolderTest() override { fs::remove_all(root_); }

  std::vector<std::string> files_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder)) names.push_back(entry.path().filename());
    return names;
  }

  fs::path root_ = fs::path(::testing::TempDir()) / ("plumb-output-" + std::to_string(getpid()));
};

TEST_F(OutputFolderTest, IsMadeWithTheFoldersAboveItAndLeftEmpty) {
  const OutputFolder folder(root_ / "a" / "b");
  EXPECT_TRUE(files_in(root_ / "a" / "b").empty());
}

TEST_F(OutputFolderTest, HoldsWholeFilesOnly) {
  const OutputFolder folder(root_);
  const auto written = folder.write({});
  EXPECT_THAT(files_in(root_), ::testing::IsSupersetOf({"report.json", "report.csv"}));
  EXPECT_EQ(files_in(root_).size(), written.files.size());
  for (const auto& skipped : written.skipped) EXPECT_FALSE(skipped.why.empty()) << skipped.file;
}

TEST_F(OutputFolderTest, RefusesWhereAFileStandsInTheWay) {
  std::ofstream(root_ / "file") << "mine";
  EXPECT_THROW(OutputFolder(root_ / "file"), std::invalid_argument);
  EXPECT_THROW(OutputFolder(root_ / "file" / "out"), std::invalid_argument);
  EXPECT_EQ(files_in(root_).size(), 1u);
}

TEST_F(OutputFolderTest, RefusesWhereNothingCanBeWritten) {
  fs::permissions(root_, fs::perms::owner_read | fs::perms::owner_exec);
  // Permissions do not stop root; /proc takes no files from anybody.
  EXPECT_THROW(OutputFolder(geteuid() == 0 ? fs::path("/proc") : root_), std::invalid_argument);
  fs::permissions(root_, fs::perms::owner_all);
}

TEST_F(OutputFolderTest, LeavesNothingBehindWhenAFileCannotTakeItsPlace) {
  const OutputFolder folder(root_);
  fs::create_directories(root_ / "report.csv.part");  // in the way of the temporary file
  EXPECT_THROW(folder.write({}), std::runtime_error);
  EXPECT_THAT(files_in(root_), ::testing::ElementsAre("report.csv.part"));
}

}  // namespace
}  // namespace plumb::output_test
