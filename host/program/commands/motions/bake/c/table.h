typedef struct {
    toytop_clock clock;
    REAL scales[4];                       /* 2s; rates of x and of the sum of the mean phases, and about the axis */
    const COEFFICIENT (*coefficients)[4]; /* by segment and power: Re alpha, Im alpha, Re beta, Im beta */
} toytop_SCALAR;

/* Sample. alpha, beta: {re, im}. u: cosine of the tilt; rounding may exceed 1. c: tip, 2 s alpha beta, or 2 alpha beta if it is held.
 * In fixed point all are in units of 2^-30 (q31) or 2^-14 (q15), and c is 2 alpha beta. */
typedef struct { NUMBER alpha[2], beta[2], u, c[2]; } toytop_sample_SCALAR;

