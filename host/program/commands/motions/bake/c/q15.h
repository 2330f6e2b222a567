
TOYTOP_TYPES(q15, int16_t, float, int16_t)

/* a c + b d, rounded down to 2^-14: needs a compiler that shifts signed numbers arithmetically, as all do. */
static inline int32_t toytop_inner_q15(int32_t a, int32_t b, int32_t c, int32_t d) { return (a * c + b * d) >> 14; }

/* Sine and cosine of a phase with 15 bits after the point: those of the nearest point of the circle, moved along its tangent. */
static inline void toytop_sincos_q15(uint64_t leading, int32_t of[2]) {
    uint32_t phase = (uint32_t)(leading >> 32);
    const int32_t *point = toytop_point(phase);
    int32_t small = ((int32_t)(phase << 9) >> 16) * (TOYTOP_LINEAR >> 16) >> 15;
    of[0] = ((point[0] >> 1) + ((point[128] >> 16) * small >> 7)) >> 15;
    of[1] = ((point[128] >> 1) - ((point[0] >> 16) * small >> 7)) >> 15;
}

/* Rotated number, converted from units of 2^-31 to units of 2^-14. */
static inline void toytop_turn_q15(int32_t re, int32_t im, const int32_t by[2], int32_t turned[2]) {
    turned[0] = ((re >> 16) * by[1] - (im >> 16) * by[0] + (1 << 15)) >> 16;
    turned[1] = ((re >> 16) * by[0] + (im >> 16) * by[1] + (1 << 15)) >> 16;
}

static inline toytop_sums toytop_sums_at_q15(const toytop_q15 *table, uint64_t nutation) {
    toytop_sums sums;
    uint32_t segment, terms = table->clock.terms;
    int32_t x = (int32_t)(((toytop_find(&table->clock, nutation, 32, &segment, &sums.depth) >> 47) + 1) >> 1);
    const int16_t (*c)[4] = table->coefficients + segment * terms;
    for (int i = 0; i < 4; i++) {
        int32_t sum = c[terms - 1][i] * 65536, slope = 0;
        for (uint32_t k = terms - 1; k-- > 1;) {
            slope = (sum >> 1) + (slope >> 16) * x;
            sum = c[k][i] * 65536 + (sum >> 16) * x;
        }
        sums.slope[i] = (sum >> 1) + (slope >> 16) * x;
        /* half a unit: what follows rounds down */
        sums.value[i] = toytop_saturated((int64_t)c[0][i] * 65536 + 32768 + (sum >> 16) * x);
    }
    return sums;
}

/* Re alpha, Im alpha, Re beta and Im beta in units of 2^-14. */
static inline void toytop_alpha_beta_q15(const toytop_sums *sums, const toytop_cursor *at, int32_t four[4]) {
    int falling = (int)(at->phase[0].leading >> 63);
    int32_t of[2];
    for (int i = 0; i < 2; i++) {
        int32_t re = sums->value[2 * i], im = sums->value[2 * i + 1];
        toytop_sincos_q15(at->phase[i + 1].leading, of);
        toytop_turn_q15(re, falling ? ~im : im, of, four + 2 * i);
    }
}

static inline toytop_sample_q15 toytop_sample_of_q15(const toytop_q15 *table, const toytop_cursor *at) {
    toytop_sample_q15 m;
    int32_t four[4];
    toytop_sums sums = toytop_sums_at_q15(table, at->phase[0].leading);
    toytop_alpha_beta_q15(&sums, at, four);
    for (int i = 0; i < 2; i++) m.alpha[i] = (int16_t)four[i], m.beta[i] = (int16_t)four[i + 2];
    m.u = (int16_t)toytop_inner_q15(four[0] + four[2], four[1] + four[3], four[0] - four[2], four[1] - four[3]);
    m.c[0] = (int16_t)(2 * ((four[0] * four[2] - four[1] * four[3]) >> 14));
    m.c[1] = (int16_t)(2 * toytop_inner_q15(four[0], four[1], four[3], four[2]));
    return m;
}

/* Parameters alpha and beta in units of 2^-30, and the angular velocity in the body frame as from toytop_integer_rates. */
static inline int32_t toytop_rates_at_q15(const toytop_q15 *table, const toytop_cursor *at, int32_t four[4], int32_t omega[3]) {
    toytop_sums sums = toytop_sums_at_q15(table, at->phase[0].leading);
    int32_t a[2], b[2], turn[2];
    toytop_sincos_q15(at->phase[1].leading, a);
    toytop_sincos_q15(at->phase[2].leading, b);
    turn[0] = a[1] * b[1] + a[0] * b[0];
    turn[1] = a[1] * b[0] - a[0] * b[1];
    toytop_alpha_beta_q15(&sums, at, four);
    for (int i = 0; i < 4; i++) four[i] *= 65536;
    return toytop_integer_rates(&sums, (int)(at->phase[0].leading >> 63), turn, table->scales, omega);
}

TOYTOP_FUNCTIONS(q15, 15, int16_t)
TOYTOP_OMEGA(q15)
