/* A Cortex-M4F in C: an interrupt of 1 kHz follows a top, the main loop relaunches it after a stroke and hands a new table over.
 *
 * Two tables take turns. The interrupt reads the one that `current` points to; the main loop sets up the other one and then changes
 * `current`, which is one word. The interrupt makes its cursor again when it sees the change. Launch and set-up call
 * `count`, which could feed a watchdog. */
#include "../release.h"
#include "chip.h"

static toytop_table_f32 tables[2];
static const toytop_table_f32 *volatile current;
static volatile int64_t ticks; /* of the interrupt, written by it alone */
static volatile uint32_t changes, failures;
static uint32_t calls;
static volatile float largest_jump;

/* Called by the interrupt a thousand times a second. */
void SysTick_Handler(void) {
    static const toytop_table_f32 *table;
    static toytop_cursor cursor;
    static float before[4];
    const toytop_table_f32 *now = current;
    float quaternion[4];
    if (now == 0) return;
    if (now != table) {
        changes += table != 0;
        table = now;
        if (toytop_f32_cursor(table, ticks, &cursor) != TOYTOP_OK) failures++;
    }
    if (toytop_f32_next_quaternion(table, &cursor, quaternion) != TOYTOP_OK) failures++;
    for (int i = 0; i < 4; i++) {
        float jump = quaternion[i] - before[i];
        if (jump < 0) jump = -jump;
        if (ticks > 0 && jump > largest_jump) largest_jump = jump;
        before[i] = quaternion[i];
    }
    ticks++;
}

static void stop_if(toytop_status status, const toytop_error *error) {
    if (status == TOYTOP_OK) return;
    print(error->text);
    print("\n");
    leave(1);
}

static void count(void *context) { ++*(uint32_t *)context; }

/* Sets up a table of the motion from a state at a tick, and prints the bits of three of its ticks. */
static void set_up(toytop_table_f32 *table, const toytop_state *state, int64_t epoch) {
    static toytop_motion motion;
    static toytop_workspace workspace;
    static toytop_error error;
    const toytop_settings settings = {
        .tick = {1000, 1}, .epoch = epoch, .workspace = &workspace, .pause = count, .context = &calls
    };
    stop_if(toytop_launch_with_pauses(&top, state, count, &calls, &motion, &error), &error);
    stop_if(toytop_f32_set_up(table, sizeof *table, &motion, &settings, &error), &error);
    for (int64_t tick = 0; tick < 3; tick++) {
        toytop_sample now;
        float numbers[6];
        toytop_f32_at_tick(table, epoch + tick, &now);
        toytop_f32_cayley_klein(&now, numbers);
        toytop_f32_tip(&now, numbers + 4);
        print("f32 ");
        print_number((uint32_t)tick);
        for (int i = 0; i < 6; i++) print_bits_f32(numbers[i]);
        print("\n");
    }
}

int main(void) {
    static toytop_error error;
    static toytop_state state;
    toytop_sample at_the_stroke;
    stop_if(toytop_state_from_release(&release_at_20_degrees, &state, &error), &error);
    set_up(&tables[0], &state, 0);
    current = &tables[0];
    start_systick(25000000u / 1000u);

    while (ticks < 100) wait_for_interrupt();
    /* struck at tick 100 */
    toytop_f32_at_tick(&tables[0], 100, &at_the_stroke);
    if (toytop_f32_state(&at_the_stroke, &state) != TOYTOP_OK) leave(2);
    stop_if(toytop_impulse(&top, &state, impulse, point, &state, &error), &error);
    print("state 100");
    for (int i = 0; i < 7; i++) print_bits_f64(i < 2 ? state.alpha[i] : i < 4 ? state.beta[i - 2] : state.omega[i - 4]);
    print("\n");
    set_up(&tables[1], &state, 100); /* its tick 100 is that of the stroke: the interrupt's count goes on */
    current = &tables[1];

    while (ticks < 1000) wait_for_interrupt();
    print("calls ");
    print_number(calls);
    print("\n");
    print("interrupts ");
    print_number((uint32_t)ticks);
    print(", exchanges ");
    print_number(changes);
    print(", failures ");
    print_number(failures);
    print(largest_jump < 0.2f ? ", no jump\n" : ", a jump\n");
    return 0;
}
