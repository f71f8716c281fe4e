#include <cstdio>
#include <memory>
#include <new>

#include "c_api/convert.h"

namespace impulse::c_api {

namespace {

thread_local char last_error[512] = "";

template <class Enum>
Enum checked(Enum value, Enum last, const char* what) {
  if (static_cast<int>(value) < 0 || value > last) throw std::invalid_argument(std::string(what) + " is unknown");
  return value;
}

/// Over the settings that C does not have.
Settings from_c(const impulse_settings& from, Settings to) {
  to.gravity = c_api::from_c(from.gravity);
  to.dt = from.dt;
  to.solver = name_of(static_cast<SolverType>(checked(from.solver, IMPULSE_SOFT_STEP, "the solver")));
  to.iterations = from.iterations;
  to.substeps = from.substeps;
  to.workers = from.workers;
  to.continuous = static_cast<Continuous>(checked(from.continuous, IMPULSE_CONTINUOUS_ON, "continuous"));
  to.contact_events = from.contact_events;
  to.sleeping = from.sleeping;
  to.sleep_linear_speed = from.sleep_linear_speed;
  to.sleep_angular_speed = from.sleep_angular_speed;
  to.sleep_time = from.sleep_time;
  return to;
}

impulse_settings to_c(const Settings& from) {
  impulse_settings to{};
  to.gravity = c_api::to_c(from.gravity);
  to.dt = from.dt;
  to.solver = from.solver == name_of(SolverType::soft_step) ? IMPULSE_SOFT_STEP : IMPULSE_ACCURATE;
  to.iterations = from.iterations;
  to.substeps = from.substeps;
  to.workers = from.workers;
  to.continuous = static_cast<impulse_continuous>(from.continuous);
  to.contact_events = from.contact_events;
  to.sleeping = from.sleeping;
  to.sleep_linear_speed = from.sleep_linear_speed;
  to.sleep_angular_speed = from.sleep_angular_speed;
  to.sleep_time = from.sleep_time;
  return to;
}

}  // namespace

impulse_status failed(impulse_status status, const char* what) noexcept {
  std::snprintf(last_error, sizeof(last_error), "%s", what);
  return status;
}

impulse_status failed() noexcept {
  try {
    throw;
  } catch (const std::out_of_range& error) {
    return failed(IMPULSE_STALE, error.what());
  } catch (const std::invalid_argument& error) {
    return failed(IMPULSE_INVALID, error.what());
  } catch (const std::domain_error& error) {
    return failed(IMPULSE_UNSOLVABLE, error.what());
  } catch (const std::logic_error& error) {
    return failed(IMPULSE_MISUSED, error.what());
  } catch (const std::bad_alloc&) {
    return failed(IMPULSE_NO_MEMORY, "out of memory");
  } catch (const std::exception& error) {
    return failed(IMPULSE_FAULT, error.what());
  } catch (...) {
    return failed(IMPULSE_FAULT, "unknown");
  }
}

}  // namespace impulse::c_api

using namespace impulse::c_api;

const char* impulse_last_error() { return last_error; }

impulse_settings impulse_default_settings() { return to_c(impulse::Settings{}); }

impulse_status impulse_create_world(const impulse_settings* settings, impulse_world** world) {
  return guarded([&] {
    impulse_world*& to = given(world, "the place for the world");
    const impulse::Settings chosen = settings == nullptr ? impulse::Settings{} : from_c(*settings, impulse::Settings{});
    to = new impulse_world{impulse::World(chosen)};
  });
}

void impulse_destroy_world(impulse_world* world) { delete world; }

impulse_status impulse_copy_world(const impulse_world* world, impulse_world** copy) {
  return guarded([&] {
    impulse_world*& to = given(copy, "the place for the copy");
    to = new impulse_world{impulse::World(world_of(world))};
  });
}

impulse_status impulse_restore_world(impulse_world* world, const impulse_world* saved) {
  return guarded([&] { world_of(world) = world_of(saved); });
}

impulse_status impulse_get_settings(const impulse_world* world, impulse_settings* settings) {
  return guarded([&] { given(settings, "the place for the settings") = to_c(world_of(world).settings()); });
}

impulse_status impulse_set_settings(impulse_world* world, const impulse_settings* settings) {
  return guarded([&] {
    impulse::World& of = world_of(world);
    of.set_settings(from_c(given(settings, "the settings"), of.settings()));
  });
}

impulse_status impulse_step(impulse_world* world) {
  return guarded([&] { world_of(world).step(); });
}

impulse_status impulse_set_filter(impulse_world* world, impulse_filter filter, void* context) {
  return guarded([&] {
    if (filter == nullptr) return world_of(world).set_filter({});
    world_of(world).set_filter([filter, context](impulse::PartId a, impulse::PartId b) {
      return filter(context, impulse::c_api::to_c(a), impulse::c_api::to_c(b));
    });
  });
}

impulse_status impulse_set_pre_solve(impulse_world* world, impulse_pre_solve pre_solve, void* context) {
  return guarded([&] {
    if (pre_solve == nullptr) return world_of(world).set_pre_solve({});
    world_of(world).set_pre_solve([pre_solve, context](impulse::PreSolveContact& contact) {
      const auto part = [](impulse::BodyId body, std::uint16_t index) {
        return impulse::c_api::to_c(impulse::PartId{body, index});
      };
      impulse_pre_solve_contact shown{};
      shown.a = part(contact.a, contact.part_a);
      shown.b = part(contact.b, contact.part_b);
      shown.point = impulse::c_api::to_c(contact.point);
      shown.normal = impulse::c_api::to_c(contact.normal);
      shown.separation = contact.separation;
      shown.enabled = contact.enabled;
      shown.static_friction = contact.static_friction;
      shown.dynamic_friction = contact.dynamic_friction;
      shown.restitution = contact.restitution;
      pre_solve(context, &shown);
      contact.enabled = shown.enabled;
      contact.static_friction = shown.static_friction;
      contact.dynamic_friction = shown.dynamic_friction;
      contact.restitution = shown.restitution;
    });
  });
}
