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

/* Number of type float as an integer times 2^(exponent - 157). */
typedef struct { int32_t digits, exponent; } toytop_significand;

static inline toytop_significand toytop_significand_of(float number) {
    toytop_significand s;
    uint32_t bits;
    memcpy(&bits, &number, sizeof bits);
    s.exponent = (int32_t)(bits >> 23 & 0xffu);
    s.digits = s.exponent == 0 ? 0 : (int32_t)((bits << 7 | UINT32_C(1) << 30) & UINT32_C(0x7fffffff));
    if (bits >> 31) s.digits = -s.digits;
    return s;
}

static inline int32_t toytop_least(int32_t a, int32_t b) { return a < b ? a : b; }
static inline int32_t toytop_greatest(int32_t a, int32_t b) { return a > b ? a : b; }

static inline int32_t toytop_scaled(toytop_significand s, int32_t integer, int32_t exponent) {
    return toytop_high(s.digits, integer) >> toytop_least(exponent - s.exponent, 31);
}

/* Number in units of 2^(exponent - 157) as a float. */
static inline float toytop_rate_in(int32_t number, int32_t exponent) {
    float rate = (float)number;
    uint32_t bits;
    if (number == 0 || exponent <= 31) return 0.0f;
    memcpy(&bits, &rate, sizeof bits);
    bits += (uint32_t)(exponent - 157) << 23;
    memcpy(&rate, &bits, sizeof rate);
    return rate;
}

/* Product x y* of complex numbers, in units of 2^-30. */
static inline void toytop_times_conj(const int32_t x[2], const int32_t y[2], int32_t product[2]) {
    product[0] = toytop_plus(toytop_high(x[0], y[0]), toytop_high(x[1], y[1]));
    product[1] = toytop_minus(toytop_high(x[1], y[0]), toytop_high(x[0], y[1]));
}

/* Angular velocity in the body frame, in units of 2^(exponent - 157) per unit of time, with the cosine and sine of the mean phase of
 * beta minus that of alpha, in units of 2^-30. The exponent is returned. */
static inline int32_t toytop_integer_rates(const toytop_sums *sums, int falling, const int32_t turn[2], const float scales[4],
                                           int32_t omega[3]) {
    toytop_significand x = toytop_significand_of(scales[1]), mean = toytop_significand_of(scales[2]);
    toytop_significand axial = toytop_significand_of(scales[3]);
    int32_t forth[2], back[2], product[2], n[2], transverse[2], exponent, own;
    uint32_t used, spare = 0;
    toytop_times_conj(sums->slope + 2, sums->value, forth);
    toytop_times_conj(sums->value + 2, sums->slope, back);
    toytop_times_conj(sums->value + 2, sums->value, product);
    x.exponent += (int32_t)sums->depth - 3;
    exponent = toytop_greatest(x.exponent, mean.exponent);
    n[0] = toytop_plus(toytop_scaled(x, toytop_minus(forth[0], back[0]), exponent),
                       toytop_scaled(mean, toytop_minus(0, product[1]), exponent));
    n[1] = toytop_plus(toytop_scaled(x, toytop_minus(forth[1], back[1]), exponent),
                       toytop_scaled(mean, product[0], exponent));
    if (falling) n[0] = toytop_minus(0, n[0]);
    /* as many leading bits as the sum of two products can have */
    used = (uint32_t)((n[0] ^ n[0] >> 31) | (n[1] ^ n[1] >> 31));
    while (spare < 30 && !(used << spare >> 29)) spare++;
    n[0] = toytop_shifted(n[0], spare);
    n[1] = toytop_shifted(n[1], spare);
    transverse[0] = toytop_shifted(toytop_plus(toytop_high(n[0], turn[1]), toytop_high(n[1], turn[0])), 2);
    transverse[1] = toytop_shifted(toytop_minus(toytop_high(n[1], turn[1]), toytop_high(n[0], turn[0])), 2);
    own = exponent + 3 - (int32_t)spare;
    exponent = toytop_greatest(own, axial.exponent + 1);
    for (int i = 0; i < 2; i++) omega[i] = transverse[i] >> toytop_least(exponent - own, 31);
    omega[2] = axial.digits >> toytop_least(exponent - axial.exponent, 31);
    return exponent;
}

/* a b + c d and a b - c d as whole numbers of 2^-28, wrapping. */
static inline int32_t toytop_plus_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return toytop_shifted(toytop_plus(toytop_high(a, b), toytop_high(c, d)), 2);
}
static inline int32_t toytop_minus_q31(int32_t a, int32_t b, int32_t c, int32_t d) {
    return toytop_shifted(toytop_minus(toytop_high(a, b), toytop_high(c, d)), 2);
}

/* A vector in body coordinates, in fixed ones; four: Re alpha, Im alpha, Re beta and Im beta in units of 2^-30. */
static inline void toytop_adjoint_q31(const int32_t four[4], const int32_t v[3], int32_t fixed[3]) {
    const int32_t *a = four, *b = four + 2;
    int32_t p[2], q[2];
    p[0] = toytop_minus(toytop_minus_q31(a[0], v[0], a[1], v[1]), toytop_shifted(toytop_high(b[0], v[2]), 2));
    p[1] = toytop_minus(toytop_plus_q31(a[0], v[1], a[1], v[0]), toytop_shifted(toytop_high(b[1], v[2]), 2));
    q[0] = toytop_plus(toytop_shifted(toytop_high(a[0], v[2]), 2), toytop_minus_q31(b[0], v[0], b[1], toytop_minus(0, v[1])));
    q[1] = toytop_plus(toytop_shifted(toytop_high(a[1], v[2]), 2), toytop_plus_q31(b[0], toytop_minus(0, v[1]), b[1], v[0]));
    fixed[0] = toytop_minus(toytop_minus_q31(a[0], p[0], a[1], p[1]), toytop_minus_q31(b[0], q[0], b[1], q[1]));
    fixed[1] = toytop_minus(toytop_plus_q31(a[0], p[1], a[1], p[0]), toytop_plus_q31(b[0], q[1], b[1], q[0]));
    fixed[2] = toytop_plus(toytop_plus_q31(a[0], q[0], a[1], q[1]), toytop_plus_q31(b[0], p[0], b[1], p[1]));
}

/* Parameters and angular velocity of the scalar S. SUMS_AT and TURN: functions of its sums and of the rotation; PRODUCT: product of two
 * sines in units of 2^-30; UNIT: factor from its parameters to units of 2^-30. */
#define TOYTOP_INTEGER_FUNCTIONS(S, SUMS_AT, TURN, PRODUCT, UNIT) \
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
    /* Parameters in units of 2^-30, and the angular velocity in the body frame as from toytop_integer_rates. */ \
    static inline int32_t toytop_rates_at_##S(const toytop_##S *table, const toytop_cursor *at, int32_t four[4], int32_t omega[3]) { \
        int32_t of[2][2], turn[2]; \
        toytop_sums sums = toytop_parameters_##S(table, at, 1, four, of); \
        turn[0] = PRODUCT(of[0][1], of[1][1]) + PRODUCT(of[0][0], of[1][0]); \
        turn[1] = PRODUCT(of[0][1], of[1][0]) - PRODUCT(of[0][0], of[1][1]); \
        for (int i = 0; i < 4; i++) four[i] *= UNIT; \
        return toytop_integer_rates(&sums, (int)(at->phase[0].leading >> 63), turn, table->scales, omega); \
    } \
    /* Angular velocity at the tick of a cursor in the body frame, rad per unit of time. */ \
    TOYTOP_API void toytop_omega_body_##S(const toytop_##S *table, const toytop_cursor *at, float omega[3]) { \
        int32_t four[4], rates[3]; \
        int32_t exponent = toytop_rates_at_##S(table, at, four, rates); \
        for (int i = 0; i < 2; i++) omega[i] = toytop_rate_in(rates[i], exponent); \
        omega[2] = table->scales[3]; \
    } \
    /* Angular velocity at the tick of a cursor in the fixed frame, rad per unit of time. */ \
    TOYTOP_API void toytop_omega_##S(const toytop_##S *table, const toytop_cursor *at, float omega[3]) { \
        int32_t four[4], rates[3], fixed[3]; \
        int32_t exponent = toytop_rates_at_##S(table, at, four, rates); \
        toytop_adjoint_q31(four, rates, fixed); \
        for (int i = 0; i < 3; i++) omega[i] = toytop_rate_in(fixed[i], exponent); \
    }

TOYTOP_INTEGER_FUNCTIONS(f32, toytop_sums_at, toytop_turn, toytop_high, 1)
TOYTOP_INTEGER_FUNCTIONS(q31, toytop_sums_at, toytop_turn, toytop_high, 1)

static inline toytop_sample_f32 toytop_sample_of_f32(const toytop_f32 *table, const toytop_cursor *at) {
    toytop_sample_f32 m;
    int32_t four[4], of[2][2], u;
    const float unit = 1.0f / 1073741824.0f; /* 2^-30 */
    toytop_parameters_f32(table, at, 0, four, of);
    for (int i = 0; i < 2; i++) m.alpha[i] = (float)four[i] * unit, m.beta[i] = (float)four[i + 2] * unit;
    u = toytop_plus_q31(four[0] + four[2], four[0] - four[2], four[1] + four[3], four[1] - four[3]);
    m.u = (float)u * unit;
    m.c[0] = (float)toytop_minus_q31(four[0], four[2], four[1], four[3]) * unit * table->scales[0];
    m.c[1] = (float)toytop_plus_q31(four[0], four[3], four[1], four[2]) * unit * table->scales[0];
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
