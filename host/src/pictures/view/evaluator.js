// Evaluation of a table that `toytop bake --lang json` writes in f32, at any tick, with the bits of the crate.
//
// All numbers before alpha and beta are integers of 32 bits, which a Number represents exactly; only the phases, of 64 and 96 bits, are
// BigInt.

/** One integer from words of 32 bits, the least significant first. */
function wide(words) {
  return words.reduceRight((sum, word) => (sum << 32n) | BigInt(word), 0n);
}

/** Table from its JSON. */
function readTable(json) {
  if (json.format !== 5 || json.scalar !== "f32") throw new Error("not a table of format 5 in f32");
  return {
    ...json,
    first: json.first.map(wide),
    step: json.step.map(wide),
    horizon: json.horizon && json.horizon.map((words) => BigInt.asIntN(64, wide(words))),
  };
}

/** Nutation phase, A and B at a tick (a BigInt or a whole Number), in units of 2^-64 turns. */
function phasesAt(table, tick) {
  const n = BigInt(tick);
  const sinceFirst = BigInt.asUintN(64, n + (1n << 63n));
  const phases = table.first.map((first, i) => BigInt.asUintN(64, first + ((table.step[i] * sinceFirst) >> 32n)));
  if (table.horizon && n < table.horizon[0]) phases[0] = 1n << 63n;
  if (table.horizon && n > table.horizon[1]) phases[0] = (1n << 63n) - 1n;
  return phases;
}

/** Half of the period, segment, and local coordinate x 2^31 with x in [-1, 1); the falling half is the mirror image of the rising one. */
function find(table, nutation) {
  const falling = nutation >> 63n === 1n;
  const share = BigInt.asUintN(64, (falling ? ~nutation : nutation) << 1n);
  const cell = table.cells[Number(share >> 60n)];
  const level = cell & 15;
  const rest = Number(BigInt.asUintN(32, share >> 29n)); // place in a pair of cells
  const segment = ((cell >> 4) + (rest >>> 1 >>> (31 - level))) & 4095;
  return { falling, segment, x: (rest << level) ^ 0x80000000 };
}

/** Product a b 2^-32, rounded down. No partial product needs more than 53 bits. */
function high(a, b) {
  return Math.floor((a * (b >> 16) + Math.floor((a * (b & 0xffff)) / 65536)) / 65536) | 0;
}

/** Product of a and the upper 16 bits of b, times 2^-16, rounded down. */
function shortHigh(a, b) {
  return Math.floor((a * (b >> 16)) / 65536) | 0;
}

/** Sine and cosine, times 2^31, of a phase of 32 bits: those of the nearest of 512 points, rotated by the remaining angle. */
function sineAndCosine({ points, secant }, phase) {
  const nearest = (phase + 0x400000) >>> 23;
  const [s, c] = [points[nearest], points[nearest + 128]];
  const small = high(phase << 9, secant);
  const versine = high(small, small >> 1);
  return [s - high(s, versine) + high(c, small), c - high(c, versine) - high(s, small)];
}

/** Complex number in units of 2^-31, rotated by a phase, as two f32. */
function turned(table, [re, im], phase) {
  const [sine, cosine] = sineAndCosine(table.sine, Number(phase >> 32n));
  const number = (integer) => Math.fround(integer) * 2 ** -30;
  return [number(high(re, cosine) + high(~im, sine)), number(high(re, sine) + high(im, cosine))];
}

/** Values of the four polynomials of a segment at x, complex conjugate on the falling half. */
function polynomials(table, { falling, segment, x }) {
  const rows = table.coefficients[segment];
  return [0, 1, 2, 3].map((i) => {
    let sum = rows[table.terms - 1][i];
    for (let k = table.terms - 2; k > 0; k--) {
      // for the upper half of the powers 16 bits of x are enough
      const product = 2 * (k + 1) > table.terms ? shortHigh : high;
      sum = (rows[k][i] + product(sum, x)) | 0;
    }
    const last = Math.max(-(2 ** 31), Math.min(2 ** 31 - 1, rows[0][i] + high(sum, x)));
    return falling && i % 2 === 1 ? ~last : last;
  });
}

/**
 * State of the motion at a tick: alpha and beta as [re, im], u (the cosine of the tilt) and the tip c = 2 s alpha beta (2 alpha beta
 * where it is held), with the bits of the crate in f32.
 */
function momentAt(table, tick) {
  const [nutation, a, b] = phasesAt(table, tick);
  const sums = polynomials(table, find(table, nutation));
  const alpha = turned(table, sums.slice(0, 2), a);
  const beta = turned(table, sums.slice(2), b);
  const f = Math.fround;
  const product = (i) => f(f(alpha[i] + beta[i]) * f(alpha[i] - beta[i]));
  const u = f(product(0) + product(1));
  const tip = [
    f(f(f(alpha[0] * beta[0]) - f(alpha[1] * beta[1])) * table.tip_scale),
    f(f(f(alpha[0] * beta[1]) + f(alpha[1] * beta[0])) * table.tip_scale),
  ];
  return { nutation, alpha, beta, u, tip };
}
