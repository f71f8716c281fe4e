#include "reports/find/judge.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <nlohmann/json.hpp>

#include "reports/find/isolated.h"
#include "reports/run/horizon.h"
#include "reports/run/scene_file.h"
#include "scenarios/catalog.h"
#include "scenarios/parts.h"

namespace plumb::find_judge_test {
namespace {

TEST(FindJudge, RaisesNoAlarmForClosedFormsInTheScenesTheyKnow) {
  int judged_scenes = 0;
  for (const char* name : {"flight", "plane", "pair", "slider", "textbook"}) {
    const Kind& kind = *Catalog<Kind>::find(name);
    for (int n = 0; n < 25; ++n) {
      const Scene scene = drawn(kind, 1, n);
      const Engine* exact = find_closed_form(scene);
      if (exact == nullptr) continue;
      const EngineConfig config{exact, complete(*exact, {})};
      Opinion opinion = judged_by_laws(scene, kind.posed, config);
      if (opinion.status == "not supported") continue;
      std::ranges::move(judged_by(Known(scene, kind.posed), scene, config), std::back_inserter(opinion.complaints));
      ++judged_scenes;
      for (const Complaint& one : opinion.complaints) ADD_FAILURE() << scene.name << ": " << one.words();
    }
  }
  EXPECT_GE(judged_scenes, 30) << "random scenes have closed forms now and then";
}

/// A random scene, and our engine that is to run it.
struct Draw {
  const char* name;
  std::uint64_t seed;
  int number;
  const char* precision;

  const Kind& kind() const { return *Catalog<Kind>::find(name); }
  Scene scene() const { return drawn(kind(), seed, number); }
  EngineConfig ours() const {
    EngineConfig config = our_config();
    config.settings = complete(*config.engine, {{"precision", precision}});
    return config;
  }
};

// Each was wrong once, of our engine or of what it is judged by: three bodies that meet what pulls at them between two
// moments, a chain whose joints mend rounding, one that gained energy as they mended more, a door that its post swings
// to its limit, links that a solve which found nothing shot out at 2500 m/s, a light body that heavy ones squeeze out
// of a heap, one that flies beside a jam whose energy is bounded, faces that roll over discs, contacts of different
// restitution that are struck together, a body that a blow lays against the turning wall of a drum, what is welded to
// a body that is hit and comes down on the ground, a ball that bounces off a slab that shakes, a door that its motor
// swings to its stop within the first step, a second corner that comes round where two walls of a drum meet, a light
// box that levers throw at the body on which it hangs, a body that turns between its press and what takes that back, a
// disc that a door hits while its motor works, and boxes in a drum that are struck by what rests before the step.
TEST(FindJudge, RaisesNoAlarmForOurEngineInScenesWithPitfalls) {
  for (const Draw& draw :
       {Draw{"flight", 82, 92, "double"}, {"chain", 72002, 2, "double"}, {"flight", 72009, 5, "double"},
        {"flight", 72010, 0, "double"},   {"chain", 72003, 3, "float"},  {"door", 72006, 7, "double"},
        {"jointed", 72006, 1, "float"},   {"jointed", 401, 33, "float"}, {"heap", 992, 5, "double"},
        {"heap", 77007, 5, "double"},     {"pair", 77005, 4, "float"},   {"thin", 771, 160, "double"},
        {"thin", 78002, 6, "double"},     {"drum", 32, 20, "double"},    {"jointed", 87006, 4, "double"},
        {"belt", 87003, 5, "double"},     {"door", 88003, 2, "double"},  {"drum", 89003, 7, "double"},
        {"jointed", 90004, 4, "double"},  {"door", 90004, 1, "double"},  {"drum", 91002, 3, "double"},
        {"composite", 90001, 2, "float"}}) {
    for (const Complaint& one : judged_by_laws(draw.scene(), draw.kind().posed, draw.ours()).complaints)
      ADD_FAILURE() << draw.scene().name << ": " << one.words();
  }
}

// Each moved otherwise once in some image: bodies of many shapes that fly about, whose contacts were swept as all
// together are many, and thin ones in wedges, where laws contradict each other; one in a corner that was none in the
// mirror; bricks of which the one that lies lower had the face that they met at; welded bodies that rounding kept from
// rebounding; a door that rounding kept at its limit; and bodies of which no random displacement shows the worst.
TEST(FindJudge, FindsScenesAlikeThatOurEngineMovedOtherwise) {
  for (const Draw& draw : {Draw{"composite", 77003, 2, "double"},
                           {"composite", 77005, 7, "double"},
                           {"thin", 772, 62, "double"},
                           {"thin", 772, 163, "double"},
                           {"drum", 87006, 7, "double"},
                           {"wall", 87005, 4, "double"},
                           {"jointed", 87003, 3, "double"},
                           {"door", 87005, 6, "float"},
                           {"composite", 87009, 3, "double"},
                           {"chain", 90004, 7, "float"},
                           {"jointed", 93003, 2, "float"},
                           {"jointed", 94002, 1, "double"},
                           {"drum", 94001, 5, "double"}}) {
    const Scene scene = draw.scene();
    for (const Complaint& one : judged_by(Known(scene, draw.kind().posed), scene, draw.ours()))
      ADD_FAILURE() << scene.name << ": " << one.words();
  }
}

// A post that goes up and down carries a door, and a cart on a rail with a spring to the world. What the post does
// between the ends of steps is the harness's way of driving it, which no engine is to blame for.
TEST(FindJudge, BlamesNoEngineForTheStraightWaysOfBodiesOnPaths) {
  Body post = disc("post", {}, 0.05, {});
  post.type = BodyType::kinematic;
  post.path = Path{.amplitude = {0, 0.06}, .frequency = 1.2, .phase = 1.5};
  Scene door{.name = "door", .gravity = {}, .duration = 1, .bodies = {post, box("leaf", {0.7, 0}, {1.4, 0.13}, {})}};
  door.bodies[1].velocity = {0, 0.9};
  door.bodies[1].angular_velocity = 0.9 / 0.7;
  door.joints = {Revolute{.a = 0, .b = 1, .anchor = {}}};
  Scene cart{.name = "cart", .duration = 1, .bodies = {post, box("cart", {1.2, 0}, {0.4, 0.4}, {})}};
  cart.bodies[1].velocity = {-2, 0};
  cart.joints = {Prismatic{.a = 0, .b = 1, .anchor = {1.2, 0}, .axis = {1, 0}}};
  cart.forces = {
      Spring{.a = {}, .b = 1, .anchor_a = {0.3, -0.3}, .anchor_b = {}, .stiffness = 12, .length = 0.7, .damping = 1}};
  for (Scene* scene : {&door, &cart}) {
    for (Body& body : scene->bodies) {
      for (Shape& shape : body.shapes) shape.surface.density = 2;
      body.layers = 0;
    }
    const EngineConfig ours = our_config();
    for (const Complaint& one : judged_by_laws(*scene, Posed::well, ours).complaints)
      ADD_FAILURE() << scene->name << ": " << one.words();
    for (const Complaint& one : judged_by(Known(*scene, Posed::well), *scene, ours))
      ADD_FAILURE() << scene->name << ": " << one.words();
  }
  door.gravity = {0, -10};
  const Suspect twice = parse_suspects("fault:gravity-twice").front();
  EXPECT_TRUE(judged_by_laws(door, Posed::well, *twice.right).complaints.empty());
  EXPECT_NE(judged_by_laws(door, Posed::well, twice.config).of("invariant free_motion"), nullptr);
}

TEST(FindJudge, KnowsWhereAThrownBodyMustBe) {
  Scene scene{.name = "throw", .gravity = {0, -10}, .duration = 1};
  scene.bodies.push_back(disc("ball", {}, 0.5, {}));
  scene.bodies[0].velocity = {3, 4};
  const Known known(scene, Posed::well);
  const Suspect twice = parse_suspects("fault:gravity-twice").front();
  const Opinion wrong{.status = "ok", .complaints = judged_by(known, scene, twice.config)};
  EXPECT_NE(wrong.of("closed form y -"), nullptr);
  EXPECT_TRUE(judged_by(known, scene, *twice.right).empty());
}

TEST(FindJudge, AsksNothingBeyondTheEndOfAClosedForm) {
  // Lands shortly before the end, where the closed form ends; the last step ends after it.
  Scene scene{.name = "landing", .gravity = {0, -10}, .duration = 0.64};
  scene.bodies.push_back(level_ground({}));
  scene.bodies.push_back({.name = "body", .position = {0, 2}, .angle = -3});
  scene.bodies[1].shapes.push_back({.geometry = Capsule{.from = {-0.3, 0}, .to = {0.3, 0}, .radius = 0.6}});
  ASSERT_NE(find_closed_form(scene), nullptr);
  const EngineConfig impulse = parse_suspects("impulse").front().config;
  for (const Complaint& one : judged_by(Known(scene, Posed::well), scene, impulse)) {
    EXPECT_NE(one.judge, "closed form") << one.words();
  }
}

// Two discs meet after the scene's end, yet within its last step.
TEST(FindJudge, RunsAClosedFormToTheEndOfTheLastStep) {
  Scene scene{.name = "row", .gravity = {}, .duration = 0.101};
  scene.bodies = {disc("a", {0, 0}, 0.1, {}), disc("b", {0.305, 0}, 0.1, {})};
  scene.bodies[0].velocity = {1, 0};
  const Engine* line = Catalog<Engine>::find("line");
  const EngineConfig config{line, complete(*line, {})};
  EXPECT_EQ(judged_by_laws(scene, Posed::well, config).status, "ok");
  for (const Complaint& one : judged_by_laws(scene, Posed::well, config).complaints) ADD_FAILURE() << one.words();
}

TEST(FindJudge, AsksOnlyForEnergyWhereNoMotionIsRight) {
  const Kind& kind = *Catalog<Kind>::find("painleve");
  EXPECT_EQ(kind.posed, Posed::impossible);
  for (const char* engine : {"impulse", "box2d", "chipmunk"}) {
    for (int n = 0; n < 5; ++n) {
      const Scene scene = drawn(kind, 1, n);
      const EngineConfig config = parse_suspects(engine).front().config;
      EXPECT_TRUE(judged_by(Known(scene, kind.posed), scene, config).empty());
      const Opinion opinion = judged_by_laws(scene, kind.posed, config);
      for (const Complaint& one : opinion.complaints) {
        EXPECT_TRUE(one.judge == "run" || one.what == "energy" || one.what == "energy_bound") << one.words();
      }
    }
  }
}

TEST(FindJudge, AsksOnlyForAnEndWhereBodiesStartInEachOther) {
  const Scene scene = drawn(*Catalog<Kind>::find("overlapping"), 1, 0);
  const EngineConfig impulse = parse_suspects("impulse").front().config;
  EXPECT_FALSE(judged_by_laws(scene, Posed::well, impulse).complaints.empty()) << "it overlaps";
  EXPECT_TRUE(judged_by_laws(scene, Posed::overlapping, impulse).complaints.empty());
  EXPECT_TRUE(Known(scene, Posed::overlapping).empty());
}

std::shared_ptr<Engine> misbehaving(void (*step)()) {
  class Bad : public Simulation {
   public:
    explicit Bad(void (*what)()) : step_(what) {}
    void step(double) override { step_(); }
    void read(std::span<BodyState> out) const override { std::ranges::fill(out, BodyState{}); }

   private:
    void (*step_)();
  };
  return std::make_shared<Engine>(
      Engine{.name = "bad",
             .about = "",
             .source = "",
             .options = {},
             .stepping = [](const Settings&, double dt) { return Stepping{.dt = dt, .h = dt}; },
             .unsupported = [](const Scene&, const Settings&) { return ""; },
             .build = [step](const Scene&, const Settings&) { return std::make_unique<Bad>(step); }});
}

TEST(JudgedApart, SurvivesAnEngineThatCrashesOrHangs) {
  Scene scene{.name = "one", .duration = 0.1};
  scene.bodies.push_back(disc("ball", {}, 0.5, {}));
  const auto of = [&](double seconds, void (*step)()) {
    const auto engine = misbehaving(step);
    const Suspect bad{.name = "bad", .config = {engine.get(), {}}};
    return judged_apart(scene, Posed::ambiguous, {&bad, 1}, {}, {.seconds = seconds, .mebibytes = 2048}).front();
  };
  const Opinion crashed = of(600, [] { std::abort(); });
  EXPECT_NE(crashed.of("run crashed"), nullptr) << as_json(crashed).dump();
  EXPECT_NE(of(0.2,
               [] {
                 for (;;) usleep(1000);
               })
                .of("run timed out"),
            nullptr);
}

TEST(JudgedApart, DoesNotBlameAFaultForWhatTheRightEngineFailsToo) {
  Scene scene{.name = "throw", .gravity = {0, -10}, .duration = 1};
  scene.bodies.push_back(disc("ball", {}, 0.5, {}));
  Suspect twice = parse_suspects("fault:gravity-twice").front();
  EXPECT_FALSE(judged_apart(scene, Posed::well, {&twice, 1}, {}, {}).front().complaints.empty());
  twice.right = twice.config;
  EXPECT_TRUE(judged_apart(scene, Posed::well, {&twice, 1}, {}, {}).front().complaints.empty());
}

TEST(Suspects, AreEnginesAndFaultsByName) {
  EXPECT_EQ(parse_suspects("impulse").size(), 1U);
  EXPECT_GE(parse_suspects("fault:all").size(), 70U);
  EXPECT_TRUE(parse_suspects("fault:gravity-twice").front().right.has_value());
  EXPECT_THROW(parse_suspects("fault:gravity-twce"), std::invalid_argument);
  EXPECT_GE(parse_suspects("closed-form:all").size(), 15U);
  EXPECT_TRUE(parse_suspects("closed-form:orbit").front().config.engine->exact);
  EXPECT_THROW(parse_suspects("closed-form:orbt"), std::invalid_argument);
  EXPECT_THROW(parse_suspects("impuls"), std::invalid_argument);
  EXPECT_GE(parse_suspects(std::vector<std::string>{}).size(), 3U);
}

}  // namespace
}  // namespace plumb::find_judge_test
