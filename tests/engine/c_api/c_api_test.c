/* The engine from C11: every function of impulse.h is called, and what a game relies on is checked. */
#include <impulse.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void check(bool holds, const char* what, int line) {
  if (holds) return;
  ++failures;
  fprintf(stderr, "%s:%d: %s\n", __FILE__, line, what);
}
#define CHECK(holds) check((holds), #holds, __LINE__)
#define OK(call) CHECK((call) == IMPULSE_OK)

static bool near(float a, float b, float by) { return a - b < by && b - a < by; }

static impulse_body_id add(impulse_world* world, impulse_body_type type, float x, float y, impulse_shape shape) {
  impulse_body_def def = impulse_default_body();
  def.type = type;
  def.position.x = x;
  def.position.y = y;
  impulse_body_id id = {0, 0};
  OK(impulse_create_body(world, &def, &shape, 1, &id));
  return id;
}

static impulse_body body(impulse_world* world, impulse_body_id id) {
  impulse_body state;
  memset(&state, 0, sizeof state);
  OK(impulse_get_body(world, id, &state));
  return state;
}

static void run(impulse_world* world, int steps) {
  for (int i = 0; i < steps; ++i) OK(impulse_step(world));
}

static bool same(impulse_body_id a, impulse_body_id b) { return a.index == b.index && a.generation == b.generation; }

static void a_ball_falls_and_rolls_back(void) {
  impulse_world* world = NULL;
  OK(impulse_create_world(NULL, &world));
  const impulse_body_id floor = add(world, IMPULSE_FIXED, 0, 0, impulse_half_space((impulse_vec2){0, 1}, 0));
  impulse_shape ball_shape = impulse_circle(.5F, (impulse_vec2){0, 0});
  CHECK(near(ball_shape.material.static_friction, .6F, 1e-6F));
  const impulse_body_id ball = add(world, IMPULSE_DYNAMIC, 0, 5, ball_shape);
  run(world, 12);
  CHECK(near(body(world, ball).position.y, 5 - .5F * 10 * .04F, 1e-4F));
  impulse_world* saved = NULL;
  OK(impulse_copy_world(world, &saved));
  run(world, 200);
  const impulse_body rest = body(world, ball);
  CHECK(near(rest.position.y, .5F, .01F));
  CHECK(near(rest.mass, 3.14159F * .25F, 1e-4F));
  OK(impulse_restore_world(world, saved));
  run(world, 200);
  const impulse_body again = body(world, ball);
  CHECK(memcmp(&again.position, &rest.position, sizeof rest.position) == 0);

  impulse_contact contacts[4];
  size_t count = 0;
  OK(impulse_contacts(world, contacts, 4, &count));
  CHECK(count == 1);
  CHECK(same(contacts[0].a, floor) && same(contacts[0].b, ball));
  CHECK(near(contacts[0].normal_impulse * 60, rest.mass * 10, .01F));
  OK(impulse_contacts(world, NULL, 0, &count));
  CHECK(count == 1);
  impulse_body_id ids[8];
  OK(impulse_bodies(world, ids, 1, &count));
  CHECK(count == 2 && same(ids[0], floor));

  OK(impulse_set_velocity(world, ball, (impulse_vec2){1, 2}, 3));
  OK(impulse_set_pose(world, ball, (impulse_vec2){4, 4}, 0));
  OK(impulse_apply_force(world, ball, (impulse_vec2){0, 1}, (impulse_vec2){4, 4}));
  OK(impulse_apply_torque(world, ball, 1));
  OK(impulse_apply_impulse(world, ball, (impulse_vec2){rest.mass, 0}, (impulse_vec2){4, 4}));
  CHECK(near(body(world, ball).velocity.x, 2, 1e-5F));
  OK(impulse_set_layers(world, ball, (impulse_layers){2, 2}));
  OK(impulse_wake(world, ball));
  OK(impulse_destroy_body(world, ball));
  CHECK(!impulse_has_body(world, ball) && impulse_has_body(world, floor));
  impulse_destroy_world(saved);
  impulse_destroy_world(world);
}

static void joints_drive_and_limit(void) {
  impulse_settings settings = impulse_default_settings();
  settings.solver = IMPULSE_SOFT_STEP;
  impulse_world* world = NULL;
  OK(impulse_create_world(&settings, &world));
  OK(impulse_get_settings(world, &settings));
  CHECK(settings.solver == IMPULSE_SOFT_STEP && near(settings.gravity.y, -10, 1e-6F));
  settings.solver = IMPULSE_ACCURATE;
  OK(impulse_set_settings(world, &settings));

  impulse_body_def def = impulse_default_body();
  def.type = IMPULSE_FIXED;
  const impulse_vec2 line[] = {{20, 0}, {0, 0}, {-20, 0}};
  impulse_body_id ground;
  OK(impulse_create_chain(world, &def, line, 3, false, NULL, &ground));
  const impulse_vec2 box = {1, .2F};
  const impulse_body_id lift = add(world, IMPULSE_DYNAMIC, 0, 2, impulse_box(box, (impulse_vec2){0, 0}, 0));
  impulse_joint shaft;
  memset(&shaft, 0, sizeof shaft);
  shaft.type = IMPULSE_PRISMATIC;
  shaft.a = ground;
  shaft.b = lift;
  shaft.anchor = (impulse_vec2){0, 2};
  shaft.axis = (impulse_vec2){0, 1};
  shaft.has_limits = true;
  shaft.limits = (impulse_limits){0, 1};
  impulse_joint_id id;
  OK(impulse_create_joint(world, &shaft, &id));
  OK(impulse_set_motor(world, id, &(impulse_motor){1, 500}));
  run(world, 30);
  CHECK(near(body(world, lift).position.y, 2.5F, .01F));
  run(world, 60);
  CHECK(near(body(world, lift).position.y, 3, .01F));
  OK(impulse_set_limits(world, id, &(impulse_limits){0, 2}));
  run(world, 30);
  CHECK(near(body(world, lift).position.y, 3.5F, .02F));
  impulse_vec2 impulse = {0, 0};
  OK(impulse_joint_impulse(world, id, &impulse));
  CHECK(impulse.y > 0);
  OK(impulse_set_motor(world, id, NULL));
  OK(impulse_destroy_joint(world, id));
  CHECK(impulse_destroy_joint(world, id) == IMPULSE_STALE);
  shaft.type = (impulse_joint_type)77;
  CHECK(impulse_create_joint(world, &shaft, &id) == IMPULSE_INVALID);
  impulse_destroy_world(world);
}

struct platform {
  impulse_body_id id;
  int calls;
  impulse_world* world;
};

static void one_way(void* context, impulse_pre_solve_contact* contact) {
  struct platform* platform = context;
  ++platform->calls;
  const bool first = same(contact->a.body, platform->id);
  if (!first && !same(contact->b.body, platform->id)) return;
  const float up = first ? contact->normal.y : -contact->normal.y;
  contact->enabled = up > .7F && contact->separation > -.05F;
  CHECK(impulse_step(platform->world) == IMPULSE_MISUSED);
  CHECK(impulse_destroy_body(platform->world, platform->id) == IMPULSE_MISUSED);
}

static bool not_odd(void* context, impulse_part_id a, impulse_part_id b) {
  ++*(int*)context;
  return a.body.index % 2 == 0 || b.body.index % 2 == 0;
}

static void callbacks_decide(void) {
  impulse_settings settings = impulse_default_settings();
  settings.contact_events = true;
  settings.workers = 2;
  impulse_world* world = NULL;
  OK(impulse_create_world(&settings, &world));
  add(world, IMPULSE_FIXED, 0, 0, impulse_half_space((impulse_vec2){0, 1}, 0));
  const impulse_vec2 corners[] = {{-2, -.05F}, {2, -.05F}, {2, .05F}, {-2, .05F}};
  struct platform platform = {add(world, IMPULSE_FIXED, 0, 1.6F, impulse_polygon(corners, 4)), 0, world};
  const impulse_body_id player =
      add(world, IMPULSE_DYNAMIC, 0, .6F, impulse_capsule((impulse_vec2){0, -.1F}, (impulse_vec2){0, .1F}, .4F));
  OK(impulse_set_velocity(world, player, (impulse_vec2){0, 7}, 0));
  OK(impulse_set_pre_solve(world, one_way, &platform));
  impulse_shape zone = impulse_box((impulse_vec2){1, .2F}, (impulse_vec2){0, 0}, 0);
  zone.sensor = true;
  const impulse_body_id goal = add(world, IMPULSE_FIXED, 0, 2.5F, zone);
  size_t entered = 0;
  size_t landed = 0;
  for (int i = 0; i < 240; ++i) {
    OK(impulse_step(world));
    impulse_overlap overlaps[2];
    size_t count = 0;
    OK(impulse_sensor_events(world, IMPULSE_BEGUN, overlaps, 2, &count));
    if (count > 0) CHECK(same(overlaps[0].sensor.body, goal) && same(overlaps[0].visitor.body, player));
    entered += count;
    impulse_touch touches[2];
    OK(impulse_contact_events(world, IMPULSE_BEGUN, touches, 2, &count));
    landed += count;
    OK(impulse_contact_events(world, IMPULSE_LASTING, NULL, 0, &count));
    OK(impulse_contact_events(world, IMPULSE_ENDED, NULL, 0, &count));
  }
  CHECK(entered > 0 && landed > 0 && platform.calls > 0);
  CHECK(near(body(world, player).position.y, 2.15F, .02F));

  OK(impulse_set_pre_solve(world, NULL, NULL));
  int asked = 0;
  OK(impulse_set_filter(world, not_odd, &asked));
  OK(impulse_set_pose(world, player, (impulse_vec2){0, 2.15F}, 0));
  run(world, 30);
  CHECK(asked > 0);
  CHECK(near(body(world, player).position.y, 2.15F, .02F));
  OK(impulse_set_filter(world, NULL, NULL));

  impulse_hit hit;
  OK(impulse_ray_cast(world, (impulse_vec2){0, 9}, (impulse_vec2){0, -9}, ~0U, &hit));
  CHECK(hit.found && same(hit.part.body, player) && hit.normal.y > .99F);
  const impulse_shape boulder = impulse_circle(.3F, (impulse_vec2){0, 0});
  OK(impulse_shape_cast(world, &boulder, (impulse_vec2){1.5F, 9}, 0, (impulse_vec2){0, -9}, ~0U, &hit));
  CHECK(hit.found && same(hit.part.body, platform.id));
  OK(impulse_ray_cast(world, (impulse_vec2){50, 9}, (impulse_vec2){50, 8}, ~0U, &hit));
  CHECK(!hit.found);
  impulse_destroy_world(world);
}

static void mistakes_are_told(void) {
  impulse_settings settings = impulse_default_settings();
  settings.dt = -1;
  impulse_world* world = NULL;
  CHECK(impulse_create_world(&settings, &world) == IMPULSE_INVALID);
  CHECK(world == NULL && strstr(impulse_last_error(), "dt") != NULL);
  settings.dt = .01F;
  settings.solver = (impulse_solver)9;
  CHECK(impulse_create_world(&settings, &world) == IMPULSE_INVALID);
  CHECK(impulse_step(NULL) == IMPULSE_INVALID);
  OK(impulse_create_world(NULL, &world));
  const impulse_body_def def = impulse_default_body();
  impulse_body_id id = {7, 7};
  CHECK(impulse_create_body(world, &def, NULL, 0, &id) == IMPULSE_INVALID);
  CHECK(impulse_create_body(world, &def, NULL, 1, &id) == IMPULSE_INVALID);
  impulse_shape shape = impulse_segment((impulse_vec2){0, 0}, (impulse_vec2){1, 0});
  CHECK(impulse_create_body(world, &def, &shape, 1, &id) == IMPULSE_INVALID); /* no mass */
  shape = impulse_circle(-1, (impulse_vec2){0, 0});
  CHECK(impulse_create_body(world, &def, &shape, 1, &id) == IMPULSE_INVALID);
  impulse_vec2 many[9];
  memset(many, 0, sizeof many);
  shape = impulse_polygon(many, 9);
  CHECK(impulse_create_body(world, &def, &shape, 1, &id) == IMPULSE_INVALID);
  CHECK(strstr(impulse_last_error(), "8 points") != NULL);
  impulse_body state;
  CHECK(impulse_get_body(world, id, &state) == IMPULSE_STALE);
  size_t count = 0;
  CHECK(impulse_contact_events(world, IMPULSE_BEGUN, NULL, 0, &count) == IMPULSE_MISUSED);
  CHECK(impulse_bodies(world, NULL, 0, &count) == IMPULSE_OK && count == 0);
  impulse_destroy_world(world);
  impulse_destroy_world(NULL);
}

int main(void) {
  a_ball_falls_and_rolls_back();
  joints_drive_and_limit();
  callbacks_decide();
  mistakes_are_told();
  return failures == 0 ? 0 : 1;
}
