
/* Whether no bit of a table has changed since it was written. */
TOYTOP_API int toytop_intact_f64(const toytop_f64 *table) {
    uint64_t bits;
    uint32_t sum = toytop_head(&table->clock, 64);
    for (int i = 0; i < 4; i++) {
        memcpy(&bits, &table->scales[i], sizeof bits);
        sum = toytop_crc(sum, bits, 8);
    }
    for (uint32_t row = 0; row < table->clock.segments * table->clock.terms; row++)
        for (int i = 0; i < 4; i++) {
            memcpy(&bits, &table->coefficients[row][i], sizeof bits);
            sum = toytop_crc(sum, bits, 8);
        }
    return ~sum == table->clock.crc32;
}
