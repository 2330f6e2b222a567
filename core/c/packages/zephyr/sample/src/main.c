/* Prints the orientation of a top ten times a second. */
#include <stdio.h>
#include <toytop.h>
#include <zephyr/kernel.h>

static const toytop_top top = {TOYTOP_SLIDING, 3.0e-5, 2.0e-5, 0.03, 0.05, 0.0, TOYTOP_STANDARD_GRAVITY, 0.0};
static const toytop_release release = {0.35, 0.0, 0.0, 150.0, 0.0, 0.0};
static const toytop_settings settings = {.tick = {10, 1}}; /* 10 ticks in 1 s */
static toytop_table_f32 table;
static toytop_cursor cursor;
static toytop_motion motion;

int main(void) {
    toytop_state state;
    toytop_error why;
    if (toytop_state_from_release(&release, &state, &why) || toytop_launch(&top, &state, &motion, &why)
        || toytop_f32_set_up(&table, sizeof table, &motion, &settings, &why) || toytop_f32_cursor(&table, 0, &cursor)) {
        printf("%s\n", why.text);
        return 0;
    }
    for (int tick = 0;; tick++) {
        float q[4];
        toytop_f32_next_quaternion(&table, &cursor, q);
        /* whole numbers, because printf has no floats by default */
        printf("tick %d: quaternion 0.%04d\n", tick, (int)(q[0] * 10000.0f));
        k_msleep(100);
    }
}
