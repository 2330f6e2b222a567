typedef struct {
    toytop_clock clock;
    float scales[4];                  /* 2s; rates for the derivatives, which this file does not compute */
    const int16_t (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_q15;

/* In units of 2^-14: the orientation; u, the cosine of the tilt (a rounding can take it past 2^14); the tip over s, 2 alpha beta. {re, im}. */
typedef struct { int16_t alpha[2], beta[2], u, c[2]; } toytop_sample_q15;

/* a c + b d, rounded down to 2^-14: needs a compiler that shifts signed numbers arithmetically, as all do. */
static inline int32_t toytop_inner_q15(int32_t a, int32_t b, int32_t c, int32_t d) { return (a * c + b * d) >> 14; }

/* From 31 bits after the point to 14, turned by the phase: the nearest point of the circle, moved along its tangent. */
static inline void toytop_turn_q15(int32_t re, int32_t im, uint64_t leading, int32_t turned[2]) {
    uint32_t phase = (uint32_t)(leading >> 32);
    const int32_t *point = toytop_point(phase);
    int32_t small = ((int32_t)(phase << 9) >> 16) * (TOYTOP_LINEAR >> 16) >> 15;
    int32_t sine = ((point[0] >> 1) + ((point[128] >> 16) * small >> 7)) >> 15;
    int32_t cosine = ((point[128] >> 1) - ((point[0] >> 16) * small >> 7)) >> 15;
    turned[0] = ((re >> 16) * cosine - (im >> 16) * sine + (1 << 15)) >> 16;
    turned[1] = ((re >> 16) * sine + (im >> 16) * cosine + (1 << 15)) >> 16;
}

static inline toytop_sample_q15 toytop_sample_of_q15(const toytop_q15 *table, const toytop_cursor *at) {
    toytop_sample_q15 m;
    uint64_t nutation = at->phase[0].leading;
    uint32_t segment, terms = table->clock.terms;
    int32_t x = (int32_t)(((toytop_find(&table->clock, nutation, 32, &segment) >> 47) + 1) >> 1), sums[4], four[4];
    const int16_t (*c)[4] = table->coefficients + segment * terms;
    for (int i = 0; i < 4; i++) {
        int32_t sum = c[terms - 1][i] * 65536;
        for (uint32_t k = terms - 1; k-- > 1;) sum = c[k][i] * 65536 + (sum >> 16) * x;
        int64_t last = (int64_t)c[0][i] * 65536 + 32768 + (sum >> 16) * x; /* half a unit: what follows rounds down */
        sums[i] = last > INT32_MAX ? INT32_MAX : last < INT32_MIN ? INT32_MIN : (int32_t)last;
        if (i & 1 && nutation >> 63) sums[i] = ~sums[i];
    }
    toytop_turn_q15(sums[0], sums[1], at->phase[1].leading, four);
    toytop_turn_q15(sums[2], sums[3], at->phase[2].leading, four + 2);
    for (int i = 0; i < 2; i++) m.alpha[i] = (int16_t)four[i], m.beta[i] = (int16_t)four[i + 2];
    m.u = (int16_t)toytop_inner_q15(four[0] + four[2], four[1] + four[3], four[0] - four[2], four[1] - four[3]);
    m.c[0] = (int16_t)(2 * ((four[0] * four[2] - four[1] * four[3]) >> 14));
    m.c[1] = (int16_t)(2 * toytop_inner_q15(four[0], four[1], four[3], four[2]));
    return m;
}
