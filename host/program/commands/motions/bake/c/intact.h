
/* Whether no bit of a table has changed since it was written. */
TOYTOP_API int toytop_intact_SCALAR(const toytop_SCALAR *table) {
    uint32_t sum = toytop_head(&table->clock, BITS), rows = table->clock.segments * table->clock.terms;
    if (table->clock.not_rows != ~rows) return 0;
    for (int i = 0; i < 4; i++) {
        REAL_WORD scale;
        memcpy(&scale, &table->scales[i], sizeof scale);
        sum = toytop_crc(sum, scale, sizeof scale);
    }
    for (uint32_t row = 0; row < rows; row++)
        for (int i = 0; i < 4; i++) {
            COEFFICIENT_WORD coefficient;
            memcpy(&coefficient, &table->coefficients[row][i], sizeof coefficient);
            sum = toytop_crc(sum, coefficient, sizeof coefficient);
        }
    return ~sum == table->clock.crc32;
}
