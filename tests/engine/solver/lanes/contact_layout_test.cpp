// Contacts laid out in lanes by every version of the kernels, against their rows made one at a time.
#include <gtest/gtest.h>

#include <vector>

#include "../../random_shapes.h"
#include "contacts/contact_rows.h"
#include "solver/lanes/kernels.h"

namespace impulse::inline IMPULSE_PRECISION::contact_layout_test {

namespace {

constexpr std::uint32_t body_count = 20;
constexpr std::uint32_t lanes_of_kind = 32;

/// Contacts that mean nothing, a quarter of the lanes left empty.
struct Heap {
  BodySet bodies;
  std::vector<Contact> contacts;
  std::vector<std::uint32_t> row_of;
  std::vector<Slot> slots[lanes_kinds];
  LayoutInput input{};
  bool rounded;  // all shapes, or none

  explicit Heap(unsigned seed) : rounded(seed % 2 == 0) {
    RandomShapes random(seed);
    for (std::uint32_t i = 0; i < body_count; ++i) {
      bodies.inverse_mass.push_back(i % 5 == 0 ? InverseMass{}
                                               : InverseMass{random.number(.1, 2), random.number(.1, 2)});
      bodies.pose.push_back(random.pose(3));
      row_of.push_back(body_count - 1 - i);
    }
    for (std::uint32_t kind = 0; kind < lanes_kinds; ++kind) {
      slots[kind].resize(lanes_of_kind);
      for (std::uint32_t lane = 0; lane < lanes_of_kind; ++lane) {
        if (lane % 4 == 3) continue;
        Contact contact = contact_of(random);
        if (!rounded) contact.radius_a = contact.radius_b = 0;
        slots[kind][lane].tie.contact = static_cast<std::uint32_t>(contacts.size());
        slots[kind][lane].tie.a = contact.body_a;
        slots[kind][lane].tie.b = contact.body_b;
        slots[kind][lane].web = lane % 2 == 0;
        contacts.push_back(contact);
      }
    }
    static const Contact nothing{};
    input.contacts = contacts.data();
    input.no_contact = &nothing;
    input.masses = bodies.inverse_mass.data();
    input.poses = bodies.pose.data();
    input.row_of = row_of.data();
    input.nobody = body_count;
    input.offset_from_age = 2;
    input.substeps = 4;
  }

  static Contact contact_of(RandomShapes& random) {
    Contact contact;
    contact.body_a = static_cast<std::uint32_t>(random.number(0, body_count - .01));
    contact.body_b = static_cast<std::uint32_t>(random.number(0, body_count - .01));
    contact.count = 2;
    const Rotation q(random.number(-3, 3));
    contact.normal = {q.c, q.s};
    contact.found_separation = {random.number(-.01, .01), random.number(-.01, .01)};
    contact.static_friction = random.number(.3, 1);
    contact.dynamic_friction = random.number(.1, .3);
    contact.radius_a = random.number(0, 1);
    contact.radius_b = random.number(0, 1);
    contact.offset = random.number(0, .001);
    contact.slips = contact.offset < Real{1} / 2000;
    contact.age = static_cast<int>(random.number(0, 3.9));
    for (ContactPoint& p : contact.points) {
      p.arm_a = random.point(1);
      p.arm_b = random.point(1);
      p.normal_impulse = random.number(0, 1);
      p.tangent_impulse = random.number(-.3, .3);
      p.separation = random.number(-.01, .01);
    }
    return contact;
  }
};

template <std::size_t width>
struct Laid {
  std::vector<ContactLanes<1, width>> one{lanes_of_kind / width};
  std::vector<DiscLanes<width>> discs{lanes_of_kind / width};
  std::vector<ContactLanes<2, width>> two{lanes_of_kind / width};
  std::vector<ContactLanes<2, width>> block{lanes_of_kind / width};
  std::vector<SmoothLanes<width>> smooth{lanes_of_kind / width};
  std::vector<SmoothDiscLanes<width>> smooth_discs{lanes_of_kind / width};
  ContactTable<width> table{one.data(),    discs.data(),        two.data(), block.data(),
                            smooth.data(), smooth_discs.data(), nullptr,    nullptr};

  explicit Laid(Heap& heap) {
    for (std::uint32_t kind = 0; kind < lanes_kinds; ++kind) {
      heap.input.slots[kind] = heap.slots[kind].data();
      heap.input.groups[kind] = lanes_of_kind / width;
    }
  }
};

template <std::size_t width, class Lanes>
void expect_rough(const ContactRow& row, bool slips, const Lanes& lanes, std::size_t lane) {
  const auto at = [lane](const Row<width>& row_of_lanes) { return row_of_lanes.lane[lane]; };
  EXPECT_EQ(at(lanes.inertia_b), row.mass_b.i);
  EXPECT_EQ(at(lanes.static_friction), row.static_friction);
  EXPECT_EQ(at(lanes.dynamic_friction), row.dynamic_friction);
  EXPECT_EQ(at(lanes.friction), slips ? row.dynamic_friction : row.static_friction);
  EXPECT_EQ((lanes.slips >> lane & 1U) != 0, slips);
  EXPECT_EQ((lanes.two_frictions >> lane & 1U) != 0, row.static_friction != row.dynamic_friction);
  for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
    const RowPoint& p = row.points[i];
    const PointLanes<width>& laid = lanes.point[i];
    EXPECT_EQ(at(laid.cross_a), p.cross_a);
    EXPECT_EQ(at(laid.cross_b), p.cross_b);
    EXPECT_EQ(at(laid.dot_a), p.dot_a);
    EXPECT_EQ(at(laid.dot_b), p.dot_b);
    EXPECT_EQ(at(laid.dot_a) - at(lanes.radius_a), p.turn_a);
    EXPECT_EQ(at(laid.dot_b) + at(lanes.radius_b), p.turn_b);
    EXPECT_EQ(at(laid.normal_mass), p.normal_mass);
    EXPECT_EQ(at(laid.tangent_mass), p.tangent_mass);
    EXPECT_EQ(at(laid.tangent_impulse), p.tangent_impulse / 4);
  }
}

template <std::size_t width, class Lanes>
void expect_contact(const Heap& heap, const Slot& slot, const Lanes& lanes, std::size_t lane) {
  const auto at = [lane](const Row<width>& row) { return row.lane[lane]; };
  const Contact& contact = heap.contacts[slot.tie.contact];
  const ContactRow row = make_row(heap.bodies, heap.contacts, slot.tie.contact);
  EXPECT_EQ(lanes.a[lane], 4 * heap.row_of[row.a]);
  EXPECT_EQ(lanes.b[lane], 4 * heap.row_of[row.b]);
  EXPECT_EQ(at(lanes.normal_x), row.normal.x);
  EXPECT_EQ(at(lanes.normal_y), row.normal.y);
  const auto tells = [lane](std::uint32_t bits) { return (bits >> lane & 1U) != 0; };
  EXPECT_EQ(tells(lanes.web), slot.web);
  EXPECT_EQ(tells(lanes.fixed), row.mass_a.m == 0 || row.mass_b.m == 0);
  EXPECT_EQ(tells(lanes.aged), contact.age >= 2);
  EXPECT_EQ(tells(lanes.fresh), contact.age == 0);
  EXPECT_EQ(at(lanes.offset), contact.offset);
  for (std::size_t i = 0; i < std::size(lanes.point); ++i) {
    const RowPoint& p = row.points[i];
    const SmoothPointLanes<width>& laid = lanes.point[i];
    EXPECT_EQ(at(laid.separation), p.separation - contact.offset);
    EXPECT_EQ(at(laid.gap), p.separation - contact.offset);
    EXPECT_EQ(at(laid.normal_impulse), p.normal_impulse / 4);
  }
  if constexpr (requires { lanes.static_friction; }) {
    expect_rough<width>(row, contact.slips, lanes, lane);
    EXPECT_EQ(lanes.rounded, heap.rounded);
  } else {
    EXPECT_EQ(at(lanes.point[0].normal_mass), solvable(heap.bodies, contact) ? 1 / (row.mass_a.m + row.mass_b.m) : 0);
  }
}

template <std::size_t width, class Lanes>
void expect_contacts(const Heap& heap, LanesKind kind, const std::vector<Lanes>& all) {
  for (std::size_t i = 0; i < lanes_of_kind; ++i) {
    const Slot& slot = heap.slots[static_cast<std::size_t>(kind)][i];
    const Lanes& lanes = all[i / width];
    if (slot.tie.contact == Slot::empty) {
      EXPECT_EQ(lanes.a[i % width], 4 * body_count);
      EXPECT_EQ(lanes.point[0].normal_impulse.lane[i % width], 0);
      EXPECT_EQ(lanes.fresh >> i % width & 1U, 0U);
    } else {
      expect_contact<width>(heap, slot, lanes, i % width);
    }
  }
}

template <std::size_t width>
void expect_laid_out_and_stored(const ContactPasses<width>& passes, unsigned seed) {
  Heap heap(seed);
  Laid<width> laid(heap);
  passes.lay_out(laid.table, heap.input);
  expect_contacts<width>(heap, LanesKind::one, laid.one);
  expect_contacts<width>(heap, LanesKind::discs, laid.discs);
  expect_contacts<width>(heap, LanesKind::two, laid.two);
  expect_contacts<width>(heap, LanesKind::block, laid.block);
  expect_contacts<width>(heap, LanesKind::smooth, laid.smooth);
  expect_contacts<width>(heap, LanesKind::smooth_discs, laid.smooth_discs);

  const std::vector<Contact> before = heap.contacts;
  for (auto& lanes : laid.two) {
    for (std::size_t lane = 0; lane < width; ++lane) {
      lanes.offset.lane[lane] += 1;
      lanes.point[1].tangent_impulse.lane[lane] *= 2;
      lanes.point[1].total_normal.lane[lane] = 7;
    }
  }
  for (SmoothDiscLanes<width>& lanes : laid.smooth_discs) {
    for (std::size_t lane = 0; lane < width; ++lane) {
      lanes.offset.lane[lane] += 1;
      lanes.point[0].total_normal.lane[lane] = 7;
    }
  }
  passes.store(laid.table, heap.input);
  for (const Slot& slot : heap.slots[static_cast<std::size_t>(LanesKind::smooth_discs)]) {
    if (slot.tie.contact == Slot::empty) continue;
    const Contact& now = heap.contacts[slot.tie.contact];
    const Contact& then = before[slot.tie.contact];
    EXPECT_EQ(now.offset, then.offset + 1);
    EXPECT_EQ(now.points[0].normal_impulse, then.points[0].normal_impulse);
    EXPECT_EQ(now.points[0].tangent_impulse, 0);
    EXPECT_EQ(now.points[0].total_normal_impulse, 7);
    EXPECT_EQ(now.points[0].total_tangent_impulse, 0);
  }
  for (const Slot& slot : heap.slots[static_cast<std::size_t>(LanesKind::two)]) {
    if (slot.tie.contact == Slot::empty) continue;
    const Contact& now = heap.contacts[slot.tie.contact];
    const Contact& then = before[slot.tie.contact];
    EXPECT_EQ(now.offset, then.offset + 1);
    EXPECT_EQ(now.points[0].normal_impulse, then.points[0].normal_impulse);
    EXPECT_EQ(now.points[1].tangent_impulse, 2 * then.points[1].tangent_impulse);
    EXPECT_EQ(now.points[1].total_normal_impulse, 7);
    EXPECT_EQ(now.points[1].separation, then.points[1].separation);
  }
}

TEST(ContactLayout, CopiesRowsToLanesAndBack) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    for (const InstructionSet set : runnable_instruction_sets()) {
      const SolverKernels& version = solver_kernels(set);
      if (version.contacts_by_eight != nullptr) expect_laid_out_and_stored(*version.contacts_by_eight, seed);
      if (version.contacts_by_sixteen != nullptr) expect_laid_out_and_stored(*version.contacts_by_sixteen, seed);
    }
  }
}

}  // namespace

}  // namespace impulse::inline IMPULSE_PRECISION::contact_layout_test
