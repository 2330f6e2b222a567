TOYTOP_TYPES(f32, int32_t, float, float)
TOYTOP_TYPES(q31, int32_t, float, int32_t)

/* Product a b 2^-32, rounded down. The compiler must shift signed numbers arithmetically. */
static inline int32_t toytop_high(int32_t a, int32_t b) { return (int32_t)(((int64_t)a * b) >> 32); }

/* Product with the 16 upper bits of b. */
static inline int32_t toytop_short(int32_t a, int32_t b) { return (int32_t)(((int64_t)a * (b >> 16)) >> 16); }

/* Entry for the nearest of 512 points of the circle: 2^31 times its sine and, 128 entries later, its cosine. */
static inline const int32_t *toytop_point(uint32_t phase) { return toytop_sines + ((uint32_t)(phase + 0x400000) >> 23); }

/* 2^31 times sine and cosine of a phase, to 26 bits: those of the nearest point, corrected by a series. */
static inline void toytop_sincos_f32(uint64_t leading, int32_t of[2]) {
    uint32_t phase = (uint32_t)(leading >> 32);
    const int32_t *point = toytop_point(phase);
    int32_t small = toytop_high((int32_t)(phase << 9), TOYTOP_SECANT), versine = toytop_high(small, small >> 1);
    of[0] = point[0] - toytop_high(point[0], versine) + toytop_high(point[128], small);
    of[1] = point[128] - toytop_high(point[128], versine) - toytop_high(point[0], small);
}

/* 2^31 times sine and cosine of a phase, to 29 bits: those of the nearest point, and the rest by a series. */
static inline void toytop_sincos_q31(uint64_t leading, int32_t of[2]) {
    uint32_t phase = (uint32_t)(leading >> 32);
    int32_t x = (int32_t)(phase << 9);
    const int32_t *point = toytop_point(phase);
    int32_t square = toytop_high(x, x), versine = toytop_high(square, TOYTOP_VERSINE * 65536);
    int32_t small = toytop_high(x, TOYTOP_LINEAR - (((square >> 16) * TOYTOP_CUBIC) >> 8));
    int32_t change = toytop_high(point[128], small) - (toytop_short(versine, point[0]) >> 7);
    of[0] = point[0] + ((change + 16) >> 5);
    change = toytop_high(point[0], small) + (toytop_short(versine, point[128]) >> 7);
    of[1] = point[128] - ((change + 16) >> 5);
}

/* Rotation of a number in units of 2^-31; the result is in units of 2^-30. */
static inline void toytop_turn(int32_t re, int32_t im, const int32_t by[2], int32_t turned[2]) {
    turned[0] = toytop_high(re, by[1]) + toytop_high(~im, by[0]);
    turned[1] = toytop_high(re, by[0]) + toytop_high(im, by[1]);
}

/* Values and, in half their scale, derivatives of the four polynomials of a table in integers, and the depth of the segment. */
typedef struct { int32_t value[4], slope[4]; uint32_t depth; } toytop_sums;

static inline int32_t toytop_saturated(int64_t sum) {
    return sum > INT32_MAX ? INT32_MAX : sum < INT32_MIN ? INT32_MIN : (int32_t)sum;
}

static inline toytop_sums toytop_sums_at(const toytop_clock *clock, const int32_t (*c)[4], uint64_t nutation, int slopes) {
    toytop_sums sums;
    uint32_t segment, terms = clock->terms;
    int32_t x = (int32_t)(toytop_find(clock, nutation, 32, &segment, &sums.depth) >> 32);
    c += segment * terms;
    for (int i = 0; i < 4; i++) {
        int32_t sum = c[terms - 1][i], slope = 0;
        for (uint32_t k = terms - 1; k-- > 1;) {
            if (slopes) slope = (sum >> 1) + toytop_high(slope, x);
            sum = c[k][i] + toytop_high(sum, x);
        }
        if (slopes) slope = (sum >> 1) + toytop_high(slope, x);
        sums.value[i] = toytop_saturated((int64_t)c[0][i] + toytop_high(sum, x));
        sums.slope[i] = slope;
    }
    return sums;
}

/* Sums and shifts modulo 2^32. */
static inline int32_t toytop_plus(int32_t a, int32_t b) { return (int32_t)((uint32_t)a + (uint32_t)b); }
static inline int32_t toytop_minus(int32_t a, int32_t b) { return (int32_t)((uint32_t)a - (uint32_t)b); }
static inline int32_t toytop_shifted(int32_t a, uint32_t by) { return (int32_t)((uint32_t)a << by); }

/* a b + c d and a b - c d as whole numbers of 2^-28, wrapping. */
static inline int32_t toytop_plus_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return toytop_shifted(toytop_plus(toytop_high(a, b), toytop_high(c, d)), 2);
}
static inline int32_t toytop_minus_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return toytop_shifted(toytop_minus(toytop_high(a, b), toytop_high(c, d)), 2);
}

TOYTOP_RATES(float)

/* Unit of the parameters in 32 bits, 2^-30. */
#define TOYTOP_UNIT (1.0f / 1073741824.0f)

/* Rotated number in units of 2^-31 as float. */
static inline void toytop_turn_float(int32_t re, int32_t im, const int32_t by[2], float turned[2]) {
    int32_t integers[2];
    toytop_turn(re, im, by, integers);
    for (int i = 0; i < 2; i++) turned[i] = (float)integers[i] * TOYTOP_UNIT;
}

/* Parameters and angular velocity of the scalar S. SUMS_AT: function of its sums; TURN and FLOAT_TURN: rotations, to integers in
 * units of UNIT and to float. */
#define TOYTOP_INTEGER_FUNCTIONS(S, SUMS_AT, TURN, FLOAT_TURN, UNIT) \
    /* Sums of the table, and Re alpha, Im alpha, Re beta and Im beta, and sine and cosine of the mean phases. */ \
    static inline toytop_sums toytop_parameters_##S(const toytop_##S *table, const toytop_cursor *at, int slopes, int32_t four[4], \
                                                    int32_t of[2][2]) { \
        toytop_sums sums = SUMS_AT(&table->clock, table->coefficients, at->phase[0].leading, slopes); \
        int falling = (int)(at->phase[0].leading >> 63); \
        for (int i = 0; i < 2; i++) { \
            int32_t re = sums.value[2 * i], im = sums.value[2 * i + 1]; \
            toytop_sincos_##S(at->phase[i + 1].leading, of[i]); \
            TURN(re, falling ? ~im : im, of[i], four + 2 * i); \
        } \
        return sums; \
    } \
    /* Parameters, and the angular velocity in the body frame. */ \
    static inline void toytop_rates_at_##S(const toytop_##S *table, const toytop_cursor *at, float four[4], float omega[3]) { \
        int32_t parameters[4], of[2][2], falling = (int32_t)(at->phase[0].leading >> 63); \
        float value[4], slope[4]; \
        toytop_sums sums = toytop_parameters_##S(table, at, 1, parameters, of); \
        for (int i = 0; i < 2; i++) { \
            int32_t im = sums.value[2 * i + 1], im_slope = sums.slope[2 * i + 1]; \
            FLOAT_TURN(sums.value[2 * i], falling ? ~im : im, of[i], value + 2 * i); \
            FLOAT_TURN(sums.slope[2 * i], falling ? ~im_slope : im_slope, of[i], slope + 2 * i); \
        } \
        for (int i = 0; i < 4; i++) four[i] = (float)parameters[i] * UNIT; \
        toytop_body_rates_float(value, slope, sums.depth, falling, table->scales, omega); \
    } \
    TOYTOP_OMEGA(S, float)

TOYTOP_INTEGER_FUNCTIONS(f32, toytop_sums_at, toytop_turn, toytop_turn_float, TOYTOP_UNIT)
TOYTOP_INTEGER_FUNCTIONS(q31, toytop_sums_at, toytop_turn, toytop_turn_float, TOYTOP_UNIT)

static inline toytop_sample_f32 toytop_sample_of_f32(const toytop_f32 *table, const toytop_cursor *at) {
    toytop_sample_f32 m;
    int32_t four[4], of[2][2], u;
    toytop_parameters_f32(table, at, 0, four, of);
    for (int i = 0; i < 2; i++) m.alpha[i] = (float)four[i] * TOYTOP_UNIT, m.beta[i] = (float)four[i + 2] * TOYTOP_UNIT;
    u = toytop_plus_q31(four[0] + four[2], four[0] - four[2], four[1] + four[3], four[1] - four[3]);
    m.u = (float)u * TOYTOP_UNIT;
    m.c[0] = (float)toytop_minus_q31(four[0], four[2], four[1], four[3]) * TOYTOP_UNIT * table->scales[0];
    m.c[1] = (float)toytop_plus_q31(four[0], four[3], four[1], four[2]) * TOYTOP_UNIT * table->scales[0];
    return m;
}

static inline toytop_sample_q31 toytop_sample_of_q31(const toytop_q31 *table, const toytop_cursor *at) {
    toytop_sample_q31 m;
    int32_t four[4], of[2][2];
    toytop_parameters_q31(table, at, 0, four, of);
    for (int i = 0; i < 2; i++) m.alpha[i] = four[i], m.beta[i] = four[i + 2];
    m.u = toytop_plus_q31(four[0] + four[2], four[0] - four[2], four[1] + four[3], four[1] - four[3]);
    m.c[0] = 2 * toytop_minus_q31(four[0], four[2], four[1], four[3]);
    m.c[1] = 2 * toytop_plus_q31(four[0], four[3], four[1], four[2]);
    return m;
}

TOYTOP_FUNCTIONS(f32, 32, float)
TOYTOP_FUNCTIONS(q31, 31, int32_t)
