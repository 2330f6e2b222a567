// Replacement of `Core` on a page without WebAssembly: one motion from a table, without other motions and without the ghost.

class Recorded {
  constructor({ table, shown }) {
    Object.assign(this, { table: readTable(table), shown, isLive: false });
    this.rate = table.ticks_per_time[0] + table.ticks_per_time[1];
  }

  launch() {
    return this.shown;
  }

  at(t) {
    const { alpha, beta, u, tip } = momentAt(this.table, Math.round(t * this.rate));
    return { alpha, beta, u, tip, axis: rotation({ alpha, beta, u }).axis };
  }

  curve(from, step, count) {
    const point = (_, i) => {
      const { axis, tip } = this.at(from + i * step);
      return [...axis, ...tip];
    };
    return Float64Array.from(Array.from({ length: count }, point).flat());
  }

  startGhost() {}

  ghostAt() {
    return null;
  }
}
