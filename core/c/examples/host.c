/* A launch, the orientation at some ticks, and a relaunch after a stroke: on a PC, in C99.
 *
 * Prints bits, which `toytop state` has too: a line for each tick with alpha, beta and tip, and the state after the stroke. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "release.h"

static toytop_table_f32 in_f32;
static toytop_table_f64 in_f64;
static toytop_table_q31 in_q31;

static int refused(const toytop_error *error) {
    fprintf(stderr, "%s\n", error->text);
    return 1;
}

static void print_f32(const char *label, int64_t tick, const float *numbers, int count) {
    printf("%s %" PRId64, label, tick);
    for (int i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf(" %08" PRIx32, bits);
    }
    printf("\n");
}

static void print_f64(const char *label, int64_t tick, const double *numbers, int count) {
    printf("%s %" PRId64, label, tick);
    for (int i = 0; i < count; i++) {
        uint64_t bits;
        memcpy(&bits, &numbers[i], sizeof bits);
        printf(" %016" PRIx64, bits);
    }
    printf("\n");
}

/* The motion from a state, in three scalars, at ticks of all sizes. */
static int follow(const toytop_state *state) {
    static const toytop_settings settings = {.tick = {1000, 1}};
    static const int64_t ticks[] = {0, 1, 2, 1000, -7, INT64_C(1) << 40};
    toytop_motion motion;
    toytop_error error;
    if (toytop_launch(&top, state, &motion, &error) != TOYTOP_OK) return refused(&error);
    if (toytop_f32_set_up(&in_f32, sizeof in_f32, &motion, &settings, &error) != TOYTOP_OK) return refused(&error);
    if (toytop_f64_set_up(&in_f64, sizeof in_f64, &motion, &settings, &error) != TOYTOP_OK) return refused(&error);
    if (toytop_q31_set_up(&in_q31, sizeof in_q31, &motion, &settings, &error) != TOYTOP_OK) return refused(&error);
    for (size_t i = 0; i < sizeof ticks / sizeof *ticks; i++) {
        toytop_sample now;
        float single[6];
        double twice[6];
        int32_t fixed[4];
        toytop_f32_at_tick(&in_f32, ticks[i], &now);
        toytop_f32_cayley_klein(&now, single);
        toytop_f32_tip(&now, single + 4);
        print_f32("f32", ticks[i], single, 6);
        toytop_f64_at_tick(&in_f64, ticks[i], &now);
        toytop_f64_cayley_klein(&now, twice);
        toytop_f64_tip(&now, twice + 4);
        print_f64("f64", ticks[i], twice, 6);
        toytop_q31_at_tick(&in_q31, ticks[i], &now);
        toytop_q31_cayley_klein(&now, fixed);
        toytop_q31_tip(&now, single);
        printf("q31 %" PRId64 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32 " %08" PRIx32, ticks[i], (uint32_t)fixed[0],
               (uint32_t)fixed[1], (uint32_t)fixed[2], (uint32_t)fixed[3]);
        for (int j = 0; j < 2; j++) {
            uint32_t bits;
            memcpy(&bits, &single[j], sizeof bits);
            printf(" %08" PRIx32, bits);
        }
        printf("\n");
    }
    return 0;
}

int main(void) {
    toytop_error error;
    toytop_state state;
    toytop_sample at_the_stroke;
    if (toytop_state_from_release(&release_at_20_degrees, &state, &error) != TOYTOP_OK) return refused(&error);
    if (follow(&state) != 0) return 1;

    /* struck at tick 100 */
    toytop_f64_at_tick(&in_f64, 100, &at_the_stroke);
    if (toytop_f64_state(&at_the_stroke, &state) != TOYTOP_OK) return 1;
    if (toytop_impulse(&top, &state, impulse, point, &state, &error) != TOYTOP_OK) return refused(&error);
    double numbers[7];
    memcpy(numbers, &state, sizeof numbers);
    print_f64("state", 100, numbers, 7);
    return follow(&state);
}
