#include <float.h>
#include <stdint.h>
#include <string.h>
#if FLT_EVAL_METHOD == 1 || FLT_EVAL_METHOD == 2
#error "floating point must not be evaluated in a wider type (for x86: -msse2 -mfpmath=sse)"
#endif
#ifdef __FAST_MATH__
#error "-ffast-math may change every bit: compile without it"
#endif

/* Fraction of a turn in 96 bits, without whole turns. */
typedef struct { uint64_t leading; uint32_t low; } toytop_phase;

/* Clock of a table. The order of phases is nutation, mean phase of alpha, mean phase of beta. */
typedef struct {
    uint32_t format, crc32, segments, terms;
    uint32_t not_rows;          /* ~(segments * terms): a changed size must not lead the check beyond the table */
    uint64_t first_phases[3];   /* phases at tick INT64_MIN, from which ticks are unsigned numbers */
    uint64_t epoch;             /* tick of the launch, as an unsigned number modulo 2^64 */
    toytop_phase increments[3]; /* increments in a tick, without whole turns */
    uint32_t whole_turns[3];    /* whole turns of the increments, to which they are added, modulo 2^32 */
    uint64_t ticks_per_time[2]; /* bits of doubles */
    uint64_t error_bounds[4];   /* bits of doubles: of orientation and rates, each at tick 0 and its growth in a tick */
    uint32_t mean_tip_at_tick_0[4];      /* mean tip angle at tick 0, in units of 2^-96 turns, the least significant word first */
    uint8_t flags[3];           /* quarter turns of alpha beta at u = e1, parameters that pass 0, whether the tip angle exists */
    uint8_t has_turning_points;
    uint16_t cells[16];         /* for each cell of half a period: its segments */
} toytop_clock;

/* Phases of consecutive ticks, advanced by additions, which an interrupt keeps. */
typedef struct { toytop_phase phase[3]; int64_t tick; } toytop_cursor;

static inline toytop_phase toytop_sum(toytop_phase a, toytop_phase b) {
    toytop_phase sum = {a.leading + b.leading, a.low + b.low};
    sum.leading += sum.low < a.low;
    return sum;
}

/* Cursor at a tick. */
TOYTOP_API toytop_cursor toytop_at(const toytop_clock *clock, int64_t tick) {
    toytop_cursor at = {{{0, 0}, {0, 0}, {0, 0}}, tick};
    uint64_t n = (uint64_t)tick ^ (uint64_t)1 << 63; /* ticks since INT64_MIN */
    for (int i = 0; i < 3; i++) {
        toytop_phase step = clock->increments[i];
        uint64_t lowest = (uint64_t)step.low * (uint32_t)n;
        at.phase[i].low = (uint32_t)lowest;
        at.phase[i].leading = step.leading * n + (uint64_t)step.low * (n >> 32) + (lowest >> 32) + clock->first_phases[i];
    }
    return at;
}

/* Moves a cursor to the next tick. */
TOYTOP_API void toytop_move_on(const toytop_clock *clock, toytop_cursor *at) {
    for (int i = 0; i < 3; i++) at->phase[i] = toytop_sum(at->phase[i], clock->increments[i]);
    at->tick = (int64_t)((uint64_t)at->tick + 1);
}

/* Finds the segment of a phase. Returns its coordinate x in [-1, 1) times 2^63, from `kept` bits of the phase in an eighth of half a period. The falling
 * half of a period is the mirror image of the rising one. depth: half a period would have 2^depth such segments. */
static inline int64_t toytop_find(const toytop_clock *clock, uint64_t nutation, int kept, uint32_t *segment, uint32_t *depth_of) {
    uint64_t share = (nutation ^ (0 - (nutation >> 63))) << 1;
    uint32_t cell = clock->cells[share >> 60], depth = 3 + (cell & 15);
    *depth_of = depth;
    *segment = ((cell >> 4) + ((uint32_t)(share >> 32) >> (32 - depth))) & 4095;
    share <<= 3; /* place in an eighth of half a period */
    return (int64_t)(share >> (64 - kept) << (64 - kept) << (depth - 3) ^ (uint64_t)1 << 63);
}

/* CRC-32 (ISO-HDLC) after `count` numbers of `size` bytes, a power of two. The least significant byte of a number is the first. */
static inline uint32_t toytop_crc(uint32_t sum, const void *numbers, uint32_t count, uint32_t size) {
    const uint8_t *bytes = (const uint8_t *)numbers;
    const uint16_t one = 1;
    uint8_t low_first;
    memcpy(&low_first, &one, 1);
    for (uint32_t i = 0; i < count * size; i++) {
        sum ^= bytes[low_first ? i : i ^ (size - 1)];
        for (int bit = 0; bit < 8; bit++) sum = sum >> 1 ^ (UINT32_C(0xedb88320) & (0u - (sum & 1u)));
    }
    return sum;
}

/* Checksum of a clock, with which the checksum of a table begins. */
static inline uint32_t toytop_head(const toytop_clock *clock, uint32_t scalar) {
    uint32_t sum = toytop_crc(UINT32_MAX, &clock->format, 1, 4);
    sum = toytop_crc(sum, &scalar, 1, 4);
    sum = toytop_crc(sum, &clock->segments, 1, 4);
    sum = toytop_crc(sum, &clock->terms, 1, 4);
    for (int i = 0; i < 3; i++) {
        sum = toytop_crc(toytop_crc(sum, &clock->increments[i].low, 1, 4), &clock->increments[i].leading, 1, 8);
        sum = toytop_crc(sum, &clock->whole_turns[i], 1, 4);
    }
    sum = toytop_crc(sum, clock->first_phases, 3, 8);
    sum = toytop_crc(sum, &clock->epoch, 1, 8);
    sum = toytop_crc(sum, clock->ticks_per_time, 2, 8);
    sum = toytop_crc(sum, clock->mean_tip_at_tick_0, 4, 4);
    sum = toytop_crc(sum, clock->flags, 3, 1);
    sum = toytop_crc(sum, &clock->has_turning_points, 1, 1);
    sum = toytop_crc(sum, clock->error_bounds, 4, 8);
    return toytop_crc(sum, clock->cells, 16, 2);
}

/* Least number of steps by which a phase advances by `ahead`, at most INT64_MAX: a long division of 96 bits. */
static inline int64_t toytop_steps_to(toytop_phase ahead, toytop_phase step) {
    toytop_phase rest = {0, 0};
    uint64_t quotient = 0;
    int whole = 1;
    if (step.leading == 0 && step.low == 0) step.low = 1;
    for (int i = 95; i >= 0; i--) {
        uint32_t bit = i >= 32 ? (uint32_t)(ahead.leading >> (i - 32)) & 1u : ahead.low >> i & 1u;
        uint64_t over = rest.leading >> 63;
        rest.leading = rest.leading << 1 | rest.low >> 31;
        rest.low = rest.low << 1 | bit;
        if (quotient >> 62) return INT64_MAX;
        quotient <<= 1;
        if (over || rest.leading > step.leading || (rest.leading == step.leading && rest.low >= step.low)) {
            rest.leading -= step.leading + (rest.low < step.low);
            rest.low -= step.low;
            quotient |= 1;
        }
        whole = rest.leading == 0 && rest.low == 0;
    }
    if (!whole) quotient++;
    return quotient > (uint64_t)INT64_MAX ? INT64_MAX : (int64_t)quotient;
}

static inline int64_t toytop_later(int64_t tick, int64_t steps) {
    return tick > INT64_MAX - steps ? INT64_MAX : tick + steps;
}

/* Next turning point of u at tick n or later: 1 with its first tick, and whether u is greatest there; 0 if there is none, or
 * more than one in a tick. */
TOYTOP_API int toytop_next_turning_point(const toytop_clock *clock, int64_t n, int64_t *tick, int *upper) {
    const uint64_t close = (uint64_t)1 << 14; /* 2^-50 turns: a phase within this distance counts as the point */
    const uint64_t half = (uint64_t)1 << 63;
    toytop_phase step = clock->increments[0];
    int64_t from = n == INT64_MIN ? n : n - 1;
    toytop_phase ahead, now;
    if (!clock->has_turning_points || clock->whole_turns[0] != 0 || step.leading >= half) return 0;
    now = toytop_at(clock, from).phase[0];
    now.leading += close;
    *upper = now.leading < half;
    now.leading &= half - 1;
    ahead.low = 0u - now.low;
    ahead.leading = half - now.leading - (now.low != 0);
    *tick = toytop_later(from, toytop_steps_to(ahead, step));
    return 1;
}
