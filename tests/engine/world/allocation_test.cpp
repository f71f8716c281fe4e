// What allocates no memory, once a world has been running for a while.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "../solver/worlds.h"

namespace {
thread_local std::size_t allocations = 0;
}

// Not inlined: GCC would take malloc and free for mismatched. Both forms of new: std::stable_partition uses the second,
// and the default one need not call the first.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size == 0 ? 1 : size);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = operator new(size, std::nothrow)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace impulse::inline IMPULSE_PRECISION::allocation_test {
namespace {

template <class Act>
std::size_t allocations_of(const Act& act) {
  const std::size_t before = allocations;
  act();
  return allocations - before;
}

TEST(Allocation, IsCounted) {
  EXPECT_EQ(allocations_of([] { std::vector<int>(3).push_back(1); }), 2U);
  EXPECT_EQ(allocations_of([] { operator delete(operator new(1, std::nothrow)); }), 1U);
}

TEST(Allocation, IsNotNeededToReadAWorld) {
  for (const bool sleeping : {false, true}) {
    Settings settings;
    settings.sleeping = sleeping;
    settings.contact_events = true;
    World world(settings);
    add_floor(world);
    for (int row = 0; row < 12; ++row) {
      for (int i = 0; i < 12 - row; ++i) {
        world.create_body(at(1.01 * i + .505 * row, .5 + row), Shape::box({real(.5), real(.5)}));
      }
    }
    Part zone{Shape::circle(3), {}};
    zone.sensor = true;
    BodyDef def = at(0, 0);
    def.type = BodyType::fixed;
    world.create_body(def, std::span(&zone, 1));
    run_for(world, 5);
    ASSERT_GT(world.contacts().size() + world.bodies().size() + world.contact_events().touching.size(), 200U);
    run(world, 1);
    EXPECT_EQ(allocations_of([&] {
                EXPECT_FALSE(world.contacts().empty());
                EXPECT_FALSE(world.bodies().empty());
                EXPECT_FALSE(world.contact_events().touching.empty());
                EXPECT_FALSE(world.sensor_events().overlapping.empty());
                world.body(world.bodies().back()).position();
              }),
              0U)
        << (sleeping ? "asleep" : "a pile at rest");
  }
}

}  // namespace
}  // namespace impulse::inline IMPULSE_PRECISION::allocation_test
