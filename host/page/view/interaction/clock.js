// The clock moves the time of the page while the motion plays.

/** Clock that can be started and stopped; `step` is called for each frame with the time since the last one, s. */
class Clock {
  playing = false;
  last = 0;

  constructor(step) {
    this.step = step;
  }

  play(playing) {
    this.last = performance.now();
    const starts = playing && !this.playing;
    this.playing = playing;
    if (starts) requestAnimationFrame((time) => this.frame(time));
  }

  frame(time) {
    if (!this.playing) return;
    // the limit prevents a jump after the page was in the background
    const passed = Math.max(0, Math.min(0.1, (time - this.last) / 1000));
    this.last = time;
    this.step(passed);
    requestAnimationFrame((next) => this.frame(next));
  }
}
