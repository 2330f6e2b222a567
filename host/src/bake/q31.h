typedef struct {
    toytop_clock clock;
    float scales[4];                  /* 2s; rates for the derivatives, which this file does not compute */
    const int32_t (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_q31;

/* In units of 2^-30: the orientation; u, the cosine of the tilt; the tip over s, 2 alpha beta. {re, im}. */
typedef struct { int32_t alpha[2], beta[2], u, c[2]; } toytop_moment_q31;

/* a c + b d to 2^-28. */
static inline int32_t toytop_inner_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return (toytop_high(a, c) + toytop_high(b, d)) * 4;
}

static inline toytop_moment_q31 toytop_moment_of_q31(const toytop_q31 *table, const toytop_cursor *at) {
    toytop_moment_q31 m;
    int32_t four[4];
    toytop_alpha_beta(&table->clock, table->coefficients, at, four);
    for (int i = 0; i < 2; i++) m.alpha[i] = four[i], m.beta[i] = four[i + 2];
    m.u = toytop_inner_q31(four[0] + four[2], four[1] + four[3], four[0] - four[2], four[1] - four[3]);
    m.c[0] = (toytop_high(four[0], four[2]) - toytop_high(four[1], four[3])) * 8;
    m.c[1] = 2 * toytop_inner_q31(four[0], four[1], four[3], four[2]);
    return m;
}
