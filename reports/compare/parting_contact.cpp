#include "reports/compare/parting_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/judge/touching.h"
#include "reports/vec.h"

namespace plumb {
namespace {

const Touching* find(const TouchingPairs& pairs, BodyPair pair) {
  const auto found = pairs.find(pair);
  return found == pairs.end() ? nullptr : &found->second;
}

bool reports(const Trace& trace) {
  for (std::size_t k = 0; k < trace.size(); ++k) {
    if (!trace.contacts(k).empty()) return true;
  }
  return false;
}

class Search {
 public:
  Search(const Scene& scene, const Side& a, const Side& b, std::size_t step, std::size_t body,
         const SameEnough& allowed)
      : scene_(scene),
        a_(a),
        b_(b),
        step_(step),
        body_(body),
        allowed_(allowed),
        in_a_(touching_pairs(a.trace->contacts(step))),
        in_b_(touching_pairs(b.trace->contacts(step))) {}

  PartingContact answer() const {
    const std::vector<BodyPair> pairs = involved();
    if (pairs.empty()) return {.advice = alone()};
    if (const Side* silent = who_is_silent()) {
      return {
          .stage = Stage::not_reported,
          .advice = fmt::format("{} tells of no contacts in all of its run, while something touches {} in the other: "
                                "the contact or the motion may differ.",
                                silent->name, name(body_))};
    }
    for (const auto look : {&Search::met_later, &Search::touched_by_one, &Search::touched_elsewhere, &Search::pushed,
                            &Search::met_within}) {
      for (const BodyPair& pair : pairs) {
        PartingContact found = (this->*look)(pair);
        if (!found.advice.empty()) return found;
      }
    }
    return {.stage = Stage::not_reported,
            .advice =
                "Both tell of the same contacts and impulses: look at what comes after them, such as the correction "
                "of positions, at damping and at the integrators."};
  }

 private:
  const std::string& name(std::size_t body) const { return scene_.bodies[body].name; }

  bool acts(const TouchingPairs& pairs, BodyPair pair) const {
    const Touching* touching = find(pairs, pair);
    return touching != nullptr && touching->acts(allowed_.position);
  }

  // The pairs that act in either run and can pass something on to the body, its own first. What is fixed passes
  // nothing on.
  std::vector<BodyPair> involved() const {
    std::set<BodyPair> acting;
    for (const TouchingPairs* pairs : {&in_a_, &in_b_}) {
      for (const auto& [pair, touching] : *pairs) {
        if (touching.acts(allowed_.position)) acting.insert(pair);
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

  std::string alone() const {
    std::string advice = fmt::format("Nothing touches {} in either run: look at the integrators", name(body_));
    if (!scene_.forces.empty()) advice += ", and at how forces are evaluated";
    if (!scene_.joints.empty()) advice += ", and at the joints";
    if (reports(*a_.trace) || reports(*b_.trace)) return advice + ".";
    return advice + ". (Neither tells of any contact.)";
  }

  const Side* who_is_silent() const {
    if (!reports(*a_.trace)) return &a_;
    return reports(*b_.trace) ? nullptr : &b_;
  }

  // An impact that was not there a step before, and that the other run has soon.
  PartingContact met_later(BodyPair pair) const {
    const bool first_is_a = acts(in_a_, pair);
    if (first_is_a == acts(in_b_, pair)) return {};
    const Side& early = first_is_a ? a_ : b_;
    const Side& late = first_is_a ? b_ : a_;
    if (acts(touching_pairs(early.trace->contacts(step_ - 1)), pair)) return {};
    // Impacts may be noticed so much late, of either run's own time of impact.
    const double lag = std::max(a_.stepping.impact_lag * a_.stepping.h, b_.stepping.impact_lag * b_.stepping.h);
    const auto soon = step_ + 1 + static_cast<std::size_t>(std::ceil(lag / early.stepping.dt));
    for (std::size_t k = step_ + 1; k <= soon && k < late.trace->size(); ++k) {
      if (!acts(touching_pairs(late.trace->contacts(k)), pair)) continue;
      PartingContact found = about(pair, Stage::event_time);
      Figure when{.what = "step of the impact", .difference = static_cast<double>(k - step_)};
      (first_is_a ? when.a : when.b) = static_cast<double>(step_);
      (first_is_a ? when.b : when.a) = static_cast<double>(k);
      found.figures.insert(found.figures.begin(), when);
      found.advice =
          fmt::format("{} has {} meet {} in step {}, {} in step {}: look at how each finds the time of an impact.",
                      early.name, name(pair.first), name(pair.second), step_, late.name, k);
      return found;
    }
    return {};
  }

  PartingContact touched_by_one(BodyPair pair) const {
    const Touching* a = find(in_a_, pair);
    const Touching* b = find(in_b_, pair);
    if ((a == nullptr) == (b == nullptr)) return {};
    PartingContact found = about(pair, Stage::contact_set);
    found.advice =
        fmt::format("{} has {} touch {} and {} has not: look at the search for pairs and at margins (skins, slop).",
                    (a ? a_ : b_).name, name(pair.first), name(pair.second), (a ? b_ : a_).name);
    return found;
  }

  // Engines report a contact as it was before they moved the bodies, after, or somewhere between. Over the step, in one
  // run, at one contact:
  struct Moved {
    double low = 0, high = 0;  // m, by which its separation may have changed so far; into an impact and out of it again
    double way = 0;            // m, that its points may have gone
    double turn = 0;           // rad, that its normal may have turned
  };

  Moved moved(const Side& side, const ContactState& contact) const {
    const double dt = side.stepping.dt;
    Vec went, before, after;  // of b's point against a's: m, m/s, m/s
    Moved all;
    for (const auto& [body, sign] : {std::pair{contact.a, -1.0}, std::pair{contact.b, 1.0}}) {
      const BodyState& from = side.trace->states(step_ - 1)[body];
      const BodyState& to = side.trace->states(step_)[body];
      const Vec arm = contact.point - to.position;
      const Vec aside{-arm.y, arm.x};
      const Vec by = to.position - from.position + (to.angle - from.angle) * aside;
      const Vec at_first = from.velocity + from.angular_velocity * aside;
      const Vec at_last = to.velocity + to.angular_velocity * aside;
      went = went + sign * by;
      before = before + sign * at_first;
      after = after + sign * at_last;
      if (scene_.bodies[body].type == BodyType::fixed) continue;
      all.way += std::max({length(by), dt * length(at_first), dt * length(at_last)});
      all.turn += std::abs(to.angle - from.angle);
    }
    all.low = std::min({0.0, dot(went, contact.normal), dt * dot(before, contact.normal)});
    all.high = std::max({0.0, dot(went, contact.normal), dt * dot(after, contact.normal)});
    return all;
  }

  bool alike(const ContactState& a, const ContactState& b) const {
    const Moved in_a = moved(a_, a);
    const Moved in_b = moved(b_, b);
    const double deeper = a.separation - b.separation;
    return length(a.point - b.point) <= allowed_.position + in_a.way + in_b.way &&
           deeper >= in_a.low - in_b.high - allowed_.position && deeper <= in_a.high - in_b.low + allowed_.position &&
           length(a.normal - b.normal) <= allowed_.angle + in_a.turn + in_b.turn;
  }

  // Each point that acts must have its like in the other run.
  bool alike(const Touching& a, const Touching& b) const {
    const auto acts = [&](const ContactState& point) {
      return point.normal_impulse > 0 || point.separation < -allowed_.position;
    };
    const auto in_b = [&](const ContactState& one) {
      const auto like = [&](const ContactState& other) { return alike(one, other); };
      return !acts(one) || std::any_of(b.points.begin(), b.points.end(), like);
    };
    const auto in_a = [&](const ContactState& one) {
      const auto like = [&](const ContactState& other) { return alike(other, one); };
      return !acts(one) || std::any_of(a.points.begin(), a.points.end(), like);
    };
    return std::all_of(a.points.begin(), a.points.end(), in_b) && std::all_of(b.points.begin(), b.points.end(), in_a);
  }

  PartingContact touched_elsewhere(BodyPair pair) const {
    const Touching* a = find(in_a_, pair);
    const Touching* b = find(in_b_, pair);
    if (a == nullptr || b == nullptr || alike(*a, *b)) return {};
    PartingContact found = about(pair, Stage::manifold);
    found.advice = fmt::format(
        "Both have {} touch {}, but not alike: look at points, normals and separations (clipping, skins, slop).",
        name(pair.first), name(pair.second));
    return found;
  }

  PartingContact pushed(BodyPair pair) const {
    const Touching* a = find(in_a_, pair);
    const Touching* b = find(in_b_, pair);
    const bool same = a != nullptr && b != nullptr && std::abs(a->push - b->push) <= allowed_.impulse &&
                      std::abs(a->rub - b->rub) <= allowed_.impulse;
    if (same) return {};
    PartingContact found = about(pair, Stage::impulse);
    found.advice = fmt::format(
        "Both find the contact of {} and {} alike, but push otherwise: look at the solver (its iterations and what it "
        "starts from, restitution and its threshold, friction, softness).",
        name(pair.first), name(pair.second));
    return found;
  }

  // A new impact with the same impulse, after which the body is as fast in both runs but elsewhere. One is an impact if
  // it closes faster than by what gravity adds in a step, which is what rests.
  PartingContact met_within(BodyPair pair) const {
    const double resting = length(scene_.gravity) * a_.stepping.dt + allowed_.velocity;
    for (const auto& [side, pairs] : {std::pair{&a_, &in_a_}, std::pair{&b_, &in_b_}}) {
      if (acts(touching_pairs(side->trace->contacts(step_ - 1)), pair)) return {};
      const ContactState& contact = find(*pairs, pair)->points[0];
      const auto before = side->trace->states(step_ - 1);
      if (dot(before[pair.second].velocity - before[pair.first].velocity, contact.normal) > -resting) return {};
    }
    const Vec a = a_.trace->states(step_)[body_].velocity;
    const Vec b = b_.trace->states(step_)[body_].velocity;
    if (length(a - b) > allowed_.velocity) return {};
    PartingContact found = about(pair, Stage::event_time);
    found.advice = fmt::format(
        "Both have {} meet {} in step {} with the same impulse, but at different moments of the step: look at how each "
        "finds the time of an impact.",
        name(pair.first), name(pair.second), step_);
    return found;
  }

  PartingContact about(BodyPair pair, Stage stage) const {
    const Touching* a = find(in_a_, pair);
    const Touching* b = find(in_b_, pair);
    const std::string of = fmt::format(", {} and {}", name(pair.first), name(pair.second));
    const auto figure = [&](const char* what, const char* unit, double allowed, double (*read)(const Touching&)) {
      Figure made{.what = what + of, .unit = unit, .tolerance = allowed};
      if (a) made.a = read(*a);
      if (b) made.b = read(*b);
      if (a && b) made.difference = std::abs(*made.a - *made.b);
      return made;
    };
    return {.stage = stage,
            .other = name(pair.first == body_ ? pair.second : pair.first),
            .figures = {
                figure("contact points", "", 0, [](const Touching& t) { return static_cast<double>(t.points.size()); }),
                figure("separation", "m", allowed_.position, [](const Touching& t) { return t.separation(); }),
                figure("normal x", "", allowed_.angle, [](const Touching& t) { return t.points[0].normal.x; }),
                figure("normal y", "", allowed_.angle, [](const Touching& t) { return t.points[0].normal.y; }),
                figure("normal impulse", "N s", allowed_.impulse, [](const Touching& t) { return t.push; }),
                figure("tangent impulse", "N s", allowed_.impulse, [](const Touching& t) { return t.rub; })}};
  }

  const Scene& scene_;
  const Side& a_;
  const Side& b_;
  std::size_t step_, body_;
  const SameEnough& allowed_;
  TouchingPairs in_a_, in_b_;
};

}  // namespace

PartingContact parting_contact(const Scene& scene, const Side& a, const Side& b, std::size_t step, std::size_t body,
                               const SameEnough& allowed) {
  return Search(scene, a, b, step, body, allowed).answer();
}

}  // namespace plumb
