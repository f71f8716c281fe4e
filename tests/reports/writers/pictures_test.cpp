#include "reports/writers/pictures.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "sample.h"

namespace plumb::pictures_test {
namespace {

using ::testing::HasSubstr;

TEST(Preview, ShowsEveryRunOfACaseInRealTime) {
  const Report report = sample_report();
  const RunRecord& first = report.runs.front();
  const Preview preview = preview_of(report);
  const double seconds = std::min(Preview::longest, first.trace->times().back());
  EXPECT_EQ(preview.frames.size(), static_cast<std::size_t>(seconds * Preview::rate) + 1);
  for (const std::string& frame : preview.frames) {
    EXPECT_THAT(frame, ::testing::StartsWith("<svg "));
    EXPECT_THAT(frame, ::testing::EndsWith("</svg>"));
    EXPECT_THAT(frame, ::testing::Not(HasSubstr("nan")));
  }
}

TEST(Preview, LetsNoNameBreakOut) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) run.variant = "<script>";
  const Preview preview = preview_of(report);
  EXPECT_THAT(preview.frames.front(), ::testing::Not(HasSubstr("<script")));
  EXPECT_THAT(preview.frames.front(), HasSubstr("script"));
}

TEST(Preview, SaysWhyThereIsNothingToShow) {
  Report report = sample_report();
  for (RunRecord& run : report.runs) {
    run.status = Status::not_supported;
    run.reason = "has no wheels";
  }
  try {
    preview_of(report);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr(report.runs.front().variant));
    EXPECT_THAT(error.what(), HasSubstr("has no wheels"));
    EXPECT_THAT(error.what(), HasSubstr("another case"));
  }
}

TEST(Preview, NeedsFfmpegAndSaysSo) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/none", 1);
  try {
    check_preview();
    ADD_FAILURE();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("apt-get install ffmpeg"));
  }
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "preview.gif";
  EXPECT_THROW(write_preview({{"<svg/>"}}, file), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(file));
  setenv("PATH", path.c_str(), 1);
}

}  // namespace
}  // namespace plumb::pictures_test
