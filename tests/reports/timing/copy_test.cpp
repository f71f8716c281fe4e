#include "reports/timing/copy.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>

namespace plumb {
namespace {

namespace fs = std::filesystem;

// Folders for temporary files of a test's own.
class TimingCopy : public testing::Test {
 protected:
  TimingCopy() {
    fs::create_directories(folder_);
    setenv("TMPDIR", folder_.c_str(), 1);
    std::ofstream(program_) << "a program";
  }
  ~TimingCopy() override {
    setenv("TMPDIR", usual_.c_str(), 1);
    fs::remove_all(folder_);
  }

  std::set<fs::path> folders() const {
    std::set<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      if (entry.is_directory()) found.insert(entry.path());
    }
    return found;
  }

  fs::path usual_ = fs::temp_directory_path();
  fs::path folder_ = usual_ / ("plumb-copies-" + std::to_string(getpid()));
  fs::path program_ = folder_ / "program";
};

TEST_F(TimingCopy, GoesAwayAgain) {
  {
    const ProgramCopy copy(program_);
    EXPECT_EQ(fs::file_size(copy.path()), fs::file_size(program_));
  }
  EXPECT_TRUE(folders().empty());
}

TEST_F(TimingCopy, NamesWhatCannotBeCopiedAndLeavesNothing) {
  EXPECT_THROW(ProgramCopy(folder_ / "missing"), std::invalid_argument);
  EXPECT_TRUE(folders().empty());
}

TEST_F(TimingCopy, OfAKilledRunGoesWithTheNextOnesBeginning) {
  const pid_t run = fork();
  if (run == 0) {
    const ProgramCopy copy(program_);
    raise(SIGKILL);
  }
  int status = 0;
  ASSERT_EQ(waitpid(run, &status, 0), run);
  ASSERT_TRUE(WIFSIGNALED(status));
  ASSERT_EQ(folders().size(), 1U);
  const ProgramCopy next(program_);
  EXPECT_EQ(folders(), std::set{next.path().parent_path()});
}

TEST_F(TimingCopy, StaysWhileItsRunLives) {
  const ProgramCopy first(program_);
  const ProgramCopy second(program_);
  EXPECT_EQ(folders(), (std::set{first.path().parent_path(), second.path().parent_path()}));
}

}  // namespace
}  // namespace plumb
