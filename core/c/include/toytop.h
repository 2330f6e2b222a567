/* toytop: the exact motion of a spinning top, in C99 and C++11 or later. Written by cbindgen; do not edit.
 *
 * No function allocates memory: all memory belongs to the caller, except a count of set-ups. A function returns TOYTOP_OK, or the
 * reason of a refusal. Units are SI or any consistent ones. The third fixed axis points up, the third body axis from the tip to the
 * centre of mass. Results of type int32_t are in units of 2^-30.
 *
 * A pointer is null, or it points to an object of its type, or to as many objects as its description names. While a program uses a cursor
 * or a sample, it must not change or move the table. During a set-up nothing else may use the memory of the table. */

#ifndef TOYTOP_H
#define TOYTOP_H

#include <stddef.h>
#include <stdint.h>

/* Size in bytes of a table with the given number of segments, from 8 to 4096. */
#define TOYTOP_TABLE_F32_SIZE_OF(segments) (216 + 80 * sizeof(char) * (segments))
#define TOYTOP_TABLE_F64_SIZE_OF(segments) (232 + 352 * sizeof(char) * (segments))
#define TOYTOP_TABLE_Q31_SIZE_OF(segments) (216 + 64 * sizeof(char) * (segments))

// Bytes of the text of an error, the closing zero included.
#define TOYTOP_TEXT_SIZE 192

// Support of a tip that slides on a horizontal plane without friction: Springborn's toy top.
#define TOYTOP_SLIDING 0

// Support of a tip that is held at a point: the Lagrange top.
#define TOYTOP_FIXED 1

// No support: a body that is thrown, floats or is in orbit.
#define TOYTOP_FREE 2

// Standard gravity, m/s^2.
#define TOYTOP_STANDARD_GRAVITY 9.80665

// Bytes of a motion.
#define TOYTOP_MOTION_SIZE 1024

// Bytes of a table in `f32` of the standard size, 25 segments.
#define TOYTOP_TABLE_F32_SIZE 2216

// Bytes of a table in `f64` of the standard size, 48 segments.
#define TOYTOP_TABLE_F64_SIZE 17128

// Bytes of a table in fixed point of the standard size, 32 segments.
#define TOYTOP_TABLE_Q31_SIZE 2264

// Alignment of the memory of a table, bytes.
#define TOYTOP_TABLE_ALIGNMENT 8

// Bytes of the workspace of a set-up.
#define TOYTOP_WORKSPACE_SIZE 3432

// Bytes of a sample.
#define TOYTOP_SAMPLE_SIZE 144

// Bytes of a cursor.
#define TOYTOP_CURSOR_SIZE 64

// Bytes of the events of a table.
#define TOYTOP_EVENTS_SIZE 384

// Status of a call: `TOYTOP_OK`, or the reason of a refusal. A refused call changes nothing, except that a refused set-up leaves no table.
enum toytop_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The call was successful.
  TOYTOP_OK = 0,
  // A pointer is null that must not be null.
  TOYTOP_NULL_POINTER = 1,
  // A parameter is NaN or infinite; the text of the error names it.
  TOYTOP_NOT_FINITE = 2,
  // A parameter is finite but not allowed; the text of the error names it and the allowed range.
  TOYTOP_OUT_OF_RANGE = 3,
  // The memory of a table is too small for the motion; the error says how many segments are not enough.
  TOYTOP_TABLE_TOO_SMALL = 4,
  // The memory of a table or a workspace is not aligned, or the memory of a table has no room for 8 segments.
  TOYTOP_BAD_MEMORY = 5,
  // A table, motion, cursor, sample or search for events was not made by this library, its set-up failed, or it belongs to another or an earlier table.
  TOYTOP_NOT_SET_UP = 6,
  // The motion has no such event, angle or derivative.
  TOYTOP_NONE = 7,
  // The motion is aperiodic, and such a motion has no table.
  TOYTOP_NO_TABLE = 8,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum toytop_status toytop_status;
#else
typedef uint32_t toytop_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Regime of a motion.
enum toytop_regime
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : uint32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // The axis rises and falls between e1 and e2.
  TOYTOP_NUTATING = 0,
  // The tilt is constant and |l| < |n|: of a fast top, the slower of its two regular precessions.
  TOYTOP_SLOW_PRECESSION = 1,
  // The tilt is constant and |l| >= |n|: of a fast top, the faster of the two.
  TOYTOP_FAST_PRECESSION = 2,
  // The axis is upright, and a small push causes a small nutation.
  TOYTOP_SLEEPING_STABLE = 3,
  // The axis is upright, and any push makes the top fall.
  TOYTOP_SLEEPING_UNSTABLE = 4,
  // The centre of mass is straight below the tip.
  TOYTOP_HANGING = 5,
  // The axis leaves the vertical and returns to it, in infinite time.
  TOYTOP_APERIODIC = 6,
  // The regime has no name in this version.
  TOYTOP_OTHER_REGIME = 7,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum toytop_regime toytop_regime;
#else
typedef uint32_t toytop_regime;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Release of a top by angles and rates.
typedef struct toytop_release {
  // Tilt of the axis from the upward vertical, rad, between 0 and pi.
  double tilt;
  // Direction in which the axis leans, rad, from the first fixed axis.
  double azimuth;
  // Rotation of the body about its axis, rad.
  double roll;
  // Whole axial component of the angular velocity, rad/s, precession included.
  double spin;
  // Rate of the azimuth, rad/s.
  double precession;
  // Rate of the tilt, rad/s.
  double nutation;
} toytop_release;

// State: orientation and angular velocity at one instant.
typedef struct toytop_state {
  // Cayley-Klein parameter alpha, {re, im}.
  double alpha[2];
  // Cayley-Klein parameter beta, {re, im}; |alpha|^2 + |beta|^2 = 1 to within 1e-6.
  double beta[2];
  // Angular velocity in the fixed frame, rad/s.
  double omega[3];
} toytop_state;

// Reason why a call was refused.
typedef struct toytop_error {
  // Status that the call returned.
  toytop_status status;
  // With `TOYTOP_TABLE_TOO_SMALL`: number of segments of the table, which is not enough.
  uint32_t segments;
  // One line without its end, such as "tilt: must be between 0 and pi"; it closes with a zero.
  char text[TOYTOP_TEXT_SIZE];
} toytop_error;

// Top, in SI or any consistent units. Exactly one of `mass` and `mass_moment` is given; the other is 0. For a free body only the
// two moments of inertia and the rotor enter the motion; the other fields must be finite, and have no effect.
typedef struct toytop_top {
  // Support of the tip: `TOYTOP_SLIDING`, `TOYTOP_FIXED` or `TOYTOP_FREE`.
  uint32_t support;
  // Transverse moment of inertia A, kg m^2: about the tip for a fixed one, otherwise about the centre of mass.
  double transverse_inertia;
  // Axial moment of inertia C <= 2A, kg m^2; 0 is a thin rod.
  double axial_inertia;
  // Distance s of the centre of mass from the tip, m; for a fixed tip it is used only together with `mass`.
  double com_height;
  // Mass M, kg, or 0.
  double mass;
  // Mass moment p = M s, kg m, or 0.
  double mass_moment;
  // Gravity g, m/s^2: `TOYTOP_STANDARD_GRAVITY`, or 1 in the units of the paper; 0 only for a fixed tip or a free body.
  double gravity;
  // Angular momentum K of a rotor inside, relative to the body and along its axis, kg m^2/s, of either sign and constant; 0
  // without one. The body's mass and inertia include the rotor's.
  double rotor_momentum;
} toytop_top;

// Motion of one launch, from which a table is set up. It may be copied; a program must not use its words.
typedef struct toytop_motion {
  uint64_t opaque[128];
} toytop_motion;

// Function of the program that a launch or a set-up calls at least every 50 000 cycles of a Cortex-M4F (80 000 in `f64`, 200 000 of a
// Cortex-M0+): to feed a watchdog, or to read another table. Null for none.
typedef void (*toytop_pause)(void *context);

// Constants of a motion, by the paper's symbols.
typedef struct toytop_constants {
  // Regime.
  toytop_regime regime;
  // Vertical angular momentum l, kg m^2/s.
  double l;
  // Axial angular momentum n, kg m^2/s.
  double n;
  // Energy h, J.
  double h;
  // Least cosine of the tilt, e1.
  double e1;
  // Greatest cosine of the tilt, e2.
  double e2;
  // Third branch point e3 >= 1.
  double e3;
  // Nutation period, s; NaN where there is none.
  double period;
  // Least force of the plane over the weight; NaN for a fixed tip or a free body. Below 0 a real top would leave the plane.
  double min_normal_force;
  // Tilt at which the normal force changes its sign, rad; NaN where it never does. Crossings of it, in any scalar, are the lift-offs.
  double lift_off_tilt;
} toytop_constants;

// Partial derivatives of a motion at one time.
//
// In each array they are with respect to: the rotation vector in the fixed frame that turns orientation and omega of the launch, rad (0 to
// 2); omega of the launch in the fixed frame, rad/s (3 to 5); A/C (6); A/(p s), for a fixed tip A/p (7); the height s of the centre of
// mass (8); gravity (9). Relative to the largest derivative of a column the error is about 1e-10.
typedef struct toytop_partials {
  // Derivatives of the orientation: rotation vectors in the fixed frame, rad.
  double orientation[10][3];
  // Derivatives of the angular velocity in the fixed frame, rad/s.
  double omega[10][3];
  // Derivatives of the angular velocity in the body frame, rad/s.
  double omega_body[10][3];
  // Derivatives of the position of the tip, m; without unit for a fixed tip.
  double tip[10][2];
} toytop_partials;

// Table of a motion in `f32`. Memory of `TOYTOP_TABLE_F32_SIZE_OF(segments)` bytes with the same alignment may be used
// as a larger or smaller table.
typedef struct toytop_table_f32 {
  uint64_t opaque[277];
} toytop_table_f32;

// Length of a tick, as an exact fraction of a second: `ticks` ticks in `seconds` seconds.
typedef struct toytop_tick {
  // Number of ticks, at least 1.
  uint32_t ticks;
  // Number of seconds, at least 1.
  uint32_t seconds;
} toytop_tick;

// Workspace of a set-up, which need not be initialised, and which a program may use for something else afterwards.
typedef struct toytop_workspace {
  uint64_t opaque[429];
} toytop_workspace;

// Settings of a table. The default of each one but the tick is 0 or null.
typedef struct toytop_settings {
  // Length of a tick, such as {1000, 1} for 1 kHz.
  struct toytop_tick tick;
  // Tick of the launch on a running counter.
  int64_t epoch;
  // Allowed truncation error, rad: a smaller table for a larger error. 0 stands for the default of the scalar.
  double truncation;
  // Workspace of the set-up; null for one on the stack.
  struct toytop_workspace *workspace;
  // Function that the set-up calls; null for none.
  toytop_pause pause;
  // Argument of `pause`.
  void *context;
} toytop_settings;

// Table of a motion in `f64`; see `toytop_table_f32`.
typedef struct toytop_table_f64 {
  uint64_t opaque[2141];
} toytop_table_f64;

// Table of a motion in fixed point of 32 bits; see `toytop_table_f32`.
typedef struct toytop_table_q31 {
  uint64_t opaque[283];
} toytop_table_q31;

// Sample of a motion at one instant: its orientation, and phases from which each rate is computed on demand. It may be copied.
//
// A sample refers to its table, whose memory must still be there. After another set-up in this memory the sample is refused.
typedef struct toytop_sample {
  uint64_t opaque[18];
} toytop_sample;

// Upper bounds on the errors of a table at a tick.
typedef struct toytop_error_bounds {
  // Orientation error 2 sqrt(|d alpha|^2 + |d beta|^2), rad.
  double orientation;
  // Error of the angular velocity, in either frame, rad/s.
  double rate;
} toytop_error_bounds;

// Phases of consecutive ticks of one table, which an interrupt keeps. It may be copied.
//
// Make the cursor again after each set-up of its table: an older cursor, and one of another table, is refused. The count of set-ups repeats after
// 65 536.
typedef struct toytop_cursor {
  uint64_t opaque[8];
} toytop_cursor;

// Events of one kind of a table, in order. They may be copied.
//
// They refer to their table, whose memory must still be there. After another set-up in this memory they are refused.
typedef struct toytop_events {
  uint64_t opaque[48];
} toytop_events;

// Event of a motion: its instant in ticks, and the sense of the change.
typedef struct toytop_event {
  // Last tick at or before the event.
  int64_t tick;
  // Fraction of the following tick that passes before the event, in [0, 1).
  double fraction;
  // 1 or 0: see the function that found the events.
  uint32_t upward;
} toytop_event;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Text of a status code, in one line; never null.
const char *toytop_status_text(uint32_t status);

// State of a release.
//
// Refusals name `tilt`, `azimuth`, `roll`, `spin`, `precession` or `nutation`. `error` may be null.
toytop_status toytop_state_from_release(const struct toytop_release *release,
                                        struct toytop_state *state,
                                        struct toytop_error *error);

// State from sensors.
//
// Refusals name `quaternion` or `gyro`. `error` may be null.
//
// * `quaternion`: four numbers w, x, y, z of unit norm to within 1e-6, from body to fixed coordinates
// * `gyro`: three rates in the body frame, rad/s
toytop_status toytop_state_from_quaternion_and_gyro(const double *quaternion,
                                                    const double *gyro,
                                                    struct toytop_state *state,
                                                    struct toytop_error *error);

// State after an impulse and the reaction of the support. `before` and `after` may be the same object.
//
// Refusals name a parameter of the top or of the state, `impulse` or `point`. `error` may be null.
//
// * `impulse`: three components in the fixed frame, N s
// * `point`: three body coordinates of the point at which it acts, m from the tip, or from the centre of mass of a
//   free body
toytop_status toytop_impulse(const struct toytop_top *top,
                             const struct toytop_state *before,
                             const double *impulse,
                             const double *point,
                             struct toytop_state *after,
                             struct toytop_error *error);

// Reaction impulse of the support, N s in the fixed frame. If its vertical part is negative, a real top leaves
// the plane.
//
// It has the arguments and refusals of `toytop_impulse`.
//
// * `reaction`: memory for three numbers
toytop_status toytop_reaction_impulse(const struct toytop_top *top,
                                      const struct toytop_state *before,
                                      const double *impulse,
                                      const double *point,
                                      double *reaction,
                                      struct toytop_error *error);

// Motion of a top from a state at t = 0.
//
// Refusals name a parameter of the top or of the state. `error` may be null.
toytop_status toytop_launch(const struct toytop_top *top,
                            const struct toytop_state *state,
                            struct toytop_motion *motion,
                            struct toytop_error *error);

// Motion of a top from a state at t = 0, with pauses for other work.
//
// It has the refusals of `toytop_launch`.
//
// * `context`: argument of `pause`
toytop_status toytop_launch_with_pauses(const struct toytop_top *top,
                                        const struct toytop_state *state,
                                        toytop_pause pause,
                                        void *context,
                                        struct toytop_motion *motion,
                                        struct toytop_error *error);

// Constants of a motion. The call integrates the period, as a set-up does, so it takes too long for an interrupt.
toytop_status toytop_motion_constants(const struct toytop_motion *motion,
                                      struct toytop_constants *constants);

// Partial derivatives at a time, s from the launch. The call integrates over a nutation period, so it takes too long for an interrupt.
// `TOYTOP_NONE` where the time is not finite or too far to integrate to, or a derivative is beyond 1e150.
toytop_status toytop_motion_partials(const struct toytop_motion *motion,
                                     double time,
                                     struct toytop_partials *partials);

// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
//
// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion, or that it is aperiodic. After a refusal
// every function that reads the table returns `TOYTOP_NOT_SET_UP`. A refusal of `table` or `size` changes nothing. `error` may be null.
//
// * `size`: bytes of the memory, `sizeof *table`, or the size for another number of segments (from 8 to 4096)
toytop_status toytop_f32_set_up(struct toytop_table_f32 *table,
                                uintptr_t size,
                                const struct toytop_motion *motion,
                                const struct toytop_settings *settings,
                                struct toytop_error *error);

// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if `set_up` would refuse. A
// table has at least 8. The call costs what a set-up costs, and has no pauses.
//
// * `truncation`: allowed truncation error, rad; 0 stands for the default of the scalar
uint32_t toytop_f32_segments_needed(const struct toytop_motion *motion,
                                    double truncation);

// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
//
// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion, or that it is aperiodic. After a refusal
// every function that reads the table returns `TOYTOP_NOT_SET_UP`. A refusal of `table` or `size` changes nothing. `error` may be null.
//
// * `size`: bytes of the memory, `sizeof *table`, or the size for another number of segments (from 8 to 4096)
toytop_status toytop_f64_set_up(struct toytop_table_f64 *table,
                                uintptr_t size,
                                const struct toytop_motion *motion,
                                const struct toytop_settings *settings,
                                struct toytop_error *error);

// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if `set_up` would refuse. A
// table has at least 8. The call costs what a set-up costs, and has no pauses.
//
// * `truncation`: allowed truncation error, rad; 0 stands for the default of the scalar
uint32_t toytop_f64_segments_needed(const struct toytop_motion *motion,
                                    double truncation);

// Sets up a table in memory of the caller, which need not be initialised. It takes too long for an interrupt.
//
// Refusals name `tick` or `truncation`, or say that the segments are not enough for this motion, or that it is aperiodic. After a refusal
// every function that reads the table returns `TOYTOP_NOT_SET_UP`. A refusal of `table` or `size` changes nothing. `error` may be null.
//
// * `size`: bytes of the memory, `sizeof *table`, or the size for another number of segments (from 8 to 4096)
toytop_status toytop_q31_set_up(struct toytop_table_q31 *table,
                                uintptr_t size,
                                const struct toytop_motion *motion,
                                const struct toytop_settings *settings,
                                struct toytop_error *error);

// Number of segments of a table that is enough for a motion; 0 if 4096, the largest number, are not, or if `set_up` would refuse. A
// table has at least 8. The call costs what a set-up costs, and has no pauses.
//
// * `truncation`: allowed truncation error, rad; 0 stands for the default of the scalar
uint32_t toytop_q31_segments_needed(const struct toytop_motion *motion,
                                    double truncation);

// Sample at any tick, of either sign, always at the same cost.
toytop_status toytop_f32_at_tick(const struct toytop_table_f32 *table,
                                 int64_t tick,
                                 struct toytop_sample *sample);

// Sample at any time, s from tick 0.
toytop_status toytop_f32_at(const struct toytop_table_f32 *table, double time, struct toytop_sample *sample);

// Error bounds of a table at a tick.
toytop_status toytop_f32_error_bounds(const struct toytop_table_f32 *table,
                                      int64_t tick,
                                      struct toytop_error_bounds *bounds);

// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
toytop_status toytop_f32_cayley_klein(const struct toytop_sample *sample, float *parameters);

// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
toytop_status toytop_f32_quaternion(const struct toytop_sample *sample, float *quaternion);

// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
// tilt, which a rounding can take past 1.
toytop_status toytop_f32_axis(const struct toytop_sample *sample,
                              float *axis);

// Angular velocity of three components in the fixed frame, rad/s.
toytop_status toytop_f32_omega(const struct toytop_sample *sample, float *omega);

// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
toytop_status toytop_f32_omega_body(const struct toytop_sample *sample, float *omega);

// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
// axis with the opposite sign.
toytop_status toytop_f32_tip(const struct toytop_sample *sample,
                             float *tip);

// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
toytop_status toytop_f32_tip_velocity(const struct toytop_sample *sample, float *velocity);

// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
toytop_status toytop_f32_tip_angle(const struct toytop_sample *sample,
                                   double *angle);

// State of a sample, from which another motion can be launched.
toytop_status toytop_f32_state(const struct toytop_sample *sample, struct toytop_state *state);

// Sample at any tick, of either sign, always at the same cost.
toytop_status toytop_f64_at_tick(const struct toytop_table_f64 *table,
                                 int64_t tick,
                                 struct toytop_sample *sample);

// Sample at any time, s from tick 0.
toytop_status toytop_f64_at(const struct toytop_table_f64 *table, double time, struct toytop_sample *sample);

// Error bounds of a table at a tick.
toytop_status toytop_f64_error_bounds(const struct toytop_table_f64 *table,
                                      int64_t tick,
                                      struct toytop_error_bounds *bounds);

// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
toytop_status toytop_f64_cayley_klein(const struct toytop_sample *sample, double *parameters);

// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
toytop_status toytop_f64_quaternion(const struct toytop_sample *sample, double *quaternion);

// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
// tilt, which a rounding can take past 1.
toytop_status toytop_f64_axis(const struct toytop_sample *sample,
                              double *axis);

// Angular velocity of three components in the fixed frame, rad/s.
toytop_status toytop_f64_omega(const struct toytop_sample *sample, double *omega);

// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
toytop_status toytop_f64_omega_body(const struct toytop_sample *sample, double *omega);

// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
// axis with the opposite sign.
toytop_status toytop_f64_tip(const struct toytop_sample *sample,
                             double *tip);

// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
toytop_status toytop_f64_tip_velocity(const struct toytop_sample *sample, double *velocity);

// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
toytop_status toytop_f64_tip_angle(const struct toytop_sample *sample,
                                   double *angle);

// State of a sample, from which another motion can be launched.
toytop_status toytop_f64_state(const struct toytop_sample *sample, struct toytop_state *state);

// Sample at any tick, of either sign, always at the same cost.
toytop_status toytop_q31_at_tick(const struct toytop_table_q31 *table,
                                 int64_t tick,
                                 struct toytop_sample *sample);

// Sample at any time, s from tick 0.
toytop_status toytop_q31_at(const struct toytop_table_q31 *table, double time, struct toytop_sample *sample);

// Error bounds of a table at a tick.
toytop_status toytop_q31_error_bounds(const struct toytop_table_q31 *table,
                                      int64_t tick,
                                      struct toytop_error_bounds *bounds);

// Cayley-Klein parameters: four numbers Re alpha, Im alpha, Re beta, Im beta.
toytop_status toytop_q31_cayley_klein(const struct toytop_sample *sample, int32_t *parameters);

// Unit quaternion, four numbers w, x, y, z, from body to fixed coordinates.
toytop_status toytop_q31_quaternion(const struct toytop_sample *sample, int32_t *quaternion);

// Unit vector of three components from the tip to the centre of mass, in the fixed frame. The third is u, the cosine of the
// tilt, which a rounding can take past 1.
toytop_status toytop_q31_axis(const struct toytop_sample *sample,
                              int32_t *axis);

// Angular velocity of three components in the fixed frame, rad/s.
toytop_status toytop_q31_omega(const struct toytop_sample *sample, float *omega);

// Angular velocity of three components in the body frame, rad/s, as a gyroscope measures it.
toytop_status toytop_q31_omega_body(const struct toytop_sample *sample, float *omega);

// Position x, y of the tip, m from the point of the plane below the centre of mass; for a fixed tip the horizontal part of the
// axis with the opposite sign.
toytop_status toytop_q31_tip(const struct toytop_sample *sample,
                             float *tip);

// Velocity x, y of the tip, m/s; 1/s for a fixed tip.
toytop_status toytop_q31_tip_velocity(const struct toytop_sample *sample, float *velocity);

// Angle of the tip, rad, continued in time from (-pi, pi] at the launch. `TOYTOP_NONE` if the axis is always vertical.
toytop_status toytop_q31_tip_angle(const struct toytop_sample *sample,
                                   double *angle);

// State of a sample, from which another motion can be launched.
toytop_status toytop_q31_state(const struct toytop_sample *sample, struct toytop_state *state);

// Tick of the last sample of a cursor; before the first sample, the tick before it.
toytop_status toytop_cursor_tick(const struct toytop_cursor *place, int64_t *tick);

// Cursor whose first sample is at tick `first`.
toytop_status toytop_f32_cursor(const struct toytop_table_f32 *table,
                                int64_t first,
                                struct toytop_cursor *cursor);

// Next sample of a cursor. The sequence has no end.
toytop_status toytop_f32_next(const struct toytop_table_f32 *table,
                              struct toytop_cursor *cursor,
                              struct toytop_sample *sample);

// Quaternion, four numbers w, x, y, z, at the next tick of a cursor, from body to fixed coordinates, without a sample.
toytop_status toytop_f32_next_quaternion(const struct toytop_table_f32 *table,
                                         struct toytop_cursor *cursor,
                                         float *quaternion);

// Cursor whose first sample is at tick `first`.
toytop_status toytop_f64_cursor(const struct toytop_table_f64 *table,
                                int64_t first,
                                struct toytop_cursor *cursor);

// Next sample of a cursor. The sequence has no end.
toytop_status toytop_f64_next(const struct toytop_table_f64 *table,
                              struct toytop_cursor *cursor,
                              struct toytop_sample *sample);

// Quaternion, four numbers w, x, y, z, at the next tick of a cursor, from body to fixed coordinates, without a sample.
toytop_status toytop_f64_next_quaternion(const struct toytop_table_f64 *table,
                                         struct toytop_cursor *cursor,
                                         double *quaternion);

// Cursor whose first sample is at tick `first`.
toytop_status toytop_q31_cursor(const struct toytop_table_q31 *table,
                                int64_t first,
                                struct toytop_cursor *cursor);

// Next sample of a cursor. The sequence has no end.
toytop_status toytop_q31_next(const struct toytop_table_q31 *table,
                              struct toytop_cursor *cursor,
                              struct toytop_sample *sample);

// Quaternion, four numbers w, x, y, z, at the next tick of a cursor, from body to fixed coordinates, without a sample.
toytop_status toytop_q31_next_quaternion(const struct toytop_table_q31 *table,
                                         struct toytop_cursor *cursor,
                                         int32_t *quaternion);

// Turning points of u at tick `from` or later; `upward` is 1 where u = e2. There are none where the tilt is constant to 2^-49 rad.
toytop_status toytop_f32_turning_points(const struct toytop_table_f32 *table,
                                        int64_t from,
                                        struct toytop_events *events);

// Crossings of a tilt, the angle of the axis to the upward vertical in rad, at tick `from` or later; `upward` is 1 where the axis
// rises. The tip is on the circle of a radius r about the origin where the sine of the tilt is r/s.
toytop_status toytop_f32_crossings(const struct toytop_table_f32 *table,
                                   double tilt,
                                   int64_t from,
                                   struct toytop_events *events);

// Instants at tick `from` or later at which the angle of the tip is `angle`, rad, up to whole turns; `upward` is 1 where it
// increases. There are none where the axis is always vertical.
toytop_status toytop_f32_tip_angles(const struct toytop_table_f32 *table,
                                    double angle,
                                    int64_t from,
                                    struct toytop_events *events);

// Next of the events. `TOYTOP_NONE` where there is none.
toytop_status toytop_f32_next_event(struct toytop_events *events, struct toytop_event *event);

// Turning points of u at tick `from` or later; `upward` is 1 where u = e2. There are none where the tilt is constant to 2^-49 rad.
toytop_status toytop_f64_turning_points(const struct toytop_table_f64 *table,
                                        int64_t from,
                                        struct toytop_events *events);

// Crossings of a tilt, the angle of the axis to the upward vertical in rad, at tick `from` or later; `upward` is 1 where the axis
// rises. The tip is on the circle of a radius r about the origin where the sine of the tilt is r/s.
toytop_status toytop_f64_crossings(const struct toytop_table_f64 *table,
                                   double tilt,
                                   int64_t from,
                                   struct toytop_events *events);

// Instants at tick `from` or later at which the angle of the tip is `angle`, rad, up to whole turns; `upward` is 1 where it
// increases. There are none where the axis is always vertical.
toytop_status toytop_f64_tip_angles(const struct toytop_table_f64 *table,
                                    double angle,
                                    int64_t from,
                                    struct toytop_events *events);

// Next of the events. `TOYTOP_NONE` where there is none.
toytop_status toytop_f64_next_event(struct toytop_events *events, struct toytop_event *event);

// Turning points of u at tick `from` or later; `upward` is 1 where u = e2. There are none where the tilt is constant to 2^-49 rad.
toytop_status toytop_q31_turning_points(const struct toytop_table_q31 *table,
                                        int64_t from,
                                        struct toytop_events *events);

// Crossings of a tilt, the angle of the axis to the upward vertical in rad, at tick `from` or later; `upward` is 1 where the axis
// rises. The tip is on the circle of a radius r about the origin where the sine of the tilt is r/s.
toytop_status toytop_q31_crossings(const struct toytop_table_q31 *table,
                                   double tilt,
                                   int64_t from,
                                   struct toytop_events *events);

// Instants at tick `from` or later at which the angle of the tip is `angle`, rad, up to whole turns; `upward` is 1 where it
// increases. There are none where the axis is always vertical.
toytop_status toytop_q31_tip_angles(const struct toytop_table_q31 *table,
                                    double angle,
                                    int64_t from,
                                    struct toytop_events *events);

// Next of the events. `TOYTOP_NONE` where there is none.
toytop_status toytop_q31_next_event(struct toytop_events *events, struct toytop_event *event);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* TOYTOP_H */

#ifndef TOYTOP_SIZES
#define TOYTOP_SIZES
/* The compiler stops here if a type has another size than in the archive. */
typedef char toytop_f32_has_its_size[sizeof(toytop_table_f32) == TOYTOP_TABLE_F32_SIZE_OF(25) ? 1 : -1];
typedef char toytop_f64_has_its_size[sizeof(toytop_table_f64) == TOYTOP_TABLE_F64_SIZE_OF(48) ? 1 : -1];
typedef char toytop_q31_has_its_size[sizeof(toytop_table_q31) == TOYTOP_TABLE_Q31_SIZE_OF(32) ? 1 : -1];
typedef char toytop_workspace_has_its_size[sizeof(toytop_workspace) == TOYTOP_WORKSPACE_SIZE ? 1 : -1];
typedef char toytop_top_has_its_size[sizeof(toytop_top) == 64 ? 1 : -1];
typedef char toytop_state_has_its_size[sizeof(toytop_state) == 56 && sizeof(double) == 8 ? 1 : -1];
#endif
