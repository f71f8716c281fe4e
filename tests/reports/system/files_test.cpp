#include "reports/system/files.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>

namespace plumb::files_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class NewFileIn : public ::testing::Test {
 protected:
  NewFileIn() { fs::create_directories(folder_); }
  ~NewFileIn() override { fs::remove_all(folder_); }

  std::string at(const char* name) const { return (folder_ / name).string(); }

  fs::path folder_ = fs::path(::testing::TempDir()) / ("plumb-files-" + std::to_string(getpid()));
};

void write(const std::string& place, const std::string& text) {
  NewFile file(place);
  file.write_all(text);
  file.put_in_place();
}

TEST_F(NewFileIn, ReplacesTheTargetOfALinkEvenWhereThereIsNoneYet) {
  fs::create_symlink("target", at("link"));
  write(at("link"), "one");
  write(at("link"), "another");
  EXPECT_TRUE(fs::is_symlink(at("link")));
  EXPECT_EQ(read_text(at("target"), 100), "another");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 2) << "nothing else is left";
}

TEST_F(NewFileIn, RefusesACircleOfLinks) {
  fs::create_symlink("b", at("a"));
  fs::create_symlink("a", at("b"));
  EXPECT_THROW(NewFile(fs::path(at("a"))), FileError);
}

TEST_F(NewFileIn, WritesToADeviceAndLeavesItThere) {
  write("/dev/null", "text");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  try {
    write("/dev/full", "text");
    ADD_FAILURE();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full: cannot be written: No space left"));
  }
}

TEST(CsvField, IsNeverAFormula) {
  EXPECT_EQ(csv_field(std::string("=HYPERLINK(1)")), "'=HYPERLINK(1)");
  EXPECT_EQ(csv_field(std::string("@a,b")), "\"'@a,b\"");
  EXPECT_EQ(csv_field(std::string("a=b")), "a=b");
  EXPECT_EQ(csv_field(-1.5), "-1.5");
}

}  // namespace
}  // namespace plumb::files_test
