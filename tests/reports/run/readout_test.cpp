#include "reports/run/readout.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>
#include <utility>

#include "../fakes.h"

namespace plumb::readout_test {
namespace {

using ::testing::HasSubstr;

/// A simulation that reads as a test specifies.
struct CustomReader : Simulation {
  std::function<void(std::span<BodyState>)> reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state = {};
  };
  ContactState touching{.a = 0, .b = 1};
  void step(double) override {}
  void read(std::span<BodyState> out) const override { reads(out); }
  void read_contacts(std::vector<ContactState>& out) const override { out.push_back(touching); }
};

std::string error_of(const CustomReader& simulation) {
  Scene scene = fakes::thrown_box();
  scene.bodies.push_back({.name = "other"});
  Readout readout(scene);
  try {
    readout.states(simulation);
    readout.contacts(simulation);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(Readout, AcceptsCorrectReads) { EXPECT_EQ(error_of({}), ""); }

TEST(Readout, NamesABodyThatWasLeftOut) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) { out[0] = {}; };
  EXPECT_THAT(error_of(simulation), HasSubstr("read() left out body \"other\""));
  simulation.reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state.position = {1, 2};
  };
  EXPECT_THAT(error_of(simulation), HasSubstr("read() left out body \"box\""));
}

TEST(Readout, NoticesAWritePastTheEnd) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) {
    for (std::size_t i = 0; i < 3; ++i) out.data()[i] = {};
  };
  EXPECT_THAT(error_of(simulation), HasSubstr("past the end: the scene has 2 bodies"));
}

TEST(Readout, AcceptsNaNWhichTheRunReports) {
  CustomReader simulation;
  simulation.reads = [](std::span<BodyState> out) {
    for (BodyState& state : out) state = {.angle = std::numeric_limits<double>::quiet_NaN()};
  };
  EXPECT_EQ(error_of(simulation), "");
}

TEST(Readout, RefusesImpossibleContacts) {
  CustomReader simulation;
  simulation.touching = {.a = 0, .b = 2};
  EXPECT_THAT(error_of(simulation), HasSubstr("between bodies 0 and 2 of a scene of 2"));
  simulation.touching = {.a = 1, .b = 1};
  EXPECT_THAT(error_of(simulation), HasSubstr("between bodies 1 and 1"));
  simulation.touching = {.a = 0, .b = 1, .normal_impulse = std::numeric_limits<double>::infinity()};
  EXPECT_THAT(error_of(simulation), HasSubstr("not finite"));
}

}  // namespace
}  // namespace plumb::readout_test
