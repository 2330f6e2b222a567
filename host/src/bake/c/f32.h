typedef struct {
    toytop_clock clock;
    float scales[4];                  /* 2s; rates for the derivatives, which this file does not compute */
    const int32_t (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_f32;

/* The orientation; u, the cosine of the tilt (a rounding can take it past 1: clamp before acosf); the tip c = 2 s alpha beta (without s where it is held). {re, im}. */
typedef struct { float alpha[2], beta[2], u, c[2]; } toytop_sample_f32;

/* a b 2^-32, rounded down: needs a compiler that shifts signed numbers arithmetically, as all do. */
static inline int32_t toytop_high(int32_t a, int32_t b) { return (int32_t)(((int64_t)a * b) >> 32); }

/* The same with the 16 upper bits of b alone. */
static inline int32_t toytop_short(int32_t a, int32_t b) { return (int32_t)(((int64_t)a * (b >> 16)) >> 16); }

/* The nearest of 512 points of the circle: 2^31 times its sine and, 128 numbers on, its cosine. */
static inline const int32_t *toytop_point(uint32_t phase) { return toytop_sines + ((uint32_t)(phase + 0x400000) >> 23); }

/* 2^31 times sine and cosine of a phase, to 26 bits: those of the nearest point, and the rest by a series. */
static inline void toytop_sincos_q26(uint32_t phase, int32_t of[2]) {
    const int32_t *point = toytop_point(phase);
    int32_t small = toytop_high((int32_t)(phase << 9), TOYTOP_SECANT), versine = toytop_high(small, small >> 1);
    of[0] = point[0] - toytop_high(point[0], versine) + toytop_high(point[128], small);
    of[1] = point[128] - toytop_high(point[128], versine) - toytop_high(point[0], small);
}

/* From units of 2^-31 to 2^-30, turned. */
static inline void toytop_turn(int32_t re, int32_t im, const int32_t by[2], int32_t turned[2]) {
    turned[0] = toytop_high(re, by[1]) + toytop_high(~im, by[0]);
    turned[1] = toytop_high(re, by[0]) + toytop_high(im, by[1]);
}

/* Re alpha, Im alpha, Re beta and Im beta in units of 2^-30. */
static inline void toytop_alpha_beta(const toytop_clock *clock, const int32_t (*c)[4], const toytop_cursor *at,
                                     void (*sincos)(uint32_t, int32_t[2]), int32_t four[4]) {
    uint64_t nutation = at->phase[0].leading;
    uint32_t segment, terms = clock->terms;
    int32_t x = (int32_t)(toytop_find(clock, nutation, 32, &segment) >> 32), sums[4], of[2];
    c += segment * terms;
    for (int i = 0; i < 4; i++) {
        int32_t sum = c[terms - 1][i];
        for (uint32_t k = terms - 1; k-- > 1;) /* for the upper half of the powers 16 bits of x will do */
            sum = c[k][i] + (2 * (k + 1) > terms ? toytop_short(sum, x) : toytop_high(sum, x));
        int64_t last = (int64_t)c[0][i] + toytop_high(sum, x);
        sums[i] = last > INT32_MAX ? INT32_MAX : last < INT32_MIN ? INT32_MIN : (int32_t)last;
        if (i & 1 && nutation >> 63) sums[i] = ~sums[i];
    }
    for (int i = 0; i < 2; i++) {
        sincos((uint32_t)(at->phase[i + 1].leading >> 32), of);
        toytop_turn(sums[2 * i], sums[2 * i + 1], of, four + 2 * i);
    }
}

static inline toytop_sample_f32 toytop_sample_of_f32(const toytop_f32 *table, const toytop_cursor *at) {
    toytop_sample_f32 m;
    int32_t four[4];
    toytop_alpha_beta(&table->clock, table->coefficients, at, toytop_sincos_q26, four);
    const float unit = 1.0f / 1073741824.0f; /* 2^-30 */
    for (int i = 0; i < 2; i++) m.alpha[i] = (float)four[i] * unit, m.beta[i] = (float)four[i + 2] * unit;
    m.u = (m.alpha[0] + m.beta[0]) * (m.alpha[0] - m.beta[0]) + (m.alpha[1] + m.beta[1]) * (m.alpha[1] - m.beta[1]);
    m.c[0] = (m.alpha[0] * m.beta[0] - m.alpha[1] * m.beta[1]) * table->scales[0];
    m.c[1] = (m.alpha[0] * m.beta[1] + m.alpha[1] * m.beta[0]) * table->scales[0];
    return m;
}
