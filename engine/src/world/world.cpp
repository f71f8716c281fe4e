#include "impulse/world.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <string>

#include "core/method_list.h"
#include "core/stages.h"
#include "world/world_state.h"

namespace impulse::inline IMPULSE_PRECISION {

namespace {

/// Marks the bodies that contacts or joints acted on in this step. Sleeping bodies keep their mark, because their
/// contacts are not among these.
void mark_held(BodySet& bodies, std::span<const Contact> contacts, std::span<const ActiveJoint> joints) {
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies.held[i] &= bodies.asleep[i];
  for (const Contact& contact : contacts) {
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.count); ++p) {
      if (contact.points[p].total_normal_impulse == 0) continue;
      bodies.held[contact.body_a] = 1;
      bodies.held[contact.body_b] = 1;
    }
  }
  for (const ActiveJoint& joint : joints) {
    if (joint.block.equations == 0) continue;
    bodies.held[joint.block.a] = 1;
    bodies.held[joint.block.b] = 1;
  }
}

/// While one exists, callbacks of a step may be running.
class SteppingScope {
 public:
  explicit SteppingScope(bool& stepping) : stepping_(stepping) { stepping_ = true; }
  SteppingScope(const SteppingScope&) = delete;
  SteppingScope& operator=(const SteppingScope&) = delete;
  ~SteppingScope() { stepping_ = false; }

 private:
  bool& stepping_;
};

}  // namespace

World::World(const Settings& settings) : state_(std::make_unique<State>(settings)) {}
World::World(const World& other) : state_(other.state_->copy()) {}
World& World::operator=(const World& other) {
  if (this != &other) state_ = other.state_->copy();
  return *this;
}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::step() {
  state_->refuse_in_step();
  if (state_->callbacks_running > 0) throw std::logic_error("World::step called from a callback of the same world");
  const SteppingScope scope(state_->stepping);
  state_->step();
  state_->sensors.update(state_->bodies);
}

void World::State::step() {
  start_stages();
  forces.gravity = settings.gravity;
  const bool stops = settings.contacts && settings.continuous != Continuous::off;
  if (stops) continuous.store_start(bodies);
  const Margin margin = solver->margin(settings);
  if (settings.sleeping && !sleep.wake_before_step(margin)) {
    if (settings.contact_events) touches.note(bodies, {});
    bodies.clear_forces();
    return;
  }
  end_stage("begin");
  if (settings.contacts) {
    find_contacts(margin);
    contacts.pre_solve(bodies, pre_solve);
  }
  const bool contacts_needed = settings.sleeping || pre_solve || integrator->needs_held();
  StepData data{bodies,   contacts.rows(), joints.activate(bodies), forces,          *integrator,
                settings, *workers,        contacts.changes(),      !contacts_needed};
  end_stage("activate joints");
  const std::uint64_t pile_changes = bodies.pile_changes;
  solver->step(data);
  if (pile_changes != bodies.pile_changes) contacts.leave_to_piles(bodies);
  if (stops) continuous.clamp_to_impacts(bodies, {joints, filter, contacts}, settings.continuous);
  end_stage("continuous");
  joints.store();
  if (integrator->needs_held()) mark_held(bodies, contacts.rows(), data.joints);
  if (settings.contact_events) touches.note(bodies, awake_contacts());
  end_stage("note touches");
  bodies.clear_forces();
  if (settings.sleeping) sleep.update_after_step(settings, margin);
  end_stage("sleep");
}

std::span<const Contact> World::State::awake_contacts() {
  const RestingPiles* resting = solver->resting();
  if (resting == nullptr || resting->empty()) return contacts.rows();
  contacts_of_piles.clear();
  resting->append(bodies, contacts_of_piles);
  std::sort(contacts_of_piles.begin(), contacts_of_piles.end(), comes_before);
  all_contacts.clear();
  std::merge(contacts.rows().begin(), contacts.rows().end(), contacts_of_piles.begin(), contacts_of_piles.end(),
             std::back_inserter(all_contacts), comes_before);
  return all_contacts;
}

const Settings& World::settings() const { return state_->settings; }

void World::set_settings(const Settings& settings) { state_->adopt(settings); }

void World::set_gravity(Vec2 gravity) {
  Settings changed = settings();
  changed.gravity = gravity;
  set_settings(changed);
}

void World::set_dt(Real dt) {
  Settings changed = settings();
  changed.dt = dt;
  set_settings(changed);
}

BodyId World::create_body(const BodyDef& def, std::span<const Part> parts) {
  state_->refuse_in_step();
  const BodyId id = state_->bodies.add(def, parts);
  insert_body(id);
  return id;
}

BodyId World::create_body(const BodyDef& def, const Shape& shape, const Material& material) {
  const Part part{shape, material};
  return create_body(def, std::span(&part, 1));
}

void World::remove_body(BodyId id) { state_->change(State::Change::remove, id); }
void World::insert_body(BodyId id) { state_->change(State::Change::insert, id); }
void World::destroy_body(BodyId id) { state_->change(State::Change::destroy, id); }

ForceId World::add_force(const Force& force) {
  state_->refuse_in_step();
  const ForceId id = state_->forces.add(force, state_->bodies);
  for (const std::uint32_t i : state_->forces.bodies_of(id, state_->bodies)) state_->wake(i);
  return id;
}

void World::remove_force(ForceId id) {
  state_->refuse_in_step();
  for (const std::uint32_t i : state_->forces.bodies_of(id, state_->bodies)) state_->wake(i);
  state_->forces.remove(id);
}

bool World::contains(ForceId id) const { return state_->forces.contains(id); }

JointId World::create_joint(const Joint& joint) {
  state_->refuse_in_step();
  const JointId id = state_->joints.add(joint, state_->bodies, state_->forces);
  state_->wake_ends(id);
  return id;
}

void World::destroy_joint(JointId id) {
  state_->wake_ends(id);
  state_->joints.remove(id, state_->forces);
}

bool World::contains(JointId id) const { return state_->joints.contains(id); }

void World::set_motor(JointId id, const std::optional<Motor>& motor) {
  state_->refuse_in_step();
  state_->joints.set_motor(id, motor);
  state_->wake_ends(id);
}

void World::set_limits(JointId id, const std::optional<Limits>& limits) {
  state_->refuse_in_step();
  state_->joints.set_limits(id, limits);
  state_->wake_ends(id);
}

void World::set_filter(PartFilter filter) {
  state_->refuse_in_step();
  state_->let_go();
  state_->sleep.wake_all();
  state_->filter = std::move(filter);
}

void World::set_pre_solve(PreSolve pre_solve) {
  state_->refuse_in_step();
  state_->let_go();
  state_->pre_solve = std::move(pre_solve);
}

Vec2 World::joint_impulse(JointId id) const { return state_->joints.impulse(id); }

bool World::contains(BodyId id) const { return state_->bodies.contains(id); }

Body World::body(BodyId id) {
  state_->row(id);
  return {*this, id};
}

std::span<const BodyId> World::bodies() const {
  std::vector<BodyId>& ids = state_->listed_bodies;
  ids.clear();
  for (std::size_t i = 0; i < state_->bodies.size(); ++i) {
    if (state_->bodies.detail[i].inserted) ids.push_back(state_->bodies.id(i));
  }
  return ids;
}

std::size_t World::body_count() const {
  std::size_t count = 0;
  for (const BodyDetail& body : state_->bodies.detail) count += body.inserted ? 1 : 0;
  return count;
}

std::size_t World::awake_count() const {
  const auto& masses = state_->bodies.inverse_mass;
  return static_cast<std::size_t>(std::count_if(masses.begin(), masses.end(), [](InverseMass m) { return m.m > 0; }));
}

void World::State::refuse_in_step() const {
  if (stepping) {
    throw std::logic_error("World: the filter and the pre-solve callback may read the world, not change or copy it");
  }
}

void World::State::adopt(const Settings& chosen) {
  refuse_in_step();
  validate(chosen);
  const bool first = solver == nullptr;
  if (!first) let_go();
  if (!first && chosen.dt != settings.dt) contacts.stretch_rest(chosen.dt / settings.dt);
  // Wake everything if the conditions of rest change; time step and accuracy don't count.
  if (!chosen.sleeping || chosen.gravity != settings.gravity || chosen.solver != settings.solver ||
      chosen.friction_mixing != settings.friction_mixing || chosen.contacts != settings.contacts) {
    sleep.wake_all();
  }
  if (settings.contacts && !chosen.contacts) {
    for (std::size_t i = 0; i < bodies.size(); ++i) contacts.forget(i);
  }
  if (first || chosen.solver != settings.solver) {
    solver = MethodList<Solver>::make(chosen.solver);
  }
  if (first || chosen.integrator != settings.integrator) integrator = MethodList<Integrator>::make(chosen.integrator);
  if (first || chosen.broad_phase != settings.broad_phase)
    broad_phase = MethodList<BroadPhase>::make(chosen.broad_phase);
  if (!chosen.contact_events) touches = {};
  if (first || chosen.workers != settings.workers) workers = std::make_unique<Workers>(chosen.workers);
  settings = chosen;
}

std::unique_ptr<World::State> World::State::copy() const {
  refuse_in_step();
  if (callbacks_running > 0) throw std::logic_error("World: copied in a callback of the same world");
  return std::make_unique<State>(*this);
}

World::State::State(const State& other)
    : settings(other.settings),
      solver(MethodList<Solver>::make(settings.solver)),
      integrator(MethodList<Integrator>::make(settings.integrator)),
      broad_phase(MethodList<BroadPhase>::make(settings.broad_phase)),
      workers(std::make_unique<Workers>(settings.workers)),
      bodies(other.bodies),
      contacts(other.contacts),
      touches(other.touches),
      sensors(other.sensors),
      forces(other.forces),
      joints(other.joints),
      filter(other.filter),
      pre_solve(other.pre_solve) {
  sleep.copy(other.sleep);
  if (RestingPiles* resting = solver->resting()) resting->copy(*other.solver->resting());
}

void World::State::wake_ends(JointId id) {
  const auto [a, b] = joints.bodies_of(id);
  wake(a);
  wake(b);
}

void World::State::find_contacts(const Margin& margin) {
  const SearchInput input{bodies, *broad_phase, settings, margin, solver->contact_persistence(), joints, filter};
  RestingPiles* resting = solver->resting();
  if (resting == nullptr) return contacts.find(input);
  std::vector<Contact> returned;
  resting->rouse(bodies, returned);
  contacts.put_in(returned);
  contacts.find(input);
  while (!contacts.hit_piles().empty()) {
    returned.clear();
    for (const std::uint32_t pile : contacts.hit_piles()) resting->let_go(pile, bodies, returned);
    contacts.forget_new();
    contacts.put_in(returned);
    contacts.find(input);
  }
}

void World::State::let_go() {
  RestingPiles* resting = solver->resting();
  if (resting == nullptr) return;
  std::vector<Contact> kept;
  resting->let_go(bodies, kept);
  contacts.put_in(kept);
}

void World::State::let_go(std::size_t i) {
  if (bodies.pile[i] == 0) return;
  std::vector<Contact> kept;
  solver->resting()->let_go(bodies.pile[i], bodies, kept);
  contacts.put_in(kept);
}

void World::State::wake(std::size_t i) {
  refuse_in_step();
  let_go(i);
  sleep.wake(i);
}

// The bodies that rest on a fixed or kinematic body may be of any pile.
void World::State::disturb(std::size_t i) {
  refuse_in_step();
  bodies.dynamic(i) ? let_go(i) : let_go();
  sleep.disturb(i);
}

std::size_t World::State::row(BodyId id) const {
  if (!bodies.contains(id)) {
    throw std::out_of_range("World: no body " + std::to_string(id.index) + " of generation " +
                            std::to_string(id.generation) + "; it was destroyed or never in this world");
  }
  return id.index;
}

void World::State::change(Change what, BodyId id) {
  refuse_in_step();
  row(id);
  if (callbacks_running > 0) {
    deferred.emplace_back(what, id);
  } else {
    apply(what, id);
  }
}

void World::State::apply(Change what, BodyId id) {
  const std::size_t i = id.index;
  if (what == Change::insert) {
    bodies.insert(i);
    return disturb(i);
  }
  if (bodies.detail[i].inserted) disturb(i);
  contacts.forget(i);
  if (what == Change::remove) return bodies.remove(i);
  joints.forget(id);
  forces.forget(id);
  bodies.destroy(i);
}

World::State::CallbackScope::~CallbackScope() {
  if (--state_.callbacks_running > 0) return;
  // A body may be destroyed twice in one callback; skip the second time.
  for (const auto& [what, id] : state_.deferred) {
    if (state_.bodies.contains(id)) state_.apply(what, id);
  }
  state_.deferred.clear();
}

}  // namespace impulse::inline IMPULSE_PRECISION
