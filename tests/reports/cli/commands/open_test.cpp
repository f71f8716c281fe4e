#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "scene_files.h"

namespace plumb::open_test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class Open : public SceneFiles {
 protected:
  Open() {
    desktop(nullptr);
    path_ = std::getenv("PATH");
  }
  ~Open() override {
    desktop(nullptr);
    setenv("PATH", path_.c_str(), 1);
  }

  static void desktop(const char* display) {
    unsetenv("WAYLAND_DISPLAY");
    if (display != nullptr) {
      setenv("DISPLAY", display, 1);
    } else {
      unsetenv("DISPLAY");
    }
  }

  // Stands in for the desktop's: notes what it is asked to open.
  void stand_in() const {
    const std::string program =
        put("xdg-open", "#!/bin/sh\nprintf %s \"$1\" > \"$0.part\" && mv \"$0.part\" \"$0.asked\"\n");
    fs::permissions(program, fs::perms::owner_all);
    setenv("PATH", (folder_.string() + ":" + path_).c_str(), 1);
  }

  std::string asked() const {
    // At most for five minutes: a busy machine takes seconds to start a program.
    for (int tries = 0; tries < 30'000 && !fs::exists(at("xdg-open.asked")); ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    std::ostringstream text;
    text << std::ifstream(at("xdg-open.asked")).rdbuf();
    return text.str();
  }

  std::string path_;
};

TEST_F(Open, PrintsWhereThePageIsWithoutADesktop) {
  put("index.html", "");
  stand_in();
  const Said said = say({"open", folder_.string()});
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(said.out, at("index.html") + "\n");
  EXPECT_FALSE(fs::exists(at("xdg-open.asked")));
}

TEST_F(Open, OpensItWhereThereIsADesktop) {
  put("index.html", "");
  stand_in();
  desktop(":0");
  EXPECT_EQ(say({"open", folder_.string()}).code, 0);
  EXPECT_EQ(asked(), at("index.html"));
}

TEST_F(Open, DoesNotFailWhereNothingCanOpenIt) {
  put("index.html", "");
  desktop(":0");
  setenv("PATH", at("none").c_str(), 1);
  const Said said = say({"open", folder_.string()});
  EXPECT_EQ(said.code, 0);
  EXPECT_EQ(said.err, "");
}

TEST_F(Open, FindsAStudysPage) {
  put("study-speed.html", "");
  EXPECT_EQ(say({"open", folder_.string()}).out, at("study-speed.html") + "\n");
  put("study-model.html", "");
  EXPECT_EQ(say({"open", at("study-model.html")}).out, at("study-model.html") + "\n");
  const Said said = say({"open", folder_.string()});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("study-model.html, study-speed.html; name one"));
}

TEST_F(Open, ExitsWith2AndTheCureWhereThereIsNoPage) {
  const Said said = say({"open", folder_.string()});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("plumb report --out"));
  EXPECT_EQ(say({"open", at("nowhere")}).code, 2);
  EXPECT_THAT(say({"open", put("report.json", "{}")}).err, HasSubstr("is not a page"));
}

}  // namespace
}  // namespace plumb::open_test
