typedef struct {
    toytop_clock clock;
    double scales[4];                /* 2s; rates for the derivatives, which this file does not compute */
    const double (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_f64;

/* The orientation; u, the cosine of the tilt (a rounding can take it past 1: clamp before acos); the tip c = 2 s alpha beta (without s where it is held). {re, im}. */
typedef struct { double alpha[2], beta[2], u, c[2]; } toytop_sample_f64;

static inline double toytop_series(const double *coefficients, int count, double y) {
    double sum = 0.0;
    while (count-- > 0) sum = sum * y + coefficients[count];
    return sum;
}

/* Turned by the phase: the nearest quarter turn, and the rest by two series. */
static inline void toytop_turn_f64(double re, double im, uint64_t phase, double turned[2]) {
    uint64_t quadrant = (phase + ((uint64_t)1 << 61)) >> 62, rest = phase - (quadrant << 62);
    double x = ((double)(int32_t)(rest >> 32) + (double)(uint32_t)rest * (1.0 / 4294967296.0)) * (1.0 / 4294967296.0), y = x * x;
    double s = x * toytop_series(toytop_sine, 8, y), c = toytop_series(toytop_cosine, 9, y);
    double sine = quadrant & 1 ? c : s, cosine = quadrant & 1 ? -s : c;
    if (quadrant & 2) sine = -sine, cosine = -cosine;
    turned[0] = re * cosine - im * sine;
    turned[1] = re * sine + im * cosine;
}

static inline toytop_sample_f64 toytop_sample_of_f64(const toytop_f64 *table, const toytop_cursor *at) {
    toytop_sample_f64 m;
    uint64_t nutation = at->phase[0].leading;
    uint32_t segment, terms = table->clock.terms;
    double x = (double)toytop_find(&table->clock, nutation, 64, &segment) * (1.0 / 9223372036854775808.0), sums[4];
    const double (*c)[4] = table->coefficients + segment * terms;
    for (int i = 0; i < 4; i++) {
        double sum = c[terms - 1][i];
        for (uint32_t k = terms - 1; k-- > 0;) sum = sum * x + c[k][i];
        sums[i] = i & 1 && nutation >> 63 ? -sum : sum;
    }
    toytop_turn_f64(sums[0], sums[1], at->phase[1].leading, m.alpha);
    toytop_turn_f64(sums[2], sums[3], at->phase[2].leading, m.beta);
    m.u = (m.alpha[0] + m.beta[0]) * (m.alpha[0] - m.beta[0]) + (m.alpha[1] + m.beta[1]) * (m.alpha[1] - m.beta[1]);
    m.c[0] = (m.alpha[0] * m.beta[0] - m.alpha[1] * m.beta[1]) * table->scales[0];
    m.c[1] = (m.alpha[0] * m.beta[1] + m.alpha[1] * m.beta[0]) * table->scales[0];
    return m;
}
