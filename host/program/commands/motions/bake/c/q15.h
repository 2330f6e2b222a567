
TOYTOP_TYPES(q15, int16_t, float, int16_t)

/* a b + c d, rounded down to 2^-14: needs a compiler that shifts signed numbers arithmetically, as all do. */
static inline int32_t toytop_plus_q15(int32_t a, int32_t b, int32_t c, int32_t d) { return (a * b + c * d) >> 14; }

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

/* Rotated number as float, from all of its bits. */
static inline void toytop_turn_float_q15(int32_t re, int32_t im, const int32_t by[2], float turned[2]) {
    float x = (float)(re >> 1) * TOYTOP_UNIT, y = (float)(im >> 1) * TOYTOP_UNIT;
    float sine = (float)by[0] * (1.0f / 32768.0f), cosine = (float)by[1] * (1.0f / 32768.0f);
    turned[0] = toytop_inner_float(x, cosine, -y, sine);
    turned[1] = toytop_inner_float(x, sine, y, cosine);
}

static inline toytop_sums toytop_sums_at_q15(const toytop_clock *clock, const int16_t (*c)[4], uint64_t nutation, int slopes) {
    toytop_sums sums;
    uint32_t segment, terms = clock->terms;
    int32_t x = (int32_t)(((toytop_find(clock, nutation, 32, &segment, &sums.depth) >> 47) + 1) >> 1);
    c += segment * terms;
    for (int i = 0; i < 4; i++) {
        int32_t sum = c[terms - 1][i] * 65536, slope = 0;
        for (uint32_t k = terms - 1; k-- > 1;) {
            if (slopes) slope = (sum >> 1) + (slope >> 16) * x;
            sum = c[k][i] * 65536 + (sum >> 16) * x;
        }
        if (slopes) slope = (sum >> 1) + (slope >> 16) * x;
        /* half a unit: what follows rounds down */
        sums.value[i] = toytop_saturated((int64_t)c[0][i] * 65536 + 32768 + (sum >> 16) * x);
        sums.slope[i] = slope;
    }
    return sums;
}

TOYTOP_INTEGER_FUNCTIONS(q15, toytop_sums_at_q15, toytop_turn_q15, toytop_turn_float_q15, 1.0f / 16384.0f)

static inline toytop_sample_q15 toytop_sample_of_q15(const toytop_q15 *table, const toytop_cursor *at) {
    toytop_sample_q15 m;
    int32_t four[4], of[2][2];
    toytop_parameters_q15(table, at, 0, four, of);
    for (int i = 0; i < 2; i++) m.alpha[i] = (int16_t)four[i], m.beta[i] = (int16_t)four[i + 2];
    m.u = (int16_t)toytop_plus_q15(four[0] + four[2], four[0] - four[2], four[1] + four[3], four[1] - four[3]);
    m.c[0] = (int16_t)(2 * toytop_plus_q15(four[0], four[2], -four[1], four[3]));
    m.c[1] = (int16_t)(2 * toytop_plus_q15(four[0], four[3], four[1], four[2]));
    return m;
}

TOYTOP_FUNCTIONS(q15, 15, int16_t)
