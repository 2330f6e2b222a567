// The plane from above shows the tip curve between its bounding circles, with their names and a scale.

function drawPlan({ pen, size: [width, height] }, { scene, scenario, now, past, colours, comparison }) {
  const most = greatestRadius(scene) || 1;
  const scale = (0.5 * Math.min(width, height) - 26) / most;
  const project = ([x, y]) => [0.5 * width + scale * x, 0.5 * height - 6 - scale * y];
  const [cx, cy] = project([0, 0]);
  for (const [dx, dy] of [[5, 0], [0, 5]]) {
    trace(pen, [[cx - dx, cy - dy], [cx + dx, cy + dy]]);
    stroke(pen, colours.faint, 1);
  }
  write(pen, colours.faint, "center");
  scene.circles.forEach(({ radius, name, dash }, i) => {
    trace(pen, circle(radius, 0).map(project), true);
    stroke(pen, colours.bound, 1.2, dash);
    // the name is outside of the largest circle and inside of the others, at the top or at the bottom, where the curve is not
    if (radius >= most) pen.fillText(name, cx, cy - scale * radius - 6);
    else if (scale * radius > 34) pen.fillText(name, cx, i ? cy - scale * radius + 15 : cy + scale * radius - 7);
  });
  fading(pen, past.map(({ foot }) => project(foot)), colours.tip, 2);
  drawDirection(pen, past.map(({ foot }) => project(foot)), colours.tip);
  if (comparison) disc(pen, project(comparison.foot), 4, colours.comparison);
  disc(pen, project(now.foot), 4, colours.tip);
  drawScale(pen, { scene, scenario, scale, height, colours });
}

/** Draws an arrow head on the recent part of the curve, in the direction of motion. */
function drawDirection(pen, pixels, style) {
  const last = pixels.length - 1;
  const [from, to] = [pixels[Math.max(0, last - 14)], pixels[Math.max(0, last - 11)]];
  if (last < 15 || Math.hypot(to[0] - from[0], to[1] - from[1]) < 1) return;
  const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
  const corner = (turn, size) => [to[0] + size * Math.cos(angle + turn), to[1] + size * Math.sin(angle + turn)];
  trace(pen, [corner(0, 7), corner(2.5, 6), corner(-2.5, 6)], true);
  pen.fillStyle = style;
  pen.fill();
}

/** Draws a scale bar of a round length, without a unit if the curve is that of the axis. */
function drawScale(pen, { scene, scenario, scale, height, colours }) {
  const most = (90 / scale) * scene.scale;
  if (!(most > 0)) return;
  const length = roundBelow(most);
  const pixels = (length / scene.scale) * scale;
  trace(pen, [[12, height - 16], [12, height - 10], [12 + pixels, height - 10], [12 + pixels, height - 16]]);
  stroke(pen, colours.ink, 1.2);
  write(pen, colours.ink, "left", 11);
  pen.fillText(scene.slides ? lengthText(length, scenario) : short(length), 12 + pixels + 6, height - 10);
}
