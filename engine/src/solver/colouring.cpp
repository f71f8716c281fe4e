#include "solver/colouring.h"

#include <bit>

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// One bit each. If a body has more contacts than there are colours (a drum, a floor that can move), each contact
/// without a colour gets lanes of its own, after all others.
constexpr std::uint16_t colours = 64;
constexpr std::uint64_t fixed_colours = ~std::uint64_t{0} << 16;

LanesKind kind_of(const Tie& tie, bool web) {
  if (tie.discs) return tie.smooth ? LanesKind::smooth_discs : LanesKind::discs;
  if (tie.points == 1) return tie.smooth ? LanesKind::smooth : LanesKind::one;
  // In columns the pair of points is solved as a block, which settles faster; in the web of a pyramid it is worse.
  return web ? LanesKind::two : LanesKind::block;
}

}  // namespace

void Colouring::assign(const Partition& parts, const Island& island, std::uint32_t width) {
  width_ = width;
  choose(parts, island);
  place();
}

void Colouring::choose(const Partition& parts, const Island& island) {
  // Only what the island names is touched.
  taken_.resize(parts.body_count());
  for (const std::uint32_t body : island.bodies) taken_[body] = 0;
  choices_.clear();
  for (const Tie& tie : island.contacts) {
    std::uint64_t free = tie.pushes_a && tie.pushes_b ? ~std::uint64_t{0} : fixed_colours;
    if (tie.pushes_a) free &= ~taken_[tie.a];
    if (tie.pushes_b) free &= ~taken_[tie.b];
    const auto colour = static_cast<std::uint16_t>(std::countr_zero(free));
    const std::uint64_t bit = free & (~free + 1);
    if (tie.pushes_a) taken_[tie.a] |= bit;
    if (tie.pushes_b) taken_[tie.b] |= bit;
    const bool web = parts.in_web(tie);
    choices_.push_back({{tie, web}, colour, kind_of(tie, web)});
  }
}

void Colouring::place() {
  const auto group = [](const Choice& choice) {
    return choice.colour * lanes_kinds + static_cast<std::size_t>(choice.kind);
  };
  next_.assign((colours + 1) * lanes_kinds, 0);
  for (const Choice& choice : choices_) ++next_[group(choice)];
  runs_.clear();
  std::array<std::uint32_t, lanes_kinds> used{};
  for (std::size_t g = 0; g < next_.size(); ++g) {
    const auto kind = static_cast<LanesKind>(g % lanes_kinds);
    std::uint32_t& end = used[g % lanes_kinds];
    const std::uint32_t begin = end;
    const bool alone = g / lanes_kinds == colours;
    end += alone ? next_[g] : (next_[g] + width_ - 1) / width_;
    next_[g] = begin * width_;
    if (alone) {
      for (std::uint32_t i = begin; i < end; ++i) runs_.push_back({kind, i, i + 1});
    } else if (begin < end) {
      runs_.push_back({kind, begin, end});
    }
  }
  for (std::size_t kind = 0; kind < lanes_kinds; ++kind) lanes_[kind].assign(std::size_t{width_} * used[kind], {});
  for (const Choice& choice : choices_) {
    std::uint32_t& next = next_[group(choice)];
    lanes_[static_cast<std::size_t>(choice.kind)][next] = choice.slot;
    next += choice.colour == colours ? width_ : 1;
  }
}

std::span<const Tie> Colouring::order() {
  order_.clear();
  for (const LanesRun& run : runs_) {
    for (const Slot& slot :
         lanes(run.kind).subspan(std::size_t{width_} * run.begin, std::size_t{width_} * (run.end - run.begin))) {
      if (slot.tie.contact != Slot::empty) order_.push_back(slot.tie);
    }
  }
  return order_;
}

}  // namespace impulse::inline IMPULSE_PRECISION
