typedef struct {
    toytop_clock clock;
    float scales[4];                  /* 2s; rates for the derivatives, which this file does not compute */
    const int32_t (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_q31;

/* In units of 2^-30: the orientation; u, the cosine of the tilt (a rounding can take it past 2^30); the tip over s, 2 alpha beta. {re, im}. */
typedef struct { int32_t alpha[2], beta[2], u, c[2]; } toytop_sample_q31;

/* 2^31 times sine and cosine of a phase, to 29 bits: those of the nearest point, and the rest by a series. */
static inline void toytop_sincos_q31(uint32_t phase, int32_t of[2]) {
    int32_t x = (int32_t)(phase << 9);
    const int32_t *point = toytop_point(phase);
    int32_t square = toytop_high(x, x), versine = toytop_high(square, TOYTOP_VERSINE * 65536);
    int32_t small = toytop_high(x, TOYTOP_LINEAR - (((square >> 16) * TOYTOP_CUBIC) >> 8));
    int32_t change = toytop_high(point[128], small) - (toytop_short(versine, point[0]) >> 7);
    of[0] = point[0] + ((change + 16) >> 5);
    change = toytop_high(point[0], small) + (toytop_short(versine, point[128]) >> 7);
    of[1] = point[128] - ((change + 16) >> 5);
}

/* a c + b d to 2^-28. */
static inline int32_t toytop_inner_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return (toytop_high(a, c) + toytop_high(b, d)) * 4;
}

static inline toytop_sample_q31 toytop_sample_of_q31(const toytop_q31 *table, const toytop_cursor *at) {
    toytop_sample_q31 m;
    int32_t four[4];
    toytop_alpha_beta(&table->clock, table->coefficients, at, toytop_sincos_q31, four);
    for (int i = 0; i < 2; i++) m.alpha[i] = four[i], m.beta[i] = four[i + 2];
    m.u = toytop_inner_q31(four[0] + four[2], four[1] + four[3], four[0] - four[2], four[1] - four[3]);
    m.c[0] = (toytop_high(four[0], four[2]) - toytop_high(four[1], four[3])) * 8;
    m.c[1] = 2 * toytop_inner_q31(four[0], four[1], four[3], four[2]);
    return m;
}
