/* impulse for C: the same world as <impulse/world.h>, which says more about each call. In float: link impulse::impulse.
 *
 * Units are m, kg, s, rad and N; vectors are in the world frame unless it says otherwise. All calls with a status
 * return IMPULSE_OK, or change nothing and tell why in impulse_last_error(). A world may be used by one thread at a
 * time. */
#ifndef IMPULSE_H
#define IMPULSE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* C may pass a number that no constant has; C++ may read it only from an enum of a fixed type. */
#ifdef __cplusplus
#define IMPULSE_AN_INT : int
#else
#define IMPULSE_AN_INT
#endif

typedef enum impulse_status {
  IMPULSE_OK = 0,
  IMPULSE_INVALID,    /* an argument is out of its range */
  IMPULSE_STALE,      /* a handle of something destroyed, or of another world */
  IMPULSE_MISUSED,    /* not allowed now, such as changing a world in a callback of its step */
  IMPULSE_UNSOLVABLE, /* the solver cannot solve this step; nothing moved */
  IMPULSE_NO_MEMORY,
  IMPULSE_FAULT /* a mistake of the engine */
} impulse_status;

/* What was wrong with this thread's last call that failed; valid until its next one. */
const char* impulse_last_error(void);

typedef struct impulse_vec2 {
  float x, y;
} impulse_vec2;

/* ---- Worlds ---- */

typedef struct impulse_world impulse_world;

typedef enum impulse_solver IMPULSE_AN_INT { IMPULSE_ACCURATE, IMPULSE_SOFT_STEP } impulse_solver;
typedef enum impulse_continuous IMPULSE_AN_INT {
  IMPULSE_CONTINUOUS_OFF,
  IMPULSE_CONTINUOUS_AUTOMATIC,
  IMPULSE_CONTINUOUS_ON
} impulse_continuous;

typedef struct impulse_settings {
  impulse_vec2 gravity;
  float dt; /* s, one step */
  impulse_solver solver;
  int iterations, substeps;
  int workers; /* threads; the bits are the same for any number */
  impulse_continuous continuous;
  bool contact_events;
  bool sleeping;
  float sleep_linear_speed, sleep_angular_speed, sleep_time;
} impulse_settings;

impulse_settings impulse_default_settings(void);

/* NULL settings are the default ones. Destroy the world with impulse_destroy_world(), which accepts NULL. */
impulse_status impulse_create_world(const impulse_settings* settings, impulse_world** world);
void impulse_destroy_world(impulse_world* world);
/* A copy has the same handles and goes on with the same bits: restore it to roll back. */
impulse_status impulse_copy_world(const impulse_world* world, impulse_world** copy);
impulse_status impulse_restore_world(impulse_world* world, const impulse_world* saved);
impulse_status impulse_get_settings(const impulse_world* world, impulse_settings* settings);
impulse_status impulse_set_settings(impulse_world* world, const impulse_settings* settings);
/* Advances by dt. */
impulse_status impulse_step(impulse_world* world);

/* ---- Shapes: values in the frame of their body ---- */

typedef struct impulse_material {
  float density; /* kg/m^2 */
  float static_friction, dynamic_friction;
  float restitution; /* 0 ... 1 */
} impulse_material;

/* Two parts collide if the category of each shares a bit with the other's mask. */
typedef struct impulse_layers {
  uint32_t category, mask;
} impulse_layers;

typedef enum impulse_shape_type IMPULSE_AN_INT {
  IMPULSE_CIRCLE,
  IMPULSE_BOX,
  IMPULSE_POLYGON,
  IMPULSE_CAPSULE,
  IMPULSE_SEGMENT,
  IMPULSE_HALF_SPACE
} impulse_shape_type;

/* Make it with one of the functions below, which set the default material, and change what you like. */
typedef struct impulse_shape {
  impulse_shape_type type;
  size_t point_count;
  impulse_vec2 points[8]; /* centre, ends, corners, or the normal of a half-space */
  impulse_vec2 half_extents;
  float angle;
  float radius;
  float offset;
  impulse_material material;
  bool has_layers; /* whether `layers` replace those of the body */
  impulse_layers layers;
  bool sensor; /* reports what overlaps it, collides with nothing, has no mass */
} impulse_shape;

impulse_material impulse_default_material(void);
impulse_shape impulse_circle(float radius, impulse_vec2 center);
impulse_shape impulse_box(impulse_vec2 half_extents, impulse_vec2 center, float angle);
/* The convex hull of at most eight points, in any order. */
impulse_shape impulse_polygon(const impulse_vec2* points, size_t count);
impulse_shape impulse_capsule(impulse_vec2 from, impulse_vec2 to, float radius);
impulse_shape impulse_segment(impulse_vec2 from, impulse_vec2 to);
/* Solid where dot(normal, p) <= offset. */
impulse_shape impulse_half_space(impulse_vec2 normal, float offset);

/* ---- Bodies ---- */

typedef struct impulse_body_id {
  uint32_t index, generation;
} impulse_body_id;

typedef enum impulse_body_type IMPULSE_AN_INT { IMPULSE_FIXED, IMPULSE_KINEMATIC, IMPULSE_DYNAMIC } impulse_body_type;

typedef struct impulse_body_def {
  impulse_body_type type;
  impulse_vec2 position;
  float angle;
  impulse_vec2 velocity; /* of the centre of mass */
  float angular_velocity;
  float gravity_scale;
  float linear_damping, angular_damping; /* 1/s */
  bool fixed_rotation;
  bool bullet;           /* continuous collision against dynamic bodies too */
  impulse_layers layers; /* of the shapes that have none of their own */
  void* user_data;
} impulse_body_def;

typedef struct impulse_body {
  impulse_body_type type;
  impulse_vec2 position; /* of the body's frame */
  float angle;
  impulse_vec2 center;   /* of mass */
  impulse_vec2 velocity; /* of the centre of mass */
  float angular_velocity;
  float mass, inertia; /* 0 unless dynamic */
  bool awake;
  void* user_data;
} impulse_body;

impulse_body_def impulse_default_body(void);
impulse_status impulse_create_body(impulse_world* world, const impulse_body_def* def, const impulse_shape* shapes,
                                   size_t shape_count, impulse_body_id* id);
/* One-sided segments that nothing catches on, solid to the left of the direction of travel; `loop` joins the ends. */
impulse_status impulse_create_chain(impulse_world* world, const impulse_body_def* def, const impulse_vec2* points,
                                    size_t point_count, bool loop, const impulse_material* material,
                                    impulse_body_id* id);
impulse_status impulse_destroy_body(impulse_world* world, impulse_body_id id);
bool impulse_has_body(const impulse_world* world, impulse_body_id id);
/* Copies at most `capacity` handles; `count` is how many there are. So do all lists below. */
impulse_status impulse_bodies(const impulse_world* world, impulse_body_id* into, size_t capacity, size_t* count);
impulse_status impulse_get_body(impulse_world* world, impulse_body_id id, impulse_body* body);
impulse_status impulse_set_pose(impulse_world* world, impulse_body_id id, impulse_vec2 position, float angle);
impulse_status impulse_set_velocity(impulse_world* world, impulse_body_id id, impulse_vec2 velocity,
                                    float angular_velocity);
impulse_status impulse_set_layers(impulse_world* world, impulse_body_id id, impulse_layers layers);
/* Forces and torques act in the next step, impulses at once. */
impulse_status impulse_apply_force(impulse_world* world, impulse_body_id id, impulse_vec2 force, impulse_vec2 point);
impulse_status impulse_apply_torque(impulse_world* world, impulse_body_id id, float torque);
impulse_status impulse_apply_impulse(impulse_world* world, impulse_body_id id, impulse_vec2 impulse,
                                     impulse_vec2 point);
impulse_status impulse_wake(impulse_world* world, impulse_body_id id);

/* ---- Joints ---- */

typedef struct impulse_joint_id {
  uint32_t index, generation;
} impulse_joint_id;

typedef enum impulse_joint_type IMPULSE_AN_INT {
  IMPULSE_REVOLUTE,
  IMPULSE_DISTANCE,
  IMPULSE_PRISMATIC,
  IMPULSE_WELD
} impulse_joint_type;

typedef struct impulse_limits {
  float low, high; /* of b relative to a, 0 at the poses where the joint was created */
} impulse_limits;

typedef struct impulse_motor {
  float speed;    /* rad/s or m/s, of b relative to a */
  float strength; /* N m or N, maximum */
} impulse_motor;

typedef struct impulse_joint {
  impulse_joint_type type;
  impulse_body_id a, b;
  impulse_vec2 anchor;              /* of a, and of b too but for a distance joint */
  impulse_vec2 anchor_b;            /* distance joints only, as is the next line */
  float length, stiffness, damping; /* stiffness 0 is rigid */
  impulse_vec2 axis;                /* prismatic joints only */
  bool has_limits, has_motor;       /* revolute and prismatic joints only */
  impulse_limits limits;
  impulse_motor motor;
} impulse_joint;

impulse_status impulse_create_joint(impulse_world* world, const impulse_joint* joint, impulse_joint_id* id);
impulse_status impulse_destroy_joint(impulse_world* world, impulse_joint_id id);
/* NULL removes the motor or the limits. */
impulse_status impulse_set_motor(impulse_world* world, impulse_joint_id id, const impulse_motor* motor);
impulse_status impulse_set_limits(impulse_world* world, impulse_joint_id id, const impulse_limits* limits);
/* On body b in the last sub-step. */
impulse_status impulse_joint_impulse(const impulse_world* world, impulse_joint_id id, impulse_vec2* impulse);

/* ---- Contacts and sensors of the last step ---- */

typedef struct impulse_part_id {
  impulse_body_id body;
  size_t part; /* index of the shape in its body */
} impulse_part_id;

typedef struct impulse_contact {
  impulse_body_id a, b;
  impulse_vec2 point;
  impulse_vec2 normal; /* unit, from a to b */
  float separation;    /* negative when they overlap */
  float normal_impulse, tangent_impulse;
} impulse_contact;

typedef struct impulse_touch {
  impulse_part_id a, b;
  impulse_vec2 point;
  impulse_vec2 normal;
  float normal_impulse, tangent_impulse;
} impulse_touch;

typedef struct impulse_overlap {
  impulse_part_id sensor, visitor;
} impulse_overlap;

typedef enum impulse_events IMPULSE_AN_INT {
  IMPULSE_BEGUN,
  IMPULSE_LASTING, /* all now */
  IMPULSE_ENDED
} impulse_events;

impulse_status impulse_contacts(const impulse_world* world, impulse_contact* into, size_t capacity, size_t* count);
/* Needs contact_events in the settings. */
impulse_status impulse_contact_events(const impulse_world* world, impulse_events which, impulse_touch* into,
                                      size_t capacity, size_t* count);
impulse_status impulse_sensor_events(const impulse_world* world, impulse_events which, impulse_overlap* into,
                                     size_t capacity, size_t* count);

/* ---- Callbacks of a step: they may read the world, not change it. NULL ends them. ---- */

/* Whether two shapes may collide; the same answer for the same two. */
typedef bool (*impulse_filter)(void* context, impulse_part_id a, impulse_part_id b);
impulse_status impulse_set_filter(impulse_world* world, impulse_filter filter, void* context);

typedef struct impulse_pre_solve_contact {
  impulse_part_id a, b;
  impulse_vec2 point;
  impulse_vec2 normal; /* unit, from a to b */
  float separation;    /* of the nearest point */
  /* May be changed, for this step: */
  bool enabled;
  float static_friction, dynamic_friction, restitution;
} impulse_pre_solve_contact;

typedef void (*impulse_pre_solve)(void* context, impulse_pre_solve_contact* contact);
impulse_status impulse_set_pre_solve(impulse_world* world, impulse_pre_solve pre_solve, void* context);

/* ---- Queries ---- */

typedef struct impulse_hit {
  bool found; /* if not, nothing else is set */
  impulse_part_id part;
  float fraction; /* of the way */
  impulse_vec2 point;
  impulse_vec2 normal; /* out of the part */
} impulse_hit;

/* The nearest hit on shapes whose category shares a bit with `layers`. */
impulse_status impulse_ray_cast(const impulse_world* world, impulse_vec2 from, impulse_vec2 to, uint32_t layers,
                                impulse_hit* hit);
/* The first shape that this one touches when it moves by `by` without rotating. */
impulse_status impulse_shape_cast(const impulse_world* world, const impulse_shape* shape, impulse_vec2 position,
                                  float angle, impulse_vec2 by, uint32_t layers, impulse_hit* hit);

#ifdef __cplusplus
}
#endif

#endif
