
/* Sample at any tick, at the same cost. */
TOYTOP_API toytop_sample_SCALAR toytop_at_tick_SCALAR(const toytop_SCALAR *table, int64_t tick) {
    toytop_cursor at = toytop_at(&table->clock, tick);
    return toytop_sample_of_SCALAR(table, &at);
}

/* Sample at the tick of a cursor, which then moves to the next tick. toytop_at(&table->clock, first) is the cursor at tick first. */
TOYTOP_API toytop_sample_SCALAR toytop_next_SCALAR(const toytop_SCALAR *table, toytop_cursor *at) {
    toytop_sample_SCALAR now = toytop_sample_of_SCALAR(table, at);
    toytop_move_on(&table->clock, at);
    return now;
}

/* Unit quaternion w, x, y, z of a sample, from body to fixed coordinates. */
TOYTOP_API void toytop_quaternion_SCALAR(const toytop_sample_SCALAR *sample, NUMBER quaternion[4]) {
    quaternion[0] = sample->alpha[0];
    quaternion[1] = sample->beta[1];
    quaternion[2] = (NUMBER)-sample->beta[0];
    quaternion[3] = sample->alpha[1];
}
