TOYTOP_TYPES(f64, double, double, double)

TOYTOP_RATES(double)

static inline double toytop_series(const double *coefficients, int count, double y) {
    double sum = 0.0;
    while (count-- > 0) sum = toytop_rounded_double(sum * y) + coefficients[count];
    return sum;
}

/* Sine and cosine of a phase, from the nearest quarter turn by two series. */
static inline void toytop_sincos_f64(uint64_t phase, double of[2]) {
    uint64_t quadrant = (phase + ((uint64_t)1 << 61)) >> 62, rest = phase - (quadrant << 62);
    double low = toytop_rounded_double((double)(uint32_t)rest * (1.0 / 4294967296.0));
    double x = ((double)(int32_t)(rest >> 32) + low) * (1.0 / 4294967296.0), y = x * x;
    double s = x * toytop_series(toytop_sine, 8, y), c = toytop_series(toytop_cosine, 9, y);
    of[0] = quadrant & 1 ? c : s;
    of[1] = quadrant & 1 ? -s : c;
    if (quadrant & 2) of[0] = -of[0], of[1] = -of[1];
}

/* Values and derivatives of the four polynomials of a table; half a period would have 2^depth segments of this length. */
typedef struct { double value[4], slope[4]; uint32_t depth; } toytop_sums_f64;

static inline toytop_sums_f64 toytop_sums_at_f64(const toytop_f64 *table, uint64_t nutation, int slopes) {
    toytop_sums_f64 sums;
    uint32_t segment, terms = table->clock.terms;
    double x = (double)toytop_find(&table->clock, nutation, 64, &segment, &sums.depth) * (1.0 / 9223372036854775808.0);
    const double (*c)[4] = table->coefficients + segment * terms;
    for (int i = 0; i < 4; i++) {
        double sum = c[terms - 1][i], slope = 0.0;
        for (uint32_t k = terms - 1; k-- > 0;) {
            if (slopes) slope = toytop_rounded_double(slope * x) + sum;
            sum = toytop_rounded_double(sum * x) + c[k][i];
        }
        sums.value[i] = sum;
        sums.slope[i] = slope;
    }
    return sums;
}

/* Product (re + i im) e^{i phase}, with sine and cosine of the phase. */
static inline void toytop_turn_f64(double re, double im, const double by[2], double turned[2]) {
    turned[0] = toytop_inner_double(re, by[1], -im, by[0]);
    turned[1] = toytop_inner_double(re, by[0], im, by[1]);
}

/* Re a, Im a, Re b and Im b, or their derivatives, rotated by the mean phases: for values, alpha and beta. */
static inline void toytop_turned_f64(const double number[4], const toytop_cursor *at, double turned[4]) {
    for (int i = 0; i < 2; i++) {
        double im = number[2 * i + 1], of[2];
        toytop_sincos_f64(at->phase[i + 1].leading, of);
        toytop_turn_f64(number[2 * i], at->phase[0].leading >> 63 ? -im : im, of, turned + 2 * i);
    }
}

static inline toytop_sample_f64 toytop_sample_of_f64(const toytop_f64 *table, const toytop_cursor *at) {
    toytop_sample_f64 m;
    double four[4];
    toytop_sums_f64 sums = toytop_sums_at_f64(table, at->phase[0].leading, 0);
    toytop_turned_f64(sums.value, at, four);
    for (int i = 0; i < 2; i++) m.alpha[i] = four[i], m.beta[i] = four[i + 2];
    m.u = toytop_inner_double(m.alpha[0] + m.beta[0], m.alpha[0] - m.beta[0], m.alpha[1] + m.beta[1], m.alpha[1] - m.beta[1]);
    m.c[0] = toytop_inner_double(m.alpha[0], m.beta[0], -m.alpha[1], m.beta[1]) * table->scales[0];
    m.c[1] = toytop_inner_double(m.alpha[0], m.beta[1], m.alpha[1], m.beta[0]) * table->scales[0];
    return m;
}

/* Parameters alpha and beta, and the angular velocity in the body frame. */
static inline void toytop_rates_at_f64(const toytop_f64 *table, const toytop_cursor *at, double four[4], double omega[3]) {
    toytop_sums_f64 sums = toytop_sums_at_f64(table, at->phase[0].leading, 1);
    double slope[4];
    toytop_turned_f64(sums.value, at, four);
    toytop_turned_f64(sums.slope, at, slope);
    toytop_body_rates_double(four, slope, sums.depth, (int)(at->phase[0].leading >> 63), table->scales, omega);
}

TOYTOP_OMEGA(f64, double)
TOYTOP_FUNCTIONS(f64, 64, double)
