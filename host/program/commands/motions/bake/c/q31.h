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

static inline toytop_sample_q31 toytop_sample_of_q31(const toytop_q31 *table, const toytop_cursor *at) {
    toytop_sample_q31 m;
    int32_t four[4];
    toytop_sums sums = toytop_sums_at(&table->clock, table->coefficients, at->phase[0].leading, 0);
    toytop_alpha_beta(&sums, at, toytop_sincos_q31, four);
    for (int i = 0; i < 2; i++) m.alpha[i] = four[i], m.beta[i] = four[i + 2];
    m.u = toytop_inner_q31(four[0] + four[2], four[1] + four[3], four[0] - four[2], four[1] - four[3]);
    m.c[0] = (toytop_high(four[0], four[2]) - toytop_high(four[1], four[3])) * 8;
    m.c[1] = 2 * toytop_inner_q31(four[0], four[1], four[3], four[2]);
    return m;
}

static inline int32_t toytop_rates_at_q31(const toytop_q31 *table, const toytop_cursor *at, int32_t four[4], int32_t omega[3]) {
    return toytop_rates_at(&table->clock, table->scales, table->coefficients, at, toytop_sincos_q31, four, omega);
}
