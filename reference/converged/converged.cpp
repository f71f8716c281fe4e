#include "reference/converged/converged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "reference/exact/closed_form.h"
#include "reference/scene_facts.h"
#include "scenarios/allowance.h"
#include "scenarios/images.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

struct Method {
  const Engine& engine;
  Settings settings;
};

Method method_of(const Refinement& refinement) {
  if (refinement.engine != nullptr) return {*refinement.engine, complete(*refinement.engine, refinement.settings)};
  const Engine& ours = *Catalog<Engine>::find("impulse");
  return {ours, complete(ours, {{"precision", "double"}})};
}

BodyState interpolated(const BodyState& a, const BodyState& b, double share) {
  return {.position = a.position + share * (b.position - a.position),
          .angle = a.angle + share * (b.angle - a.angle),
          .velocity = a.velocity + share * (b.velocity - a.velocity),
          .angular_velocity = a.angular_velocity + share * (b.angular_velocity - a.angular_velocity)};
}

// A run after k halvings: 2^k times as many steps in a scene 2^k times as large. Scaling by a power of two is exact.
// Between two steps it is interpolated linearly; that error shrinks along with the others.
class HalvedRun {
 public:
  HalvedRun(const Scene& scene, const Method& method, double coarsest, int halvings)
      : scale_(std::ldexp(1.0, halvings)),
        dt_(coarsest / scale_),
        simulation_(method.engine.build(in_units(scene, {.length = scale_}), method.settings)),
        before_(scene.bodies.size()),
        now_(scene.bodies.size()) {
    simulation_->read(now_);
    before_ = now_;
  }

  /// Appends the states at `time`, s, which is no earlier than that of the last call.
  void read_at(double time, std::vector<BodyState>& to) {
    while (steps_ * dt_ < time * (1 - 1e-12)) {
      before_.swap(now_);
      simulation_->step(dt_);
      simulation_->read(now_);
      ++steps_;
    }
    const double share = 1 - std::clamp(steps_ - time / dt_, 0.0, 1.0);
    for (std::size_t i = 0; i < now_.size(); ++i) {
      BodyState state = interpolated(before_[i], now_[i], share);
      state.position = (1 / scale_) * state.position;
      state.velocity = (1 / scale_) * state.velocity;
      to.push_back(state);
    }
  }

 private:
  double scale_, dt_;
  std::unique_ptr<Simulation> simulation_;
  std::vector<BodyState> before_, now_;
  double steps_ = 0;
};

struct Limit {
  Vec value;
  double error = 0;
  bool ordered = false;
};

// x(h) = x + c h^p + ... : successive differences of the answers shrink by a ratio of 2^p and point the same way. Where
// the last two ratios agree well enough not to be chance, the limit lies another D/(2^p - 1) beyond the finest answer,
// D being the last difference. That extrapolation leaves only a higher order, but its whole length times Roache's
// factor of safety is claimed as the error (P. J. Roache, Perspective: a method for uniform reporting of grid
// refinement studies, 1994: 1.25 for three grids or more). Where the differences follow no order (an impact falls at a
// different point of each step, and its error with it) the finest answer is the limit; its error is taken from the last
// three differences, doubled because each is a difference of two errors.
Limit limit_of(std::span<const Vec> answers) {
  constexpr double slowest = 1.5;   // ratio; first order has 2
  constexpr double fastest = 5;     // the method is of second order: 4, and some scatter
  constexpr double alike = 1.15;    // of one ratio to the next, at most
  constexpr double aligned = 0.95;  // cosine between successive differences, at least
  constexpr double safety = 1.25;
  const std::size_t n = answers.size();
  const std::array<Vec, 3> step{answers[n - 3] - answers[n - 4], answers[n - 2] - answers[n - 3],
                                answers[n - 1] - answers[n - 2]};
  const std::array<double, 3> size{length(step[0]), length(step[1]), length(step[2])};
  const double first = size[0] / size[1];
  const double last = size[1] / size[2];
  const bool ordered = std::min(first, last) > slowest && std::max(first, last) < fastest &&
                       std::max(first, last) < alike * std::min(first, last) &&
                       dot(step[0], step[1]) > aligned * size[0] * size[1] &&
                       dot(step[1], step[2]) > aligned * size[1] * size[2];
  if (!ordered) return {answers[n - 1], 2 * std::max({size[0], size[1], size[2]})};
  const Vec further = (1 / (std::min(first, last) - 1)) * step[2];
  return {answers[n - 1] + further, safety * length(further), true};
}

// Speeds at a support may agree for a while and then start to change. Without an order, a speed is known no better than
// from two positions at the ends of a coarsest step, each within its error.
double error_of_speed(const Limit& speed, const Limit& position, double dt) {
  return speed.ordered ? speed.error : std::max(speed.error, 2 * position.error / dt);
}

std::string divergence_in_words(const Scene& scene, std::size_t body, double time, std::span<const Vec> answers) {
  const std::size_t n = answers.size();
  std::ostringstream words;
  words.precision(3);
  words << "does not converge: at t = " << time << " s \"" << scene.bodies[body].name << "\" differs by "
        << length(answers[n - 3] - answers[n - 4]) << ", " << length(answers[n - 2] - answers[n - 3]) << ", "
        << length(answers[n - 1] - answers[n - 2]) << " m from one halving of the step to the next";
  return words.str();
}

// Errors that no halving reveals. Round-off grows with the number of steps. Every step rounds the g h that gravity adds
// and a support takes away, and the position x, which contacts and joints turn into a speed within one sub-step. Hops
// slower than the engine's restitution threshold are missing; they are v^2/(2 g) high.
class ErrorFloor {
 public:
  ErrorFloor(const Scene& scene, const Refinement& refinement, int halvings)
      : stepping_(stepping_of(refinement, halvings)),
        gravity_(length(scene.gravity)),
        size_(smallest_body(scene)),
        fastest_(scene.bodies.size()) {
    const double threshold = std::ldexp(stepping_.restitution_threshold, -halvings);
    for (const Body& body : scene.bodies) {
      for (const Shape& shape : body.shapes) {
        if (shape.surface.restitution > 0 && gravity_ > 0) slowest_bounce_ = threshold;
      }
    }
  }

  StateError at(double time, std::size_t body, const BodyState& state) {
    double& fastest = fastest_[body];
    fastest = std::max(fastest, length(state.velocity) + size_ * std::abs(state.angular_velocity));
    const double extent = length(state.position) + size_ * std::abs(state.angle);
    const double position = round_off(stepping_, time, extent + fastest * time);
    const double velocity =
        round_off(stepping_, time, fastest + gravity_ * stepping_.h) + round_off(stepping_, 0, extent) / stepping_.h;
    const double hop = gravity_ > 0 ? slowest_bounce_ * slowest_bounce_ / (2 * gravity_) : 0;
    return {hop + position, position / size_, slowest_bounce_ + velocity, velocity / size_};
  }

 private:
  static Stepping stepping_of(const Refinement& refinement, int halvings) {
    const auto [engine, settings] = method_of(refinement);
    return engine.stepping(settings, refinement.dt / std::ldexp(1.0, halvings));
  }

  Stepping stepping_;
  double gravity_, size_;
  double slowest_bounce_ = 0;    // m/s
  std::vector<double> fastest_;  // m/s so far, of each body
};

// Interpolates between the times of a solution, as the motion of a ClosedForm.
class InterpolatedMotion {
 public:
  explicit InterpolatedMotion(std::shared_ptr<const Converged> converged) : converged_(std::move(converged)) {}

  void at(double t, std::span<BodyState> out) const {
    const std::vector<double>& times = converged_->times();
    const auto after = std::lower_bound(times.begin(), times.end() - 1, t * (1 - 1e-12));
    const auto last = static_cast<std::size_t>(after - times.begin());
    const std::size_t first = last == 0 ? 0 : last - 1;
    const double share = last == 0 ? 0 : std::min((t - times[first]) / (times[last] - times[first]), 1.0);
    for (std::size_t i = 0; i < out.size(); ++i) {
      out[i] = interpolated(converged_->states(first)[i], converged_->states(last)[i], share);
    }
  }
  double valid_until() const { return converged_->valid_until() * (1 + 1e-12); }

 private:
  std::shared_ptr<const Converged> converged_;
};

}  // namespace

Converged::Converged(const Scene& scene, std::vector<double> times, const Refinement& refinement)
    : times_(std::move(times)),
      bodies_(scene.bodies.size()),
      size_(smallest_body(scene)),
      tolerance_(refinement.tolerance * size_) {
  if (times_.empty() || times_.front() < 0 || !std::is_sorted(times_.begin(), times_.end())) {
    throw std::invalid_argument("the times of a converged reference must ascend from 0 or later");
  }
  const auto [engine, settings] = method_of(refinement);
  const std::string unsupported = engine.unsupported(scene, settings);
  if (!unsupported.empty()) throw std::domain_error(unsupported);
  states_.resize(times_.size() * bodies_);
  errors_.resize(times_.size() * bodies_);
  valid_until_ = times_.back();
  extrapolate(scene, refine(scene, refinement), refinement);
}

// As many answers as the budget allows. Each is computed only as long as those before it leave hope; the first two side
// by side.
Converged::Answers Converged::refine(const Scene& scene, const Refinement& refinement) {
  const Method method = method_of(refinement);
  const auto budget = static_cast<double>(refinement.budget);
  const auto cost = [&](std::size_t moments, double coarsest_steps) {  // body-steps
    return moments == 0
               ? 0
               : static_cast<double>(bodies_) * std::ceil(times_[moments - 1] / refinement.dt) * coarsest_steps;
  };
  std::size_t moments = times_.size();
  const double fewest = std::ldexp(1.0, fewest_halvings + 1) - 1;
  while (cost(moments, fewest) > budget) --moments;
  if (moments < times_.size()) {
    std::ostringstream words;
    words << "over budget: " << fewest_halvings << " halvings need " << cost(times_.size(), fewest)
          << " body-steps, the limit is " << budget;
    end_before(moments, words.str());
  }
  HalvedRun coarsest(scene, method, refinement.dt, 0);
  Answers answers(1);
  double spent = cost(moments, 1);
  for (int k = 1; k <= refinement.halvings; ++k) {
    if (k > fewest_halvings && spent + cost(moments, std::ldexp(1.0, k)) > budget) break;
    spent += cost(moments, std::ldexp(1.0, k));
    int left = 0;  // halvings that the budget pays if all moments stay
    for (double after = spent; k + left < refinement.halvings; ++left) {
      after += cost(moments, std::ldexp(1.0, k + left + 1));
      if (k + left >= fewest_halvings && after > budget) break;
    }
    HalvedRun finest(scene, method, refinement.dt, k);
    answers.emplace_back();
    for (std::size_t moment = 0; moment < moments; ++moment) {
      if (k == 1) coarsest.read_at(times_[moment], answers[0]);
      finest.read_at(times_[moment], answers.back());
      if (!is_promising(scene, moment, left, answers)) moments = moment;
    }
  }
  return answers;
}

// Whether the last two answers are close enough at a moment for the halvings that are left, and the extrapolation after
// them, to bring them within the tolerance, even at second order, which gains a factor of four each. Where not, the
// solution ends before it.
bool Converged::is_promising(const Scene& scene, std::size_t moment, int halvings, const Answers& answers) {
  const std::size_t n = answers.size();
  const double hopeless = tolerance_ * std::ldexp(1.0, 2 * (halvings + 1));
  for (std::size_t body = 0; body < bodies_; ++body) {
    const std::size_t index = moment * bodies_ + body;
    const double apart = length(answers[n - 1][index].position - answers[n - 2][index].position);
    if (apart <= hopeless) continue;
    std::ostringstream words;
    words.precision(3);
    words << "does not converge: at t = " << times_[moment] << " s \"" << scene.bodies[body].name
          << "\" still differs by " << apart << " m after halving " << n - 1 << " of the step";
    end_before(moment, words.str());
    return false;
  }
  return true;
}

void Converged::end_before(std::size_t time_index, std::string reason) {
  const double until = time_index == 0 ? 0 : times_[time_index - 1];
  if (!reason_.empty() && until >= valid_until_) return;
  valid_until_ = until;
  reason_ = std::move(reason);
}

// Written so that a NaN counts as not known.
bool Converged::is_known(const StateError& error) const {
  return error.position + size_ / 2 * error.angle <= tolerance_;
}

void Converged::extrapolate(const Scene& scene, const Answers& answers, const Refinement& refinement) {
  ErrorFloor floor(scene, refinement, static_cast<int>(answers.size()) - 1);
  std::vector<Vec> sequence(answers.size());
  const auto limit = [&](std::size_t index, auto&& read) {
    for (std::size_t k = 0; k < answers.size(); ++k) sequence[k] = read(answers[k][index]);
    return limit_of(sequence);
  };
  const auto place = [](const BodyState& state) { return state.position; };
  for (std::size_t index = 0; index < answers.back().size(); ++index) {
    const std::size_t time_index = index / bodies_;
    const std::size_t i = index % bodies_;
    const Limit position = limit(index, place);
    const Limit angle = limit(index, [](const BodyState& state) { return Vec{state.angle, 0}; });
    const Limit velocity = limit(index, [](const BodyState& state) { return state.velocity; });
    const Limit turning = limit(index, [](const BodyState& state) { return Vec{state.angular_velocity, 0}; });
    states_[index] = {position.value, angle.value.x, velocity.value, turning.value.x};
    StateError error = floor.at(times_[time_index], i, states_[index]);
    error.position += position.error;
    error.angle += angle.error;
    error.velocity += error_of_speed(velocity, position, refinement.dt);
    error.angular_velocity += error_of_speed(turning, angle, refinement.dt);
    errors_[index] = error;
    if (is_known(error)) continue;
    limit(index, place);
    end_before(time_index, divergence_in_words(scene, i, times_[time_index], sequence));
    return;
  }
}

std::optional<std::size_t> Converged::contradicted_by(const Converged& other, std::size_t time_index) {
  for (std::size_t i = 0; i < bodies_; ++i) {
    const BodyState& a = states(time_index)[i];
    const BodyState& b = other.states(time_index)[i];
    const StateError& doubt = other.errors(time_index)[i];
    StateError& error = errors_[time_index * bodies_ + i];
    error.position = std::max(error.position, length(a.position - b.position) - doubt.position);
    error.angle = std::max(error.angle, std::abs(a.angle - b.angle) - doubt.angle);
    error.velocity = std::max(error.velocity, length(a.velocity - b.velocity) - doubt.velocity);
    error.angular_velocity =
        std::max(error.angular_velocity, std::abs(a.angular_velocity - b.angular_velocity) - doubt.angular_velocity);
    if (!is_known(error)) return i;
  }
  return std::nullopt;
}

std::span<const BodyState> Converged::states(std::size_t time_index) const {
  return std::span(states_).subspan(time_index * bodies_, bodies_);
}

std::span<const StateError> Converged::errors(std::size_t time_index) const {
  return std::span(errors_).subspan(time_index * bodies_, bodies_);
}

double Converged::largest_error() const {
  double largest = 0;
  for (std::size_t time_index = 0; time_index < times_.size() && times_[time_index] <= valid_until_; ++time_index) {
    for (const StateError& error : errors(time_index)) largest = std::max(largest, error.position);
  }
  return largest;
}

ConvergedTruth converged_truth(const Scene& scene, std::vector<double> times, const Refinement& refinement) {
  return truth_of([&] { return std::make_shared<const Converged>(scene, std::move(times), refinement); });
}

ConvergedTruth truth_of(const std::function<std::shared_ptr<const Converged>()>& solve) {
  ConvergedTruth truth;
  std::string refused;
  try {
    truth.answer = solve();
    if (!(truth.answer->valid_until() > 0)) refused = truth.answer->reason();
  } catch (const std::domain_error& error) {
    refused = error.what();
  }
  Engine& engine = truth.engine;
  engine.name = "converged";
  engine.about = "the limit of our engine's solutions as the step is halved, where they converge";
  engine.source = "this repository, reference/converged; L. F. Richardson (1911)";
  engine.exact = true;
  engine.stepping = [](const Settings&, double dt) { return Stepping{.dt = dt, .impact_lag = 0, .epsilon = 0x1p-53}; };
  engine.unsupported = [refused](const Scene&, const Settings&) { return refused; };
  engine.build = [answer = truth.answer](const Scene&, const Settings&) -> std::unique_ptr<Simulation> {
    return std::make_unique<ClosedForm<InterpolatedMotion>>(InterpolatedMotion(answer));
  };
  return truth;
}

}  // namespace plumb
