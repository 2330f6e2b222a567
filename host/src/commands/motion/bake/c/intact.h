
/* Whether no bit of a table has changed since it was written. */
TOYTOP_API int toytop_intact_SCALAR(const toytop_SCALAR *table) {
    uint32_t bits, sum = toytop_head(&table->clock, BITS);
    for (int i = 0; i < 4; i++) {
        memcpy(&bits, &table->scales[i], sizeof bits);
        sum = toytop_crc(sum, bits, 4);
    }
    for (uint32_t row = 0; row < table->clock.segments * table->clock.terms; row++)
        for (int i = 0; i < 4; i++)
            sum = toytop_crc(sum, (uint64_t)(int64_t)table->coefficients[row][i], sizeof table->coefficients[row][i]);
    return ~sum == table->clock.crc32;
}
