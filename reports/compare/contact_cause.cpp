#include "reports/compare/divergence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/judge/contacts.h"
#include "scenarios/scene/vec.h"

namespace plumb {
namespace {

const PairContacts* find_pair(const ContactsByPair& pairs, BodyPair pair) {
  const auto found = pairs.find(pair);
  return found == pairs.end() ? nullptr : &found->second;
}

class CauseSearch {
 public:
  CauseSearch(const Scene& scene, const ComparedRun& a, const ComparedRun& b, std::size_t step, std::size_t body,
              const StateTolerance& tolerance)
      : scene_(scene),
        a_(a),
        b_(b),
        step_(step),
        body_(body),
        tolerance_(tolerance),
        in_a_(contacts_by_pair(a.trace->contacts(step))),
        in_b_(contacts_by_pair(b.trace->contacts(step))) {}

  ContactCause find() const {
    const std::vector<BodyPair> pairs = connected_pairs();
    if (pairs.empty()) {
      ContactCause cause = unreported_impact();
      return cause.advice.empty() ? ContactCause{.advice = no_contact_advice()} : cause;
    }
    if (const ComparedRun* silent = run_without_contacts()) {
      return {
          .stage = Stage::not_reported,
          .advice = fmt::format(
              "{} reports no contacts in its whole run, while something touches {} in the other: the contact or the "
              "motion may differ.",
              silent->name, name(body_))};
    }
    for (const auto look :
         {&CauseSearch::later_impact, &CauseSearch::contact_in_one_run, &CauseSearch::different_manifold,
          &CauseSearch::different_impulse, &CauseSearch::impact_within_step}) {
      for (const BodyPair& pair : pairs) {
        ContactCause cause = (this->*look)(pair);
        if (!cause.advice.empty()) return cause;
      }
    }
    return {.stage = Stage::not_reported,
            .advice =
                "Both report the same contacts and impulses: look at what follows them, such as position correction, "
                "damping and the integrators."};
  }

 private:
  const std::string& name(std::size_t body) const { return scene_.bodies[body].name; }

  bool acts(const ContactsByPair& pairs, BodyPair pair) const {
    const PairContacts* contacts = find_pair(pairs, pair);
    return contacts != nullptr && contacts->acts(tolerance_.position);
  }

  // The pairs that act in either run and are connected to the body through dynamic bodies, its own first.
  std::vector<BodyPair> connected_pairs() const {
    std::set<BodyPair> acting;
    for (const ContactsByPair* pairs : {&in_a_, &in_b_}) {
      for (const auto& [pair, contacts] : *pairs) {
        if (contacts.acts(tolerance_.position)) acting.insert(pair);
      }
    }
    std::vector<BodyPair> found;
    std::vector<std::size_t> reached{body_};
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (auto pair = acting.begin(); pair != acting.end();) {
        if (pair->first != reached[next] && pair->second != reached[next]) {
          ++pair;
          continue;
        }
        const std::size_t other = pair->first == reached[next] ? pair->second : pair->first;
        if (scene_.bodies[other].type == BodyType::dynamic) reached.push_back(other);
        found.push_back(*pair);
        pair = acting.erase(pair);
      }
    }
    return found;
  }

  std::string no_contact_advice() const {
    std::string advice = fmt::format("Nothing touches {} in either run: look at the integrators", name(body_));
    if (!scene_.forces.empty()) advice += ", and at how forces are evaluated";
    if (!scene_.joints.empty()) advice += ", and at the joints";
    if (a_.trace->has_contacts() || b_.trace->has_contacts()) return advice + ".";
    return advice + ". (Neither reports any contact.)";
  }

  const ComparedRun* run_without_contacts() const {
    if (!a_.trace->has_contacts()) return &a_;
    return b_.trace->has_contacts() ? nullptr : &b_;
  }

  // Either run may notice an impact late; by this step, the late one has noticed what happened in `step_`.
  std::size_t noticed_by(double dt) const {
    const double lag = std::max(a_.stepping.impact_lag * a_.stepping.h, b_.stepping.impact_lag * b_.stepping.h);
    return step_ + 1 + static_cast<std::size_t>(std::ceil(lag / dt));
  }

  // An impact in a run that reports no contacts, as a closed form: the body's velocity jumps, and in the other run the
  // body is struck soon after.
  ContactCause unreported_impact() const {
    const ComparedRun* silent = run_without_contacts();
    if (silent == nullptr) return {};
    const ComparedRun& other = silent == &a_ ? b_ : a_;
    const Vec jump = silent->trace->states(step_)[body_].velocity - silent->trace->states(step_ - 1)[body_].velocity;
    if (length(jump) <= length(scene_.gravity) * other.stepping.dt + tolerance_.velocity) return {};
    const std::size_t soon = noticed_by(other.stepping.dt);
    for (std::size_t k = step_ + 1; k <= soon && k < other.trace->size(); ++k) {
      for (const auto& [pair, contacts] : contacts_by_pair(other.trace->contacts(k))) {
        if ((pair.first != body_ && pair.second != body_) || !contacts.acts(tolerance_.position)) continue;
        return {
            .stage = Stage::event_time,
            .other = name(pair.first == body_ ? pair.second : pair.first),
            .advice = fmt::format(
                "In {}, which reports no contacts, the velocity of {} jumps in step {}; in {}, {} and {} collide in "
                "step {}: look at how each finds the time of impact.",
                silent->name, name(body_), step_, other.name, name(pair.first), name(pair.second), k)};
      }
    }
    return {};
  }

  // An impact that was not there a step before, and that the other run has soon after.
  ContactCause later_impact(BodyPair pair) const {
    const bool first_is_a = acts(in_a_, pair);
    if (first_is_a == acts(in_b_, pair)) return {};
    const ComparedRun& early = first_is_a ? a_ : b_;
    const ComparedRun& late = first_is_a ? b_ : a_;
    if (acts(contacts_by_pair(early.trace->contacts(step_ - 1)), pair)) return {};
    const std::size_t soon = noticed_by(early.stepping.dt);
    for (std::size_t k = step_ + 1; k <= soon && k < late.trace->size(); ++k) {
      if (!acts(contacts_by_pair(late.trace->contacts(k)), pair)) continue;
      ContactCause cause = cause_at(pair, Stage::event_time);
      ValueDifference when{.what = "step of the impact", .difference = static_cast<double>(k - step_)};
      (first_is_a ? when.a : when.b) = static_cast<double>(step_);
      (first_is_a ? when.b : when.a) = static_cast<double>(k);
      cause.values.insert(cause.values.begin(), when);
      cause.advice = fmt::format(
          "In {}, {} and {} collide in step {}; in {}, in step {}: look at how each finds the time of impact.",
          early.name, name(pair.first), name(pair.second), step_, late.name, k);
      return cause;
    }
    return {};
  }

  ContactCause contact_in_one_run(BodyPair pair) const {
    const PairContacts* a = find_pair(in_a_, pair);
    const PairContacts* b = find_pair(in_b_, pair);
    if ((a == nullptr) == (b == nullptr)) return {};
    ContactCause cause = cause_at(pair, Stage::contact_set);
    cause.advice =
        fmt::format("{} and {} touch in {} but not in {}: look at the broad phase and at margins (skin, slop).",
                    name(pair.first), name(pair.second), (a ? a_ : b_).name, (a ? b_ : a_).name);
    return cause;
  }

  // Engines report a contact as it was before they moved the bodies, after, or in between. Within the step, in one run,
  // at one contact, it may have moved by:
  struct ContactMotion {
    double low = 0, high = 0;  // m, the separation: into an impact, and out of it again
    double distance = 0;       // m, the point
    double rotation = 0;       // rad, the normal
  };

  ContactMotion motion_of(const ComparedRun& run, const ContactState& contact) const {
    const double dt = run.stepping.dt;
    Vec moved, before, after;  // of b's point relative to a's: m, m/s, m/s
    ContactMotion motion;
    for (const auto& [body, sign] : {std::pair{contact.a, -1.0}, std::pair{contact.b, 1.0}}) {
      const BodyState& from = run.trace->states(step_ - 1)[body];
      const BodyState& to = run.trace->states(step_)[body];
      const Vec arm = contact.point - to.position;
      const Vec normal_to_arm{-arm.y, arm.x};
      const Vec by = to.position - from.position + (to.angle - from.angle) * normal_to_arm;
      const Vec at_first = from.velocity + from.angular_velocity * normal_to_arm;
      const Vec at_last = to.velocity + to.angular_velocity * normal_to_arm;
      moved = moved + sign * by;
      before = before + sign * at_first;
      after = after + sign * at_last;
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      motion.distance += std::max({length(by), dt * length(at_first), dt * length(at_last)});
      motion.rotation += std::abs(to.angle - from.angle);
    }
    motion.low = std::min({0.0, dot(moved, contact.normal), dt * dot(before, contact.normal)});
    motion.high = std::max({0.0, dot(moved, contact.normal), dt * dot(after, contact.normal)});
    return motion;
  }

  bool same_point(const ContactState& a, const ContactState& b) const {
    const ContactMotion in_a = motion_of(a_, a);
    const ContactMotion in_b = motion_of(b_, b);
    const double deeper = a.separation - b.separation;
    return length(a.point - b.point) <= tolerance_.position + in_a.distance + in_b.distance &&
           deeper >= in_a.low - in_b.high - tolerance_.position &&
           deeper <= in_a.high - in_b.low + tolerance_.position &&
           length(a.normal - b.normal) <= tolerance_.angle + in_a.rotation + in_b.rotation;
  }

  // Each point that acts must have a counterpart in the other run.
  bool same_manifold(const PairContacts& a, const PairContacts& b) const {
    const auto point_acts = [&](const ContactState& point) {
      return point.normal_impulse > 0 || point.separation < -tolerance_.position;
    };
    const auto is_in_b = [&](const ContactState& one) {
      const auto is_same = [&](const ContactState& other) { return same_point(one, other); };
      return !point_acts(one) || std::any_of(b.points.begin(), b.points.end(), is_same);
    };
    const auto is_in_a = [&](const ContactState& one) {
      const auto is_same = [&](const ContactState& other) { return same_point(other, one); };
      return !point_acts(one) || std::any_of(a.points.begin(), a.points.end(), is_same);
    };
    return std::all_of(a.points.begin(), a.points.end(), is_in_b) &&
           std::all_of(b.points.begin(), b.points.end(), is_in_a);
  }

  ContactCause different_manifold(BodyPair pair) const {
    const PairContacts* a = find_pair(in_a_, pair);
    const PairContacts* b = find_pair(in_b_, pair);
    if (a == nullptr || b == nullptr || same_manifold(*a, *b)) return {};
    ContactCause cause = cause_at(pair, Stage::manifold);
    cause.advice = fmt::format(
        "{} and {} touch in both, but differently: look at points, normals and separations (clipping, skin, slop).",
        name(pair.first), name(pair.second));
    return cause;
  }

  ContactCause different_impulse(BodyPair pair) const {
    const PairContacts* a = find_pair(in_a_, pair);
    const PairContacts* b = find_pair(in_b_, pair);
    const bool same = a != nullptr && b != nullptr &&
                      std::abs(a->normal_impulse - b->normal_impulse) <= tolerance_.impulse &&
                      std::abs(a->tangent_impulse - b->tangent_impulse) <= tolerance_.impulse;
    if (same) return {};
    ContactCause cause = cause_at(pair, Stage::impulse);
    cause.advice = fmt::format(
        "Both find the same contact of {} and {}, but with different impulses: look at the solver (its iterations and "
        "warm start, restitution and its threshold, friction, softness).",
        name(pair.first), name(pair.second));
    return cause;
  }

  // A new impact with the same impulse, after which the body has the same velocity in both runs but not the same
  // position. The contact counts as an impact if it closes faster than what gravity adds in a step, which is what a
  // resting contact does.
  ContactCause impact_within_step(BodyPair pair) const {
    const double resting = length(scene_.gravity) * a_.stepping.dt + tolerance_.velocity;
    for (const auto& [run, pairs] : {std::pair{&a_, &in_a_}, std::pair{&b_, &in_b_}}) {
      if (acts(contacts_by_pair(run->trace->contacts(step_ - 1)), pair)) return {};
      const ContactState& contact = find_pair(*pairs, pair)->points[0];
      const auto before = run->trace->states(step_ - 1);
      if (dot(before[pair.second].velocity - before[pair.first].velocity, contact.normal) > -resting) return {};
    }
    const Vec a = a_.trace->states(step_)[body_].velocity;
    const Vec b = b_.trace->states(step_)[body_].velocity;
    if (length(a - b) > tolerance_.velocity) return {};
    ContactCause cause = cause_at(pair, Stage::event_time);
    cause.advice = fmt::format(
        "{} and {} collide in step {} of both with the same impulse, but at different moments of the step: look at how "
        "each finds the time of impact.",
        name(pair.first), name(pair.second), step_);
    return cause;
  }

  ContactCause cause_at(BodyPair pair, Stage stage) const {
    const PairContacts* a = find_pair(in_a_, pair);
    const PairContacts* b = find_pair(in_b_, pair);
    const std::string of = fmt::format(", {} and {}", name(pair.first), name(pair.second));
    const auto value = [&](const char* what, const char* unit, double tolerance, double (*read)(const PairContacts&)) {
      ValueDifference made{.what = what + of, .unit = unit, .tolerance = tolerance};
      if (a) made.a = read(*a);
      if (b) made.b = read(*b);
      if (a && b) made.difference = std::abs(*made.a - *made.b);
      return made;
    };
    return {
        .stage = stage,
        .other = name(pair.first == body_ ? pair.second : pair.first),
        .values = {
            value("contact points", "", 0, [](const PairContacts& c) { return static_cast<double>(c.points.size()); }),
            value("separation", "m", tolerance_.position, [](const PairContacts& c) { return c.separation(); }),
            value("normal x", "", tolerance_.angle, [](const PairContacts& c) { return c.points[0].normal.x; }),
            value("normal y", "", tolerance_.angle, [](const PairContacts& c) { return c.points[0].normal.y; }),
            value("normal impulse", "N s", tolerance_.impulse, [](const PairContacts& c) { return c.normal_impulse; }),
            value("tangent impulse", "N s", tolerance_.impulse,
                  [](const PairContacts& c) { return c.tangent_impulse; })}};
  }

  const Scene& scene_;
  const ComparedRun& a_;
  const ComparedRun& b_;
  std::size_t step_, body_;
  const StateTolerance& tolerance_;
  ContactsByPair in_a_, in_b_;
};

}  // namespace

const char* name_of(Stage stage) {
  switch (stage) {
    case Stage::start:
      return "start";
    case Stage::integration:
      return "integration";
    case Stage::event_time:
      return "event time";
    case Stage::contact_set:
      return "contact set";
    case Stage::manifold:
      return "manifold";
    case Stage::impulse:
      return "impulse";
    case Stage::not_reported:
      return "not reported";
  }
  return "";
}

ContactCause find_contact_cause(const Scene& scene, const ComparedRun& a, const ComparedRun& b, std::size_t step,
                                std::size_t body, const StateTolerance& tolerance) {
  return CauseSearch(scene, a, b, step, body, tolerance).find();
}

}  // namespace plumb
