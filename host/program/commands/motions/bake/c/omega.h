
/* Angular velocity at the tick of a cursor in the body frame, rad per unit of time. */
TOYTOP_API void toytop_omega_body_SCALAR(const toytop_SCALAR *table, const toytop_cursor *at, float omega[3]) {
    int32_t four[4], rates[3];
    int32_t exponent = toytop_rates_at_SCALAR(table, at, four, rates);
    for (int i = 0; i < 2; i++) omega[i] = toytop_rate_in(rates[i], exponent);
    omega[2] = table->scales[3];
}

/* Angular velocity at the tick of a cursor in the fixed frame, rad per unit of time. */
TOYTOP_API void toytop_omega_SCALAR(const toytop_SCALAR *table, const toytop_cursor *at, float omega[3]) {
    int32_t four[4], rates[3], fixed[3];
    int32_t exponent = toytop_rates_at_SCALAR(table, at, four, rates);
    toytop_adjoint_q31(four, rates, fixed);
    for (int i = 0; i < 3; i++) omega[i] = toytop_rate_in(fixed[i], exponent);
}
