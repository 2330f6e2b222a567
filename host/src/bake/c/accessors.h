
/* Any tick, at the same cost. */
static inline toytop_sample_SCALAR toytop_at_tick_SCALAR(const toytop_SCALAR *table, int64_t tick) {
    toytop_cursor at = toytop_at(&table->clock, tick);
    return toytop_sample_of_SCALAR(table, &at);
}

/* The tick of a cursor, which begins as toytop_at(&table->clock, first) and moves on to the next. */
static inline toytop_sample_SCALAR toytop_next_SCALAR(const toytop_SCALAR *table, toytop_cursor *at) {
    toytop_sample_SCALAR now = toytop_sample_of_SCALAR(table, at);
    toytop_move_on(&table->clock, at);
    return now;
}
