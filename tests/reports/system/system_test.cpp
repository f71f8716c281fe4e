#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "reports/system/files.h"
#include "reports/system/hash.h"
#include "reports/system/jobs.h"
#include "reports/system/processes.h"
#include "reports/system/terminal.h"

namespace plumb::system_test {
namespace {

using ::testing::HasSubstr;

// FIPS 180-2, appendix B.
TEST(Sha256, MatchesTheStandardsExamples) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1'000'000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, CountsZeroBytes) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_NE(sha256(""), sha256(std::string(1, '\0')));
}

// The offset basis of FNV-1a with 64 bits.
TEST(BitHash, DependsOnEveryBitAndOnTheOrder) {
  EXPECT_EQ(BitHash().value(), 0xcbf29ce484222325U);
  const auto hash_of_two = [](double a, double b) {
    BitHash hash;
    hash.add(a);
    hash.add(b);
    return hash.value();
  };
  EXPECT_NE(hash_of_two(1, 2), hash_of_two(2, 1));
  EXPECT_NE(hash_of_two(0.0, 0), hash_of_two(-0.0, 0));
}

TEST(DoAll, CallsEachIndexOnceForAnyNumberOfJobs) {
  for (const int jobs : {1, 2, 7}) {
    std::vector<std::atomic<int>> calls(100);
    do_all(calls.size(), jobs, [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls) EXPECT_EQ(count, 1);
  }
}

TEST(DoAll, FinishesAllAndRethrowsTheExceptionOfTheLowestIndex) {
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t i) {
    ++done;
    if (i == 3 || i == 8) throw std::runtime_error(i == 3 ? "three" : "eight");
  };
  try {
    do_all(20, 2, work);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "three");
  }
  EXPECT_EQ(done, 20);
}

TEST(DoAll, CallsNothingForACountOfZero) {
  do_all(0, 4, [](std::size_t) { FAIL(); });
}

TEST(FindProgram, SearchesPath) {
  ASSERT_TRUE(find_program("sh"));
  EXPECT_EQ(find_program("sh")->filename(), "sh");
  EXPECT_FALSE(find_program("no-such-program-of-anybodys"));
}

TEST(RunProgram, ReturnsTheExitCodeOrTheSignal) {
  EXPECT_EQ(run_program({"sh", "-c", "exit 3"}), 3);
  EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}), 128 + 9);
  EXPECT_EQ(run_program({"no-such-program-of-anybodys"}), 127);
}

TEST(RunProgram, PassesArgumentsUnchanged) { EXPECT_EQ(run_program({"test", "a b; exit 1", "=", "a b; exit 1"}), 0); }

TEST(OutputOf, IsStandardOutputWithoutTheLastLineBreak) {
  EXPECT_EQ(output_of({"sh", "-c", "echo one; echo two; echo lost >&2"}), "one\ntwo");
  EXPECT_EQ(output_of({"true"}), "");
}

TEST(OutputOf, IsNothingIfTheProgramFails) {
  EXPECT_FALSE(output_of({"sh", "-c", "echo one; exit 1"}));
  EXPECT_FALSE(output_of({"no-such-program-of-anybodys"}));
}

TEST(StartProgram, ReturnsWhetherItStarted) {
  EXPECT_TRUE(start_program({"true"}));
  EXPECT_FALSE(start_program({"no-such-program-of-anybodys"}));
}

TEST(LogPace, HasALineInThirtySeconds) {
  LogPace pace(LogPace::interval);
  EXPECT_FALSE(pace.due(0));
  EXPECT_FALSE(pace.due(29));
  EXPECT_TRUE(pace.due(31));
  EXPECT_FALSE(pace.due(60));
  EXPECT_TRUE(pace.due(61));
}

std::string logged(ProgressLine::Kind kind) {
  ::testing::internal::CaptureStderr();
  {
    const ProgressLine line(kind);
    line.show("[0/9] bounce\033[2J");
    line.show("[1/9] slope");
  }
  return ::testing::internal::GetCapturedStderr();
}

TEST(ProgressLine, LogsTheStartAndTheEndOfALongRunOnly) {
  EXPECT_EQ(logged(ProgressLine::Kind::long_run), "[0/9] bounce?[2J\ndone in 0 s\n");
  EXPECT_EQ(logged(ProgressLine::Kind::usual), "");
  EXPECT_EQ(logged(ProgressLine::Kind::quiet), "");
}

namespace fs = std::filesystem;

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
}  // namespace plumb::system_test
