/* Types of the scalar S: coefficient, table, sample. In a sample alpha, beta: {re, im}. u: cosine of the tilt; rounding may exceed 1. c: tip,
 * 2 s alpha beta, or 2 alpha beta if it is held. In fixed point all are in units of 2^-30 (q31) or 2^-14 (q15), and c is 2 alpha beta. */
#define TOYTOP_TYPES(S, COEFFICIENT, REAL, NUMBER) \
    typedef COEFFICIENT toytop_coefficient_##S; \
    typedef struct { \
        toytop_clock clock; \
        REAL scales[4];                       /* 2s; rates of x and of the sum of the mean phases, and about the axis */ \
        const COEFFICIENT (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */ \
    } toytop_##S; \
    typedef struct { NUMBER alpha[2], beta[2], u, c[2]; } toytop_sample_##S;

/* Functions of the scalar S that use its toytop_sample_of. */
#define TOYTOP_FUNCTIONS(S, BITS, NUMBER) \
    /* Sample at any tick, at the same cost. */ \
    TOYTOP_API toytop_sample_##S toytop_at_tick_##S(const toytop_##S *table, int64_t tick) { \
        toytop_cursor at = toytop_at(&table->clock, tick); \
        return toytop_sample_of_##S(table, &at); \
    } \
    /* Sample at the tick of a cursor, which then moves to the next tick. toytop_at(&table->clock, first) is the cursor at tick first. */ \
    TOYTOP_API toytop_sample_##S toytop_next_##S(const toytop_##S *table, toytop_cursor *at) { \
        toytop_sample_##S now = toytop_sample_of_##S(table, at); \
        toytop_move_on(&table->clock, at); \
        return now; \
    } \
    /* Unit quaternion w, x, y, z of a sample, from body to fixed coordinates. */ \
    TOYTOP_API void toytop_quaternion_##S(const toytop_sample_##S *sample, NUMBER quaternion[4]) { \
        quaternion[0] = sample->alpha[0]; \
        quaternion[1] = sample->beta[1]; \
        quaternion[2] = (NUMBER)-sample->beta[0]; \
        quaternion[3] = sample->alpha[1]; \
    } \
    /* Whether no bit of a table has changed since it was written. */ \
    TOYTOP_API int toytop_intact_##S(const toytop_##S *table) { \
        uint32_t sum = toytop_head(&table->clock, BITS), rows = table->clock.segments * table->clock.terms; \
        if (table->clock.not_rows != ~rows) return 0; \
        sum = toytop_crc(sum, table->scales, 4, sizeof table->scales[0]); \
        sum = toytop_crc(sum, table->coefficients, 4 * rows, sizeof table->coefficients[0][0]); \
        return ~sum == table->clock.crc32; \
    }

/* Angular velocity in the scalar S, from its toytop_rates_at. */
#define TOYTOP_OMEGA(S, F) \
    /* Angular velocity at the tick of a cursor in the body frame, rad per unit of time. */ \
    TOYTOP_API void toytop_omega_body_##S(const toytop_##S *table, const toytop_cursor *at, F omega[3]) { \
        F four[4]; \
        toytop_rates_at_##S(table, at, four, omega); \
    } \
    /* Angular velocity at the tick of a cursor in the fixed frame, rad per unit of time. */ \
    TOYTOP_API void toytop_omega_##S(const toytop_##S *table, const toytop_cursor *at, F omega[3]) { \
        F four[4], body[3]; \
        toytop_rates_at_##S(table, at, four, body); \
        toytop_adjoint_##F(four, body, omega); \
    }
